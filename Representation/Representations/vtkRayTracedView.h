/**
 * @class   vtkRayTracedView
 * @brief   settings and information of a view's ray-traced image, on the processes that have the view
 *
 * The client has one for each view (vtkSMRayTracedViewProxy). Settings go to the view's vtkRayTracedScene; see
 * RayTracedImageSettings for units and ranges.
 */
#ifndef vtkRayTracedView_h
#define vtkRayTracedView_h

#include "vtkObject.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro
#include "vtkWeakPointer.h"
#ifndef __VTK_WRAP__ // what the wrapping tools need not know
#include "RayTracedImageSettings.h"
#endif

#include <string>

class vtkPVView;
class vtkPVRenderView;
class vtkRayTracedScene;

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedView : public vtkObject
{
public:
  static vtkRayTracedView* New();
  vtkTypeMacro(vtkRayTracedView, vtkObject);

  void SetView(vtkPVView* view);

  ///@{
  /**
   * Values out of range count as the nearest in it, NaN as the default.
   */
  void SetShadingMode(int mode) { this->Set(this->Settings.ShadingMode, mode); }
  void SetAmbientOcclusionRadius(double radius) { this->Set(this->Settings.AmbientOcclusionRadius, radius); }
  void SetIllumination(int kind) { this->Set(this->Settings.Illumination, kind); }
  void SetShadows(bool cast) { this->Set(this->Settings.Shadows, cast); }
  void SetShadowSoftness(double degrees) { this->Set(this->Settings.ShadowSoftness, degrees); }
  void SetGroundShadow(int kind) { this->Set(this->Settings.GroundShadow, kind); }
  void SetToneMapping(int kind) { this->Set(this->Settings.ToneMapping, kind); }
  void SetExposure(double stops) { this->Set(this->Settings.Exposure, stops); }
  void SetDenoising(int when) { this->Set(this->Settings.Denoising, when); }
  void SetSamplesPerPixel(int samples) { this->Set(this->Settings.SamplesPerPixel, samples); }
  void SetSamplesPerRender(int samples) { this->Set(this->Settings.SamplesPerRender, samples); }
  void SetOutlineWidth(double pixels) { this->Set(this->Settings.OutlineWidth, pixels); }
  void SetOutlineColor(double red, double green, double blue)
  {
    this->Set(this->Settings.OutlineColor, { red, green, blue });
  }
  void SetDepthCue(double share) { this->Set(this->Settings.DepthCue, share); }
  void SetParallelLight(int light);
  ///@}

  /**
   * The view's next finished image also leaves what it shows besides colors in this file (RayTracedFeatureImage).
   */
  void SaveFeatureImage(const char* fileName);

  /**
   * Images of the view that are not finished stay as they are until something else changes them.
   */
  void StopRefinement();

  /**
   * Statistics and progress of the view's last frame; see RayTracedFrameStatus.
   */
  const char* GetRenderStatistics();

  /**
   * The position of the glyph in a pixel, counted from the lower left, as a JSON array; empty: there is none.
   * To be called by all ranks that render at once.
   */
  const char* FindPlace(int x, int y);

  /**
   * Whether this process has a Vulkan device to trace with; `words` name it, or what is missing and how to get it.
   * Lists the drivers' devices; no device is made.
   */
  static bool FindDevice(std::string& words);

protected:
  vtkRayTracedView() = default;
  ~vtkRayTracedView() override = default;

private:
#ifndef __VTK_WRAP__
  template <class T>
  void Set(T& held, const T& value)
  {
    held = value;
    this->Apply();
  }
  void Apply();
  vtkRayTracedScene* GetScene() const;

  rtglyphs::RayTracedImageSettings Settings;
#endif
  vtkWeakPointer<vtkPVRenderView> View;
  std::string Statistics, Place;
};

#endif
