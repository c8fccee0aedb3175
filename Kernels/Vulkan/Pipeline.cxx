#include "Pipeline.h"

#include "Programs.h"

#include <algorithm>
#include <cstring>

namespace rtg
{

namespace
{

struct Specialisation
{
  std::uint32_t sizesPerGlyph;
  vk::Bool32 turned;
  vk::Bool32 coloured;
  vk::Bool32 fixedHeads;
  vk::Bool32 hasTree;
  vk::Bool32 ownExponents;
  vk::Bool32 smoothNormals;
  std::uint32_t meshColours;
  vk::Bool32 colouredByForm;
  vk::Bool32 translucency;
  vk::Bool32 alone;
  vk::Bool32 leavesSurface;
  vk::Bool32 hasVelocities;
  vk::Bool32 hasAccelerations;
  vk::Bool32 spins;
  vk::Bool32 ownTreeOrder;
  vk::Bool32 dropsHidden;
  vk::Bool32 meshVelocities;
  vk::Bool32 meshAccelerations;
  vk::Bool32 exactCentres;
};

const vk::SpecializationMapEntry specialisationMap[] = {
  { 0, offsetof(Specialisation, sizesPerGlyph), sizeof(std::uint32_t) },
  { 1, offsetof(Specialisation, turned), sizeof(vk::Bool32) },
  { 2, offsetof(Specialisation, coloured), sizeof(vk::Bool32) },
  { 3, offsetof(Specialisation, fixedHeads), sizeof(vk::Bool32) },
  { 4, offsetof(Specialisation, hasTree), sizeof(vk::Bool32) },
  { 5, offsetof(Specialisation, ownExponents), sizeof(vk::Bool32) },
  { 6, offsetof(Specialisation, smoothNormals), sizeof(vk::Bool32) },
  { 7, offsetof(Specialisation, meshColours), sizeof(std::uint32_t) },
  { 8, offsetof(Specialisation, colouredByForm), sizeof(vk::Bool32) },
  { 14, offsetof(Specialisation, translucency), sizeof(vk::Bool32) },
  { 15, offsetof(Specialisation, alone), sizeof(vk::Bool32) },
  { 20, offsetof(Specialisation, leavesSurface), sizeof(vk::Bool32) },
  { 30, offsetof(Specialisation, hasVelocities), sizeof(vk::Bool32) },
  { 31, offsetof(Specialisation, hasAccelerations), sizeof(vk::Bool32) },
  { 32, offsetof(Specialisation, spins), sizeof(vk::Bool32) },
  { 34, offsetof(Specialisation, ownTreeOrder), sizeof(vk::Bool32) },
  { 36, offsetof(Specialisation, dropsHidden), sizeof(vk::Bool32) },
  { 40, offsetof(Specialisation, meshVelocities), sizeof(vk::Bool32) },
  { 41, offsetof(Specialisation, meshAccelerations), sizeof(vk::Bool32) },
  { 42, offsetof(Specialisation, exactCentres), sizeof(vk::Bool32) },
};

// Shading/Sampling.glsl, Programs/pixel.glsl, Programs/bindings.glsl, Programs/layers.glsl
struct GenerationSpecialisation
{
  std::uint32_t sampler;
  vk::Bool32 accumulates;
  vk::Bool32 gathersFeatures;
  vk::Bool32 develops;
  vk::Bool32 translucency;
  vk::Bool32 alone;
  vk::Bool32 moves;
  vk::Bool32 environmentImage;
  vk::Bool32 layered;
};

const vk::SpecializationMapEntry generationMap[] = {
  { 10, offsetof(GenerationSpecialisation, sampler), sizeof(std::uint32_t) },
  { 11, offsetof(GenerationSpecialisation, accumulates), sizeof(vk::Bool32) },
  { 12, offsetof(GenerationSpecialisation, gathersFeatures), sizeof(vk::Bool32) },
  { 13, offsetof(GenerationSpecialisation, develops), sizeof(vk::Bool32) },
  { 14, offsetof(GenerationSpecialisation, translucency), sizeof(vk::Bool32) },
  { 15, offsetof(GenerationSpecialisation, alone), sizeof(vk::Bool32) },
  { 33, offsetof(GenerationSpecialisation, moves), sizeof(vk::Bool32) },
  { 35, offsetof(GenerationSpecialisation, environmentImage), sizeof(vk::Bool32) },
  { 38, offsetof(GenerationSpecialisation, layered), sizeof(vk::Bool32) },
};

const programs::Code& CodeOf(const Generation& generation, const std::vector<HitGroup>& groups)
{
  if (generation.whole)
  {
    return programs::shapes[static_cast<std::uint32_t>(groups.front().shape)]
      .whole[static_cast<std::uint32_t>(generation.program)];
  }
  switch (generation.program)
  {
    case Program::Local:
      return programs::imageGeneration;
    case Program::Occlusion:
      return programs::occlusionGeneration;
    case Program::Path:
      return programs::pathGeneration;
    default:
      return programs::probeGeneration;
  }
}

Specialisation ConstantsOf(const HitGroup& group, const Generation& generation)
{
  const vk::Bool32 leavesSurface =
    generation.program == Program::Occlusion || generation.program == Program::Path || generation.layered;
  return { group.sizesPerGlyph, group.turned, group.coloured, group.fixedHeads, group.hasTree, group.ownExponents,
    group.smoothNormals, group.meshColours, group.colouredByForm, generation.translucency, generation.alone,
    leavesSurface, group.hasVelocities, group.hasAccelerations, group.spins, group.ownTreeOrder, group.dropsHidden,
    group.meshVelocities, group.meshAccelerations, group.exactCentres };
}

// What ray generation programs are specialised for; those of whole scenes for their only set, too.
struct GenerationConstants
{
  GenerationSpecialisation generation;
  Specialisation set;
};

std::vector<vk::SpecializationMapEntry> GenerationMap(bool whole)
{
  std::vector<vk::SpecializationMapEntry> entries(std::begin(generationMap), std::end(generationMap));
  for (vk::SpecializationMapEntry entry : specialisationMap)
  {
    const bool known = std::any_of(std::begin(generationMap), std::end(generationMap),
      [&entry](const auto& e) { return e.constantID == entry.constantID; });
    if (whole && !known)
    {
      entry.offset += offsetof(GenerationConstants, set);
      entries.push_back(entry);
    }
  }
  return entries;
}

vk::raii::ShaderModule MakeModule(Device::State& device, const programs::Code& code)
{
  return vk::raii::ShaderModule(device.device, vk::ShaderModuleCreateInfo({}, code.bytes, code.words));
}

std::size_t AlignUp(std::size_t value, std::size_t alignment)
{
  return (value + alignment - 1) / alignment * alignment;
}

} // namespace

bool CanBeWhole(const Generation& generation, const std::vector<HitGroup>& groups)
{
  return generation.alone && groups.size() == 1 && groups.front().hasTree && generation.program != Program::Probe &&
    programs::shapes[static_cast<std::uint32_t>(groups.front().shape)].whole[0].words;
}

Pipeline::Pipeline(Device::State& device, const Generation& generation, const std::vector<HitGroup>& groups)
  : device_(&device)
  , generation_(generation)
  , groups_(groups)
{
  using Stage = vk::ShaderStageFlagBits;
  const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eUniformBuffer, 1,
    Stage::eRaygenKHR | Stage::eIntersectionKHR | Stage::eClosestHitKHR | Stage::eMissKHR);
  this->setLayout_ = vk::raii::DescriptorSetLayout(device.device, vk::DescriptorSetLayoutCreateInfo({}, binding));
  const vk::DescriptorPoolSize poolSize(vk::DescriptorType::eUniformBuffer, 1);
  this->pool_ = vk::raii::DescriptorPool(
    device.device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, poolSize));
  this->set_ = std::move(device.device.allocateDescriptorSets({ *this->pool_, *this->setLayout_ }).front());
  this->layout_ = vk::raii::PipelineLayout(device.device, vk::PipelineLayoutCreateInfo({}, *this->setLayout_));

  // Ray generation and miss, then two stages a hit group. Every group has stage entries of its own:
  // lavapipe mixes up groups that share one.
  std::vector<vk::raii::ShaderModule> modules;
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  std::vector<Specialisation> constants(groups.size());
  std::vector<vk::SpecializationInfo> specialisations(groups.size());
  modules.reserve(2 + 2 * groups.size());
  const auto addStage = [&](Stage stage, const programs::Code& code, const vk::SpecializationInfo* special)
  {
    modules.push_back(MakeModule(device, code));
    stages.emplace_back(vk::PipelineShaderStageCreateFlags(), stage, *modules.back(), "main", special);
    return static_cast<std::uint32_t>(stages.size() - 1);
  };
  std::vector<vk::RayTracingShaderGroupCreateInfoKHR> shaderGroups;
  GenerationConstants generationConstants{};
  generationConstants.generation = { generation.sampler, generation.accumulates, generation.gathersFeatures,
    generation.develops, generation.translucency, generation.alone, generation.moves, generation.environmentImage,
    generation.layered };
  if (generation.whole)
  {
    generationConstants.set = ConstantsOf(groups.front(), generation);
  }
  const std::vector<vk::SpecializationMapEntry> entries = GenerationMap(generation.whole);
  const vk::SpecializationInfo generationInfo(
    static_cast<std::uint32_t>(entries.size()), entries.data(), sizeof(generationConstants), &generationConstants);
  const auto addGeneral = [&](std::uint32_t stage)
  {
    shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eGeneral, stage, VK_SHADER_UNUSED_KHR,
      VK_SHADER_UNUSED_KHR, VK_SHADER_UNUSED_KHR);
  };
  addGeneral(addStage(Stage::eRaygenKHR, CodeOf(generation, groups), &generationInfo));
  addGeneral(addStage(Stage::eMissKHR, programs::nothingMiss, nullptr));
  const std::size_t hitGroups = generation.whole ? 0 : groups.size();
  for (std::size_t i = 0; i < hitGroups; ++i)
  {
    const HitGroup& group = groups[i];
    constants[i] = ConstantsOf(group, generation);
    specialisations[i] = vk::SpecializationInfo(static_cast<std::uint32_t>(std::size(specialisationMap)),
      specialisationMap, sizeof(Specialisation), &constants[i]);
    if (group.shape == Shape::Mesh && !group.meshTree)
    {
      const std::uint32_t closestHit =
        addStage(Stage::eClosestHitKHR, programs::triangleClosestHit, &specialisations[i]);
      shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eTrianglesHitGroup, VK_SHADER_UNUSED_KHR, closestHit,
        VK_SHADER_UNUSED_KHR, VK_SHADER_UNUSED_KHR);
      continue;
    }
    const programs::ShapeCode& code = programs::shapes[static_cast<std::uint32_t>(group.shape)];
    const std::uint32_t intersection =
      addStage(Stage::eIntersectionKHR, group.hasTree ? code.treeIntersection : code.intersection, &specialisations[i]);
    const std::uint32_t closestHit = addStage(Stage::eClosestHitKHR, code.closestHit, &specialisations[i]);
    shaderGroups.emplace_back(vk::RayTracingShaderGroupTypeKHR::eProceduralHitGroup, VK_SHADER_UNUSED_KHR, closestHit,
      VK_SHADER_UNUSED_KHR, intersection);
  }

  const vk::RayTracingPipelineCreateInfoKHR info(
    {}, stages, shaderGroups, 1, nullptr, nullptr, nullptr, *this->layout_);
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
  vk::raii::CommandBuffer& command, const Buffer& frame, std::uint32_t width, std::uint32_t height) const
{
  const vk::DescriptorBufferInfo block(frame.Handle(), 0, frame.Size());
  this->device_->device.updateDescriptorSets(
    vk::WriteDescriptorSet(*this->set_, 0, 0, vk::DescriptorType::eUniformBuffer, {}, block), {});
  command.bindPipeline(vk::PipelineBindPoint::eRayTracingKHR, *this->pipeline_);
  command.bindDescriptorSets(vk::PipelineBindPoint::eRayTracingKHR, *this->layout_, 0, *this->set_, {});
  command.traceRaysKHR(
    this->generationTable_, this->missTable_, this->hitTable_, this->callableTable_, width, height, 1);
}

} // namespace rtg
