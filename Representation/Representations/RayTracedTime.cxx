#include "RayTracedTime.h"

#include "GlyphShutterGuess.h"
#include "RayTracedRanks.h"

namespace rtglyphs
{

//----------------------------------------------------------------------------
void RayTracedTime::SetShutterTimeFromData(bool on)
{
  this->ShutterTimeFromData = on;
  this->ShutterGuess.Forget();
  this->ShutterTime = 0.0;
}

//----------------------------------------------------------------------------
GlyphMotion::Settings RayTracedTime::GetMotion() const
{
  GlyphMotion::Settings motion = this->Motion;
  if (this->ShutterTimeFromData)
  {
    // While nothing moves any will do.
    const double known = this->ShutterTime > 0.0 ? this->ShutterTime : motion.ShutterTime;
    motion.ShutterTime = known > 0.0 ? known : 1.0;
  }
  return motion;
}

//----------------------------------------------------------------------------
GlyphMotion::Settings RayTracedTime::GetMotionOfPoints() const
{
  GlyphMotion::Settings motion = this->GetMotion();
  motion.AngularVelocity.clear();
  return motion.Effective();
}

//----------------------------------------------------------------------------
// After the sizes of the points are known, and before their bounds.
void RayTracedTime::UpdateShutterTime(
  vtkPolyData* points, const std::function<GlyphSettings(double& unitSize)>& sizes, double time)
{
  if (!this->ShutterTimeFromData || !this->Motion.On)
  {
    return;
  }
  if (this->Motion.FromPreviousStep)
  {
    this->ShutterTime = RayTracedRanks::Largest(this->Steps.GetStepLength());
    return;
  }
  double unitSize = 1.0;
  const GlyphSettings settings = sizes(unitSize);
  this->ShutterTime = GlyphShutterGuess::Update(this->ShutterGuess, points, settings, unitSize, time);
}

} // namespace rtglyphs
