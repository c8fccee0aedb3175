/**
 * @class   vtkSMRayTracedRepresentationProxy
 * @brief   the client's side of ray-traced glyphs, surfaces and tubes
 *
 * - Properties with the hint OfView hold for the whole view: a change on one of its displays is a change on all, and a
 * display that is added takes the values of those that are there.
 * - Information properties speak of the process that renders, and are current after each render. ParaView asks the
 *   client for information about whatever is there too; with remote rendering nothing happens there, and the server's
 * first rank is asked.
 * - Those with the hint OfData speak of the processes that have the data.
 * - ScaleFactor and ShutterTime are what the data suggest until they are set.
 * - Properties that 3D Glyphs has are those of its representation. Where nobody has chosen, data choose otherwise than
 *   ParaView does; see ChooseDefaults().
 * - Numbers of tensors (GlyphTensorColoring) have a lookup table and a scalar bar of their own.
 */
#ifndef vtkSMRayTracedRepresentationProxy_h
#define vtkSMRayTracedRepresentationProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "vtkSMRayTracedDefault.h"
#endif

#include <functional>
#include <set>
#include <string>

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMRayTracedRepresentationProxy* New();
  vtkTypeMacro(vtkSMRayTracedRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ViewUpdated(vtkSMProxy* view) override;

  ///@{
  /**
   * The first display of a view that is wanted, or null; and whether a display, of any kind, is visible and shown as
   * ray-traced glyphs or as a ray-traced surface.
   */
  static vtkSMProxy* FindDisplay(vtkSMProxy* view, const std::function<bool(vtkSMProxy*)>& wanted);
  static bool ShowsRayTraced(vtkSMProxy* display);
  ///@}

  struct Suggested;

protected:
  vtkSMRayTracedRepresentationProxy();
  ~vtkSMRayTracedRepresentationProxy() override;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;
  void SetPropertyModifiedFlag(const char* name, int flag) override;
  void AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer) override;

private:
  vtkSMRayTracedRepresentationProxy(const vtkSMRayTracedRepresentationProxy&) = delete;
  void operator=(const vtkSMRayTracedRepresentationProxy&) = delete;

  vtkSMProxy* FindView();
  bool IsExposed(const char* name);
  bool IsFollower(const char* name);
  bool HoldsForView(const char* name);
#ifndef __VTK_WRAP__
  bool RenewDefault(const char* name, vtkSMRayTracedDefault::Where where);
  bool ChooseSharedArrays(vtkSMRayTracedDefault::Where where);
#endif
  void RenewDefaults(vtkSMProxy* view);
  void TakeSelection();
  void FollowQuality(const std::string& name);
  void ShareWithView(const char* name);
  void NoteChoice(const std::string& name);
  void ChooseDefaults();
  void ListArraysOfLocation();
  void TakeFromView(vtkSMProxy* view);
  void Rendered(vtkObject* view, unsigned long event, void* interactive);
  void UpdateTensorTable(vtkSMProxy* view);
  void TakeGuess(const Suggested& suggested);
  void TakeDataSizes();

  vtkWeakPointer<vtkSMProxy> ObservedView, ObservedDisplay;
  double Time = 0.0;           // of the last update
  std::string TensorTableName; // of the table and scalar bar that are in use; empty: none
  double TensorRange[2] = { 1.0, -1.0 };
  bool TensorTableChosen = false; // by somebody else than this class
  bool ApplyingQuality = false;
  std::set<std::string> Chosen; // of the properties shared with 3D Glyphs, by the user or a script
  bool Choosing = false;        // by this class
  bool TakingGuess = false;     // a number is set to what the data suggest, not by the user
};

#endif
