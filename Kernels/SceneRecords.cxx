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
      ". Show fewer with GlyphMask, or hide other data.");
  }
}

void Scene::State::BuildTopLevel()
{
  Stopwatch watch;
  const bool trees = this->structure == Structure::Tree;
  if (!trees)
  {
    this->CheckInstanceCount();
  }
  std::vector<vk::AccelerationStructureInstanceKHR> instances;
  this->DropTopLevel();
  this->groups.clear();
  this->bounds = Bounds();
  this->moves = false;
  this->placedTimeSliceBits = 0;
  std::uint32_t record = 0;
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    const PlacedGlyphs& placed = set.placed;
    set.listedGroup = placed.group;
    set.listedTranslucent = set.Translucent();
    this->moves |= placed.group.Moves();
    this->placedTimeSliceBits =
      std::max({ this->placedTimeSliceBits, placed.timeSliceBits, placed.mesh.shape.sliceBits });
    auto group = std::find(this->groups.begin(), this->groups.end(), placed.group);
    if (group == this->groups.end())
    {
      group = this->groups.insert(group, placed.group);
    }
    const glm::vec3 offset(set.instances.origin - this->origin);
    for (std::size_t i = 0; !trees && i < placed.runs.size(); ++i)
    {
      vk::AccelerationStructureInstanceKHR instance;
      const std::array<std::array<float, 4>, 3> translation = { { { 1, 0, 0, offset.x }, { 0, 1, 0, offset.y },
        { 0, 0, 1, offset.z } } };
      instance.transform.matrix = translation;
      instance.instanceCustomIndex = record++;
      instance.mask = set.Translucent() ? device::TRANSLUCENT_MASK : device::OPAQUE_MASK;
      instance.instanceShaderBindingTableRecordOffset = static_cast<std::uint32_t>(group - this->groups.begin());
      if (placed.group.DriverTriangles())
      {
        this->AddMeshInstances(set, instance, instances);
        continue;
      }
      instance.accelerationStructureReference = placed.runs[i].structure.Address();
      instances.push_back(instance);
    }
    const float pad = std::ldexp(placed.builtReach, -20);
    this->bounds.Include(set.bounds.lower + offset - pad, set.bounds.upper + offset + pad);
  }
  if (!instances.empty())
  {
    this->topLevel = AccelerationStructure::OverInstances(this->device->GetState(), instances);
  }
  this->statistics.topLevelBuilds += !this->groups.empty();
  this->statistics.buildSeconds += watch.Lap();
}

// In the order of BuildTopLevel()'s instances.
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
      // Of the run's first glyph, or 0.
      const auto at = [&](const Buffer& buffer, std::size_t stride)
      { return buffer.Size() ? buffer.Address() + run.first * stride : 0; };
      record.centres = at(placed.centres, sizeof(glm::vec3));
      // Compilers may load, and drop, what a set lacks where another set of the scene has it: from its centres.
      const auto orCentres = [&](const Buffer& buffer, std::size_t stride)
      { return buffer.Size() ? at(buffer, stride) : record.centres; };
      record.centresLow = orCentres(placed.centresLow, sizeof(glm::vec3));
      record.sizes = orCentres(placed.sizes, placed.group.Has(device::SIZES_EACH) ? sizeof(glm::vec3) : sizeof(float));
      record.rotations = at(placed.rotations, sizeof(glm::vec4));
      record.exponents = orCentres(placed.exponents, sizeof(glm::vec3));
      record.colours = orCentres(placed.colours, sizeof(std::uint32_t));
      record.forms = orCentres(placed.forms, sizeof(glm::vec3));
      const glm::dvec3 offset = set.instances.origin - this->origin;
      record.offset = glm::vec3(offset);
      record.offsetLow = glm::vec3(offset - glm::dvec3(record.offset));
      const ArrowForm& arrow = set.instances.arrow;
      record.arrow = { arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding };
      record.unitLength = arrow.unitLength;
      record.uniformSize = set.instances.uniformSize;
      record.uniformExponents = set.instances.uniformExponents;
      record.tree = placed.tree.Address();
      record.velocities = at(placed.velocities, sizeof(glm::vec3));
      record.accelerations = at(placed.accelerations, sizeof(glm::vec3));
      record.angularVelocities = at(placed.angularVelocities, sizeof(glm::vec3));
      record.treeOrder = at(placed.treeOrder, sizeof(std::uint32_t));
      record.shutterOpen = set.instances.motion.shutterOpen;
      record.shutterLength = set.instances.motion.shutterClose - set.instances.motion.shutterOpen;
      record.timeSliceBits = placed.timeSliceBits;
      record.nodesPerSlice = placed.nodesPerSlice;
      record.treeLevels = placed.treeLevels;
      record.treeLeafBits = placed.treeLeafBits;
      record.glyphCount = run.count;
      record.meshPositions = placed.mesh.positions.Address();
      record.meshTriangles = placed.mesh.triangles.Address();
      record.meshNormals = placed.mesh.normals.Address();
      record.meshColours = placed.mesh.colours.Address();
      record.meshValueCount =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->positionValues.size()) : 0;
      record.meshTableSize =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->valueColours.size()) : 0;
      record.meshTree = placed.mesh.tree.Address();
      record.meshVelocities = placed.mesh.velocities.Address();
      record.meshAccelerations = placed.mesh.accelerations.Address();
      record.meshMiddle = placed.mesh.shape.middle;
      record.meshRadius = placed.mesh.shape.radius;
      record.meshTriangleCount =
        placed.mesh.source ? static_cast<std::uint32_t>(placed.mesh.source->triangles.size()) : 0;
      record.meshTreeLevels = placed.mesh.shape.levels;
      record.meshTreeLeafBits = placed.mesh.shape.leafBits;
      record.meshTimeSliceBits = placed.mesh.shape.sliceBits;
      record.meshNodesPerSlice = placed.mesh.shape.nodesPerSlice;
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
      record.ambientColour = material.ambientColour;
      record.coloured = placed.group.Has(device::COLOURS | device::MESH_COLOURS | device::FORMS);
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
