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
   * To be called when the domains have been asked for a value that fits the data, with their answer, which is returned.
   * Where there are no data, as when ParaView resets all properties of a display, the input first, the property gets
   * the value that was chosen before; the default of the XML, while there is none, counts as chosen by ParaView.
   */
  bool Take(vtkSMProperty* property, bool chosen);

  /**
   * To be called when the property is modified. What is not followed by Take() is a choice of the user or of a script.
   */
  void Modify() { this->ByUser = true; }

  /**
   * Whether ParaView has chosen the present value, or would choose it now.
   */
  bool Has(vtkSMProperty* property) const;

  /**
   * Whether the present value is the one that ParaView has chosen.
   */
  bool IsChosen(vtkSMProperty* property) const;

  enum class Where
  {
    Everywhere,
    Lost,   // values that are in no list of values any more, and what Missing names
    Missing // None, and what stands in the XML, where the data had nothing to choose
  };

  /**
   * Chooses anew where ParaView has chosen. Returns whether that is another value.
   */
  bool Renew(vtkSMProperty* property, Where where);

private:
  bool IsMissing(vtkSMProperty* property) const;

  vtkSmartPointer<vtkSMProperty> Chosen; // null: none yet, as in a display of a state file
  bool Found = false;                    // by the data
  bool ByUser = false;                   // the present value
};

#endif
// VTK-HeaderTest-Exclude: vtkSMRayTracedDefault.h
