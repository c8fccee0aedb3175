// Tensors: decomposition against 113 bits, the exponents of both kinds of glyphs, continuity.
#include "Continuity.h"
#include "Quad.h"
#include "RandomTensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace rtg;
using rtg::testing::Quad;
using rtg::testing::Random;
using rtg::testing::shareOfJump;
using rtg::testing::Sweep;
using rtg::testing::TensorOf;

//----------------------------------------------------------------------------
// The reference: Jacobi's rotations in 113 bits, which loses 1e-33 of the largest eigenvalue.

std::array<Quad, 3> QuadEigenvalues(const SymmetricTensor& t)
{
  Quad a[3][3] = { { t.xx, t.xy, t.xz }, { t.xy, t.yy, t.yz }, { t.xz, t.yz, t.zz } };
  for (int rotation = 0; rotation < 60; ++rotation)
  {
    const int p = rotation % 3, q = (p + 1) % 3;
    if (a[p][q] == 0)
    {
      continue;
    }
    const Quad difference = a[p][p] - a[q][q];
    const Quad angle = difference == 0 ? atanq(1) : atanq(2 * a[p][q] / difference) / 2;
    const Quad c = cosq(angle), s = sinq(angle);
    for (int k = 0; k < 3; ++k)
    {
      const Quad kp = a[k][p], kq = a[k][q];
      a[k][p] = c * kp + s * kq;
      a[k][q] = c * kq - s * kp;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Quad pk = a[p][k], qk = a[q][k];
      a[p][k] = c * pk + s * qk;
      a[q][k] = c * qk - s * pk;
    }
  }
  std::array<Quad, 3> values = { a[0][0], a[1][1], a[2][2] };
  std::sort(values.begin(), values.end(), std::greater<Quad>());
  return values;
}

// What every decomposition must be: ordered, orthonormal, right-handed, with a small residual.
void ExpectValid(const SymmetricTensor& t, const Eigensystem& eigen)
{
  const double u = 0x1p-53, largest = t.Largest();
  EXPECT_GE(eigen.values.x, eigen.values.y);
  EXPECT_GE(eigen.values.y, eigen.values.z);
  const glm::dmat3& v = eigen.vectors;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(glm::dot(v[i], v[j]), i == j ? 1.0 : 0.0, 32 * u);
    }
    const glm::dvec3 scaled = (t.Matrix() / largest) * v[i] - (eigen.values[i] / largest) * v[i];
    EXPECT_LT(glm::length(scaled), 64 * u);
  }
  EXPECT_NEAR(glm::determinant(v), 1.0, 64 * u);
}

TEST(TensorTest, AntisymmetricPartTurnsAboutItsAxis)
{
  const double m[] = { 1, 2, 3, 4, 5, 6, 7, 8, 10 };
  const glm::dvec3 axis = AntisymmetricAxis(m), x(0.3, -0.7, 0.2);
  glm::dvec3 turned(0.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      turned[i] += 0.5 * (m[3 * i + j] - m[3 * j + i]) * x[j];
    }
  }
  EXPECT_LT(glm::length(glm::cross(axis, x) - turned), 1e-15);
}

TEST(TensorTest, EigenvaluesAgainst113Bits)
{
  Random random(11);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    // Ratios up to 1e12, either sign; every fourth with two nearly equal ones.
    glm::dvec3 values(std::pow(10.0, random.Uniform(-12, 0)), std::pow(10.0, random.Uniform(-12, 0)), 1.0);
    for (int k = 0; k < 3; ++k)
    {
      values[k] *= random.Uniform(0, 1) < 0.5 ? -1.0 : 1.0;
    }
    if (i % 4 == 0)
    {
      values.y = values.x * (1.0 + std::pow(10.0, random.Uniform(-9, -1)));
    }
    const SymmetricTensor t = TensorOf(values, random.Rotation());
    const Eigensystem eigen = Decompose(t);
    ExpectValid(t, eigen);
    const auto exact = QuadEigenvalues(t);
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, double(fabsq((exact[k] - eigen.values[k]) / exact[k])));
    }
  }
  EXPECT_LT(worst, 1e-15);
  RecordProperty("worst", std::to_string(worst));
}

TEST(TensorTest, TinyAndHugeTensors)
{
  Random random(11);
  const SymmetricTensor t = TensorOf({ 3.0, -1.5, 0.25 }, random.Rotation());
  const Eigensystem unit = Decompose(t);
  for (const int exponent : { -1000, -500, 500, 1020 })
  {
    const auto scaled = [&](double x) { return std::ldexp(x, exponent); };
    const Eigensystem eigen =
      Decompose({ scaled(t.xx), scaled(t.yy), scaled(t.zz), scaled(t.xy), scaled(t.yz), scaled(t.xz) });
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(eigen.values[k], scaled(unit.values[k]));
      EXPECT_EQ(eigen.vectors[k], unit.vectors[k]);
    }
  }
}

TEST(TensorTest, EqualAndZeroEigenvalues)
{
  EXPECT_EQ(Decompose({}).values, glm::dvec3(0.0));
  EXPECT_EQ(Decompose({}).vectors, glm::dmat3(1.0));
  EXPECT_EQ(Decompose({ 2, 2, 2, 0, 0, 0 }).vectors, glm::dmat3(1.0));
  // Ties keep the order of the axes.
  const Eigensystem planar = Decompose({ 1, 3, 3, 0, 0, 0 });
  EXPECT_EQ(planar.values, glm::dvec3(3, 3, 1));
  EXPECT_EQ(planar.vectors, glm::dmat3(0, 1, 0, 0, 0, 1, 1, 0, 0));
  // All ones: one eigenvalue 3 along the diagonal, two zeros.
  const SymmetricTensor ones{ 1, 1, 1, 1, 1, 1 };
  const Eigensystem linear = Decompose(ones);
  ExpectValid(ones, linear);
  EXPECT_NEAR(linear.values.x, 3.0, 1e-15);
  EXPECT_LT(std::abs(linear.values.y), 1e-28);
  EXPECT_LT(std::abs(linear.values.z), 1e-28);
  EXPECT_NEAR(glm::dot(linear.vectors[0], glm::dvec3(1.0)), std::sqrt(3.0), 1e-15);
}

/// The glyph's half-lengths and exponents stay, its axes turn.
TEST(TensorTest, TurningATensorTurnsItsGlyph)
{
  Random random(11);
  for (int i = 0; i < 5000; ++i)
  {
    const glm::dvec3 values(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    const double gap = std::min({ std::abs(values.x - values.y), std::abs(values.y - values.z),
      std::abs(values.z - values.x), std::abs(std::abs(values.x) - std::abs(values.y)),
      std::abs(std::abs(values.y) - std::abs(values.z)), std::abs(std::abs(values.z) - std::abs(values.x)) });
    if (gap < 1e-3)
    {
      continue;
    }
    const glm::dquat first = random.Rotation(), turn = random.Rotation();
    for (const auto kind :
      { TensorGlyphKind::Ellipsoid, TensorGlyphKind::Superquadric, TensorGlyphKind::SignedSuperquadric })
    {
      const TensorGlyph a = MakeTensorGlyph(Decompose(TensorOf(values, first)), kind, 3.0);
      const TensorGlyph b = MakeTensorGlyph(Decompose(TensorOf(values, turn * first)), kind, 3.0);
      EXPECT_LT(glm::length(a.halfLengths - b.halfLengths), 1e-14);
      EXPECT_LT(glm::length(a.exponents - b.exponents), 1e-12);
      for (int axis = 0; axis < 3; ++axis)
      {
        const glm::dvec3 unit(axis == 0, axis == 1, axis == 2);
        const double c = glm::dot(turn * (a.rotation * unit), b.rotation * unit);
        EXPECT_NEAR(std::abs(c), 1.0, 1e-12);
      }
    }
  }
}

TEST(TensorTest, Measures)
{
  EXPECT_EQ(FractionalAnisotropy({ 0, 0, 0 }), 0.0);
  EXPECT_EQ(FractionalAnisotropy({ 2, 2, 2 }), 0.0);
  EXPECT_NEAR(FractionalAnisotropy({ 5e300, 0, 0 }), 1.0, 1e-15);
  EXPECT_NEAR(FractionalAnisotropy({ 1e-300, 1e-300, 0 }), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(FractionalAnisotropy({ 1, 0, -1 }), std::sqrt(1.5), 1e-15);
}

TEST(TensorTest, KindlmannsCorners)
{
  const auto expect = [](const glm::dvec3& lengths, double alpha, double beta, bool first)
  {
    const TensorExponents e = KindlmannExponents(lengths, 3.0);
    EXPECT_NEAR(e.alpha, alpha, 1e-15);
    EXPECT_NEAR(e.beta, beta, 1e-15);
    EXPECT_EQ(e.beta, e.c);
    EXPECT_EQ(e.alongFirst, first);
  };
  expect({ 1, 1, 1 }, 1, 1, true);
  expect({ 1, 0, 0 }, 1, 0, true);
  expect({ 1, 1, 0 }, 1, 0, false);
  // cl = 0.15, cp = 0.4.
  expect({ 0.5, 0.35, 0.15 }, 0.614125, 0.216, false);
  // cl = 0.5, cp = 0.2.
  expect({ 0.7, 0.2, 0.1 }, 0.512, 0.125, true);
  expect({ 7e200, 2e200, 1e200 }, 0.512, 0.125, true);
}

/// Centroids of the ten zones: the mean of three corners' shapes, worked out by hand.
TEST(TensorTest, SchultzKindlmannsZones)
{
  struct Row
  {
    double u, v, alpha, beta, c;
    bool first;
  };
  const Row rows[] = {
    { 2.25 / 3, 2.75 / 3, 2.5 / 3, 0.5, 0.5, true },
    { 2.75 / 3, 2.25 / 3, 2.5 / 3, 0.5, 0.5, false },
    { 2.5 / 3, 1.5 / 3, 2.0 / 3, 7.0 / 3, 7.0 / 3, false },
    { 2.0 / 3, 1.5 / 3, 1.0 / 3, 8.0 / 3, 7.0 / 3, false },
    { 2.0 / 3, 0.5 / 3, 2.0 / 3, 8.0 / 3, 7.0 / 3, false },
    { 1.0 / 3, 2.5 / 3, 2.0 / 3, 8.0 / 3, 7.0 / 3, true },
    { 1.0 / 3, 1.5 / 3, 1.0 / 3, 8.0 / 3, 7.0 / 3, true },
    { 0.5 / 3, 1.5 / 3, 2.0 / 3, 7.0 / 3, 7.0 / 3, true },
    { 0.25 / 3, 0.75 / 3, 2.5 / 3, 0.5, 0.5, true },
    { 0.75 / 3, 0.25 / 3, 2.5 / 3, 0.5, 0.5, false },
  };
  for (const Row& row : rows)
  {
    const TensorExponents e = SchultzKindlmannBase({ row.u, row.v });
    EXPECT_NEAR(e.alpha, row.alpha, 1e-14) << row.u << ' ' << row.v;
    EXPECT_NEAR(e.beta, row.beta, 1e-14) << row.u << ' ' << row.v;
    EXPECT_NEAR(e.c, row.c, 1e-14) << row.u << ' ' << row.v;
    EXPECT_EQ(e.alongFirst, row.first) << row.u << ' ' << row.v;
  }
}

TEST(TensorTest, EigenvaluesInTheSquare)
{
  const auto expect = [](const glm::dvec3& values, double u, double v)
  {
    for (const double scale : { 1.0, 1e-200, 1e200 })
    {
      const glm::dvec2 uv = EigenvalueSquare(scale * values);
      EXPECT_NEAR(uv.x, u, 1e-15);
      EXPECT_NEAR(uv.y, v, 1e-15);
    }
  };
  expect({ 1, 1, 1 }, 1, 1);
  expect({ 1, 0, 0 }, 0.5, 1);
  expect({ 1, 1, 0 }, 1, 0.5);
  expect({ 1, 1, -1 }, 1, 0);
  expect({ 1, -1, -1 }, 0, 1);
  expect({ 0, -1, -1 }, 0, 0.5);
  expect({ 0, 0, -1 }, 0.5, 0);
  expect({ -1, -1, -1 }, 0, 0);
  expect({ 1, 0, -1 }, 0.5, 0.5);
  // Two ways in at x = -z; both must be the same point.
  expect({ 1, 0.5, -1 + 1e-16 }, 0.75, 0.25);
  expect({ 1 - 1e-16, 0.5, -1 }, 0.75, 0.25);
}

TEST(TensorTest, SharpnessKeepsBallAndCone)
{
  const TensorExponents ball = SchultzKindlmannExponents({ 1, 1, 1 }, 3.0);
  EXPECT_EQ(glm::dvec3(ball.alpha, ball.beta, ball.c), glm::dvec3(1.0));
  const TensorExponents linear = SchultzKindlmannExponents({ 1, 1e-9, 1e-9 }, 3.0);
  EXPECT_NEAR(linear.alpha, 1.0, 1e-8);
  EXPECT_NEAR(linear.beta, 0.0, 1e-8);
  const TensorExponents funk = SchultzKindlmannExponents({ 1, -1e-9, -1 }, 3.0);
  EXPECT_NEAR(funk.alpha, 0.0, 1e-8);
  EXPECT_NEAR(funk.beta, 5.0, 1e-7);
  EXPECT_NEAR(funk.c, 2.0, 1e-7);
}

/// Two points of each zone's triangle, nearer to one corner than to the others, from Teem's table (tenGlyphBqdAbcUv,
/// the first of its two values of the concave corners' beta): the corners' order.
TEST(TensorTest, CornersOfTheZonesAreTeems)
{
  struct Row
  {
    int u, v; ///< cells of the table
    glm::dvec3 exponents;
  };
  const Row rows[] = {
    { 91, 97, { 0.95, 0.83, 0.83 } },
    { 58, 97, { 0.95, 0.17, 0.17 } },
    { 97, 91, { 0.95, 0.83, 0.83 } },
    { 80, 75, { 0.61, 0.51, 0.51 } },
    { 61, 82, { 0.23, 2.06666666666, 2.12 } },
    { 94, 50, { 0.89, 2.05555555555, 2.1 } },
    { 55, 82, { 0.11, 2.13333333332, 2.11 } },
    { 88, 17, { 0.77, 2.48888888884, 2.77 } },
    { 88, 5, { 0.89, 2.48888888884, 2.77 } },
    { 55, 38, { 0.23, 2.48888888884, 2.11 } },
    { 44, 94, { 0.89, 2.12222222221, 2.11 } },
    { 44, 61, { 0.23, 2.48888888884, 2.11 } },
    { 44, 50, { 0.11, 2.49999999995, 2.11 } },
    { 11, 82, { 0.77, 2.48888888884, 2.77 } },
    { 5, 82, { 0.89, 2.42222222218, 2.76 } },
    { 5, 50, { 0.89, 2.06666666666, 2.12 } },
    { 2, 41, { 0.95, 0.17, 0.17 } },
    { 19, 25, { 0.61, 0.49, 0.49 } },
    { 25, 19, { 0.61, 0.49, 0.49 } },
    { 41, 2, { 0.95, 0.17, 0.17 } },
  };
  for (const Row& row : rows)
  {
    const TensorExponents e = SchultzKindlmannBase({ (row.u + 0.5) / 100, (row.v + 0.5) / 100 }, 2.5555555555);
    EXPECT_NEAR(e.alpha, row.exponents.x, 1e-10) << row.u << ' ' << row.v;
    EXPECT_NEAR(e.beta, row.exponents.y, 1e-10) << row.u << ' ' << row.v;
    EXPECT_NEAR(e.c, row.exponents.z, 1e-10) << row.u << ' ' << row.v;
  }
}

/// Teem's own exponents (tenGlyphBqdAbcUv), when its table is there: u fastest, cell-centerd, two values of the
/// concave corners' beta.
TEST(TensorTest, TeemsTable)
{
  const char* folder = std::getenv("RTGLYPHS_SHARED_DATA");
  std::ifstream file(std::string(folder ? folder : RTGLYPHS_SHARED_DATA) + "/tenGlyphBqdAbcUv.nrrd", std::ios::binary);
  if (!file)
  {
    GTEST_SKIP() << "tenGlyphBqdAbcUv.nrrd is not there: set RTGLYPHS_SHARED_DATA to its folder";
  }
  std::string line;
  while (std::getline(file, line) && !line.empty())
  {
  }
  double worst = 0.0;
  for (const double concave : { 2.5555555555, 3.888888888888 })
  {
    for (int j = 0; j < 100; ++j)
    {
      for (int i = 0; i < 100; ++i)
      {
        double exact[3];
        ASSERT_TRUE(file.read(reinterpret_cast<char*>(exact), sizeof(exact)));
        const TensorExponents e = SchultzKindlmannBase({ (i + 0.5) / 100, (j + 0.5) / 100 }, concave);
        worst =
          std::max({ worst, std::abs(e.alpha - exact[0]), std::abs(e.beta - exact[1]), std::abs(e.c - exact[2]) });
      }
    }
  }
  EXPECT_LT(worst, 1e-12);
  std::cout << "20000 points, largest difference " << worst << '\n';
}

//----------------------------------------------------------------------------
// Continuity. A glyph's support in a direction n is a norm of its local components; here that of its box and
// its exponents are enough: the glyph as a set of points depends on nothing else.

/// Largest change of the distance from the glyph's center to its surface over directions, from a to b: radial, so
/// that it compares sets of points and not their coordinates.
double RadialChange(const TensorGlyph& a, const TensorGlyph& b, const std::vector<glm::dvec3>& directions)
{
  const auto radius = [](const TensorGlyph& glyph, const glm::dvec3& world)
  {
    // |x / Rx|^(2/alpha) + |y / Ry|^(2/alpha) <= 1, bisected along the ray: the glyph is star-shaped.
    const glm::dvec3 d = (glm::conjugate(glyph.rotation) * world) / glyph.halfLengths;
    double low = 0.0, high = 1.0 / std::max({ std::abs(d.x), std::abs(d.y), std::abs(d.z) });
    for (int i = 0; i < 40; ++i)
    {
      const double s = 0.5 * (low + high);
      const glm::dvec3 p = glm::abs(s * d);
      const double rx = std::pow(1.0 - std::pow(p.z, 2.0 / glyph.exponents.y), glyph.exponents.y / 2.0);
      const double ry = std::pow(1.0 - std::pow(p.z, 2.0 / glyph.exponents.z), glyph.exponents.z / 2.0);
      const double e = 2.0 / glyph.exponents.x;
      (std::pow(p.x / rx, e) + std::pow(p.y / ry, e) < 1.0 ? low : high) = s;
    }
    return low;
  };
  double change = 0.0;
  for (const glm::dvec3& d : directions)
  {
    change = std::max(change, std::abs(radius(a, d) - radius(b, d)));
  }
  return change;
}

/// Steps through equal, zero and sign-changing eigenvalues, the frame turning as well. There is no jump:
/// no part of a step changes the glyph as much as the step does.
TEST(TensorTest, GlyphsChangeContinuously)
{
  Random random(11);
  std::vector<glm::dvec3> many;
  for (int i = 0; i < 64; ++i)
  {
    many.push_back(random.Rotation() * glm::dvec3(1, 0, 0));
  }
  const std::vector<glm::dvec3> few(many.begin(), many.begin() + 4);
  // Two equal, all equal, one zero, two zero, signs change one after the other, to all negative.
  const glm::dvec3 stations[] = { { 1, 0.6, 0.2 }, { 1, 1, 0.2 }, { 1, 1, 1 }, { 1, 0.5, 0.5 }, { 1, 0.4, 0 },
    { 1, 0.3, -0.5 }, { 1, 0, -1 }, { 0.7, -0.3, -1 }, { 0, -0.6, -1 }, { -0.3, -0.3, -1 }, { -0.8, -0.8, -0.8 } };
  const int legs = int(std::size(stations)) - 1;
  const auto glyphAt = [&](double s, TensorGlyphKind kind)
  {
    const int leg = std::min(int(s * legs), legs - 1);
    const double f = s * legs - leg;
    const glm::dvec3 values = (1.0 - f) * stations[leg] + f * stations[leg + 1];
    const glm::dquat turn = glm::angleAxis(3.0 * s, glm::normalize(glm::dvec3(1, 2, 3)));
    return MakeTensorGlyph(Decompose(TensorOf(values, turn)), kind, 3.0);
  };
  for (const auto kind :
    { TensorGlyphKind::Ellipsoid, TensorGlyphKind::Superquadric, TensorGlyphKind::SignedSuperquadric })
  {
    const auto along = [&](const std::vector<glm::dvec3>& directions)
    {
      return [&, kind](double from, double to)
      { return RadialChange(glyphAt(from, kind), glyphAt(to, kind), directions); };
    };
    const Sweep sweep(2000, along(few));
    EXPECT_LT(sweep.WorstShare(), shareOfJump) << int(kind) << " at " << sweep.WorstAt();
    EXPECT_LT(sweep.Share(sweep.At(), along(many)), shareOfJump) << int(kind) << " at " << sweep.At();
    std::cout << "kind " << int(kind) << ": largest step " << sweep.Largest() << " at " << sweep.At() << "; of "
              << sweep.Divided() << " large ones a part changes at most " << sweep.WorstShare() << " of its step, at "
              << sweep.WorstAt() << '\n';
  }
}

TEST(TensorTest, ThinGlyphsAreThereAndNoiseBecomesBalls)
{
  const Eigensystem linear = Decompose({ 1, 0, 0, 0, 0, 0 });
  for (const auto kind :
    { TensorGlyphKind::Ellipsoid, TensorGlyphKind::Superquadric, TensorGlyphKind::SignedSuperquadric })
  {
    const TensorGlyph glyph = MakeTensorGlyph(linear, kind, 3.0);
    EXPECT_EQ(std::min({ glyph.halfLengths.x, glyph.halfLengths.y, glyph.halfLengths.z }), thinnestTensorGlyph);
    EXPECT_EQ(std::max({ glyph.halfLengths.x, glyph.halfLengths.y, glyph.halfLengths.z }), 1.0);
    EXPECT_GE(std::min({ glyph.exponents.x, glyph.exponents.y, glyph.exponents.z }), leastTensorExponent);
  }
  const Eigensystem nearly = Decompose({ 1, 1e-4, 1e-4, 0, 0, 0 });
  const TensorGlyph sharp = MakeTensorGlyph(nearly, TensorGlyphKind::SignedSuperquadric, 3.0, 1.0);
  const TensorGlyph blurred = MakeTensorGlyph(nearly, TensorGlyphKind::SignedSuperquadric, 3.0, 100.0);
  EXPECT_EQ(sharp.exponents.y, leastTensorExponent);
  EXPECT_NEAR(blurred.exponents.y, 1.0, 1e-3);
}

/// The profile with the exponent c, straight where the other one is concave, lies over the eigenvector of the middle
/// eigenvalue: between eigenvalues of opposite signs the glyph is concave.
TEST(TensorTest, MiddleEigenvectorIsTheGlyphsY)
{
  Random random(11);
  for (const glm::dvec3 values : { glm::dvec3(1, 0.2, -1), glm::dvec3(1, -0.2, -1), glm::dvec3(1, 0.5, 0.1) })
  {
    const Eigensystem eigen = Decompose(TensorOf(values, random.Rotation()));
    const TensorGlyph glyph = MakeTensorGlyph(eigen, TensorGlyphKind::SignedSuperquadric, 3.0);
    const glm::dvec3 y = glyph.rotation * glm::dvec3(0, 1, 0);
    EXPECT_NEAR(std::abs(glm::dot(y, eigen.vectors[1])), 1.0, 1e-14);
    EXPECT_EQ(glyph.exponents.y > glyph.exponents.z, values.z < 0.0);
  }
}

/// Half-lengths lie along the eigenvectors of their eigenvalues, for all orders of signs and magnitudes.
TEST(TensorTest, LengthsLieAlongTheirEigenvectors)
{
  Random random(11);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 values(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    const SymmetricTensor t = TensorOf(values, random.Rotation());
    for (const auto kind :
      { TensorGlyphKind::Ellipsoid, TensorGlyphKind::Superquadric, TensorGlyphKind::SignedSuperquadric })
    {
      const TensorGlyph glyph = MakeTensorGlyph(Decompose(t), kind, 3.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        const glm::dvec3 n = glyph.rotation * glm::dvec3(axis == 0, axis == 1, axis == 2);
        EXPECT_NEAR(std::abs(glm::dot(n, t.Matrix() * n)), std::max(glyph.halfLengths[axis], 0.0), 1e-3 + 1e-13);
        EXPECT_NEAR(glm::length(t.Matrix() * n), std::abs(glm::dot(n, t.Matrix() * n)), 1e-12);
      }
    }
  }
}

} // namespace
