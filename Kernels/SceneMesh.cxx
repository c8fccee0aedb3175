// The part of a scene that is made of triangles: mesh glyphs and surfaces.
#include "SceneState.h"

#include "SpatialOrder.h"
#include "Stopwatch.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstring>
#include <cmath>

namespace rtg
{

namespace
{

using Usage = vk::BufferUsageFlagBits;

// Rotation times scale of one glyph.
glm::mat3 LinearPart(const GlyphInstances& instances, std::size_t i)
{
  const glm::vec3 size = !instances.sizes3.empty() ? instances.sizes3[i]
    : !instances.sizes1.empty()                    ? glm::vec3(instances.sizes1[i])
                                                   : glm::vec3(instances.uniformSize);
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

// lavapipe splits triangles in their own order; see SpatialOrder.h.
std::vector<std::uint32_t> OrderTriangles(const TriangleMesh& mesh)
{
  std::vector<glm::vec3> centroids(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), centroids.begin(),
    [&](const glm::uvec3& corner)
    {
      return (mesh.positions[corner.x] + mesh.positions[corner.y] + mesh.positions[corner.z]) /
        3.0f;
    });
  return SpatialOrder(centroids);
}

template <class T>
std::vector<T> Ordered(const std::vector<T>& values, const std::vector<std::uint32_t>& order)
{
  if (order.empty() || values.empty())
  {
    return values;
  }
  std::vector<T> ordered(values.size());
  std::transform(
    order.begin(), order.end(), ordered.begin(), [&](std::uint32_t i) { return values[i]; });
  return ordered;
}

Buffer SendMeshColours(Device::State& device, const PlacedMesh& mesh, const TriangleMesh& source)
{
  if (!source.positionValues.empty())
  {
    // The table lies behind the values.
    std::vector<std::uint32_t> words(source.positionValues.size());
    std::memcpy(words.data(), source.positionValues.data(), words.size() * sizeof(std::uint32_t));
    words.insert(words.end(), source.valueColours.begin(), source.valueColours.end());
    return Send(device, words);
  }
  return source.positionColours.empty() ? Send(device, Ordered(source.triangleColours, mesh.order))
                                        : Send(device, source.positionColours);
}

// Which colors a mesh has; numbers as in Programs/triangle.glsl.
std::uint32_t ColoursOf(const TriangleMesh& mesh)
{
  return !mesh.positionValues.empty() ? 3
    : !mesh.positionColours.empty()   ? 1
    : !mesh.triangleColours.empty()   ? 2
                                      : 0;
}

PlacedMesh Place(Device::State& device, std::shared_ptr<const TriangleMesh> source, bool sorts)
{
  PlacedMesh mesh;
  mesh.order = sorts ? OrderTriangles(*source) : std::vector<std::uint32_t>();
  const auto input = Usage::eAccelerationStructureBuildInputReadOnlyKHR;
  mesh.positions = Send(device, source->positions, input);
  mesh.triangles = Send(device, Ordered(source->triangles, mesh.order), input);
  mesh.normals = Send(device, source->normals);
  mesh.colours = SendMeshColours(device, mesh, *source);
  mesh.structure = AccelerationStructure::OverTriangles(device, mesh.positions,
    static_cast<std::uint32_t>(source->positions.size()), mesh.triangles,
    static_cast<std::uint32_t>(source->triangles.size()));
  mesh.source = std::move(source);
  return mesh;
}

} // namespace

void CheckMesh(const TriangleMesh* mesh, const GlyphMotion& shutter)
{
  const auto fail = [](const std::string& what) { throw Error("Ray Traced Glyphs: " + what); };
  if (!mesh || mesh->triangles.empty())
  {
    fail("the mesh has no triangle; choose a source with polygons.");
  }
  const auto fits = [&](const char* name, std::size_t found, std::size_t wanted)
  {
    if (found != 0 && found != wanted)
    {
      fail("the mesh has " + std::to_string(found) + " " + name + "; it must have " +
        std::to_string(wanted) + " or none.");
    }
  };
  fits("normals", mesh->normals.size(), mesh->positions.size());
  fits("colours of positions", mesh->positionColours.size(), mesh->positions.size());
  fits("colours of triangles", mesh->triangleColours.size(), mesh->triangles.size());
  fits("values of positions", mesh->positionValues.size(), mesh->positions.size());
  if (!mesh->positionValues.empty() && mesh->valueColours.size() < 2)
  {
    fail("the mesh has values of positions, but no table of colors for them.");
  }
  for (const glm::uvec3& corner : mesh->triangles)
  {
    const std::uint32_t largest = std::max({ corner.x, corner.y, corner.z });
    if (largest >= mesh->positions.size())
    {
      fail("a triangle of the mesh has corner " + std::to_string(largest) + " of " +
        std::to_string(mesh->positions.size()) + " positions.");
    }
  }
  CheckMotion(mesh->motion, mesh->positions.size());
  if (mesh->motion.Spins())
  {
    fail("the positions of a mesh have angular velocities; they can have velocities and accelerations.");
  }
  if (Deforms(*mesh))
  {
    CheckShutter(shutter);
  }
}

bool IsMovingMesh(const GlyphInstances& instances)
{
  return instances.shape == Shape::Mesh && (instances.motion.Any() || Deforms(*instances.mesh));
}

// The same mesh at other places is sent once, and of one that has only other colours nothing but these.
bool Scene::State::KeepsMesh(GlyphSet& set)
{
  const GlyphInstances& instances = set.instances;
  if (set.mesh.source != instances.mesh && set.mesh.source &&
    SameShape(*set.mesh.source, *instances.mesh))
  {
    set.mesh.colours = SendMeshColours(this->device->GetState(), set.mesh, *instances.mesh);
    set.mesh.source = instances.mesh;
    ++this->statistics.colourUploads;
    return true;
  }
  return set.mesh.source == instances.mesh;
}

// The mesh itself; its glyphs are sent like those of other shapes.
void Scene::State::SendMovingMesh(GlyphSet& set)
{
  const GlyphInstances& instances = set.instances;
  const TriangleMesh& mesh = *instances.mesh;
  Device::State& vulkan = this->device->GetState();
  if (!vulkan.int64)
  {
    throw Error("Ray Traced Glyphs: the device has no 64-bit integers in shaders (shaderInt64), which meshes that move "
                "need; switch their MotionBlur off.");
  }
  const GlyphMotion& shutter = instances.motion;
  // A tree of positions at rest is the same whatever the shutter does.
  const bool sameShutter = !Deforms(mesh) ||
    (set.mesh.shutterOpen == shutter.shutterOpen && set.mesh.shutterClose == shutter.shutterClose);
  if (!(this->KeepsMesh(set) && set.mesh.tree.Size() && sameShutter))
  {
    set.mesh = PlacedMesh();
    PlacedMesh& placed = set.mesh;
    MeshTree tree = BuildMeshTree(mesh, shutter, this->timeSliceBits);
    placed.tree = Send(vulkan, tree.nodes);
    placed.order = std::move(tree.order);
    placed.positions = Send(vulkan, tree.positions);
    placed.triangles = Send(vulkan, Ordered(mesh.triangles, placed.order));
    placed.normals = Send(vulkan, mesh.normals);
    placed.velocities = Send(vulkan, mesh.motion.velocities);
    placed.accelerations = Send(vulkan, mesh.motion.accelerations);
    placed.colours = SendMeshColours(vulkan, placed, mesh);
    placed.source = instances.mesh;
    placed.shutterOpen = shutter.shutterOpen;
    placed.shutterClose = shutter.shutterClose;
    tree.nodes = {};
    tree.positions = {};
    placed.shape = std::move(tree);
    ++this->statistics.structureBuilds;
  }
  set.group.meshTree = true;
  set.group.meshVelocities = !mesh.motion.velocities.empty();
  set.group.meshAccelerations = !mesh.motion.accelerations.empty();
  set.group.smoothNormals = !mesh.normals.empty();
  set.group.meshColours = ColoursOf(mesh);
}

void Scene::State::SendMesh(GlyphSet& set, float reach)
{
  Stopwatch watch;
  const GlyphInstances& instances = set.instances;
  const TriangleMesh& mesh = *instances.mesh;
  const bool coloured = set.group.coloured;
  set.group = HitGroup();
  set.group.shape = Shape::Mesh;
  set.group.coloured = coloured;
  set.group.smoothNormals = !mesh.normals.empty();
  set.group.meshColours = ColoursOf(mesh);
  if (set.mesh.tree.Size())
  {
    set.mesh = PlacedMesh();
  }
  const std::shared_ptr<const TriangleMesh> before = set.mesh.source;
  const bool keeps = this->KeepsMesh(set);
  this->statistics.instanceUploads += !keeps || before == instances.mesh;
  if (!keeps)
  {
    set.mesh = PlacedMesh();
    set.mesh = Place(this->device->GetState(), instances.mesh, this->device->IsCpu());
    ++this->statistics.structureBuilds;
  }
  GlyphRun run;
  run.count = static_cast<std::uint32_t>(set.count);
  set.runs.push_back(std::move(run));
  set.builtReach = 4.0f * reach;
  set.boxes.clear();
  set.instancesChanged = false;
  this->statistics.buildSeconds += watch.Lap();
}

void Scene::State::PlaceMesh(GlyphSet& set, const vk::AccelerationStructureInstanceKHR& like,
  std::vector<vk::AccelerationStructureInstanceKHR>& instances) const
{
  set.firstInstance = static_cast<std::uint32_t>(instances.size());
  for (std::size_t i = 0; i < set.count; ++i)
  {
    vk::AccelerationStructureInstanceKHR instance = like;
    const glm::mat3 linear = LinearPart(set.instances, i);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        instance.transform.matrix[row][column] = linear[column][row];
      }
      instance.transform.matrix[row][3] += set.instances.centres[i][row];
    }
    instance.accelerationStructureReference = set.mesh.structure.Address();
    instances.push_back(instance);
  }
}

} // namespace rtg
