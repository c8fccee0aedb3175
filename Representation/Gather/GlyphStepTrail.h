/**
 * @class   GlyphStepTrail
 * @brief   where points were in the last time steps before the one shown
 *
 * The steps are requested from the pipeline, one after the other, and kept until it changes: a step that is jumped to
 * has the same trails as one that was played to. Steps that have been shown or requested before are not requested
 * again. Keeping them takes 48 bytes a point and step.
 *
 * A trail ends where the next earlier step has no single point of that id, or none of finite position, and where the
 * point crossed a border (GlyphStep::WithoutCrossings()); in a periodic box it goes on to the nearest image.
 */
#ifndef GlyphStepTrail_h
#define GlyphStepTrail_h

#include "GlyphStep.h"
#include "Glyphs.h"
#include "RayTracedArrays.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;

namespace rtglyphs
{

class GlyphStepTrail
{
public:
  ///@{
  /**
   * How many earlier steps, 0 for none, and the array of GlyphStep. Whether it is another than before.
   */
  bool SetSteps(int steps);
  bool SetPointIdArray(const std::string& name);
  ///@}

  int GetSteps() const { return this->Steps; }

  /**
   * What the pipeline gave, gathered: of the time shown or, while steps are missing, of GetMissing(). `from` has the
   * pipeline's time steps. True: the pipeline must be updated again, for GetMissing() or, if that is nothing, for the
   * time shown. All ranks do it at once.
   */
  bool Take(vtkDataObject* gathered, double time, vtkInformation* from, vtkAlgorithm* source);
  std::optional<double> GetMissing() const;

  /**
   * Adds the point array RayTracedArrays::Trail to the leaves of the last RayTracedTree that was taken: positions, from
   * the last step backwards, NaN where there is none. Takes it away where there is no earlier step.
   */
  void AddTo(vtkDataObject* gathered, const rtg::PeriodicImages& images) const;

  /**
   * The message about the last step, with a remedy; empty when the same message comes again.
   */
  std::string TakeMessage();

  /**
   * Nothing is missing any more: taking steps has failed.
   */
  void GiveUp() { this->Missing.clear(); }

private:
  void Forget();
  void FindMissing(double time, vtkInformation* from);

  int Steps = 0;
  std::string PointIdArray;
  vtkWeakPointer<vtkAlgorithm> Source; // whose steps they are
  vtkMTimeType SourceTime = 0;         // of the pipeline as it was then
  std::map<double, GlyphStep> Kept;
  GlyphStep Shown;
  std::vector<double> Earlier; // times before the one shown, the last first
  std::vector<double> Missing; // the last is requested
  bool Returns = false;        // the time shown is requested again
  std::string Problem, Said;
};

} // namespace rtglyphs

#endif
