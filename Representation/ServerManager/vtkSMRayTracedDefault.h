/**
 * Defaults of this plugin's properties, which every display of a data set has, whatever it is shown as. ParaView fills
 * in values that fit the data, and would then name these properties in the trace and the Python state of any display:
 * scripts that do not run without this plugin. So on displays that show nothing ray traced a property whose value
 * ParaView itself has chosen counts as one that has its default.
 */
#ifndef vtkSMRayTracedDefault_h
#define vtkSMRayTracedDefault_h

#include "vtkSmartPointer.h"

class vtkSMProperty;

struct vtkSMRayTracedDefault
{
  /**
   * Whether the display that a property belongs to shows something ray traced.
   */
  static bool IsShown(vtkSMProperty* property);

  /**
   * Whether a property is but another name of one of ParaView's own, as PathMetallic is of Metallic. That one is named.
   */
  static bool IsAlias(vtkSMProperty* property);

  /**
   * To be called when the domains have been asked for a value that fits the data, with their answer, which is returned.
   * Where there are no data, as when ParaView resets all properties of a display, the input first, the property gets
   * the value that was chosen before.
   */
  bool Take(vtkSMProperty* property, bool chosen);

  /**
   * Whether ParaView has chosen the present value, or would choose it now.
   */
  bool Has(vtkSMProperty* property) const;

  /**
   * Whether the present value is the one that ParaView has chosen.
   */
  bool IsChosen(vtkSMProperty* property) const;

  /**
   * Chooses anew where ParaView has chosen: if `lost`, only a value that is in no list of values any more, or None.
   */
  void Renew(vtkSMProperty* property, bool lost) const;

private:
  vtkSmartPointer<vtkSMProperty> Chosen; // null: none yet, as in a display of a state file
};

#endif
// VTK-HeaderTest-Exclude: vtkSMRayTracedDefault.h
