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

  friend bool operator==(const HitGroup& a, const HitGroup& b)
  {
    return a.shape == b.shape && a.sizesPerGlyph == b.sizesPerGlyph && a.turned == b.turned &&
      a.coloured == b.coloured && a.fixedHeads == b.fixedHeads && a.hasTree == b.hasTree &&
      a.ownExponents == b.ownExponents;
  }
};

/// A ray generation program.
enum class Program
{
  Image,
  Probe
};

/// One ray generation program with the hit groups of a scene, and its shader binding table.
class Pipeline
{
public:
  /// Hit group i is the one at shader binding table offset i. Throws vk::SystemError.
  /// `alone`: the scene has a single GlyphSetRecord, FrameRecord::onlySet.
  Pipeline(Device::State& device, Program program, const std::vector<HitGroup>& groups, bool alone);

  Program GetProgram() const { return this->program_; }
  const std::vector<HitGroup>& Groups() const { return this->groups_; }
  bool Alone() const { return this->alone_; }

  /// Binds and launches; `frame` is the uniform block that all programs see. Not while a launch before is still running.
  void Trace(vk::raii::CommandBuffer& command, const Buffer& frame, std::uint32_t width,
    std::uint32_t height) const;

private:
  Device::State* device_;
  Program program_;
  std::vector<HitGroup> groups_;
  bool alone_;
  vk::raii::DescriptorSetLayout setLayout_{ nullptr };
  vk::raii::DescriptorPool pool_{ nullptr };
  vk::raii::DescriptorSet set_{ nullptr };
  vk::raii::PipelineLayout layout_{ nullptr };
  vk::raii::Pipeline pipeline_{ nullptr };
  Buffer table_;
  vk::StridedDeviceAddressRegionKHR generation_, miss_, hit_, callable_;
};

} // namespace rtg
