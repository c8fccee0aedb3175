/**
 * @class   vtkGlyphHighScale
 * @brief   the scale of the arrow whose fixed head has the proportions of the unit arrow
 *
 * It is a high quantile of the scales of all glyphs where the settings name no magnitude, so that hardly an arrow has a
 * head that is too large for it. Heads have one size on all ranks.
 */
#ifndef vtkGlyphHighScale_h
#define vtkGlyphHighScale_h

#include "vtkGlyphBlockAttributes.h"
#include "vtkGlyphTuples.h"
#include "vtkRayTracedCache.h"

#include <vector>

class vtkPolyData;

class vtkGlyphHighScale
{
public:
  /**
   * For vtkGlyphSettings::HighScale; 0 where the settings need none. Blocks as Resolve()d for `points`. All ranks that
   * have data call it at once. Scales are counted where points, settings or visible blocks have changed, and ranks
   * exchange their counts where those of one have.
   */
  double Get(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks);

private:
  // How many glyphs have about which scale, and the largest of these.
  struct Histogram
  {
    std::vector<double> Counts = std::vector<double>(1 << 14), Largest = Counts;

    void Add(double scale);
    void Add(const Histogram& other);
    double High() const;
  };
  static Histogram
  Count(vtkPolyData* points, const vtkGlyphSettings& settings, const vtkGlyphBlockAttributes::Table& blocks);

  vtkRayTracedCache<vtkGlyphArrays::Key> Known;
  Histogram Own; // of this rank
  double High = 1.0;
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphHighScale.h
