/**
 * Common code of the builders of instances and bounds: tuples of arrays as double, and which points have a glyph at
 * all.
 */
#ifndef GlyphTuples_h
#define GlyphTuples_h

#include "RayTracedRanges.h"
#include "GlyphSettings.h"
#include "RayTracedBlocks.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

class vtkPolyData;

namespace rtglyphs
{

/**
 * Tuples of a float or double array without a virtual call each; of any other array through its interface. Two
 * components, of data in a plane, are followed by a zero.
 * vtkArrayDispatch would compile the loop over glyphs for every combination of the types of six arrays. Each thread
 * needs one of its own.
 */
class GlyphTuples
{
public:
  explicit GlyphTuples(vtkDataArray* array)
    : Array(array)
    , Float(vtkAOSDataArrayTemplate<float>::FastDownCast(array))
    , Double(vtkAOSDataArrayTemplate<double>::FastDownCast(array))
    , Missing(RayTracedBlocks::MissingTuples(array))
    , Components(array ? array->GetNumberOfComponents() : 0)
  {
  }
  explicit operator bool() const { return this->Array != nullptr; }
  /// Without the array, and in blocks that lack it, a point has no tuple.
  bool Has(vtkIdType i) const { return this->Array && !this->Missing.Has(i); }
  int Size() const { return this->Components; }

  const double* Get(vtkIdType i)
  {
    if (this->Double && this->Components != 2)
    {
      return this->Double->GetPointer(i * this->Components);
    }
    this->Buffer.resize(std::max(this->Components, 3));
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
  const RayTracedRanges& Missing;
  int Components;
  std::vector<double> Buffer;
};

namespace GlyphArrays
{
/**
 * Point arrays that settings name, besides those of tensors and motion, which have classes of their own. Each has one
 * row in the table in GlyphTuples.cxx.
 */
enum Id
{
  SCALE,
  ORIENTATION,
  TABLE_INDEX,
  EXPONENTS,
  OPACITY,
  RADIUS,
  NUMBER_OF_IDS
};

/**
 * The array; null where none is wanted, it is missing, or its tuples have no length that makes sense. What is wrong is
 * appended to `messages` where there are any.
 */
vtkDataArray*
Find(Id id, vtkPolyData* points, const GlyphSettings& settings, std::vector<std::string>* messages = nullptr);

/**
 * The same for any property that names an array of one of these lengths, none for any length; `without`: what happens
 * then.
 */
vtkDataArray* Find(vtkPolyData* points, const std::string& name, const char* property, const std::vector<int>& lengths,
  const char* without, std::vector<std::string>* messages);

/**
 * A point's tuple of the array of opacities as the kernels want it.
 */
float Opacity(GlyphTuples& opacities, vtkIdType point);

/**
 * Why glyphs that need an array have none, with the remedy: it is not chosen, not there, or its number of components is
 * none of the `counts`. Empty: it fits.
 */
std::string Problem(const std::string& name, vtkDataArray* array, bool fits, const std::string& need,
  const std::string& property, const std::string& counts);

/**
 * Reports which blocks lack one of all the arrays that settings name (RayTracedBlocks::ReportMissing).
 */
void ReportMissing(vtkPolyData* points, const GlyphSettings& settings, const RayTracedRanges& hidden,
  std::vector<std::string>& messages);

/**
 * Meaning of the number of components, in every mode: four components are a quaternion, nine a
 * matrix.
 */
int OrientationMode(vtkDataArray* orientations, const GlyphSettings& settings);

/**
 * Where the points were in earlier steps, where the settings want it; else null.
 */
vtkDataArray* Trail(vtkPolyData* points, const GlyphSettings& settings);

/**
 * All arrays that instances of these settings are built from, positions and blocks among them, in a fixed order; null
 * where there is none. Instances are the same as long as these and the settings are.
 */
std::vector<vtkDataArray*> All(vtkPolyData* points, const GlyphSettings& settings);

/**
 * Dependencies of glyphs of all these settings at the same points. Arrays are known by their time stamps, of which no
 * two are alike: data that come again in a new vtkPolyData are recognized.
 */
struct Key
{
  std::vector<GlyphSettings> Settings;
  std::vector<vtkMTimeType> Times;
  RayTracedRanges Hidden;
  bool operator==(const Key&) const = default;
};
Key KeyOf(vtkPolyData* points, std::vector<GlyphSettings> settings, const RayTracedRanges& hidden);

/**
 * The points that are not hidden, thinned out as the mask says, in their own order.
 */
std::vector<vtkIdType> Candidates(vtkPolyData* points, const GlyphScaling& settings, const RayTracedRanges& hidden);
}

} // namespace rtglyphs

#endif
