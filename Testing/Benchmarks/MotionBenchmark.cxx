// What motion blur costs and how far from the truth it is.
//
// MotionBenchmark cost SPHERES OUTPUT.csv [PIXELS] [SAMPLES] [TURNS]
//   Processor seconds of one sample a pixel, over those of the same spheres at rest, and seconds to build, by path
//   length, in each of so many turns.
// MotionBenchmark error SPHERES OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] [MOST-SAMPLES] [TURNS]
//   Of the middle PIXELS x PIXELS of an image of 1200 x 1200: mean squared error against a reference of independent
//   samples, by scheme, path length, samples and seconds in each of so many turns over the schemes.
// SPHERES: a file by Data/spheres_280k.py. Paths are in radii, along the file's velocities, and straight.
#include "Files.h"
#include "Measures.h"
#include "Scene.h"
#include "SceneState.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cmath>
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
  subject.velocities = benchmark::ToVectors(benchmark::ReadArray(in, "velocity", 3 * subject.spheres.centres.size()));
  for (glm::vec3& velocity : subject.velocities)
  {
    velocity = glm::normalize(velocity);
  }
  return subject;
}

// The spheres at a fraction of the shutter's opening, at rest; or with the motion of a path of so many radii.
rtg::GlyphInstances Instances(const Subject& subject, double path, bool moving, double fraction = 0.5)
{
  const auto length = static_cast<float>(path * subject.spheres.radius);
  rtg::GlyphInstances instances;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * subject.spheres.radius;
  for (std::size_t i = 0; i < subject.spheres.centres.size(); ++i)
  {
    const glm::vec3 displacement = length * subject.velocities[i];
    const auto time = static_cast<float>(fraction - 0.5);
    instances.centres.push_back(subject.spheres.centres[i] - glm::vec3(50.0f) + (moving ? 0.0f : time) * displacement);
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
    csv << path << ',' << (1u << moving.scene.GetState().placedTimeSliceBits) << ',' << benchmark::Measured(build)
        << ',' << benchmark::Measured(sample) << ',' << benchmark::Measured(overRest) << std::endl;
  }
}

// A way to spread times over an image, and what the rays are traced through.
struct Scheme
{
  const char* name;
  bool independentSamples;
  bool frames; // all pixels of a sample see one time, with a structure of its own
};

constexpr Scheme schemes[] = {
  { "random times: slices", true, false },
  { "strata of times with places: slices", false, false },
  { "one time a frame: rebuilt", false, true },
};

struct Measured
{
  double build = 0.0;
  double trace = 0.0;
  std::vector<glm::vec4> means;
};

// Where the camera looks so that the pixels' centers are places in them that are spread evenly over samples: the
// additive recurrence of the plastic number (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
rtg::Camera Shifted(rtg::Camera camera, std::uint32_t sample, std::uint32_t pixels)
{
  const double plastic = 1.32471795724474602596;
  const auto place = [&](double step) { return 2.0 / pixels * (std::fmod(0.5 + step * sample, 1.0) - 0.5); };
  camera.forward += place(1.0 / plastic) * camera.right + place(1.0 / (plastic * plastic)) * camera.up;
  return camera;
}

Measured Trace(Scene& scene, rtg::Tracer& tracer, const Subject& subject, const Scheme& scheme, double path,
  rtg::TraceSettings settings)
{
  const std::vector<rtg::Light> lights(1);
  const auto trace = [&](const rtg::Camera& camera)
  {
    const double start = benchmark::CpuSeconds();
    tracer.Trace(scene.scene, camera, lights, settings);
    return benchmark::CpuSeconds() - start;
  };
  // The first image compiles the programs.
  const auto compile = [&]
  {
    rtg::TraceSettings first = settings;
    first.samples = 1;
    tracer.Trace(scene.scene, subject.camera, lights, first);
  };
  Measured measured;
  settings.independentSamples = scheme.independentSamples;
  if (!scheme.frames)
  {
    measured.build = scene.Show(Instances(subject, path, true));
    compile();
    measured.trace = trace(subject.camera);
    measured.means = tracer.Means();
    return measured;
  }
  // An image of one scene takes no samples of another: each time has an image of its own, of one sample.
  const std::uint32_t samples = settings.samples;
  settings.samples = 1;
  scene.Show(Instances(subject, path, false));
  compile();
  measured.means.resize(std::size_t(settings.width) * settings.height);
  for (std::uint32_t s = 0; s < samples; ++s)
  {
    measured.build += scene.Show(Instances(subject, path, false, (s + 0.5) / samples));
    measured.trace += trace(Shifted(subject.camera, s, settings.width));
    const std::vector<glm::vec4> one = tracer.Means();
    std::transform(one.begin(), one.end(), measured.means.begin(), measured.means.begin(),
      [samples](const glm::vec4& pixel, const glm::vec4& sum) { return sum + pixel / static_cast<float>(samples); });
  }
  return measured;
}

// What a scheme's images of so many samples took in each turn.
struct Turns
{
  const Scheme* scheme;
  std::uint32_t samples;
  std::vector<double> build, trace;
  std::vector<glm::vec4> means;
};

void MeasureError(Subject& subject, const std::string& output, std::uint32_t pixels, std::uint32_t referenceSamples,
  std::uint32_t mostSamples, std::uint32_t turns)
{
  std::ofstream csv = benchmark::Written(output);
  // The middle of an image of 1200 x 1200; seconds of tracing are of all of it.
  const double whole = 1200.0 * 1200.0 / (double(pixels) * pixels);
  subject.camera.right *= pixels / 1200.0;
  subject.camera.up *= pixels / 1200.0;
  csv << "radii,scheme,samples,build_cpu_seconds,trace_cpu_seconds,mse,reference_mse,blurred_mse\n";
  rtg::TraceSettings settings;
  settings.width = settings.height = pixels;
  settings.keepSums = true;
  rtg::Tracer tracer(subject.device);
  Scene scene(subject);
  for (const double path : paths)
  {
    settings.samples = referenceSamples;
    std::fprintf(stderr, "%g radii: reference of %u samples\n", path, referenceSamples);
    const Measured truth = Trace(scene, tracer, subject, schemes[0], path, settings);
    const std::vector<glm::vec4> blurredTruth = benchmark::Blurred(truth.means, static_cast<int>(pixels));
    std::vector<Turns> all;
    for (const Scheme& scheme : schemes)
    {
      for (std::uint32_t samples = 1; samples <= mostSamples; samples *= 4)
      {
        all.push_back({ &scheme, samples, {}, {}, {} });
      }
    }
    for (std::uint32_t turn = 0; turn < turns; ++turn)
    {
      for (Turns& one : all)
      {
        settings.samples = one.samples;
        Measured found = Trace(scene, tracer, subject, *one.scheme, path, settings);
        one.build.push_back(found.build);
        one.trace.push_back(found.trace * whole);
        one.means = std::move(found.means); // the same in every turn
      }
    }
    // Random times' error falls as 1 / samples, so their measured error gives the reference's own part.
    double referenceError = 0.0;
    for (const Turns& one : all)
    {
      const double error = benchmark::SquaredError(one.means, truth.means);
      if (one.scheme->independentSamples && one.samples == 4)
      {
        referenceError = error / (1.0 + double(referenceSamples) / one.samples);
      }
      csv << path << ',' << one.scheme->name << ',' << one.samples << ',' << benchmark::Measured(one.build) << ','
          << benchmark::Measured(one.trace) << ',' << error << ',' << referenceError << ','
          << benchmark::SquaredError(benchmark::Blurred(one.means, static_cast<int>(pixels)), blurredTruth)
          << std::endl;
    }
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  const std::string what = argc > 3 ? argv[1] : "";
  const auto number = [&](int at, int otherwise)
  { return static_cast<std::uint32_t>(argc > at ? std::atoi(argv[at]) : otherwise); };
  if (what != "cost" && what != "error")
  {
    std::fprintf(stderr,
      "Usage: MotionBenchmark cost SPHERES.vtk OUTPUT.csv [PIXELS] [SAMPLES] [TURNS]\n"
      "       MotionBenchmark error SPHERES.vtk OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] "
      "[MOST-SAMPLES] [TURNS]\n");
    return 2;
  }
  Subject subject = Load(argv[2]);
  if (what == "cost")
  {
    MeasureCost(subject, argv[3], number(4, 300), number(5, 8), number(6, 7));
  }
  else
  {
    MeasureError(subject, argv[3], number(4, 160), number(5, 1024), number(6, 64), number(7, 7));
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "MotionBenchmark: %s\n", error.what());
  return 1;
}
