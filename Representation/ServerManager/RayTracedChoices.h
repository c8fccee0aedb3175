/**
 * @class   RayTracedChoices
 * @brief   who has chosen the value of each property of a display: nobody yet, the plugin from the data, or the user
 *
 * What neither the user, nor a script, nor a state has set is the plugin's: arrays, places and sizes come from the
 * properties' domains, numbers from DataSummary, colors from RayTracedColoring. Values are chosen when the display is
 * first shown as something ray traced, and anew when the data no longer have them, or have them for the first time.
 *
 * There is one for each display. A change of a property inside of a Scope is the plugin's, outside the user's.
 */
#ifndef RayTracedChoices_h
#define RayTracedChoices_h

#include "RayTracedColoring.h"
#include "RayTracedTensorTable.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro

#include <map>
#include <string>

class vtkSMProperty;
class vtkSMProxy;

namespace rtglyphs
{

class RayTracedChoices
{
public:
  ///@{
  /**
   * What is set meanwhile is set by the plugin, or by ParaView's defaults.
   */
  struct Scope
  {
    Scope();
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
  };
  VTKRAYTRACEDGLYPHS_EXPORT static bool IsChoosing();
  ///@}

  /**
   * Those of a property's proxy; null: it is none of a ray-traced representation.
   */
  static RayTracedChoices* Of(vtkSMProperty* property);

  bool IsUsers(const std::string& name) const { return this->Is(name, USER); }

  /**
   * Whether nobody has decided what the glyphs look like: neither the user, nor data that have something to show.
   */
  bool WaitsForData() const
  {
    return this->WaitsForForm && !this->IsUsers("GlyphType") && !this->IsUsers("GlyphShape");
  }

  ///@{
  /**
   * Whether a property of a ray-traced representation has a value of the plugin that counts as its default. Every
   * display of a data set has these properties, in every representation, and ParaView would name them in the trace and
   * the state of any display: scripts that do not run without this plugin. So, on displays that show nothing ray
   * traced, do all values that the plugin has chosen; and, on all displays, numbers that follow the data.
   */
  static bool IsDefault(vtkSMProperty* property);

  /**
   * It has got the default that its domains have found, or else that of the XML.
   */
  static void Reset(vtkSMProperty* property, bool found);
  ///@}

  ///@{
  /**
   * Before observers know that a property of the representation is set, so that undoing both ends with the data's:
   * returns whether the user sets it. And after that: other properties depend on it.
   */
  bool PropertyChanging(vtkSMProxy* glyphs, const std::string& name);
  void PropertyChanged(vtkSMProxy* glyphs, const std::string& name, bool byUser);
  ///@}

  /**
   * The display has entered a view, or its representation was changed.
   */
  void Choose(vtkSMProxy* glyphs);

  /**
   * After an update of the view, before its render: what the data shown before had nothing for, these may have, as the
   * first time step with particles has arrays. While time goes on a value that was found stays; other data may have
   * others. Returns whether something was chosen anew.
   */
  bool Renew(vtkSMProxy* glyphs, bool otherTime);

  /**
   * The same, of what depends on the data's values. A display that is not visible has no scalar bar any more.
   */
  void Update(vtkSMProxy* glyphs, vtkSMProxy* view, bool visible);

  ///@{
  /**
   * State of a display: its ray-traced representation (null: none), whether it shows that as glyphs, as a surface, or
   * as anything ray traced, and whether it is one of ParaView's window; scripts set what they need.
   */
  VTKRAYTRACEDGLYPHS_EXPORT static vtkSMProxy* GlyphsOf(vtkSMProxy* display);
  VTKRAYTRACEDGLYPHS_EXPORT static bool ShowsGlyphs(vtkSMProxy* display);
  static bool ShowsSurface(vtkSMProxy* display);
  VTKRAYTRACEDGLYPHS_EXPORT static bool ShowsRayTraced(vtkSMProxy* display);
  static bool IsInWindow(vtkSMProxy* display);
  ///@}

private:
  enum By
  {
    NOBODY,
    PLUGIN,
    USER
  };
  // Values that Renew() chooses anew, unless they are the user's.
  enum class Renewed
  {
    All,
    Invalid, // arrays that are in no list of arrays any more, and what Unset names
    Unset    // None, and what stands in the XML, where the data had nothing to choose
  };

  bool Is(const std::string& name, By by) const;
  bool Renew(vtkSMProxy* glyphs, const std::string& name, Renewed which);
  bool RenewAll(vtkSMProxy* glyphs, Renewed which);
  bool RenewRadius(vtkSMProxy* glyphs);
  bool ChooseForm(vtkSMProxy* glyphs);
  void ChooseArrays(vtkSMProxy* glyphs);
  void ChooseShape(vtkSMProxy* glyphs);
  void ChooseScaleMode(vtkSMProxy* glyphs);
  void ChooseTubes(vtkSMProxy* display);
  static void PullNumbers(vtkSMProxy* glyphs);

  std::map<std::string, By> Chosen; // by name
  RayTracedColoring Coloring;
  RayTracedTensorTable TensorTable;
  bool Shown = false;       // as ray-traced glyphs
  bool WaitsForForm = true; // for data that have something to show
  bool InView = false;      // else the display is being made
  bool TubesShown = false, TubesWanted = false;
};

} // namespace rtglyphs

#endif
