// What an image of each kind of scene costs: one set of glyphs, several, surfaces beside them, translucent and cut
// ones. Usage: SceneBenchmark [PIXELS] [REPETITIONS] [CSV] [NAME...]
//
// NAME...: only the scenes whose names begin so.
//
// Glyphs lie at random in a cube that fills the image (Crowds.h). Printed: processor seconds of an image with local
// shading, depth and ids, the median of the repetitions, which are taken in turns over the scenes, the cost beside that
// of the first scene, and of a cut one beside the uncut one. The file has all turns. Where the program is built with
// Embree, also the processor seconds of its rays alone, one by one and in packets of eight, for the scenes that are
// opaque and whole, in the same turns; the program fails where their picture is another one. To compare two trees, run
// the program of each in turns.
#include "Crowds.h"
#ifdef RTGLYPHS_EMBREE
#include "EmbreeScene.h"
#endif
#include "Measures.h"
#include "Scene.h"
#include "SweptEllipsoid.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using benchmark::Crowd;

constexpr std::size_t glyphs = 280000, balls = 100000, copies = 20000, curves = 400, pieces = 500, movers = 20000;

rtg::GlyphInstances Surface(rtg::TriangleMesh mesh)
{
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = std::make_shared<rtg::TriangleMesh>(std::move(mesh));
  instances.identifyTriangles = true;
  instances.centers.emplace_back(0.0f);
  return instances;
}

/// A closed ball of 80,000 triangles.
rtg::GlyphInstances Globe()
{
  constexpr std::uint32_t around = 200, along = 201;
  rtg::TriangleMesh mesh;
  for (std::uint32_t j = 0; j < along; ++j)
  {
    for (std::uint32_t i = 0; i < around; ++i)
    {
      const float a = 6.2831853f * float(i) / around, b = 3.1415927f * float(j) / (along - 1);
      mesh.positions.push_back(
        0.45f * benchmark::crowdSide * glm::vec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)));
      if (j + 1 < along)
      {
        const std::uint32_t first = j * around, next = (i + 1) % around;
        mesh.triangles.emplace_back(first + i, first + next, first + around + i);
        mesh.triangles.emplace_back(first + next, first + around + next, first + around + i);
      }
    }
  }
  return Surface(std::move(mesh));
}

/// Adds a line of round cones of those diameters. `joined`: they know their neighbors.
void AddLine(rtg::GlyphInstances& instances, const std::vector<glm::vec3>& places,
  const std::function<float(int)>& diameter, bool joined)
{
  instances.shape = rtg::Shape::RoundCone;
  const int last = int(places.size()) - 1;
  for (int k = 0; k < last; ++k)
  {
    const glm::vec3 way = places[k + 1] - places[k], middle = 0.5f * (places[k] + places[k + 1]);
    const glm::vec3 axis = glm::normalize(way);
    const glm::quat turn = glm::normalize(glm::quat(1.0f + axis.x, 0.0f, -axis.z, axis.y));
    instances.centers.push_back(middle);
    instances.sizes3.emplace_back(glm::length(way), diameter(k), diameter(k + 1));
    instances.rotations.emplace_back(turn.x, turn.y, turn.z, turn.w);
    const auto end = [&](int beyond)
    {
      return beyond < 0 || beyond > last
        ? glm::vec4(0.0f)
        : glm::vec4(glm::conjugate(turn) * (places[beyond] - middle), 0.5f * diameter(beyond));
    };
    if (joined)
    {
      instances.before.push_back(end(k - 1));
      instances.after.push_back(end(k + 2));
    }
  }
}

/// Adds the same line as tubes of covariances, not quite round.
void AddSweeps(rtg::GlyphInstances& instances, const std::vector<glm::vec3>& places, double radius)
{
  instances.shape = rtg::Shape::SweptEllipsoid;
  const auto end = [&](std::size_t k)
  {
    const double square = radius * radius;
    return rtg::SweepEnd{ glm::dvec3(places[k]), { square, (0.8 + 0.2 * double(k % 2)) * square, 0.6 * square } };
  };
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
  {
    const std::size_t index = instances.Count();
    instances.centers.emplace_back();
    instances.sizes3.emplace_back();
    instances.rotations.emplace_back();
    instances.before.emplace_back();
    instances.after.emplace_back();
    instances.exponents3.emplace_back();
    rtg::StoreSweep(end(k), end(k + 1), index, instances);
  }
}

/// Curves at random places, each a helix, of round cones or swept ellipsoids.
rtg::GlyphInstances Tubes(bool swept)
{
  const rtg::GlyphInstances starts = benchmark::MakeInstances({ "", rtg::Shape::Sphere, true }, curves);
  rtg::GlyphInstances instances;
  for (const glm::vec3& start : starts.centers)
  {
    std::vector<glm::vec3> places;
    for (int k = 0; k <= int(pieces); ++k)
    {
      const float angle = 0.05f * k;
      places.push_back(start + 5.0f * glm::vec3(std::cos(angle), std::sin(angle), 0.2f * angle));
    }
    if (swept)
    {
      AddSweeps(instances, places, 0.3);
    }
    else
    {
      AddLine(
        instances, places, [](int) { return 0.6f; }, true);
    }
  }
  return instances;
}

/// A smooth sheet through the cube, of 80,000 triangles.
rtg::GlyphInstances Sheet()
{
  constexpr std::uint32_t side = 201;
  rtg::TriangleMesh mesh;
  for (std::uint32_t j = 0; j < side; ++j)
  {
    for (std::uint32_t i = 0; i < side; ++i)
    {
      const glm::vec2 at = benchmark::crowdSide * (glm::vec2(i, j) / float(side - 1) - 0.5f);
      const glm::vec2 phase = 0.15f * at;
      const glm::vec2 slope(1.5f * std::cos(phase.x), -1.5f * std::sin(phase.y));
      mesh.positions.emplace_back(at, 10.0f * (std::sin(phase.x) + std::cos(phase.y)));
      mesh.normals.push_back(glm::normalize(glm::vec3(-slope, 1.0f)));
      if (i + 1 < side && j + 1 < side)
      {
        const std::uint32_t a = j * side + i;
        mesh.triangles.emplace_back(a, a + 1, a + side);
        mesh.triangles.emplace_back(a + 1, a + side + 1, a + side);
      }
    }
  }
  return Surface(std::move(mesh));
}

/// Copies of an octahedron.
rtg::GlyphInstances MeshGlyphs()
{
  auto mesh = std::make_shared<rtg::TriangleMesh>();
  mesh->positions = { { 0.5, 0, 0 }, { -0.5, 0, 0 }, { 0, 0.5, 0 }, { 0, -0.5, 0 }, { 0, 0, 0.5 }, { 0, 0, -0.5 } };
  mesh->triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
    { 0, 3, 5 } };
  rtg::GlyphInstances instances = benchmark::MakeInstances({ "", rtg::Shape::Sphere, true }, copies);
  instances.shape = rtg::Shape::Mesh;
  instances.mesh = std::move(mesh);
  return instances;
}

rtg::GlyphInstances Spheres(std::size_t count, float size)
{
  rtg::GlyphInstances instances = benchmark::MakeInstances({ "", rtg::Shape::Sphere, false }, count);
  instances.uniformSize *= size;
  return instances;
}

/// The paths of balls through their last steps, each a quarter of their diameter: tubes of half of it that taper.
rtg::GlyphInstances Trails(const rtg::GlyphInstances& balls, bool fading)
{
  constexpr int steps = 50;
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  const auto vector = [&]
  {
    const float x = normal(random), y = normal(random);
    return glm::vec3(x, y, normal(random));
  };
  rtg::GlyphInstances trails;
  for (const glm::vec3& ball : balls.centers)
  {
    std::vector<glm::vec3> places{ ball };
    glm::vec3 direction = glm::normalize(vector());
    for (int step = 0; step < steps; ++step)
    {
      direction = glm::normalize(direction + 0.1f * vector());
      places.push_back(places.back() + 0.25f * balls.uniformSize * direction);
    }
    AddLine(
      trails, places, [&](int step) { return 0.5f * balls.uniformSize * float(steps - step) / steps; }, fading);
    for (int step = 0; fading && step < steps; ++step)
    {
      trails.opacities.push_back(float(steps - step) / (steps + 1));
    }
  }
  return trails;
}

/// The same with one more a million sizes away, which no picture shows.
rtg::GlyphInstances WithOutlier(rtg::GlyphInstances instances)
{
  instances.centers.emplace_back(1e6f * instances.uniformSize, 0.0f, 0.0f);
  return instances;
}

struct Part
{
  rtg::GlyphInstances instances;
  float opacity = 1.0f;
  rtg::Section section = {};
};

/// Away with the half of the cube before a plane that is askew to the view, or with an octant's box.
rtg::Section Cut(bool box)
{
  rtg::Section section;
  section.planes = { { glm::dvec3(0.0), { -0.3, -0.2, -1.0 } } };
  if (box)
  {
    section.planes = { { glm::dvec3(0.0), { -1, 0, 0 } }, { glm::dvec3(0.0), { 0, -1, 0 } },
      { glm::dvec3(0.0), { 0, 0, -1 } }, { glm::dvec3(benchmark::crowdSide), { 1, 0, 0 } },
      { glm::dvec3(benchmark::crowdSide), { 0, 1, 0 } }, { glm::dvec3(benchmark::crowdSide), { 0, 0, 1 } } };
  }
  return section;
}

/// One scene on the device, and the processor seconds of its images.
class Subject
{
public:
  /// `uncut`: the same without its cut, or null.
  Subject(std::string name, std::vector<Part> parts, const Subject* uncut)
    : name_(std::move(name))
    , uncut_(uncut)
  {
    for (Part& part : parts)
    {
      const rtg::Scene::SetId set = this->scene_.Add();
      rtg::Material material;
      material.opacity = part.opacity;
      material.section = part.section;
      const bool translucent = part.opacity < 1.0f || rtg::IsTranslucent(part.instances);
      this->translucent_ |= translucent;
      this->opaque_ |= !translucent;
#ifdef RTGLYPHS_EMBREE
      this->embree_.Add(part.instances);
#endif
      this->scene_.SetInstances(set, std::move(part.instances));
      this->scene_.SetMaterial(set, material);
    }
    this->scene_.Commit();
#ifdef RTGLYPHS_EMBREE
    this->embree_.Commit();
#endif
  }

  void Trace(std::uint32_t pixels, bool counts)
  {
    const rtg::Camera camera = benchmark::CrowdCamera();
    std::vector<float> depth;
    const auto trace = [&](rtg::Tracer& tracer, std::uint32_t side)
    {
      rtg::TraceSettings settings;
      settings.width = settings.height = side;
      if (this->opaque_)
      {
        const rtg::Image image = tracer.Trace(this->scene_, camera, { rtg::Light() }, settings, rtg::Pass::Opaque);
        depth.assign(image.depth, image.depth + std::size_t(side) * side);
      }
      if (this->translucent_)
      {
        tracer.Trace(this->scene_, camera, { rtg::Light() }, settings, rtg::Pass::Translucent);
      }
    };
    // The device keeps fewer programs than there are scenes, so this scene's may have to be compiled again.
    trace(this->compiler_, 8);
    double start = benchmark::CpuSeconds();
    trace(this->tracer_, pixels);
    if (counts)
    {
      this->seconds_.push_back(benchmark::CpuSeconds() - start);
    }
#ifdef RTGLYPHS_EMBREE
    if (this->translucent_ || this->uncut_)
    {
      return;
    }
    for (const bool packets : { false, true })
    {
      std::vector<float> theirs;
      start = benchmark::CpuSeconds();
      this->embree_.Trace(camera, static_cast<int>(pixels), packets, theirs);
      if (counts)
      {
        (packets ? this->packets_ : this->singles_).push_back(benchmark::CpuSeconds() - start);
      }
      this->differs_ = std::max(this->differs_, ShareThatDiffers(camera, depth, theirs));
    }
#endif
  }

  const std::string& Name() const
  {
    return this->name_;
  }
  const std::vector<double>& Seconds() const
  {
    return this->seconds_;
  }
  const Subject* Uncut() const
  {
    return this->uncut_;
  }
  // Embree's; none where it draws nothing.
  const std::vector<double>& Singles() const
  {
    return this->singles_;
  }
  const std::vector<double>& Packets() const
  {
    return this->packets_;
  }
  // Fraction of the pixels in which Embree has seen something else.
  double Differs() const
  {
    return this->differs_;
  }

private:
  // Of window depths and view depths. A window depth as a float resolves view depths here to 1e-4.
  static double
  ShareThatDiffers(const rtg::Camera& camera, const std::vector<float>& window, const std::vector<float>& view)
  {
    std::size_t different = 0;
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      const bool hit = window[i] < 1.0f;
      const double depth = camera.depthB / (window[i] - camera.depthA);
      different += hit != std::isfinite(view[i]) || (hit && std::abs(depth - view[i]) > 5e-3);
    }
    return static_cast<double>(different) / static_cast<double>(view.size());
  }

#ifdef RTGLYPHS_EMBREE
  benchmark::EmbreeScene embree_;
#endif
  std::string name_;
  const Subject* uncut_;
  std::shared_ptr<rtg::Device> device_ = rtg::Device::Shared();
  rtg::Scene scene_{ device_ };
  rtg::Tracer tracer_{ device_ }, compiler_{ device_ };
  std::vector<double> seconds_, singles_, packets_;
  double differs_ = 0.0;
  bool translucent_ = false, opaque_ = false;
};

} // namespace

int main(int argc, char** argv)
try
{
  const auto pixels = static_cast<std::uint32_t>(argc > 1 ? std::atoi(argv[1]) : 800);
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 7;
  std::ofstream csv = benchmark::Written(argc > 3 ? argv[3] : "/dev/null");
  const Crowd arrows{ "", rtg::Shape::Arrow, true }, random{ "", rtg::Shape::Superquadric, true, 0.5f, 8.0f };
  const auto crowd = [](const Crowd& of) { return Part{ benchmark::MakeInstances(of, glyphs) }; };
  const Part packed{ Spheres(glyphs, 1.2f) };

  const std::vector<std::string> names(argv + std::min(argc, 4), argv + argc);
  std::vector<std::unique_ptr<Subject>> subjects;
  const auto add = [&](const std::string& name, std::vector<Part> parts, const Subject* uncut = nullptr)
  {
    if (names.empty() || std::ranges::any_of(names, [&](const std::string& begin) { return name.starts_with(begin); }))
    {
      subjects.push_back(std::make_unique<Subject>(name, std::move(parts), uncut));
      return subjects.back().get();
    }
    return static_cast<Subject*>(nullptr);
  };
  // Also cut
  const auto addCuts = [&](const std::string& name, const rtg::GlyphInstances& instances)
  {
    const Subject* uncut = add(name, { { instances } });
    add(name + ", plane", { { instances, 1.0f, Cut(false) } }, uncut);
    add(name + ", box", { { instances, 1.0f, Cut(true) } }, uncut);
  };
  addCuts("spheres, packed", packed.instances);
  add("spheres, packed, one far away", { { WithOutlier(packed.instances) } });
  add("spheres, dilute", { { Spheres(glyphs, 0.3f) } });
  add("spheres, surface", { packed, { Sheet() } });
  add("spheres, arrows, surface", { packed, crowd(arrows), { Sheet() } });
  add("spheres, spheres", { { Spheres(glyphs / 2, 1.0f) }, { Spheres(glyphs, 0.5f) } });
  add("surface", { { Sheet() } });
  addCuts("closed surface", Globe());
  addCuts("mesh glyphs", MeshGlyphs());
  addCuts("ellipsoids", crowd({ "", rtg::Shape::Sphere, true }).instances);
  addCuts("arrows", crowd(arrows).instances);
  addCuts("superquadrics", crowd(random).instances);
  addCuts("tubes", Tubes(false));
  addCuts("tubes of covariances", Tubes(true));
  add("balls", { { Spheres(balls, 1.0f) } });
  add("balls, opacity 0.3", { { Spheres(balls, 1.0f), 0.3f } });
  add("balls, opacity 0.3, surface", { { Spheres(balls, 1.0f), 0.3f }, { Sheet() } });
  const rtg::GlyphInstances moving = Spheres(movers, 1.0f);
  add("moving balls", { { moving } });
  add("moving balls, trails", { { moving }, { Trails(moving, false) } });
  add("moving balls, fading trails", { { moving }, { Trails(moving, true) } });
  for (int i = -1; i < repetitions; ++i) // the first one compiles
  {
    for (const auto& subject : subjects)
    {
      subject->Trace(pixels, i >= 0);
    }
  }
  csv << "scene,CPU s,cost beside the first,cost beside the uncut,Embree s,Embree packets s,pixels differ\n";
  std::printf("%-30s %8s %8s %8s %8s %8s %8s\n", "scene", "CPU s", "cost", "cut", "Embree", "packets", "differ");
  bool same = true;
  for (const auto& subject : subjects)
  {
    const benchmark::Measured seconds(subject->Seconds()), singles(subject->Singles()), packets(subject->Packets());
    const benchmark::Measured cost(benchmark::Ratios(subject->Seconds(), subjects.front()->Seconds()));
    const benchmark::Measured cut(
      subject->Uncut() ? benchmark::Ratios(subject->Seconds(), subject->Uncut()->Seconds()) : std::vector<double>());
    std::printf("%-30s %8.3f %8.2f %8.2f %8.3f %8.3f %8.1e\n", subject->Name().c_str(), seconds.Median(), cost.Median(),
      cut.Median(), singles.Median(), packets.Median(), subject->Differs());
    csv << '"' << subject->Name() << "\"," << seconds << ',' << cost << ',' << cut << ',' << singles << ',' << packets
        << ',';
    if (!subject->Singles().empty())
    {
      csv << subject->Differs();
    }
    csv << '\n';
    same &= subject->Differs() < 1e-3;
  }
  return same ? 0 : 1;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "SceneBenchmark: %s\n", error.what());
  return 1;
}
