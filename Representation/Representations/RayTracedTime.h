/**
 * How a display moves, as its properties say and earlier time steps of its data tell: velocities, trails, and how long
 * the shutter is open.
 */
#ifndef RayTracedTime_h
#define RayTracedTime_h

#include "GlyphKeptGuess.h"
#include "GlyphMotion.h"
#include "GlyphStepTrail.h"
#include "GlyphStepVelocity.h"
#include "Glyphs.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace rtglyphs
{
class RayTracedTime
{
public:
  GlyphMotion::Settings Motion; // as the properties say

  ///@{
  /**
   * Whether the points must be gathered anew.
   */
  bool SetVelocityFromPreviousStep(bool on);
  bool SetPointIdArray(const std::string& name);
  bool SetTrailSteps(int steps) { return this->Trail.SetSteps(steps); }
  ///@}

  void SetShutterTimeFromData(bool on);
  double GetShutterTimeGuess() const { return this->ShutterTime; }
  int GetTrailSteps() const { return this->Trail.GetSteps(); }

  /**
   * The properties, with the shutter time that the data suggest.
   */
  GlyphMotion::Settings GetMotion() const;

  ///@{
  /**
   * Adds earlier places of the points to what is gathered of `input`. True: the pipeline must first be
   * updated for the step that is missing, which AskForMissingStep() sets as the time of all inputs. GiveUp() where
   * gathering has failed.
   */
  bool AddTrails(vtkDataObject* gathered, vtkDataObject* input, double time, vtkInformation* from, vtkAlgorithm* source,
    const std::function<rtg::PeriodicImages()>& images);
  void AskForMissingStep(vtkInformationVector** inputs, int ports) const;
  void GiveUp() { this->Trail.GiveUp(); }
  ///@}

  /**
   * Adds velocities where they are those since the previous step. Where the data are, and not where they are rendered:
   * what is delivered may come from ParaView's cache of time steps.
   */
  void AddVelocities(vtkDataObject* gathered, vtkDataObject* input, vtkAlgorithm* source);

  /**
   * What is to be said of the last step, with a remedy; else empty.
   */
  std::string TakeMessage();

  /**
   * On all ranks that have data at once. `sizes` of the points, of a unit glyph of some length, are asked for where
   * they matter.
   */
  void UpdateShutterTime(vtkPolyData* points, const std::function<GlyphSettings(double& unitSize)>& sizes, double time);

private:
  GlyphStepVelocity Velocity;
  GlyphStepTrail Trail;
  bool ShutterTimeFromData = true;
  double ShutterTime = 0.0; // that the data suggest; 0: none
  GlyphKeptGuess ShutterGuess;
};
}

#endif
