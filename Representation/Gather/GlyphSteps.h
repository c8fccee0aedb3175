/**
 * @class   GlyphSteps
 * @brief   earlier time steps of points: their trails, and velocities by differences
 *
 * Trails have the places in the last steps before the one shown. These steps are requested from the pipeline, one after
 * the other, and kept until it changes: a step that is jumped to has the same trails as one that was played to. A trail
 * ends where the next earlier step has no single point of that id, or none of finite position, and where the point
 * crossed a border (GlyphStep::WithoutCrossings()); in a periodic box it goes on to the nearest image.
 *
 * Velocities are v = (x(now) - x(before)) / (t(now) - t(before)), a backward difference of first order. "Before" is the
 * last step of another time that was shown, whichever it was: time may jump and run backwards, and data that come in
 * situ have no earlier steps to request. A point stands still where its id is new, or occurs more than once in one of
 * the steps, where one of the two positions is not finite, where it crossed a border, and in the first step.
 *
 * A step takes 48 bytes a point.
 */
#ifndef GlyphSteps_h
#define GlyphSteps_h

#include "GlyphStep.h"
#include "Glyphs.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;

namespace rtglyphs
{

class GlyphSteps
{
public:
  ///@{
  /**
   * How many earlier steps trails have, 0 for none; whether there are velocities; the array of GlyphStep. Whether the
   * points must be gathered anew.
   */
  bool SetTrailSteps(int steps);
  bool SetVelocities(bool on);
  bool SetPointIdArray(const std::string& name);
  ///@}

  int GetTrailSteps() const { return this->TrailSteps; }

  /**
   * Takes a RayTracedTree that was gathered of `input`, at the pipeline's time, for the step that is shown. `from` has
   * the pipeline's time steps. The earlier times whose points are needed and not known, the first first; on all ranks
   * the same. Each of them is to be kept.
   */
  std::vector<double> Show(vtkDataObject* gathered, vtkDataObject* input, double time, vtkInformation* from,
    vtkAlgorithm* source, bool trails);

  /**
   * Keeps the points of an earlier step. Null: it cannot be read, so trails end after it.
   */
  void Keep(double time, vtkDataObject* gathered);

  /**
   * The tree of Show() once more, after others: a source may give other points the second time.
   */
  void Replace(vtkDataObject* gathered);

  /**
   * Adds RayTracedArrays::Trail, from the last step backwards, NaN where there is none, and StepVelocity to the leaves
   * of the tree of Show(), or of Replace().
   */
  void AddTo(vtkDataObject* gathered, bool trails, const std::function<rtg::PeriodicImages()>& images);

  /**
   * Warnings about the last step that were not returned before, with remedies; or empty.
   */
  std::string TakeMessage() { return std::exchange(this->Message, {}); }

  /**
   * The time between the last two steps; 0: there was one at most.
   */
  double GetStepLength() const;

private:
  struct Step
  {
    double Time;
    GlyphStep Points;
  };
  void Forget();
  std::vector<double> FindMissing(double time, vtkInformation* from, vtkAlgorithm* source);
  void AddTrails(vtkDataObject* gathered, const rtg::PeriodicImages& images) const;
  void AddVelocities(vtkDataObject* gathered);
  void AddMessage(const std::string& message, const std::string& kind);

  int TrailSteps = 0;
  bool Velocities = false;
  std::string PointIdArray;
  vtkWeakPointer<vtkAlgorithm> Source; // whose steps they are
  std::optional<Step> Shown, Before;
  vtkMTimeType SourceTime = 0; // of the pipeline when steps were kept
  std::map<double, GlyphStep> Kept;
  std::vector<double> Earlier; // times before the one shown, the last first
  std::set<std::string> Reported;
  std::string Message;
};

} // namespace rtglyphs

#endif
