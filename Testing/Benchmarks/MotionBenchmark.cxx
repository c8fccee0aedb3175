// What motion blur costs and how far from the truth it is.
//
// MotionBenchmark cost SPHERES [PIXELS] [SAMPLES]
//   Processor seconds of one sample a pixel, over those of the same spheres at rest, by path length, number of time slices and
//   sampling of time; and seconds to build.
// MotionBenchmark error SPHERES OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] [MOST-SAMPLES]
//   Of the middle PIXELS x PIXELS of an image of 1200 x 1200: mean squared error against a reference of independent samples, by
//   scheme, path length, samples and seconds.
// SPHERES: a file by Data/spheres_280k.py. Paths are in radii, along the file's velocities, and straight.
#include "Files.h"
#include "Scene.h"
#include "SceneState.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

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

// Processor seconds of this process, all threads: less disturbed by other work than the wall clock.
double CpuSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Subject Load(const std::string& path)
{
  Subject subject;
  subject.spheres = benchmark::ReadSpheres(path);
  std::ifstream in(path, std::ios::binary);
  benchmark::ReadPoints(in);
  subject.velocities =
    benchmark::ToVectors(benchmark::ReadArray(in, "velocity", 3 * subject.spheres.centres.size()));
  for (glm::vec3& velocity : subject.velocities)
  {
    velocity = glm::normalize(velocity);
  }
  return subject;
}

// The spheres at a fraction of the shutter's opening, at rest; or with the motion of a path of so many radii.
rtg::GlyphInstances
Instances(const Subject& subject, double path, bool moving, double fraction = 0.5)
{
  const auto length = static_cast<float>(path * subject.spheres.radius);
  rtg::GlyphInstances instances;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * subject.spheres.radius;
  for (std::size_t i = 0; i < subject.spheres.centres.size(); ++i)
  {
    const glm::vec3 displacement = length * subject.velocities[i];
    const auto time = static_cast<float>(fraction - 0.5);
    instances.centres.push_back(
      subject.spheres.centres[i] - glm::vec3(50.0f) + (moving ? 0.0f : time) * displacement);
    if (moving)
    {
      instances.motion.velocities.push_back(displacement);
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
    material.colour = material.ambientColour = glm::vec3(0.85f, 0.8f, 0.7f);
    this->scene.SetMaterial(this->set, material);
  }
  // Processor seconds to have them ready.
  double Show(rtg::GlyphInstances instances)
  {
    const double start = CpuSeconds();
    this->scene.SetInstances(this->set, std::move(instances));
    this->scene.Commit();
    return CpuSeconds() - start;
  }
  rtg::Scene scene;
  rtg::Scene::SetId set;
};

// Processor seconds of an image after one that compiles.
double
Cost(Scene& scene, rtg::Tracer& tracer, const Subject& subject, const rtg::TraceSettings& settings)
{
  rtg::TraceSettings first = settings;
  first.samples = 1;
  first.keepSums = true;
  const std::vector<rtg::Light> lights(1);
  tracer.Trace(scene.scene, subject.camera, lights, first);
  const double start = CpuSeconds();
  tracer.Trace(scene.scene, subject.camera, lights, settings);
  return CpuSeconds() - start;
}

void MeasureCost(const Subject& subject, std::uint32_t pixels, std::uint32_t samples)
{
  rtg::TraceSettings settings;
  settings.width = settings.height = pixels;
  settings.samples = samples;
  settings.keepSums = true;
  rtg::Tracer tracer(subject.device);
  Scene scene(subject);
  std::printf("%u x %u, %u samples\n%8s %7s %7s %10s %12s %10s\n", pixels, pixels, samples, "radii",
    "slices", "shared", "build s", "s a sample", "at rest=1");
  for (const double path : paths)
  {
    scene.Show(Instances(subject, path, false));
    const double still = Cost(scene, tracer, subject, settings) / samples;
    std::printf("%8.1f %7s %7s %10s %12.3f %10.2f\n", path, "rest", "", "", still, 1.0);
    const auto measure = [&](int bits, rtg::SliceSorting sorting, int sharedBits)
    {
      scene.scene.GetState().timeSliceBits = bits;
      scene.scene.GetState().sliceSorting = sorting;
      const double build = scene.Show(Instances(subject, path, true));
      settings.sharedTimeBits = sharedBits;
      const double seconds = Cost(scene, tracer, subject, settings) / samples;
      std::printf("%8.1f %6u%s %7d %10.2f %12.3f %10.2f %s\n", path,
        1u << scene.scene.GetState().placedTimeSliceBits, bits < 0 ? "*" : " ", sharedBits, build,
        seconds, seconds / still,
        sorting == rtg::SliceSorting::Always    ? "sorted"
          : sorting == rtg::SliceSorting::Never ? "not sorted"
                                                : "");
      std::fflush(stdout);
    };
    using Sorting = rtg::SliceSorting;
    measure(0, Sorting::Never, -1);
    measure(-1, Sorting::WhereDecayed, -1);
    measure(-1, Sorting::WhereDecayed, 0);
    measure(-1, Sorting::Never, -1);
    measure(-1, Sorting::Always, -1);
    for (int bits = 1; bits <= 5; ++bits)
    {
      measure(bits, Sorting::WhereDecayed, -1);
    }
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  const std::string what = argc > 2 ? argv[1] : "";
  const auto number = [&](int at, int otherwise)
  { return static_cast<std::uint32_t>(argc > at ? std::atoi(argv[at]) : otherwise); };
  const Subject subject = Load(argv[2]);
  MeasureCost(subject, number(3, 600), number(4, 8));
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "MotionBenchmark: %s\n", error.what());
  return 1;
}
