/**
 * Builds the round cones that the kernels trace from lines and poly-lines.
 *
 * Round cones are those of TubePieces. With covariances as radii each piece is a swept ellipsoid
 * (Kernels/Shapes/SweptEllipsoid.glsl), whose ends are round.
 *
 * Left out and counted are lines without two different points, and pieces with an end whose position, motion or radius
 * is not finite, or whose radius or an eigenvalue of whose covariance is negative, or with radii of zero at both ends.
 */
#ifndef RayTracedTubeBuilder_h
#define RayTracedTubeBuilder_h

#include "RayTracedRanges.h"
#include "GlyphMotion.h"
#include "Glyphs.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMatrix4x4;
class vtkPolyData;

namespace rtglyphs::RayTracedTubeBuilder
{
struct Settings
{
  double Radius = 1.0; // world units
  // Of points, or else of cells, times Radius; covariances times its square; empty or "None": none.
  std::string RadiusArray;
  bool FlatEnds = false; // discs, else half balls
  bool Joined = false;   // no surface is left inside a line, as translucent ones show
  GlyphMotion::Settings Motion;

  bool operator==(const Settings&) const = default;
};

struct Result
{
  rtg::GlyphInstances Instances;
  std::vector<vtkIdType> Cells;               // of each piece
  std::vector<std::array<vtkIdType, 2>> Ends; // points of each piece
  vtkIdType Bad = 0;                          // pieces and lines left out because something is wrong
  vtkIdType Empty = 0;                        // pieces left out because their radii are zero
  std::vector<std::string> Messages;
};

/**
 * The array of radii, and whether it has one for each cell; null where none is named, or none fits.
 */
vtkDataArray* RadiusArray(vtkPolyData* lines, const Settings& settings, bool& ofCells);

/**
 * In the world, relative to the middle of the data. Points that are `hidden` (RayTracedBlocks::GetHidden()) are left
 * out. `modelToWorld` may be null.
 */
Result Build(vtkPolyData* lines, const RayTracedRanges& hidden, vtkMatrix4x4* modelToWorld, const Settings& settings);
}

#endif
