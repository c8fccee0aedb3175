// The part of a scene that places its sets beside each other, and writes the record of each.
#include "SceneState.h"

#include "Frame.h"
#include "GlyphChecks.h"
#include "Stopwatch.h"

#include <algorithm>
#include <array>

namespace rtg
{

// Every mesh glyph at rest is an instance of the driver's structure, every other set one, and its periodic images.
void Scene::State::CheckInstanceCount() const
{
  std::size_t count = 0;
  for (const auto& [id, set] : this->sets)
  {
    count += !set.Shown() ? 0 : set.DriverTriangles() ? set.count : set.Images().size();
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
  const bool any =
    std::any_of(this->sets.begin(), this->sets.end(), [](const auto& entry) { return entry.second.Shown(); });
  if (this->structure == Structure::Boxes && any)
  {
    std::uint32_t sliceBits = 0;
    for (const auto& [id, set] : this->sets)
    {
      sliceBits = std::max(sliceBits, set.Shown() ? set.placed.sliceBits : 0);
    }
    std::vector<vk::DeviceAddress> addresses;
    for (std::uint32_t slice = 0; slice < 1u << sliceBits; ++slice)
    {
      this->records.topLevels.push_back(
        AccelerationStructure::OverInstances(this->device->GetState(), this->InstancesIn(slice, sliceBits)));
      addresses.push_back(this->records.topLevels.back().Address());
    }
    this->records.topLevelAddresses = Send(this->device->GetState(), addresses);
  }
  this->statistics->topLevelBuilds += any;
  this->statistics->buildSeconds += watch.Lap();
}

std::vector<GlyphSet::Image> GlyphSet::Images() const
{
  std::vector<Image> result{ { glm::dvec3(0.0), true } };
  const auto& [edges, shown, lit] = this->images;
  const glm::ivec3 sides = 2 * lit + 1;
  for (int i = 0; i < sides.x * sides.y * sides.z; ++i)
  {
    const glm::ivec3 place = glm::ivec3(i / (sides.y * sides.z), i / sides.z % sides.y, i % sides.z) - lit;
    if (place != glm::ivec3(0))
    {
      const glm::dvec3 offset = double(place.x) * edges[0] + double(place.y) * edges[1] + double(place.z) * edges[2];
      result.push_back({ offset, glm::all(glm::lessThanEqual(glm::abs(place), shown)) });
    }
  }
  return result;
}

// The instances of the top-level structure of a slice, out of 2^sliceBits.
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
    for (const GlyphSet::Image& image : set.Images())
    {
      const glm::vec3 offset(set.instances.origin + image.offset - this->records.origin);
      vk::AccelerationStructureInstanceKHR instance;
      const std::array<std::array<float, 4>, 3> translation = { { { 1, 0, 0, offset.x }, { 0, 1, 0, offset.y },
        { 0, 0, 1, offset.z } } };
      instance.transform.matrix = translation;
      instance.instanceCustomIndex = record++;
      instance.mask = set.Mask(image.shown);
      // Queries yield every translucent triangle that a ray meets.
      instance.flags =
        static_cast<VkGeometryInstanceFlagsKHR>(set.Translucent() ? vk::GeometryInstanceFlagBitsKHR::eForceNoOpaque
                                                                  : vk::GeometryInstanceFlagBitsKHR::eForceOpaque);
      if (set.DriverTriangles())
      {
        this->AddMeshInstances(set, instance, instances);
        continue;
      }
      instance.accelerationStructureReference = placed.structures[slice >> (sliceBits - placed.sliceBits)].Address();
      instances.push_back(instance);
    }
  }
  return instances;
}

// The record's values of a cut.
void Scene::State::FillSection(GlyphSet& set, device::GlyphSetRecord& record) const
{
  const Section& section = set.material.section;
  record.variants |= device::SECTION;
  record.sectionKeepsInside = section.keepsInside;
  const bool cutsWhole = section.faces == Section::Faces::Whole && set.instances.identifyTriangles;
  record.sectionFaces = static_cast<std::uint32_t>(cutsWhole ? Section::Faces::Open : section.faces);
  record.sectionColors = section.capColor.has_value();
  record.sectionColor = section.capColor.value_or(glm::vec3(0.0f));
  const std::vector<device::SectionSlab> slabs = SlabsOf(section, this->records.origin);
  record.sectionSlabs = static_cast<std::uint32_t>(slabs.size());
  device::SectionSlab* const filled[] = { &record.sectionSlab0, &record.sectionSlab1, &record.sectionSlab2 };
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    *filled[i] = slabs[i];
  }
  if (const TriangleMesh* mesh = set.placed.mesh.source.get())
  {
    std::optional<bool>& closed = set.placed.mesh.closed;
    closed = closed ? *closed : IsClosed(*mesh);
    record.meshClosed = *closed;
  }
}

// Records have the order of InstancesIn().
void Scene::State::FillRecords()
{
  std::vector<device::GlyphSetRecord> filled;
  std::uint32_t sliceBits = 0;
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    const PlacedGlyphs& placed = set.placed;
    set.listedMask = set.Mask();
    sliceBits = std::max({ sliceBits, placed.sliceBits, placed.mesh.tree.record.sliceBits });
    device::GlyphSetRecord record{};
    // What a set lacks and another set of the scene has points at the centers: a compiler may load it, for the first
    // glyph (InSet in bindings.glsl), and drop it.
    const vk::DeviceAddress anything = placed.arrays[0].Address();
    const auto at = [&](const Buffer& buffer) { return buffer.Size() ? buffer.Address() : anything; };
    const GlyphInstances& instances = set.instances;
    const GlyphColors& colors = set.colors;
#define RTG_FILL(number, BIT, type, name, values, words) record.name = at(placed.arrays[number]);
    RTG_GLYPH_ARRAYS(RTG_FILL)
#undef RTG_FILL
#define RTG_FILL(type, name, value) record.name = static_cast<decltype(record.name)>(value);
    RTG_GLYPH_NUMBERS(RTG_FILL)
#undef RTG_FILL
#define RTG_FILL(type, name) record.name = set.material.name;
    RTG_MATERIAL(RTG_FILL)
#undef RTG_FILL
    record.tree = placed.tree.record;
    record.tree.order = at(placed.tree.order);
    record.polynomialWidth = static_cast<std::uint32_t>(instances.polynomials.width);
    record.variants = placed.variants.bits;
    record.setId = id;
    record.glyphCount = static_cast<std::uint32_t>(set.count);
    record.translucent = set.Translucent();
    record.colored = placed.variants.Has(device::COLORS | device::END_COLORS | device::MESH_COLORS | device::FORMS |
      device::SIGN_COLORS | device::DIRECTION_COLORS);
    record.colorTable = at(placed.colorTable);
    record.colorTableSize = static_cast<std::uint32_t>(colors.table.size());
    // What the coat reflects straight back (Fresnel)
    const float coatRoot = (set.material.coatIor - 1.0f) / (set.material.coatIor + 1.0f);
    record.coatReflectance = coatRoot * coatRoot;
    if (const TriangleMesh* source = placed.mesh.source.get())
    {
      const PlacedMesh& mesh = placed.mesh;
      const auto ofMesh = [&](const Buffer& buffer) { return (buffer.Size() ? buffer : mesh.positions).Address(); };
      record.meshPositions = mesh.positions.Address();
      record.meshTriangles = mesh.triangles.Address();
      record.meshNormals = ofMesh(mesh.normals);
      record.meshColors = ofMesh(mesh.colors);
      record.meshVelocities = ofMesh(mesh.velocities);
      record.meshAccelerations = ofMesh(mesh.accelerations);
      record.meshValueCount = static_cast<std::uint32_t>(source->positionValues.size());
      record.meshTableSize = static_cast<std::uint32_t>(source->valueColors.size());
      record.meshTriangleCount = static_cast<std::uint32_t>(source->triangles.size());
      record.meshMiddle = mesh.middle;
      record.meshRadius = mesh.radius;
      record.meshTree = mesh.tree.record;
      record.firstInstance = set.firstInstance;
    }
    if (!set.material.section.planes.empty())
    {
      this->FillSection(set, record);
    }
    // Each periodic image has the same record at another place.
    for (const GlyphSet::Image& image : set.Images())
    {
      const glm::dvec3 offset = set.instances.origin + image.offset - this->records.origin;
      const Box moved{ set.bounds.lower + glm::vec3(offset), set.bounds.upper + glm::vec3(offset) };
      const Box bounds = moved.Widened(SlabPadding(moved.Reach()));
      Split(offset, record.offset, record.offsetLow);
      record.lower = bounds.lower;
      record.upper = bounds.upper;
      record.mask = set.Mask(image.shown);
      filled.push_back(record);
    }
  }
  this->records.buffer = Send(this->device->GetState(), filled);
  this->records.sets = std::move(filled);
  this->records.sliceBits = sliceBits;
}

} // namespace rtg
