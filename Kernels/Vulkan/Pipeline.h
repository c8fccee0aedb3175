#pragma once

#include "Buffer.h"

#include "../Glyphs.h"
#include "../HostDevice.h"
#include "../Shading/List.h"

#include <vector>

namespace rtg
{

/// The specialisation constants of a program (Variants.h), as Vulkan takes them.
struct Constants
{
#define RTG_FIELD(id, type, name) std::uint32_t name = 0;
  RTG_CONSTANTS(RTG_FIELD)
#undef RTG_FIELD

  bool operator==(const Constants&) const = default;
};

/// What sets have in common that are traced by the same programs.
struct HitGroup
{
  Shape shape = Shape::Sphere;
  std::uint32_t variants = 0; ///< bits of Variants.h
  std::uint32_t degree = 0;   ///< of polynomials

  bool operator==(const HitGroup&) const = default;
  bool Has(std::uint32_t variant) const { return (this->variants & variant) != 0; }
  void Set(std::uint32_t variant, bool has)
  {
    this->variants = has ? this->variants | variant : this->variants & ~variant;
  }
  bool Moves() const { return this->Has(device::MOVING_GLYPHS | device::MOVING_MESH); }
  /// Whether the driver knows the triangles.
  bool DriverTriangles() const { return this->shape == Shape::Mesh && !this->Has(device::MESH_TREE); }
};

/// The number of the ray generation program that comes after those of Shading/List.h: probe.rgen.
#define RTG_COUNT(...) +1
constexpr std::uint32_t probeProgram = RTG_SHADINGS(RTG_COUNT);
#undef RTG_COUNT

/// The program that starts rays, and what it is specialised for.
struct Generation
{
  std::uint32_t program = 0; ///< number of a shading, or probeProgram
  bool ownTrees = false;     ///< it walks the trees of all sets itself, and there are no hit groups
  Constants constants;

  bool operator==(const Generation&) const = default;
};

/// A program that starts rays: a compute shader, which walks the sets' trees itself, or a ray generation shader with
/// the hit groups of a scene and its shader binding table.
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
  void MakeComputePipeline();
  void MakeRayTracingPipeline();

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
