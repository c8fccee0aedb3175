// What light costs and how far from the truth it is.
//
// LightBenchmark cost SCENE [PIXELS] [REPETITIONS]
//   Seconds of an image with local shading, with one ray of ambient occlusion, and path-traced with 1, 2, ... bounces.
// LightBenchmark error SCENE OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] [MOST-SAMPLES]
//   Of the middle PIXELS x PIXELS of an image of 1200 x 1200: mean squared error against a reference of independent samples, by shading, sampler, samples and seconds.
// SCENE: a file by Data/spheres_280k.py, or one of Data/impact, whose velocities become arrows.
#include "Files.h"
#include "Measures.h"
#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using rtg::Sampler;
using rtg::Shading;

struct Subject
{
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene{ device };
  rtg::Camera camera;
  double extent = 1.0; // a radius of ambient occlusion that means something
};

rtg::Material Grey()
{
  rtg::Material material;
  material.colour = material.ambientColour = glm::vec3(0.85f, 0.8f, 0.7f);
  return material;
}

void AddSpheres(Subject& subject, const std::string& path)
{
  const benchmark::Spheres spheres = benchmark::ReadSpheres(path);
  rtg::GlyphInstances instances;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * spheres.radius;
  for (const glm::vec3& centre : spheres.centres)
  {
    instances.centres.push_back(centre - glm::vec3(50.0f));
  }
  const auto set = subject.scene.Add();
  subject.scene.SetInstances(set, std::move(instances));
  subject.scene.SetMaterial(set, Grey());
  subject.camera = benchmark::SpheresCamera();
}

// The grains' velocities as arrows, as in Testing/Pictures/simulation.py.
void AddArrows(Subject& subject, const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  const std::vector<glm::vec3> points = benchmark::ReadPoints(in);
  const std::vector<glm::vec3> velocities =
    benchmark::ToVectors(benchmark::ReadArray(in, "velocity", 3 * points.size()));
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
    const glm::vec4 turn =
      d.x > -0.9999f ? glm::vec4(0.0f, -d.z, d.y, 1.0f + d.x) : glm::vec4(0, 0, 1, 0);
    instances.centres.push_back(points[i] - glm::vec3(instances.origin));
    instances.sizes3.push_back(glm::vec3(0.3f * speed));
    instances.rotations.push_back(glm::normalize(turn));
  }
  const auto set = subject.scene.Add();
  subject.scene.SetInstances(set, std::move(instances));
  subject.scene.SetMaterial(set, Grey());
  subject.camera = benchmark::LookAt(
    { 9.0, -34.0, 22.0 }, { 14.3, 14.0, 5.5 }, { 0.0, 0.0, 1.0 }, 30.0, 10.0, 100.0);
}

void Load(Subject& subject, const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  if (line.find("impact") != std::string::npos)
  {
    AddArrows(subject, path);
  }
  else
  {
    AddSpheres(subject, path);
  }
  subject.scene.Commit();
}

// Best processor seconds of a number of repetitions after a first one that compiles.
double BestOf(int repetitions, const std::function<void()>& work)
{
  work();
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i)
  {
    const double start = benchmark::CpuSeconds();
    work();
    best = std::min(best, benchmark::CpuSeconds() - start);
  }
  return best;
}

void MeasureCost(Subject& subject, int pixels, int repetitions)
{
  rtg::Tracer tracer(subject.device);
  const std::vector<rtg::Light> lights(1);
  rtg::TraceSettings settings;
  settings.width = settings.height = static_cast<std::uint32_t>(pixels);
  const auto seconds = [&]
  {
    return BestOf(
      repetitions, [&] { tracer.Trace(subject.scene, subject.camera, lights, settings); });
  };

  std::printf("%s, %d x %d, one sample a pixel\n%-24s %10s %14s\n", subject.device->Name().c_str(),
    pixels, pixels, "", "CPU s", "local = 1");
  const double local = seconds();
  std::printf("%-24s %10.3f %14.2f\n", "local", local, 1.0);
  settings.shading = Shading::AmbientOcclusion;
  for (const auto& [name, sampler] : { std::pair("occlusion, random", Sampler::Random),
         std::pair("occlusion, stratified", Sampler::Stratified),
         std::pair("occlusion, Sobol", Sampler::Sobol),
         std::pair("occlusion, blue noise", Sampler::BlueNoise) })
  {
    settings.sampler = sampler;
    const double cost = seconds();
    std::printf("%-24s %10.3f %14.2f\n", name, cost, cost / local);
  }
  settings.sampler = Sampler::Sobol;
  settings.shading = Shading::PathTracing;
  double before = local;
  for (std::uint32_t bounces : { 1, 2, 3, 4, 6, 8, 10 })
  {
    settings.maximumBounces = bounces;
    const auto image = [&] { tracer.Trace(subject.scene, subject.camera, {}, settings); };
    const double cost = BestOf(repetitions, image);
    std::printf("path, %2u bounces         %10.3f %14.2f  (%+.3f s)\n", bounces, cost, cost / local,
      cost - before);
    before = cost;
  }
}

void MeasureError(Subject& subject, const std::string& output, int pixels,
  std::uint32_t referenceSamples, std::uint32_t mostSamples)
{
  std::FILE* csv = std::fopen(output.c_str(), "w");
  if (!csv)
  {
    throw std::runtime_error("cannot write " + output);
  }
  // The middle of an image of 1200 x 1200: what a pixel sees there decides how hard it is.
  subject.camera.right *= pixels / 1200.0;
  subject.camera.up *= pixels / 1200.0;
  std::fprintf(csv, "shading,sampler,samples,cpu_seconds,mse,reference_mse,blurred_mse\n");
  const std::pair<const char*, Shading> shadings[] = { { "occlusion", Shading::AmbientOcclusion },
    { "path", Shading::PathTracing } };
  const std::pair<const char*, Sampler> samplers[] = { { "random", Sampler::Random },
    { "stratified", Sampler::Stratified }, { "sobol", Sampler::Sobol },
    { "blue noise", Sampler::BlueNoise } };
  for (const auto& [shadingName, shading] : shadings)
  {
    rtg::TraceSettings settings;
    settings.width = settings.height = static_cast<std::uint32_t>(pixels);
    settings.shading = shading;
    settings.keepSums = true;
    const std::vector<rtg::Light> lights(shading == Shading::PathTracing ? 0 : 1);
    rtg::Tracer tracer(subject.device);

    // Independent samples favour none of the others; its own error is known.
    rtg::TraceSettings reference = settings;
    reference.samples = referenceSamples;
    reference.sampler = Sampler::Random;
    std::fprintf(stderr, "%s: reference of %u samples\n", shadingName, referenceSamples);
    tracer.Trace(subject.scene, subject.camera, lights, reference);
    const std::vector<glm::vec4> truth = tracer.Means();
    const std::vector<glm::vec4> blurredTruth = benchmark::Blurred(truth, pixels);

    // Random samples' error falls as 1 / samples, so what they measure tells the reference's own part.
    double referenceError = 0.0;
    const std::uint32_t most =
      shading == Shading::AmbientOcclusion ? std::min(256u, mostSamples) : mostSamples;
    for (const auto& [samplerName, sampler] : samplers)
    {
      settings.sampler = sampler;
      for (settings.samples = 1; settings.samples <= most; settings.samples *= 2)
      {
        const auto image = [&] { tracer.Trace(subject.scene, subject.camera, lights, settings); };
        const double seconds = BestOf(settings.samples <= 16 ? 3 : 1, image);
        const std::vector<glm::vec4> means = tracer.Means();
        const double error = benchmark::SquaredError(means, truth);
        if (sampler == Sampler::Random && settings.samples == std::min(16u, most))
        {
          referenceError = error / (1.0 + double(referenceSamples) / settings.samples);
        }
        std::fprintf(csv, "%s,%s,%u,%.4f,%.6g,%.6g,%.6g\n", shadingName, samplerName,
          settings.samples, seconds, error, referenceError,
          benchmark::SquaredError(benchmark::Blurred(means, pixels), blurredTruth));
        std::fflush(csv);
      }
    }
  }
  std::fclose(csv);
}

} // namespace

int main(int argc, char** argv)
try
{
  const std::string what = argc > 2 ? argv[1] : "";
  const auto number = [&](int at, int otherwise)
  { return argc > at ? std::atoi(argv[at]) : otherwise; };
  if (what != "cost" && !(what == "error" && argc > 3))
  {
    std::fprintf(stderr,
      "Usage: LightBenchmark cost SCENE.vtk [PIXELS] [REPETITIONS]\n"
      "       LightBenchmark error SCENE.vtk OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] "
      "[MOST-SAMPLES]\n");
    return 2;
  }
  Subject subject;
  Load(subject, argv[2]);
  if (what == "cost")
  {
    MeasureCost(subject, number(3, 1200), number(4, 3));
  }
  else
  {
    MeasureError(subject, argv[3], number(4, 240), static_cast<std::uint32_t>(number(5, 16384)),
      static_cast<std::uint32_t>(number(6, 1024)));
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "LightBenchmark: %s\n", error.what());
  return 1;
}
