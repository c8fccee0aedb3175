/**
 * Builds the glyph instances that the kernels trace from points and arrays.
 *
 * GlyphMaker makes the glyph of a point. Positions are made relative to the middle of the data in double
 * precision.
 *
 * Bad input (an exponent that is not positive; position, scale or orientation not finite) makes no glyph; it
 * is counted and reported in Result::Messages. Zeros are ordinary: scales and tensors of zero, and directions of
 * zero for arrows and cones, make no glyph either, but are reported only where no glyph is left.
 */
#ifndef GlyphInstanceBuilder_h
#define GlyphInstanceBuilder_h

#include "RayTracedRanges.h"
#include "GlyphSettings.h"
#include "Glyphs.h"
#include "RayTracedParallel.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

namespace rtglyphs::GlyphInstanceBuilder
{
struct Result
{
  rtg::GlyphInstances Instances;
  std::vector<vtkIdType> Points; // point of each glyph
  std::vector<float> Radii;      // of each polynomial: the |f| that half its size stands for, in units of the array
  vtkIdType Skipped = 0;         // points that could not be shown
  std::vector<std::string> Messages;
  std::string MissingInput; // what must be chosen before there are glyphs, or these move; empty: nothing
};

/**
 * Hidden points as RayTracedBlocks has them; `modelToWorld` may be null.
 */
Result Build(vtkPolyData* points, const GlyphSettings& settings, const RayTracedRanges& hidden,
  vtkMatrix4x4* modelToWorld, const RayTracedParallel::Progress& progress);
}

#endif
