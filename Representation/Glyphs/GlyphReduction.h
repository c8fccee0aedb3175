/**
 * Fewer glyphs that stand for many small ones, for frames that must come at once.
 *
 * A grid over the data joins in each of its cells all points of a block whose glyphs are smaller than the cell. What
 * stands for them is one of them, chosen by chance: it has their mean vectors, tensors and numbers, its own place, id
 * and whole numbers, and a glyph as large as the area that they cover, if they lie in the cell by chance (Cook,
 * Halstead, Planck and Ryu, "Stochastic simplification of aggregate detail", ACM TOG 26(3), 2007). Number times mean,
 * summed over the points that are left, is the sum over all.
 */
#ifndef GlyphReduction_h
#define GlyphReduction_h

#include "GlyphTuples.h"
#include "RayTracedCache.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <tuple>

namespace rtglyphs
{

class GlyphReduction
{
public:
  /**
   * `blocks` are those of `tree`, `cell` is the side of the grid's cells. Null: the points would hardly be fewer.
   */
  vtkDataObject* Get(vtkDataObject* tree, const RayTracedBlocks& blocks, const GlyphSettings& settings, double cell);

  /**
   * Those of the glyphs that are left.
   */
  static GlyphSettings SettingsFor(GlyphSettings settings);

private:
  RayTracedCache<std::tuple<GlyphArrays::Key, std::uint64_t, double>> Known; // blocks have a version
  vtkSmartPointer<vtkDataObject> Reduced;
};

} // namespace rtglyphs

#endif
