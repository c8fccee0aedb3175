#include "MeshTree.h"

#include "GlyphBoxes.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace rtg
{

namespace
{

struct Paths
{
  const std::vector<glm::vec3>& positions;
  const TriangleMesh& mesh;

  MeshBounds Corner(std::uint32_t corner, double first, double last) const
  {
    const glm::dvec3 at(this->positions[corner]);
    if (!Deforms(this->mesh))
    {
      return { at, at };
    }
    const DisplacementRange range = PaddedRangeOfDisplacements(this->mesh.motion, corner, first, last);
    return { at + range.lower, at + range.upper };
  }

  MeshBounds Triangle(std::size_t triangle, double first, double last) const
  {
    const glm::uvec3& corner = this->mesh.triangles[triangle];
    MeshBounds bounds = this->Corner(corner.x, first, last);
    for (const std::uint32_t other : { corner.y, corner.z })
    {
      const MeshBounds more = this->Corner(other, first, last);
      bounds.lower = glm::min(bounds.lower, more.lower);
      bounds.upper = glm::max(bounds.upper, more.upper);
    }
    return bounds;
  }
};

double Surface(const MeshBounds& bounds)
{
  const glm::dvec3 e = bounds.upper - bounds.lower;
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

// So many slices that boxes round paths have at most twice the surface that triangles at rest have.
std::uint32_t ChooseSliceBits(const Paths& paths, const GlyphMotion& shutter, std::size_t bytesPerSlice)
{
  constexpr std::size_t mostBytes = std::size_t(1) << 29;
  constexpr double mostGrowth = 2.0;
  const std::size_t triangles = paths.mesh.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, triangles / 4096);
  std::uint32_t bits = 0;
  for (; bits < maxTimeSliceBits && (bytesPerSlice << (bits + 1)) <= mostBytes; ++bits)
  {
    double still = 0.0, moving = 0.0;
    const double length = 1.0 / double(1u << bits);
    for (std::size_t i = 0; i < triangles; i += step)
    {
      const double first = length * double((i / step) & ((1u << bits) - 1));
      const double middle = shutter.Time(first + 0.5 * length);
      still += Surface(paths.Triangle(i, middle, middle));
      moving += Surface(paths.Triangle(i, shutter.Time(first), shutter.Time(first + length)));
    }
    if (moving <= mostGrowth * still)
    {
      break;
    }
  }
  return bits;
}

} // namespace

bool Deforms(const TriangleMesh& mesh)
{
  return mesh.motion.Moves();
}

MeshBounds BoundsOf(const TriangleMesh& mesh, double firstTime, double lastTime)
{
  const Paths paths{ mesh.positions, mesh };
  MeshBounds bounds{ glm::dvec3(INFINITY), glm::dvec3(-INFINITY) };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const MeshBounds own = paths.Triangle(i, firstTime, lastTime);
    bounds.lower = glm::min(bounds.lower, own.lower);
    bounds.upper = glm::max(bounds.upper, own.upper);
  }
  return bounds;
}

MeshTree BuildMeshTree(const TriangleMesh& mesh, const GlyphMotion& shutter, int sliceBits)
{
  constexpr std::size_t trianglesPerLeaf = 2;
  MeshTree tree;
  const MeshBounds bounds = BoundsOf(mesh, shutter.Time(0.0), shutter.Time(1.0));
  tree.middle = glm::vec3(0.5 * (bounds.lower + bounds.upper));
  tree.positions = mesh.positions;
  for (glm::vec3& position : tree.positions)
  {
    position -= tree.middle;
  }
  const glm::dvec3 reach =
    glm::max(glm::abs(bounds.lower - glm::dvec3(tree.middle)), glm::abs(bounds.upper - glm::dvec3(tree.middle)));
  // The positions have been rounded.
  tree.radius = static_cast<float>(1.000001 * glm::length(reach) + 1e-6 * glm::length(glm::dvec3(tree.middle)));

  const Paths paths{ tree.positions, mesh };
  // A slab test in float errs by a few ulps of the distances it subtracts (Scene.cxx).
  const double pad = std::ldexp(double(tree.radius), -20);
  const auto boxesBetween = [&](double first, double last)
  {
    std::vector<Box> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      const std::size_t triangle = tree.order.empty() ? i : tree.order[i];
      const MeshBounds own = paths.Triangle(triangle, shutter.Time(first), shutter.Time(last));
      boxes[i] = { glm::vec3(own.lower - pad), glm::vec3(own.upper + pad) };
    }
    return boxes;
  };
  tree.leafBits = GlyphTree::LeafBits(mesh.triangles.size(), trianglesPerLeaf);
  tree.levels = GlyphTree::Levels(tree.leafBits);
  KdOrder kd = MakeKdOrder(boxesBetween(0.5, 0.5), tree.leafBits);
  tree.order = std::move(kd.order);
  tree.nodesPerSlice = static_cast<std::uint32_t>(kd.axes.size());
  if (Deforms(mesh))
  {
    tree.sliceBits = sliceBits >= 0 ? static_cast<std::uint32_t>(sliceBits)
                                    : ChooseSliceBits(paths, shutter, tree.nodesPerSlice * sizeof(GlyphTreeNode));
  }
  const std::size_t slices = std::size_t(1) << tree.sliceBits;
  tree.nodes.resize(slices * tree.nodesPerSlice);
  ParallelFor(slices,
    [&](std::size_t slice)
    {
      const std::vector<Box> boxes = boxesBetween(double(slice) / double(slices), double(slice + 1) / double(slices));
      const GlyphTree built = BuildGlyphTree(boxes, tree.leafBits, kd.axes);
      std::copy(built.nodes.begin(), built.nodes.end(), tree.nodes.begin() + slice * tree.nodesPerSlice);
    });
  return tree;
}

} // namespace rtg
