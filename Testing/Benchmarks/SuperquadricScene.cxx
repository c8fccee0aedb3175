// Time of an image of 280,000 glyphs of each shape beside one of as many spheres, through the pipeline.
// Usage: SuperquadricScene [PIXELS] [REPETITIONS] [COUNT] [dilute|packed|both] [CSV]
//
// Images are taken in turns over the shapes, after a first one that compiles; printed are medians, the file has all.
// Layout, camera and coverage are those of Data/spheres_280k.py; exponents lie between 0.3 and 20 at random on a
// logarithmic scale. The superquadrics' sizes are such that their boxes' sides are the spheres' diameters. Those that
// are turned have sides from half of it to all of it. Arrows are as long as that, of vtkArrowSource's proportions.
// Eigenvalues of tensor glyphs are such that the largest magnitude is 1, which makes the diameter: positive ones as
// all-positive tensors have them, signed ones of either sign.
#include "Measures.h"
#include "Camera.h"
#include "Scene.h"
#include "Stopwatch.h"
#include "Tensor.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <utility>
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
  int tensors = -1; ///< an rtg::TensorGlyphKind, or none
};

class Random
{
public:
  float Place() { return std::uniform_real_distribution<float>(-50.0f, 50.0f)(this->engine_); }
  float Unit() { return std::uniform_real_distribution<float>(0.0f, 1.0f)(this->engine_); }
  glm::vec3 Unit3()
  {
    const float x = this->Unit(), y = this->Unit();
    return { x, y, this->Unit() };
  }
  glm::vec4 Quaternion()
  {
    std::normal_distribution<float> normal;
    const float x = normal(this->engine_), y = normal(this->engine_), z = normal(this->engine_);
    return glm::normalize(glm::vec4(x, y, z, normal(this->engine_)));
  }

private:
  std::mt19937 engine_{ 20190923 };
};

// One tensor glyph more, turned at random.
void AddTensor(rtg::GlyphInstances& instances, rtg::TensorGlyphKind kind, Random& random)
{
  glm::dvec3 values(random.Unit3());
  if (kind == rtg::TensorGlyphKind::SignedSuperquadric)
  {
    values = 2.0 * values - 1.0;
  }
  values /= std::max({ std::abs(values.x), std::abs(values.y), std::abs(values.z), 1e-3 });
  std::sort(&values.x, &values.x + 3, [](double a, double b) { return a > b; });
  rtg::Eigensystem eigen;
  eigen.values = values;
  const rtg::TensorGlyph glyph = rtg::MakeTensorGlyph(eigen, kind, 3.0);
  instances.sizes3.push_back(instances.uniformSize * glm::vec3(glyph.halfLengths));
  instances.rotations.push_back(random.Quaternion());
  instances.exponents3.emplace_back(glyph.exponents);
}

rtg::GlyphInstances MakeInstances(const Kind& kind, bool packed, int count)
{
  Random random;
  rtg::GlyphInstances instances;
  instances.shape = kind.shape;
  instances.uniformSize =
    packed ? 0.8f * 100.0f / std::cbrt(float(count)) : 2.0f * 0.17769f * std::sqrt(280000.0f / float(count));
  instances.arrow.unitLength = instances.uniformSize;
  for (int i = 0; i < count; ++i)
  {
    const float x = random.Place(), y = random.Place();
    instances.centers.emplace_back(x, y, random.Place());
    if (kind.tensors >= 0)
    {
      AddTensor(instances, static_cast<rtg::TensorGlyphKind>(kind.tensors), random);
      continue;
    }
    const glm::vec3 share = random.Unit3();
    const float least = kind.leastExponent, ratio = kind.mostExponent / least;
    if (ratio > 1.0f)
    {
      instances.exponents3.push_back(least * glm::pow(glm::vec3(ratio), share));
    }
    if (kind.turned)
    {
      instances.rotations.push_back(random.Quaternion());
      const glm::vec3 sides = 0.5f + 0.5f * random.Unit3();
      instances.sizes3.push_back(instances.uniformSize * (kind.shape == rtg::Shape::Arrow ? glm::vec3(1.0f) : sides));
    }
  }
  return instances;
}

/// One scene on the device, and what its images took.
class Subject
{
public:
  Subject(const std::shared_ptr<rtg::Device>& device, rtg::GlyphInstances instances)
    : scene_(device)
    , tracer_(device)
  {
    this->scene_.SetInstances(this->scene_.Add(), std::move(instances));
    this->scene_.Commit();
  }

  /// The first one compiles.
  void Trace(std::uint32_t pixels)
  {
    rtg::TraceSettings settings;
    settings.width = settings.height = pixels;
    const double startCpu = benchmark::CpuSeconds();
    rtg::Stopwatch watch;
    const rtg::Image image = this->tracer_.Trace(this->scene_, SceneCamera(), { rtg::Light() }, settings);
    const double seconds = watch.Lap();
    if (this->first < 0.0)
    {
      this->first = seconds;
      const std::size_t rays = std::size_t(pixels) * pixels;
      this->hits =
        double(std::count_if(image.depth, image.depth + rays, [](float depth) { return depth < 1.0f; })) / double(rays);
      return;
    }
    this->wall.push_back(seconds);
    this->cpu.push_back(benchmark::CpuSeconds() - startCpu);
  }

  double first = -1.0;           ///< seconds
  double hits = 0.0;             ///< fraction of the rays
  std::vector<double> wall, cpu; ///< seconds of the others

private:
  rtg::Scene scene_;
  rtg::Tracer tracer_;
};

} // namespace

int main(int argc, char** argv)
try
{
  const std::uint32_t pixels = argc > 1 ? std::uint32_t(std::atoi(argv[1])) : 1200;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  const int count = argc > 3 ? std::atoi(argv[3]) : 280000;
  const std::string layout = argc > 4 ? argv[4] : "both";
  const auto tensor = [](rtg::TensorGlyphKind kind) { return static_cast<int>(kind); };
  const Kind kinds[] = {
    { "spheres", rtg::Shape::Sphere, 2, 2, false },
    { "superquadrics, all 2", rtg::Shape::Superquadric, 2, 2, false },
    { "superquadrics, 1 to 20", rtg::Shape::Superquadric, 1, 20, false },
    { "superquadrics, 0.3 to 20", rtg::Shape::Superquadric, 0.3f, 20, false },
    { "ellipsoids, turned", rtg::Shape::Sphere, 2, 2, true },
    { "boxes, turned", rtg::Shape::Box, 2, 2, true },
    { "cylinders, turned", rtg::Shape::Cylinder, 2, 2, true },
    { "cones, turned", rtg::Shape::Cone, 2, 2, true },
    { "arrows, turned", rtg::Shape::Arrow, 2, 2, true },
    { "superquadrics, 0.3 to 20, turned", rtg::Shape::Superquadric, 0.3f, 20, true },
    { "tensor superquadrics", rtg::Shape::NestedSuperquadric, 2, 2, true, tensor(rtg::TensorGlyphKind::Superquadric) },
    { "signed tensor superquadrics", rtg::Shape::NestedSuperquadric, 2, 2, true,
      tensor(rtg::TensorGlyphKind::SignedSuperquadric) },
  };
  std::ofstream csv;
  if (argc > 5)
  {
    csv = benchmark::Written(argv[5]);
    csv << "layout,shape,glyphs,pixels,first s,wall s,CPU s,hit share,CPU over spheres\n";
  }
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  std::printf("device: %s, %d glyphs, %u x %u\n", device->Name().c_str(), count, pixels, pixels);
  std::printf("%-34s %8s %8s %8s %10s %8s %8s\n", "", "first s", "wall s", "CPU s", "Mray/s", "hit %", "ratio");
  for (const bool packed : { false, true })
  {
    const char* name = packed ? "packed" : "dilute";
    if (layout != "both" && layout != name)
    {
      continue;
    }
    // In turns, because the machine's speed changes.
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const Kind& kind : kinds)
    {
      subjects.push_back(std::make_unique<Subject>(device, MakeInstances(kind, packed, count)));
    }
    for (int turn = 0; turn <= repetitions; ++turn)
    {
      for (const auto& subject : subjects)
      {
        subject->Trace(pixels);
      }
    }
    for (std::size_t i = 0; i < subjects.size(); ++i)
    {
      const Subject& subject = *subjects[i];
      const benchmark::Measured wall(subject.wall), cpu(subject.cpu);
      const benchmark::Measured overSpheres(benchmark::Ratios(subject.cpu, subjects.front()->cpu));
      const double rate = 1e-6 * double(pixels) * pixels / wall.Median();
      std::printf("%-34s %8.2f %8.3f %8.3f %10.2f %8.1f %8.2f  %s\n", kinds[i].name, subject.first, wall.Median(),
        cpu.Median(), rate, 100.0 * subject.hits, overSpheres.Median(), name);
      csv << name << ",\"" << kinds[i].name << "\"," << count << ',' << pixels << ',' << subject.first << ',' << wall
          << ',' << cpu << ',' << subject.hits << ',' << overSpheres << std::endl;
    }
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "SuperquadricScene: %s\n", error.what());
  return 1;
}
