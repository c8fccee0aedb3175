// The rays and glyphs on which float ray tracing goes wrong, for every shape: the same cases go through the
// kernels in C++ and through the programs. Deterministic.
#pragma once

#include "FormExtents.h"
#include "Glyphs.h"
#include "HarmonicForms.h"
#include "Shapes/Shapes.h"
#include "SweptEllipsoid.h"
#include "Tensor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <numeric>
#include <random>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

// All shapes are much to compile: once, in Measure.cxx.
extern template struct rtg::shapes::Kernel<float>;
extern template struct rtg::shapes::Kernel<double>;

namespace rtg::testing
{

struct HardRay
{
  glm::dvec3 origin;   ///< relative to GlyphInstances::origin; a float plus a float, exactly
  glm::vec3 direction; ///< of any length
  std::uint32_t glyph; ///< the glyph it is aimed at
};

struct HardCase
{
  std::string subject;   ///< the shape and its parameters
  std::string situation; ///< what makes it hard
  GlyphInstances instances;
  std::vector<HardRay> rays;
};

template <class Real>
typename shapes::Kernel<Real>::Glyph KernelGlyph(const GlyphInstances& instances, std::uint32_t index)
{
  typename shapes::Kernel<Real>::Glyph glyph{};
  glyph.center = instances.centers[index];
  glyph.size = instances.SizeOf(index);
  glyph.rotated = !instances.rotations.empty();
  glyph.rotation = glyph.rotated ? instances.rotations[index] : glm::vec4(0, 0, 0, 1);
  glyph.sameSize = instances.sizes3.empty();
  glyph.joined = instances.shape == Shape::SweptEllipsoid && !instances.polynomials.empty();
  const ArrowForm& form = instances.arrow;
  glyph.arrow = glm::vec4(form.shaftRadius, form.tipRadius, form.tipLength, form.tipRounding);
  glyph.fixedHeads = form.fixedHeads;
  glyph.unitLength = form.unitLength;
  glyph.exponents = instances.exponents3.empty() ? instances.uniformExponents : instances.exponents3[index];
  glyph.before = instances.before.empty() ? glm::vec4(0.0f) : instances.before[index];
  glyph.after = instances.after.empty() ? glm::vec4(0.0f) : instances.after[index];
  glyph.values = instances.polynomials.empty() ? nullptr : instances.polynomials[index];
  glyph.degree = instances.polynomialDegree;
  return glyph;
}

/// Rounds and widens again. GCC 12 at -O2 takes double(float(x)) for x when it does two components at once
/// (straight-line vectorisation, x86-64); a volatile in between keeps it from that.
template <class Real>
glm::dvec3 Rounded(const glm::dvec3& v)
{
  volatile Real x = Real(v.x), y = Real(v.y), z = Real(v.z);
  return { double(x), double(y), double(z) };
}

template <class Real>
typename shapes::Kernel<Real>::GlyphRay KernelRay(const HardRay& ray)
{
  using Vector = glm::vec<3, Real>;
  const glm::dvec3 high = Rounded<Real>(ray.origin);
  return { Vector(high), Vector(ray.origin - high), Vector(ray.direction) };
}

/// The ray from the place next to `origin` that is a float plus a float.
inline HardRay RayFrom(const glm::dvec3& origin, const glm::vec3& direction, std::uint32_t glyph)
{
  const glm::dvec3 high = Rounded<float>(origin);
  return { high + Rounded<float>(origin - high), direction, glyph };
}

/// What polynomials are made of.
enum class Forms
{
  Harmonics, ///< random ones of both signs, of all even bands up to the degree
  Bundles,   ///< up to three powers (n a)^degree of directions a, which makes narrow lobes
  Stress,    ///< degree 2: n^T S n, the eigenvalues of S having ratios to 1e6, now and then equal ones or zeros
  Stiffness  ///< degree 4: C_ijkl n_i n_j n_k n_l, a positive definite matrix in Voigt's notation
};

/// One shape with its parameters, and how to make it flat or thin.
struct Subject
{
  std::string name;
  Shape shape;
  ArrowForm arrow;
  bool sameSize;
  /// Each glyph's exponents lie between these, at random on a logarithmic scale; the third is the second where `most`
  /// of it is 0.
  glm::vec3 leastExponents{ 2.0f };
  glm::vec3 mostExponents{ 2.0f };
  /// Instead those of random tensors whose eigenvalues have ratios to 1e6, now and then equal ones or zeros.
  bool fromTensors = false;
  TensorGlyphKind tensors = TensorGlyphKind::Superquadric;
  /// Of polynomials; else 0. Each glyph has another one.
  int degree = 0;
  Forms forms = Forms::Harmonics;
};

/// For GoogleTest's lists of parameters.
inline void PrintTo(const Subject& subject, std::ostream* out)
{
  *out << subject.name;
}

class HardCaseMaker
{
public:
  static constexpr std::uint64_t usualSeed = 20;

  HardCaseMaker(const Subject& subject, int glyphs, int raysPerGlyph, std::uint64_t seed = usualSeed)
    : subject_(subject)
    , glyphs_(glyphs)
    , raysPerGlyph_(raysPerGlyph)
    , seed_(seed)
  {
  }

  std::vector<HardCase> All();

  /// One case of All(), with the same rays. The cases before it are made and thrown away, as all share
  /// one sequence of random numbers: the first cases cost least. Throws std::invalid_argument where
  /// the subject has no case of that name.
  HardCase Case(const std::string& situation);

private:
  using Vec = glm::dvec3;
  using Exact = shapes::Kernel<double>;
  /// Adds one ray at the glyph of the given number.
  using RayMaker = std::function<void(HardCase&, std::uint32_t)>;
  /// Takes a case; false: no more are wanted.
  using CaseTaker = std::function<bool(HardCase)>;

  double Uniform(double low, double high) { return low + (high - low) * double(this->engine_() >> 11) * 0x1p-53; }
  int Choice(int count) { return int(this->engine_() % std::uint64_t(count)); }
  Vec UnitVector()
  {
    const double z = this->Uniform(-1, 1), phi = this->Uniform(-std::numbers::pi, std::numbers::pi);
    return { std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z };
  }
  glm::vec4 Rotation()
  {
    const Vec axis = this->UnitVector();
    const double angle = this->Uniform(0, std::numbers::pi);
    return glm::vec4(glm::dvec4(std::sin(angle / 2) * axis, std::cos(angle / 2)));
  }

  /// With ratios to 1e6, now and then equal ones or zeros; largest first.
  glm::dvec3 Eigenvalues(bool ofBothSigns)
  {
    Eigensystem eigen;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool negative = ofBothSigns && this->Choice(2) == 0;
      const double magnitude = std::pow(10.0, this->Choice(2) == 0 ? this->Uniform(-6, 0) : this->Uniform(-1, 0));
      eigen.values[axis] = negative ? -magnitude : magnitude;
    }
    if (this->Choice(6) == 0)
    {
      eigen.values.y = this->Choice(2) == 0 ? 0.0 : eigen.values.x;
    }
    double* values = &eigen.values.x;
    std::sort(values, values + 3, std::greater<double>());
    return eigen.values;
  }

  glm::vec3 TensorExponents()
  {
    Eigensystem eigen;
    eigen.values = this->Eigenvalues(this->subject_.tensors == TensorGlyphKind::SignedSuperquadric);
    return glm::vec3(MakeTensorGlyph(eigen, this->subject_.tensors, 3.0).exponents);
  }

  /// xx yy zz xy yz xz
  std::vector<double> Stress()
  {
    const glm::dvec3 values = this->Eigenvalues(true);
    const glm::vec4 turn = this->Rotation();
    const glm::dmat3 axes = glm::mat3_cast(glm::dquat(turn.w, turn.x, turn.y, turn.z));
    const glm::dmat3 s = axes * glm::dmat3(values.x, 0, 0, 0, values.y, 0, 0, 0, values.z) * glm::transpose(axes);
    return { s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[0][2] };
  }

  /// The 36 components of A A^T, A a matrix of 6 x 6 random numbers with a diagonal that is now and then large.
  std::vector<double> Stiffness()
  {
    double a[6][6];
    const double stiff = this->Choice(2) == 0 ? 3.0 : 0.0;
    for (int i = 0; i < 6; ++i)
    {
      for (int j = 0; j < 6; ++j)
      {
        a[i][j] = this->Uniform(-1, 1) + (i == j ? stiff : 0.0);
      }
    }
    std::vector<double> components;
    for (int i = 0; i < 6; ++i)
    {
      for (int j = 0; j < 6; ++j)
      {
        components.push_back(std::inner_product(a[i], a[i] + 6, a[j], 0.0));
      }
    }
    return components;
  }

  glm::vec3 Exponents()
  {
    if (this->subject_.fromTensors)
    {
      return this->TensorExponents();
    }
    glm::vec3 exponents = this->subject_.leastExponents;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double least = exponents[axis], most = this->subject_.mostExponents[axis];
      exponents[axis] = most == 0 ? exponents.y : float(least * std::pow(most / least, this->Uniform(0, 1)));
    }
    return exponents;
  }
  std::vector<double> Form()
  {
    const int degree = this->subject_.degree;
    std::vector<double> form(FormTerms(degree), 0.0);
    if (this->subject_.forms == Forms::Stress)
    {
      FormMap::NormalStress().Apply(this->Stress().data(), form.data());
      return form;
    }
    if (this->subject_.forms == Forms::Stiffness)
    {
      FormMap::FourthOrder(36).Apply(this->Stiffness().data(), form.data());
      return form;
    }
    if (this->subject_.forms == Forms::Harmonics)
    {
      std::vector<double> harmonics;
      for (int l = 0; l <= degree; l += 2)
      {
        for (int m = -l; m <= l; ++m)
        {
          harmonics.push_back(this->Uniform(-1, 1));
        }
      }
      FormMap::Harmonics(int(harmonics.size()), HarmonicsBasis::Orthonormal).Apply(harmonics.data(), form.data());
      return form;
    }
    for (int bundle = this->Choice(3); bundle >= 0; --bundle)
    {
      const Vec a = this->UnitVector();
      const double weight = this->Uniform(0.3, 1);
      for (int b = 0; b <= degree; ++b)
      {
        for (int c = 0; b + c <= degree; ++c)
        {
          const int rest = degree - b - c;
          form[FormTerm(b, c)] += weight *
            std::exp(std::lgamma(degree + 1) - std::lgamma(rest + 1) - std::lgamma(b + 1) - std::lgamma(c + 1)) *
            std::pow(a.x, rest) * std::pow(a.y, b) * std::pow(a.z, c);
        }
      }
    }
    return form;
  }

  /// Of half-axes between those of `least` and `most`, diagonal or rotated.
  SymmetricTensor Covariance(const Vec& least, const Vec& most, const glm::dmat3& axes)
  {
    glm::dmat3 squares(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double half = this->Uniform(least[axis], most[axis]);
      squares[axis][axis] = half * half;
    }
    return SymmetricTensor::Of(axes * squares * glm::transpose(axes));
  }

  /// Stores a sweep next to a center. Thin ones are needles, or flat, which StoreSweep() limits to 1 : 1e3: in one
  /// plane, or not.
  void StoreSweep(GlyphInstances& instances, std::size_t index, double size, double ratio, bool turned)
  {
    const auto axes = [&]
    {
      const glm::vec4 q = turned ? this->Rotation() : glm::vec4(0, 0, 0, 1);
      return glm::mat3_cast(glm::normalize(glm::dquat(q.w, q.x, q.y, q.z)));
    };
    const bool thin = ratio > 1, needle = thin && this->Choice(2) == 0;
    Vec least(needle ? 0.3 * size / ratio : 0.1 * size), most(needle ? size / ratio : 0.3 * size);
    if (thin && !needle)
    {
      least.z = most.z = size / ratio;
    }
    const glm::dmat3 first = axes(), last = this->Choice(2) == 0 ? first : axes();
    const Vec center(instances.centers[index]),
      way = (turned ? this->UnitVector() : Vec(1, 0, 0)) * size * this->Uniform(0.15, 0.3);
    rtg::StoreSweep({ center - way, this->Covariance(least, most, first) },
      { center + way, this->Covariance(least, most, last) }, index, instances);
  }

  bool IsFixedArrow() const { return this->subject_.shape == Shape::Arrow && this->subject_.arrow.fixedHeads; }

  /// The unit form's box: (0 .. 1) along x for arrows, else centerd.
  Vec ToWorld(const HardCase& hard, std::uint32_t index, const Vec& box) const;
  Vec RandomBoxPoint();
  Vec EdgePoint(const HardCase& hard, std::uint32_t index);
  bool Surface(const HardCase& hard, std::uint32_t index, Vec& point, Vec& normal);
  double Extent(const HardCase& hard, std::uint32_t index) const;

  void ForEachCase(const CaseTaker& take);
  HardCase Start(const std::string& situation, double size, double ratio, double distance, bool turned);
  void Shoot(HardCase& hard, std::uint32_t index, const Vec& target, Vec direction, double distance);
  void Fill(HardCase& hard, const RayMaker& maker);
  void Aim(HardCase& hard, double distance);
  void Graze(HardCase& hard);
  void Touch(HardCase& hard);
  void StartInside(HardCase& hard);
  void StartOnSurface(HardCase& hard);
  void AlongAxes(HardCase& hard);
  void AlongThinness(HardCase& hard, double ratio);

  Subject subject_;
  int glyphs_;
  int raysPerGlyph_;
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

inline HardCase
HardCaseMaker::Start(const std::string& situation, double size, double ratio, double distance, bool turned)
{
  HardCase hard;
  hard.subject = this->subject_.name;
  hard.situation = situation;
  GlyphInstances& instances = hard.instances;
  instances.shape = this->subject_.shape;
  instances.arrow = this->subject_.arrow;
  instances.uniformExponents = this->subject_.leastExponents;
  // A fixed head's proportions are its own; what can be extreme is the shaft's length.
  instances.arrow.unitLength = float(size / (ratio > 1 ? ratio : 1.25));
  for (int i = 0; i < this->glyphs_; ++i)
  {
    instances.centers.emplace_back(distance * this->UnitVector() + 0.5 * size * this->UnitVector());
    if (turned)
    {
      instances.rotations.push_back(this->Rotation());
    }
    if (this->subject_.fromTensors || this->subject_.leastExponents != this->subject_.mostExponents)
    {
      instances.exponents3.push_back(this->Exponents());
    }
    if (this->subject_.degree > 0)
    {
      const FormMeter meter(this->subject_.degree);
      const std::vector<double> form = this->Form();
      std::vector<float> values(3 + form.size());
      meter.Store(form.data(), meter.Measure(form.data()), values.data());
      instances.polynomialDegree = this->subject_.degree;
      instances.polynomials.width = values.size();
      instances.polynomials.values.insert(instances.polynomials.values.end(), values.begin(), values.end());
    }
    if (this->subject_.sameSize)
    {
      instances.sizes1.push_back(float(size));
      continue;
    }
    if (instances.shape == Shape::SweptEllipsoid)
    {
      const std::size_t count = instances.centers.size();
      instances.sizes3.resize(count);
      instances.rotations.resize(count);
      instances.exponents3.resize(count);
      instances.before.resize(count);
      instances.after.resize(count);
      this->StoreSweep(instances, count - 1, size, ratio, turned);
      continue;
    }
    Vec sizes = size * Vec(this->Uniform(0.3, 1), this->Uniform(0.3, 1), this->Uniform(0.3, 1));
    if (ratio > 1)
    {
      const int axis = this->Choice(3);
      const bool needle = this->Choice(2) == 0;
      sizes = Vec(needle ? size / ratio : size);
      sizes[axis] = needle ? size : size / ratio;
    }
    if (this->IsFixedArrow())
    {
      sizes = Vec(size * this->Uniform(0.3, 1), size, size);
    }
    instances.sizes3.emplace_back(sizes);
  }
  return hard;
}

inline double HardCaseMaker::Extent(const HardCase& hard, std::uint32_t index) const
{
  const Exact::Glyph glyph = KernelGlyph<double>(hard.instances, index);
  return glm::max(glyph.size.x, glm::max(glyph.size.y, glyph.size.z));
}

inline glm::dvec3 HardCaseMaker::ToWorld(const HardCase& hard, std::uint32_t index, const Vec& box) const
{
  const Exact::Glyph glyph = KernelGlyph<double>(hard.instances, index);
  Vec scale = glyph.size;
  if (this->IsFixedArrow())
  {
    scale.y = scale.z =
      2 * std::max(glyph.arrow.x, glyph.arrow.y) * std::min(glyph.unitLength, glyph.size.x / glyph.arrow.z);
  }
  else if (this->subject_.shape == Shape::Arrow)
  {
    scale.y *= 2 * std::max(glyph.arrow.x, glyph.arrow.y);
    scale.z *= 2 * std::max(glyph.arrow.x, glyph.arrow.y);
  }
  else if (this->subject_.shape == Shape::Capsule)
  {
    scale.x += std::max(scale.y, scale.z);
  }
  Vec shift(this->subject_.shape == Shape::Arrow ? 0.5 : 0.0, 0, 0);
  if (this->subject_.shape == Shape::RoundCone)
  {
    Vec middle;
    Exact::RoundConeBox(glyph, middle, scale);
    scale *= 2.0;
    shift = middle / scale;
  }
  return glyph.center + Exact::RotateToWorld(glyph, (box + shift) * scale);
}

inline glm::dvec3 HardCaseMaker::RandomBoxPoint()
{
  const double half = 0.52;
  return { this->Uniform(-half, half), this->Uniform(-half, half), this->Uniform(-half, half) };
}

/// A point of an edge, rim, vertex or apex of the unit form, in its box.
inline glm::dvec3 HardCaseMaker::EdgePoint(const HardCase& hard, std::uint32_t index)
{
  const double phi = this->Uniform(-std::numbers::pi, std::numbers::pi);
  const double c = 0.5 * std::cos(phi), s = 0.5 * std::sin(phi);
  const double side = this->Choice(2) - 0.5;
  const ArrowForm& arrow = this->subject_.arrow;
  switch (this->subject_.shape)
  {
    case Shape::Box:
    {
      Vec p(this->Choice(2) - 0.5, this->Choice(2) - 0.5, this->Choice(2) - 0.5);
      if (this->Choice(4) != 0)
      {
        p[this->Choice(3)] = this->Uniform(-0.5, 0.5);
      }
      return p;
    }
    case Shape::Cylinder:
      return { c, side, s };
    case Shape::Capsule:
    {
      // Where an end begins, or its pole.
      const Exact::Glyph glyph = KernelGlyph<double>(hard.instances, index);
      const double seam = glyph.size.x / (glyph.size.x + std::max(glyph.size.y, glyph.size.z));
      return this->Choice(3) == 0 ? Vec(side, 0, 0) : Vec(side * seam, c, s);
    }
    case Shape::RoundCone:
    {
      // Where the cone touches a ball, or a pole.
      const Exact::Glyph glyph = KernelGlyph<double>(hard.instances, index);
      Vec middle, half;
      Exact::RoundConeBox(glyph, middle, half);
      const double radius = side < 0 ? 0.5 * glyph.size.y : 0.5 * glyph.size.z;
      const double sine = std::clamp(0.5 * (glyph.size.y - glyph.size.z) / glyph.size.x, -1.0, 1.0);
      const double across = radius * std::sqrt(1.0 - sine * sine) / half.y;
      return this->Choice(3) == 0
        ? Vec(side, 0, 0)
        : Vec((side * glyph.size.x + radius * sine - middle.x) / (2.0 * half.x), across * c, across * s);
    }
    case Shape::Cone:
      return this->Choice(3) == 0 ? Vec(0.5, 0, 0) : Vec(-0.5, c, s);
    case Shape::Arrow:
    {
      const double r = std::max(arrow.shaftRadius, arrow.tipRadius);
      const double shaft = r > 0 ? arrow.shaftRadius / r : 0, tip = r > 0 ? arrow.tipRadius / r : 0;
      // For fixed heads the head's base is elsewhere unless the arrow has unit length: still near edges.
      const double base = 0.5 - arrow.tipLength;
      const Vec edges[] = { { 0.5, 0, 0 }, { base, tip * c, tip * s }, { base, shaft * c, shaft * s },
        { -0.5, shaft * c, shaft * s } };
      return edges[this->Choice(4)];
    }
    case Shape::NestedSuperquadric:
    {
      // The rim, the seams where a profile meets a coordinate plane, the corners of the cross-section, the ends.
      const double alpha = std::max(KernelGlyph<double>(hard.instances, index).exponents.x, 1e-6);
      const double a = std::abs(2 * c), b = std::abs(2 * s);
      const double norm = std::pow(std::pow(a, 2 / alpha) + std::pow(b, 2 / alpha), alpha / 2);
      const Vec rim(c / norm, s / norm, 0), end(0, 0, side);
      const double along = this->Choice(3) == 0 ? std::pow(10.0, this->Uniform(-6, 0)) : this->Uniform(0, 1);
      const Vec corner(side, side, 0);
      switch (this->Choice(4))
      {
        case 0:
          return rim;
        case 1:
          return end * (1 - along) + Vec(along * along * c / norm, along * along * s / norm, 0);
        case 2:
          return std::pow(0.5, alpha / 2) * corner;
        default:
          return end;
      }
    }
    case Shape::Superquadric:
    {
      // Where it meets a plane of its frame, or its tips.
      const Vec e(KernelGlyph<double>(hard.instances, index).exponents);
      const int axis = this->Choice(3), u = (axis + 1) % 3, v = (axis + 2) % 3;
      const double share = this->Choice(4) == 0 ? 1.0 : this->Uniform(0, 1);
      Vec p(0);
      p[u] = 2.0 * side * 0.5 * std::pow(share, 1.0 / e[u]);
      p[v] = (this->Choice(2) - 0.5) * std::pow(1.0 - share, 1.0 / e[v]);
      return p;
    }
    case Shape::Polynomial:
      // The lobes meet at the center.
      return std::pow(10.0, this->Uniform(-6, -0.5)) * this->UnitVector();
    default:
      return 2.0 * Vec(c, 0.5 * s, s) / std::sqrt(1.0 + s * s);
  }
}

inline std::vector<HardCase> MakeHardCases(int glyphs = 12, int raysPerGlyph = 100);

} // namespace rtg::testing

#include "HardCaseRays.h"
