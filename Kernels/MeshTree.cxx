#include "MeshTree.h"

#include "Parallel.h"
#include "TimeSlices.h"

namespace rtg
{

DoubleBox TrianglePaths::Corner(std::uint32_t corner, double first, double last) const
{
  const glm::dvec3 at(this->positions[corner]);
  if (!this->mesh.motion.Moves())
  {
    return { at, at };
  }
  const DoubleBox range = PaddedRangeOfDisplacements(this->mesh.motion, corner, first, last);
  return { at + range.lower, at + range.upper };
}

DoubleBox TrianglePaths::Triangle(std::size_t triangle, double first, double last) const
{
  const glm::uvec3& corner = this->mesh.triangles[triangle];
  DoubleBox bounds = this->Corner(corner.x, first, last);
  for (const std::uint32_t other : { corner.y, corner.z })
  {
    bounds.Include(this->Corner(other, first, last));
  }
  return bounds;
}

DoubleBox BoundsOf(const TriangleMesh& mesh, double firstTime, double lastTime)
{
  const TrianglePaths paths{ mesh.positions, mesh };
  DoubleBox bounds;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    bounds.Include(paths.Triangle(i, firstTime, lastTime));
  }
  return bounds;
}

CenteredMesh Center(const TriangleMesh& mesh, const GlyphMotion& shutter)
{
  CenteredMesh centered;
  const DoubleBox bounds = BoundsOf(mesh, shutter.EarliestTime(0.0), shutter.LatestTime(1.0));
  centered.middle = glm::vec3(0.5 * (bounds.lower + bounds.upper));
  centered.positions = mesh.positions;
  for (glm::vec3& position : centered.positions)
  {
    position -= centered.middle;
  }
  const glm::dvec3 middle(centered.middle);
  const glm::dvec3 reach = glm::max(glm::abs(bounds.lower - middle), glm::abs(bounds.upper - middle));
  // The positions have been rounded.
  centered.radius = static_cast<float>(1.000001 * glm::length(reach) + 1e-6 * glm::length(middle));
  return centered;
}

MeshTree BuildMeshTree(const TriangleMesh& mesh, const CenteredMesh& centered, const GlyphMotion& shutter)
{
  constexpr std::size_t trianglesPerLeaf = 2;
  MeshTree tree;
  const TrianglePaths paths{ centered.positions, mesh };
  const double padding = SlabPadding(centered.radius);
  const auto boxesBetween = [&](double first, double last)
  {
    std::vector<Box> boxes(mesh.triangles.size());
    ParallelEach(boxes.size(),
      [&](std::size_t i)
      {
        const std::size_t triangle = tree.order.empty() ? i : tree.order[i];
        const DoubleBox own =
          paths.Triangle(triangle, shutter.EarliestTime(first), shutter.LatestTime(last)).Widened(padding);
        boxes[i] = { glm::vec3(own.lower), glm::vec3(own.upper) };
      });
    return boxes;
  };
  const std::uint32_t leafBits = GlyphTree::LeafBits(mesh.triangles.size(), trianglesPerLeaf);
  KdOrder kd = MakeKdOrder(boxesBetween(0.5, 0.5), leafBits);
  tree.order = std::move(kd.order);
  const std::uint32_t sliceBits = !mesh.motion.Moves()
    ? 0
    : ChooseSliceBits(
        mesh.triangles.size(), kd.axes.size() * sizeof(GlyphTreeNode),
        [&](std::size_t i, double at) { return paths.Triangle(i, shutter.Time(at), shutter.Time(at)); },
        [&](std::size_t i, double first, double last)
        { return paths.Triangle(i, shutter.Time(first), shutter.Time(last)); });
  tree.tree = BuildSlices(sliceBits, leafBits, kd.axes, false, boxesBetween);
  return tree;
}

} // namespace rtg
