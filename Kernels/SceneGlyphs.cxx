// The part of a scene that sorts and sends a set's glyphs and builds what rays find them by.
#include "SceneState.h"

#include "GlyphBoxes.h"
#include "Parallel.h"
#include "Stopwatch.h"
#include "TimeSlices.h"

#include <algorithm>
#include <utility>

namespace rtg
{

namespace
{

// One or two glyphs a leaf measured best on lavapipe (Testing/Benchmarks).
constexpr std::size_t glyphsPerLeaf = 2;
// Bytes of a glyph in lavapipe's structure; those of GPUs are smaller.
constexpr std::size_t bytesPerBox = 88;

} // namespace

PlacedTree::PlacedTree(Device::State& device, const GlyphTree& tree)
  : nodes(Send(device, tree.nodes))
  , order(Send(device, tree.order))
  , record{ this->nodes.Address(), this->order.Address(), tree.levels, tree.leafBits, tree.sliceBits,
    tree.nodesPerSlice }
{
}

void Scene::State::Place(GlyphSet& set, float reach)
{
  // The old arrays are not shown any more, and a large set may not fit twice. Only a mesh may be used again.
  PlacedMesh mesh = this->Withdraw(set).mesh;
  Stopwatch watch;
  // Measure() has listed the boxes, unless old instances are placed anew.
  std::vector<Box> list = std::exchange(set.boxes, std::vector<Box>());
  if (list.empty())
  {
    list = ListedBoxes(set.instances);
  }
  if (set.instancesChanged || set.sorted.order.size() != set.count)
  {
    this->Sort(set, { set.instances, list });
    this->statistics->sortSeconds += watch.Lap();
  }
  this->progress.Add(set.count);
  PlacedGlyphs placed;
  using SurfaceColors = GlyphInstances::SurfaceColors;
  placed.variants.Set(device::SIGN_COLORS, set.instances.surfaceColors == SurfaceColors::Sign);
  placed.variants.Set(device::DIRECTION_COLORS, set.instances.surfaceColors == SurfaceColors::Direction);
  placed.variants.Set(device::FIXED_HEADS, set.instances.shape == Shape::Arrow && set.instances.arrow.fixedHeads);
  bool isNew = true;
  if (set.instances.shape == Shape::Mesh)
  {
    placed.mesh = std::move(mesh);
    isNew = this->PlaceMesh(set, placed);
  }
  this->statistics->instanceUploads += isNew;
  mesh = PlacedMesh();
  if (!placed.any)
  {
    // First what takes memory besides, then what stays.
    Stopwatch building;
    if (set.instances.motion.Any())
    {
      list = std::vector<Box>(); // each slice of time has its own
    }
    if (this->structure == Structure::Tree)
    {
      this->BuildTree(set, placed, { set.instances, list });
    }
    else
    {
      // Some head-room, so that a scene that grows little by little is not rebuilt at every step.
      placed.builtReach = 4.0f * reach;
      this->BuildBoxes(set, placed, { set.instances, list });
    }
    this->statistics->buildSeconds += building.Lap();
    list = std::vector<Box>();
    this->progress.Add(set.count);
  }
  this->SendArrays(set, placed);
  this->progress.Add(set.count);
  set.placed = std::move(placed);
  this->topLevelChanged = true;
}

void Scene::State::SendArrays(const GlyphSet& set, PlacedGlyphs& placed, std::uint32_t variants)
{
  Stopwatch watch;
  ForEachArray(set.instances, set.colors,
    [&](std::size_t number, std::uint32_t bit, const auto& values, const char*)
    {
      if (variants & bit)
      {
        placed.arrays[number] = SendInOrder(this->device->GetState(), values, set.sorted.order);
        placed.variants.Set(bit, !values.empty());
      }
    });
  if (variants & device::END_COLORS)
  {
    placed.colorTable = Send(this->device->GetState(), set.colors.table);
    placed.variants.Set(device::END_VALUES, !set.colors.table.empty());
  }
  this->statistics->colorUploads += (variants & device::COLORS) && !set.colors.Empty();
  this->statistics->uploadSeconds += watch.Lap();
}

// Sorts glyphs into the order of a tree's leaves, which also serves lavapipe's own structure: that splits its input
// where it finds it. A GPU's driver sorts for itself. Glyphs of a time series mostly stay near those beside which they
// were: as long as the nodes above the leaves have not grown by much, the last order does.
void Scene::State::Sort(GlyphSet& set, const BoxReader& boxes)
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
  const BoxReader sortedBoxes = instances.motion.Any() ? BoxReader(middle) : boxes;
  const std::uint32_t leafBits = GlyphTree::LeafBits(set.count, glyphsPerLeaf);
  const auto surface = [&](const std::vector<std::uint32_t>& order) {
    return LeafSurface({ sortedBoxes, order }, leafBits - std::min(leafBits, 3u));
  };
  const GlyphOrder& last = set.sorted;
  const bool fits = !last.kdAxes.empty() && last.order.size() == set.count && last.leafBits == leafBits;
  if (fits && surface(last.order) <= orderDecay * last.sortedSurface)
  {
    return;
  }
  KdOrder kd = MakeKdOrder(sortedBoxes, leafBits);
  const double sortedSurface = surface(kd.order);
  set.sorted = { std::move(kd.order), std::move(kd.axes), leafBits, sortedSurface };
  ++this->statistics->sorts;
}

// The driver's structures of a set, one primitive a glyph: of glyphs that move, one for each slice of time.
void Scene::State::BuildBoxes(const GlyphSet& set, PlacedGlyphs& placed, const BoxReader& boxes)
{
  const bool moves = set.instances.motion.Any();
  placed.sliceBits = moves ? TimeSliceBits(set.instances, set.count * bytesPerBox) : 0;
  const float padding = SlabPadding(placed.builtReach);
  const std::size_t slices = std::size_t(1) << placed.sliceBits;
  for (std::size_t slice = 0; slice < slices; ++slice)
  {
    std::vector<Box> own;
    if (moves)
    {
      own = GlyphBoxes(set.instances, double(slice) / double(slices), double(slice + 1) / double(slices));
    }
    const BoxReader read(moves ? BoxReader(own) : boxes, set.sorted.order);
    std::vector<vk::AabbPositionsKHR> positions(set.count);
    ParallelEach(set.count,
      [&](std::size_t i)
      {
        const auto [lower, upper] = read[i].Widened(padding);
        positions[i] = vk::AabbPositionsKHR(lower.x, lower.y, lower.z, upper.x, upper.y, upper.z);
      });
    placed.structures.push_back(AccelerationStructure::OverBoxes(this->device->GetState(), positions));
  }
  placed.any = true;
  ++this->statistics->structureBuilds;
}

// The tree of a set: of glyphs that move, one for each slice of time.
void Scene::State::BuildTree(const GlyphSet& set, PlacedGlyphs& placed, const BoxReader& boxes)
{
  const GlyphOrder& sorted = set.sorted;
  GlyphTree tree;
  if (!set.instances.motion.Any())
  {
    tree = BuildGlyphTree({ boxes, sorted.order }, sorted.leafBits, sorted.kdAxes);
  }
  else
  {
    const auto boxesBetween = [&](double first, double last)
    {
      const std::vector<Box> own = GlyphBoxes(set.instances, first, last);
      return InOrder(own, sorted.order);
    };
    const std::size_t bytes = sorted.kdAxes.size() * sizeof(GlyphTreeNode);
    tree =
      BuildSlices(TimeSliceBits(set.instances, bytes), sorted.leafBits, sorted.kdAxes, /*sorts=*/true, boxesBetween);
  }
  placed.variants.Set(device::ORDER_OF_SLICES, !tree.order.empty());
  placed.sliceBits = tree.sliceBits;
  placed.tree = PlacedTree(this->device->GetState(), tree);
  placed.any = true;
  // Copies of a mesh at rest are placed, not built, as in the driver's top level.
  this->statistics->structureBuilds += set.instances.shape != Shape::Mesh || IsMovingMesh(set.instances);
}

} // namespace rtg
