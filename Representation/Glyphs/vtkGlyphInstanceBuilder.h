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
 * With a table of forms the magnitude of the index array's tuple, cut to a whole number and clamped to the table, is
 * the number of a point's form.
 *
 * A negative scale component mirrors the glyph. That changes nothing about a sphere, box or cylinder; cones and arrows
 * point the other way, as 3D Glyphs shows them; meshes are mirrored.
 *
 * What cannot be shown (an exponent that is not positive; position, scale or orientation not finite) makes no glyph; it
 * is counted and put into words in Result::Messages. Zeros are ordinary: scales and tensors of zero, and directions of
 * zero for arrows and cones, make no glyph either, but are put into words only where no glyph is left. Other shapes
 * without a direction are not turned.
 */
#ifndef vtkGlyphInstanceBuilder_h
#define vtkGlyphInstanceBuilder_h

#include "Glyphs.h"
#include "vtkGlyphBlockAttributes.h"
#include "vtkGlyphSettings.h"
#include "vtkRayTracedParallel.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

class vtkGlyphInstanceBuilder
{
public:
  struct Result
  {
    rtg::GlyphInstances Instances;
    std::vector<vtkIdType> Points; // point of each glyph
    std::vector<float> Radii;      // of each polynomial: the |f| that half its size stands for, in units of the array
    vtkIdType Skipped = 0;         // points that could not be shown
    std::vector<std::string> Messages;
    std::string Unfinished; // what must be chosen before there are glyphs; empty: nothing
  };

  /**
   * `blocks` as Resolve()d for `points`; `modelToWorld` may be null.
   */
  static Result Build(vtkPolyData* points, const vtkGlyphSettings& settings,
    const vtkGlyphBlockAttributes::Table& blocks, vtkMatrix4x4* modelToWorld,
    const vtkRayTracedParallel::Progress& progress = {});
};

#endif
