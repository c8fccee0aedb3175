#include "GlyphInstanceBuilder.h"

#include "Finite.h"
#include "GlyphArrays.h"
#include "GlyphMaker.h"
#include "GlyphMotion.h"
#include "GlyphOutcomes.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace
{
using Settings = rtglyphs::GlyphSettings;
using namespace rtglyphs::GlyphOutcomes;

// Stores the glyphs of points; threads may store several at the same time. Values that all glyphs share are stored
// once.
class Assembly
{
public:
  Assembly(const rtglyphs::GlyphMaker& maker, const rtglyphs::GlyphMotion& motion, const Settings& settings,
    rtglyphs::GlyphInstanceBuilder::Result& result)
    : Maker(maker)
    , Motion(motion)
    , How(settings)
    , Parts(maker.Parts())
    , Rotation(glm::mat3_cast(maker.GetPlacement().Rotation))
    , Out(result)
    , Instances(result.Instances)
  {
  }

  // Adds glyphs of the candidates, in their order; returns how many points had which outcome.
  Counts AddAll(std::vector<vtkIdType> candidates, const rtglyphs::RayTracedParallel::Progress& progress)
  {
    this->Instances.origin = this->Maker.MiddleOf(candidates);
    this->Instances.uniformExponents = this->Maker.GetSameExponents();
    if (this->Parts > 1)
    {
      std::vector<vtkIdType> each(this->Parts * candidates.size());
      for (std::size_t i = 0; i < each.size(); ++i)
      {
        each[i] = candidates[i / this->Parts];
      }
      candidates = std::move(each);
    }
    const auto count = static_cast<vtkIdType>(candidates.size());
    this->Allocate(candidates.size());
    std::vector<Outcome> outcomes(candidates.size());
    rtglyphs::RayTracedParallel::ForChunks(
      count,
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphMaker::Tuples tuples(this->Maker);
        for (vtkIdType k = begin; k < end; ++k)
        {
          outcomes[k] = this->Add(k, candidates[k], tuples);
        }
      },
      progress);
    // A point's first glyph counts its errors.
    Counts numbers{};
    for (vtkIdType k = 0; k < count; k += this->Parts)
    {
      ++numbers[outcomes[k]];
    }
    this->Out.Points = std::move(candidates);
    if (!this->NeedsLowParts)
    {
      this->Instances.centersLow = std::vector<glm::vec3>(); // = {} would keep the memory
    }
    if (this->Parts > 1 || numbers[SHOWN] < count)
    {
      this->Keep(rtglyphs::RayTracedParallel::Select(count, [&](vtkIdType k) { return outcomes[k] == SHOWN; }));
    }
    this->Finish();
    return numbers;
  }

private:
  void Allocate(std::size_t count)
  {
    const auto allocate = [count](auto& values, bool wanted) { values.resize(wanted ? count : 0); };
    allocate(this->Instances.centers, true);
    allocate(this->Instances.centersLow, true);
    allocate(this->Instances.forms, this->How.Tensors.ColorsBySign());
    allocate(this->Instances.exponents3,
      (this->Maker.GetSizes().GetTensors() && HasExponents(this->How.Shape)) ||
        this->Maker.Has(rtglyphs::GlyphArrays::EXPONENTS));
    if (const rtglyphs::GlyphForms* forms = this->Maker.GetSizes().GetForms())
    {
      this->Instances.polynomialDegree = forms->Degree();
      this->Instances.polynomials.width = forms->Width();
      this->Instances.polynomials.values.resize(count * forms->Width());
      this->Out.Radii.resize(count);
    }
    allocate(this->Instances.opacities, this->Maker.Has(rtglyphs::GlyphArrays::OPACITY));
    allocate(this->Instances.sizes3, !this->Maker.HasOneSize());
    allocate(this->Instances.sizes1, this->Maker.HasOneSize() && !this->Maker.HasSameSizes());
    allocate(this->Instances.rotations, this->Maker.IsTurned());
    this->Motion.Allocate(this->Instances.motion, count);
  }

  // The point's outcome; if it is SHOWN, instance `number` is its glyph.
  Outcome Add(vtkIdType number, vtkIdType point, rtglyphs::GlyphMaker::Tuples& tuples)
  {
    rtglyphs::GlyphMaker::Glyph glyph;
    const Outcome outcome = this->Maker.Make(point, static_cast<int>(number % this->Parts), this->Instances.origin,
      tuples, glyph, this->Maker.GetSizes().GetForms() ? this->Instances.polynomials[number] : nullptr);
    if (outcome != SHOWN)
    {
      return outcome;
    }
    if (!this->Motion.IsFinite(point))
    {
      return this->How.IsAroundVectors() ? NOT_SHOWN : MOTION; // the vectors' messages name it
    }
    const glm::vec3 center(glyph.Center), low(glyph.Center - glm::dvec3(center));
    if (std::max({ std::abs(low.x), std::abs(low.y), std::abs(low.z) }) > 1e-6 * glyph.SmallestExtent())
    {
      this->NeedsLowParts = true;
    }
    this->Instances.centers[number] = center;
    this->Instances.centersLow[number] = low;
    this->Motion.Store(this->Instances.motion, number, point, this->Maker.GetPlacement().Linear, this->Rotation);
    if (!this->Instances.opacities.empty())
    {
      this->Instances.opacities[number] = rtglyphs::GlyphArrays::Opacity(tuples[rtglyphs::GlyphArrays::OPACITY], point);
    }
    this->Store(number, glyph);
    return SHOWN;
  }

  void Store(vtkIdType number, const rtglyphs::GlyphMaker::Glyph& glyph)
  {
    if (this->Maker.HasSameSizes() && this->SameSize == 0.0f)
    {
      this->SameSize = glyph.Size.x;
    }
    const auto store = [number](auto& values, const auto& value)
    {
      if (!values.empty())
      {
        values[number] = value;
      }
    };
    store(this->Instances.sizes3, glyph.Size);
    store(this->Instances.sizes1, glyph.Size.x);
    store(this->Instances.rotations, glyph.Turn);
    store(this->Instances.exponents3,
      this->Maker.GetSizes().GetTensors() ? glm::vec3(glyph.Tensor.exponents) : glyph.Exponents);
    store(this->Out.Radii, glyph.Radius);
    if (!this->Instances.forms.empty())
    {
      const glm::dvec3 magnitudes(glm::abs(glyph.Tensor.values));
      this->Instances.forms[number] =
        glm::vec3(glyph.Tensor.values / std::max({ magnitudes.x, magnitudes.y, magnitudes.z }));
    }
  }

  template <typename Value>
  static void KeepOnly(std::vector<Value>& values, const std::vector<vtkIdType>& glyphs)
  {
    if (!values.empty())
    {
      std::transform(
        glyphs.begin(), glyphs.end(), values.begin(), [&values](vtkIdType glyph) { return values[glyph]; });
      values.resize(glyphs.size());
    }
  }
  static void KeepOnly(rtg::GlyphTuples& tuples, const std::vector<vtkIdType>& glyphs)
  {
    for (std::size_t i = 0; i < glyphs.size() && !tuples.empty(); ++i)
    {
      std::copy_n(tuples[glyphs[i]], tuples.width, tuples[i]);
    }
    tuples.values.resize(tuples.empty() ? 0 : glyphs.size() * tuples.width);
  }

  // Only these glyphs, by rising number.
  void Keep(const std::vector<vtkIdType>& glyphs)
  {
    const auto keep = [&glyphs](auto& values) { KeepOnly(values, glyphs); };
    keep(this->Out.Points);
    keep(this->Out.Radii);
    rtg::GlyphColors colors; // are not made here
    rtg::ForEachArray(
      this->Instances, colors, [&keep](std::size_t, std::uint32_t, auto& values, const char*) { keep(values); });
  }

  void Finish()
  {
    if (this->SameSize != 0.0f)
    {
      this->Instances.uniformSize = this->SameSize;
    }
    this->Motion.Finish(this->Instances.motion);
    if (this->Maker.IsRound())
    {
      this->Instances.motion.angularVelocities = std::vector<glm::vec3>(); // rotations are invisible
    }
  }

  const rtglyphs::GlyphMaker& Maker;
  const rtglyphs::GlyphMotion& Motion;
  const Settings& How;
  const int Parts;           // glyphs of each point
  const glm::dmat3 Rotation; // of the placement
  rtglyphs::GlyphInstanceBuilder::Result& Out;
  rtg::GlyphInstances& Instances;
  std::atomic<float> SameSize{ 0.0f };      // of all glyphs; 0: there is none, or they differ
  std::atomic<bool> NeedsLowParts{ false }; // of the centers, which for some glyph exceed 1e-6 of its size
};
}

//----------------------------------------------------------------------------
rtglyphs::GlyphInstanceBuilder::Result rtglyphs::GlyphInstanceBuilder::Build(vtkPolyData* points,
  const Settings& settings, const rtglyphs::RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld,
  const rtglyphs::RayTracedParallel::Progress& progress)
{
  Result result;
  rtg::GlyphInstances& instances = result.Instances;
  instances.shape = settings.Shape;
  instances.arrow = settings.Arrow;
  // Quadratic forms give the sign of tensors.
  const auto surface = settings.SurfaceColors();
  using SurfaceColors = rtg::GlyphInstances::SurfaceColors;
  instances.surfaceColors = surface == SurfaceColors::Sign && !settings.Forms.On ? SurfaceColors::None : surface;
  const bool isMesh = settings.Shape == rtg::Shape::Mesh;
  if (isMesh && (!settings.Mesh || settings.Mesh->triangles.empty()))
  {
    const std::string number = std::to_string(settings.TableEntry);
    result.Messages.push_back((settings.HasTable() ? "Entry " + number +
                                    " of GlyphType has no polygons, so points that choose it have no glyph."
                                                   : "GlyphType has no polygons, so there are no glyphs.") +
      " Choose a source that has some, such as Arrow, Cone or Sphere.");
    return result;
  }
  instances.mesh = isMesh ? settings.Mesh : nullptr;
  std::vector<vtkIdType> candidates = rtglyphs::GlyphArrays::Candidates(points, settings, hidden);
  if (candidates.empty())
  {
    return result;
  }
  rtglyphs::GlyphArrays::ReportMissing(points, settings, hidden, result.Messages);
  const rtglyphs::GlyphSizes sizes(points, settings, candidates);
  if (const std::string& problem = sizes.GetProblem(); !problem.empty())
  {
    const std::string& array = settings.Forms.On ? settings.Forms.Array
      : settings.Tensors.On                      ? settings.Tensors.Array
                                                 : settings.OrientationArray;
    if (rtglyphs::RayTracedArrays::IsNone(array))
    {
      result.MissingInput = problem;
    }
    else if (!rtglyphs::RayTracedBlocks::IsOnOtherRanks(points, array))
    {
      result.Messages.push_back(problem);
    }
    result.Skipped = static_cast<vtkIdType>(candidates.size());
    return result;
  }
  const rtglyphs::GlyphMaker maker(points, settings, modelToWorld, sizes, result.Messages);
  const rtglyphs::GlyphMotion motion(points, settings.Motion);
  result.MissingInput = rtglyphs::GlyphMotion::MissingInput(settings.Motion);
  const bool pointed = settings.Shape == rtg::Shape::Arrow || settings.Shape == rtg::Shape::Cone;
  if (pointed && settings.Orient && !settings.Tensors.On &&
    rtglyphs::RayTracedArrays::IsNone(settings.OrientationArray))
  {
    result.MissingInput =
      "Arrows and cones need directions; without them all point along x. Choose a point array of 2 or 3 "
      "components as SelectOrientationVectors, or switch Orient off.";
  }
  const std::vector<std::string>& aboutMotion = motion.Messages();
  result.Messages.insert(result.Messages.end(), aboutMotion.begin(), aboutMotion.end());
  const std::size_t candidatesCount = candidates.size();
  Assembly assembly(maker, motion, settings, result);
  const Counts outcomes = assembly.AddAll(std::move(candidates), progress);

  // Fixed heads have the world size that they have on the arrow of reference
  const rtglyphs::GlyphPlacement& placement = maker.GetPlacement();
  if (settings.Shape == rtg::Shape::Arrow)
  {
    const auto unit = static_cast<float>(sizes.ArrowUnit() * std::abs(placement.Scale));
    instances.arrow.unitLength = sizes.HasRadii() ? 0.0f : rtg::IsPositive(unit) ? unit : 1.0f;
  }
  if (!placement.Uniform && settings.Shape != rtg::Shape::Sphere)
  {
    result.Messages.emplace_back("Scale of the representation differs between its axes, which glyphs of this shape "
                                 "can follow only approximately. Transform the data instead, or use one scale.");
  }
  if (settings.HasTable() && settings.TableEntry > 0)
  {
    result.Messages.clear(); // the first entry has reported what is not about single points
  }
  result.Skipped += Describe(outcomes, settings, candidatesCount, result.Messages);
  return result;
}
