#include "GlyphTessellatedSet.h"

#include "GlyphTessellation.h"
#include "Shading/Shading.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace
{
// Linear light of a display color, as the formats have it.
glm::vec4 Linear(const glm::vec3& shown, float opacity)
{
  return { rtg::shading::DisplayToLinear(shown), opacity };
}

std::string NameOf(rtg::Shape shape)
{
  switch (shape)
  {
#define RTG_SHAPE_NAME(number, Name)                                                                                   \
  case rtg::Shape::Name:                                                                                               \
    return #Name;
    RTG_SHAPES(RTG_SHAPE_NAME)
#undef RTG_SHAPE_NAME
    default:
      return "Mesh";
  }
}

// The mean of the colors at a tube's ends.
glm::vec4 MeanOfEnds(const rtg::GlyphColors& colors, std::size_t glyph)
{
  const auto at = [&colors](std::uint32_t bits)
  {
    if (colors.table.empty())
    {
      return glm::unpackUnorm4x8(bits);
    }
    const auto values = static_cast<float>(colors.table.size() - 2);
    const float value = glm::uintBitsToFloat(bits);
    const std::size_t entry = value <= rtg::noValue ? colors.table.size() - 1
      : value <= rtg::notANumber                    ? colors.table.size() - 2
                                 : static_cast<std::size_t>(std::clamp(value * values, 0.0f, values - 1.0f));
    return glm::unpackUnorm4x8(colors.table[entry]);
  };
  return 0.5f * (at(colors.ends[glyph].x) + at(colors.ends[glyph].y));
}

// Puts copies of a display's glyphs, part by part, into the set.
class Assembly
{
public:
  Assembly(rtglyphs::GlyphTessellatedSet& set, const rtg::GlyphInstances& all)
    : Set(set)
    , All(all)
  {
  }

  std::size_t AddMesh(const std::string& name, rtg::TriangleMesh mesh)
  {
    rtglyphs::GlyphTessellatedPart part;
    part.Name = name;
    part.Mesh = std::make_shared<const rtg::TriangleMesh>(std::move(mesh));
    this->Set.Parts.push_back(std::move(part));
    return this->Set.Parts.size() - 1;
  }

  // A copy at `place` in the glyph's frame, rotated about its y axis by 180 degrees if it points back.
  void Add(std::size_t part, std::size_t glyph, const glm::vec3& scale, const glm::vec3& place = glm::vec3(0.0f),
    bool back = false)
  {
    const glm::dquat turn = this->TurnOf(glyph);
    const glm::dvec3 shift = turn * glm::dvec3(place);
    const glm::dquat whole = back ? turn * glm::dquat(0.0, 0.0, 1.0, 0.0) : turn;
    rtglyphs::GlyphTessellatedPart& to = this->Set.Parts[part];
    to.Glyphs.push_back(static_cast<std::uint32_t>(glyph));
    to.Positions.emplace_back(this->PlaceOf(glyph, place));
    to.Orientations.emplace_back(whole.x, whole.y, whole.z, whole.w);
    to.Scales.push_back(scale);

    const rtg::GlyphMotion& motion = this->All.motion;
    const glm::dvec3 spin = motion.Spins() ? glm::dvec3(motion.angularVelocities[glyph]) : glm::dvec3(0.0);
    const auto fill = [&](std::vector<glm::vec3>& values, const std::vector<glm::vec3>& of, const glm::dvec3& more)
    {
      if (!of.empty() || motion.Spins())
      {
        values.emplace_back((of.empty() ? glm::dvec3(0.0) : glm::dvec3(of[glyph])) + more);
      }
    };
    // Parts beside the glyph's center rotate around it.
    const glm::dvec3 around = glm::cross(spin, shift);
    fill(to.Velocities, motion.velocities, around);
    fill(to.Accelerations, motion.accelerations, glm::cross(spin, around));
    if (motion.Spins())
    {
      to.AngularVelocities.emplace_back(spin);
    }
  }

  void AddAll(std::size_t part)
  {
    for (std::size_t glyph = 0; glyph < this->All.Count(); ++glyph)
    {
      this->Add(part, glyph, this->All.SizeOf(glyph));
    }
  }

  // A cylinder, and half balls that are as long as its larger diameter is wide: Kernels/Shapes/Capsule.glsl.
  void AddCapsules()
  {
    const std::size_t middle = this->AddMesh("Middle", rtglyphs::GlyphTessellation::CutCone(1.0, true));
    const std::size_t end = this->AddMesh("End", rtglyphs::GlyphTessellation::Sphere(/*half=*/true));
    for (std::size_t glyph = 0; glyph < this->All.Count(); ++glyph)
    {
      const glm::vec3 size = this->All.SizeOf(glyph);
      const float half = 0.5f * size.x;
      this->Add(middle, glyph, { size.x, 0.5f * size.y, 0.5f * size.z }, { -half, 0.0f, 0.0f });
      const float widest = std::max(size.y, size.z);
      this->Add(end, glyph, { widest, size.y, size.z }, { half, 0.0f, 0.0f });
      this->Add(end, glyph, { widest, size.y, size.z }, { -half, 0.0f, 0.0f }, true);
    }
  }

  // Shaft and head, each of which is an affine image of one mesh, whether or not heads are fixed:
  // Kernels/Shapes/ArrowForm.glsl.
  void AddArrows()
  {
    const rtg::ArrowForm& form = this->All.arrow;
    const bool hasHeads = form.tipRadius > 0.0f, hasShafts = form.shaftRadius > 0.0f;
    const std::size_t shaft = hasShafts ? this->AddMesh("Shaft", rtglyphs::GlyphTessellation::CutCone(1.0, false)) : 0;
    const std::size_t head = hasHeads ? this->AddMesh("Head", rtglyphs::GlyphTessellation::ArrowHead(form)) : 0;
    for (std::size_t glyph = 0; glyph < this->All.Count(); ++glyph)
    {
      const glm::vec3 size = this->All.SizeOf(glyph);
      glm::vec3 unit = size; // of the arrow that has this one's head
      if (form.fixedHeads)
      {
        const float length = form.unitLength > 0.0f ? form.unitLength : size.y;
        unit = glm::vec3(std::min(length, size.x / form.tipLength));
      }
      const float shaftLength = size.x - form.tipLength * unit.x;
      if (hasShafts && shaftLength > 1e-6f * size.x)
      {
        this->Add(shaft, glyph, { shaftLength, form.shaftRadius * unit.y, form.shaftRadius * unit.z });
      }
      if (hasHeads)
      {
        this->Add(head, glyph, unit, { size.x, 0.0f, 0.0f });
      }
    }
  }

  // Balls, and the cones between that touch them: Kernels/Shapes/RoundCone.glsl. Cones have a mesh for each percent of
  // their ratio of radii.
  void AddTubes()
  {
    const std::size_t ball = this->AddMesh("Ball", rtglyphs::GlyphTessellation::Sphere());
    std::map<std::pair<int, bool>, std::size_t> cones;
    glm::dvec3 last(HUGE_VAL); // middle of the last ball
    for (std::size_t glyph = 0; glyph < this->All.Count(); ++glyph)
    {
      const glm::vec3 size = this->All.SizeOf(glyph);
      const bool flat[] = { !this->All.before.empty() && this->All.before[glyph].w < 0.0f,
        !this->All.after.empty() && this->All.after[glyph].w < 0.0f };
      const double radii[] = { 0.5 * size.y, 0.5 * size.z }, half = 0.5 * size.x;
      const bool back = radii[1] > radii[0]; // the mesh becomes thinner toward +x
      const double larger = radii[back ? 1 : 0], smaller = radii[back ? 0 : 1];
      const double sine = (larger - smaller) / size.x, cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
      if (sine < 1.0)
      {
        const double from = -half + larger * sine, to = half + smaller * sine; // along the mesh
        const int percent =
          smaller > 0.0 ? std::max(-1000, static_cast<int>(std::lround(100.0 * std::log(smaller / larger)))) : -1000;
        const bool open = !flat[0] && !flat[1];
        const auto [found, added] = cones.try_emplace({ percent, open }, this->Set.Parts.size());
        if (added)
        {
          this->AddMesh("Cone_" + std::to_string(found->second),
            rtglyphs::GlyphTessellation::CutCone(std::exp(0.01 * percent), open));
        }
        const auto across = static_cast<float>(larger * cosine);
        this->Add(found->second, glyph, { static_cast<float>(to - from), across, across },
          { static_cast<float>(back ? -from : from), 0.0f, 0.0f }, back);
      }
      for (int end = 0; end < 2; ++end)
      {
        const float at = static_cast<float>(end == 0 ? -half : half);
        const glm::dvec3 middle = this->PlaceOf(glyph, { at, 0.0f, 0.0f });
        const bool again = glm::distance(middle, last) < 1e-4 * radii[end];
        if (!flat[end] && !again && radii[end] > 0.0)
        {
          this->Add(ball, glyph, glm::vec3(static_cast<float>(2.0 * radii[end])), { at, 0.0f, 0.0f });
        }
        last = middle;
      }
    }
  }

  // A mesh for each. False: they would be too many.
  bool AddSweeps()
  {
    const bool few = this->All.Count() <= rtglyphs::GlyphTessellatedSet::MostMeshes;
    for (std::size_t glyph = 0; few && glyph < this->All.Count(); ++glyph)
    {
      const std::size_t part =
        this->AddMesh("Sweep_" + std::to_string(glyph), rtglyphs::GlyphTessellation::SweptEllipsoid(this->All, glyph));
      this->Add(part, glyph, glm::vec3(1.0f));
    }
    return few;
  }

  // A mesh for each triple of exponents. False: they would be too many.
  bool AddSuperquadrics()
  {
    const bool same = this->All.exponents3.empty();
    const int facets = same ? 64 : 16;
    const bool nested = this->All.shape == rtg::Shape::NestedSuperquadric;
    std::map<std::array<float, 3>, std::size_t> parts;
    for (std::size_t glyph = 0; glyph < this->All.Count(); ++glyph)
    {
      const glm::vec3 e = same ? this->All.uniformExponents : this->All.exponents3[glyph];
      const auto [found, added] = parts.try_emplace({ e.x, e.y, e.z }, this->Set.Parts.size());
      if (added)
      {
        if (parts.size() > rtglyphs::GlyphTessellatedSet::MostMeshes)
        {
          this->Set.Parts.clear();
          return false;
        }
        this->AddMesh("Superquadric_" + std::to_string(found->second),
          nested ? rtglyphs::GlyphTessellation::NestedSuperquadric(e, facets)
                 : rtglyphs::GlyphTessellation::Superquadric(e, facets));
      }
      this->Add(found->second, glyph, this->All.SizeOf(glyph));
    }
    return true;
  }

private:
  glm::dquat TurnOf(std::size_t glyph) const
  {
    const glm::vec4 r = this->All.rotations.empty() ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : this->All.rotations[glyph];
    return glm::dquat(r.w, r.x, r.y, r.z);
  }

  // Position of a place in the glyph's frame.
  glm::dvec3 PlaceOf(std::size_t glyph, const glm::vec3& place) const
  {
    glm::dvec3 center(this->All.centers[glyph]);
    if (!this->All.centersLow.empty())
    {
      center += glm::dvec3(this->All.centersLow[glyph]);
    }
    return center + this->TurnOf(glyph) * glm::dvec3(place);
  }

  rtglyphs::GlyphTessellatedSet& Set;
  const rtg::GlyphInstances& All;
};
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphTessellatedSet::IsTranslucent() const
{
  return this->Color.a < 1.0f ||
    std::any_of(this->Colors.begin(), this->Colors.end(), [](const glm::vec4& color) { return color.a < 1.0f; });
}

//----------------------------------------------------------------------------
const glm::vec4& rtglyphs::GlyphTessellatedSet::ColorOf(std::uint32_t glyph) const
{
  return this->Colors.empty() ? this->Color : this->Colors[glyph];
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTessellatedSet rtglyphs::GlyphTessellatedSet::Make(const std::string& number,
  const rtg::GlyphInstances& instances, const rtg::GlyphColors& colors, const rtg::Material& material,
  std::vector<std::string>& messages)
{
  rtglyphs::GlyphTessellatedSet set;
  set.Origin = instances.origin;
  set.Metallic = material.metallic;
  set.Roughness = material.roughness;
  set.Color = Linear(material.color, material.opacity);
  const bool bySign = !instances.forms.empty();
  const bool swept = instances.shape == rtg::Shape::SweptEllipsoid;
  const bool ofEnds = (swept || instances.shape == rtg::Shape::RoundCone) && !colors.ends.empty();
  bool bothSigns = false;
  if (bySign || !instances.opacities.empty() || !colors.Empty())
  {
    set.Colors.resize(instances.Count(), set.Color);
    for (std::size_t glyph = 0; glyph < instances.Count(); ++glyph)
    {
      glm::vec4& color = set.Colors[glyph];
      if (bySign)
      {
        const glm::vec3& form = instances.forms[glyph];
        const auto [least, most] = std::minmax({ form.x, form.y, form.z });
        const bool negative = least < 0.0f && most <= 0.0f;
        bothSigns = bothSigns || (least < 0.0f && most > 0.0f);
        color = Linear(negative ? material.negativeColor : material.positiveColor, material.opacity);
      }
      const glm::vec4 ofSurface = color;
      if (!colors.each.empty() || ofEnds)
      {
        const glm::vec4 shown = ofEnds ? MeanOfEnds(colors, glyph) : glm::unpackUnorm4x8(colors.each[glyph]);
        // White stands for the colors of the surface (rtg::GlyphColors).
        color = bySign && glm::vec3(shown) == glm::vec3(1.0f) ? ofSurface : Linear(glm::vec3(shown), material.opacity);
        color.a *= shown.a;
      }
      color.a *= instances.opacities.empty() ? 1.0f : instances.opacities[glyph];
    }
  }

  Assembly assembly(set, instances);
  const std::string shape = NameOf(instances.shape);
  set.Name = shape + "_" + number;
  const auto all = [&](rtg::TriangleMesh mesh) { assembly.AddAll(assembly.AddMesh(shape, std::move(mesh))); };
  switch (instances.shape)
  {
    case rtg::Shape::Sphere:
      all(rtglyphs::GlyphTessellation::Sphere());
      break;
    case rtg::Shape::Box:
      all(rtglyphs::GlyphTessellation::Box());
      break;
    case rtg::Shape::Cylinder:
      all(rtglyphs::GlyphTessellation::Cylinder());
      break;
    case rtg::Shape::Cone:
      all(rtglyphs::GlyphTessellation::Cone());
      break;
    case rtg::Shape::Capsule:
      assembly.AddCapsules();
      break;
    case rtg::Shape::Arrow:
      assembly.AddArrows();
      break;
    case rtg::Shape::Mesh:
      all(*instances.mesh);
      break;
    case rtg::Shape::Superquadric:
    case rtg::Shape::NestedSuperquadric:
      if (!assembly.AddSuperquadrics())
      {
        messages.push_back("Superquadrics of more than " + std::to_string(MostMeshes) +
          " different shapes are left out of the exported file, which has a mesh for each. Show fewer of them with "
          "GlyphMode, or round their exponents or tensors.");
      }
      break;
    case rtg::Shape::RoundCone:
      assembly.AddTubes();
      break;
    case rtg::Shape::SweptEllipsoid:
      if (!assembly.AddSweeps())
      {
        messages.push_back(std::to_string(instances.Count()) +
          " pieces of tubes of covariances are left out of the "
          "exported file, which has a mesh for each of at most " +
          std::to_string(MostMeshes) + ". Show fewer lines, for example with Threshold, or another TubeRadiusArray.");
      }
      break;
    default:
      messages.push_back(
        "Glyphs of the shapes Spherical Harmonics, Normal Stress and Fourth-Order Tensor are left out of the exported "
        "file, because they have no triangles. Choose another GlyphShape, or save a screenshot.");
  }
  std::erase_if(set.Parts, [](const rtglyphs::GlyphTessellatedPart& part) { return part.Glyphs.empty(); });
  if (!set.Parts.empty() && bothSigns)
  {
    messages.push_back("GlyphTensorColoring Sign gives some of the glyphs two colors, which exported instances "
                       "cannot have: these have the first one. Choose another GlyphTensorColoring to export colors.");
  }
  return set;
}
