/**
 * @class   vtkGlyphHighScale
 * @brief   the scale of the arrow whose fixed head has the proportions of the unit arrow
 *
 * It is a high quantile of the scales of all glyphs where the settings name no magnitude, so that hardly an arrow has a
 * head that is too large for it. Heads have one size on all ranks, which ask each other for their scales.
 */
#ifndef vtkGlyphHighScale_h
#define vtkGlyphHighScale_h

#include "vtkGlyphBlockAttributes.h"
#include "vtkGlyphSettings.h"

#include <memory>
#include <vector>

class vtkPolyData;

class vtkGlyphHighScale
{
public:
  vtkGlyphHighScale();
  ~vtkGlyphHighScale();

  /**
   * For vtkGlyphSettings::HighScale; 0 where the settings need none. Blocks as Resolve()d for `points`. Collective: all
   * ranks call it at once. What this rank's points give is kept while they, the settings and the visible blocks are
   * the same.
   */
  double Get(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks,
    bool collective);

  /**
   * The scale as the settings have it: that of ArrowReference, HighScale, or a quantile of these points.
   */
  static double
  Reference(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks);

private:
  vtkGlyphHighScale(const vtkGlyphHighScale&) = delete;
  void operator=(const vtkGlyphHighScale&) = delete;

  struct Histogram;
  static Histogram
  Count(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks);

  struct Known;
  std::unique_ptr<Known> Own; // of this rank
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphHighScale.h
