#include "RayTracedImageRequest.h"

#include "RayTracedStudioLight.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
// Seconds of one step of the images of a frame in the window, and of a frame of a camera that moves: what the user does
// meanwhile waits for the one and is shown by the other. A server's frames take longer to be sent.
constexpr double firstSeconds = 0.1; // of the first frame of another image: it is to have more than a few pixels
double StepSeconds()
{
  return vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_CLIENT ? 0.04 : 0.1;
}

// Settings that mean nothing to the shading stay at their defaults: no image is traced again for them.
rtg::TraceSettings ToTraceSettings(const rtglyphs::RayTracedImageSettings& from)
{
  rtg::TraceSettings settings;
  settings.shading = static_cast<rtg::Shading>(from.ShadingMode);
  if (settings.shading == rtg::Shading::AmbientOcclusion)
  {
    settings.occlusionRadius = static_cast<float>(from.AmbientOcclusionRadius);
    settings.occlusionRays = 8;
  }
  if (settings.shading == rtg::Shading::PathTracing)
  {
    settings.paths = 4;
  }
  if (settings.shading != rtg::Shading::Local && from.Illumination == rtglyphs::RayTracedImageSettings::LightsOfView)
  {
    settings.lightIntensity = 0.0f;
    settings.lightFraction = 1.0f;
  }
  if (from.ToneMapping != rtglyphs::RayTracedImageSettings::AutomaticToneMapping)
  {
    settings.toneMapping = static_cast<rtg::ToneMapping>(from.ToneMapping);
  }
  else if (settings.shading != rtg::Shading::Local)
  {
    settings.toneMapping = rtg::ToneMapping::Neutral;
  }
  settings.exposure = static_cast<float>(from.Exposure);
  return settings;
}

void PutGroundBelow(const vtkBoundingBox& shown, int across, vtkCamera* camera, rtg::TraceSettings& settings)
{
  const double* up = camera->GetViewUp();
  int axis = across - rtglyphs::RayTracedImageSettings::GroundAcrossX;
  if (across == rtglyphs::RayTracedImageSettings::GroundBelowView)
  {
    axis =
      static_cast<int>(std::max_element(up, up + 3, [](double a, double b) { return std::abs(a) < std::abs(b); }) - up);
  }
  const bool upwards = up[axis] >= 0.0;
  settings.groundNormal[axis] = upwards ? 1.0f : -1.0f;
  settings.groundHeight = upwards ? shown.GetBound(2 * axis) : -shown.GetBound(2 * axis + 1);
}
}

//----------------------------------------------------------------------------
rtg::ImageView rtglyphs::RayTracedImageRequest::ViewOf(const rtglyphs::RayTracedImageSettings& settings,
  vtkRenderer* renderer, rtg::Pass pass, std::uint32_t width, std::uint32_t height, const vtkBoundingBox& shown,
  rtglyphs::RayTracedRendererState::Environment& environment)
{
  rtg::ImageView view;
  view.camera =
    rtglyphs::RayTracedRendererState::CameraOf(renderer, rtglyphs::RayTracedRendererState::WorldToClip(renderer));
  view.pass = pass;
  view.settings = ToTraceSettings(settings);
  view.settings.width = width;
  view.settings.height = height;
  // Headlight and light kit replace environment light, which path tracing has.
  const bool surrounded = view.settings.shading == rtg::Shading::PathTracing &&
    settings.Illumination != rtglyphs::RayTracedImageSettings::LightsOfView;
  const bool soft = settings.Shadows || view.settings.shading == rtg::Shading::PathTracing;
  view.lights = rtglyphs::RayTracedRendererState::LightsOf(
    renderer, soft ? settings.ShadowSoftness : 0.0, /*placedOnly=*/surrounded);
  view.previewLights = rtglyphs::RayTracedRendererState::LightsOf(renderer, /*softness=*/0.0, /*placedOnly=*/false);
  if (surrounded)
  {
    environment = rtglyphs::RayTracedRendererState::EnvironmentOf(renderer, environment);
    view.settings.environmentImage = environment.Image;
  }
  const bool lit = view.settings.shading == rtg::Shading::AmbientOcclusion || surrounded;
  if (lit && settings.Illumination == rtglyphs::RayTracedImageSettings::StudioLight && !view.settings.environmentImage)
  {
    rtglyphs::RayTracedStudioLight::Apply(view, renderer);
  }
  // Without lights that cast shadows there are no shadow rays.
  view.settings.shadows = settings.Shadows && view.settings.shading != rtg::Shading::PathTracing &&
    std::any_of(view.lights.begin(), view.lights.end(),
      [](const rtg::Light& light) { return light.castsShadow && light.kind != rtg::Light::Kind::Headlight; });
  // Local shading has none without shadows; but programs of the other modes are compiled ahead for these settings.
  if (shown.IsValid())
  {
    PutGroundBelow(shown, settings.GroundShadow, renderer->GetActiveCamera(), view.settings);
  }
  return view;
}

//----------------------------------------------------------------------------
rtg::ScreenEffects rtglyphs::RayTracedImageRequest::EffectsOf(
  const rtglyphs::RayTracedImageSettings& settings, const rtg::ImageView& view, const rtg::Image& image)
{
  rtg::ScreenEffects effects;
  const double scale = view.settings.width > 0 ? double(image.width) / view.settings.width : 1.0;
  effects.outlineWidth = static_cast<float>(settings.OutlineWidth * scale);
  effects.outlineColor = glm::vec3(settings.OutlineColor[0], settings.OutlineColor[1], settings.OutlineColor[2]);
  effects.depthCue = static_cast<float>(settings.DepthCue);
  // ParaView puts the planes round all that is visible, on all ranks alike.
  effects.nearDepth = view.camera.nearDepth;
  effects.farDepth = view.camera.farDepth;
  return effects;
}

//----------------------------------------------------------------------------
rtg::ImageEffort
rtglyphs::RayTracedImageRequest::EffortOf(const rtglyphs::RayTracedImageSettings& settings, const Frame& frame)
{
  rtg::ImageEffort effort;
  effort.samples = static_cast<std::uint32_t>(settings.SamplesPerPixel);
  const bool stepwise = settings.IsStepwise() && !frame.Capture;
  effort.samplesAtOnce = frame.Capture || stepwise ? 0 : static_cast<std::uint32_t>(settings.SamplesPerRender);
  effort.seconds = stepwise ? StepSeconds() / frame.Images : 0.0;
  effort.firstSeconds = firstSeconds / frame.Images;
  effort.preview = frame.Interactive;
  effort.exact = frame.Capture || settings.SamplesPerRender == 0;
  effort.denoising = static_cast<rtg::Denoising>(settings.Denoising);
  effort.features = frame.Features;
  return effort;
}
