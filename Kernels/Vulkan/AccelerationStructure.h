#pragma once

#include "Buffer.h"

#include <vector>

namespace rtg
{

/// A bottom- or top-level acceleration structure with the memory that holds it. It is built with the thread's Batch,
/// which there must be.
class AccelerationStructure
{
public:
  AccelerationStructure() = default;

  /// Over axis-aligned boxes, one procedural opaque primitive each. `boxes` are VkAabbPositionsKHR.
  static AccelerationStructure OverBoxes(Device::State& device, const std::vector<vk::AabbPositionsKHR>& boxes);

  /// Over opaque triangles: `positions` are so many vec3, `indices` three 32-bit numbers a triangle. Both buffers need
  /// the usage eAccelerationStructureBuildInputReadOnlyKHR.
  static AccelerationStructure OverTriangles(Device::State& device, const Buffer& positions,
    std::uint32_t positionCount, const Buffer& indices, std::uint32_t triangleCount);

  /// Over instances of bottom-level structures.
  static AccelerationStructure
  OverInstances(Device::State& device, const std::vector<vk::AccelerationStructureInstanceKHR>& instances);

  vk::DeviceAddress Address() const { return this->address_; }

private:
  AccelerationStructure(Device::State& device, const vk::AccelerationStructureGeometryKHR& geometry,
    vk::AccelerationStructureTypeKHR type, std::uint32_t count, Buffer&& input);

  Buffer storage_;
  vk::raii::AccelerationStructureKHR structure_{ nullptr };
  vk::DeviceAddress address_ = 0;
};

} // namespace rtg
