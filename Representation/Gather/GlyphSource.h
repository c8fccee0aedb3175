/**
 * The kernels' shape of 3D Glyphs' GlyphType: a shape of the kernels, where that is exactly what the source
 * approximates by triangles, or its triangles.
 */
#ifndef GlyphSource_h
#define GlyphSource_h

#include "Glyphs.h"

class vtkAlgorithm;
class vtkPolyData;

namespace rtglyphs
{

struct GlyphSource
{
  rtg::Shape Shape = rtg::Shape::Mesh;
  glm::dvec3 UnitSize{ 1.0 }; // in unit glyphs of the shape
  rtg::ArrowForm Arrow;       // radii and length of the tip

  /**
   * That of an arrow, cone, box, cylinder or sphere that lies as the unit glyph does, at any resolution. Null:
   * none.
   */
  explicit GlyphSource(vtkAlgorithm* algorithm);

  ///@{
  /**
   * It travels with the triangles (may be null) from the processes that have the source to those that render.
   */
  explicit GlyphSource(vtkPolyData* triangles);
  void StoreIn(vtkPolyData* triangles) const;
  ///@}
};

} // namespace rtglyphs

#endif
