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
      a.coloured == b.coloured && a.fixedHeads == b.fixedHeads && a.hasTree == b.hasTree && a.ownExponents == b.ownExponents;
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
  Pipeline(Device::State& device, Program program, const std::vector<HitGroup>& groups);

  Program GetProgram() const { return this->program_; }
  const std::vector<HitGroup>& Groups() const { return this->groups_; }

  /// Binds and launches; `push` is the push constant block.
  void Trace(vk::raii::CommandBuffer& command, const void* push, std::uint32_t pushSize,
    std::uint32_t width, std::uint32_t height) const;

private:
  Program program_;
  std::vector<HitGroup> groups_;
  vk::raii::PipelineLayout layout_{ nullptr };
  vk::raii::Pipeline pipeline_{ nullptr };
  Buffer table_;
  vk::StridedDeviceAddressRegionKHR generation_, miss_, hit_, callable_;
};

} // namespace rtg
