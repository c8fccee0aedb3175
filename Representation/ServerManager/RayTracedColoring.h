/**
 * The quantity that colors ray-traced glyphs while ColorFromData is on: the one that they show, as ParaView colors
 * volumes and slices at once. In the window it is switched on, but neither where the user or the user's settings have
 * chosen, nor where ParaView has found a quantity to color by.
 */
#ifndef RayTracedColoring_h
#define RayTracedColoring_h

#include <string>

class vtkSMProxy;

namespace rtglyphs
{

class RayTracedColoring
{
public:
  /**
   * The display is shown as ray-traced glyphs for the first time.
   */
  void Begin(vtkSMProxy* glyphs);

  /**
   * ColorArrayName was set; returns whether it names another array than before: paraview.simple sets others of its five
   * strings whenever an input is set.
   */
  bool UpdateColorArray(vtkSMProxy* glyphs);

  /**
   * The user has set a property of the glyphs. Of directions and an array the one that is not `chosen` colors nothing.
   */
  void ClearOther(vtkSMProxy* glyphs, const std::string& chosen);

  /**
   * After an update of the view, before its render.
   */
  void Update(vtkSMProxy* glyphs, vtkSMProxy* view);

private:
  bool Choose(vtkSMProxy* glyphs); // whether that is another color

  bool Wanted = false;   // ColorFromData, in a window
  bool Replaced = false; // an array, whose scalar bar may be of no use
  std::string ColoredBy; // association and name of ColorArrayName
  std::string Shown;     // by the glyphs, when the color was chosen
  bool Ranged = true;    // that had a range then
  bool Begun = false;    // by Begin()
  bool Bytes = false;    // color the display as they are
};

} // namespace rtglyphs

#endif
