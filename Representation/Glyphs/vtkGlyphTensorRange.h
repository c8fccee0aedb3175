/**
 * @class   vtkGlyphTensorRange
 * @brief   least and largest number that colors tensor glyphs, over all ranks that have data
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
   * An empty interval (1, -1) where there is no number. All ranks call it at once. What this rank's tensors give is
   * kept while they and the settings are the same.
   */
  std::array<double, 2> Get(vtkPolyData* points, const vtkGlyphTensors::Settings& settings);

private:
  std::array<double, 2> Own{}; // of this rank: the least number, and the negative of the largest
  vtkGlyphTensors::Settings Settings;
  vtkMTimeType Time = 1;
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphTensorRange.h
