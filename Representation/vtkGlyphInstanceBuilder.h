/**
 * @class   vtkGlyphInstanceBuilder
 * @brief   turns points and arrays into the glyph instances that the kernels trace
 *
 * Arrays mean what they mean to vtkGlyph3DMapper: magnitudes of scale arrays of any length, components of arrays of
 * three; orientation by direction (the same half turn, so that also boxes agree), by angles about z, x, y in degrees
 * or by quaternion (w, x, y, z). Positions are made relative to the middle of the data in double precision.
 *
 * Superquadrics have exponents, the same for all or from an array: with one component the same on every axis, with two
 * the first across (x and y) and the second along z, with three one for each axis. In the nested form the first is
 * that along z, the second that across, as blockiness is given in granular matter codes; one component is both.
 *
 * With a table of forms the magnitude of the index array's tuple, cut to a whole number and clamped to the table, is the
 * number of a point's form.
 *
 * A negative scale component mirrors the glyph. That changes nothing about a sphere, box or cylinder; cones and arrows
 * point the other way, as 3D Glyphs shows them; meshes are mirrored.
 *
 * What cannot be shown (an exponent that is not positive; position, scale, direction zero where one is needed, or anything
 * not finite) makes no glyph; it is
 * counted and put into words in Result::Messages.
 */
#ifndef vtkGlyphInstanceBuilder_h
#define vtkGlyphInstanceBuilder_h

#include "Glyphs.h"
#include "vtkGlyphBlockAttributes.h"
#include "vtkGlyphMotion.h"
#include "vtkGlyphTensors.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMatrix4x4;
class vtkPolyData;

class vtkGlyphInstanceBuilder
{
public:
  enum ScaleModes
  {
    MAGNITUDE = 0,
    COMPONENTS = 1
  };
  enum OrientationModes
  {
    DIRECTION = 0,
    ROTATION = 1,
    QUATERNION = 2
  };

  struct Settings
  {
    rtg::Shape Shape = rtg::Shape::Sphere;
    bool Scaling = false;
    std::string ScaleArray; // empty or "None": none
    int ScaleMode = MAGNITUDE;
    double ScaleFactor = 1.0;
    bool Orient = true;
    std::string OrientationArray;
    int OrientationMode = DIRECTION;
    rtg::ArrowForm Arrow; // its unit length is computed
    double ArrowReference =
      0.0; // scale of the arrow whose head has the unit arrow's proportions; 0: the mean
    std::shared_ptr<const rtg::TriangleMesh> Mesh; // for rtg::Shape::Mesh
    /// Of a table of TableSize forms, Mesh is that of number TableEntry: only points that choose it show it.
    int TableSize = 1, TableEntry = 0;
    std::string TableIndexArray; // empty or "None": all points choose entry 0
    vtkGlyphTensors::Settings Tensors; // on: they give size, rotation and exponents
    double Exponents[3] = { 2.0, 2.0, 2.0 }; // of superquadrics; each counts as one in [0.1, 100]
    std::string ExponentArray;               // overrides them; empty or "None": none
    vtkGlyphMotion::Settings Motion;   // on: the glyphs move while the shutter is open
    bool Mask = false;
    vtkIdType MaximumNumberOfGlyphs = 5000;
    int Seed = 1;
  };

  struct Result
  {
    rtg::GlyphInstances Instances;
    std::vector<vtkIdType> Points; // point of each glyph
    vtkIdType Skipped = 0;         // points that could not be shown
    std::vector<std::string> Messages;
  };

  /**
   * The arrows that show the antisymmetric parts of the tensors that glyphs of these settings show: from each glyph's
   * centre along vtkGlyphTensors::Axis, as long as the factors and scales that make a tensor glyph's axis out of an eigenvalue
   * make of the vector's length. Components of a scale array belong to the glyph's own axes and do not count.
   */
  static Settings AxesOf(const Settings& tensorGlyphs);

  /**
   * `blocks` as Resolve()d for `points`; `modelToWorld` may be null.
   */
  static Result Build(vtkPolyData* points, const Settings& settings,
    const vtkGlyphBlockAttributes::Table& blocks, vtkMatrix4x4* modelToWorld);

  /**
   * A box around all glyphs before the actor's transform; cheap, and not tight. Uninitialised when there are none.
   */
  static void ComputeBounds(vtkPolyData* points, const Settings& settings,
    const vtkGlyphBlockAttributes::Table& blocks, double bounds[6]);

  ///@{
  /**
   * The scale of the arrow whose fixed head has the proportions of the unit arrow: as set, else the mean scale over
   * all processes where field data of `points` say it, else that of the glyphs of `points`. Scales of a set of points
   * add up to the mean of several processes.
   */
  struct ScaleSum
  {
    double Sum = 0.0, Count = 0.0;
    double Mean() const
    {
      return this->Count > 0.0 && this->Sum > 0.0 ? this->Sum / this->Count : 1.0;
    }
  };
  static bool NeedsMeanScale(const Settings& settings);
  static ScaleSum SumScales(
    vtkPolyData* points, const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks);
  static double ReferenceScale(
    vtkPolyData* points, const Settings& settings, const vtkGlyphBlockAttributes::Table& blocks);
  static double SharedMeanScale(vtkPolyData* points); // 0: the field data say nothing
  static const char* MeanScaleName() { return "RayTracedGlyphsMeanScale"; }
  ///@}

  ///@{
  /**
   * The arrays that the settings name; null when none is wanted, or it is missing.
   */
  static vtkDataArray* ScaleArray(vtkPolyData* points, const Settings& settings);
  static vtkDataArray* OrientationArray(vtkPolyData* points, const Settings& settings);
  static vtkDataArray* ExponentArray(vtkPolyData* points, const Settings& settings);
  static vtkDataArray* TableIndexArray(vtkPolyData* points, const Settings& settings);
  ///@}
};

#endif
