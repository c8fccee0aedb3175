/**
 * Which points carry glyphs, where there are too many for all.
 */
#ifndef GlyphMask_h
#define GlyphMask_h

#include "RayTracedNumbers.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace rtglyphs
{

struct GlyphMask
{
  enum Modes
  {
    RANDOM = 0,
    EVERY_NTH = 1,
    EVEN_IN_SPACE = 2
  };
  bool On = false;
  RayTracedEnum<Modes, RANDOM, EVEN_IN_SPACE> Mode;
  vtkIdType MaximumNumberOfGlyphs = 5000; // of RANDOM and EVEN_IN_SPACE
  int Stride = 10;                        // of EVERY_NTH
  // Of all ranks together, where each has some of the points: it has that fraction of MaximumNumberOfGlyphs. Not more
  // than its own: it has all.
  vtkIdType PointsOfAllRanks = 0;

  bool operator==(const GlyphMask&) const = default;

  /**
   * The same mask with all that has no effect set to its default.
   */
  GlyphMask Effective() const;

  /**
   * Those of the candidates that are left, in their order.
   *
   * RANDOM: at most MaximumNumberOfGlyphs. Which ones depends on the points' numbers, so they are the same at each time
   * step.
   *
   * EVERY_NTH: those whose number is a multiple of Stride.
   *
   * EVEN_IN_SPACE: at most MaximumNumberOfGlyphs, as far as possible one in each of the boxes of equal size and shape
   * into which halving the data's bounding cube again and again divides it: with so many boxes that hold points that
   * one more halving would make them more than the maximum. What is left of the maximum goes to the halves of boxes,
   * at random, as is the choice in each box.
   *
   * Those of a smaller maximum are among those of a larger one.
   */
  std::vector<vtkIdType> Choose(vtkPolyData* points, std::vector<vtkIdType> candidates) const;
};

} // namespace rtglyphs

#endif
