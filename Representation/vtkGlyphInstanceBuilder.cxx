#include "vtkGlyphInstanceBuilder.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"
#include "vtkUnsignedIntArray.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
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

// What vtkGlyph3DMapper turns a glyph by. False: the tuple gives no rotation.
bool RotationFromTuple(const double* tuple, int mode, glm::dquat& rotation)
{
  const auto finite = [tuple](int n)
  { return std::all_of(tuple, tuple + n, [](double v) { return std::isfinite(v); }); };
  switch (mode)
  {
    case vtkGlyphInstanceBuilder::ROTATION:
    {
      if (!finite(3))
      {
        return false;
      }
      const glm::dvec3 half = 0.5 * glm::radians(glm::dvec3(tuple[0], tuple[1], tuple[2]));
      rotation = glm::dquat(std::cos(half.z), 0.0, 0.0, std::sin(half.z)) *
        glm::dquat(std::cos(half.x), std::sin(half.x), 0.0, 0.0) *
        glm::dquat(std::cos(half.y), 0.0, std::sin(half.y), 0.0);
      return true;
    }
    case vtkGlyphInstanceBuilder::QUATERNION:
    {
      if (!finite(4))
      {
        return false;
      }
      // Scaled first: the square of a tiny or huge component would leave the range of double.
      const double largest = std::max(
        { std::abs(tuple[0]), std::abs(tuple[1]), std::abs(tuple[2]), std::abs(tuple[3]) });
      if (largest == 0.0)
      {
        return false;
      }
      rotation = glm::normalize(
        glm::dquat(tuple[0] / largest, tuple[1] / largest, tuple[2] / largest, tuple[3] / largest));
      return true;
    }
    default:
    {
      if (!finite(3))
      {
        return false;
      }
      const double largest =
        std::max({ std::abs(tuple[0]), std::abs(tuple[1]), std::abs(tuple[2]) });
      if (largest == 0.0)
      {
        return false;
      }
      // A half turn about the middle between +x and the direction. It is +z for -x, as in vtkGlyph3DMapper.
      const glm::dvec3 direction =
        glm::normalize(glm::dvec3(tuple[0], tuple[1], tuple[2]) / largest);
      if (direction.y == 0.0 && direction.z == 0.0)
      {
        rotation =
          direction.x < 0.0 ? glm::dquat(0.0, 0.0, 1.0, 0.0) : glm::dquat(1.0, 0.0, 0.0, 0.0);
        return true;
      }
      // 1 + x loses its digits where the direction is nearly -x; there (y^2 + z^2) / (1 - x) is the same.
      const double yz = direction.y * direction.y + direction.z * direction.z;
      const double x = direction.x < 0.0 ? yz / (1.0 - direction.x) : 1.0 + direction.x;
      const glm::dvec3 axis = glm::normalize(glm::dvec3(x, direction.y, direction.z));
      rotation = glm::dquat(0.0, axis.x, axis.y, axis.z);
      return true;
    }
  }
}

// The linear part of the actor's matrix: none, a turn with one scale, or one that also shears.
struct Placement
{
  bool Identity = true;
  bool Uniform = true;
  glm::dmat3 Linear{ 1.0 };
  glm::dvec3 Offset{ 0.0 };
  double Scale = 1.0;
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };

  explicit Placement(vtkMatrix4x4* matrix)
  {
    if (!matrix || matrix->IsIdentity())
    {
      return;
    }
    this->Identity = false;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        this->Linear[column][row] = matrix->GetElement(row, column);
      }
      this->Offset[row] = matrix->GetElement(row, 3);
    }
    const glm::dmat3 gram = glm::transpose(this->Linear) * this->Linear;
    const double square = (gram[0][0] + gram[1][1] + gram[2][2]) / 3.0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Uniform &= std::abs(gram[i][j] - (i == j ? square : 0.0)) <= 1e-9 * square;
      }
    }
    if (this->Uniform && square > 0.0)
    {
      // A mirror image is the negative of a turned one: the sign goes into the scale.
      this->Scale = std::copysign(std::sqrt(square), glm::determinant(this->Linear));
      this->Rotation = glm::normalize(glm::quat_cast(this->Linear / this->Scale));
    }
  }
};

// Size and rotation of the image of a glyph under a map that is no turn with one scale. Exact for spheres, whose
// image is an ellipsoid; of other shapes the sheared image is no glyph and its straight-angled neighbour is taken.
void Deform(const glm::dmat3& linear, bool sphere, glm::dvec3& size, glm::dquat& rotation)
{
  glm::dmat3 image = linear * glm::mat3_cast(rotation);
  for (int i = 0; i < 3; ++i)
  {
    image[i] *= size[i];
  }
  if (!sphere)
  {
    for (int i = 0; i < 3; ++i)
    {
      size[i] = glm::length(image[i]);
      if (size[i] > 0.0)
      {
        image[i] /= size[i];
      }
    }
  }
  double a[3][3], u[3][3], w[3], vt[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      a[row][column] = image[column][row];
    }
  }
  vtkMath::SingularValueDecomposition3x3(a, u, w, vt);
  glm::dmat3 left, right;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      left[column][row] = u[row][column];
      right[column][row] = vt[row][column];
    }
  }
  glm::dmat3 turn = sphere ? left : left * right;
  if (glm::determinant(turn) < 0.0)
  {
    turn = -turn;
  }
  if (sphere)
  {
    size = glm::dvec3(std::abs(w[0]), std::abs(w[1]), std::abs(w[2]));
  }
  rotation = glm::normalize(glm::quat_cast(turn));
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
  REASONS
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
  const bool hasTable = isMesh && settings.TableSize > 1;
  if (isMesh && (!settings.Mesh || settings.Mesh->triangles.empty()))
  {
    const std::string number = std::to_string(settings.TableEntry);
    result.Messages.push_back((hasTable ? "Entry " + number + " of GlyphMesh has no polygons, so points that choose it have no glyph."
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

  // Arrays, as far as they are there and fit
  const bool byComponents = settings.ScaleMode == COMPONENTS;
  Tuples scales(CheckedArray(ScaleArray(points, settings), settings.Scaling, settings.ScaleArray,
    "GlyphScaleArray", byComponents ? std::vector<int>{ 3 } : std::vector<int>{},
    "all glyphs get the same size", result));
  Tuples orientations(CheckedArray(OrientationArray(points, settings), settings.Orient,
    settings.OrientationArray, "GlyphOrientationArray",
    { settings.OrientationMode == QUATERNION ? 4 : 3 }, "the glyphs are not turned", result));
  Tuples forms(CheckedArray(TableIndexArray(points, settings), hasTable, settings.TableIndexArray, "GlyphMeshIndexArray", {},
    "all points have the table's first form", result));
  const bool ownExponents = HasOwnExponents(settings);
  Tuples exponents(CheckedArray(ExponentArray(points, settings), ownExponents, settings.ExponentArray,
    "GlyphExponentArray", { 1, 2, 3 }, "GlyphExponents count", result));
  const bool goodExponents =
    ownExponents && MakeExponents(settings, settings.Exponents, 3, instances.uniformExponents);
  Tuples positions(points->GetPoints()->GetData());
  std::unique_ptr<vtkGlyphTensors> tensors;
  if (settings.Tensors.On)
  {
    vtkDataArray* array = vtkGlyphTensors::Array(points, settings.Tensors);
    const std::string problem = vtkGlyphTensors::Problem(array, settings.Tensors);
    if (!problem.empty())
    {
      result.Messages.push_back(problem);
      result.Skipped = static_cast<vtkIdType>(candidates.size());
      return result;
    }
    tensors = std::make_unique<vtkGlyphTensors>(array, settings.Tensors, candidates);
  }

  const vtkGlyphMotion motion(points, settings.Motion);
  result.Messages.insert(
    result.Messages.end(), motion.Messages().begin(), motion.Messages().end());

  // What an instance stores: nothing that is the same for all, and no turn of what looks the same from all sides
  const Placement placement(modelToWorld);
  const bool sphere = settings.Shape == rtg::Shape::Sphere;
  const bool sameSizes = !scales && !tensors && placement.Uniform;
  const bool oneSize = (!scales || !byComponents) && !tensors && placement.Uniform;
  const bool turned = (orientations || tensors || !placement.Identity) && !(sphere && oneSize);
  const bool pointed = settings.Shape == rtg::Shape::Cone || settings.Shape == rtg::Shape::Arrow;
  bool flips = (scales && byComponents) || settings.ScaleFactor < 0.0 || placement.Scale < 0.0;
  flips = flips && pointed;

  // The middle of the data, from which the positions lose the least when they become float
  vtkBoundingBox box;
  for (vtkIdType i : candidates)
  {
    const double* x = positions.Get(i);
    if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
    {
      box.AddPoint(x[0], x[1], x[2]);
    }
  }
  if (box.IsValid())
  {
    glm::dvec3 center;
    box.GetCenter(&center[0]);
    instances.origin = placement.Linear * center + placement.Offset;
  }

  result.Points.reserve(candidates.size());
  instances.centres.reserve(candidates.size());
  std::array<vtkIdType, REASONS> skipped{};
  bool sized = false;
  for (vtkIdType i : candidates)
  {
    if (hasTable)
    {
      const double number = forms ? vtkMath::Norm(forms.Get(i), forms.Size()) : 0.0;
      const int last = settings.TableSize - 1;
      const bool counts = !std::isnan(number);
      if ((counts ? static_cast<int>(std::min<double>(number, last)) : 0) != settings.TableEntry)
      {
        continue;
      }
      if (!counts)
      {
        ++skipped[FORM];
        continue;
      }
    }
    const double* x = positions.Get(i);
    const glm::dvec3 position =
      placement.Linear * glm::dvec3(x[0], x[1], x[2]) + placement.Offset - instances.origin;
    const glm::vec3 center(position);
    if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z))
    {
      ++skipped[POSITION];
      continue;
    }

    glm::dvec3 size(settings.ScaleFactor);
    if (scales)
    {
      const double* tuple = scales.Get(i);
      size *= byComponents ? glm::dvec3(tuple[0], tuple[1], tuple[2])
                           : glm::dvec3(vtkMath::Norm(tuple, scales.Size()));
    }
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    rtg::TensorGlyph tensorGlyph;
    double axis[3];
    if (tensors && settings.Tensors.Axes)
    {
      if (!tensors->Axis(i, axis))
      {
        continue; // nothing to show is no fault
      }
      size *= std::hypot(axis[0], axis[1], axis[2]);
      RotationFromTuple(axis, DIRECTION, rotation);
    }
    else if (tensors)
    {
      if (!tensors->Glyph(i, tensorGlyph))
      {
        ++skipped[TENSOR];
        continue;
      }
      size *= tensorGlyph.halfLengths;
      rotation = tensorGlyph.rotation;
    }
    else if (orientations && turned &&
      !RotationFromTuple(orientations.Get(i), settings.OrientationMode, rotation))
    {
      ++skipped[ORIENTATION];
      continue;
    }

    glm::vec3 ownExponent(2.0f);
    if (ownExponents &&
      !(exponents ? MakeExponents(settings, exponents.Get(i), exponents.Size(), ownExponent) : goodExponents))
    {
      ++skipped[EXPONENT];
      continue;
    }

    // The actor's transform
    if (!placement.Uniform)
    {
      Deform(placement.Linear, sphere, size, rotation);
    }
    else if (!placement.Identity)
    {
      size *= placement.Scale;
      rotation = placement.Rotation * rotation;
    }
    if (flips && size.x < 0.0)
    {
      rotation = rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
    }
    const glm::vec3 extent(glm::abs(size));
    const float smallest = std::min({ extent.x, extent.y, extent.z });
    const float largest = std::max({ extent.x, extent.y, extent.z });
    if (!(smallest > 0.0f) || !std::isfinite(largest) || !std::isfinite(extent.y))
    {
      ++skipped[SCALE];
      continue;
    }
    if (!motion.IsFinite(i))
    {
      ++skipped[MOTION];
      continue;
    }

    result.Points.push_back(i);
    motion.AppendTo(
      instances.motion, i, placement.Linear, glm::mat3_cast(placement.Rotation));
    instances.centres.push_back(center);
    const glm::vec3 stored = isMesh ? glm::vec3(size) : extent;
    if (!sized)
    {
      instances.uniformSize = stored.x;
      sized = true;
    }
    if (settings.Tensors.ColorsBySign())
    {
      instances.forms.emplace_back(
        tensorGlyph.values / std::max({ std::abs(tensorGlyph.values.x),
                               std::abs(tensorGlyph.values.y), std::abs(tensorGlyph.values.z) }));
    }
    if (tensors && HasExponents(settings.Shape))
    {
      instances.exponents3.emplace_back(tensorGlyph.exponents);
    }
    else if (exponents)
    {
      instances.exponents3.push_back(ownExponent);
    }
    if (!oneSize)
    {
      instances.sizes3.push_back(stored);
    }
    else if (!sameSizes)
    {
      instances.sizes1.push_back(stored.x);
    }
    if (turned || flips)
    {
      instances.rotations.emplace_back(rotation.x, rotation.y, rotation.z, rotation.w);
    }
  }

  motion.Finish(instances.motion);
  if (sphere && oneSize)
  {
    instances.motion.angularVelocities.clear(); // it looks the same from all sides
  }

  // Fixed heads have the world size that they have on the arrow of reference
  if (settings.Shape == rtg::Shape::Arrow)
  {
    const double reference = scales ? ReferenceScale(points, settings, blocks) : 1.0;
    const auto unit =
      static_cast<float>(std::abs(settings.ScaleFactor * placement.Scale) * reference);
    instances.arrow.unitLength = IsPositive(unit) ? unit : 1.0f;
  }
  if (!placement.Uniform && !sphere)
  {
    result.Messages.push_back(
      "Scale of the representation differs between its axes, which glyphs of this shape "
      "can follow only approximately. Transform the data instead, or use one scale.");
  }
  if (hasTable && settings.TableEntry > 0)
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
    if (visible && std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
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
