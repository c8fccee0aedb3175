#include "GlyphMaker.h"

#include "Finite.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

using namespace rtglyphs::GlyphOutcomes;

namespace
{
// One of the arrows of a tensor: along the eigenvector of the largest magnitude first, to both sides of the center.
// From it where the eigenvalue is positive, else to it.
Outcome TakePart(int part, rtg::TensorGlyph& tensor, glm::dvec3& size, glm::dquat& rotation, double& shift)
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

// One of the cylinders of a split vector, whose y axis lies along the glyph's x.
Outcome TakeCylinder(
  const rtglyphs::GlyphSettings::Cylinder& part, double factor, glm::dvec3& size, glm::dquat& rotation, double& shift)
{
  if (!(part.Length() > 0.0))
  {
    return NOT_SHOWN; // of the power 0
  }
  size = factor * glm::dvec3(2.0 * part.Radius, part.Length(), 2.0 * part.Radius);
  rotation = rotation * glm::dquat(std::sqrt(0.5), 0.0, 0.0, -std::sqrt(0.5));
  shift = 0.5 * (part.Begin + part.End) / part.Length();
  return SHOWN;
}

// One of the cones of an uncertain direction, of the largest or of the least length; its apex, at +x, is at the point.
Outcome
TakeCone(int part, const rtglyphs::GlyphTensors::Cone& cone, glm::dvec3& size, glm::dquat& rotation, double& shift)
{
  const double length = part == 0 ? cone.Most : cone.Least;
  size = length * glm::dvec3(1.0, 2.0 * cone.Slopes[0], 2.0 * cone.Slopes[1]);
  rotation = cone.Rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
  shift = -0.5;
  return length > 0.0 ? SHOWN : NOT_SHOWN;
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphMaker::GlyphMaker(vtkPolyData* points, const rtglyphs::GlyphSettings& settings,
  vtkMatrix4x4* modelToWorld, const rtglyphs::GlyphSizes& sizes, std::vector<std::string>& messages)
  : How(settings)
  , Sizes(sizes)
  , Placement(modelToWorld)
  , ChoosesForm(settings.HasTable())
  , OwnExponents(settings.HasOwnExponents())
  , Sphere(settings.Shape == rtg::Shape::Sphere)
  , Pointed(
      settings.Shape == rtg::Shape::Cone || settings.Shape == rtg::Shape::Arrow || settings.Frame == GlyphFrame::Split)
  , AnchorShift(settings.AnchorShift())
  , NumberOfParts(settings.Parts())
  , Positions(points->GetPoints()->GetData())
{
  std::vector<std::string>* const reported = settings.IsAroundVectors() ? nullptr : &messages; // by the arrows
  for (int id = 0; id < rtglyphs::GlyphArrays::NUMBER_OF_IDS; ++id)
  {
    this->Arrays[id] =
      rtglyphs::GlyphArrays::Find(static_cast<rtglyphs::GlyphArrays::Id>(id), points, settings, reported);
  }
  this->OrientationMode =
    rtglyphs::GlyphArrays::OrientationMode(this->Arrays[rtglyphs::GlyphArrays::ORIENTATION], settings);
  this->GoodExponents = this->OwnExponents && MakeExponents(settings.Shape, settings.Exponents, 3, this->SameExponents);

  const bool tensors = sizes.GetTensors() != nullptr, scaledByComponents = sizes.ScalesByComponents();
  const bool sizedByData = sizes.HasScales() || sizes.HasRadii() || tensors || sizes.GetForms() || sizes.IsReduced();
  const glm::dvec3& unit = settings.UnitSize;
  const bool sameSides = unit.x == unit.y && unit.y == unit.z && this->Placement.Uniform;
  this->SameSizes = !sizedByData && sameSides;
  this->OneSize = sameSides &&
    (settings.Frame == GlyphFrame::Cross ||
      (this->NumberOfParts == 1 && !scaledByComponents && !sizes.HasRadii() && !tensors));
  this->Turned = (this->Has(rtglyphs::GlyphArrays::ORIENTATION) || tensors || !this->Placement.Identity) &&
    !(this->IsRound() && this->AnchorShift == 0.0);
  this->Flips = this->Pointed && (scaledByComponents || settings.ScaleFactor < 0.0 || this->Placement.Scale < 0.0);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphMaker::MakeExponents(rtg::Shape shape, const double* tuple, int components, glm::vec3& exponents)
{
  glm::dvec3 e(tuple[0]);
  if (components == 2)
  {
    e = glm::dvec3(tuple[0], tuple[0], tuple[1]);
  }
  else if (components == 3)
  {
    e = glm::make_vec3(tuple);
  }
  const bool nested = shape == rtg::Shape::NestedSuperquadric;
  if (nested)
  {
    // Along z, across; the third is not used.
    e = components > 1 ? glm::dvec3(tuple[0], tuple[1], tuple[1]) : glm::dvec3(tuple[0]);
  }
  if (!rtg::IsPositive(e.x) || !rtg::IsPositive(e.y) || !rtg::IsPositive(e.z))
  {
    return false;
  }
  e = glm::clamp(e, glm::dvec3(0.1), glm::dvec3(100.0));
  exponents = nested ? glm::vec3(2.0 / e.y, 2.0 / e.x, 2.0 / e.x) : glm::vec3(e);
  return true;
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphMaker::MiddleOf(const std::vector<vtkIdType>& points) const
{
  constexpr std::size_t enough = 1000;
  const std::size_t step = std::max<std::size_t>(1, points.size() / enough);
  rtglyphs::GlyphTuples positions(this->Positions);
  std::array<std::vector<double>, 3> coordinates;
  for (std::size_t k = 0; k < points.size(); k += step)
  {
    const glm::dvec3 x = glm::make_vec3(positions.Get(points[k]));
    for (int axis = 0; axis < 3 && rtg::IsFinite(x); ++axis)
    {
      coordinates[axis].push_back(x[axis]);
    }
  }
  if (coordinates[0].empty())
  {
    return glm::dvec3(0.0);
  }
  glm::dvec3 median;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto& values = coordinates[axis];
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    median[axis] = *middle;
  }
  return this->Placement(median);
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphMaker::PlaceOf(vtkIdType point, Tuples& tuples) const
{
  glm::dvec3 place = glm::make_vec3(tuples.Positions.Get(point));
  if (this->How.Frame == GlyphFrame::Tip)
  {
    rtglyphs::GlyphTuples& vectors = tuples[rtglyphs::GlyphArrays::ORIENTATION];
    place += vectors.Has(point) ? this->How.ScaleFactor * glm::make_vec3(vectors.Get(point)) : glm::dvec3(NAN);
  }
  return this->Placement(place);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphMaker::IsOfThisForm(vtkIdType point, Tuples& tuples, Outcome& otherwise) const
{
  if (!this->ChoosesForm)
  {
    return true;
  }
  rtglyphs::GlyphTuples& indices = tuples[rtglyphs::GlyphArrays::TABLE_INDEX];
  const double number = indices.Has(point) ? vtkMath::Norm(indices.Get(point), indices.Size()) : 0.0;
  const int last = this->How.TableSize - 1;
  const bool counts = !std::isnan(number);
  if ((counts ? static_cast<int>(std::min<double>(number, last)) : 0) != this->How.TableEntry)
  {
    otherwise = NOT_SHOWN;
    return false;
  }
  otherwise = FORM;
  return counts;
}

//----------------------------------------------------------------------------
// By the orientation array.
Outcome rtglyphs::GlyphMaker::Turn(vtkIdType point, Tuples& tuples, glm::dquat& rotation) const
{
  rtglyphs::GlyphTuples& orientations = tuples[rtglyphs::GlyphArrays::ORIENTATION];
  if (!orientations.Has(point) || !this->Turned || this->Sizes.GetTensors())
  {
    return SHOWN;
  }
  const double* tuple = orientations.Get(point);
  if (!rtglyphs::GlyphPlacement::RotationFromTuple(tuple, this->OrientationMode, rotation))
  {
    if (vtkMath::Norm(tuple, orientations.Size()) != 0.0)
    {
      return ORIENTATION;
    }
    if (this->Pointed || this->OrientationMode != rtglyphs::GlyphSettings::DIRECTION)
    {
      return ZERO_ORIENTATION;
    }
    rotation = glm::dquat(1.0, 0.0, 0.0, 0.0); // a box at rest is a box
  }
  return SHOWN;
}

//----------------------------------------------------------------------------
Outcome rtglyphs::GlyphMaker::Make(
  vtkIdType point, int part, const glm::dvec3& origin, Tuples& tuples, Glyph& glyph, float* polynomial) const
{
  Outcome outcome = SHOWN;
  if (!this->IsOfThisForm(point, tuples, outcome))
  {
    return outcome;
  }
  const glm::dvec3 place = this->PlaceOf(point, tuples) - origin;
  if (!rtg::IsFinite(glm::vec3(place)))
  {
    return this->How.IsAroundVectors() ? NOT_SHOWN : POSITION; // the vectors' messages name it
  }
  rtglyphs::GlyphSizes::Glyph sized;
  outcome = this->Sizes.Make(point, tuples.Sizes, sized, polynomial);
  glm::dvec3& size = sized.Size;
  glm::dquat& rotation = sized.Rotation;
  if (outcome == SHOWN)
  {
    outcome = this->Turn(point, tuples, rotation);
  }
  if (outcome != SHOWN)
  {
    return outcome;
  }

  if (this->OwnExponents)
  {
    rtglyphs::GlyphTuples& exponents = tuples[rtglyphs::GlyphArrays::EXPONENTS];
    glyph.Exponents = this->SameExponents;
    if (!(exponents.Has(point) ? MakeExponents(this->How.Shape, exponents.Get(point), exponents.Size(), glyph.Exponents)
                               : this->GoodExponents))
    {
      return EXPONENT;
    }
  }

  glyph.Tensor = sized.Tensor;
  glyph.Radius = sized.Radius;
  double shift = this->AnchorShift; // from the point to the center, in lengths of the glyph along this axis
  const int axis = this->How.Frame == GlyphFrame::Split ? 1 : 0;
  rtglyphs::GlyphTuples& vectors = tuples[rtglyphs::GlyphArrays::ORIENTATION];
  if (this->How.Frame == GlyphFrame::Split)
  {
    const double magnitude = vtkMath::Norm(vectors.Get(point), vectors.Size());
    outcome = TakeCylinder(this->How.CylinderOf(magnitude, part), this->How.ScaleFactor, size, rotation, shift);
  }
  else if (this->How.Frame == GlyphFrame::Cones)
  {
    rtglyphs::GlyphTensors::Cone cone;
    outcome = this->Sizes.MakeCone(sized, vectors, point, cone);
    outcome = outcome == SHOWN ? TakeCone(part, cone, size, rotation, shift) : outcome;
  }
  else if (this->How.Frame == GlyphFrame::Cross)
  {
    outcome = TakePart(part, glyph.Tensor, size, rotation, shift);
  }
  if (outcome != SHOWN)
  {
    return outcome;
  }
  this->Placement.Apply(this->Sphere, size, rotation);
  if (this->Flips && size.x < 0.0)
  {
    rotation = rotation * glm::dquat(0.0, 0.0, 0.0, 1.0);
  }
  const glm::vec3 extent(glm::abs(size));
  glyph.Size = this->How.Shape == rtg::Shape::Mesh ? glm::vec3(size) : extent;
  glyph.Turn = this->IsTurned() ? glm::vec4(rotation.x, rotation.y, rotation.z, rotation.w) : NoTurn;
  if (!rtg::IsFinite(extent))
  {
    return SCALE;
  }
  if (!(glyph.SmallestExtent() > 0.0f))
  {
    return ZERO_SCALE;
  }
  glyph.Center = place;
  if (shift != 0.0)
  {
    // By size and rotation as they are kept.
    glm::dvec3 along(0.0);
    along[axis] = shift * glyph.Size[axis];
    glyph.Center += glm::normalize(glm::dquat(glyph.Turn.w, glyph.Turn.x, glyph.Turn.y, glyph.Turn.z)) * along;
  }
  return SHOWN;
}
