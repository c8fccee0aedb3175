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
   * The display has entered a view: what it is colored by now ParaView has chosen.
   */
  void Enter(vtkSMProxy* glyphs);

  /**
   * The display is shown as ray-traced glyphs for the first time.
   */
  void Begin(vtkSMProxy* glyphs);

  /**
   * A property of the glyphs was set. Whether that chooses a color; of directions and an array the one chosen before is
   * taken back. Of its five strings ColorArrayName gets others by paraview.simple alone, whenever an input is set.
   */
  bool Follow(vtkSMProxy* glyphs, const std::string& name);

  /**
   * After an update of the view, before its render.
   */
  void Update(vtkSMProxy* glyphs, vtkSMProxy* view);

private:
  void TakeBack(vtkSMProxy* glyphs, const std::string& chosen);
  void FollowBytes(vtkSMProxy* glyphs, bool window);

  bool Wanted = false;   // ColorFromData, in a window
  bool Choosing = false; // by this class
  bool Replaced = false; // an array, whose scalar bar may be of no use
  std::string Chosen;    // association and name of ColorArrayName
  std::string Shown;     // by the glyphs, when the color was chosen
  bool Ranged = true;    // that had a range then
  bool Begun = false;    // by Begin()
  bool Bytes = false;    // color the display as they are
};

} // namespace rtglyphs

#endif
