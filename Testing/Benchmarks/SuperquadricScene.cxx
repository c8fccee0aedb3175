// Time of an image of 280,000 superquadrics with random exponents beside one of as many spheres, through the pipeline.
// Usage: SuperquadricScene [PIXELS] [REPETITIONS] [COUNT]
//
// Layout, camera and coverage are those of Data/spheres_280k.py; exponents lie between 0.3 and 20 at random on a logarithmic
// scale. The superquadrics' sizes are such that their boxes' sides are the spheres' diameters.
#include "Measures.h"
#include "Camera.h"
#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace
{

// The camera of spheres_280k.py: the box's near face just fills a square view of 30 degrees.
rtg::Camera SceneCamera()
{
  const double tangent = std::tan(15.0 * 3.14159265358979323846 / 180.0);
  rtg::Camera camera;
  camera.eye = { 0.0, 0.0, 50.0 + 186.6025 };
  camera.forward = { 0.0, 0.0, -1.0 };
  camera.right = { tangent, 0.0, 0.0 };
  camera.up = { 0.0, tangent, 0.0 };
  camera.nearDepth = 180.0;
  camera.farDepth = 300.0;
  camera.depthA = camera.farDepth / (camera.farDepth - camera.nearDepth);
  camera.depthB = -camera.farDepth * camera.nearDepth / (camera.farDepth - camera.nearDepth);
  return camera;
}

struct Kind
{
  const char* name;
  rtg::Shape shape;
  float leastExponent, mostExponent; ///< equal: one for all
  bool turned;
};

} // namespace

int main(int argc, char** argv)
try
{
  const std::uint32_t pixels = argc > 1 ? std::uint32_t(std::atoi(argv[1])) : 1200;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  const int count = argc > 3 ? std::atoi(argv[3]) : 280000;
  const Kind kinds[] = {
    { "spheres", rtg::Shape::Sphere, 2, 2, false },
    { "superquadrics, all 2", rtg::Shape::Superquadric, 2, 2, false },
    { "superquadrics, 1 to 20", rtg::Shape::Superquadric, 1, 20, false },
    { "superquadrics, 0.3 to 20", rtg::Shape::Superquadric, 0.3f, 20, false },
    { "ellipsoids, turned", rtg::Shape::Sphere, 2, 2, true },
    { "superquadrics, 0.3 to 20, turned", rtg::Shape::Superquadric, 0.3f, 20, true },
  };
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  std::printf("device: %s, %d glyphs, %u x %u\n", device->Name().c_str(), count, pixels, pixels);
  std::printf("%-34s %8s %8s %8s %10s %8s\n", "", "first s", "wall s", "CPU s", "Mray/s", "hit %");
  for (const bool packed : { false, true })
  {
    for (const Kind& kind : kinds)
    {
      std::mt19937 random(20190923);
      std::uniform_real_distribution<float> place(-50.0f, 50.0f), unit(0.0f, 1.0f);
      std::normal_distribution<float> normal;
      rtg::GlyphInstances instances;
      instances.shape = kind.shape;
      instances.uniformSize = packed ? 0.8f * 100.0f / std::cbrt(float(count))
                                     : 2.0f * 0.17769f * std::sqrt(280000.0f / float(count));
      for (int i = 0; i < count; ++i)
      {
        instances.centres.emplace_back(place(random), place(random), place(random));
        const glm::vec3 share(unit(random), unit(random), unit(random));
        const float least = kind.leastExponent, ratio = kind.mostExponent / least;
        if (ratio > 1.0f)
        {
          instances.exponents3.push_back(least * glm::pow(glm::vec3(ratio), share));
        }
        if (kind.turned)
        {
          instances.rotations.push_back(
            glm::normalize(glm::vec4(normal(random), normal(random), normal(random), normal(random))));
          instances.sizes3.push_back(
            instances.uniformSize * (0.5f + 0.5f * glm::vec3(unit(random), unit(random), unit(random))));
        }
      }
      rtg::Scene scene(device);
      rtg::Tracer tracer(device);
      scene.SetInstances(scene.Add(), std::move(instances));
      scene.Commit();
      rtg::TraceSettings settings;
      settings.width = settings.height = pixels;
      const std::vector<rtg::Light> lights(1);
      const auto wallNow = []
      {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
          .count();
      };
      double first = wallNow();
      tracer.Trace(scene, SceneCamera(), lights, settings);
      first = wallNow() - first;
      double wall = 1e30, cpu = 1e30, hits = 0;
      for (int i = 0; i < repetitions; ++i)
      {
        const double wallStart = wallNow(), cpuStart = benchmark::CpuSeconds();
        const rtg::Image image = tracer.Trace(scene, SceneCamera(), lights, settings);
        wall = std::min(wall, wallNow() - wallStart);
        cpu = std::min(cpu, benchmark::CpuSeconds() - cpuStart);
        hits = double(std::count_if(image.depth, image.depth + std::size_t(pixels) * pixels,
          [](float depth) { return depth < 1.0f; }));
      }
      const double rays = double(pixels) * pixels;
      std::printf("%-34s %8.2f %8.3f %8.3f %10.2f %8.1f%s\n", kind.name, first, wall, cpu,
        1e-6 * rays / wall, 100.0 * hits / rays, packed ? "  packed" : "");
      std::fflush(stdout);
    }
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "SuperquadricScene: %s\n", error.what());
  return 1;
}
