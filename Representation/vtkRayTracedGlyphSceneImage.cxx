// The image of a frame: how good it is to be, tracing it, keeping it.
#include "vtkRayTracedGlyphScene.h"

#include "vtkRayTracedGlyphSceneInternals.h"

#include "vtkRayTracedGlyphMapper.h"
#include "vtkRayTracedOpenGL.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

using namespace vtkRayTracedGlyphSceneDetail;

namespace
{
// Above this, in frames a second, a window asks for speed: ParaView renders interactively at 5, at rest at 0.002.
constexpr double interactiveRate = 1.0;
// One step of an image that somebody watches, in seconds: a camera that is turned meanwhile waits so long.
constexpr double stepSeconds = 0.1;

rtg::TraceSettings SettingsOf(const vtkRayTracedGlyphLight& light)
{
  rtg::TraceSettings settings;
  settings.shading = static_cast<rtg::Shading>(light.ShadingMode);
  settings.occlusionRadius = static_cast<float>(light.AmbientOcclusionRadius);
  settings.occlusionRays = static_cast<std::uint32_t>(light.AmbientOcclusionRays);
  settings.paths = static_cast<std::uint32_t>(light.PathsPerSample);
  settings.maximumBounces = static_cast<std::uint32_t>(light.MaximumBounces);
  settings.lightIntensity = static_cast<float>(light.LightIntensity);
  settings.environmentColour = glm::vec3(static_cast<float>(light.EnvironmentColor[0]),
    static_cast<float>(light.EnvironmentColor[1]), static_cast<float>(light.EnvironmentColor[2]));
  settings.toneMapping = static_cast<rtg::ToneMapping>(light.ToneMapping);
  settings.exposure = static_cast<float>(light.Exposure);
  return settings;
}
}

//----------------------------------------------------------------------------
// How good an image this frame wants. `capturing`: ParaView takes it without showing, and only once.
vtkRayTracedGlyphScene::Internals::Plan vtkRayTracedGlyphScene::Internals::PlanImage(
  const PassImage& image, const ImageKey& key, bool forIds, bool interactive, bool capturing) const
{
  Plan plan;
  rtg::TraceSettings& settings = plan.Settings;
  settings = SettingsOf(key.Light);
  settings.environmentImage = key.Environment;
  settings.width = key.Width;
  settings.height = key.Height;
  settings.plannedSamples = this->SamplesPerPixel;
  const bool same = image.Valid && image.Key == key;
  const bool coarse = interactive && !capturing;
  const bool inSteps = (this->SamplesPerRender > 0 || this->Stepwise) && !capturing;
  // Surfaces that are lit locally have no noise, and cost one ray a pixel.
  const bool noisy = key.Light.ShadingMode != static_cast<int>(rtg::Shading::Local);

  if (forIds)
  {
    // Identities and depths do not depend on the light.
    settings = SettingsOf(vtkRayTracedGlyphLight());
    settings.width = key.Width;
    settings.height = key.Height;
    settings.samples = 1;
    plan.Good = same && image.Image.samples >= 1 && image.PixelStep == 1;
    return plan;
  }
  if (coarse)
  {
    // Pixels that need more than one ray are spared more of them, for the camera to answer as fast.
    settings.pixelStep =
      this->InteractiveReduction + (noisy && this->InteractiveReduction > 1 ? 1 : 0);
    settings.samples = 1;
    // Such an image is not added to, so its samples need not be like others.
    if (settings.pixelStep > 1)
    {
      settings.occlusionRays = settings.paths = 1;
    }
  }
  else if (inSteps)
  {
    const std::uint32_t done = same && image.PixelStep == 1 ? image.Image.samples : 0;
    std::uint32_t step = this->SamplesPerRender;
    if (step == 0)
    {
      step = done == 0 || image.SecondsPerSample <= 0.0
        ? 1
        : static_cast<std::uint32_t>(std::clamp(stepSeconds / image.SecondsPerSample, 1.0, 1e6));
    }
    settings.samples = std::min(this->SamplesPerPixel, done + step);
  }
  else
  {
    settings.samples = this->SamplesPerPixel;
  }
  const bool enough = coarse ? image.Image.samples >= settings.samples
                             : image.Image.samples == settings.samples;
  plan.Good = same && enough && image.PixelStep <= settings.pixelStep;

  // An image that grows step by step keeps its sums, and new samples are added to them. Images of a moving camera
  // do so, too, when steps will follow: they need no other program then, which would first have to be compiled.
  const bool unfinished = settings.samples < this->SamplesPerPixel;
  settings.keepSums = unfinished && (settings.pixelStep == 1 || this->Stepwise);
  if (same && image.Kept && image.PixelStep == 1 && settings.pixelStep == 1 &&
    image.Image.samples < settings.samples)
  {
    settings.firstSample = image.Image.samples;
    settings.samples -= settings.firstSample;
  }

  // Smooth light in place of noise; what a step gathers the next ones need.
  const int denoising = key.Light.Denoising;
  const bool smooth = noisy && (denoising == 2 || (denoising == 1 && inSteps));
  settings.features = smooth || !key.FeatureFile.empty();
  settings.keepSums |= settings.features;
  plan.Denoise = smooth && settings.pixelStep == 1 && (denoising == 2 || unfinished);
  return plan;
}

//----------------------------------------------------------------------------
// Makes the image of a pass the one of this frame; false: there is nothing to draw.
bool vtkRayTracedGlyphScene::UpdateImage(int pass, bool forIds)
{
  Internals& self = *this->Self;
  const bool translucent = pass == static_cast<int>(rtg::Pass::Translucent);
  const bool wanted = std::any_of(self.Members.begin(), self.Members.end(),
    [translucent](const auto& m) { return m.second.Shown && m.second.Translucent == translucent; });
  if (!self.Scene || !self.Failure.empty() || !wanted)
  {
    return false;
  }
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] < 1 || viewport[3] < 1)
  {
    return false;
  }

  // A camera that sees nothing is no failure of the glyphs: the next one may be good.
  ImageKey key;
  rtg::Camera camera;
  try
  {
    key.WorldToClip = vtkRayTracedGlyphView::WorldToClip(this->Renderer);
    camera = vtkRayTracedGlyphView::CameraOf(this->Renderer, key.WorldToClip);
    self.CameraFailure.clear();
  }
  catch (const rtg::Error& error)
  {
    if (self.CameraFailure != error.what())
    {
      self.CameraFailure = error.what();
      vtkWarningMacro(<< error.what());
    }
    return false;
  }

  PassImage& image = self.Images[pass];
  try
  {
    key.Position = camera.position;
    key.Width = static_cast<std::uint32_t>(viewport[2]);
    key.Height = static_cast<std::uint32_t>(viewport[3]);
    key.Content = self.Content;
    key.Light = self.Light;
    key.FeatureFile = self.FeatureFile;
    // Headlight and light kit make up for the lack of light from all around; path tracing has that.
    const bool surrounded =
      self.Light.ShadingMode == static_cast<int>(rtg::Shading::PathTracing) &&
      self.Light.LightIntensity > 0.0;
    key.Lights = vtkRayTracedGlyphView::LightsOf(this->Renderer, /*placedOnly=*/surrounded);

    if (surrounded)
    {
      self.Environment = vtkRayTracedGlyphView::EnvironmentOf(this->Renderer, self.Environment);
      key.Environment = self.Environment.Image;
    }

    if (forIds)
    {
      key.Light = image.Valid ? image.Key.Light : vtkRayTracedGlyphLight();
      key.FeatureFile = image.Valid ? image.Key.FeatureFile : std::string();
      key.Environment = image.Valid ? image.Key.Environment : nullptr;
    }
    vtkRenderWindow* window = this->Renderer->GetRenderWindow();
    const Internals::Plan plan =
      self.PlanImage(image, key, forIds, window->GetDesiredUpdateRate() >= interactiveRate,
        window->GetSwapBuffers() == 0);
    const rtg::TraceSettings& settings = plan.Settings;
    if (plan.Good)
    {
      self.Samples = image.Image.samples;
      return true;
    }
    if (forIds)
    {
      key.Light = vtkRayTracedGlyphLight();
    }

    if (!image.Tracer)
    {
      image.Tracer = std::make_unique<rtg::Tracer>(self.Device);
    }
    image.Valid = image.Kept = image.Sent = false;
    // Only now: what is hidden and shown again before the next image costs nothing.
    for (auto& item : self.Members)
    {
      if (item.second.Visible != item.second.Shown)
      {
        self.Scene->SetVisible(item.second.Set, item.second.Shown);
        item.second.Visible = item.second.Shown;
      }
    }
    self.Scene->Commit();
    const double traced = image.Tracer->GetStatistics().traceSeconds;
    image.Image =
      image.Tracer->Trace(*self.Scene, camera, key.Lights, settings, static_cast<rtg::Pass>(pass));
    if (plan.Denoise)
    {
      // Denoising takes about as long as a sample: only when there is a good deal more to see.
      const std::uint32_t samples = image.Image.samples;
      if (settings.firstSample == 0 || image.SmoothSamples == 0 || 2 * samples >= 3 * image.SmoothSamples)
      {
        image.Tracer->Denoise(image.Image);
        image.Smooth.assign(
          image.Image.colour, image.Image.colour + std::size_t(settings.width) * settings.height);
        image.SmoothSamples = samples;
      }
      image.Image.colour = image.Smooth.data();
    }
    else
    {
      image.Smooth.clear();
      image.SmoothSamples = 0;
    }
    image.Key = std::move(key);
    image.PixelStep = settings.pixelStep;
    if (settings.pixelStep == 1)
    {
      image.SecondsPerSample =
        (image.Tracer->GetStatistics().traceSeconds - traced) / settings.samples;
    }
    image.Valid = true;
    image.Kept = settings.keepSums;
    self.Samples = image.Image.samples;
    self.Reported.clear();
    self.LostDevice = false;
    // The translucent pass comes last, and with it both images are there.
    const bool last = translucent ||
      std::none_of(self.Members.begin(), self.Members.end(),
        [](const auto& m) { return m.second.Shown && m.second.Translucent; });
    if (!image.Key.FeatureFile.empty() && !forIds && last && settings.pixelStep == 1 &&
      self.Samples == self.SamplesPerPixel)
    {
      // Parallel rays start from another plane than the camera's.
      this->WriteFeatures(
        image.Key.FeatureFile, glm::dot(camera.eye - camera.position, glm::dvec3(camera.forward)));
    }
    return true;
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
    return false;
  }
}
