#include "vtkGlyphInstanceBuilder.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkGlyphPlacement.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

namespace
{
using Settings = vtkGlyphInstanceBuilder::Settings;

bool IsNone(const std::string& name)
{
  return name.empty() || name == "None";
}

bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

// Tuples of a float or double array without a virtual call each; any other array through its interface.
class Tuples
{
public:
  explicit Tuples(vtkDataArray* array)
    : Array(array)
    , Float(vtkAOSDataArrayTemplate<float>::FastDownCast(array))
    , Double(vtkAOSDataArrayTemplate<double>::FastDownCast(array))
    , Components(array ? array->GetNumberOfComponents() : 0)
  {
  }
  explicit operator bool() const { return this->Array != nullptr; }
  int Size() const { return this->Components; }

  const double* Get(vtkIdType i)
  {
    if (this->Double)
    {
      return this->Double->GetPointer(i * this->Components);
    }
    this->Buffer.resize(this->Components);
    if (this->Float)
    {
      const float* tuple = this->Float->GetPointer(i * this->Components);
      std::copy(tuple, tuple + this->Components, this->Buffer.begin());
    }
    else
    {
      this->Array->GetTuple(i, this->Buffer.data());
    }
    return this->Buffer.data();
  }

private:
  vtkDataArray* Array;
  vtkAOSDataArrayTemplate<float>* Float;
  vtkAOSDataArrayTemplate<double>* Double;
  int Components;
  std::vector<double> Buffer;
};

// A number whose order is random but the same for a point at every time step, whatever the maximum.
std::uint64_t SampleOrder(std::uint64_t point, std::uint64_t block, std::uint64_t seed)
{
  std::uint64_t x = point + 0x9e3779b97f4a7c15ull * (block + 1) + 0xd1342543de82ef95ull * seed;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// The points of visible blocks, thinned out as the mask says, in their own order.
std::vector<vtkIdType> Candidates(
  vtkPolyData* points, const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  const vtkIdType count = points->GetNumberOfPoints();
  auto* blockIds = vtkUnsignedIntArray::SafeDownCast(
    points->GetPointData()->GetArray(vtkGlyphPointGatherer::CompositeIndexName()));
  std::vector<vtkIdType> candidates;
  candidates.reserve(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (blockIds && !blocks.empty())
    {
      const auto block = blocks.find(blockIds->GetValue(i));
      if (block != blocks.end() && !block->second.Visible)
      {
        continue;
      }
    }
    candidates.push_back(i);
  }

  const auto maximum =
    static_cast<std::size_t>(std::max<vtkIdType>(settings.MaximumNumberOfGlyphs, 0));
  if (settings.Mask && candidates.size() > maximum)
  {
    vtkDataArray* ids = points->GetPointData()->GetArray(vtkGlyphPointGatherer::PointIdsName());
    std::vector<std::pair<std::uint64_t, vtkIdType>> order;
    order.reserve(candidates.size());
    for (vtkIdType i : candidates)
    {
      const auto id = static_cast<std::uint64_t>(ids ? ids->GetTuple1(i) : i);
      order.emplace_back(SampleOrder(id, blockIds ? blockIds->GetValue(i) : 0, settings.Seed), i);
    }
    std::nth_element(order.begin(), order.begin() + maximum, order.end());
    candidates.clear();
    std::transform(order.begin(), order.begin() + maximum, std::back_inserter(candidates),
      [](const auto& item) { return item.second; });
    std::sort(candidates.begin(), candidates.end());
  }
  return candidates;
}

// Why a point has no glyph.
enum Reason
{
  POSITION,
  SCALE,
  ORIENTATION,
  TENSOR,
  EXPONENT,
  MOTION,
  FORM,
  REASONS,
  NO_REASON = REASONS
};

void Describe(vtkGlyphInstanceBuilder::Result& result, const Settings& settings,
  const std::array<vtkIdType, REASONS>& skipped, std::size_t candidates)
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
  say(skipped[POSITION], "their position is not finite",
    "Remove these points, for example with Threshold or Clean.");
  if (!settings.Scaling)
  {
    say(skipped[SCALE], "GlyphScaleFactor, or Scale of the representation, is zero or not finite",
      "Set it to a positive number.");
  }
  else
  {
    say(skipped[SCALE],
      "their scale, from the point array '" + settings.ScaleArray + "', is zero or not finite",
      "Choose another GlyphScaleArray, switch GlyphScaling off, or remove these points with "
      "Threshold.");
  }
  say(skipped[ORIENTATION],
    "their orientation, from the point array '" + settings.OrientationArray +
      "', is zero or not finite",
    "Choose another GlyphOrientationArray, switch GlyphOrient off, or remove these points with "
    "Threshold.");
  say(skipped[TENSOR],
    "their tensor, from the point array '" + settings.Tensors.Array + "', is zero or not finite",
    "Remove these points with Threshold, or leave it at that.");
  say(skipped[MOTION],
    "their velocity, acceleration or angular velocity, or the way they go while the shutter is "
    "open, is not finite",
    "Choose other arrays, switch MotionBlur off, or remove these points with Threshold.");
  say(skipped[FORM],
    "the number of their form, from the point array '" + settings.TableIndexArray + "', is not finite",
    "Choose another GlyphMeshIndexArray, or remove these points with Threshold.");
  if (IsNone(settings.ExponentArray))
  {
    std::ostringstream why;
    why << "GlyphExponents are " << settings.Exponents[0] << ", " << settings.Exponents[1] << ", "
        << settings.Exponents[2];
    say(skipped[EXPONENT], why.str(), "Make each of them positive; 2 2 2 is an ellipsoid.");
  }
  else
  {
    say(skipped[EXPONENT],
      "their exponents, from the point array '" + settings.ExponentArray +
        "', are zero, negative or not finite",
      "Choose another GlyphExponentArray, or None, or remove these points with Threshold.");
  }
}

// Whether the points choose among several forms.
bool HasTable(const Settings& settings)
{
  return settings.Shape == rtg::Shape::Mesh && settings.TableSize > 1;
}

// Whether the shape is a superquadric with exponents of the settings; those of tensors come from elsewhere.
bool HasOwnExponents(const Settings& settings)
{
  return HasExponents(settings.Shape) && !settings.Tensors.On;
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

vtkDataArray* WantedArray(vtkPolyData* points, bool wanted, const std::string& name)
{
  return wanted && !IsNone(name) ? points->GetPointData()->GetArray(name.c_str()) : nullptr;
}

// The wanted array, when it is there and its tuples have one of the lengths that make sense (none given: any).
vtkDataArray* CheckedArray(vtkDataArray* array, bool wanted, const std::string& name,
  const char* property, const std::vector<int>& lengths, const char* without,
  vtkGlyphInstanceBuilder::Result& result)
{
  if (!wanted || IsNone(name))
  {
    return nullptr;
  }
  if (!array)
  {
    result.Messages.push_back("There is no point array '" + name + "', which " + property +
      " names; " + without + ". Choose one that exists, or None.");
    return nullptr;
  }
  if (!lengths.empty() &&
    std::find(lengths.begin(), lengths.end(), array->GetNumberOfComponents()) == lengths.end())
  {
    std::ostringstream text;
    text << "The point array '" << name << "', which " << property << " names, has "
         << array->GetNumberOfComponents() << " components where " << lengths.front()
         << (lengths.size() > 1 ? " to " + std::to_string(lengths.back()) : "")
         << " are needed; " << without << ". Choose another array or mode.";
    result.Messages.push_back(text.str());
    return nullptr;
  }
  return array;
}
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphInstanceBuilder::ScaleArray(vtkPolyData* points, const Settings& settings)
{
  return WantedArray(points, settings.Scaling, settings.ScaleArray);
}

//----------------------------------------------------------------------------
vtkDataArray*
vtkGlyphInstanceBuilder::OrientationArray(vtkPolyData* points, const Settings& settings)
{
  return WantedArray(points, settings.Orient, settings.OrientationArray);
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphInstanceBuilder::ExponentArray(vtkPolyData* points, const Settings& settings)
{
  return WantedArray(points, HasOwnExponents(settings), settings.ExponentArray);
}

//----------------------------------------------------------------------------
vtkDataArray* vtkGlyphInstanceBuilder::TableIndexArray(vtkPolyData* points, const Settings& settings)
{
  return WantedArray(points, settings.TableSize > 1, settings.TableIndexArray);
}

//----------------------------------------------------------------------------
bool vtkGlyphInstanceBuilder::NeedsMeanScale(const Settings& settings)
{
  return settings.Shape == rtg::Shape::Arrow && settings.Arrow.fixedHeads && settings.Scaling &&
    !IsNone(settings.ScaleArray) && !IsPositive(settings.ArrowReference);
}

//----------------------------------------------------------------------------
vtkGlyphInstanceBuilder::ScaleSum vtkGlyphInstanceBuilder::SumScales(
  vtkPolyData* points, const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  ScaleSum sum;
  vtkDataArray* array = ScaleArray(points, settings);
  const bool byComponents = settings.ScaleMode == COMPONENTS;
  if (!array || (byComponents && array->GetNumberOfComponents() != 3))
  {
    return sum;
  }
  Tuples scales(array);
  for (vtkIdType i : Candidates(points, settings, blocks))
  {
    const double* tuple = scales.Get(i);
    const double scale = byComponents ? std::abs(tuple[0]) : vtkMath::Norm(tuple, scales.Size());
    if (IsPositive(scale)) // else there is no glyph
    {
      sum.Sum += scale;
      sum.Count += 1.0;
    }
  }
  return sum;
}

//----------------------------------------------------------------------------
double vtkGlyphInstanceBuilder::SharedMeanScale(vtkPolyData* points)
{
  vtkDataArray* shared = points->GetFieldData()->GetArray(MeanScaleName());
  return shared && shared->GetNumberOfValues() > 0 ? shared->GetComponent(0, 0) : 0.0;
}

//----------------------------------------------------------------------------
double vtkGlyphInstanceBuilder::ReferenceScale(
  vtkPolyData* points, const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks)
{
  if (!NeedsMeanScale(settings))
  {
    const bool scaled = settings.Scaling && !IsNone(settings.ScaleArray);
    return scaled && IsPositive(settings.ArrowReference) ? settings.ArrowReference : 1.0;
  }
  const double shared = SharedMeanScale(points);
  return IsPositive(shared) ? shared : SumScales(points, settings, blocks).Mean();
}

//----------------------------------------------------------------------------
vtkGlyphInstanceBuilder::Settings vtkGlyphInstanceBuilder::AxesOf(const Settings& tensorGlyphs)
{
  Settings settings = tensorGlyphs;
  settings.Shape = rtg::Shape::Arrow;
  settings.Tensors.Axes = true;
  settings.Scaling &= settings.ScaleMode != COMPONENTS;
  settings.ScaleFactor = std::abs(settings.ScaleFactor);
  // Thin, so as to hide little, and of one form: short ones are small.
  settings.Arrow.shaftRadius = 0.015f;
  settings.Arrow.tipRadius = 0.05f;
  settings.Arrow.tipLength = 0.15f;
  settings.Arrow.tipRounding = 0.0f;
  settings.Arrow.fixedHeads = false;
  return settings;
}

namespace
{
bool IsFinite(const double* x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

// Appends glyphs to a result, one point after the other.
class Assembly
{
public:
  // Takes the arrays that are there and fit. `tensors` may be null; all stay the caller's.
  Assembly(vtkPolyData* points, const Settings& settings, vtkMatrix4x4* modelToWorld, const vtkGlyphTensors* tensors,
    vtkGlyphInstanceBuilder::Result& result)
    : How(settings)
    , Tensors(tensors)
    , Placement(modelToWorld)
    , Motion(points, settings.Motion)
    , Out(result)
    , Instances(result.Instances)
    , ByComponents(settings.ScaleMode == vtkGlyphInstanceBuilder::COMPONENTS)
    , ChoosesForm(HasTable(settings))
    , OwnExponents(HasOwnExponents(settings))
    , Sphere(settings.Shape == rtg::Shape::Sphere)
    , Positions(points->GetPoints()->GetData())
    , Scales(CheckedArray(vtkGlyphInstanceBuilder::ScaleArray(points, settings), settings.Scaling, settings.ScaleArray,
        "GlyphScaleArray", this->ByComponents ? std::vector<int>{ 3 } : std::vector<int>{},
        "all glyphs get the same size", result))
    , Orientations(CheckedArray(vtkGlyphInstanceBuilder::OrientationArray(points, settings), settings.Orient,
        settings.OrientationArray, "GlyphOrientationArray",
        { settings.OrientationMode == vtkGlyphInstanceBuilder::QUATERNION ? 4 : 3 }, "the glyphs are not turned", result))
    , Forms(CheckedArray(vtkGlyphInstanceBuilder::TableIndexArray(points, settings), this->ChoosesForm,
        settings.TableIndexArray, "GlyphMeshIndexArray", {}, "all points have the table's first form", result))
    , Exponents(CheckedArray(vtkGlyphInstanceBuilder::ExponentArray(points, settings), this->OwnExponents,
        settings.ExponentArray, "GlyphExponentArray", { 1, 2, 3 }, "GlyphExponents count", result))
  {
    this->GoodExponents =
      this->OwnExponents && MakeExponents(settings, settings.Exponents, 3, this->Instances.uniformExponents);

    // What an instance stores: nothing that is the same for all, and no turn of what looks the same from all sides
    const bool sizedByData = this->Scales || tensors;
    this->SameSizes = !sizedByData && this->Placement.Uniform;
    this->OneSize = (!this->Scales || !this->ByComponents) && !tensors && this->Placement.Uniform;
    this->Turned =
      (this->Orientations || tensors || !this->Placement.Identity) && !(this->Sphere && this->OneSize);
    const bool pointed = settings.Shape == rtg::Shape::Cone || settings.Shape == rtg::Shape::Arrow;
    this->Flips = pointed &&
      ((this->Scales && this->ByComponents) || settings.ScaleFactor < 0.0 || this->Placement.Scale < 0.0);
  }

  bool IsScaled() const { return static_cast<bool>(this->Scales); }
  const vtkGlyphPlacement& GetPlacement() const { return this->Placement; }
  const vtkGlyphMotion& GetMotion() const { return this->Motion; }

  // The middle of the data, from which the positions lose the least when they become float
  void ChooseOrigin(const std::vector<vtkIdType>& candidates)
  {
    vtkBoundingBox box;
    for (vtkIdType i : candidates)
    {
      const double* x = this->Positions.Get(i);
      if (IsFinite(x))
      {
        box.AddPoint(x[0], x[1], x[2]);
      }
    }
    if (box.IsValid())
    {
      glm::dvec3 center;
      box.GetCenter(&center[0]);
      this->Instances.origin = this->Placement.Linear * center + this->Placement.Offset;
    }
  }

  // Why the point has no glyph; NO_REASON when it has one, or is none of this set's.
  Reason Add(vtkIdType i)
  {
    if (this->ChoosesForm)
    {
      const double number = this->Forms ? vtkMath::Norm(this->Forms.Get(i), this->Forms.Size()) : 0.0;
      const int last = this->How.TableSize - 1;
      const bool counts = !std::isnan(number);
      if ((counts ? static_cast<int>(std::min<double>(number, last)) : 0) != this->How.TableEntry)
      {
        return NO_REASON;
      }
      if (!counts)
      {
        return FORM;
      }
    }
    const double* x = this->Positions.Get(i);
    const glm::dvec3 position = this->Placement.Linear * glm::dvec3(x[0], x[1], x[2]) + this->Placement.Offset -
      this->Instances.origin;
    const glm::vec3 center(position);
    if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z))
    {
      return POSITION;
    }

    glm::dvec3 size(this->How.ScaleFactor);
    if (this->Scales)
    {
      const double* tuple = this->Scales.Get(i);
      size *= this->ByComponents ? glm::dvec3(tuple[0], tuple[1], tuple[2])
                                 : glm::dvec3(vtkMath::Norm(tuple, this->Scales.Size()));
    }
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    rtg::TensorGlyph tensorGlyph;
    if (this->Tensors && this->How.Tensors.Axes)
    {
      double axis[3];
      if (!this->Tensors->Axis(i, axis))
      {
        return NO_REASON; // nothing to show is no fault
      }
      size *= std::hypot(axis[0], axis[1], axis[2]);
      vtkGlyphPlacement::RotationFromTuple(axis, vtkGlyphInstanceBuilder::DIRECTION, rotation);
    }
    else if (this->Tensors)
    {
      if (!this->Tensors->Glyph(i, tensorGlyph))
      {
        return TENSOR;
      }
      size *= tensorGlyph.halfLengths;
      rotation = tensorGlyph.rotation;
    }
    else if (this->Orientations && this->Turned &&
      !vtkGlyphPlacement::RotationFromTuple(this->Orientations.Get(i), this->How.OrientationMode, rotation))
    {
      return ORIENTATION;
    }

    glm::vec3 exponents(2.0f);
    if (this->OwnExponents &&
      !(this->Exponents ? MakeExponents(this->How, this->Exponents.Get(i), this->Exponents.Size(), exponents)
                        : this->GoodExponents))
    {
      return EXPONENT;
    }

    this->Placement.Apply(this->Sphere, size, rotation);
    if (this->Flips && size.x < 0.0)
    {
      rotation = rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
    }
    const glm::vec3 extent(glm::abs(size));
    const float smallest = std::min({ extent.x, extent.y, extent.z });
    const float largest = std::max({ extent.x, extent.y, extent.z });
    if (!(smallest > 0.0f) || !std::isfinite(largest) || !std::isfinite(extent.y))
    {
      return SCALE;
    }
    if (!this->Motion.IsFinite(i))
    {
      return MOTION;
    }

    this->Out.Points.push_back(i);
    this->Motion.AppendTo(
      this->Instances.motion, i, this->Placement.Linear, glm::mat3_cast(this->Placement.Rotation));
    this->Instances.centres.push_back(center);
    this->Store(this->How.Shape == rtg::Shape::Mesh ? glm::vec3(size) : extent, rotation, tensorGlyph, exponents);
    return NO_REASON;
  }

  void Finish()
  {
    this->Motion.Finish(this->Instances.motion);
    if (this->Sphere && this->OneSize)
    {
      this->Instances.motion.angularVelocities.clear(); // it looks the same from all sides
    }
  }

private:
  void Store(const glm::vec3& size, const glm::dquat& rotation, const rtg::TensorGlyph& tensor, const glm::vec3& exponents)
  {
    if (this->Instances.centres.size() == 1)
    {
      this->Instances.uniformSize = size.x;
    }
    if (this->How.Tensors.ColorsBySign())
    {
      const glm::dvec3 magnitudes(glm::abs(tensor.values));
      this->Instances.forms.emplace_back(tensor.values / std::max({ magnitudes.x, magnitudes.y, magnitudes.z }));
    }
    if (this->Tensors && HasExponents(this->How.Shape))
    {
      this->Instances.exponents3.emplace_back(tensor.exponents);
    }
    else if (this->Exponents)
    {
      this->Instances.exponents3.push_back(exponents);
    }
    if (!this->OneSize)
    {
      this->Instances.sizes3.push_back(size);
    }
    else if (!this->SameSizes)
    {
      this->Instances.sizes1.push_back(size.x);
    }
    if (this->Turned || this->Flips)
    {
      this->Instances.rotations.emplace_back(rotation.x, rotation.y, rotation.z, rotation.w);
    }
  }

  const Settings& How;
  const vtkGlyphTensors* Tensors;
  const vtkGlyphPlacement Placement;
  const vtkGlyphMotion Motion;
  vtkGlyphInstanceBuilder::Result& Out;
  rtg::GlyphInstances& Instances;
  const bool ByComponents, ChoosesForm, OwnExponents, Sphere;
  Tuples Positions, Scales, Orientations, Forms, Exponents;
  bool GoodExponents = false; // of the settings
  bool SameSizes = false, OneSize = false; // for all glyphs; for all axes of one
  bool Turned = false, Flips = false;
};
}

//----------------------------------------------------------------------------
vtkGlyphInstanceBuilder::Result vtkGlyphInstanceBuilder::Build(vtkPolyData* points,
  const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks,
  vtkMatrix4x4* modelToWorld)
{
  Result result;
  rtg::GlyphInstances& instances = result.Instances;
  instances.shape = settings.Shape;
  instances.arrow = settings.Arrow;
  const bool isMesh = settings.Shape == rtg::Shape::Mesh;
  if (isMesh && (!settings.Mesh || settings.Mesh->triangles.empty()))
  {
    const std::string number = std::to_string(settings.TableEntry);
    result.Messages.push_back((HasTable(settings) ? "Entry " + number + " of GlyphMesh has no polygons, so points that choose it have no glyph."
                                        : "GlyphMesh has no polygons, so there are no glyphs.") +
      " Choose a source that has some, such as Arrow, Cone or Sphere.");
    return result;
  }
  instances.mesh = isMesh ? settings.Mesh : nullptr;
  const std::vector<vtkIdType> candidates = Candidates(points, settings, blocks);
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

  Assembly assembly(points, settings, modelToWorld, tensors.get(), result);
  if (!problem.empty())
  {
    result.Messages.push_back(problem);
    result.Skipped = static_cast<vtkIdType>(candidates.size());
    return result;
  }
  const std::vector<std::string>& aboutMotion = assembly.GetMotion().Messages();
  result.Messages.insert(result.Messages.end(), aboutMotion.begin(), aboutMotion.end());
  assembly.ChooseOrigin(candidates);
  result.Points.reserve(candidates.size());
  instances.centres.reserve(candidates.size());
  std::array<vtkIdType, REASONS> skipped{};
  for (vtkIdType i : candidates)
  {
    const Reason reason = assembly.Add(i);
    if (reason != NO_REASON)
    {
      ++skipped[reason];
    }
  }
  assembly.Finish();

  // Fixed heads have the world size that they have on the arrow of reference
  const vtkGlyphPlacement& placement = assembly.GetPlacement();
  if (settings.Shape == rtg::Shape::Arrow)
  {
    const double reference = assembly.IsScaled() ? ReferenceScale(points, settings, blocks) : 1.0;
    const auto unit =
      static_cast<float>(std::abs(settings.ScaleFactor * placement.Scale) * reference);
    instances.arrow.unitLength = IsPositive(unit) ? unit : 1.0f;
  }
  if (!placement.Uniform && settings.Shape != rtg::Shape::Sphere)
  {
    result.Messages.push_back(
      "Scale of the representation differs between its axes, which glyphs of this shape "
      "can follow only approximately. Transform the data instead, or use one scale.");
  }
  if (HasTable(settings) && settings.TableEntry > 0)
  {
    result.Messages.clear(); // what is not about single points the first entry has said
  }
  Describe(result, settings, skipped, candidates.size());
  return result;
}

//----------------------------------------------------------------------------
void vtkGlyphInstanceBuilder::ComputeBounds(vtkPolyData* points, const Settings& settings,
  const vtkGlyphBlockAttributes::Table& blocks, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  vtkBoundingBox box;
  Tuples positions(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  const vtkGlyphMotion motion(points, settings.Motion);
  auto* blockIds = vtkUnsignedIntArray::SafeDownCast(
    points->GetPointData()->GetArray(vtkGlyphPointGatherer::CompositeIndexName()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* x = positions.Get(i);
    const auto block = blockIds ? blocks.find(blockIds->GetValue(i)) : blocks.end();
    const bool visible = block == blocks.end() || block->second.Visible;
    if (visible && IsFinite(x))
    {
      box.AddPoint(x[0], x[1], x[2]);
      if (motion.On() && motion.IsFinite(i))
      {
        const rtg::DisplacementRange range = motion.Range(i);
        box.AddPoint(x[0] + range.lower.x, x[1] + range.lower.y, x[2] + range.lower.z);
        box.AddPoint(x[0] + range.upper.x, x[1] + range.upper.y, x[2] + range.upper.z);
      }
    }
  }
  if (!box.IsValid())
  {
    return;
  }

  glm::dvec3 largest(std::abs(settings.ScaleFactor));
  if (vtkDataArray* scales = ScaleArray(points, settings))
  {
    const bool byComponents = settings.ScaleMode == COMPONENTS;
    if (!byComponents || scales->GetNumberOfComponents() == 3)
    {
      for (int c = 0; c < 3; ++c)
      {
        double range[2] = { 0.0, 0.0 };
        scales->GetFiniteRange(range, byComponents ? c : -1);
        largest[c] *= std::max(std::abs(range[0]), std::abs(range[1]));
      }
    }
  }
  if (!std::isfinite(largest.x + largest.y + largest.z))
  {
    largest = glm::dvec3(0.0);
  }
  if (vtkDataArray* tensors = vtkGlyphTensors::Array(points, settings.Tensors))
  {
    largest *= settings.Tensors.Axes ? vtkGlyphTensors::LargestAxis(tensors, settings.Tensors)
                                     : vtkGlyphTensors::Largest(tensors, settings.Tensors);
  }
  // Reach of the unit form from its centre along the axes; turned, in every direction
  const bool arrow = settings.Shape == rtg::Shape::Arrow;
  glm::dvec3 reach(0.5);
  if (arrow)
  {
    const double thick = std::max(settings.Arrow.shaftRadius, settings.Arrow.tipRadius);
    reach = glm::dvec3(1.0, thick, thick);
    if (settings.Arrow.fixedHeads)
    {
      // As thick as on the arrow of reference; where even the longest is but a shrunk head, as that.
      const double thickness =
        std::min(std::abs(settings.ScaleFactor) * ReferenceScale(points, settings, blocks),
          largest.x / settings.Arrow.tipLength);
      largest = glm::dvec3(largest.x, thickness, thickness);
    }
  }
  if (settings.Shape == rtg::Shape::Mesh && settings.Mesh)
  {
    reach = glm::dvec3(0.0);
    for (const glm::vec3& position : settings.Mesh->positions)
    {
      reach = glm::max(reach, glm::abs(glm::dvec3(position)));
    }
  }
  reach *= largest;
  if (OrientationArray(points, settings) || settings.Tensors.On || arrow || settings.Shape == rtg::Shape::Cone || motion.Spins())
  {
    const double radius = settings.Shape == rtg::Shape::Sphere
      ? std::max({ reach.x, reach.y, reach.z })
      : glm::length(reach);
    reach = glm::dvec3(radius);
  }
  if (reach.x > 0.0 && std::isfinite(reach.x + reach.y + reach.z))
  {
    double lower[3], upper[3];
    box.GetMinPoint(lower[0], lower[1], lower[2]);
    box.GetMaxPoint(upper[0], upper[1], upper[2]);
    box.AddPoint(lower[0] - reach.x, lower[1] - reach.y, lower[2] - reach.z);
    box.AddPoint(upper[0] + reach.x, upper[1] + reach.y, upper[2] + reach.z);
  }
  box.GetBounds(bounds);
}
