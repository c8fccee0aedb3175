// The part of a scene that is made of triangles: mesh glyphs and surfaces.
#include "SceneState.h"

#include "Stopwatch.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstring>
#include <cmath>
#include <tuple>

namespace rtg
{

namespace
{

// Rotation times scale of one glyph.
glm::mat3 LinearPart(const GlyphInstances& instances, std::size_t i)
{
  const glm::vec3 size = instances.SizeOf(i);
  glm::mat3 linear(1.0f);
  if (!instances.rotations.empty())
  {
    const glm::vec4& q = instances.rotations[i];
    linear = glm::mat3_cast(glm::quat(q.w, q.x, q.y, q.z));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    linear[axis] *= size[axis];
  }
  return linear;
}

Buffer SendMeshColors(Device::State& device, const PlacedMesh& mesh, const TriangleMesh& source)
{
  if (!source.positionValues.empty())
  {
    // The table lies behind the values.
    std::vector<std::uint32_t> words(source.positionValues.size());
    std::memcpy(words.data(), source.positionValues.data(), words.size() * sizeof(std::uint32_t));
    words.insert(words.end(), source.valueColors.begin(), source.valueColors.end());
    return Send(device, words);
  }
  return source.positionColors.empty() ? SendInOrder(device, source.triangleColors, mesh.order)
                                       : Send(device, source.positionColors);
}

} // namespace

bool IsMovingMesh(const GlyphInstances& instances)
{
  return instances.shape == Shape::Mesh &&
    (instances.motion.Any() || instances.mesh->motion.Moves() || !instances.centersLow.empty());
}

bool IsClosed(const TriangleMesh& mesh)
{
  const auto before = [](const glm::vec3& a, const glm::vec3& b)
  { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::vector<glm::vec3> places = mesh.positions;
  std::sort(places.begin(), places.end(), before);
  std::vector<std::uint64_t> place(mesh.positions.size());
  std::transform(mesh.positions.begin(), mesh.positions.end(), place.begin(),
    [&](const glm::vec3& position)
    { return std::lower_bound(places.begin(), places.end(), position, before) - places.begin(); });
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& corner : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::uint64_t a = place[corner[i]], b = place[corner[(i + 1) % 3]];
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    const bool isPoint = *edge >> 32 == (*edge & 0xffffffffu);
    if (!isPoint && (next - edge) % 2 != 0)
    {
      return false;
    }
    edge = next;
  }
  return true;
}

// A mesh that is only copied to other places is not sent again, and where only its colors are new these are sent alone.
bool Scene::State::PlaceMesh(const GlyphSet& set, PlacedGlyphs& placed)
{
  Stopwatch watch;
  const std::shared_ptr<const TriangleMesh>& wanted = set.instances.mesh;
  const TriangleMesh& mesh = *wanted;
  const GlyphMotion& shutter = set.instances.motion;
  const bool hasTree = this->NeedsMeshTree(set);
  PlacedMesh& sent = placed.mesh;
  const std::shared_ptr<const TriangleMesh> before = sent.source;
  // Positions at rest do not depend on the shutter.
  const bool sameShutter =
    !mesh.motion.Moves() || (sent.shutterOpen == shutter.shutterOpen && sent.shutterClose == shutter.shutterClose);
  const bool keeps =
    (sent.tree.nodes.Size() > 0) == hasTree && sameShutter && before && (before == wanted || SameShape(*before, mesh));
  Device::State& vulkan = this->device->GetState();
  if (keeps && before != wanted)
  {
    // Of a mesh that stays: to one that goes the batch would copy when its buffer is no more.
    sent.colors = SendMeshColors(vulkan, sent, mesh);
    sent.source = wanted;
    ++this->statistics->colorUploads;
  }
  else if (!keeps)
  {
    sent = PlacedMesh();
    CenteredMesh centered = Center(mesh, shutter);
    if (hasTree)
    {
      MeshTree tree = BuildMeshTree(mesh, centered, shutter);
      sent.tree = PlacedTree(vulkan, tree.tree);
      sent.order = std::move(tree.order);
    }
    const vk::BufferUsageFlags input =
      hasTree ? vk::BufferUsageFlags() : vk::BufferUsageFlagBits::eAccelerationStructureBuildInputReadOnlyKHR;
    sent.positions = Send(vulkan, centered.positions, input);
    sent.triangles = SendInOrder(vulkan, mesh.triangles, sent.order, input);
    sent.normals = Send(vulkan, mesh.normals);
    sent.velocities = Send(vulkan, mesh.motion.velocities);
    sent.accelerations = Send(vulkan, mesh.motion.accelerations);
    sent.colors = SendMeshColors(vulkan, sent, mesh);
    if (!hasTree)
    {
      sent.structure =
        AccelerationStructure::OverTriangles(vulkan, sent.positions, static_cast<std::uint32_t>(mesh.positions.size()),
          sent.triangles, static_cast<std::uint32_t>(mesh.triangles.size()));
    }
    sent.source = wanted;
    sent.shutterOpen = shutter.shutterOpen;
    sent.shutterClose = shutter.shutterClose;
    sent.middle = centered.middle;
    sent.radius = centered.radius;
    ++this->statistics->structureBuilds;
  }
  Variants& variants = placed.variants;
  variants.Set(device::MESH_TREE, hasTree);
  variants.Set(device::MESH_VELOCITIES, !mesh.motion.velocities.empty());
  variants.Set(device::MESH_ACCELERATIONS, !mesh.motion.accelerations.empty());
  variants.Set(device::MESH_NORMALS, !mesh.normals.empty());
  variants.Set(device::MESH_VALUE_COLORS, !mesh.positionValues.empty());
  variants.Set(device::MESH_POSITION_COLORS, mesh.positionValues.empty() && !mesh.positionColors.empty());
  variants.Set(device::MESH_TRIANGLE_COLORS,
    mesh.positionValues.empty() && mesh.positionColors.empty() && !mesh.triangleColors.empty());
  placed.any = !hasTree; // the driver's top level has the glyphs
  this->statistics->buildSeconds += watch.Lap();
  return !keeps || before == wanted;
}

bool Scene::State::NeedsMeshTree(const GlyphSet& set) const
{
  if (this->structure == Structure::Tree || IsMovingMesh(set.instances) || !set.material.section.planes.empty() ||
    set.images.Any())
  {
    return true;
  }
  // Beside a set far away, of which the scene's origin is, float places glyphs only to more than 1e-6 of their sizes.
  const glm::dvec3 offset = glm::abs(set.instances.origin - this->records.origin);
  const double farthest = std::max({ offset.x, offset.y, offset.z });
  const double error = std::ldexp(farthest + set.bounds.Reach(), -24);
  return farthest > 0.0 && error > 1e-6 * set.smallest;
}

void Scene::State::AddMeshInstances(GlyphSet& set, const vk::AccelerationStructureInstanceKHR& like,
  std::vector<vk::AccelerationStructureInstanceKHR>& instances) const
{
  set.firstInstance = static_cast<std::uint32_t>(instances.size());
  for (std::size_t i = 0; i < set.count; ++i)
  {
    const std::size_t glyph = set.sorted.order.empty() ? i : set.sorted.order[i];
    vk::AccelerationStructureInstanceKHR instance = like;
    const glm::mat3 linear = LinearPart(set.instances, glyph);
    const glm::vec3 middle = set.instances.centers[glyph] + linear * set.placed.mesh.middle;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        instance.transform.matrix[row][column] = linear[column][row];
      }
      instance.transform.matrix[row][3] += middle[row];
    }
    instance.accelerationStructureReference = set.placed.mesh.structure.Address();
    instances.push_back(instance);
  }
}

} // namespace rtg
