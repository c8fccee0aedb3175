/**
 * @class   GlyphStepVelocity
 * @brief   velocities of points by differences to the previously shown time step
 *
 * For data without an array of velocities: v = (x(now) - x(before)) / (t(now) - t(before)), a backward difference of
 * first order, of the points that have the same id in both steps. "Before" is the last step of another time that this
 * object was given, whichever it was, so that time may jump and run backwards; its positions are kept, 48 bytes a
 * point.
 *
 * A point without a partner stands still: its id is new, or occurs more than once in one of the steps, or one of
 * the two positions is not finite. So do all in the first step, and those that
 * cross a border (GlyphStep::WithoutCrossings()).
 */
#ifndef GlyphStepVelocity_h
#define GlyphStepVelocity_h

#include "GlyphStep.h"
#include "RayTracedArrays.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace rtglyphs
{

class GlyphStepVelocity
{
public:
  /**
   * The point array of one component that identifies points; "None" or empty: the global ids. Whether it is
   * another than before, which forgets all steps.
   */
  bool SetPointIdArray(const std::string& name);

  /**
   * Adds the point array Name() to the leaves of the RayTracedTree `gathered`, made of `input`. Without ids or
   * times, all points stand still. Steps of another source than the last are forgotten.
   */
  void AddTo(vtkDataObject* gathered, vtkDataObject* input, vtkAlgorithm* source);

  /**
   * A message on the last step, with a remedy; empty the second time that the same comes since Reset().
   */
  std::string TakeMessage();

  /**
   * The time between the last two steps; 0: there was one at most.
   */
  double GetStepLength() const;

  /**
   * Forgets all steps.
   */
  void Reset();

  static const char* Name() { return RayTracedArrays::StepVelocity; }

private:
  enum Outcomes
  {
    FOUND = 0,  // all points have a velocity, or this is the first step
    NO_IDS = 1, // the other outcomes: all or some stand still
    NO_TIME = 2,
    WITHOUT_PARTNER = 3
  };

  struct Step
  {
    bool Seen = false;
    double Time = 0.0;
    GlyphStep Points;
  };
  void Follow(vtkDataObject* gathered, double time);
  std::string Describe() const;

  std::string PointIdArray;
  vtkWeakPointer<vtkAlgorithm> Source; // whose steps they are
  Step Now, Before;
  Outcomes Outcome = FOUND;
  std::array<bool, WITHOUT_PARTNER + 1> Said{};
  vtkIdType Points = 0;
  vtkIdType WithoutPartner = 0;
};

} // namespace rtglyphs

#endif
