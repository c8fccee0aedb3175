// The part of a scene that sorts and sends a set's glyphs and builds what rays find them by.
#include "SceneState.h"

#include "GlyphBoxes.h"
#include "SpatialOrder.h"
#include "Stopwatch.h"
#include "TimeSlices.h"

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

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

} // namespace

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

} // namespace rtg
