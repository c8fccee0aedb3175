// The part of a scene that places its sets beside each other, and tells the device's programs about each.
#include "SceneState.h"

#include "Stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtg
{

namespace
{

// Share of light that a surface of that refractive index reflects straight back (Fresnel).
float NormalReflectance(float ior)
{
  const float root = (ior - 1.0f) / (ior + 1.0f);
  return root * root;
}

} // namespace

// Every mesh glyph at rest is an instance of the driver's structure, every other set one or a few.
void Scene::State::CheckInstanceCount() const
{
  std::size_t count = 0;
  for (const auto& [id, set] : this->sets)
  {
    const HitGroup& group = set.placed.group;
    count += !set.Shown() ? 0 : group.DriverTriangles() ? set.count : set.placed.runs.size();
  }
  if (count > this->mostInstances)
  {
    throw Error("Ray Traced Glyphs: the view shows " + std::to_string(count) + " mesh glyphs; the most that '" +
      this->device->Name() + "' can show is " + std::to_string(this->mostInstances) +
      ". Show fewer with GlyphMode, or hide other data.");
  }
}

void Scene::State::BuildTopLevels()
{
  Stopwatch watch;
  if (this->structure == Structure::Boxes)
  {
    this->CheckInstanceCount();
  }
  this->DropTopLevels();
  this->ListSets();
  if (this->structure == Structure::Boxes && !this->groups.empty())
  {
    std::uint32_t sliceBits = 0;
    for (const auto& [id, set] : this->sets)
    {
      sliceBits = std::max(sliceBits, set.Shown() ? set.placed.sliceBits : 0);
    }
    std::vector<vk::DeviceAddress> addresses;
    for (std::uint32_t slice = 0; slice < 1u << sliceBits; ++slice)
    {
      this->topLevels.push_back(
        AccelerationStructure::OverInstances(this->device->GetState(), this->InstancesIn(slice, sliceBits)));
      addresses.push_back(this->topLevels.back().Address());
    }
    this->topLevelAddresses = Send(this->device->GetState(), addresses);
  }
  this->statistics.topLevelBuilds += !this->groups.empty();
  this->statistics.buildSeconds += watch.Lap();
}

// What the visible sets have in common and what tells them apart.
void Scene::State::ListSets()
{
  this->groups.clear();
  this->bounds = Box();
  this->moves = false;
  this->placedTimeSliceBits = 0;
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    const PlacedGlyphs& placed = set.placed;
    set.listedGroup = placed.group.OfPrograms();
    set.listedMask = set.Mask();
    this->moves |= placed.group.Moves();
    this->placedTimeSliceBits =
      std::max({ this->placedTimeSliceBits, placed.sliceBits, placed.mesh.tree.record.sliceBits });
    if (std::find(this->groups.begin(), this->groups.end(), set.listedGroup) == this->groups.end())
    {
      this->groups.push_back(set.listedGroup);
    }
    const glm::vec3 offset(set.instances.origin - this->origin);
    const Box moved{ set.bounds.lower + offset, set.bounds.upper + offset };
    this->bounds.Include(moved.Widened(SlabPadding(moved.Reach())));
  }
}

// Of the top-level structure of a slice, out of 2^sliceBits.
std::vector<vk::AccelerationStructureInstanceKHR>
Scene::State::InstancesIn(std::uint32_t slice, std::uint32_t sliceBits)
{
  std::vector<vk::AccelerationStructureInstanceKHR> instances;
  std::uint32_t record = 0;
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    const PlacedGlyphs& placed = set.placed;
    const auto group = std::find(this->groups.begin(), this->groups.end(), set.listedGroup);
    const glm::vec3 offset(set.instances.origin - this->origin);
    for (const GlyphRun& run : placed.runs)
    {
      vk::AccelerationStructureInstanceKHR instance;
      const std::array<std::array<float, 4>, 3> translation = { { { 1, 0, 0, offset.x }, { 0, 1, 0, offset.y },
        { 0, 0, 1, offset.z } } };
      instance.transform.matrix = translation;
      instance.instanceCustomIndex = record++;
      instance.mask = set.Mask();
      instance.instanceShaderBindingTableRecordOffset = static_cast<std::uint32_t>(group - this->groups.begin());
      if (placed.group.DriverTriangles())
      {
        this->AddMeshInstances(set, instance, instances);
        continue;
      }
      instance.accelerationStructureReference = run.structures[slice >> (sliceBits - placed.sliceBits)].Address();
      instances.push_back(instance);
    }
  }
  return instances;
}

// In the order of InstancesIn().
void Scene::State::FillRecords()
{
  std::vector<device::GlyphSetRecord> filled;
  for (const auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    const PlacedGlyphs& placed = set.placed;
    for (const GlyphRun& run : placed.runs)
    {
      device::GlyphSetRecord record{};
      // The values of the run's first glyph. What a set lacks and another set of the scene has points at the centres,
      // or where the driver's instances have these, at the mesh's positions: a compiler may load it, for the first
      // glyph (InSet in bindings.glsl), and drop it.
      const vk::DeviceAddress anything = placed.arrays[0].Size()
        ? placed.arrays[0].Address() + run.first * sizeof(glm::vec3)
        : placed.mesh.positions.Address();
      const auto at = [&](const Buffer& buffer, std::size_t stride)
      { return buffer.Size() ? buffer.Address() + run.first * stride : anything; };
      const GlyphInstances& instances = set.instances;
      const GlyphColours& colours = set.colours;
#define RTG_FILL(number, BIT, type, name, values, words) record.name = at(placed.arrays[number], Stride(values));
      RTG_GLYPH_ARRAYS(RTG_FILL)
#undef RTG_FILL
      const glm::dvec3 offset = set.instances.origin - this->origin;
      record.offset = glm::vec3(offset);
      record.offsetLow = glm::vec3(offset - glm::dvec3(record.offset));
      const ArrowForm& arrow = set.instances.arrow;
      record.arrow = { arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding };
      record.unitLength = arrow.unitLength;
      record.uniformSize = set.instances.uniformSize;
      record.uniformExponents = set.instances.uniformExponents;
      record.polynomialWidth = static_cast<std::uint32_t>(set.instances.polynomials.width);
      record.polynomialDegree = static_cast<std::uint32_t>(set.instances.polynomialDegree);
      record.tree = placed.tree.record;
      record.tree.order = at(placed.tree.order, sizeof(std::uint32_t));
      record.shutterOpen = set.instances.motion.shutterOpen;
      record.shutterLength = set.instances.motion.shutterClose - set.instances.motion.shutterOpen;
      record.glyphCount = run.count;
      record.meshPositions = placed.mesh.positions.Address();
      record.meshTriangles = placed.mesh.triangles.Address();
      const auto ofMesh = [&](const Buffer& buffer) { return buffer.Size() ? buffer.Address() : record.meshPositions; };
      record.meshNormals = ofMesh(placed.mesh.normals);
      record.meshColours = ofMesh(placed.mesh.colours);
      record.meshValueCount =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->positionValues.size()) : 0;
      record.meshTableSize =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->valueColours.size()) : 0;
      record.meshTree = placed.mesh.tree.record;
      record.meshVelocities = ofMesh(placed.mesh.velocities);
      record.meshAccelerations = ofMesh(placed.mesh.accelerations);
      record.meshMiddle = placed.mesh.middle;
      record.meshRadius = placed.mesh.radius;
      record.meshTriangleCount =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->triangles.size()) : 0;
      record.firstInstance = set.firstInstance;
      record.identifiesTriangles = set.instances.identifyTriangles;
      record.shape = static_cast<std::uint32_t>(placed.group.shape);
      record.variants = placed.group.variants;
      record.setId = id;
      record.firstGlyph = run.first;
      const Material& material = set.material;
      record.colour = material.colour;
      record.opacity = material.opacity;
      record.translucent = set.Translucent();
      record.mask = set.Mask();
      record.ambientColour = material.ambientColour;
      record.coloured = placed.group.Has(device::COLOURS | device::END_COLOURS | device::MESH_COLOURS | device::FORMS |
        device::SIGN_COLOURS | device::DIRECTION_COLOURS);
      record.colourTable = at(placed.colourTable, 0);
      record.colourTableSize = static_cast<std::uint32_t>(colours.table.size());
      record.positiveColour = material.positiveColour;
      record.negativeColour = material.negativeColour;
      record.specularColour = material.specularColour;
      record.specular = material.specular;
      record.ambient = material.ambient;
      record.diffuse = material.diffuse;
      record.specularPower = material.specularPower;
      record.lighting = material.lighting;
      record.metallic = material.metallic;
      record.roughness = material.roughness;
      record.coatStrength = material.coatStrength;
      record.coatRoughness = material.coatRoughness;
      record.coatReflectance = NormalReflectance(material.coatIor);
      record.coatColour = material.coatColour;
      filled.push_back(record);
    }
  }
  this->recordBuffer = Send(this->device->GetState(), filled);
  this->records = std::move(filled);
}

} // namespace rtg
