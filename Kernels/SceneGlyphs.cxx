// The part of a scene that sorts and sends a set's glyphs and builds what rays find them by.
#include "SceneState.h"

#include "GlyphBoxes.h"
#include "Stopwatch.h"
#include "TimeSlices.h"

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

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
  return vk::AabbPositionsKHR(box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z);
}

// One or two glyphs a leaf measured best on lavapipe (Testing/Benchmarks).
constexpr std::size_t glyphsPerLeaf = 2;
// From so many leaves met by a line on average, rays find so soon what stops them that dropping what lies behind pays.
constexpr double leavesWorthDropping = 20.0;

} // namespace

void Scene::State::Place(GlyphSet& set, float reach)
{
  // What is there is not shown any more, and a large set may not fit twice. Only a mesh may be wanted again.
  PlacedMesh mesh = this->Withdraw(set).mesh;
  Stopwatch watch;
  // Those of Measure(), unless old instances are placed anew.
  std::vector<Box> boxes = set.boxes.empty() ? GlyphBoxes(set.instances) : std::move(set.boxes);
  set.boxes = {};
  if (set.instancesChanged || set.sorted.order.size() != set.count)
  {
    this->Sort(set, boxes);
    this->statistics.sortSeconds += watch.Lap();
  }
  this->TellStage(set);
  PlacedGlyphs placed;
  // Some head-room, so that a scene that grows little by little is not rebuilt at every step.
  placed.builtReach = 4.0f * reach;
  bool isNew = true;
  if (set.instances.shape == Shape::Mesh)
  {
    placed.mesh = std::move(mesh);
    isNew = this->PlaceMesh(set, placed);
  }
  this->statistics.instanceUploads += isNew;
  mesh = PlacedMesh();
  if (placed.runs.empty())
  {
    this->SendGlyphs(set, placed);
    this->statistics.uploadSeconds += watch.Lap();
    this->TellStage(set);
    boxes = set.sorted.order.empty() ? std::move(boxes) : InOrder(boxes, set.sorted.order);
    if (this->structure == Structure::Tree)
    {
      this->BuildTree(set, placed, std::move(boxes));
    }
    else
    {
      Pad(boxes, placed.builtReach);
      this->BuildBoxes(placed, boxes);
    }
    this->statistics.buildSeconds += watch.Lap();
  }
  this->SendColours(set, placed);
  this->TellStage(set);
  set.placed = std::move(placed);
  this->topLevelChanged = true;
}

// All arrays but the colors.
void Scene::State::SendGlyphs(const GlyphSet& set, PlacedGlyphs& placed)
{
  Device::State& vulkan = this->device->GetState();
  const GlyphInstances& instances = set.instances;
  const std::vector<std::uint32_t>& order = set.sorted.order;
  const GlyphMotion& motion = instances.motion;
  HitGroup& group = placed.group;
  group.shape = instances.shape;
  const auto send = [&](Buffer& buffer, const auto& values, std::uint32_t variant)
  {
    buffer = SendInOrder(vulkan, values, order);
    group.Set(variant, !values.empty());
  };
  send(placed.centres, instances.centres, 0);
  send(placed.centresLow, instances.centresLow, device::CENTRES_LOW);
  if (instances.sizes3.empty())
  {
    send(placed.sizes, instances.sizes1, device::SIZE_EACH);
  }
  else
  {
    send(placed.sizes, instances.sizes3, device::SIZES_EACH);
  }
  send(placed.rotations, instances.rotations, device::ROTATIONS);
  send(placed.exponents, instances.exponents3, device::EXPONENTS);
  send(placed.forms, instances.forms, device::FORMS);
  send(placed.velocities, motion.velocities, device::VELOCITIES);
  send(placed.accelerations, motion.accelerations, device::ACCELERATIONS);
  send(placed.angularVelocities, motion.angularVelocities, device::ANGULAR_VELOCITIES);
  group.Set(device::FIXED_HEADS, instances.shape == Shape::Arrow && instances.arrow.fixedHeads);
}

// Into the order of a tree's leaves, which also serves lavapipe's own structure: that splits its input where it finds
// it. A GPU's driver sorts for itself. Glyphs of a time series mostly stay near those beside which they were: as long
// as the nodes above the leaves have not grown by much, the last order does.
void Scene::State::Sort(GlyphSet& set, const std::vector<Box>& boxes)
{
  if (this->structure == Structure::Boxes && !this->device->IsCpu())
  {
    set.sorted = GlyphOrder();
    return;
  }
  const GlyphInstances& instances = set.instances;
  // Glyphs that move are sorted as they lie in the middle of the shutter's opening: boxes round whole paths would
  // say little about what each slice of time needs.
  const std::vector<Box> middle = instances.motion.Any() ? GlyphBoxes(instances, 0.5, 0.5) : std::vector<Box>();
  const std::vector<Box>& sortedBoxes = instances.motion.Any() ? middle : boxes;
  const std::uint32_t leafBits = GlyphTree::LeafBits(set.count, glyphsPerLeaf);
  const auto surface = [&](const std::vector<std::uint32_t>& order)
  { return LeafSurface(InOrder(sortedBoxes, order), leafBits - std::min(leafBits, 3u)); };
  const GlyphOrder& last = set.sorted;
  const bool fits = !last.kdAxes.empty() && last.order.size() == set.count && last.leafBits == leafBits;
  if (fits && surface(last.order) <= this->orderDecay * last.sortedSurface)
  {
    return;
  }
  KdOrder kd = MakeKdOrder(sortedBoxes, leafBits);
  const double sortedSurface = surface(kd.order);
  set.sorted = { std::move(kd.order), std::move(kd.axes), leafBits, sortedSurface };
  ++this->statistics.sorts;
}

// One primitive a glyph.
void Scene::State::BuildBoxes(PlacedGlyphs& placed, const std::vector<Box>& boxes)
{
  for (std::size_t at = 0; at < boxes.size(); at += this->glyphsPerRun)
  {
    GlyphRun run;
    run.first = static_cast<std::uint32_t>(at);
    run.count = static_cast<std::uint32_t>(std::min<std::size_t>(this->glyphsPerRun, boxes.size() - at));
    std::vector<vk::AabbPositionsKHR> positions(run.count);
    std::transform(boxes.begin() + at, boxes.begin() + at + run.count, positions.begin(), ToVulkan);
    run.structure = AccelerationStructure::OverBoxes(this->device->GetState(), positions);
    placed.runs.push_back(std::move(run));
    ++this->statistics.structureBuilds;
  }
}

// The tree of a set: of glyphs that move, one for each slice of time.
void Scene::State::BuildTree(const GlyphSet& set, PlacedGlyphs& placed, std::vector<Box> boxes)
{
  Device::State& vulkan = this->device->GetState();
  const GlyphOrder& sorted = set.sorted;
  const float pad = std::ldexp(placed.builtReach, -20);
  placed.treeLeafBits = sorted.leafBits;
  placed.treeLevels = GlyphTree::Levels(sorted.leafBits);
  placed.nodesPerSlice = static_cast<std::uint32_t>(sorted.kdAxes.size());
  if (set.instances.motion.Any())
  {
    const std::uint32_t bits = this->timeSliceBits >= 0
      ? static_cast<std::uint32_t>(this->timeSliceBits)
      : TimeSliceBits(set.instances, placed.nodesPerSlice * sizeof(GlyphTreeNode));
    const TimeSlices slices =
      BuildTimeSlices(set.instances, sorted.order, sorted.leafBits, sorted.kdAxes, pad, bits, this->sliceSorting);
    placed.timeSliceBits = slices.bits;
    placed.group.Set(device::ORDER_OF_SLICES, !slices.order.empty());
    placed.tree = Send(vulkan, slices.nodes);
    placed.treeOrder = Send(vulkan, slices.order);
  }
  else
  {
    Pad(boxes, placed.builtReach);
    // So many leaves a line through the bounds meets on average, by Cauchy's formula.
    const glm::dvec3 e(set.bounds.upper - set.bounds.lower);
    const double leavesMet = LeafSurface(boxes, sorted.leafBits) / (e.x * e.y + e.y * e.z + e.z * e.x);
    placed.group.Set(device::DROPS_HIDDEN, leavesMet > leavesWorthDropping);
    placed.tree = Send(vulkan, BuildGlyphTree(boxes, sorted.leafBits, sorted.kdAxes).nodes);
  }
  GlyphRun run;
  run.count = static_cast<std::uint32_t>(set.count);
  placed.runs.push_back(std::move(run));
  // Copies of a mesh at rest are placed, not built, as in the driver's top level.
  this->statistics.structureBuilds += set.instances.shape != Shape::Mesh || IsMovingMesh(set.instances);
}

void Scene::State::SendColours(const GlyphSet& set, PlacedGlyphs& placed)
{
  Stopwatch watch;
  placed.colours = SendInOrder(this->device->GetState(), set.colours, set.sorted.order);
  placed.group.Set(device::COLOURS, !set.colours.empty());
  this->statistics.colourUploads += set.colours.empty() ? 0 : 1;
  this->statistics.uploadSeconds += watch.Lap();
}

} // namespace rtg
