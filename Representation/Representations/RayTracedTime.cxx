#include "RayTracedTime.h"

#include "GlyphShutterGuess.h"
#include "RayTracedRanks.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <optional>
#include <utility>

namespace rtglyphs
{

//----------------------------------------------------------------------------
bool RayTracedTime::SetVelocityFromPreviousStep(bool on)
{
  if (std::exchange(this->Motion.FromPreviousStep, on) == on)
  {
    return false;
  }
  this->Velocity.Reset();
  return true;
}

//----------------------------------------------------------------------------
bool RayTracedTime::SetPointIdArray(const std::string& name)
{
  const bool ofVelocity = this->Velocity.SetPointIdArray(name) && this->Motion.FromPreviousStep;
  const bool ofTrail = this->Trail.SetPointIdArray(name) && this->GetTrailSteps() > 0;
  return ofVelocity || ofTrail;
}

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
bool RayTracedTime::AddTrails(vtkDataObject* gathered, vtkDataObject* input, double time, vtkInformation* from,
  vtkAlgorithm* source, const std::function<rtg::PeriodicImages()>& images)
{
  const bool shown = this->GetTrailSteps() > 0;
  if (shown)
  {
    vtkInformation* info = input->GetInformation();
    const double known = info->Has(vtkDataObject::DATA_TIME_STEP()) ? info->Get(vtkDataObject::DATA_TIME_STEP()) : time;
    if (this->Trail.Take(gathered, known, from, source))
    {
      return true;
    }
  }
  this->Trail.AddTo(gathered, shown ? images() : rtg::PeriodicImages());
  return false;
}

//----------------------------------------------------------------------------
// Of all inputs, since those behind the same source get one time.
void RayTracedTime::AskForMissingStep(vtkInformationVector** inputs, int ports) const
{
  const std::optional<double> missing = this->Trail.GetMissing();
  for (int port = 0; missing && port < ports; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      inputs[port]->GetInformationObject(i)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), *missing);
    }
  }
}

//----------------------------------------------------------------------------
void RayTracedTime::AddVelocities(vtkDataObject* gathered, vtkDataObject* input, vtkAlgorithm* source)
{
  if (this->Motion.FromPreviousStep)
  {
    this->Velocity.AddTo(gathered, input, source);
  }
}

//----------------------------------------------------------------------------
std::string RayTracedTime::TakeMessage()
{
  const std::string ofTrail = this->Trail.TakeMessage();
  const std::string ofVelocity = this->Motion.FromPreviousStep ? this->Velocity.TakeMessage() : std::string();
  return ofTrail.empty() || ofVelocity.empty() ? ofTrail + ofVelocity : ofTrail + ' ' + ofVelocity;
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
    this->ShutterTime = RayTracedRanks::Largest(this->Velocity.GetStepLength());
    return;
  }
  double unitSize = 1.0;
  const GlyphSettings settings = sizes(unitSize);
  this->ShutterTime = GlyphShutterGuess::Update(this->ShutterGuess, points, settings, unitSize, time);
}

} // namespace rtglyphs
