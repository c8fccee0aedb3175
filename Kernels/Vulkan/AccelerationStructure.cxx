#include "AccelerationStructure.h"

#include "Batch.h"

#include <utility>

namespace rtg
{

using Usage = vk::BufferUsageFlagBits;

AccelerationStructure::AccelerationStructure(Device::State& device,
  const vk::AccelerationStructureGeometryKHR& geometry, vk::AccelerationStructureTypeKHR type, std::uint32_t count,
  Buffer&& input)
{
  vk::AccelerationStructureBuildGeometryInfoKHR info(type, vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace);
  info.setGeometries(geometry);
  const vk::AccelerationStructureBuildSizesInfoKHR sizes =
    device.device.getAccelerationStructureBuildSizesKHR(vk::AccelerationStructureBuildTypeKHR::eDevice, info, count);

  this->storage_ =
    Buffer(device, sizes.accelerationStructureSize, Usage::eAccelerationStructureStorageKHR, Buffer::Place::Device);
  this->structure_ = vk::raii::AccelerationStructureKHR(device.device,
    vk::AccelerationStructureCreateInfoKHR({}, this->storage_.Handle(), 0, sizes.accelerationStructureSize, type));

  info.dstAccelerationStructure = *this->structure_;
  device.batch->Build(info, geometry, count, sizes.buildScratchSize, std::move(input));
  this->address_ =
    device.device.getAccelerationStructureAddressKHR(vk::AccelerationStructureDeviceAddressInfoKHR(*this->structure_));
}

AccelerationStructure
AccelerationStructure::OverBoxes(Device::State& device, const std::vector<vk::AabbPositionsKHR>& boxes)
{
  Buffer input = Send(device, boxes, Usage::eAccelerationStructureBuildInputReadOnlyKHR);
  const vk::AccelerationStructureGeometryAabbsDataKHR data(input.Address(), sizeof(boxes[0]));
  const vk::AccelerationStructureGeometryKHR geometry(
    vk::GeometryTypeKHR::eAabbs, data, vk::GeometryFlagBitsKHR::eOpaque);
  return AccelerationStructure(device, geometry, vk::AccelerationStructureTypeKHR::eBottomLevel,
    static_cast<std::uint32_t>(boxes.size()), std::move(input));
}

AccelerationStructure AccelerationStructure::OverTriangles(Device::State& device, const Buffer& positions,
  std::uint32_t positionCount, const Buffer& indices, std::uint32_t triangleCount)
{
  const vk::AccelerationStructureGeometryTrianglesDataKHR data(vk::Format::eR32G32B32Sfloat, positions.Address(),
    3 * sizeof(float), positionCount - 1, vk::IndexType::eUint32, indices.Address());
  const vk::AccelerationStructureGeometryKHR geometry(
    vk::GeometryTypeKHR::eTriangles, data, vk::GeometryFlagBitsKHR::eOpaque);
  return AccelerationStructure(
    device, geometry, vk::AccelerationStructureTypeKHR::eBottomLevel, triangleCount, Buffer());
}

AccelerationStructure AccelerationStructure::OverInstances(
  Device::State& device, const std::vector<vk::AccelerationStructureInstanceKHR>& instances)
{
  Buffer input = Send(device, instances, Usage::eAccelerationStructureBuildInputReadOnlyKHR);
  const vk::AccelerationStructureGeometryInstancesDataKHR data(false, input.Address());
  const vk::AccelerationStructureGeometryKHR geometry(
    vk::GeometryTypeKHR::eInstances, data, vk::GeometryFlagBitsKHR::eOpaque);
  return AccelerationStructure(device, geometry, vk::AccelerationStructureTypeKHR::eTopLevel,
    static_cast<std::uint32_t>(instances.size()), std::move(input));
}

} // namespace rtg
