/**
 * What the source of 3D Glyphs' GlyphType stands for: a shape of the kernels, where that is exactly what the source
 * approximates by triangles, or its triangles.
 */
#ifndef vtkGlyphSource_h
#define vtkGlyphSource_h

#include "Glyphs.h"

class vtkAlgorithm;
class vtkPolyData;

struct vtkGlyphSource
{
  rtg::Shape Shape = rtg::Shape::Mesh;
  glm::dvec3 UnitSize{ 1.0 }; // in unit glyphs of the shape
  rtg::ArrowForm Arrow;       // radii and length of the tip

  /**
   * That of an arrow, cone, box, cylinder or sphere that lies as the unit glyph does, whatever its resolution. Null:
   * none.
   */
  explicit vtkGlyphSource(vtkAlgorithm* algorithm);

  ///@{
  /**
   * It travels with the triangles (may be null) from the processes that have the source to those that render.
   */
  explicit vtkGlyphSource(vtkPolyData* triangles);
  void StoreIn(vtkPolyData* triangles) const;
  ///@}
};

#endif
// VTK-HeaderTest-Exclude: vtkGlyphSource.h
