// What light costs and how far from the truth it is.
//
// LightBenchmark cost OUTPUT.csv NAME=SCENE...
//   Processor seconds of an image of 600 x 600 with local shading, with one ray of ambient occlusion, and path-traced
//   with 1, 2, ... bounces, and ratios to local shading, in each of five turns.
// LightBenchmark error SCENE OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] [MOST-SAMPLES]
//   Of 3 x 3 squares of PIXELS x PIXELS, evenly spread over the scene's view: mean squared error against a reference of
//   independent samples, by shading, sampler, samples and seconds, as traced and denoised. References are kept beside
//   OUTPUT and used again.
// SCENE: a file by Data/spheres_280k.py or Data/helix.py, or one of Data/impact, whose velocities become arrows in a
// vessel.
#include "Denoiser.h"
#include "LightScenes.h"
#include "Measures.h"
#include "Shading/Shading.h"
#include "Tracer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numeric>

namespace
{

using benchmark::LightScene;
using rtg::Shading;

constexpr std::pair<const char*, Shading> shadings[] = { { "occlusion", Shading::AmbientOcclusion },
  { "path", Shading::PathTracing } };

// A way of lighting whose cost is asked for.
struct Costly
{
  std::string name;
  Shading shading = Shading::Local;
  std::uint32_t bounces = 1;
};

// All are taken in turns, and the ratio to local shading's time in the same turn counts: the machine's speed changes.
void MeasureCost(LightScene& subject, const std::string& scene, std::ofstream& csv)
{
  constexpr int turns = 5;
  std::vector<Costly> all{ { "local" }, { "occlusion", Shading::AmbientOcclusion } };
  for (std::uint32_t bounces : { 1, 2, 3, 4, 6, 8, 10 })
  {
    all.push_back({ "path " + std::to_string(bounces), Shading::PathTracing, bounces });
  }
  rtg::Tracer tracer(subject.device);
  rtg::TraceSettings settings;
  settings.width = settings.height = 600;
  std::vector<std::vector<double>> seconds(all.size()), ratios(all.size());
  for (int turn = 0; turn <= turns; ++turn)
  {
    double local = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      settings.shading = all[i].shading;
      settings.maximumBounces = all[i].bounces;
      const std::vector<rtg::Light> lights(settings.shading == Shading::PathTracing ? 0 : 1);
      const double start = benchmark::CpuSeconds();
      tracer.Trace(subject.scene, subject.camera, lights, settings);
      const double spent = benchmark::CpuSeconds() - start;
      local = i == 0 ? spent : local;
      if (turn > 0) // the first one compiles
      {
        seconds[i].push_back(spent);
        ratios[i].push_back(spent / local);
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    csv << scene << ',' << all[i].name << ',' << benchmark::Measured(seconds[i]) << ','
        << benchmark::Measured(ratios[i]) << std::endl;
  }
}

using Pixels = std::vector<glm::vec4>;

// Squares of the view at its scale, as many a side.
std::vector<rtg::Camera> SquaresOf(const LightScene& subject, int pixels, int aside = 3)
{
  std::vector<rtg::Camera> squares;
  for (int i = 0; i < aside * aside; ++i)
  {
    const double x = (2 * (i % aside) + 1.0) / aside - 1.0, y = (2 * (i / aside) + 1.0) / aside - 1.0;
    rtg::Camera camera = subject.camera;
    camera.forward += x * camera.right + y * camera.up;
    camera.right *= static_cast<double>(pixels) / subject.side;
    camera.up *= static_cast<double>(pixels) / subject.side;
    squares.push_back(camera);
  }
  return squares;
}

rtg::TraceSettings SettingsOf(LightScene& subject, int pixels, Shading shading)
{
  rtg::TraceSettings settings;
  settings.width = settings.height = static_cast<std::uint32_t>(pixels);
  settings.shading = shading;
  settings.occlusionRadius = subject.radius;
  settings.keepSums = true;
  return settings;
}

std::vector<rtg::Light> LightsOf(Shading shading)
{
  return std::vector<rtg::Light>(shading == Shading::PathTracing ? 0 : 1);
}

// How the rays of a pixel are shared out and spread.
struct Method
{
  bool independentSamples;
  std::uint32_t raysPerSample = 1; ///< occlusion rays or paths

  std::string Name() const
  {
    return std::string(this->independentSamples ? "random" : "sobol") +
      (this->raysPerSample == 1 ? std::string() : " x" + std::to_string(this->raysPerSample));
  }

  void Apply(rtg::TraceSettings& settings) const
  {
    settings.independentSamples = this->independentSamples;
    settings.occlusionRays = settings.paths = this->raysPerSample;
  }
};

std::vector<Method> Methods(Shading shading)
{
  return { { true }, { false },
    { false, shading == Shading::AmbientOcclusion ? 8u : 4u } }; // the last one is the plugin's default
}

Pixels Denoised(Pixels means, rtg::ImageFeatures features, Shading shading)
{
  std::vector<glm::vec3>& albedos = features.albedos;
  if (shading == Shading::PathTracing)
  {
    std::transform(albedos.begin(), albedos.end(), albedos.begin(), rtg::shading::DisplayToLinear);
  }
  rtg::Denoise(means, features);
  return means;
}

// What is measured: squares of a view, one after the other.
struct Squares
{
  rtg::Tracer tracer;
  LightScene& subject;
  std::vector<rtg::Camera> cameras;
  std::vector<rtg::Light> lights;
  std::vector<Pixels> denoised; ///< when features were asked for
  double denoising = 0.0;       ///< processor seconds it took

  std::vector<Pixels> Trace(const rtg::TraceSettings& settings)
  {
    std::vector<Pixels> means;
    this->denoised.clear();
    this->denoising = 0.0;
    for (const rtg::Camera& camera : this->cameras)
    {
      this->tracer.Trace(this->subject.scene, camera, this->lights, settings);
      means.push_back(this->tracer.Means());
      if (settings.features)
      {
        const double before = benchmark::CpuSeconds();
        this->denoised.push_back(Denoised(means.back(), this->tracer.Features(), settings.shading));
        this->denoising += benchmark::CpuSeconds() - before;
      }
    }
    return means;
  }
};

double SquaredError(const std::vector<Pixels>& a, const std::vector<Pixels>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += benchmark::SquaredError(a[i], b[i]) / static_cast<double>(a.size());
  }
  return sum;
}

// Independent samples; from the file if it holds so many of so many pixels.
std::vector<Pixels>
Reference(Squares& squares, rtg::TraceSettings settings, std::uint32_t samples, const std::string& path)
{
  std::vector<Pixels> means(squares.cameras.size(), Pixels(std::size_t(settings.width) * settings.height));
  const std::uint32_t head[3] = { samples, settings.width, static_cast<std::uint32_t>(means.size()) };
  std::uint32_t found[3] = {};
  const auto bytes = [](const Pixels& pixels)
  { return static_cast<std::streamsize>(pixels.size() * sizeof(glm::vec4)); };
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(found), sizeof found);
  for (Pixels& pixels : means)
  {
    in.read(reinterpret_cast<char*>(pixels.data()), bytes(pixels));
  }
  if (in && std::equal(head, head + 3, found))
  {
    return means;
  }
  settings.independentSamples = true;
  settings.samples = samples;
  means = squares.Trace(settings);
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(head), sizeof head);
  for (const Pixels& pixels : means)
  {
    out.write(reinterpret_cast<const char*>(pixels.data()), bytes(pixels));
  }
  return means;
}

// Processor seconds of a sample by each method. They are taken in turns, and of several turns the method's fractions of
// all count, times the median of the whole: the machine's speed changes.
std::vector<benchmark::Measured>
SecondsOf(Squares& squares, const std::vector<Method>& methods, rtg::TraceSettings settings)
{
  constexpr int turns = 3;
  std::vector<std::vector<double>> shares(methods.size());
  std::vector<double> totals;
  settings.samples = settings.plannedSamples = 16;
  for (int turn = 0; turn <= turns; ++turn)
  {
    std::vector<double> seconds(methods.size());
    for (std::size_t k = 0; k < methods.size(); ++k)
    {
      // Nor does one always follow the same other.
      const std::size_t i = turn % 2 == 0 ? k : methods.size() - 1 - k;
      methods[i].Apply(settings);
      const double start = benchmark::CpuSeconds();
      squares.Trace(settings);
      seconds[i] = (benchmark::CpuSeconds() - start) / settings.samples;
    }
    if (turn == 0)
    {
      continue; // it compiled
    }
    totals.push_back(std::accumulate(seconds.begin(), seconds.end(), 0.0));
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      shares[i].push_back(seconds[i] / totals.back());
    }
  }
  std::vector<benchmark::Measured> result;
  for (const std::vector<double>& share : shares)
  {
    result.emplace_back(share) *= benchmark::Quantile(totals, 0.5);
  }
  return result;
}

void MeasureShading(LightScene& subject, const char* name, const std::string& output, std::ofstream& csv, int pixels,
  std::uint32_t referenceSamples, std::uint32_t mostSamples, Shading shading)
{
  Squares squares{ rtg::Tracer(subject.device), subject, SquaresOf(subject, pixels), LightsOf(shading), {} };
  rtg::TraceSettings settings = SettingsOf(subject, pixels, shading);
  const std::vector<Pixels> truth = Reference(squares, settings, referenceSamples, output + "." + name + ".reference");
  const std::vector<Method> methods = Methods(shading);
  const std::vector<benchmark::Measured> seconds = SecondsOf(squares, methods, settings);

  settings.features = true;
  double ownError = 0.0; // of the reference: the variance of a sample over its number of samples
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const Method& method = methods[i];
    method.Apply(settings);
    for (settings.samples = 1; settings.samples <= mostSamples; settings.samples *= 4)
    {
      settings.plannedSamples = settings.samples;
      const std::vector<Pixels> means = squares.Trace(settings);
      double error = SquaredError(means, truth);
      // Random samples are the first of the reference's: they differ from it by less than from the truth, others by
      // more.
      const double share = static_cast<double>(settings.samples) / referenceSamples;
      if (method.independentSamples)
      {
        if (settings.samples == std::min(16u, mostSamples))
        {
          ownError = error * share / (1.0 - share);
        }
        error /= 1.0 - share;
      }
      else
      {
        error = std::max(error - ownError, 0.0);
      }
      benchmark::Measured all = seconds[i];
      all *= settings.samples;
      csv << name << ',' << method.Name() << ',' << settings.samples << ',' << all << ',' << error << ',' << ownError
          << ',' << std::max(SquaredError(squares.denoised, truth) - ownError, 0.0) << ',' << squares.denoising
          << std::endl;
    }
  }
}

void MeasureError(
  LightScene& subject, const std::string& output, int pixels, std::uint32_t referenceSamples, std::uint32_t mostSamples)
{
  std::ofstream csv = benchmark::Written(output);
  csv << "shading,sampler,samples,cpu_seconds,mse,reference_mse,denoised_mse,denoise_seconds\n";
  for (const auto& [name, shading] : shadings)
  {
    MeasureShading(subject, name, output, csv, pixels, referenceSamples,
      shading == Shading::AmbientOcclusion ? std::min(256u, mostSamples) : mostSamples, shading);
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  const std::string what = argc > 3 ? argv[1] : "";
  const auto number = [&](int at, int otherwise) { return argc > at ? std::atoi(argv[at]) : otherwise; };
  if (what == "cost")
  {
    std::ofstream csv = benchmark::Written(argv[2]);
    csv << "scene,light,cpu_seconds,over_local" << std::endl;
    for (int i = 3; i < argc; ++i)
    {
      const std::string named = argv[i];
      const std::size_t sign = named.find('=');
      if (sign == std::string::npos)
      {
        throw std::runtime_error("'" + named + "' is not NAME=SCENE");
      }
      LightScene subject;
      benchmark::Load(subject, named.substr(sign + 1));
      MeasureCost(subject, named.substr(0, sign), csv);
    }
    return 0;
  }
  if (what != "error")
  {
    std::fprintf(stderr,
      "Usage: LightBenchmark cost OUTPUT.csv NAME=SCENE.vtk...\n"
      "       LightBenchmark error SCENE.vtk OUTPUT.csv [PIXELS] [REFERENCE-SAMPLES] "
      "[MOST-SAMPLES]\n");
    return 2;
  }
  LightScene subject;
  benchmark::Load(subject, argv[2]);
  MeasureError(subject, argv[3], number(4, 24), static_cast<std::uint32_t>(number(5, 16384)),
    static_cast<std::uint32_t>(number(6, 1024)));
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "LightBenchmark: %s\n", error.what());
  return 1;
}
