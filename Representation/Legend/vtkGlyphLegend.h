/**
 * @class   vtkGlyphLegend
 * @brief   a glyph of a stated number in the corner of a view, from which sizes can be read
 *
 * The glyph is the silhouette of an upright one whose every scale, or eigenvalue, is the number that stands beside it.
 * It is as large as it would be at the center of rotation, with parallel projection as everywhere. Unless a number is
 * set it is the largest of 1, 2, 5 times a power of ten whose glyph is at most a fifth of the view's shorter side, that
 * no limit of sizes changes and that the data reach; so it follows the zoom as the bar of a map's scale does.
 */
#ifndef vtkGlyphLegend_h
#define vtkGlyphLegend_h

#include "GlyphSettings.h"
#include "vtkRayTracedLegend.h"

#include <array>
#include <string>

class vtkGlyphLegend : public vtkRayTracedLegend
{
public:
  static vtkGlyphLegend* New();
  vtkTypeMacro(vtkGlyphLegend, vtkRayTracedLegend);

  /**
   * The legend's subject: glyphs of these settings, `scale` times as large; name of the array that scales them, or
   * none; width and height of the mesh of mesh glyphs, for which the legend shows a rectangle; the largest magnitude of
   * the data (0: unknown), which a number that is chosen does not exceed.
   */
  void SetGlyphs(const rtglyphs::GlyphSettings& settings, double scale, const std::string& name,
    const std::array<double, 2>& mesh, double largest);

  /**
   * The number; 0: one that fits.
   */
  void SetValue(double value) { this->Value = value; }

protected:
  vtkGlyphLegend() = default;
  ~vtkGlyphLegend() override = default;

  bool Draw(vtkViewport* viewport, vtkBoundingBox& box) override;

private:
  /**
   * World size of the unit glyph scaled by that number, before the representation's own scale; negative: a limit has
   * changed it.
   */
  double Extent(double number) const;
  double PixelsPerLength(vtkViewport* viewport) const;
  double ChooseNumber(double pixelsPerLength, double most) const;
  rtg::GlyphInstances MakeGlyphs(double number, double size, double unit) const;

  rtglyphs::GlyphSettings Settings;
  double Scale = 1.0;
  std::array<double, 2> Mesh{};
  double Largest = 0.0;
  std::string Name;
  double Value = 0.0;
};

#endif
