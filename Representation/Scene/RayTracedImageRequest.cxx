#include "RayTracedImageRequest.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

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

// Of the light on a surface that faces all of it.
constexpr float skyFraction = 0.6f, keyFraction = 1.0f - skyFraction;
// The sky's radiance from above and below is 1 +- this times its mean. On a surface with normal n that is an irradiance
// of pi (1 + 2/3 slope n.up).
constexpr float slope = 0.9f;
// The sky's mean in ambient occlusion: with it the brightest surface below a headlight, whose normal leans upwards by
// 21 degrees, shows its color. The largest value of 0.4 L(cos a) + 0.6 mean (1 + 2/3 slope sin a) is 1, L: IEC
// 61966-2-1.
constexpr float occlusionMean = 0.902f;
constexpr float albedoLimit = 0.8f;

// Degrees of the key light: above the camera and to the left of it, and half of its width.
constexpr float keyElevation = 45.0f, keyAzimuth = 45.0f, keyRadius = 8.0f;

// Changes the light of an image, whose settings and lights are those of a uniform sky, to the default one, which shows
// shape: a sky that is brighter above than below and, in path tracing, a key light from above on the left, as in a
// photographer's studio. Both follow the camera. People take light to come from there (Sun and Perona, "Where is the
// sun?", Nature Neuroscience 1, 1998). Ambient occlusion keeps the view's lights beside the sky. Path tracing takes the
// key light unless the view has lights that are placed in the scene. A surface that faces the light, without occlusion,
// shows its color; what no array colors reflects four fifths of the light at most.
void ApplyStudioLight(rtg::ImageView& view, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::vec3 forward = glm::normalize(glm::vec3(glm::make_vec3(camera->GetDirectionOfProjection())));
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(glm::make_vec3(camera->GetViewUp()))));
  const glm::vec3 up = glm::cross(right, forward);
  rtg::TraceSettings& settings = view.settings;
  settings.skySlope = slope * up;
  settings.albedoLimit = albedoLimit;
  if (settings.shading == rtg::Shading::AmbientOcclusion)
  {
    settings.lightFraction = keyFraction;
    settings.lightIntensity *= occlusionMean;
    return;
  }
  const float elevation = glm::radians(keyElevation), azimuth = glm::radians(keyAzimuth);
  const glm::vec3 toKey =
    glm::sin(elevation) * up - glm::cos(elevation) * (glm::sin(azimuth) * right + glm::cos(azimuth) * forward);
  // The irradiance is largest along the sum of what sky and key add to the sky's mean.
  const float largest = skyFraction + glm::length(2.0f / 3.0f * skyFraction * slope * up + keyFraction * toKey);
  if (view.lights.empty())
  {
    rtg::Light key;
    key.kind = rtg::Light::Kind::Directional;
    key.direction = -toKey;
    key.color = glm::vec3(settings.lightIntensity * keyFraction / largest);
    key.angularRadius = keyRadius;
    view.lights.push_back(key);
  }
  settings.lightIntensity *= skyFraction / largest;
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
    ApplyStudioLight(view, renderer);
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
