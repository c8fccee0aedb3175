#include "RayTracedRendererState.h"

#include "vtkCollectionRange.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationKeyLookup.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include "Shading/Shading.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
std::vector<vtkLight*> LightsOn(vtkRenderer* renderer)
{
  std::vector<vtkLight*> on;
  for (vtkLight* light : vtk::Range(renderer->GetLights()))
  {
    if (light->GetSwitch())
    {
      on.push_back(light);
    }
  }
  return on;
}

// Null: none. Headlights shine from where they cannot be seen to cast a shadow.
const vtkLight* BrightestOnCamera(const std::vector<vtkLight*>& lights)
{
  const vtkLight* brightest = nullptr;
  double most = 0.0;
  for (vtkLight* light : lights)
  {
    const double brightness =
      light->GetIntensity() * rtg::shading::Luminance(glm::vec3(glm::make_vec3(light->GetDiffuseColor())));
    if (light->LightTypeIsCameraLight() && brightness > most)
    {
      brightest = light;
      most = brightness;
    }
  }
  return brightest;
}

// ParaView's lights keep their radius for OSPRay alone, and only where VTK has it; 0: none.
double RadiusOf(vtkLight* light)
{
  auto* key = vtkInformationDoubleKey::SafeDownCast(vtkInformationKeyLookup::Find("RADIUS", "vtkOSPRayLightNode"));
  vtkInformation* info = light->GetInformation();
  const double radius = key && info && info->Has(key) ? info->Get(key) : 0.0;
  return std::isfinite(radius) ? std::max(radius, 0.0) : 0.0;
}

// Wider environment images, or higher than half of it, are made smaller: one of 32768 x 16384 would take 6 GB twice.
constexpr vtkIdType mostEnvironmentColumns = 4096;
}

//----------------------------------------------------------------------------
glm::dmat4 rtglyphs::RayTracedRendererState::WorldToClip(vtkRenderer* renderer)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!camera)
  {
    return glm::dmat4(1.0);
  }
  vtkMatrix4x4 *worldToView, *viewToClip, *worldToClip;
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  // VTK keeps it transposed for OpenGL: its rows are GLM's columns.
  return glm::make_mat4(worldToClip->GetData());
}

//----------------------------------------------------------------------------
glm::dvec3 rtglyphs::RayTracedRendererState::PlaceOf(
  std::size_t pixel, std::uint32_t width, std::uint32_t height, float depth, const glm::dmat4& clipToWorld)
{
  const glm::dvec4 clip(
    2.0 * (pixel % width + 0.5) / width - 1.0, 2.0 * (pixel / width + 0.5) / height - 1.0, 2.0 * depth - 1.0, 1.0);
  const glm::dvec4 world = clipToWorld * clip;
  return glm::dvec3(world) / world.w;
}

//----------------------------------------------------------------------------
rtg::Camera rtglyphs::RayTracedRendererState::CameraOf(vtkRenderer* renderer, const glm::dmat4& worldToClip)
{
  rtg::Camera camera = rtg::Camera::FromWorldToClip(worldToClip);
  if (camera.parallel)
  {
    camera.position = glm::make_vec3(renderer->GetActiveCamera()->GetPosition());
  }
  // As vtkOSPRayCameraNode, and in parallel projection, too, where depths count from another place.
  vtkCamera* view = renderer->GetActiveCamera();
  const double distance = view->GetFocalDistance();
  if (distance > 0.0 && std::isfinite(distance) && std::isfinite(view->GetFocalDisk()))
  {
    camera.lensRadius = std::max(0.5 * view->GetFocalDisk(), 0.0);
    camera.lensDepth = glm::dot(camera.position - camera.eye, glm::make_vec3(view->GetDirectionOfProjection()));
    camera.focusDepth = camera.lensDepth + distance;
  }
  return camera;
}

//----------------------------------------------------------------------------
std::vector<rtg::Light>
rtglyphs::RayTracedRendererState::LightsOf(vtkRenderer* renderer, double softness, bool placedOnly)
{
  const std::vector<vtkLight*> on = LightsOn(renderer);
  const bool loneHeadlight = on.size() == 1 && on.front()->LightTypeIsHeadlight() && !on.front()->GetPositional();

  // Of the lights that make up for others one casts shadows.
  const vtkLight* const key = BrightestOnCamera(on);
  std::vector<rtg::Light> lights;
  for (vtkLight* light : on)
  {
    if (placedOnly && !light->LightTypeIsSceneLight() && !light->GetPositional())
    {
      continue;
    }
    rtg::Light converted;
    converted.color = glm::vec3(glm::make_vec3(light->GetDiffuseColor())) * static_cast<float>(light->GetIntensity());
    const glm::dvec3 position = glm::make_vec3(light->GetTransformedPosition());
    const glm::dvec3 focus = glm::make_vec3(light->GetTransformedFocalPoint());
    converted.position = position;
    if (position != focus)
    {
      converted.direction = glm::normalize(focus - position);
    }
    converted.castsShadow = light == key || light->LightTypeIsSceneLight();
    const double radius = RadiusOf(light);
    if (loneHeadlight)
    {
      converted.kind = rtg::Light::Kind::Headlight;
    }
    else if (light->GetPositional())
    {
      converted.kind = rtg::Light::Kind::Positional;
      converted.attenuation = glm::vec3(glm::make_vec3(light->GetAttenuationValues()));
      converted.coneAngle = static_cast<float>(light->GetConeAngle());
      converted.exponent = static_cast<float>(light->GetExponent());
      const double seen = glm::length(focus - position) * std::sin(glm::radians(softness));
      converted.radius = static_cast<float>(radius > 0.0 ? radius : seen);
    }
    else
    {
      converted.kind = rtg::Light::Kind::Directional;
      // As OSPRay, for which a light's radius is the angular diameter then.
      converted.angularRadius = static_cast<float>(radius > 0.0 ? std::min(0.5 * radius, 90.0) : softness);
    }
    lights.push_back(converted);
  }
  return lights;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedRendererState::Environment
rtglyphs::RayTracedRendererState::EnvironmentOf(vtkRenderer* renderer, const Environment& last)
{
  vtkTexture* texture = renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  vtkImageData* input = texture && !texture->GetCubeMap() ? texture->GetInput() : nullptr;
  vtkDataArray* colors = input ? input->GetPointData()->GetScalars() : nullptr;
  if (!colors || input->GetDimensions()[2] != 1)
  {
    return Environment();
  }
  const auto right = glm::normalize(glm::vec3(glm::make_vec3(renderer->GetEnvironmentRight())));
  const auto up = glm::normalize(glm::vec3(glm::make_vec3(renderer->GetEnvironmentUp())));
  Environment environment;
  environment.Time = input->GetMTime();
  if (last.Image && last.Time == environment.Time && last.Image->right == right && last.Image->up == up)
  {
    return last;
  }
  auto image = std::make_shared<rtg::EnvironmentImage>();
  image->right = right;
  image->up = up;
  // Blocks of side x side texels become one, of their mean light: an environment image needs no more.
  const vtkIdType columns = input->GetDimensions()[0], rows = input->GetDimensions()[1];
  const vtkIdType side = std::max<vtkIdType>(1,
    std::max((columns + mostEnvironmentColumns - 1) / mostEnvironmentColumns,
      (2 * rows + mostEnvironmentColumns - 1) / mostEnvironmentColumns));
  image->width = static_cast<std::uint32_t>((columns + side - 1) / side);
  image->height = static_cast<std::uint32_t>((rows + side - 1) / side);
  image->radiance.assign(std::size_t(image->width) * image->height, glm::vec3(0.0f));
  const int components = colors->GetNumberOfComponents();
  const bool display = colors->GetDataType() == VTK_UNSIGNED_CHAR;
  for (vtkIdType y = 0; y < rows; ++y)
  {
    const vtkIdType blockRows = std::min(side, rows - y / side * side);
    for (vtkIdType x = 0; x < columns; ++x)
    {
      glm::vec3 radiance;
      for (int c = 0; c < 3; ++c)
      {
        // One component, or one and alpha: gray.
        const double value = colors->GetComponent(y * columns + x, components >= 3 ? c : 0);
        radiance[c] = static_cast<float>(display ? value / 255.0 : value);
      }
      radiance = display ? rtg::shading::DisplayToLinear(radiance) : radiance;
      for (int c = 0; c < 3; ++c)
      {
        radiance[c] = std::isfinite(radiance[c]) ? std::max(radiance[c], 0.0f) : 0.0f;
      }
      const vtkIdType blockColumns = std::min(side, columns - x / side * side);
      image->radiance[y / side * image->width + x / side] += radiance / static_cast<float>(blockRows * blockColumns);
    }
  }
  environment.Image = std::move(image);
  return environment;
}

//----------------------------------------------------------------------------
rtg::Material rtglyphs::RayTracedRendererState::MaterialOf(vtkProperty* property, vtkRenderer* renderer)
{
  rtg::Material material;
  material.color = glm::vec3(glm::make_vec3(property->GetDiffuseColor()));
  material.ambientColor = glm::vec3(glm::make_vec3(property->GetAmbientColor()));
  material.specularColor = glm::vec3(glm::make_vec3(property->GetSpecularColor()));
  material.ambient = static_cast<float>(property->GetAmbient());
  material.diffuse = static_cast<float>(property->GetDiffuse());
  material.specular = static_cast<float>(property->GetSpecular());
  material.specularPower = static_cast<float>(property->GetSpecularPower());
  material.opacity = static_cast<float>(property->GetOpacity());
  material.metallic = static_cast<float>(property->GetMetallic());
  material.roughness = static_cast<float>(property->GetRoughness());
  material.coatStrength = static_cast<float>(property->GetCoatStrength());
  material.coatRoughness = static_cast<float>(property->GetCoatRoughness());
  material.coatIor = static_cast<float>(property->GetCoatIOR());
  material.coatColor = glm::vec3(glm::make_vec3(property->GetCoatColor()));
  material.lighting = property->GetLighting() && (renderer->GetAutomaticLightCreation() || !LightsOn(renderer).empty());
  return material;
}
