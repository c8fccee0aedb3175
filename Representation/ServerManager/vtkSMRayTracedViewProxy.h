/**
 * @class   vtkSMRayTracedViewProxy
 * @brief   the one owner of the settings and the information of a view's ray-traced image, on the client
 *
 * There is one for each view, made when its first display enters it; views need not know this plugin. Displays have the
 * same settings, on the client only (RayTracedImage): a change of one is copied to all. A display that is added takes
 * those of the view, the first one gives them. States keep them with the displays.
 *
 * RenderingQuality sets the properties that its hints name.
 *
 * After each render that is not interactive the statistics are pulled, once, from the process that has rendered.
 */
#ifndef vtkSMRayTracedViewProxy_h
#define vtkSMRayTracedViewProxy_h

#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class VTKRAYTRACEDGLYPHS_EXPORT vtkSMRayTracedViewProxy : public vtkSMProxy
{
public:
  static vtkSMRayTracedViewProxy* New();
  vtkTypeMacro(vtkSMRayTracedViewProxy, vtkSMProxy);

  /**
   * The owner of a view's settings; null: nothing ray traced was in it yet.
   */
  static vtkSMRayTracedViewProxy* Of(vtkSMProxy* view);

  ///@{
  /**
   * A display's settings become those of a view, whose owner is returned and kept by the display; or leave it.
   */
  static vtkSmartPointer<vtkSMRayTracedViewProxy> Add(vtkSMProxy* display, vtkSMProxy* view);
  void Remove(vtkSMProxy* display);
  ///@}

  vtkSMProxy* GetView();

  /**
   * A display, of that source if one is given, that is visible and shown as something ray traced; null: there is none.
   */
  vtkSMProxy* GetShownDisplay(vtkSMProxy* input = nullptr);

  ///@{
  /**
   * Whether the view's last frame was for a camera that moves. Of the last other one: how far it is in [0, 1], what it
   * waits for, its samples a pixel.
   */
  bool IsInteractive() const { return this->Interactive; }
  double GetProgress() const { return this->Progress; }
  const std::string& GetStep() const { return this->Step; }
  int GetSamples() const { return this->Samples; }
  ///@}

  ///@{
  /**
   * Seconds since that step has begun, of the whole image that are left, and that one of a RenderingQuality would take,
   * with all that the window does meanwhile; negative: unknown.
   */
  double GetSecondsOfStep() const;
  double GetSecondsLeft() const;
  double GetSecondsOfQuality(int quality);
  ///@}

  /**
   * The place of what a pixel of the view shows; false: nothing ray-traced.
   */
  bool FindPlace(int x, int y, double place[3]);

  /**
   * Pulls the statistics.
   */
  void UpdateStatistics();

  void UpdateVTKObjects() override;

protected:
  vtkSMRayTracedViewProxy();
  ~vtkSMRayTracedViewProxy() override;

  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  std::string Ask(const vtkClientServerStream& question, bool ofAllRanks); // empty: no answer
  std::vector<std::pair<std::string, int>> SettingsOfQuality(int quality);
  void ApplyQuality(const std::string& name);
  void DisplayModified(vtkObject* settings, unsigned long, void* name);
  void DisplayPushed(vtkObject* settings, unsigned long, void* name);
  bool IsOfDisplay(vtkSMProperty* property);
  void Rendered(vtkObject*, unsigned long, void* interactive);

  vtkWeakPointer<vtkSMProxy> View;
  std::vector<vtkWeakPointer<vtkSMProxy>> Displays;
  bool Sharing = false; // what displays get they give back
  bool Interactive = false;
  double Progress = 1.0;
  std::string Step;
  int Samples = 0;
  double StepStart = 0.0;
  struct Reached
  {
    double Time = 0.0, Progress = 0.0;
  };
  Reached Last, Recent[2];                // Recent[0]: where the present speed is measured from
  std::map<int, double> SecondsPerSample; // by ShadingMode, of pictures of this size
  int MeasuredSize[2] = { 0, 0 };
};

#endif
