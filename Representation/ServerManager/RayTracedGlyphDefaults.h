/**
 * Defaults of the properties of ray-traced glyphs that 3D Glyphs has, too: where neither the user nor a script has set
 * them, a display that is first shown as ray-traced glyphs gets glyphs as large as the data suggest, turned where the
 * data have directions, and spheres where they have none.
 */
#ifndef RayTracedGlyphDefaults_h
#define RayTracedGlyphDefaults_h

#include "RayTracedColoring.h"
#include "RayTracedDefault.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro

#include <set>
#include <string>
#include <vector>

class vtkSMProxy;

namespace rtglyphs
{

class RayTracedGlyphDefaults
{
public:
  /**
   * The display of the glyphs has entered a view, or its representation was changed.
   */
  void Choose(vtkSMProxy* glyphs);

  /**
   * A property of the glyphs was set.
   */
  void Follow(vtkSMProxy* glyphs, const std::string& name);

  /**
   * After an update of the view, before its render, as RayTracedDefault::Renew(). Returns whether another array was
   * chosen.
   */
  bool Renew(vtkSMProxy* glyphs, bool otherTime);

  /**
   * The same, when all is chosen that the color depends on.
   */
  void Color(vtkSMProxy* glyphs, vtkSMProxy* view) { this->Coloring.Update(glyphs, view); }

  static bool ShowsGlyphs(vtkSMProxy* display);

  /**
   * Of a display; null: it has none.
   */
  VTKRAYTRACEDGLYPHS_EXPORT static vtkSMProxy* GlyphsOf(vtkSMProxy* display);

  /**
   * Tubes of the display get the colors of their directions, where nothing colors them, and the radius of the only
   * array of that name: in the window, once, when they are first shown.
   */
  void ChooseTubes(vtkSMProxy* display);

  /**
   * Which arrays the glyphs of a display show, and why, where they are those that the data suggest; and what is to be
   * known of them. Sentences, none where it shows no ray-traced glyphs.
   */
  std::vector<std::string> Explain(vtkSMProxy* display) const;

  /**
   * The panel shows 3D Glyphs' properties at once, and path tracing's material not with Interpolation PBR alone.
   */
  static void ShowInPanel(vtkSMProxy* display);

private:
  using Where = RayTracedDefault::Where;

  bool ChooseArrays(vtkSMProxy* glyphs, Where where);
  void ChooseArray(vtkSMProxy* glyphs, const char* name);
  void ChooseShape(vtkSMProxy* glyphs);
  void ChooseScaleMode(vtkSMProxy* glyphs);

  RayTracedColoring Coloring;
  std::set<std::string> Chosen; // properties that the user or a script has set
  bool Shown = false;           // as ray-traced glyphs
  bool InView = false;          // else the display is being made
  bool Choosing = false;        // by this class
  bool TubesShown = false, TubesWanted = false;
};

} // namespace rtglyphs

#endif
