/**
 * Motion of a display by its properties and by earlier time steps of its data: velocities, trails, and how long
 * the shutter is open.
 */
#ifndef RayTracedTime_h
#define RayTracedTime_h

#include "GlyphKeptGuess.h"
#include "GlyphMotion.h"
#include "GlyphSteps.h"

#include <functional>

class vtkPolyData;

namespace rtglyphs
{
class RayTracedTime
{
public:
  GlyphMotion::Settings Motion; // as the properties say
  GlyphSteps Steps;
  double ShutterGuess = 0.0; // the shutter time that the data suggest; 0: none

  /**
   * 0: as the data suggest, from now on.
   */
  void SetShutterTime(double time);

  /**
   * The properties, with that shutter time.
   */
  GlyphMotion::Settings GetMotion() const;

  /**
   * The same of points of lines and surfaces, which do not rotate; with all that has no effect at its default.
   */
  GlyphMotion::Settings GetMotionOfPoints() const;

  /**
   * On all ranks that have data at once. `sizes` of the points, of a unit glyph of some length, are asked for where
   * they matter.
   */
  void UpdateShutterTime(vtkPolyData* points, const std::function<GlyphSettings(double& unitSize)>& sizes, double time);

private:
  GlyphKeptGuess Kept;
};
}

#endif
