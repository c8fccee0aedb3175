// What run.sh of the self-check runs besides the tests: which device traces, how fast, and what it looks like.
// Usage: SelfCheck device
//        SelfCheck benchmark short|full CSV
//        SelfCheck demonstration FOLDER [WIDTH SAMPLES SHAPES]
//
// The benchmark is after Table 1 of Zellmann, Aumueller, Marshak and Wald, "High-Quality Rendering of Glyphs Using
// Hardware-Accelerated Ray Tracing", EGPGV 2020: numbers of glyphs, shapes and kinds of light; of each the frames a
// second (one sample, path, or direction a pixel; of the median frame), the seconds from new instances to a structure
// that can be traced, and the bytes that the device holds for a glyph. Whatever fails, or covers few pixels, makes the
// exit status 1.
#include "../Benchmarks/Crowds.h"
#include "../Benchmarks/Measures.h"
#include "Parallel.h"
#include "Scene.h"
#include "Stopwatch.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

namespace
{

const benchmark::Crowd crowds[] = {
  { "spheres", rtg::Shape::Sphere, false },
  { "ellipsoids", rtg::Shape::Sphere, true },
  { "arrows", rtg::Shape::Arrow, true },
  { "superquadrics", rtg::Shape::Superquadric, true, 0.5f, 10.0f },
};

struct Mode
{
  const char* name;
  rtg::Shading shading;
};

const Mode modes[] = {
  { "local", rtg::Shading::Local },
  { "occlusion", rtg::Shading::AmbientOcclusion },
  { "paths", rtg::Shading::PathTracing },
};

/// Of the pixels. Crowds cover nearly all, thin arrows half, or a quarter of few pixels.
constexpr double leastCovered = 0.1;

struct Effort
{
  std::vector<std::size_t> counts;
  std::uint32_t pixels;
  double seconds; ///< of frames, at least two
};

/// Fraction of the pixels that show a glyph.
double Covered(const rtg::Image& image)
{
  const std::size_t pixels = std::size_t(image.width) * image.height;
  return double(std::count_if(
           image.glyphIds, image.glyphIds + pixels, [](std::uint32_t glyph) { return glyph != rtg::Image::noGlyph; })) /
    double(pixels);
}

class Benchmark
{
public:
  Benchmark(const Effort& effort, const char* csv)
    : effort_(effort)
    , csv_(csv)
  {
    this->csv_ << "shape,glyphs,light,frames per second,rebuild s,bytes per glyph\n";
  }

  /// The number of failures.
  int Run()
  {
    std::printf(
      "%-14s %10s %-10s %12s %10s %12s\n", "shape", "glyphs", "light", "frames / s", "rebuild s", "bytes/glyph");
    int failures = 0;
    for (const benchmark::Crowd& crowd : crowds)
    {
      for (const std::size_t count : this->effort_.counts)
      {
        try
        {
          failures += this->Measure(crowd, count);
        }
        catch (const rtg::OutOfMemory& error)
        {
          std::printf("%-14s %10zu not measured: %s\n", crowd.name, count, error.what());
        }
      }
    }
    return failures;
  }

private:
  int Measure(const benchmark::Crowd& crowd, std::size_t count)
  {
    const std::uint64_t before = this->device_->HeldBytes();
    rtg::Scene scene(this->device_);
    const rtg::Scene::SetId set = scene.Add();
    double rebuild = 0.0;
    for (int i = 0; i < 2; ++i) // the first one makes what all later ones share
    {
      rtg::GlyphInstances instances = benchmark::MakeInstances(crowd, count);
      rtg::Stopwatch watch;
      scene.SetInstances(set, std::move(instances));
      scene.Commit();
      rebuild = watch.Lap();
    }
    const double bytes = double(this->device_->HeldBytes() - before) / double(count);
    int failures = 0;
    for (const Mode& mode : modes)
    {
      rtg::TraceSettings settings;
      settings.width = settings.height = this->effort_.pixels;
      settings.shading = mode.shading;
      const auto trace = [&]
      { return this->tracer_.Trace(scene, benchmark::CrowdCamera(), { rtg::Light() }, settings, rtg::Pass::All); };
      const double covered = Covered(trace()); // compiles
      std::vector<double> laps;
      rtg::Stopwatch watch;
      for (double seconds = 0.0; laps.size() < 2 || seconds < this->effort_.seconds; seconds += laps.back())
      {
        trace();
        laps.push_back(watch.Lap());
      }
      const double rate = 1.0 / benchmark::Quantile(laps, 0.5);
      const bool good = covered > leastCovered;
      failures += !good;
      std::printf("%-14s %10zu %-10s %12.3f %10.4f %12.1f%s\n", crowd.name, count, mode.name, rate, rebuild, bytes,
        good ? "" : "   FAILED: glyphs are missing");
      std::fflush(stdout);
      this->csv_ << crowd.name << ',' << count << ',' << mode.name << ',' << rate << ',' << rebuild << ',' << bytes
                 << std::endl; // whatever ends the program later
    }
    return failures;
  }

  Effort effort_;
  std::ofstream csv_;
  std::shared_ptr<rtg::Device> device_ = rtg::Device::Shared();
  rtg::Tracer tracer_{ this->device_ };
};

void WritePicture(const rtg::Image& image, const std::string& path)
{
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << image.width << ' ' << image.height << "\n255\n";
  for (std::uint32_t row = image.height; row-- > 0;)
  {
    for (std::uint32_t x = 0; x < image.width; ++x)
    {
      // Over white.
      const std::uint32_t pixel = image.color[std::size_t(row) * image.width + x], alpha = pixel >> 24;
      for (int channel = 0; channel < 3; ++channel)
      {
        out.put(char(((pixel >> (8 * channel) & 255) * alpha + 255 * (255 - alpha)) / 255));
      }
    }
  }
  if (!out.flush())
  {
    throw rtg::Error("cannot write " + path);
  }
}

/// Red, green and blue by the position in the cube.
std::vector<std::uint32_t> ColorsOf(const rtg::GlyphInstances& instances)
{
  std::vector<std::uint32_t> colors;
  for (const glm::vec3& center : instances.centers)
  {
    const glm::vec3 share = 80.0f + 170.0f * (center / benchmark::crowdSide + 0.5f);
    colors.push_back(0xff000000u | std::uint32_t(share.z) << 16 | std::uint32_t(share.y) << 8 | std::uint32_t(share.x));
  }
  return colors;
}

/// The first so many shapes.
int Demonstrate(const std::string& folder, std::uint32_t side, std::uint32_t samples, std::size_t shapes)
{
  const std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Tracer tracer(device);
  int failures = 0;
  for (std::size_t i = 0; i < std::min(shapes, std::size(crowds)); ++i)
  {
    const benchmark::Crowd& crowd = crowds[i];
    rtg::Scene scene(device);
    const rtg::Scene::SetId set = scene.Add();
    rtg::GlyphInstances instances = benchmark::MakeInstances(crowd, 3000);
    const std::vector<std::uint32_t> colors = ColorsOf(instances);
    scene.SetInstances(set, std::move(instances));
    scene.SetColors(set, colors);
    scene.Commit();
    for (const Mode& mode : modes)
    {
      rtg::TraceSettings settings;
      settings.width = settings.height = side;
      settings.samples = samples;
      settings.shading = mode.shading;
      settings.occlusionRays = settings.paths = 4;
      const rtg::Image image =
        tracer.Trace(scene, benchmark::CrowdCamera(), { rtg::Light() }, settings, rtg::Pass::All);
      const std::string path = folder + '/' + crowd.name + '-' + mode.name + ".ppm";
      WritePicture(image, path);
      const double covered = Covered(image);
      const bool good = covered > leastCovered;
      failures += !good;
      std::printf(
        "%s: %.0f %% covered%s\n", path.c_str(), 100.0 * covered, good ? "" : "   FAILED: glyphs are missing");
    }
  }
  return failures;
}

int Run(const std::vector<std::string>& arguments)
{
  const std::string what = arguments.empty() ? "" : arguments[0];
  if (what == "device")
  {
    std::printf("%s\n", rtg::Device::Shared()->Name().c_str());
    return 0;
  }
  if (what == "benchmark" && arguments.size() == 3)
  {
    const Effort quick{ { 12500, 100000 }, 512, 0.5 }, full{ { 12500, 100000, 1000000, 10000000 }, 1024, 1.0 };
    return Benchmark(arguments[1] == "full" ? full : quick, arguments[2].c_str()).Run() == 0 ? 0 : 1;
  }
  if (what == "demonstration" && arguments.size() >= 2)
  {
    const int side = arguments.size() > 2 ? std::atoi(arguments[2].c_str()) : 600;
    const int samples = arguments.size() > 3 ? std::atoi(arguments[3].c_str()) : 16;
    const int shapes = arguments.size() > 4 ? std::atoi(arguments[4].c_str()) : int(std::size(crowds));
    return Demonstrate(arguments[1], std::uint32_t(side), std::uint32_t(samples), std::size_t(shapes)) == 0 ? 0 : 1;
  }
  std::fprintf(stderr,
    "usage: SelfCheck device | SelfCheck benchmark short|full CSV | SelfCheck demonstration FOLDER [WIDTH SAMPLES "
    "SHAPES]\n");
  return 2;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return Run({ argv + 1, argv + argc });
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
