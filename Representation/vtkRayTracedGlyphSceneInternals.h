/**
 * What a vtkRayTracedGlyphScene holds; for its own files.
 */
#ifndef vtkRayTracedGlyphSceneInternals_h
#define vtkRayTracedGlyphSceneInternals_h

#include "vtkRayTracedGlyphScene.h"

#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include "vtkRayTracedGlyphLight.h"
#include "vtkRayTracedGlyphView.h"
#include "vtkRayTracedImageQuad.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace vtkRayTracedGlyphSceneDetail
{
constexpr int passes = 2; // opaque, translucent: as rtg::Pass

// What can be seen: for each set its versions of instances, colours and material, of which no two in the process are
// alike. Two frames with the same list look the same.
using Content = std::vector<std::array<std::uint64_t, 3>>;

// What an image was traced from.
struct ImageKey
{
  glm::dmat4 WorldToClip{ 0.0 };
  glm::dvec3 Position{ 0.0 };
  std::vector<rtg::Light> Lights;
  std::uint32_t Width = 0, Height = 0;
  vtkRayTracedGlyphLight Light;
  std::shared_ptr<const rtg::EnvironmentImage> Environment;
  std::string FeatureFile; // to be written when the image is finished
  vtkRayTracedGlyphSceneDetail::Content Content;

  bool operator==(const ImageKey& other) const
  {
    return this->WorldToClip == other.WorldToClip && this->Position == other.Position &&
      this->Width == other.Width && this->Height == other.Height && this->Light == other.Light &&
      this->FeatureFile == other.FeatureFile && this->Environment == other.Environment &&
      this->Content == other.Content && vtkRayTracedGlyphView::Same(this->Lights, other.Lights);
  }
};

// The image of one pass. Each has a tracer of its own, which keeps its pixels.
struct PassImage
{
  std::unique_ptr<rtg::Tracer> Tracer;
  rtg::Image Image;
  ImageKey Key;
  std::uint32_t PixelStep = 1;
  double SecondsPerSample = 0.0; // of the last trace of all pixels
  std::vector<std::uint32_t> Smooth; // colours of Key's image, denoised
  std::uint32_t SmoothSamples = 0;   // that it had then; 0: none
  bool Valid = false; // Image has the pixels of Key
  bool Kept = false;  // and Tracer what more samples are added to
  bool Sent = false;  // Quad has them, too
  vtkRayTracedImageQuad Quad;
};
}

struct vtkRayTracedGlyphScene::Internals
{
  // A mapper's glyph set and what of it the kernels have.
  struct Member
  {
    rtg::Scene::SetId Set = 0;
    std::uint64_t Instances = 0, Colors = 0;
    rtg::Material Material;
    std::uint64_t MaterialVersion = 0; // 0: not yet sent
    bool Visible = true;               // as the kernels have it
    bool Shown = false;                // in this frame
    bool Translucent = false;          // then in the translucent pass
  };

  std::shared_ptr<rtg::Device> Device;
  std::unique_ptr<rtg::Scene> Scene;
  std::map<vtkRayTracedGlyphMapper*, Member> Members;
  std::uint64_t MaterialVersion = 0; // grows with every change of a material
  std::array<vtkRayTracedGlyphSceneDetail::PassImage, vtkRayTracedGlyphSceneDetail::passes> Images;
  vtkRayTracedImageQuad IdQuad;

  // This frame
  vtkRayTracedGlyphSceneDetail::Content Content;
  bool Synchronised = false;
  bool OpaqueDrawn = false;
  vtkRayTracedGlyphMapper* TranslucentLeader = nullptr;
  std::uint32_t Samples = 0;    // of the last image
  vtkRayTracedGlyphLight Light; // of the view
  vtkRayTracedGlyphView::Environment Environment;
  std::uint32_t SamplesPerPixel = 1, SamplesPerRender = 0, InteractiveReduction = 1;
  bool Stepwise = false;
  std::string FeatureFile;

  // After a failure nothing is tried until what is to be shown changes
  std::string Failure, CameraFailure;
  std::string Reported;      // the last failure, until there is an image again
  bool LostDevice = false;   // since the last image
  bool TryNewDevice = false; // once: a second loss is no accident
  std::uint64_t FailedVersion = 0;
  std::uint64_t Version = 0; // sum of the mappers' versions, visible ones

  // How the image of a pass is to be traced. Good: the one at hand will do.
  struct Plan
  {
    rtg::TraceSettings Settings;
    bool Denoise = false;
    bool Good = false;
  };
  Plan PlanImage(const vtkRayTracedGlyphSceneDetail::PassImage& image,
    const vtkRayTracedGlyphSceneDetail::ImageKey& key, bool forIds, bool interactive,
    bool capturing) const;

  void Forget()
  {
    for (auto& image : this->Images)
    {
      image.Valid = image.Kept = image.Sent = false;
      image.Tracer.reset();
    }
    this->Scene.reset();
    this->Device.reset();
    this->Members.clear();
  }

  rtg::Statistics Sum() const
  {
    rtg::Statistics sum = this->Scene ? this->Scene->GetStatistics() : rtg::Statistics();
    for (const auto& image : this->Images)
    {
      if (image.Tracer)
      {
        const rtg::Statistics& s = image.Tracer->GetStatistics();
        sum.pipelineBuilds += s.pipelineBuilds;
        sum.dispatches += s.dispatches;
        sum.primaryRays += s.primaryRays;
        sum.deviceBytes = std::max(sum.deviceBytes, s.deviceBytes);
        sum.traceSeconds += s.traceSeconds;
        sum.denoiseSeconds += s.denoiseSeconds;
      }
    }
    return sum;
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedGlyphSceneInternals.h
