#include "Tensor.h"

#include "Shapes/Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtg
{

namespace
{

using Words = shapes::Kernel<double>;
using Word = Words::DoubleWord;

// x^T A y in double words, rounded at the end.
Word QuadraticForm(const glm::dmat3& a, const glm::dvec3& x, const glm::dvec3& y)
{
  Word sum = Words::Word(0.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      sum = Words::Add(sum, Words::Multiply(Words::TwoProduct(x[i], a[j][i]), y[j]));
    }
  }
  return sum;
}

double Round(const Word& word)
{
  return word.hi + word.lo;
}

// Rayleigh quotient: its error is the square of the vector's.
double Rayleigh(const glm::dmat3& a, const glm::dvec3& v)
{
  return Round(Words::Divide(QuadraticForm(a, v, v), QuadraticForm(glm::dmat3(1.0), v, v)));
}

// One rotation in the plane of axes p and q that makes a[p][q] zero.
void Rotate(glm::dmat3& a, glm::dmat3& vectors, int p, int q)
{
  const double off = a[p][q];
  if (off == 0.0)
  {
    return;
  }
  // The smaller of the two angles; hypot instead of a square that could overflow.
  const double theta = 0.5 * (a[q][q] - a[p][p]) / off;
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1.0 / std::hypot(t, 1.0);
  const double s = t * c;
  a[p][p] -= t * off;
  a[q][q] += t * off;
  a[p][q] = a[q][p] = 0.0;
  const int r = 3 - p - q;
  const double rp = a[r][p], rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  const glm::dvec3 vp = vectors[p], vq = vectors[q];
  vectors[p] = c * vp - s * vq;
  vectors[q] = s * vp + c * vq;
}

void Sweep(glm::dmat3& a, glm::dmat3& vectors, int most)
{
  for (int sweep = 0; sweep < most && (a[0][1] != 0.0 || a[0][2] != 0.0 || a[1][2] != 0.0); ++sweep)
  {
    Rotate(a, vectors, 0, 1);
    Rotate(a, vectors, 0, 2);
    Rotate(a, vectors, 1, 2);
  }
}

// The sign that makes the component of the largest magnitude positive.
glm::dvec3 WithPositiveLargest(const glm::dvec3& v)
{
  int largest = 0;
  for (int i = 1; i < 3; ++i)
  {
    // A component that is as large but for rounding does not take the first one's place.
    if (std::abs(v[i]) > (1.0 + 1e-12) * std::abs(v[largest]))
    {
      largest = i;
    }
  }
  return v[largest] < 0.0 ? -v : v;
}

// Corners of the square of Schultz and Kindlmann.
constexpr double corners[11][2] = { { 1, 1 }, { .5, 1 }, { .75, .75 }, { 1, .5 }, { 1, 0 }, { .5, .5 }, { 0, 1 },
  { 0, .5 }, { .25, .25 }, { .5, 0 }, { 0, 0 } };

// Shapes at the corners of a zone, in the order of ExponentsOf().
enum BaseShape
{
  Ball,
  Cylinder,
  Half,
  Octahedron,
  Cone,
  Thorn,
  Funk
};

struct Zone
{
  int corner[3];
  BaseShape form[3];
  bool alongFirst;
};

// Zones in the order in which ZoneAt numbers them.
constexpr Zone zones[10] = {
  { { 0, 1, 2 }, { Ball, Cylinder, Half }, true },
  { { 0, 2, 3 }, { Ball, Half, Cylinder }, false },
  { { 1, 3, 4 }, { Octahedron, Cone, Thorn }, false },
  { { 1, 4, 5 }, { Octahedron, Thorn, Funk }, false },
  { { 4, 5, 9 }, { Thorn, Funk, Cone }, false },
  { { 1, 5, 6 }, { Cone, Funk, Thorn }, true },
  { { 5, 6, 9 }, { Funk, Thorn, Octahedron }, true },
  { { 6, 7, 9 }, { Thorn, Cone, Octahedron }, true },
  { { 7, 8, 10 }, { Cylinder, Half, Ball }, true },
  { { 8, 9, 10 }, { Half, Cylinder, Ball }, false },
};

int ZoneAt(double u, double v)
{
  if (u > 0.5)
  {
    if (u + v > 1.5)
    {
      return u < v ? 0 : 1;
    }
    return 2 * u + v > 2 ? 2 : u + v > 1 ? 3 : 4;
  }
  if (u + v > 0.5)
  {
    return u + v > 1 ? 5 : 2 * u + v > 1 ? 6 : 7;
  }
  return u < v ? 8 : 9;
}

glm::dvec3 ExponentsOf(BaseShape form, double concave)
{
  const glm::dvec3 exponents[] = { { 1.0, 1.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 0.5, 0.5, 0.5 }, { 0.0, 2.0, 2.0 },
    { 1.0, 2.0, 2.0 }, { 1.0, concave, 3.0 }, { 0.0, concave, 2.0 } };
  return exponents[form];
}

double Sharpened(double beta, double sharpness)
{
  return beta < 1.0 ? std::pow(beta, sharpness) : beta > 2.0 ? (beta - 2.0) * sharpness + 2.0 : beta;
}

} // namespace

bool SymmetricTensor::IsFinite() const
{
  return std::isfinite(this->xx) && std::isfinite(this->yy) && std::isfinite(this->zz) && std::isfinite(this->xy) &&
    std::isfinite(this->yz) && std::isfinite(this->xz);
}

bool SymmetricTensor::IsZero() const
{
  return this->Largest() == 0.0;
}

double SymmetricTensor::Largest() const
{
  return std::max({ std::abs(this->xx), std::abs(this->yy), std::abs(this->zz), std::abs(this->xy), std::abs(this->yz),
    std::abs(this->xz) });
}

glm::dmat3 SymmetricTensor::Matrix() const
{
  return { this->xx, this->xy, this->xz, this->xy, this->yy, this->yz, this->xz, this->yz, this->zz };
}

glm::dvec3 AntisymmetricAxis(const double* m)
{
  return { 0.5 * m[7] - 0.5 * m[5], 0.5 * m[2] - 0.5 * m[6], 0.5 * m[3] - 0.5 * m[1] };
}

Eigensystem Decompose(const SymmetricTensor& tensor)
{
  Eigensystem result;
  const double largest = tensor.Largest();
  if (!(largest > 0.0))
  {
    return result;
  }

  // Scale to numbers near one.
  int exponent;
  std::frexp(largest, &exponent);
  glm::dmat3 scaled = tensor.Matrix();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      scaled[i][j] = std::ldexp(scaled[i][j], -exponent);
    }
  }

  // Sweep until nothing is left beside the diagonal: six sweeps do for double, by quadratic convergence.
  glm::dmat3 a = scaled, vectors(1.0);
  Sweep(a, vectors, 16);

  // The rounding of the large eigenvalues has mixed the vectors of small ones. In double words the tensor in
  // the frame just found shows by how much; one more sweep takes it out.
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      a[i][j] = a[j][i] = Round(QuadraticForm(scaled, vectors[i], vectors[j]));
    }
  }
  Sweep(a, vectors, 2);

  // Order by value
  std::array<double, 3> values;
  for (int i = 0; i < 3; ++i)
  {
    values[i] = Rayleigh(scaled, vectors[i]);
  }
  std::array<int, 3> order = { 0, 1, 2 };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return values[i] > values[j]; });
  for (int i = 0; i < 3; ++i)
  {
    result.values[i] = std::ldexp(values[order[i]], exponent);
  }
  result.vectors[0] = WithPositiveLargest(vectors[order[0]]);
  result.vectors[1] = WithPositiveLargest(vectors[order[1]]);
  result.vectors[2] = glm::cross(result.vectors[0], result.vectors[1]);
  return result;
}

double FractionalAnisotropy(const glm::dvec3& values)
{
  const double largest = std::max({ std::abs(values.x), std::abs(values.y), std::abs(values.z) });
  if (!(largest > 0.0))
  {
    return 0.0;
  }
  const glm::dvec3 l = values / largest;
  const double xy = l.x - l.y, yz = l.y - l.z, zx = l.z - l.x;
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) / glm::dot(l, l));
}

TensorExponents KindlmannExponents(const glm::dvec3& lengths, double sharpness)
{
  TensorExponents exponents;
  if (!(lengths.x > 0.0))
  {
    return exponents;
  }
  const double second = lengths.y / lengths.x, third = lengths.z / lengths.x;
  const double sum = 1.0 + second + third;
  const double linear = std::pow(1.0 - (1.0 - second) / sum, sharpness);
  const double planar = std::pow(1.0 - 2.0 * (second - third) / sum, sharpness);
  exponents.alongFirst = 1.0 - second >= 2.0 * (second - third);
  exponents.alpha = exponents.alongFirst ? planar : linear;
  exponents.beta = exponents.c = exponents.alongFirst ? linear : planar;
  return exponents;
}

glm::dvec2 EigenvalueSquare(const glm::dvec3& values)
{
  const glm::dvec3 l = values / std::max(std::abs(values.x), std::abs(values.z));
  const double u = (l.y + 1.0) / 2.0;
  const double w = l.x > -l.z ? (l.z + 1.0) / 2.0 : (l.x + 1.0) / 2.0 - 1.0;
  return { u, w - u + 1.0 };
}

TensorExponents SchultzKindlmannBase(const glm::dvec2& uv, double concave)
{
  const Zone& zone = zones[ZoneAt(uv.x, uv.y)];

  // Barycentric coordinates in the zone's triangle
  const auto at = [&](int i) { return glm::dvec2(corners[zone.corner[i]][0], corners[zone.corner[i]][1]); };
  const glm::dvec2 a = at(1) - at(0), b = at(2) - at(0), p = uv - at(0);
  const double area = a.x * b.y - a.y * b.x;
  const double first = (p.x * b.y - p.y * b.x) / area;
  const double second = (a.x * p.y - a.y * p.x) / area;
  const glm::dvec3 blend = (1.0 - first - second) * ExponentsOf(zone.form[0], concave) +
    first * ExponentsOf(zone.form[1], concave) + second * ExponentsOf(zone.form[2], concave);

  return { std::max(blend.x, 0.0), std::max(blend.y, 0.0), std::max(blend.z, 0.0), zone.alongFirst };
}

TensorExponents SchultzKindlmannExponents(const glm::dvec3& values, double sharpness)
{
  TensorExponents exponents = SchultzKindlmannBase(EigenvalueSquare(values));
  exponents.alpha = std::pow(exponents.alpha, sharpness);
  exponents.beta = Sharpened(exponents.beta, sharpness);
  exponents.c = Sharpened(exponents.c, sharpness);
  return exponents;
}

TensorGlyph
MakeTensorGlyph(const Eigensystem& eigen, TensorGlyphKind kind, double sharpness, double noise, double thinnest)
{
  const glm::dvec3 magnitude = glm::abs(eigen.values);
  const double largest = std::max({ magnitude.x, magnitude.y, magnitude.z });

  // Which eigenvector is the first, the second, the third
  std::array<int, 3> order = { 0, 1, 2 };
  TensorExponents exponents;
  if (kind == TensorGlyphKind::Superquadric)
  {
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return magnitude[i] > magnitude[j]; });
    exponents = KindlmannExponents({ magnitude[order[0]], magnitude[order[1]], magnitude[order[2]] }, sharpness);
  }
  else if (kind == TensorGlyphKind::SignedSuperquadric)
  {
    exponents = SchultzKindlmannExponents(eigen.values, sharpness);
  }

  // The glyph's z lies along the first or third, its y along the second.
  const int z = exponents.alongFirst ? order[0] : order[2];
  const int y = order[1];
  const int x = 3 - y - z;
  glm::dmat3 frame;
  frame[1] = eigen.vectors[y];
  frame[2] = eigen.vectors[z];
  frame[0] = glm::cross(frame[1], frame[2]);

  TensorGlyph glyph;
  glyph.values = { eigen.values[x], eigen.values[y], eigen.values[z] };
  glyph.rotation = glm::normalize(glm::quat_cast(frame));
  glyph.halfLengths = glm::max(glm::dvec3(magnitude[x], magnitude[y], magnitude[z]), glm::dvec3(thinnest * largest));
  glyph.exponents = glm::max(glm::dvec3(exponents.alpha, exponents.beta, exponents.c), glm::dvec3(leastTensorExponent));
  if (largest < noise)
  {
    const double r = largest / noise;
    glyph.exponents = glm::mix(glm::dvec3(1.0), glyph.exponents, r * r * (3.0 - 2.0 * r));
  }
  return glyph;
}

} // namespace rtg
