#include "RayTracedStudioLight.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

namespace
{
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
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedStudioLight::Apply(rtg::ImageView& view, vtkRenderer* renderer)
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
