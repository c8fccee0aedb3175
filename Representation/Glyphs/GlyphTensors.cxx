#include "GlyphTensors.h"

#include "Finite.h"
#include "GlyphTuples.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
using Tensor = rtg::SymmetricTensor;
using Indices = std::vector<std::string>;

struct Known
{
  int Layout; // -1: any
  std::string Names;
};
// As simulation codes write tuples of 3 to 7 and 9 components; of two for the same number the first counts.
const Known known[] = {
  { rtglyphs::GlyphTensors::VTK_ORDER, "xx yy zz xy yz xz" },
  { rtglyphs::GlyphTensors::ROW, "xx xy xz yy yz zz" },
  { rtglyphs::GlyphTensors::LAMMPS, "xx yy zz xy xz yz" },
  { rtglyphs::GlyphTensors::LOWER, "xx xy yy xz yz zz" },
  { rtglyphs::GlyphTensors::VOIGT, "xx yy zz yz xz xy" },
  { rtglyphs::GlyphTensors::MATRIX, "xx xy yx yy" },
  { rtglyphs::GlyphTensors::ROW, "xx xy yy" },
  { rtglyphs::GlyphTensors::LOWER, "xx xy yy" },
  { -1, "xx yy zz xy" },
  { -1, "xx yy xy" },
  { -1, "xx xy xz yy yz" },
  { -1, "-- xx xy xz yy yz zz" },
  { -1, "xx xy xz yx yy yz zx zy zz" },
};

Indices Split(const std::string& names)
{
  Indices indices;
  for (std::size_t i = 0; i < names.size(); i += 3)
  {
    indices.push_back(names.substr(i, 2));
  }
  return indices;
}

// Of 'S-xy', 'S12' and the like: xy. Empty: it is none.
std::string IndexOf(const char* name)
{
  const std::string text = name ? name : "";
  std::string index;
  for (std::size_t i = text.size() < 2 ? text.size() : text.size() - 2; i < text.size(); ++i)
  {
    const std::size_t letter = std::string("xyzXYZ123").find(text[i]);
    index += letter == std::string::npos ? std::string() : std::string(1, "xyz"[letter % 3]);
  }
  return index.size() == 2 ? index : std::string();
}

double Tensor::*PlaceOf(std::string index)
{
  std::sort(index.begin(), index.end());
  return index == "xx" ? &Tensor::xx
    : index == "yy"    ? &Tensor::yy
    : index == "zz"    ? &Tensor::zz
    : index == "xy"    ? &Tensor::xy
    : index == "yz"    ? &Tensor::yz
    : index == "xz"    ? &Tensor::xz
                       : nullptr;
}

// By bisection: where a cumulative distribution, which rises from 0, has this value.
template <typename Distribution>
double Quantile(double high, double share, const Distribution& distribution)
{
  double low = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (distribution(middle) < share ? low : high) = middle;
  }
  return high;
}

// What fraction of a Gaussian lies within so many standard deviations.
double Within(double r)
{
  return std::erf(r / std::sqrt(2.0));
}

// By Cardano's formula: the eigenvalue of the largest magnitude is one of the two at the ends, and well conditioned.
double LargestEigenvalue(const rtg::SymmetricTensor& t)
{
  const double mean = (t.xx + t.yy + t.zz) / 3.0;
  const double a = t.xx - mean, b = t.yy - mean, c = t.zz - mean;
  const double off = t.xy * t.xy + t.yz * t.yz + t.xz * t.xz;
  const double p = std::sqrt((a * a + b * b + c * c + 2.0 * off) / 6.0);
  if (!(p > 0.0))
  {
    return std::abs(mean);
  }
  const double determinant =
    a * (b * c - t.yz * t.yz) - t.xy * (t.xy * c - t.yz * t.xz) + t.xz * (t.xy * t.yz - b * t.xz);
  const double angle = std::acos(std::clamp(0.5 * determinant / (p * p * p), -1.0, 1.0)) / 3.0;
  const double highest = mean + 2.0 * p * std::cos(angle);
  const double lowest = mean + 2.0 * p * std::cos(angle + 2.0943951023931953);
  return std::max(std::abs(highest), std::abs(lowest));
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTensors::Order::Order(vtkDataArray* array, int layout)
{
  const int components = array->GetNumberOfComponents();
  Indices indices;
  for (int i = 0; i < components; ++i)
  {
    indices.push_back(IndexOf(array->GetComponentName(i)));
  }
  if (components == 1 || components > 9 || std::count(indices.begin(), indices.end(), std::string()) > 0)
  {
    const auto found = std::find_if(std::begin(known), std::end(known),
      [&](const Known& one)
      { return static_cast<int>(one.Names.size() + 1) == 3 * components && (one.Layout < 0 || one.Layout == layout); });
    indices = found != std::end(known) ? Split(found->Names) : Indices();
  }
  for (const std::string& index : indices)
  {
    const std::string mirrored(index.rbegin(), index.rend());
    const bool both = index != mirrored && std::find(indices.begin(), indices.end(), mirrored) != indices.end();
    this->Places.push_back({ PlaceOf(index), both ? 0.5 : 1.0 });
  }
}

//----------------------------------------------------------------------------
rtg::SymmetricTensor rtglyphs::GlyphTensors::Order::operator()(const double* tuple) const
{
  rtg::SymmetricTensor tensor;
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    if (this->Places[i].To)
    {
      tensor.*this->Places[i].To += this->Places[i].Weight * tuple[i]; // halved first: huge numbers would overflow
    }
    else if (tuple[i] == 0.0)
    {
      return {};
    }
  }
  if (this->Places.size() == 5 || this->Places.size() == 2)
  {
    const auto isMissing = [this](double Tensor::*place)
    {
      return std::none_of(
        this->Places.begin(), this->Places.end(), [place](const Place& one) { return one.To == place; });
    };
    double Tensor::*const rest = isMissing(&Tensor::xx) ? &Tensor::xx
      : isMissing(&Tensor::yy)                          ? &Tensor::yy
                                                        : &Tensor::zz;
    tensor.*rest = -(tensor.xx + tensor.yy + tensor.zz); // without a trace
  }
  return tensor;
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphTensors::Array(vtkPolyData* points, const Settings& settings)
{
  const bool wanted = settings.On && !rtglyphs::RayTracedArrays::IsNone(settings.Array);
  return wanted ? points->GetPointData()->GetArray(settings.Array.c_str()) : nullptr;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTensors::Settings rtglyphs::GlyphTensors::Settings::Effective() const
{
  const Settings none;
  if (!this->On)
  {
    return none;
  }
  Settings settings = *this;
  settings.Confidence = this->Covariances ? this->Confidence : none.Confidence;
  settings.Coloring = this->ColorsBySign() ? SIGN : NONE;
  settings.PositiveColor = none.PositiveColor;
  settings.NegativeColor = none.NegativeColor;
  if (settings.Axes)
  {
    settings.Kind = none.Kind;
  }
  if (settings.Kind == rtg::TensorGlyphKind::Ellipsoid)
  {
    settings.Sharpness = none.Sharpness;
  }
  return settings;
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphTensors::Problem(vtkDataArray* array, const Settings& settings)
{
  const bool fits = array && Order(array, settings.Layout);
  const bool plane = settings.Layout == MATRIX; // whose layout other tuples do not have
  return rtglyphs::GlyphArrays::Problem(settings.Array, array, fits, "Tensor glyphs need tensors", "GlyphTensorArray",
    !array    ? "6 or 9"
      : plane ? "9, or 4 of a plane, with GlyphTensorLayout Matrix"
              : "6 or 9, 7 with a confidence, 5 without a trace, or 3 or 4 of a plane");
}

//----------------------------------------------------------------------------
rtglyphs::GlyphTensors::GlyphTensors(
  vtkDataArray* array, const Settings& settings, const std::vector<vtkIdType>& points)
  : Tensors(array)
  , How(settings)
  , Read(array, settings.Layout)
  , Radius(settings.Covariances ? RadiusOf(settings.Confidence) : 0.0)
{
  const auto count = static_cast<vtkIdType>(points.size());
  this->Noise = 1e-6 *
    rtglyphs::RayTracedParallel::Largest(count,
      [&](vtkIdType i)
      {
        const rtg::SymmetricTensor tensor = this->Tensor(points[i]);
        return tensor.IsFinite() ? tensor.Largest() : 0.0;
      });
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphTensors::RadiusOf(double confidence)
{
  return Quantile(
    10.0, confidence, [](double r) { return Within(r) - r * std::sqrt(2.0 / vtkMath::Pi()) * std::exp(-0.5 * r * r); });
}

//----------------------------------------------------------------------------
// With the covariance a unit matrix the cone is round, its ellipsoid a ball of radius k at the distance m, sin a = k /
// m, and the integral over the planes across its axis is closed. The half-spaces that hold the ellipsoid make the
// quadratic form mean mean^T - k^2 covariance, which needs no inverse.
bool rtglyphs::GlyphTensors::ConeOf(
  const glm::dvec3& mean, const glm::dvec3& deviations, const glm::dquat& frame, double confidence, Cone& cone)
{
  const double widest = 3.7320508075688776; // tan(75 degrees)
  const glm::dmat3 axes = glm::mat3_cast(frame);
  const double m = glm::length((mean * axes) / deviations);
  const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  const double k = Quantile(std::min(m, 10.0), confidence,
    [&](double r)
    {
      const double cosine = std::sqrt(1.0 - (r / m) * (r / m));
      return below(m) - cosine * std::exp(-0.5 * r * r) * below(m * cosine);
    });
  const glm::dmat3 roots(axes[0] * deviations.x, axes[1] * deviations.y, axes[2] * deviations.z);
  const glm::dmat3 covariance = roots * glm::transpose(roots);
  const glm::dmat3 form = glm::outerProduct(mean, mean) - k * k * covariance;
  if (!(m > 0.0) || !rtg::IsFinite(glm::dvec3(form[0] + form[1] + form[2])))
  {
    return false;
  }
  rtg::Eigensystem eigen = rtg::Decompose({ form[0][0], form[1][1], form[2][2], form[0][1], form[1][2], form[0][2] });
  const glm::dvec3 slopes = glm::sqrt(glm::max(-eigen.values, glm::dvec3(0.0)) / eigen.values.x);
  if (!(eigen.values.x > 0.0) || !(std::max(slopes.y, slopes.z) < widest))
  {
    return false;
  }
  if (glm::dot(eigen.vectors[0], mean) < 0.0)
  {
    eigen.vectors[0] = -eigen.vectors[0];
    eigen.vectors[1] = -eigen.vectors[1];
  }
  cone.Rotation = glm::quat_cast(eigen.vectors);
  cone.Slopes[0] = std::max(slopes.y, 1e-6); // thinner ones are not tested
  cone.Slopes[1] = std::max(slopes.z, 1e-6);
  const double middle = glm::dot(eigen.vectors[0], mean);
  const double reach = Quantile(10.0, confidence, Within) * glm::length(eigen.vectors[0] * roots);
  cone.Least = middle - reach;
  cone.Most = middle + reach;
  return true;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphTensors::Extent(vtkIdType point) const
{
  double extent = 0.0;
  if (this->How.Axes)
  {
    glm::dvec3 axis;
    extent = this->Axis(point, axis) ? std::hypot(axis.x, axis.y, axis.z) : 0.0;
  }
  else
  {
    const rtg::SymmetricTensor t = this->Tensor(point);
    // Relative to the largest component: squares of huge and tiny ones leave the range of numbers.
    const double largest = t.Largest();
    if (rtg::IsPositive(largest))
    {
      const rtg::SymmetricTensor u{ t.xx / largest, t.yy / largest, t.zz / largest, t.xy / largest, t.yz / largest,
        t.xz / largest };
      extent = largest * LargestEigenvalue(u);
      extent = this->How.Covariances ? 2.0 * this->Radius * std::sqrt(extent) : extent;
    }
  }
  return std::isfinite(extent) ? extent : 0.0;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphTensors::Axis(vtkIdType point, glm::dvec3& axis) const
{
  if (this->Tensors->GetNumberOfComponents() != 9)
  {
    return false;
  }
  double matrix[9];
  this->Tensors->GetTuple(point, matrix);
  double largest = 0.0;
  for (double component : matrix)
  {
    if (!std::isfinite(component))
    {
      return false;
    }
    largest = std::max(largest, std::abs(component));
  }
  axis = rtg::AntisymmetricAxis(matrix);
  return rtglyphs::GlyphSizing::Largest(axis) > 1e-6 * largest && std::isfinite(axis.x + axis.y + axis.z);
}

//----------------------------------------------------------------------------
rtg::SymmetricTensor rtglyphs::GlyphTensors::Tensor(vtkIdType point) const
{
  double components[9];
  this->Tensors->GetTuple(point, components);
  return this->Read(components);
}

//----------------------------------------------------------------------------
rtglyphs::GlyphOutcomes::Outcome rtglyphs::GlyphTensors::Glyph(vtkIdType point, rtg::TensorGlyph& glyph) const
{
  constexpr double rounding = 1e-6;
  const rtg::SymmetricTensor tensor = this->Tensor(point);
  if (!tensor.IsFinite() || tensor.IsZero())
  {
    return tensor.IsFinite() ? GlyphOutcomes::ZERO_TENSOR : GlyphOutcomes::TENSOR;
  }
  rtg::Eigensystem eigen = rtg::Decompose(tensor);
  if (this->How.Covariances)
  {
    if (eigen.values.z < -rounding * eigen.values.x)
    {
      return GlyphOutcomes::COVARIANCE;
    }
    eigen.values = 2.0 * this->Radius * glm::sqrt(glm::max(eigen.values, glm::dvec3(0.0)));
  }
  const double thickness = this->How.Covariances ? rtg::thinnestTensorGlyph : 0.02; // of the longest axis
  glyph = rtg::MakeTensorGlyph(eigen, this->How.Kind, this->How.Sharpness, this->Noise, thickness);
  return GlyphOutcomes::SHOWN;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphTensors::Decompose(vtkIdType point, rtg::Eigensystem& eigen) const
{
  const rtg::SymmetricTensor tensor = this->Tensor(point);
  if (!tensor.IsFinite() || tensor.IsZero())
  {
    return false;
  }
  eigen = rtg::Decompose(tensor);
  return true;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphTensors::Number(vtkIdType point, double& value) const
{
  if (this->How.Coloring == TRACE)
  {
    const rtg::SymmetricTensor tensor = this->Tensor(point);
    value = tensor.xx + tensor.yy + tensor.zz;
    return tensor.IsFinite() && !tensor.IsZero();
  }
  rtg::Eigensystem eigen;
  if (!this->Decompose(point, eigen))
  {
    return false;
  }
  const glm::dvec3& values = eigen.values;
  switch (this->How.Coloring)
  {
    case MAJOR_EIGENVALUE:
    case MIDDLE_EIGENVALUE:
    case MINOR_EIGENVALUE:
      value = values[this->How.Coloring - MAJOR_EIGENVALUE];
      return true;
    case EIGENVALUES:
      value = std::max(std::abs(values.x), std::abs(values.z)); // largest first
      return true;
    default:
      value = rtg::FractionalAnisotropy(values);
      return true;
  }
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::GlyphTensors::PrincipalDirection(vtkIdType point) const
{
  rtg::Eigensystem eigen;
  if (!this->Decompose(point, eigen))
  {
    return glm::dvec3(0.0);
  }
  return std::abs(eigen.values.z) > std::abs(eigen.values.x) ? eigen.vectors[2] : eigen.vectors[0];
}
