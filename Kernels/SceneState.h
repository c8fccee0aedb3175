// The device side of a Scene, for Kernels only.
#pragma once

#include "GlyphArrays.h"
#include "GlyphTree.h"
#include "MeshTree.h"
#include "Parallel.h"
#include "Scene.h"
#include "TimeSlices.h"
#include "Vulkan/AccelerationStructure.h"
#include "Vulkan/Buffer.h"
#include "Vulkan/Pipeline.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace rtg
{

/// The BVH that rays traverse.
enum class Structure
{
  Boxes, ///< the driver's, one primitive a glyph or triangle, by ray queries; on GPUs with hardware for it
  Tree   ///< the plugin's BVH (GlyphTree); on all other devices
};

/// Features of a set and its programs: bits of Variants.h.
struct Variants
{
  std::uint32_t bits = 0;

  bool Has(std::uint32_t variant) const { return (this->bits & variant) != 0; }
  void Set(std::uint32_t variant, bool has) { this->bits = has ? this->bits | variant : this->bits & ~variant; }
  bool Moves() const { return this->Has(device::MOVING_GLYPHS | device::MOVING_MESH); }
};

/// A GlyphTree on the device.
struct PlacedTree
{
  PlacedTree() = default;
  PlacedTree(Device::State& device, const GlyphTree& tree);

  Buffer nodes;
  Buffer order; ///< none unless slices are sorted each for itself
  device::TreeRecord record{};
};

/// A mesh on the device, with positions relative to its middle.
struct PlacedMesh
{
  std::shared_ptr<const TriangleMesh> source;
  std::vector<std::uint32_t> order; ///< place on the device -> triangle of the source; empty: the same
  Buffer positions, triangles, normals, colors;
  Buffer velocities, accelerations;
  glm::vec3 middle{ 0.0f }; ///< as CenteredMesh has them
  float radius = 0.0f;
  AccelerationStructure structure; ///< of the driver, or instead of it:
  PlacedTree tree;
  float shutterOpen = 0.0f, shutterClose = 0.0f; ///< that its tree is made for
  std::optional<bool> closed;                    ///< IsClosed() of the source, once computed
};

/// Whether the glyphs of a set are copies of a mesh that moves or deforms, or lie where the driver's floats are too
/// coarse: then they need a BVH of their own.
bool IsMovingMesh(const GlyphInstances& instances);

/// Whether triangles bound a body: each edge, by the places of its ends, is one of an even number of triangles.
bool IsClosed(const TriangleMesh& mesh);

/// A glyph set's arrays on the device, in the set's GlyphOrder. It is built aside and moved into its set when it is
/// complete, so that a set has all of it or nothing.
struct PlacedGlyphs
{
  Variants variants;
  float builtReach = INFINITY;            ///< distance of ray origins that the padding of the driver's boxes allows for
  std::array<Buffer, glyphArrays> arrays; ///< by number; none where the set has no such array
  Buffer colorTable;                      ///< of values at the ends of round cones
  PlacedTree tree;
  std::vector<AccelerationStructure> structures; ///< of the driver: one for each slice of time
  std::uint32_t sliceBits = 0;                   ///< of the tree, or of these
  PlacedMesh mesh;                               ///< Shape::Mesh only
  bool any = false;
};

/// The order in which a set's glyphs lie on the device.
struct GlyphOrder
{
  std::vector<std::uint32_t> order; ///< place on the device -> index in the caller's order; empty: the same
  std::vector<std::uint8_t> kdAxes; ///< see KdOrder; none without a tree
  std::uint32_t leafBits = 0;       ///< of the tree
  double sortedSurface = 0.0;       ///< of the nodes of leaves when `order` was found
};

/// One glyph set: the caller's data in its order, and its arrays on the device.
struct GlyphSet
{
  GlyphInstances instances;
  GlyphColors colors;
  Material material;
  PeriodicImages images;
  bool visible = true;
  bool kept = false;         ///< on the device while it is not visible
  bool cameraVisible = true; ///< camera rays see it
  bool translucentColors = false;
  bool translucentInstances = false;
  bool instancesChanged = false; ///< since they were placed
  bool colorsChanged = false;    ///< likewise

  std::size_t count = 0;
  bool measured = false;  ///< `bounds` are those of the instances
  Box bounds;             ///< relative to instances.origin
  float smallest = 0.0f;  ///< of the extents of its glyphs; Shape::Mesh only
  std::vector<Box> boxes; ///< of the glyphs, from their bounds to their build; none of balls
  GlyphOrder sorted;
  PlacedGlyphs placed;

  std::uint32_t listedMask = 0;    ///< as the top level has it
  std::uint32_t firstInstance = 0; ///< in the top level; Shape::Mesh only

  bool Shown() const { return this->visible && this->count > 0; }
  /// Whether the driver has the triangles of what is placed.
  bool DriverTriangles() const { return this->placed.mesh.structure.Address() != 0; }
  bool Translucent() const
  {
    return this->material.opacity < 1.0f || this->translucentColors || this->translucentInstances;
  }
  std::uint32_t Mask(bool shown = true) const
  {
    return this->Translucent()
      ? (this->cameraVisible && shown ? device::TRANSLUCENT_MASK : device::INDIRECT_TRANSLUCENT_MASK)
      : (this->cameraVisible && shown ? device::OPAQUE_MASK : device::INDIRECT_OPAQUE_MASK);
  }
  /// An image of the set: how far it lies from the set, and whether it is shown. The first one is the set.
  struct Image
  {
    glm::dvec3 offset;
    bool shown;
  };
  std::vector<Image> Images() const;
  /// How far images are at most along each axis.
  glm::dvec3 ImageReach() const
  {
    const auto& [edges, shown, lit] = this->images;
    return double(lit.x) * glm::abs(edges[0]) + double(lit.y) * glm::abs(edges[1]) + double(lit.z) * glm::abs(edges[2]);
  }
};

/// What tracers read of a scene.
struct SceneRecords
{
  glm::dvec3 origin{ 0.0 };
  std::vector<device::GlyphSetRecord> sets;     ///< one or more for each visible set; none: nothing can be traced
  Buffer buffer;                                ///< the same on the device
  std::vector<AccelerationStructure> topLevels; ///< of Structure::Boxes: one for each slice of time
  Buffer topLevelAddresses;
  std::uint32_t sliceBits = 0; ///< of time: the most of any visible set
  /// Another one with every change that changes the image, and in every scene.
  std::uint64_t version = NextVersion();
  static std::uint64_t NextVersion();
};

/// How much of a Commit()'s work is done, in stages of glyphs: measuring, sorting, sending, and building of each.
struct CommitProgress
{
  std::function<void(double)> report;
  std::uint64_t stages = 0, done = 0;

  /// A stage of so many glyphs.
  void Add(std::size_t glyphs);
};

struct Scene::State
{
  State(std::shared_ptr<Device> d, std::shared_ptr<Statistics> s);

  std::shared_ptr<Device> device;
  std::map<SetId, GlyphSet> sets;
  SetId nextId = 0;
  std::uint64_t mostInstances; ///< of a top-level structure. Tests lower it.
  /// Most elements of an array on the device, because SPIR-V takes indices for signed numbers, and AABBs of one of the
  /// driver's structures. Tests lower it.
  std::size_t mostElements = std::numeric_limits<std::int32_t>::max();
  Structure structure;
  std::shared_ptr<Statistics> statistics;
  SceneRecords records;
  bool topLevelChanged = true;
  bool recordsChanged = true;
  CommitProgress progress; ///< of the Commit() that is going on

  /// Whether some visible set is translucent, or opaque.
  bool Shows(bool translucent) const;
  std::uint64_t CountStages() const;
  void SendChanges(std::vector<GlyphSet*>& sent);
  /// Throws rtg::Error when there is none of that number.
  GlyphSet& Find(SetId id);
  /// The largest coordinate of what is visible, relative to the scene's origin. Ray origins are at most a scene away
  /// from a set, so every set's padding depends on all the others' extent.
  float Measure();
  /// Takes the set from the device, and with it the top levels, which would refer to what is gone.
  PlacedGlyphs Withdraw(GlyphSet& set);
  void DropTopLevels();
  /// Sorts and sends one set's glyphs and builds what rays find them by.
  void Place(GlyphSet& set, float reach);
  /// Sends the arrays whose bits `variants` has.
  void SendArrays(const GlyphSet& set, PlacedGlyphs& placed, std::uint32_t variants = ~0u);
  /// Sends what glyphs are copies of, and builds what rays find its triangles by. False: nothing but its colors is new.
  bool PlaceMesh(const GlyphSet& set, PlacedGlyphs& placed);
  /// Whether mesh glyphs need a tree of their own: where there are no triangles of the driver, and where these, which
  /// are placed in float, would not do.
  bool NeedsMeshTree(const GlyphSet& set) const;
  /// Adds one instance a glyph; `like` moves a set's frame to the scene's.
  void AddMeshInstances(GlyphSet& set, const vk::AccelerationStructureInstanceKHR& like,
    std::vector<vk::AccelerationStructureInstanceKHR>& instances) const;
  void Sort(GlyphSet& set, const BoxReader& boxes);
  void BuildBoxes(const GlyphSet& set, PlacedGlyphs& placed, const BoxReader& boxes);
  void BuildTree(const GlyphSet& set, PlacedGlyphs& placed, const BoxReader& boxes);
  void CheckInstanceCount() const;
  void BuildTopLevels();
  std::vector<vk::AccelerationStructureInstanceKHR> InstancesIn(std::uint32_t slice, std::uint32_t sliceBits);
  void FillRecords();
  void FillSection(GlyphSet& set, device::GlyphSetRecord& record) const;
};

/// Send() with the values of glyph order[i] at place i; an empty order: with the values as they are.
template <class Array>
Buffer SendInOrder(
  Device::State& device, const Array& values, const std::vector<std::uint32_t>& order, vk::BufferUsageFlags more = {})
{
  if (order.empty() || values.empty())
  {
    return Send(device, Flat(values), more);
  }
  Buffer buffer(
    device, order.size() * RowBytes(values), vk::BufferUsageFlagBits::eStorageBuffer | more, Buffer::Place::Device);
  buffer.Write(order.size(), RowBytes(values),
    [&](void* target, std::size_t begin, std::size_t end)
    {
      ParallelEach(end - begin,
        [&](std::size_t i) {
          std::memcpy(
            static_cast<char*>(target) + i * RowBytes(values), Row(values, order[begin + i]), RowBytes(values));
        });
    });
  return buffer;
}

} // namespace rtg
