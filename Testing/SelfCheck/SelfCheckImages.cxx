// Images that are the same to the bit on every machine: each shape in each shading mode, still and moving.
// Usage: SelfCheckImages FOLDER [SHAPE...]      (all shapes, or those)
//
// Each file has the pixels of one image: the sums' means in float before any tone mapping, display colors, depths, ids,
// normals, albedos and view depths, in the machine's byte order. run.sh prints their SHA-256.
#include "FormExtents.h"
#include "HarmonicForms.h"
#include "Scene.h"
#include "SweptEllipsoid.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include "../Benchmarks/Crowds.h"
#include "../Kernels/BoxMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr std::size_t glyphCount = 300;
constexpr std::uint32_t side = 96, sampleCount = 4;

/// The standard library's distributions differ between its implementations; this one has exact arithmetic and a square
/// root only.
class Random
{
public:
  float Uniform(float lower, float upper) { return lower + (upper - lower) * (float(this->bits_() >> 8) * 0x1p-24f); }

  glm::vec3 Vector(float lower, float upper)
  {
    const float x = this->Uniform(lower, upper), y = this->Uniform(lower, upper);
    return { x, y, this->Uniform(lower, upper) };
  }

  glm::vec4 Rotation()
  {
    const glm::vec3 axis = this->Vector(-1.0f, 1.0f);
    const glm::vec4 rotation(axis, this->Uniform(0.1f, 1.0f));
    return rotation / std::sqrt(glm::dot(rotation, rotation));
  }

private:
  std::mt19937 bits_{ 20260320 };
};

struct Subject
{
  const char* name;
  rtg::Shape shape;
  bool translucent = false;
};

constexpr Subject subjects[] = {
#define RTG_SUBJECT(number, Name) { #Name, rtg::Shape::Name },
  RTG_SHAPES(RTG_SUBJECT)
#undef RTG_SUBJECT
    { "Mesh", rtg::Shape::Mesh },
  { "TranslucentSphere", rtg::Shape::Sphere, true },
};

rtg::GlyphInstances MakeInstances(const Subject& subject, bool moves)
{
  Random random;
  rtg::GlyphInstances instances;
  instances.shape = subject.shape;
  instances.arrow.unitLength = 14.0f;
  if (subject.shape == rtg::Shape::Mesh)
  {
    instances.mesh = rtg::testing::Share(rtg::testing::BoxMesh());
  }
  constexpr int degree = 4;
  const rtg::FormMeter meter(degree);
  std::vector<double> coefficients(rtg::FormTerms(degree));
  std::vector<float> values(3 + coefficients.size());
  for (std::size_t i = 0; i < glyphCount; ++i)
  {
    instances.centers.push_back(random.Vector(-0.5f, 0.5f) * benchmark::crowdSide);
    instances.sizes3.push_back(random.Vector(8.0f, 18.0f));
    instances.rotations.push_back(random.Rotation());
    if (rtg::HasExponents(subject.shape))
    {
      instances.exponents3.push_back(random.Vector(0.6f, 6.0f));
    }
    if (subject.shape == rtg::Shape::Polynomial)
    {
      for (double& coefficient : coefficients)
      {
        coefficient = random.Uniform(-1.0f, 1.0f);
      }
      meter.Store(coefficients.data(), meter.Measure(coefficients.data()), values.data());
      instances.polynomialDegree = degree;
      instances.polynomials.width = values.size();
      instances.polynomials.values.insert(instances.polynomials.values.end(), values.begin(), values.end());
    }
    if (subject.shape == rtg::Shape::SweptEllipsoid)
    {
      instances.before.emplace_back();
      instances.after.emplace_back();
      const auto end = [&](float side)
      {
        const glm::dvec3 squares(random.Vector(4.0f, 36.0f));
        return rtg::SweepEnd{ glm::dvec3(instances.centers[i] + side * random.Vector(1.0f, 9.0f)),
          { squares.x, squares.y, squares.z, random.Uniform(-1.5f, 1.5f), 0.0, 1.0 } };
      };
      const rtg::SweepEnd first = end(-1.0f);
      rtg::StoreSweep(first, end(1.0f), i, instances);
    }
    if (subject.translucent)
    {
      instances.opacities.push_back(random.Uniform(0.2f, 0.9f));
    }
    if (moves)
    {
      instances.motion.velocities.push_back(random.Vector(-8.0f, 8.0f));
      instances.motion.accelerations.push_back(random.Vector(-8.0f, 8.0f));
      instances.motion.angularVelocities.push_back(random.Vector(-1.0f, 1.0f));
    }
  }
  return instances;
}

template <class T>
void Write(std::ostream& out, const T* values, std::size_t count)
{
  out.write(reinterpret_cast<const char*>(values), std::streamsize(count * sizeof(T)));
}

void WriteImage(const rtg::Image& image, const rtg::Tracer& tracer, const std::string& path)
{
  std::ofstream out(path, std::ios::binary);
  const std::size_t pixels = std::size_t(image.width) * image.height;
  const std::vector<glm::vec4> means = tracer.Means();
  const rtg::ImageFeatures features = tracer.Features();
  Write(out, means.data(), means.size());
  Write(out, image.color, pixels);
  Write(out, image.depth, pixels);
  Write(out, image.glyphIds, pixels);
  Write(out, features.normals.data(), features.normals.size());
  Write(out, features.albedos.data(), features.albedos.size());
  Write(out, features.viewDepths.data(), features.viewDepths.size());
  if (!out.flush())
  {
    throw rtg::Error("cannot write " + path);
  }
}

void WriteImages(const std::string& folder, const std::vector<std::string>& shapes)
{
  const std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Tracer tracer(device);
  rtg::Light lamp;
  lamp.kind = rtg::Light::Kind::Positional;
  lamp.position = { 90.0, 120.0, 150.0 };
  for (const Subject& subject : subjects)
  {
    if (!shapes.empty() && std::ranges::find(shapes, subject.name) == shapes.end())
    {
      continue;
    }
    for (const bool moves : { false, true })
    {
      rtg::Scene scene(device);
      const rtg::Scene::SetId set = scene.Add();
      rtg::GlyphInstances instances = MakeInstances(subject, moves);
      std::vector<std::uint32_t> colors;
      for (std::size_t i = 0; i < instances.Count(); ++i)
      {
        colors.push_back(0xff000000u | std::uint32_t(i * 2654435761u) >> 8);
      }
      scene.SetInstances(set, std::move(instances));
      scene.SetColors(set, colors);
      scene.Commit();
      const std::pair<const char*, rtg::Shading> modes[] = { { "local", rtg::Shading::Local },
        { "occlusion", rtg::Shading::AmbientOcclusion }, { "paths", rtg::Shading::PathTracing } };
      for (const auto& [mode, shading] : modes)
      {
        rtg::TraceSettings settings;
        settings.width = settings.height = side;
        settings.samples = sampleCount;
        settings.shading = shading;
        settings.occlusionRays = settings.paths = 2;
        settings.features = settings.keepSums = true;
        const rtg::Image image =
          tracer.Trace(scene, benchmark::CrowdCamera(), { rtg::Light(), lamp }, settings, rtg::Pass::All);
        WriteImage(image, tracer, folder + '/' + subject.name + (moves ? "-moving-" : "-still-") + mode + ".raw");
      }
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: SelfCheckImages FOLDER [SHAPE...]\n");
    return 2;
  }
  try
  {
    WriteImages(argv[1], { argv + 2, argv + argc });
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
