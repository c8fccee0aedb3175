#pragma once

#include "Buffer.h"

#include "../Glyphs.h"

#include <vector>

namespace rtg
{

/// What a hit group is specialised for: the arrays its glyph sets really have.
struct HitGroup
{
  Shape shape = Shape::Sphere;
  std::uint32_t sizesPerGlyph = 0; ///< 0, 1 or 3
  bool turned = false;
  bool coloured = false;
  bool fixedHeads = false;
  bool hasTree = false;
  bool ownExponents = false;
  bool exactCentres = false; ///< centres have low parts
  bool colouredByForm = false;
  bool hasVelocities = false;
  bool hasAccelerations = false;
  bool spins = false;
  bool ownTreeOrder = false; ///< slices of time are sorted each for itself
  bool dropsHidden = false;  ///< glyphs lie so densely that most of what a ray might meet is behind its hit
  // Shape::Mesh only
  bool smoothNormals = false;
  std::uint32_t meshColours = 0; ///< 0: none, 1: by position, 2: by triangle
  bool meshTree = false;         ///< our tree of the mesh's triangles; the driver knows no triangles that move
  bool meshVelocities = false;
  bool meshAccelerations = false;

  bool Moves() const
  {
    return this->hasVelocities || this->hasAccelerations || this->spins || this->meshVelocities ||
      this->meshAccelerations;
  }

  friend bool operator==(const HitGroup& a, const HitGroup& b)
  {
    return a.shape == b.shape && a.sizesPerGlyph == b.sizesPerGlyph && a.turned == b.turned &&
      a.coloured == b.coloured && a.fixedHeads == b.fixedHeads && a.hasTree == b.hasTree &&
      a.ownExponents == b.ownExponents && a.exactCentres == b.exactCentres && a.colouredByForm == b.colouredByForm &&
      a.hasVelocities == b.hasVelocities && a.hasAccelerations == b.hasAccelerations && a.spins == b.spins &&
      a.ownTreeOrder == b.ownTreeOrder && a.dropsHidden == b.dropsHidden && a.smoothNormals == b.smoothNormals &&
      a.meshColours == b.meshColours && a.meshTree == b.meshTree && a.meshVelocities == b.meshVelocities &&
      a.meshAccelerations == b.meshAccelerations;
  }
};

/// A ray generation program.
enum class Program
{
  Local,     ///< an image with local shading
  Occlusion, ///< with ambient occlusion
  Path,      ///< path-traced
  Probe
};

/// A ray generation program and what it is specialised for (Programs/bindings.glsl, pixel.glsl, Shading/Sampling.glsl).
struct Generation
{
  Program program = Program::Local;
  bool alone = false;        ///< the scene has a single GlyphSetRecord, FrameRecord::onlySet
  std::uint32_t sampler = 0; ///< number of an rtg::Sampler
  bool accumulates = false;
  bool gathersFeatures = false;
  bool develops = false;
  bool translucency = false;
  bool moves = false; ///< paths run at times of their own
  bool environmentImage = false;
  bool layered = false; ///< all translucent surfaces along camera rays are shown
  bool whole = false; ///< the scene is one set of glyphs with a tree, which the program walks itself; see CanBeWhole()

  friend bool operator==(const Generation& a, const Generation& b)
  {
    return a.program == b.program && a.alone == b.alone && a.sampler == b.sampler && a.accumulates == b.accumulates &&
      a.gathersFeatures == b.gathersFeatures && a.develops == b.develops && a.translucency == b.translucency &&
      a.moves == b.moves && a.environmentImage == b.environmentImage && a.layered == b.layered && a.whole == b.whole;
  }
};

/// Whether there are programs for a scene of this single hit group alone.
bool CanBeWhole(const Generation& generation, const std::vector<HitGroup>& groups);

/// One ray generation program with the hit groups of a scene, and its shader binding table.
class Pipeline
{
public:
  /// Hit group i is the one at shader binding table offset i. Throws vk::SystemError.
  Pipeline(Device::State& device, const Generation& generation, const std::vector<HitGroup>& groups);

  const Generation& GetGeneration() const { return this->generation_; }
  const std::vector<HitGroup>& Groups() const { return this->groups_; }

  /// Binds and launches; `frame` is the uniform block that all programs see. Not while a launch before is still
  /// running.
  void Trace(vk::raii::CommandBuffer& command, const Buffer& frame, std::uint32_t width, std::uint32_t height) const;

private:
  Device::State* device_;
  Generation generation_;
  std::vector<HitGroup> groups_;
  vk::raii::DescriptorSetLayout setLayout_{ nullptr };
  vk::raii::DescriptorPool pool_{ nullptr };
  vk::raii::DescriptorSet set_{ nullptr };
  vk::raii::PipelineLayout layout_{ nullptr };
  vk::raii::Pipeline pipeline_{ nullptr };
  Buffer table_;
  vk::StridedDeviceAddressRegionKHR generationTable_, missTable_, hitTable_, callableTable_;
};

} // namespace rtg
