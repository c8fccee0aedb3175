#include "vtkGlyphInstanceBuilder.h"

#include "GlyphArrays.h"
#include "vtkDataArray.h"
#include "vtkGlyphHighScale.h"
#include "vtkGlyphPlacement.h"
#include "vtkGlyphTuples.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRayTracedArrays.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <sstream>

namespace
{
using Settings = vtkGlyphSettings;

bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

// What became of a point: why it has no glyph, or that nothing is wrong. Zeros are ordinary: grains without stress,
// walls without slip.
enum Outcome : unsigned char
{
  POSITION,
  SCALE,
  RADIUS,
  ORIENTATION,
  TENSOR,
  EXPONENT,
  MOTION,
  FORM,
  POLYNOMIAL,
  ZERO_SCALE,
  ZERO_RADIUS,
  ZERO_ORIENTATION,
  ZERO_TENSOR,
  ZERO_POLYNOMIAL,
  REASONS,
  NOT_SHOWN = REASONS, // none of this set's, or nothing to show
  SHOWN
};

void Describe(vtkGlyphInstanceBuilder::Result& result, const Settings& settings,
  const std::array<vtkIdType, SHOWN + 1>& skipped, std::size_t candidates)
{
  const auto say = [&](vtkIdType count, const std::string& why, const std::string& remedy)
  {
    if (count > 0)
    {
      std::ostringstream text;
      text << count << " of " << candidates << " points have no glyph: " << why << ". " << remedy;
      result.Messages.push_back(text.str());
      result.Skipped += count;
    }
  };
  // Of zeros only where nothing else is left.
  const auto sayOfZeros = [&](vtkIdType count, const std::string& why, const std::string& remedy)
  {
    if (skipped[SHOWN] == 0)
    {
      say(count, why, remedy);
    }
    else
    {
      result.Skipped += count;
    }
  };
  say(skipped[POSITION], "their position is not finite", "Remove these points, for example with Threshold or Clean.");
  if (!settings.Scaling)
  {
    say(skipped[SCALE] + skipped[ZERO_SCALE], "GlyphScaleFactor, or Scale of the representation, is zero or not finite",
      "Set it to a positive number.");
  }
  else
  {
    const std::string scale = "their scale, from the point array '" + settings.ScaleArray + "', is ";
    const std::string remedy =
      "Choose another GlyphScaleArray, switch GlyphScaling off, or remove these points with Threshold.";
    say(skipped[SCALE], scale + "not finite", remedy);
    sayOfZeros(skipped[ZERO_SCALE], scale + "zero", remedy);
  }
  const std::string radius = "their radius, from the point array '" + settings.RadiusArray + "', is ";
  const std::string width = "Choose another GlyphRadiusArray, or None, or remove these points with Threshold.";
  say(skipped[RADIUS], radius + "not finite", width);
  sayOfZeros(skipped[ZERO_RADIUS], radius + "zero", width);
  const std::string orientation = "their orientation, from the point array '" + settings.OrientationArray + "', is ";
  const std::string turn =
    "Choose another GlyphOrientationArray, switch GlyphOrient off, or remove these points with Threshold.";
  say(skipped[ORIENTATION], orientation + "not finite", turn);
  sayOfZeros(skipped[ZERO_ORIENTATION], orientation + "zero", turn);
  const std::string tensor = "their tensor, from the point array '" + settings.Tensors.Array + "', is ";
  say(skipped[TENSOR], tensor + "not finite", "To silence this warning remove the points with Threshold.");
  sayOfZeros(skipped[ZERO_TENSOR], tensor + "zero", "Choose another GlyphTensorArray, or another time step.");
  const std::string components = "the components of their tuple in the point array '" + settings.Forms.Array + "' are ";
  say(skipped[POLYNOMIAL], components + "not all finite, or too large or small for floats",
    "To silence this warning remove the points with Threshold.");
  sayOfZeros(skipped[ZERO_POLYNOMIAL], components + "all zero", "Choose another array, or another time step.");
  say(skipped[MOTION],
    "their velocity, acceleration or angular velocity, or the way they go while the shutter is "
    "open, is not finite",
    "Choose other arrays, switch MotionBlur off, or remove these points with Threshold.");
  say(skipped[FORM], "the number of their form, from the point array '" + settings.TableIndexArray + "', is not finite",
    "Choose another GlyphMeshIndexArray, or remove these points with Threshold.");
  if (vtkRayTracedArrays::IsNone(settings.ExponentArray))
  {
    std::ostringstream why;
    why << "GlyphExponents are " << settings.Exponents[0] << ", " << settings.Exponents[1] << ", "
        << settings.Exponents[2];
    say(skipped[EXPONENT], why.str(), "Make each of them positive; 2 2 2 is an ellipsoid.");
  }
  else
  {
    say(skipped[EXPONENT],
      "their exponents, from the point array '" + settings.ExponentArray + "', are zero, negative or not finite",
      "Choose another GlyphExponentArray, or None, or remove these points with Threshold.");
  }
}

// A tuple's exponents as the kernels want them; false: there are none.
bool MakeExponents(const Settings& settings, const double* tuple, int components, glm::vec3& exponents)
{
  glm::dvec3 e(tuple[0]);
  if (components == 2)
  {
    e = glm::dvec3(tuple[0], tuple[0], tuple[1]);
  }
  else if (components == 3)
  {
    e = glm::dvec3(tuple[0], tuple[1], tuple[2]);
  }
  const bool nested = settings.Shape == rtg::Shape::NestedSuperquadric;
  if (nested)
  {
    // Along z, across; the third is not used.
    e = components > 1 ? glm::dvec3(tuple[0], tuple[1], tuple[1]) : glm::dvec3(tuple[0]);
  }
  if (!IsPositive(e.x) || !IsPositive(e.y) || !IsPositive(e.z))
  {
    return false;
  }
  e = glm::clamp(e, glm::dvec3(0.1), glm::dvec3(100.0));
  exponents = nested ? glm::vec3(2.0 / e.y, 2.0 / e.x, 2.0 / e.x) : glm::vec3(e);
  return true;
}

const glm::vec4 NoTurn(0.0f, 0.0f, 0.0f, 1.0f);

bool IsFinite(const double* x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

// Makes the glyphs of a result, of several points at the same time.
class Assembly
{
public:
  // Takes the arrays that are there and fit. `tensors` and `forms` may be null; all stay the caller's.
  Assembly(vtkPolyData* points, const Settings& settings, vtkMatrix4x4* modelToWorld, const vtkGlyphTensors* tensors,
    const vtkGlyphForms* forms, vtkGlyphInstanceBuilder::Result& result)
    : How(settings)
    , Tensors(tensors)
    , Forms(forms)
    , FormArray(vtkGlyphForms::Array(points, settings.Forms))
    , Placement(modelToWorld)
    , Motion(points, settings.Motion)
    , Out(result)
    , Instances(result.Instances)
    , ChoosesForm(settings.HasTable())
    , OwnExponents(settings.HasOwnExponents())
    , Sphere(settings.Shape == rtg::Shape::Sphere)
    , Pointed(settings.Shape == rtg::Shape::Cone || settings.Shape == rtg::Shape::Arrow)
    , AnchorShift(settings.AnchorShift())
    , Parts(settings.Tensors.Parts())
    , Positions(points->GetPoints()->GetData())
    , Rotation(glm::mat3_cast(this->Placement.Rotation))
  {
    for (int id = 0; id < vtkGlyphArrays::NUMBER_OF_IDS; ++id)
    {
      this->Arrays[id] = vtkGlyphArrays::Find(static_cast<vtkGlyphArrays::Id>(id), points, settings, &result.Messages);
    }
    this->ByComponents = vtkGlyphArrays::ScalesByComponents(this->Arrays[vtkGlyphArrays::SCALE], settings);
    this->OrientationMode = vtkGlyphArrays::OrientationMode(this->Arrays[vtkGlyphArrays::ORIENTATION], settings);
    this->GoodExponents =
      this->OwnExponents && MakeExponents(settings, settings.Exponents, 3, this->Instances.uniformExponents);

    // What an instance stores: nothing that is the same for all, and no turn of what looks the same from all sides
    const bool sizedByData = this->Has(vtkGlyphArrays::SCALE) || this->Has(vtkGlyphArrays::RADIUS) || tensors || forms;
    this->SameSizes = !sizedByData && this->Placement.Uniform;
    this->OneSize = (this->Parts > 1 ||
                      (!(this->Has(vtkGlyphArrays::SCALE) && this->ByComponents) &&
                        !this->Has(vtkGlyphArrays::RADIUS) && !tensors)) &&
      this->Placement.Uniform;
    this->Turned = (this->Has(vtkGlyphArrays::ORIENTATION) || tensors || !this->Placement.Identity) &&
      !(this->Sphere && this->OneSize && this->AnchorShift == 0.0);
    this->Flips = this->Pointed &&
      ((this->Has(vtkGlyphArrays::SCALE) && this->ByComponents) || settings.ScaleFactor < 0.0 ||
        this->Placement.Scale < 0.0);
  }

  bool IsScaled() const { return this->Has(vtkGlyphArrays::SCALE); }
  bool HasRadii() const { return this->Has(vtkGlyphArrays::RADIUS); }
  const vtkGlyphPlacement& GetPlacement() const { return this->Placement; }
  const vtkGlyphMotion& GetMotion() const { return this->Motion; }

  // Glyphs of the candidates, in their order; how many points had which outcome.
  std::array<vtkIdType, SHOWN + 1>
  AddAll(std::vector<vtkIdType> candidates, const vtkRayTracedParallel::Progress& progress)
  {
    this->ChooseOrigin(candidates);
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
    vtkRayTracedParallel::ForChunks(
      count,
      [&](vtkIdType begin, vtkIdType end)
      {
        Tuples tuples(*this);
        for (vtkIdType k = begin; k < end; ++k)
        {
          outcomes[k] = this->Add(k, candidates[k], tuples);
        }
      },
      progress);
    // Of a point's glyphs the first tells what is wrong with it.
    std::array<vtkIdType, SHOWN + 1> numbers{};
    for (vtkIdType k = 0; k < count; k += this->Parts)
    {
      ++numbers[outcomes[k]];
    }
    this->Out.Points = std::move(candidates);
    if (this->Parts > 1 || numbers[SHOWN] < count)
    {
      this->Keep(vtkRayTracedParallel::Select(count, [&](vtkIdType k) { return outcomes[k] == SHOWN; }));
    }
    this->Finish();
    this->StoreLowParts();
    return numbers;
  }

private:
  bool Has(vtkGlyphArrays::Id id) const { return this->Arrays[id] != nullptr; }

  // What one thread reads.
  struct Tuples
  {
    explicit Tuples(const Assembly& all)
      : Positions(all.Positions)
      , Forms(all.FormArray)
      , Named(all.Arrays.begin(), all.Arrays.end())
    {
    }
    vtkGlyphTuples& operator[](vtkGlyphArrays::Id id) { return this->Named[id]; }
    vtkGlyphTuples Positions, Forms;

  private:
    std::vector<vtkGlyphTuples> Named; // by vtkGlyphArrays::Id
  };

  // Where most of the data are, whatever lies far away: the median of some points, axis by axis.
  void ChooseOrigin(const std::vector<vtkIdType>& candidates)
  {
    constexpr std::size_t enough = 1000;
    const std::size_t step = std::max<std::size_t>(1, candidates.size() / enough);
    vtkGlyphTuples positions(this->Positions);
    std::array<std::vector<double>, 3> coordinates;
    for (std::size_t k = 0; k < candidates.size(); k += step)
    {
      const double* x = positions.Get(candidates[k]);
      for (int axis = 0; axis < 3 && IsFinite(x); ++axis)
      {
        coordinates[axis].push_back(x[axis]);
      }
    }
    if (coordinates[0].empty())
    {
      return;
    }
    glm::dvec3 median;
    for (int axis = 0; axis < 3; ++axis)
    {
      auto& values = coordinates[axis];
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      median[axis] = *middle;
    }
    this->Instances.origin = this->Placement(median);
  }

  glm::dvec3 FromOrigin(const double* x) const
  {
    return this->Placement(glm::dvec3(x[0], x[1], x[2])) - this->Instances.origin;
  }

  // From a glyph's point to its center, computed from what the instance stores of size and rotation.
  static glm::dvec3 FromPoint(double shift, float length, const glm::vec4& rotation)
  {
    const glm::dquat turn(rotation.w, rotation.x, rotation.y, rotation.z);
    return glm::normalize(turn) * glm::dvec3(shift * length, 0.0, 0.0);
  }

  // What rounding has left of the centers, when for some glyph it is more than 1e-6 of its size.
  void StoreLowParts()
  {
    if (!this->NeedsLowParts)
    {
      return;
    }
    this->Instances.centresLow.resize(this->Out.Points.size());
    vtkRayTracedParallel::ForChunks(static_cast<vtkIdType>(this->Out.Points.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkGlyphTuples positions(this->Positions);
        const rtg::GlyphInstances& all = this->Instances;
        for (vtkIdType k = begin; k < end; ++k)
        {
          glm::dvec3 place = this->FromOrigin(positions.Get(this->Out.Points[k]));
          const double shift = this->Shifts.empty() ? this->AnchorShift : this->Shifts[k];
          if (shift != 0.0)
          {
            place += FromPoint(shift,
              !all.sizes3.empty()     ? all.sizes3[k].x
                : !all.sizes1.empty() ? all.sizes1[k]
                                      : all.uniformSize,
              all.rotations.empty() ? NoTurn : all.rotations[k]);
          }
          this->Instances.centresLow[k] = glm::vec3(place - glm::dvec3(all.centres[k]));
        }
      });
  }

  // What becomes of the point; when it is shown, the glyph of this number is its.
  Outcome Add(vtkIdType glyph, vtkIdType i, Tuples& tuples)
  {
    if (this->ChoosesForm)
    {
      const double number = this->Has(vtkGlyphArrays::TABLE_INDEX)
        ? vtkMath::Norm(tuples[vtkGlyphArrays::TABLE_INDEX].Get(i), tuples[vtkGlyphArrays::TABLE_INDEX].Size())
        : 0.0;
      const int last = this->How.TableSize - 1;
      const bool counts = !std::isnan(number);
      if ((counts ? static_cast<int>(std::min<double>(number, last)) : 0) != this->How.TableEntry)
      {
        return NOT_SHOWN;
      }
      if (!counts)
      {
        return FORM;
      }
    }
    const double* x = tuples.Positions.Get(i);
    glm::dvec3 place = this->FromOrigin(x);
    glm::vec3 center(place);
    if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z))
    {
      return POSITION;
    }

    glm::dvec3 size(this->How.ScaleFactor);
    if (this->Has(vtkGlyphArrays::SCALE))
    {
      const double* tuple = tuples[vtkGlyphArrays::SCALE].Get(i);
      size *= this->ByComponents
        ? this->How.Sizing(glm::dvec3(tuple[0], tuple[1], tuple[2]))
        : glm::dvec3(this->How.Sizing(vtkMath::Norm(tuple, tuples[vtkGlyphArrays::SCALE].Size())));
    }
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    rtg::TensorGlyph tensorGlyph;
    if (this->Tensors && this->How.Tensors.Axes)
    {
      double axis[3];
      if (!this->Tensors->Axis(i, axis))
      {
        return NOT_SHOWN; // nothing to show is no fault
      }
      size *= this->How.Sizing(std::hypot(axis[0], axis[1], axis[2]));
      vtkGlyphPlacement::RotationFromTuple(axis, Settings::DIRECTION, rotation);
    }
    else if (this->Tensors)
    {
      if (!this->Tensors->Glyph(i, tensorGlyph))
      {
        return this->Tensors->IsZero(i) ? ZERO_TENSOR : TENSOR;
      }
      size *= this->How.Sizing(tensorGlyph.halfLengths);
      rotation = tensorGlyph.rotation;
    }
    double shift = this->AnchorShift;
    if (this->Forms)
    {
      const rtg::FormExtent extent = this->Forms->Measure(tuples.Forms, i, this->Instances.polynomials[glyph]);
      if (!(extent.radius > 0.0))
      {
        return this->IsZero(i, tuples) ? ZERO_POLYNOMIAL : POLYNOMIAL;
      }
      this->Out.Radii[glyph] = static_cast<float>(extent.bound);
      // Of the unit glyph, which is a little less than the largest that is possible
      size *= this->How.Sizing(this->Forms->Magnitude(extent)) * (extent.bound / extent.radius);
    }
    if (this->Has(vtkGlyphArrays::ORIENTATION) && this->Turned && !this->Tensors)
    {
      vtkGlyphTuples& orientations = tuples[vtkGlyphArrays::ORIENTATION];
      const double* tuple = orientations.Get(i);
      if (!vtkGlyphPlacement::RotationFromTuple(tuple, this->OrientationMode, rotation))
      {
        if (vtkMath::Norm(tuple, orientations.Size()) != 0.0)
        {
          return ORIENTATION;
        }
        if (this->Pointed || this->OrientationMode != Settings::DIRECTION)
        {
          return ZERO_ORIENTATION;
        }
        rotation = glm::dquat(1.0, 0.0, 0.0, 0.0); // a box at rest is a box
      }
    }

    glm::vec3 exponents(2.0f);
    if (this->OwnExponents &&
      !(this->Has(vtkGlyphArrays::EXPONENTS) ? MakeExponents(this->How, tuples[vtkGlyphArrays::EXPONENTS].Get(i),
                                                 tuples[vtkGlyphArrays::EXPONENTS].Size(), exponents)
                                             : this->GoodExponents))
    {
      return EXPONENT;
    }

    size = this->How.Sizing.Limited(size);
    if (this->Has(vtkGlyphArrays::RADIUS))
    {
      const double width = this->How.Width(*tuples[vtkGlyphArrays::RADIUS].Get(i));
      if (!IsPositive(width))
      {
        return width == 0.0 ? ZERO_RADIUS : RADIUS;
      }
      size.y = size.z = width;
    }
    if (this->Parts > 1)
    {
      const Outcome outcome = this->TakePart(static_cast<int>(glyph % this->Parts), tensorGlyph, size, rotation, shift);
      if (outcome != SHOWN)
      {
        return outcome;
      }
    }
    this->Placement.Apply(this->Sphere, size, rotation);
    if (this->Flips && size.x < 0.0)
    {
      rotation = rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
    }
    const glm::vec3 extent(glm::abs(size));
    const glm::vec3 stored = this->How.Shape == rtg::Shape::Mesh ? glm::vec3(size) : extent;
    const glm::vec4 turn =
      this->Turned || this->Flips ? glm::vec4(rotation.x, rotation.y, rotation.z, rotation.w) : NoTurn;
    const float smallest = std::min({ extent.x, extent.y, extent.z });
    const float largest = std::max({ extent.x, extent.y, extent.z });
    if (!(smallest > 0.0f) || !std::isfinite(largest) || !std::isfinite(extent.y))
    {
      return std::isfinite(extent.x + extent.y + extent.z) ? ZERO_SCALE : SCALE;
    }
    if (!this->Motion.IsFinite(i))
    {
      return MOTION;
    }
    if (shift != 0.0)
    {
      place += FromPoint(shift, stored.x, turn);
      center = place;
    }
    if (!this->Shifts.empty())
    {
      this->Shifts[glyph] = static_cast<float>(shift);
    }

    this->Motion.Store(this->Instances.motion, glyph, i, this->Placement.Linear, this->Rotation);
    this->Instances.centres[glyph] = center;
    if (!this->Instances.opacities.empty())
    {
      const double opacity = *tuples[vtkGlyphArrays::OPACITY].Get(i);
      this->Instances.opacities[glyph] = std::isnan(opacity) ? 1.0f : static_cast<float>(std::clamp(opacity, 0.0, 1.0));
    }
    const glm::dvec3 left = glm::abs(place - glm::dvec3(center));
    if (std::max({ left.x, left.y, left.z }) > 1e-6 * smallest)
    {
      this->NeedsLowParts = true;
    }
    this->Store(glyph, stored, turn, tensorGlyph, exponents);
    return SHOWN;
  }

  // One of the arrows of a tensor: along the eigenvector of the largest magnitude first, to both sides of the center.
  // From it where the eigenvalue is positive, else to it.
  static Outcome TakePart(int part, rtg::TensorGlyph& tensor, glm::dvec3& size, glm::dquat& rotation, double& shift)
  {
    const glm::dvec3 magnitudes(glm::abs(tensor.values));
    const int first = magnitudes.x >= std::max(magnitudes.y, magnitudes.z) ? 0 : magnitudes.y >= magnitudes.z ? 1 : 2;
    const int axis = (first + part / 2) % 3;
    const double value = tensor.values[axis], length = 0.5 * std::abs(size[axis]);
    // Of half-lengths none is less than a thousandth of the longest; an eigenvalue may be.
    size = glm::dvec3(length * std::min(1.0, magnitudes[axis] / tensor.halfLengths[axis]));
    if (axis != first && !(static_cast<float>(size.x) > 0.0f))
    {
      return NOT_SHOWN; // nothing to show is no fault
    }
    const double half = std::sqrt(0.5);
    const glm::dquat toAxis[] = { { 1.0, 0.0, 0.0, 0.0 }, { half, 0.0, 0.0, half }, { half, 0.0, -half, 0.0 } };
    rotation = rotation * toAxis[axis];
    const bool inward = value < 0.0;
    if ((part % 2 == 1) != inward)
    {
      rotation = rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
    }
    shift = inward ? -1.0 : 0.0; // its tip at the center
    tensor.values = glm::dvec3(value);
    return SHOWN;
  }

  static bool IsZero(vtkIdType i, Tuples& tuples)
  {
    const double* tuple = tuples.Forms.Get(i);
    return std::all_of(tuple, tuple + tuples.Forms.Size(), [](double component) { return component == 0.0; });
  }

  void Allocate(std::size_t count)
  {
    const auto allocate = [count](auto& values, bool wanted) { values.resize(wanted ? count : 0); };
    allocate(this->Instances.centres, true);
    allocate(this->Instances.forms, this->How.Tensors.ColorsBySign());
    allocate(this->Instances.exponents3,
      (this->Tensors && HasExponents(this->How.Shape)) || this->Has(vtkGlyphArrays::EXPONENTS));
    if (this->Forms)
    {
      this->Instances.polynomialDegree = this->Forms->Degree();
      this->Instances.polynomials.width = this->Forms->Width();
      this->Instances.polynomials.values.resize(count * this->Forms->Width());
      this->Out.Radii.resize(count);
    }
    allocate(this->Shifts, this->Parts > 1);
    allocate(this->Instances.opacities, this->Has(vtkGlyphArrays::OPACITY));
    allocate(this->Instances.sizes3, !this->OneSize);
    allocate(this->Instances.sizes1, this->OneSize && !this->SameSizes);
    allocate(this->Instances.rotations, this->Turned || this->Flips);
    this->Motion.Allocate(this->Instances.motion, count);
    this->FirstSizes.assign(vtkRayTracedParallel::NumberOfChunks(static_cast<vtkIdType>(count)), 0.0f);
  }

  void Store(vtkIdType glyph, const glm::vec3& size, const glm::vec4& turn, const rtg::TensorGlyph& tensor,
    const glm::vec3& exponents)
  {
    float& first = this->FirstSizes[vtkRayTracedParallel::ChunkOf(glyph)];
    if (first == 0.0f) // written once: those of other threads lie beside it
    {
      first = size.x;
    }
    if (!this->Instances.forms.empty())
    {
      const glm::dvec3 magnitudes(glm::abs(tensor.values));
      this->Instances.forms[glyph] = glm::vec3(tensor.values / std::max({ magnitudes.x, magnitudes.y, magnitudes.z }));
    }
    if (!this->Instances.exponents3.empty())
    {
      this->Instances.exponents3[glyph] = this->Tensors ? glm::vec3(tensor.exponents) : exponents;
    }
    if (!this->Instances.sizes3.empty())
    {
      this->Instances.sizes3[glyph] = size;
    }
    else if (!this->Instances.sizes1.empty())
    {
      this->Instances.sizes1[glyph] = size.x;
    }
    if (!this->Instances.rotations.empty())
    {
      this->Instances.rotations[glyph] = turn;
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
    keep(this->Shifts);
    rtg::GlyphColours colours; // are not made here
    rtg::ForEachArray(
      this->Instances, colours, [&keep](std::size_t, std::uint32_t, auto& values, const char*) { keep(values); });
  }

  void Finish()
  {
    const auto first =
      std::find_if(this->FirstSizes.begin(), this->FirstSizes.end(), [](float size) { return size != 0.0f; });
    if (first != this->FirstSizes.end())
    {
      this->Instances.uniformSize = *first;
    }
    this->Motion.Finish(this->Instances.motion);
    if (this->Sphere && this->OneSize)
    {
      this->Instances.motion.angularVelocities.clear(); // it looks the same from all sides
    }
  }

  const Settings& How;
  const vtkGlyphTensors* Tensors;
  const vtkGlyphForms* Forms;
  vtkDataArray* const FormArray; // null: none
  const vtkGlyphPlacement Placement;
  const vtkGlyphMotion Motion;
  vtkGlyphInstanceBuilder::Result& Out;
  rtg::GlyphInstances& Instances;
  bool ByComponents = false;
  int OrientationMode = Settings::DIRECTION; // of the array that was found
  const bool ChoosesForm, OwnExponents, Sphere, Pointed;
  const double AnchorShift; // of the unit glyph
  const int Parts;          // glyphs of each point
  vtkDataArray* const Positions;
  std::array<vtkDataArray*, vtkGlyphArrays::NUMBER_OF_IDS> Arrays{}; // null: none, or it does not fit
  const glm::dmat3 Rotation;                                         // of the placement
  std::vector<float> FirstSizes; // of each chunk's first glyph, which is never 0; 0: it has none
  std::vector<float> Shifts;     // of each unit glyph, where these differ
  bool GoodExponents = false;    // of the settings
  std::atomic<bool> NeedsLowParts{ false };
  bool SameSizes = false, OneSize = false; // for all glyphs; for all axes of one
  bool Turned = false, Flips = false;
};
}

//----------------------------------------------------------------------------
vtkGlyphInstanceBuilder::Result vtkGlyphInstanceBuilder::Build(vtkPolyData* points, const Settings& settings,
  const vtkGlyphBlockAttributes::Table& blocks, vtkMatrix4x4* modelToWorld,
  const vtkRayTracedParallel::Progress& progress)
{
  Result result;
  rtg::GlyphInstances& instances = result.Instances;
  instances.shape = settings.Shape;
  instances.arrow = settings.Arrow;
  // Of tensors, quadratic forms tell the sign.
  const auto surface = settings.SurfaceColors();
  using SurfaceColours = rtg::GlyphInstances::SurfaceColours;
  instances.surfaceColours = surface == SurfaceColours::Sign && !settings.Forms.On ? SurfaceColours::None : surface;
  const bool isMesh = settings.Shape == rtg::Shape::Mesh;
  if (isMesh && (!settings.Mesh || settings.Mesh->triangles.empty()))
  {
    const std::string number = std::to_string(settings.TableEntry);
    result.Messages.push_back((settings.HasTable() ? "Entry " + number +
                                    " of GlyphMesh has no polygons, so points that choose it have no glyph."
                                                   : "GlyphMesh has no polygons, so there are no glyphs.") +
      " Choose a source that has some, such as Arrow, Cone or Sphere.");
    return result;
  }
  instances.mesh = isMesh ? settings.Mesh : nullptr;
  std::vector<vtkIdType> candidates = vtkGlyphArrays::Candidates(points, settings, blocks);
  if (candidates.empty())
  {
    return result;
  }
  std::unique_ptr<vtkGlyphTensors> tensors;
  std::string problem;
  if (settings.Tensors.On)
  {
    vtkDataArray* array = vtkGlyphTensors::Array(points, settings.Tensors);
    problem = vtkGlyphTensors::Problem(array, settings.Tensors);
    if (problem.empty())
    {
      tensors = std::make_unique<vtkGlyphTensors>(array, settings.Tensors, candidates);
    }
  }

  std::unique_ptr<vtkGlyphForms> forms;
  if (settings.Forms.On)
  {
    vtkDataArray* array = vtkGlyphForms::Array(points, settings.Forms);
    problem = vtkGlyphForms::Problem(array, settings.Forms);
    if (problem.empty())
    {
      forms = std::make_unique<vtkGlyphForms>(array, settings.Forms);
    }
  }

  Assembly assembly(points, settings, modelToWorld, tensors.get(), forms.get(), result);
  if (!problem.empty())
  {
    const std::string& array = settings.Forms.On ? settings.Forms.Array : settings.Tensors.Array;
    if (vtkRayTracedArrays::IsNone(array))
    {
      result.Unfinished = problem;
    }
    else
    {
      result.Messages.push_back(problem);
    }
    result.Skipped = static_cast<vtkIdType>(candidates.size());
    return result;
  }
  const std::vector<std::string>& aboutMotion = assembly.GetMotion().Messages();
  result.Messages.insert(result.Messages.end(), aboutMotion.begin(), aboutMotion.end());
  const std::size_t candidatesCount = candidates.size();
  const auto outcomes = assembly.AddAll(std::move(candidates), progress);

  // Fixed heads have the world size that they have on the arrow of reference
  const vtkGlyphPlacement& placement = assembly.GetPlacement();
  if (settings.Shape == rtg::Shape::Arrow)
  {
    const double reference = assembly.IsScaled() ? vtkGlyphHighScale::Reference(points, settings, blocks) : 1.0;
    const auto unit = static_cast<float>(std::abs(settings.ScaleFactor * placement.Scale) * reference);
    instances.arrow.unitLength = assembly.HasRadii() ? 0.0f : IsPositive(unit) ? unit : 1.0f;
  }
  if (!placement.Uniform && settings.Shape != rtg::Shape::Sphere)
  {
    result.Messages.push_back("Scale of the representation differs between its axes, which glyphs of this shape "
                              "can follow only approximately. Transform the data instead, or use one scale.");
  }
  if (settings.HasTable() && settings.TableEntry > 0)
  {
    result.Messages.clear(); // what is not about single points the first entry has said
  }
  Describe(result, settings, outcomes, candidatesCount);
  return result;
}
