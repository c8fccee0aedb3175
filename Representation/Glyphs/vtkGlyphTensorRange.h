/**
 * @class   vtkGlyphTensorRange
 * @brief   least and largest number that colors tensor glyphs, over all ranks
 */
#ifndef vtkGlyphTensorRange_h
#define vtkGlyphTensorRange_h

#include "vtkGlyphTensors.h"
#include "vtkType.h"

#include <array>

class vtkPolyData;

class vtkGlyphTensorRange
{
public:
  /**
   * An empty interval (1, -1) where there is no number. Collective: all ranks call it at once; else it is that of this
   * rank. What this rank's tensors give is kept while they and the settings are the same. `points` may be null.
   */
  std::array<double, 2> Get(vtkPolyData* points, const vtkGlyphTensors::Settings& settings, bool collective);

private:
  std::array<double, 2> Own{}; // of this rank: the least number, and the negative of the largest
  vtkGlyphTensors::Settings Settings;
  vtkMTimeType Time = 1;
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphTensorRange.h
