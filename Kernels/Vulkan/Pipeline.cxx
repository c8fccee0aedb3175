#include "Pipeline.h"

#include "Programs.h"
#include "Specialize.h"

#include <cstddef>
#include <cstring>

namespace rtg
{

namespace
{

// Those of a hit group's programs: every set of theirs is alike.
Constants ConstantsOf(const HitGroup& group, const Generation& generation)
{
  Constants constants = generation.constants;
  constants.shapes = 1u << static_cast<std::uint32_t>(group.shape);
  constants.allHave = group.variants;
  constants.someHave = group.variants | device::ASKED_OF_SETS;
  constants.degree = group.degree;
  return constants;
}

vk::raii::ShaderModule MakeModule(Device::State& device, const programs::Code& code, const Constants& constants)
{
  const std::vector<std::uint32_t> words = Specialize(code, constants);
  return vk::raii::ShaderModule(
    device.device, vk::ShaderModuleCreateInfo({}, words.size() * sizeof(std::uint32_t), words.data()));
}

} // namespace

FrameBlock::FrameBlock(Device::State& device)
  : device_(&device)
  , buffer_(device, sizeof(device::FrameRecord), vk::BufferUsageFlagBits::eUniformBuffer, Buffer::Place::Device)
{
  const vk::DescriptorPoolSize poolSize(vk::DescriptorType::eUniformBuffer, 1);
  this->pool_ = vk::raii::DescriptorPool(
    device.device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, poolSize));
  this->set_ = std::move(device.device.allocateDescriptorSets({ *this->pool_, *device.frameLayout }).front());
  const vk::DescriptorBufferInfo block(this->buffer_.Handle(), 0, this->buffer_.Size());
  device.device.updateDescriptorSets(
    vk::WriteDescriptorSet(*this->set_, 0, 0, vk::DescriptorType::eUniformBuffer, {}, block), {});
}

void FrameBlock::Send(vk::raii::CommandBuffer& command, const device::FrameRecord& frame)
{
  if (this->buffer_.Mapped())
  {
    this->buffer_.Upload(&frame, sizeof(frame));
    return;
  }
  command.updateBuffer<device::FrameRecord>(this->buffer_.Handle(), 0, frame);
  Barrier(command, vk::PipelineStageFlagBits::eTransfer, vk::AccessFlagBits::eTransferWrite,
    this->device_->programStages, vk::AccessFlagBits::eUniformRead | vk::AccessFlagBits::eShaderRead);
}

Pipeline::Pipeline(Device::State& device, const Generation& generation, const std::vector<HitGroup>& groups)
  : device_(&device)
  , ownTrees_(generation.ownTrees)
{
  if (generation.ownTrees)
  {
    this->MakeComputePipeline(generation);
  }
  else
  {
    this->MakeRayTracingPipeline(generation, groups);
  }
}

void Pipeline::MakeComputePipeline(const Generation& generation)
{
  const vk::raii::ShaderModule module =
    MakeModule(*this->device_, programs::ownTreesGeneration[generation.program], generation.constants);
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
  this->pipeline_ = vk::raii::Pipeline(this->device_->device, this->device_->programCache,
    vk::ComputePipelineCreateInfo({}, stage, *this->device_->programLayout));
}

void Pipeline::MakeRayTracingPipeline(const Generation& generation, const std::vector<HitGroup>& groups)
{
  using Stage = vk::ShaderStageFlagBits;
  Device::State& device = *this->device_;
  // Ray generation and miss, then two stages a hit group. Every group has stage entries of its own:
  // lavapipe mixes up groups that share one.
  std::vector<vk::raii::ShaderModule> modules;
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  std::vector<Constants> constants(groups.size());
  modules.reserve(2 + 2 * groups.size());
  const auto addStage = [&](Stage stage, const programs::Code& code, const Constants& values)
  {
    modules.push_back(MakeModule(device, code, values));
    stages.emplace_back(vk::PipelineShaderStageCreateFlags(), stage, *modules.back(), "main");
    return static_cast<std::uint32_t>(stages.size() - 1);
  };
  std::vector<vk::RayTracingShaderGroupCreateInfoKHR> shaderGroups;
  const auto addGeneral = [&](std::uint32_t stage)
  {
    shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eGeneral, stage, VK_SHADER_UNUSED_KHR,
      VK_SHADER_UNUSED_KHR, VK_SHADER_UNUSED_KHR);
  };
  addGeneral(addStage(Stage::eRaygenKHR, programs::drivenGeneration[generation.program], generation.constants));
  addGeneral(addStage(Stage::eMissKHR, programs::nothingMiss, generation.constants));
  const std::size_t hitGroups = groups.size();
  for (std::size_t i = 0; i < hitGroups; ++i)
  {
    const HitGroup& group = groups[i];
    constants[i] = ConstantsOf(group, generation);
    if (group.DriverTriangles())
    {
      const std::uint32_t closestHit = addStage(Stage::eClosestHitKHR, programs::triangleClosestHit, constants[i]);
      shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eTrianglesHitGroup, VK_SHADER_UNUSED_KHR, closestHit,
        VK_SHADER_UNUSED_KHR, VK_SHADER_UNUSED_KHR);
      continue;
    }
    const bool mesh = group.shape == Shape::Mesh;
    const std::uint32_t intersection =
      addStage(Stage::eIntersectionKHR, mesh ? programs::meshIntersection : programs::glyphIntersection, constants[i]);
    const std::uint32_t closestHit =
      addStage(Stage::eClosestHitKHR, mesh ? programs::meshClosestHit : programs::glyphClosestHit, constants[i]);
    shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eProceduralHitGroup, VK_SHADER_UNUSED_KHR, closestHit,
      VK_SHADER_UNUSED_KHR, intersection);
  }

  const vk::RayTracingPipelineCreateInfoKHR info(
    {}, stages, shaderGroups, 1, nullptr, nullptr, nullptr, *device.programLayout);
  this->pipeline_ = vk::raii::Pipeline(device.device, nullptr, device.programCache, info);

  // Shader binding table: three regions of equally spaced handles.
  const std::size_t handleSize = device.pipelineLimits.shaderGroupHandleSize;
  const std::size_t stride = AlignUp(handleSize, device.pipelineLimits.shaderGroupHandleAlignment);
  const std::size_t base = device.pipelineLimits.shaderGroupBaseAlignment;
  const auto handles = this->pipeline_.getRayTracingShaderGroupHandlesKHR<std::uint8_t>(
    0, static_cast<std::uint32_t>(shaderGroups.size()), handleSize * shaderGroups.size());
  const std::size_t missAt = AlignUp(stride, base);
  const std::size_t hitAt = missAt + AlignUp(stride, base);
  std::vector<std::uint8_t> table(hitAt + stride * hitGroups);
  std::memcpy(table.data(), handles.data(), handleSize);
  std::memcpy(table.data() + missAt, handles.data() + handleSize, handleSize);
  for (std::size_t i = 0; i < hitGroups; ++i)
  {
    std::memcpy(table.data() + hitAt + i * stride, handles.data() + (2 + i) * handleSize, handleSize);
  }
  // The buffer's address need not be aligned to the table's base, so room is left to shift it.
  this->table_ =
    Buffer(device, table.size() + base, vk::BufferUsageFlagBits::eShaderBindingTableKHR, Buffer::Place::Device);
  const vk::DeviceAddress address = AlignUp(this->table_.Address(), base);
  table.insert(table.begin(), address - this->table_.Address(), 0);
  this->table_.Upload(table.data(), table.size());
  this->generationTable_ = vk::StridedDeviceAddressRegionKHR(address, stride, stride);
  this->missTable_ = vk::StridedDeviceAddressRegionKHR(address + missAt, stride, stride);
  if (hitGroups > 0)
  {
    this->hitTable_ = vk::StridedDeviceAddressRegionKHR(address + hitAt, stride, stride * hitGroups);
  }
}

void Pipeline::Trace(
  vk::raii::CommandBuffer& command, const FrameBlock& frame, std::uint32_t width, std::uint32_t height) const
{
  const auto point = this->ownTrees_ ? vk::PipelineBindPoint::eCompute : vk::PipelineBindPoint::eRayTracingKHR;
  command.bindPipeline(point, *this->pipeline_);
  command.bindDescriptorSets(point, *this->device_->programLayout, 0, frame.Descriptor(), {});
  if (this->ownTrees_)
  {
    command.dispatch(width / device::LAUNCH_GROUP, height, 1);
    return;
  }
  command.traceRaysKHR(
    this->generationTable_, this->missTable_, this->hitTable_, this->callableTable_, width, height, 1);
}

} // namespace rtg
