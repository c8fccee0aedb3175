#include "RayTracedTime.h"

#include "GlyphShutterGuess.h"
#include "RayTracedArrays.h"
#include "RayTracedRanks.h"

namespace rtglyphs
{

//----------------------------------------------------------------------------
void RayTracedTime::SetShutterTime(double time)
{
  this->Motion.ShutterTime = time;
  this->Kept.Forget();
}

//----------------------------------------------------------------------------
GlyphMotion::Settings RayTracedTime::GetMotion() const
{
  GlyphMotion::Settings motion = this->Motion;
  if (motion.ShutterTime == 0.0)
  {
    motion.ShutterTime = this->ShutterGuess > 0.0 ? this->ShutterGuess : 1.0; // while nothing moves any will do
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
  if (this->Motion.ShutterTime != 0.0 || !this->Motion.On)
  {
    return;
  }
  if (this->Motion.Velocity == RayTracedArrays::StepVelocity)
  {
    this->ShutterGuess = RayTracedRanks::Largest(this->Steps.GetStepLength());
    return;
  }
  double unitSize = 1.0;
  const GlyphSettings settings = sizes(unitSize);
  this->ShutterGuess = GlyphShutterGuess::Update(this->Kept, points, settings, unitSize, time);
}

} // namespace rtglyphs
