#pragma once

#include "Buffer.h"

#include "../Glyphs.h"
#include "../HostDevice.h"
#include "../Shading/List.h"

#include <cstddef>
#include <vector>

namespace rtg
{

/// The specialisation constants of a program (Variants.h), by which Specialize() makes it.
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
  /// What their programs are made for.
  HitGroup OfPrograms() const { return { this->shape, this->variants & ~device::ASKED_OF_SETS, this->degree }; }
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

/// The uniform block of a launch, and the descriptor by which programs see it.
class FrameBlock
{
public:
  FrameBlock() = default; ///< none
  explicit FrameBlock(Device::State& device);

  bool Exists() const { return this->buffer_.Size() > 0; }
  /// For the launches that are recorded after it. Not while one before is still running.
  void Send(vk::raii::CommandBuffer& command, const device::FrameRecord& frame);
  vk::DescriptorSet Descriptor() const { return *this->set_; }
  /// Of the block's own few lights.
  vk::DeviceAddress Lights() const { return this->buffer_.Address() + offsetof(device::FrameRecord, fewLights); }

private:
  Device::State* device_ = nullptr;
  Buffer buffer_;
  vk::raii::DescriptorPool pool_{ nullptr };
  vk::raii::DescriptorSet set_{ nullptr };
};

/// A program that starts rays: a compute shader, which walks the sets' trees itself, or a ray generation shader with
/// the hit groups of a scene and its shader binding table.
class Pipeline
{
public:
  /// Hit group i is the one at shader binding table offset i. Throws vk::SystemError.
  Pipeline(Device::State& device, const Generation& generation, const std::vector<HitGroup>& groups);

  /// Binds and launches; `frame` is the uniform block that all programs see. In any thread.
  void
  Trace(vk::raii::CommandBuffer& command, const FrameBlock& frame, std::uint32_t width, std::uint32_t height) const;

private:
  void MakeComputePipeline(const Generation& generation);
  void MakeRayTracingPipeline(const Generation& generation, const std::vector<HitGroup>& groups);

  Device::State* device_;
  bool ownTrees_;
  vk::raii::Pipeline pipeline_{ nullptr };
  Buffer table_;
  vk::StridedDeviceAddressRegionKHR generationTable_, missTable_, hitTable_, callableTable_;
};

} // namespace rtg
