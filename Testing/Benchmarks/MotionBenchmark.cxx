// What motion blur costs.
//
// MotionBenchmark SPHERES OUTPUT.csv [PIXELS] [SAMPLES] [TURNS]
//   Processor seconds of one sample a pixel, over those of the same spheres at rest, and seconds to build, by path
//   length, in each of so many turns.
// SPHERES: a file by Data/spheres_280k.py. Paths are in radii, along the file's velocities, and straight.
#include "Files.h"
#include "Measures.h"
#include "Scene.h"
#include "SceneState.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace
{

constexpr double paths[] = { 0.5, 3.0, 10.0, 50.0 }; // radii

struct Subject
{
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  benchmark::Spheres spheres;
  std::vector<glm::vec3> velocities; // of length one
  rtg::Camera camera = benchmark::SpheresCamera();
};

Subject Load(const std::string& path)
{
  Subject subject;
  subject.spheres = benchmark::ReadSpheres(path);
  std::ifstream in(path, std::ios::binary);
  benchmark::ReadPoints(in);
  subject.velocities = benchmark::ToVectors(benchmark::ReadArray(in, "velocity", 3 * subject.spheres.centers.size()));
  for (glm::vec3& velocity : subject.velocities)
  {
    velocity = glm::normalize(velocity);
  }
  return subject;
}

// The spheres at rest, or with the motion of a path of so many radii.
rtg::GlyphInstances Instances(const Subject& subject, double path, bool moving)
{
  const auto length = static_cast<float>(path * subject.spheres.radius);
  rtg::GlyphInstances instances;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * subject.spheres.radius;
  for (std::size_t i = 0; i < subject.spheres.centers.size(); ++i)
  {
    instances.centers.push_back(subject.spheres.centers[i] - glm::vec3(50.0f));
    if (moving)
    {
      instances.motion.velocities.push_back(length * subject.velocities[i]);
    }
  }
  return instances;
}

struct Scene
{
  explicit Scene(const Subject& subject)
    : scene(subject.device)
    , set(scene.Add())
  {
    rtg::Material material;
    material.color = material.ambientColor = glm::vec3(0.85f, 0.8f, 0.7f);
    this->scene.SetMaterial(this->set, material);
  }
  // Processor seconds to have them ready.
  double Show(rtg::GlyphInstances instances)
  {
    const double start = benchmark::CpuSeconds();
    this->scene.SetInstances(this->set, std::move(instances));
    this->scene.Commit();
    return benchmark::CpuSeconds() - start;
  }
  rtg::Scene scene;
  rtg::Scene::SetId set;
};

// Processor seconds of an image after one that compiles.
double Cost(Scene& scene, rtg::Tracer& tracer, const Subject& subject, const rtg::TraceSettings& settings)
{
  rtg::TraceSettings first = settings;
  first.samples = 1;
  first.keepSums = true;
  const std::vector<rtg::Light> lights(1);
  tracer.Trace(scene.scene, subject.camera, lights, first);
  const double start = benchmark::CpuSeconds();
  tracer.Trace(scene.scene, subject.camera, lights, settings);
  return benchmark::CpuSeconds() - start;
}

void MeasureCost(
  const Subject& subject, const std::string& output, std::uint32_t pixels, std::uint32_t samples, std::uint32_t turns)
{
  std::ofstream csv = benchmark::Written(output);
  csv << "radii,slices,build_cpu_seconds,sample_cpu_seconds,over_rest" << std::endl;
  rtg::TraceSettings settings;
  settings.width = settings.height = pixels;
  settings.samples = samples;
  settings.keepSums = true;
  rtg::Tracer tracer(subject.device);
  Scene still(subject), moving(subject);
  for (const double path : paths)
  {
    still.Show(Instances(subject, path, false));
    std::vector<double> build, sample, overRest;
    for (std::uint32_t turn = 0; turn < turns; ++turn)
    {
      build.push_back(moving.Show(Instances(subject, path, true)));
      const double rest = Cost(still, tracer, subject, settings);
      const double cost = Cost(moving, tracer, subject, settings);
      sample.push_back(cost / samples);
      overRest.push_back(cost / rest);
    }
    csv << path << ',' << (1u << moving.scene.GetState().records.sliceBits) << ',' << benchmark::Measured(build) << ','
        << benchmark::Measured(sample) << ',' << benchmark::Measured(overRest) << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc < 3)
  {
    std::fprintf(stderr, "Usage: MotionBenchmark SPHERES.vtk OUTPUT.csv [PIXELS] [SAMPLES] [TURNS]\n");
    return 2;
  }
  const auto number = [&](int at, int otherwise)
  { return static_cast<std::uint32_t>(argc > at ? std::atoi(argv[at]) : otherwise); };
  MeasureCost(Load(argv[1]), argv[2], number(3, 300), number(4, 8), number(5, 7));
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "MotionBenchmark: %s\n", error.what());
  return 1;
}
