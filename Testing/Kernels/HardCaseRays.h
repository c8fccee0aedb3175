// The rays of HardCases.h.
#pragma once

#include "HardCases.h"

namespace rtg::testing
{

/// A ray that meets `target` after about `distance`. The direction becomes float first, so that the aim is
/// true whatever the distance.
inline void HardCaseMaker::Shoot(HardCase& hard, std::uint32_t index, const Vec& target, Vec direction, double distance)
{
  // Lengths other than one happen: instance transforms, unnormalized cameras.
  const double lengths[] = { 1.0, 1.0, 1.0 / 64, 40.0 };
  const glm::vec3 along(direction * lengths[this->Choice(4)]);
  const Vec exact = glm::normalize(Rounded<float>(Vec(along)));
  hard.rays.push_back(RayFrom(target - exact * distance, along, index));
}

inline void HardCaseMaker::Fill(HardCase& hard, const RayMaker& maker)
{
  for (std::uint32_t i = 0; i < hard.instances.Count(); ++i)
  {
    for (int k = 0; k < this->raysPerGlyph_; ++k)
    {
      maker(hard, i);
    }
  }
}

/// Rays all over the glyph's box, from `distance` glyph sizes away.
inline void HardCaseMaker::Aim(HardCase& hard, double distance)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      this->Shoot(h, i, this->ToWorld(h, i, this->RandomBoxPoint()), this->UnitVector(),
        distance * this->Extent(h, i) * this->Uniform(0.9, 1.1));
    });
}

/// A point of the surface, by the kernel in double.
inline bool HardCaseMaker::Surface(const HardCase& hard, std::uint32_t index, Vec& point, Vec& normal)
{
  const Exact::Glyph glyph = KernelGlyph<double>(hard.instances, index);
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    const Vec direction = this->UnitVector();
    const Vec target = this->ToWorld(hard, index, this->RandomBoxPoint());
    const Exact::GlyphRay ray{ target - 3.0 * this->Extent(hard, index) * direction, Vec(0), direction };
    double t;
    if (Exact::IntersectGlyph(hard.instances.shape, ray, glyph, 0.0, 1e30, t))
    {
      point = ray.origin + t * direction;
      normal = Exact::GlyphNormal(hard.instances.shape, ray, glyph, t);
      return true;
    }
  }
  return false;
}

/// Tangents of the surface, moved out or in by 0 to 1e-2 glyph sizes.
inline void HardCaseMaker::Graze(HardCase& hard)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      Vec point, normal;
      if (this->Surface(h, i, point, normal))
      {
        const double extent = this->Extent(h, i);
        const double off = this->Choice(8) == 0 ? 0.0 : std::pow(10.0, this->Uniform(-9, -2));
        const Vec tangent = glm::normalize(glm::cross(normal, this->UnitVector()));
        const double side = this->Choice(3) == 0 ? 1.0 : -1.0;
        this->Shoot(h, i, point + side * off * extent * normal, tangent, 2 * extent);
      }
    });
}

/// Rays through, or within 1e-8 to 1e-3 sizes of, edges, rims, vertices and apexes.
inline void HardCaseMaker::Touch(HardCase& hard)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      const double off = this->Choice(4) == 0 ? 0.0 : std::pow(10.0, this->Uniform(-8, -3));
      const double extent = this->Extent(h, i);
      const Vec target = this->ToWorld(h, i, this->EdgePoint(h, i)) + off * extent * this->UnitVector();
      this->Shoot(h, i, target, this->UnitVector(), extent * this->Uniform(0.5, 5));
    });
}

inline void HardCaseMaker::StartInside(HardCase& hard)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    { this->Shoot(h, i, this->ToWorld(h, i, 0.9 * this->RandomBoxPoint()), this->UnitVector(), 0.0); });
}

inline void HardCaseMaker::StartOnSurface(HardCase& hard)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      Vec point, normal;
      if (this->Surface(h, i, point, normal))
      {
        this->Shoot(h, i, point, this->UnitVector(), 0.0);
      }
    });
}

/// Parallel to the unit form's axes, edges, diagonals, through its symmetry points; the glyph is not turned,
/// so these rays meet edges, vertices and apexes exactly.
inline void HardCaseMaker::AlongAxes(HardCase& hard)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      const double lattice[] = { -0.5, -0.25, 0.0, 0.25, 0.5, 0.5000001, 0.4999999 };
      const Vec box(lattice[this->Choice(7)], lattice[this->Choice(7)], lattice[this->Choice(7)]);
      Vec direction(this->Choice(3) - 1, this->Choice(3) - 1, this->Choice(3) - 1);
      if (direction == Vec(0))
      {
        direction.x = 1;
      }
      this->Shoot(h, i, this->ToWorld(h, i, box), direction, 4 * this->Extent(h, i));
    });
}

/// Within a few thicknesses of a needle's axis or of a flat glyph's plane.
inline void HardCaseMaker::AlongThinness(HardCase& hard, double ratio)
{
  this->Fill(hard,
    [&](HardCase& h, std::uint32_t i)
    {
      const Vec center = this->ToWorld(h, i, 0.8 * this->RandomBoxPoint());
      const Vec other = this->ToWorld(h, i, 0.8 * this->RandomBoxPoint());
      const double spread = std::pow(ratio, this->Uniform(-1.2, 0.0));
      const Vec direction = glm::normalize(other - center) + spread * this->UnitVector();
      this->Shoot(h, i, center, glm::normalize(direction), 3 * this->Extent(h, i));
    });
}

inline void HardCaseMaker::ForEachCase(const CaseTaker& take)
{
  this->engine_.seed(this->seed_);
  bool wanted = true;
  const auto add = [&](const std::string& situation, double size, double ratio, double distance, bool turned,
                     const std::function<void(HardCase&)>& rays)
  {
    if (wanted)
    {
      HardCase hard = this->Start(situation, size, ratio, distance, turned);
      rays(hard);
      wanted = take(std::move(hard));
    }
  };
  const auto aim = [&](double distance) { return [this, distance](HardCase& h) { this->Aim(h, distance); }; };
  const bool turned = !this->subject_.sameSize;

  add("plain", 1, 1, 0, false, aim(3));
  add("turned", 1, 1, 0, turned, aim(3));
  add("1e4 from the origin, size 0.02, camera 1 away", 0.02, 1, 1e4, turned, aim(50));
  add("1e4 from the origin, size 0.02, camera 1e4 away", 0.02, 1, 1e4, turned, aim(5e5));
  add("camera 1e4 sizes away", 1, 1, 0, turned, aim(1e4));
  add("camera 1e6 sizes away", 1, 1, 0, turned, aim(1e6));
  add("size 1e-6", 1e-6, 1, 0, turned, aim(3));
  add("size 1e6", 1e6, 1, 0, turned, aim(3));
  add("grazing", 1, 1, 0, turned, [this](HardCase& h) { this->Graze(h); });
  add("near edges", 1, 1, 0, turned, [this](HardCase& h) { this->Touch(h); });
  add("along axes", 1, 1, 0, false, [this](HardCase& h) { this->AlongAxes(h); });
  add("from inside", 1, 1, 0, turned, [this](HardCase& h) { this->StartInside(h); });
  add("from the surface", 1, 1, 0, turned, [this](HardCase& h) { this->StartOnSurface(h); });
  if (!this->subject_.sameSize)
  {
    for (const double ratio : { 1e2, 1e4, 1e6 })
    {
      const std::string suffix = " 1:1e" + std::to_string(int(std::lround(std::log10(ratio))));
      add("thin" + suffix, 1, ratio, 0, true, aim(3));
      add(
        "thin" + suffix + ", along", 1, ratio, 0, true, [this, ratio](HardCase& h) { this->AlongThinness(h, ratio); });
      add("thin" + suffix + ", grazing", 1, ratio, 0, true, [this](HardCase& h) { this->Graze(h); });
    }
    add("thin 1:1e4, 1e4 from the origin", 0.02, 1e4, 1e4, true, aim(50));
  }
  add("1e7 from the origin, size 0.02, camera 1 away", 0.02, 1, 1e7, turned, aim(50));
}

inline std::vector<HardCase> HardCaseMaker::All()
{
  std::vector<HardCase> cases;
  this->ForEachCase(
    [&](HardCase hard)
    {
      cases.push_back(std::move(hard));
      return true;
    });
  return cases;
}

inline HardCase HardCaseMaker::Case(const std::string& situation)
{
  HardCase last;
  this->ForEachCase(
    [&](HardCase hard)
    {
      last = std::move(hard);
      return last.situation != situation;
    });
  if (last.situation != situation)
  {
    throw std::invalid_argument("no hard case of " + this->subject_.name + " is called '" + situation + "'");
  }
  return last;
}

inline std::vector<Subject> HardSubjects()
{
  const auto arrow = [](float shaft, float tip, float length, float rounding, bool fixed)
  {
    ArrowForm form;
    form.shaftRadius = shaft;
    form.tipRadius = tip;
    form.tipLength = length;
    form.tipRounding = rounding;
    form.fixedHeads = fixed;
    return form;
  };
  const auto superquadric = [](const std::string& name, const glm::vec3& least, const glm::vec3& most) {
    return Subject{ "superquadric, " + name, Shape::Superquadric, {}, false, least, most };
  };
  return {
    { "sphere", Shape::Sphere, {}, true },
    { "ellipsoid", Shape::Sphere, {}, false },
    { "box", Shape::Box, {}, false },
    { "cylinder", Shape::Cylinder, {}, false },
    { "cone", Shape::Cone, {}, false },
    { "capsule", Shape::Capsule, {}, false },
    { "round cone", Shape::RoundCone, {}, false },
    { "swept ellipsoid", Shape::SweptEllipsoid, {}, false },
    { "arrow", Shape::Arrow, {}, false },
    { "arrow, sharp", Shape::Arrow, arrow(0.03f, 0.1f, 0.35f, 0, true), false },
    { "arrow, fully rounded", Shape::Arrow, arrow(0.03f, 0.1f, 0.35f, 1, true), false },
    { "arrow, scaled", Shape::Arrow, arrow(0.03f, 0.1f, 0.35f, 0.5f, false), false },
    { "arrow, scaled, sharp", Shape::Arrow, arrow(0.03f, 0.1f, 0.35f, 0, false), false },
    { "arrow, only a head", Shape::Arrow, arrow(0.03f, 0.5f, 1, 0.5f, false), false },
    { "arrow, no shaft", Shape::Arrow, arrow(0, 0.2f, 0.5f, 0.3f, true), false },
    { "arrow, thick shaft", Shape::Arrow, arrow(0.3f, 0.1f, 0.35f, 1, true), false },
    { "arrow, shaft as thick as the tip", Shape::Arrow, arrow(0.1f, 0.1f, 0.35f, 0.5f, true), false },
    superquadric("all 2", glm::vec3(2.0f), glm::vec3(2.0f)),
    superquadric("all 1", glm::vec3(1.0f), glm::vec3(1.0f)),
    superquadric("all 20", glm::vec3(20.0f), glm::vec3(20.0f)),
    superquadric("all 0.3", glm::vec3(0.3f), glm::vec3(0.3f)),
    superquadric("1 to 2", glm::vec3(1.0f), glm::vec3(2.0f)),
    superquadric("2 to 20", glm::vec3(2.0f), glm::vec3(20.0f)),
    superquadric("0.3 to 1", glm::vec3(0.3f), glm::vec3(1.0f)),
    superquadric("0.3 to 20", glm::vec3(0.3f), glm::vec3(20.0f)),
  };
}

/// Nested superquadrics, as tensors of both kinds and of sharpness up to 3 give them.
inline std::vector<Subject> NestedSubjects()
{
  const auto nested = [](const std::string& name, const glm::vec3& exponents) {
    return Subject{ "nested, " + name, Shape::NestedSuperquadric, {}, false, exponents, exponents };
  };
  const auto tensors = [](const std::string& name, TensorGlyphKind kind)
  {
    return Subject{ "nested, " + name, Shape::NestedSuperquadric, {}, false, glm::vec3(1.0f), glm::vec3(1.0f), true,
      kind };
  };
  return {
    nested("ball", { 1, 1, 1 }),
    nested("rounded box", { 0.125f, 0.125f, 0.125f }),
    nested("cylinder", { 1, 0.01f, 0.01f }),
    nested("nearly a cone", { 0.6f, 1.8f, 1.8f }),
    nested("octahedron", { 0.01f, 2, 2 }),
    nested("thorn", { 1, 5, 5 }),
    nested("between", { 0.4f, 3.5f, 2.4f }),
    nested("funk", { 0.01f, 5, 2 }),
    tensors("positive tensors", TensorGlyphKind::Superquadric),
    tensors("signed tensors", TensorGlyphKind::SignedSuperquadric),
    // 2 / alpha and 2 / beta from 0.3 to 20
    Subject{
      "nested, 0.3 to 20", Shape::NestedSuperquadric, {}, false, { 0.1f, 0.1f, 0.1f }, { 20.0f / 3, 20.0f / 3, 0 } },
  };
}

inline Subject PolynomialSubject(int degree, Forms forms)
{
  const char* const names[] = { "harmonics", "bundles", "stress", "stiffness" };
  Subject subject{ "polynomial, " + std::string(names[static_cast<int>(forms)]) + ", degree " + std::to_string(degree),
    Shape::Polynomial, {}, false };
  subject.degree = degree;
  subject.forms = forms;
  return subject;
}

/// Polynomials of the degrees of tensors and of spherical harmonics.
inline std::vector<Subject> PolynomialSubjects()
{
  return { PolynomialSubject(2, Forms::Harmonics), PolynomialSubject(4, Forms::Harmonics),
    PolynomialSubject(6, Forms::Bundles), PolynomialSubject(8, Forms::Harmonics),
    PolynomialSubject(8, Forms::Bundles) };
}

inline std::vector<HardCase> MakeHardCases(int glyphs, int raysPerGlyph)
{
  std::vector<HardCase> cases;
  std::vector<Subject> subjects = HardSubjects();
  for (const auto& more : { NestedSubjects(), PolynomialSubjects() })
  {
    subjects.insert(subjects.end(), more.begin(), more.end());
  }
  for (const Subject& subject : subjects)
  {
    for (HardCase& hard : HardCaseMaker(subject, glyphs, raysPerGlyph).All())
    {
      cases.push_back(std::move(hard));
    }
  }
  return cases;
}

} // namespace rtg::testing
