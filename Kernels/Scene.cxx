#include "SceneState.h"

#include "GlyphBoxes.h"
#include "SpatialOrder.h"
#include "Stopwatch.h"
#include "TimeSlices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

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

template <class T>
void Reorder(std::vector<T>& values, const std::vector<std::uint32_t>& order)
{
  if (values.empty())
  {
    return;
  }
  std::vector<T> sorted(values.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    sorted[i] = values[order[i]];
  }
  values = std::move(sorted);
}

// A slab test in float errs by a few ulps of the distances it subtracts: at most 16 half-ulps of `reach`, which
// bounds box coordinates and ray origins. Padding by that keeps every box conservative.
void Pad(std::vector<Box>& boxes, float reach)
{
  const float pad = std::ldexp(reach, -20);
  for (Box& box : boxes)
  {
    box.lower -= pad;
    box.upper += pad;
  }
}

vk::AabbPositionsKHR ToVulkan(const Box& box)
{
  return vk::AabbPositionsKHR(
    box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z);
}

// One or two glyphs a leaf measured best on lavapipe (Testing/Benchmarks).
constexpr std::size_t glyphsPerLeaf = 2;
// From so many leaves met by a line on average, rays find so soon what stops them that dropping what lies behind pays.
constexpr double leavesWorthDropping = 20.0;

// A device whose traversal runs on the CPU does better with our own; RTGLYPHS_STRUCTURE (boxes or tree)
// overrides, for measurements.
Structure ChooseStructure(const Device& device, bool canTree)
{
  const char* wanted = std::getenv("RTGLYPHS_STRUCTURE");
  if (wanted && std::string(wanted) == "boxes")
  {
    return Structure::Boxes;
  }
  if (wanted && std::string(wanted) != "tree" && *wanted)
  {
    throw Error("Ray Traced Glyphs: RTGLYPHS_STRUCTURE is '" + std::string(wanted) +
      "'; it can be 'boxes' or 'tree'.");
  }
  return canTree && (device.IsCpu() || (wanted && *wanted)) ? Structure::Tree : Structure::Boxes;
}

} // namespace

void Bounds::Include(const glm::vec3& a, const glm::vec3& b)
{
  this->lower = glm::min(this->lower, a);
  this->upper = glm::max(this->upper, b);
}

float Bounds::Reach() const
{
  const glm::vec3 reach = glm::max(glm::abs(this->lower), glm::abs(this->upper));
  return this->Empty() ? 0.0f : std::max({ reach.x, reach.y, reach.z });
}

Scene::State::State(std::shared_ptr<Device> d)
  : device(std::move(d))
  , structure(ChooseStructure(*device, device->GetState().int64))
{
}

Scene::Scene(std::shared_ptr<Device> device)
  : state_(std::make_unique<State>(std::move(device)))
{
}

Scene::~Scene() = default;

Scene::SetId Scene::Add()
{
  const SetId id = this->state_->nextId++;
  this->state_->sets[id];
  return id;
}

void Scene::Remove(SetId id)
{
  this->state_->topLevelChanged |= this->state_->sets.erase(id) > 0;
}

void Scene::SetInstances(SetId id, GlyphInstances instances)
{
  GlyphSet& set = this->state_->sets.at(id);
  if (instances.shape == Shape::Mesh)
  {
    CheckMesh(instances.mesh.get(), instances.motion);
    constexpr std::size_t most = (1u << 24) - 1;
    if (instances.Count() > most)
    {
      throw Error("Ray Traced Glyphs: " + std::to_string(instances.Count()) +
        " mesh glyphs; the most is " + std::to_string(most) + ". Show fewer with GlyphMask.");
    }
  }
  CheckMotion(instances.motion, instances.Count());
  if (!instances.forms.empty() && instances.forms.size() != instances.Count())
  {
    throw Error("Ray Traced Glyphs: " + std::to_string(instances.forms.size()) + " quadratic forms for " +
      std::to_string(instances.Count()) + " glyphs; give one a glyph or none.");
  }
  set.count = instances.Count();
  const auto seeThrough = [](std::uint32_t colour) { return (colour >> 24) != 255; };
  const TriangleMesh* mesh = instances.shape == Shape::Mesh ? instances.mesh.get() : nullptr;
  set.translucentMesh = mesh &&
    (std::any_of(mesh->positionColours.begin(), mesh->positionColours.end(), seeThrough) ||
      std::any_of(mesh->triangleColours.begin(), mesh->triangleColours.end(), seeThrough));
  set.instances = std::move(instances);
  set.instancesChanged = true;
  // Colours are by glyph: those of the old glyphs mean nothing now.
  set.colours.clear();
  set.coloursChanged = true;
  set.translucentColours = false;
}

void Scene::SetColours(SetId id, GlyphColours colours)
{
  GlyphSet& set = this->state_->sets.at(id);
  if (!colours.empty() && colours.size() != set.count)
  {
    throw Error("Ray Traced Glyphs: " + std::to_string(colours.size()) + " colours for " +
      std::to_string(set.count) + " glyphs; give one colour a glyph or none.");
  }
  set.translucentColours = std::any_of(
    colours.begin(), colours.end(), [](std::uint32_t colour) { return (colour >> 24) != 255; });
  set.colours = std::move(colours);
  set.coloursChanged = true;
}

void Scene::SetMaterial(SetId id, const Material& material)
{
  GlyphSet& set = this->state_->sets.at(id);
  set.material = material;
  this->state_->recordsChanged = true;
}

void Scene::SetVisible(SetId id, bool visible)
{
  GlyphSet& set = this->state_->sets.at(id);
  this->state_->topLevelChanged |= set.visible != visible;
  set.visible = visible;
}

std::size_t Scene::GlyphCount(SetId id) const
{
  return this->state_->sets.at(id).count;
}

std::uint32_t Scene::OriginalGlyph(SetId set, std::uint32_t sorted) const
{
  const GlyphSet& glyphs = this->state_->sets.at(set);
  const auto& order = glyphs.instances.identifyTriangles ? glyphs.mesh.order : glyphs.order;
  return order.empty() ? sorted : order.at(sorted);
}

bool Scene::HasTranslucent() const
{
  const auto& sets = this->state_->sets;
  return std::any_of(sets.begin(), sets.end(),
    [](const auto& entry)
    { return entry.second.visible && entry.second.count && entry.second.Translucent(); });
}

bool Scene::HasOpaque() const
{
  const auto& sets = this->state_->sets;
  return std::any_of(sets.begin(), sets.end(),
    [](const auto& entry)
    { return entry.second.visible && entry.second.count && !entry.second.Translucent(); });
}

const Statistics& Scene::GetStatistics() const
{
  this->state_->statistics.deviceBytes = this->state_->device->GetState().bytes;
  return this->state_->statistics;
}

void Scene::Commit()
{
  State& state = *this->state_;
  state.device->GetState().Guard("sending glyphs",
    [&]
    {
      // Ray origins are at most a scene away from a set, so every set's padding depends on all the others' extent.
      float reach = 0.0f;
      for (auto& [id, set] : state.sets)
      {
        if (set.instancesChanged)
        {
          set.bounds = Bounds();
          set.boxes = GlyphBoxes(set.instances);
          for (const Box& box : set.boxes)
          {
            set.bounds.Include(box.lower, box.upper);
          }
        }
      }
      // The scene's origin is that of its first set: near the data, and it stays put.
      const auto first = std::find_if(state.sets.begin(), state.sets.end(),
        [](const auto& entry) { return entry.second.count > 0; });
      const glm::dvec3 origin =
        first == state.sets.end() ? glm::dvec3(0.0) : first->second.instances.origin;
      if (origin != state.origin)
      {
        state.origin = origin;
        state.topLevelChanged = true;
      }
      for (const auto& [id, set] : state.sets)
      {
        const glm::dvec3 offset = glm::abs(set.instances.origin - origin);
        reach = std::max(reach,
          set.bounds.Reach() + static_cast<float>(std::max({ offset.x, offset.y, offset.z })));
      }

      for (auto& [id, set] : state.sets)
      {
        if (set.instancesChanged || (set.count && 2.0f * reach > set.builtReach))
        {
          state.SendInstances(set, reach);
          state.topLevelChanged = true;
        }
        if (set.coloursChanged)
        {
          state.SendColours(set);
          state.recordsChanged = true;
        }
      }
      // The top level says which hit group and which pass a set belongs to.
      for (const auto& [id, set] : state.sets)
      {
        state.topLevelChanged |= set.visible && set.count &&
          !(set.group == set.placedGroup && set.Translucent() == set.placedTranslucent);
      }
      if (state.topLevelChanged)
      {
        state.BuildTopLevel();
        state.recordsChanged = true;
      }
      if (state.recordsChanged)
      {
        state.FillRecords();
        ++state.version;
      }
      state.topLevelChanged = state.recordsChanged = false;
    });
}

// Sorts, sends and builds one set's glyphs.
void Scene::State::SendInstances(GlyphSet& set, float reach)
{
  Device::State& vulkan = this->device->GetState();
  GlyphInstances& instances = set.instances;
  set.runs.clear();
  set.centres = Buffer();
  set.sizes = Buffer();
  set.rotations = Buffer();
  set.exponents = Buffer();
  set.forms = Buffer();
  set.velocities = Buffer();
  set.accelerations = Buffer();
  set.angularVelocities = Buffer();
  set.tree = Buffer();
  set.treeOrder = Buffer();
  if (set.count == 0)
  {
    set.instancesChanged = false;
    return;
  }

  Stopwatch watch;
  if (set.instancesChanged)
  {
    this->Sort(set);
    this->statistics.sortSeconds += watch.Lap();
  }

  const bool movingMesh = IsMovingMesh(instances);
  if (instances.shape == Shape::Mesh && !movingMesh)
  {
    this->SendMesh(set, reach);
    return;
  }
  set.group.smoothNormals = set.group.meshTree = set.group.meshVelocities =
    set.group.meshAccelerations = false;
  set.group.meshColours = 0;
  if (movingMesh)
  {
    this->SendMovingMesh(set);
    this->statistics.buildSeconds += watch.Lap();
  }
  else
  {
    set.mesh = PlacedMesh();
  }

  set.centres = Send(vulkan, instances.centres);
  set.sizes =
    instances.sizes3.empty() ? Send(vulkan, instances.sizes1) : Send(vulkan, instances.sizes3);
  set.rotations = Send(vulkan, instances.rotations);
  if (!HasExponents(instances.shape))
  {
    instances.exponents3.clear();
  }
  set.exponents = Send(vulkan, instances.exponents3);
  set.forms = Send(vulkan, instances.forms);
  set.group.shape = instances.shape;
  set.group.sizesPerGlyph = !instances.sizes3.empty() ? 3 : !instances.sizes1.empty() ? 1 : 0;
  set.group.turned = !instances.rotations.empty();
  set.group.ownExponents = !instances.exponents3.empty();
  set.group.colouredByForm = !instances.forms.empty();
  set.group.fixedHeads = instances.shape == Shape::Arrow && instances.arrow.fixedHeads;
  this->SendMotion(set);
  ++this->statistics.instanceUploads;
  this->statistics.uploadSeconds += watch.Lap();

  // Some head-room, so that a scene that grows little by little is not rebuilt at every step.
  set.builtReach = 4.0f * reach;
  // Those of Commit(), unless old instances are built anew for a larger scene.
  std::vector<Box> boxes = set.boxes.empty() ? GlyphBoxes(instances) : std::move(set.boxes);
  set.boxes.clear();
  set.group.hasTree = this->structure == Structure::Tree;
  if (set.group.hasTree)
  {
    this->BuildTree(set, std::move(boxes));
  }
  else
  {
    Pad(boxes, set.builtReach);
    this->BuildBoxes(set, boxes);
  }
  set.instancesChanged = false;
  this->statistics.buildSeconds += watch.Lap();
}

void Scene::State::SendMotion(GlyphSet& set)
{
  Device::State& vulkan = this->device->GetState();
  const GlyphMotion& motion = set.instances.motion;
  set.velocities = Send(vulkan, motion.velocities);
  set.accelerations = Send(vulkan, motion.accelerations);
  set.angularVelocities = Send(vulkan, motion.angularVelocities);
  set.group.hasVelocities = !motion.velocities.empty();
  set.group.hasAccelerations = !motion.accelerations.empty();
  set.group.spins = motion.Spins();
}

// Glyphs of a time series mostly stay near those beside which they were: as long as the nodes above the leaves have not grown by
// much, the last order does.
void Scene::State::SortIntoTree(GlyphSet& set)
{
  const GlyphInstances& instances = set.instances;
  // Glyphs that move are sorted as they lie in the middle of the shutter's opening: boxes round whole paths would
  // say little about what each slice of time needs.
  const std::vector<Box> middle = instances.motion.Any() ? GlyphBoxes(instances, 0.5, 0.5) : std::vector<Box>();
  const std::vector<Box>& boxes = instances.motion.Any() ? middle : set.boxes;
  const std::uint32_t leafBits = GlyphTree::LeafBits(set.count, glyphsPerLeaf);
  const auto surface = [&]
  { return LeafSurface(InOrder(boxes, set.order), leafBits - std::min(leafBits, 3u)); };
  const bool sorted = !set.kdAxes.empty() && set.order.size() == set.count && set.treeLeafBits == leafBits;
  if (sorted && surface() <= this->orderDecay * set.sortedSurface)
  {
    return;
  }
  set.treeLeafBits = leafBits;
  KdOrder kd = MakeKdOrder(boxes, leafBits);
  set.order = std::move(kd.order);
  set.kdAxes = std::move(kd.axes);
  set.sortedSurface = surface();
  ++this->statistics.sorts;
}

void Scene::State::Sort(GlyphSet& set)
{
  GlyphInstances& instances = set.instances;
  if (this->structure == Structure::Tree &&
    (instances.shape != Shape::Mesh || IsMovingMesh(instances)))
  {
    this->SortIntoTree(set);
  }
  else
  {
    set.order.clear();
    set.kdAxes.clear();
    if (this->device->IsCpu())
    {
      // lavapipe builds in input order; a GPU's driver sorts for itself.
      set.order = SpatialOrder(instances.centres);
      ++this->statistics.sorts;
    }
  }
  if (!set.order.empty())
  {
    Reorder(instances.centres, set.order);
    Reorder(instances.sizes3, set.order);
    Reorder(instances.sizes1, set.order);
    Reorder(instances.rotations, set.order);
    Reorder(instances.exponents3, set.order);
    Reorder(instances.forms, set.order);
    Reorder(instances.motion.velocities, set.order);
    Reorder(instances.motion.accelerations, set.order);
    Reorder(instances.motion.angularVelocities, set.order);
    Reorder(set.boxes, set.order);
  }
}

// One primitive a glyph.
void Scene::State::BuildBoxes(GlyphSet& set, const std::vector<Box>& boxes)
{
  for (std::size_t at = 0; at < set.count; at += this->glyphsPerRun)
  {
    GlyphRun run;
    run.first = static_cast<std::uint32_t>(at);
    run.count =
      static_cast<std::uint32_t>(std::min<std::size_t>(this->glyphsPerRun, set.count - at));
    std::vector<vk::AabbPositionsKHR> positions(run.count);
    std::transform(boxes.begin() + at, boxes.begin() + at + run.count, positions.begin(), ToVulkan);
    run.structure = AccelerationStructure::OverBoxes(this->device->GetState(), positions);
    set.runs.push_back(std::move(run));
    ++this->statistics.structureBuilds;
  }
}

// One primitive for all, with the tree behind it: of glyphs that move, a tree for each slice of time.
void Scene::State::BuildTree(GlyphSet& set, std::vector<Box> boxes)
{
  Device::State& vulkan = this->device->GetState();
  const float pad = std::ldexp(set.builtReach, -20);
  set.treeLevels = GlyphTree::Levels(set.treeLeafBits);
  set.nodesPerSlice = static_cast<std::uint32_t>(set.kdAxes.size());
  set.timeSliceBits = 0;
  set.group.ownTreeOrder = false;
  set.group.dropsHidden = false;
  if (set.instances.motion.Any())
  {
    const std::uint32_t bits = this->timeSliceBits >= 0
      ? static_cast<std::uint32_t>(this->timeSliceBits)
      : TimeSliceBits(set.instances, set.nodesPerSlice * sizeof(GlyphTreeNode));
    const TimeSlices slices =
      BuildTimeSlices(set.instances, set.treeLeafBits, set.kdAxes, pad, bits, this->sliceSorting);
    set.timeSliceBits = slices.bits;
    set.group.ownTreeOrder = !slices.order.empty();
    set.tree = Send(vulkan, slices.nodes);
    set.treeOrder = Send(vulkan, slices.order);
  }
  else
  {
    Pad(boxes, set.builtReach);
    // So many leaves a line through the bounds meets on average, by Cauchy's formula.
    const glm::dvec3 e(set.bounds.upper - set.bounds.lower);
    const double leavesMet = LeafSurface(boxes, set.treeLeafBits) / (e.x * e.y + e.y * e.z + e.z * e.x);
    set.group.dropsHidden = leavesMet > leavesWorthDropping;
    set.tree = Send(vulkan, BuildGlyphTree(boxes, set.treeLeafBits, set.kdAxes).nodes);
  }
  GlyphRun run;
  run.count = static_cast<std::uint32_t>(set.count);
  run.structure = AccelerationStructure::OverBoxes(
    vulkan, { ToVulkan({ set.bounds.lower - pad, set.bounds.upper + pad }) });
  set.runs.push_back(std::move(run));
  ++this->statistics.structureBuilds;
}

void Scene::State::SendColours(GlyphSet& set)
{
  Stopwatch watch;
  set.group.coloured = !set.colours.empty();
  if (set.group.coloured && !set.order.empty())
  {
    Reorder(set.colours, set.order);
  }
  set.colourBuffer = Send(this->device->GetState(), set.colours);
  if (set.group.coloured)
  {
    ++this->statistics.colourUploads;
  }
  GlyphColours().swap(set.colours);
  set.coloursChanged = false;
  this->statistics.uploadSeconds += watch.Lap();
}

void Scene::State::BuildTopLevel()
{
  Stopwatch watch;
  std::vector<vk::AccelerationStructureInstanceKHR> instances;
  this->groups.clear();
  this->bounds = Bounds();
  this->moves = false;
  this->placedTimeSliceBits = 0;
  std::uint32_t record = 0;
  for (auto& [id, set] : this->sets)
  {
    if (!set.visible || set.count == 0)
    {
      continue;
    }
    set.placedGroup = set.group;
    set.placedTranslucent = set.Translucent();
    this->moves |= set.group.Moves();
    this->placedTimeSliceBits = std::max(
      { this->placedTimeSliceBits, set.timeSliceBits, set.mesh.shape.sliceBits });
    auto group = std::find(this->groups.begin(), this->groups.end(), set.group);
    if (group == this->groups.end())
    {
      group = this->groups.insert(group, set.group);
    }
    const glm::vec3 offset(set.instances.origin - this->origin);
    for (const GlyphRun& run : set.runs)
    {
      vk::AccelerationStructureInstanceKHR instance;
      const std::array<std::array<float, 4>, 3> translation = { { { 1, 0, 0, offset.x },
        { 0, 1, 0, offset.y }, { 0, 0, 1, offset.z } } };
      instance.transform.matrix = translation;
      instance.instanceCustomIndex = record++;
      instance.mask = set.Translucent() ? device::TRANSLUCENT_MASK : device::OPAQUE_MASK;
      instance.instanceShaderBindingTableRecordOffset =
        static_cast<std::uint32_t>(group - this->groups.begin());
      if (set.group.shape == Shape::Mesh && !set.group.meshTree)
      {
        this->PlaceMesh(set, instance, instances);
        continue;
      }
      instance.accelerationStructureReference = run.structure.Address();
      instances.push_back(instance);
    }
    const float pad = std::ldexp(set.builtReach, -20);
    this->bounds.Include(set.bounds.lower + offset - pad, set.bounds.upper + offset + pad);
  }
  this->topLevel = AccelerationStructure();
  if (!instances.empty())
  {
    this->topLevel = AccelerationStructure::OverInstances(this->device->GetState(), instances);
    ++this->statistics.topLevelBuilds;
  }
  this->statistics.buildSeconds += watch.Lap();
}

// In the order of BuildTopLevel()'s instances.
void Scene::State::FillRecords()
{
  this->records.clear();
  for (const auto& [id, set] : this->sets)
  {
    if (!set.visible || set.count == 0)
    {
      continue;
    }
    for (const GlyphRun& run : set.runs)
    {
      device::GlyphSetRecord record{};
      const auto at = [&](const Buffer& buffer, std::size_t stride)
      { return buffer.Size() ? buffer.Address() + run.first * stride : 0; };
      record.centres = at(set.centres, sizeof(glm::vec3));
      record.sizes = at(set.sizes, set.group.sizesPerGlyph * sizeof(float));
      record.rotations = at(set.rotations, sizeof(glm::vec4));
      record.exponents = at(set.exponents, sizeof(glm::vec3));
      record.colours = at(set.colourBuffer, sizeof(std::uint32_t));
      record.forms = at(set.forms, sizeof(glm::vec3));
      const glm::dvec3 offset = set.instances.origin - this->origin;
      record.offset = glm::vec3(offset);
      record.offsetLow = glm::vec3(offset - glm::dvec3(record.offset));
      const ArrowForm& arrow = set.instances.arrow;
      record.arrow = { arrow.shaftRadius, arrow.tipRadius, arrow.tipLength, arrow.tipRounding };
      record.unitLength = arrow.unitLength;
      record.uniformSize = set.instances.uniformSize;
      record.uniformExponents = set.instances.uniformExponents;
      record.tree = set.tree.Size() ? set.tree.Address() : 0;
      record.velocities = at(set.velocities, sizeof(glm::vec3));
      record.accelerations = at(set.accelerations, sizeof(glm::vec3));
      record.angularVelocities = at(set.angularVelocities, sizeof(glm::vec3));
      record.treeOrder = at(set.treeOrder, sizeof(std::uint32_t));
      record.shutterOpen = set.instances.motion.shutterOpen;
      record.shutterLength = set.instances.motion.shutterClose - set.instances.motion.shutterOpen;
      record.timeSliceBits = set.timeSliceBits;
      record.nodesPerSlice = set.nodesPerSlice;
      record.treeLevels = set.treeLevels;
      record.treeLeafBits = set.treeLeafBits;
      record.glyphCount = run.count;
      record.meshPositions = set.mesh.positions.Size() ? set.mesh.positions.Address() : 0;
      record.meshTriangles = set.mesh.triangles.Size() ? set.mesh.triangles.Address() : 0;
      record.meshNormals = set.mesh.normals.Size() ? set.mesh.normals.Address() : 0;
      record.meshColours = set.mesh.colours.Size() ? set.mesh.colours.Address() : 0;
      record.meshTree = at(set.mesh.tree, 0);
      record.meshVelocities = at(set.mesh.velocities, 0);
      record.meshAccelerations = at(set.mesh.accelerations, 0);
      record.meshMiddle = set.mesh.shape.middle;
      record.meshRadius = set.mesh.shape.radius;
      record.meshTriangleCount =
        set.mesh.source ? static_cast<std::uint32_t>(set.mesh.source->triangles.size()) : 0;
      record.meshTreeLevels = set.mesh.shape.levels;
      record.meshTreeLeafBits = set.mesh.shape.leafBits;
      record.meshTimeSliceBits = set.mesh.shape.sliceBits;
      record.meshNodesPerSlice = set.mesh.shape.nodesPerSlice;
      record.firstInstance = set.firstInstance;
      record.identifiesTriangles = set.instances.identifyTriangles;
      record.setId = id;
      record.firstGlyph = run.first;
      const Material& material = set.material;
      record.colour = material.colour;
      record.opacity = material.opacity;
      record.translucent = set.Translucent();
      record.ambientColour = material.ambientColour;
      record.coloured =
        set.group.coloured || set.group.meshColours != 0 || set.group.colouredByForm;
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
      this->records.push_back(record);
    }
  }
  this->recordBuffer = Send(this->device->GetState(), this->records);
}

} // namespace rtg
