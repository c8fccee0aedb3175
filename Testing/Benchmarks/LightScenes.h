// Scenes to measure light on, as glyphs, camera and the radius of ambient occlusion that suits them.
#pragma once

#include "Camera.h"
#include "Files.h"
#include "Scene.h"
#include "Tensor.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark
{

struct LightScene
{
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Camera camera;
  int side = 1200;     ///< pixels of the whole view that the camera is for
  float radius = 0.0f; ///< of ambient occlusion, world units; 0: unbounded
};

inline rtg::Material Painted(glm::vec3 color)
{
  rtg::Material material;
  material.color = material.ambientColor = color;
  return material;
}

inline void Show(LightScene& subject, rtg::GlyphInstances instances, glm::vec3 color)
{
  const auto set = subject.scene.Add();
  subject.scene.SetInstances(set, std::move(instances));
  subject.scene.SetMaterial(set, Painted(color));
}

/// The file of Data/spheres_280k.py.
inline void AddSpheres(LightScene& subject, const std::string& path)
{
  const Spheres spheres = ReadSpheres(path);
  rtg::GlyphInstances instances;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * spheres.radius;
  for (const glm::vec3& center : spheres.centers)
  {
    instances.centers.push_back(center - glm::vec3(50.0f));
  }
  Show(subject, std::move(instances), { 0.85f, 0.8f, 0.7f });
  subject.camera = SpheresCamera();
}

/// A box that is open above and in front, seen from inside and outside alike.
inline rtg::TriangleMesh Vessel(glm::vec3 low, glm::vec3 high)
{
  rtg::TriangleMesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    mesh.positions.emplace_back(
      corner & 1u ? high.x : low.x, corner & 2u ? high.y : low.y, corner & 4u ? high.z : low.z);
  }
  mesh.triangles = { { 0, 1, 3 }, { 0, 3, 2 }, { 2, 3, 7 }, { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 5, 7 },
    { 1, 7, 3 } };
  return mesh;
}

/// The grains' velocities of a file of Data/impact as arrows in a vessel, as in Testing/Pictures/shading_modes.py.
inline void AddArrowsInVessel(LightScene& subject, const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  const std::vector<glm::vec3> points = ReadPoints(in);
  const std::vector<glm::vec3> velocities = ToVectors(ReadArray(in, "velocity", 3 * points.size()));
  if (!in || points.empty())
  {
    throw std::runtime_error(path + " has no points with an array 'velocity'");
  }
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Arrow;
  instances.arrow = { 0.12f, 0.3f, 0.8f, 0.5f, true, 0.3f };
  instances.origin = { 14.0, 14.0, 5.0 };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float speed = glm::length(velocities[i]);
    if (!(speed > 0.0f))
    {
      continue;
    }
    // The shortest turn of x to the velocity.
    const glm::vec3 d = velocities[i] / speed;
    const glm::vec4 turn = d.x > -0.9999f ? glm::vec4(0.0f, -d.z, d.y, 1.0f + d.x) : glm::vec4(0, 0, 1, 0);
    instances.centers.push_back(points[i] - glm::vec3(instances.origin));
    instances.sizes3.push_back(glm::vec3(0.3f * speed));
    instances.rotations.push_back(glm::normalize(turn));
  }
  const glm::vec3 origin(instances.origin);
  Show(subject, std::move(instances), { 0.85f, 0.8f, 0.7f });

  rtg::GlyphInstances walls;
  walls.shape = rtg::Shape::Mesh;
  walls.mesh = std::make_shared<const rtg::TriangleMesh>(
    Vessel(glm::vec3(-0.7f, 2.0f, -0.5f) - origin, glm::vec3(29.3f, 29.0f, 13.0f) - origin));
  walls.identifyTriangles = true;
  walls.origin = glm::dvec3(origin);
  walls.centers = { glm::vec3(0.0f) };
  Show(subject, std::move(walls), { 0.85f, 0.83f, 0.8f });
  subject.camera = LookAt({ 10.0, -26.0, 24.0 }, { 14.3, 14.0, 5.5 }, { 0.0, 0.0, 1.0 }, 30.0, 5.0, 100.0);
  subject.side = 400;
  subject.radius = 8.0f;
}

/// The tensors of a file of Data/helix.py with more fibers than surroundings, as in Testing/Pictures/tensors.py.
inline void AddTensors(LightScene& subject, const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::string word;
  int side = 0;
  while (in >> word && word != "DIMENSIONS")
  {
  }
  in >> side;
  const std::size_t count = static_cast<std::size_t>(side) * side * side;
  const std::vector<float> tensors = ReadArray(in, "diffusion", 6 * count);
  const std::vector<float> share = ReadArray(in, "bundle", count);
  if (!in || side < 2)
  {
    throw std::runtime_error(path + " is no file by helix.py");
  }
  const double spacing = 2.0 / (side - 1);
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::NestedSuperquadric;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!(share[i] > 0.5f))
    {
      continue;
    }
    const auto t = tensors.begin() + 6 * i;
    const rtg::SymmetricTensor tensor{ t[0], t[1], t[2], t[3], t[4], t[5] };
    const rtg::TensorGlyph glyph =
      rtg::MakeTensorGlyph(rtg::Decompose(tensor), rtg::TensorGlyphKind::Superquadric, 3.0);
    const glm::dvec3 at(i % side, i / side % side, i / side / side);
    instances.centers.emplace_back(at * spacing - 1.0);
    // The largest eigenvalue is 1.7, and the longest glyph is to be 1.3 spacings long.
    instances.sizes3.emplace_back(glyph.halfLengths * (1.3 * spacing / 1.7));
    instances.rotations.emplace_back(glyph.rotation.x, glyph.rotation.y, glyph.rotation.z, glyph.rotation.w);
    instances.exponents3.emplace_back(glyph.exponents);
  }
  Show(subject, std::move(instances), { 0.85f, 0.8f, 0.7f });
  // At the turn in front, which is about the helix at -49 degrees.
  subject.camera = LookAt({ 2.6, -3.0, 1.9 }, { 0.39, -0.45, -0.12 }, { 0.0, 0.0, 1.0 }, 30.0, 1.0, 10.0);
  subject.side = 400;
}

/// By what the file says of itself in its second line.
inline void Load(LightScene& subject, const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  if (line.find("impact") != std::string::npos)
  {
    AddArrowsInVessel(subject, path);
  }
  else if (line.find("helix") != std::string::npos)
  {
    AddTensors(subject, path);
  }
  else
  {
    AddSpheres(subject, path);
  }
  subject.scene.Commit();
}

} // namespace benchmark
