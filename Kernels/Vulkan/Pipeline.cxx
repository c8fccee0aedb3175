#include "Pipeline.h"

namespace rtg
{

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

Pipeline::Pipeline(Device::State& device, const programs::Code& code, const Constants& constants)
  : device_(&device)
{
  const std::vector<std::uint32_t> words = Specialize(code, constants);
  const vk::raii::ShaderModule module(
    device.device, vk::ShaderModuleCreateInfo({}, words.size() * sizeof(words[0]), words.data()));
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
  this->pipeline_ =
    vk::raii::Pipeline(device.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *device.programLayout));
}

void Pipeline::Trace(
  vk::raii::CommandBuffer& command, const FrameBlock& frame, std::uint32_t width, std::uint32_t height) const
{
  constexpr auto point = vk::PipelineBindPoint::eCompute;
  command.bindPipeline(point, *this->pipeline_);
  command.bindDescriptorSets(point, *this->device_->programLayout, 0, frame.Descriptor(), {});
  command.dispatch(width / device::LAUNCH_GROUP, height, 1);
}

} // namespace rtg
