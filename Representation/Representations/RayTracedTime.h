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

  /**
   * Whether the points must be gathered anew.
   */
  bool SetVelocityFromPreviousStep(bool on)
  {
    this->Motion.FromPreviousStep = on;
    return this->Steps.SetVelocities(on);
  }

  void SetShutterTimeFromData(bool on);
  double GetShutterTimeGuess() const { return this->ShutterTime; }

  /**
   * The properties, with the shutter time that the data suggest.
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
  bool ShutterTimeFromData = true;
  double ShutterTime = 0.0; // that the data suggest; 0: none
  GlyphKeptGuess ShutterGuess;
};
}

#endif
