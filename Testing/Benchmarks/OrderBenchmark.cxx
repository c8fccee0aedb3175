// What keeping the order of a time series' glyphs costs and saves, as they drift away from where they were sorted.
// Usage: OrderBenchmark FILE [PIXELS] [REPETITIONS] [CSV]     FILE: written by Data/spheres_280k.py
//
// Every sphere goes its own way, evenly in all directions, by 0 to 4 mean distances of neighbours. Printed: by how much
// the nodes above the leaves grow with the old order, processor seconds of an image with the old order and with a new
// one, and seconds of sorting.
#include "Files.h"
#include "GlyphTree.h"
#include "Measures.h"
#include "Scene.h"
#include "SceneState.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

namespace
{

struct Timing
{
  double image = std::numeric_limits<double>::infinity(); ///< processor seconds, the best
  double sorting = 0.0;
  double surface = 0.0; ///< of the nodes above the leaves
};

class Series
{
public:
  Series(const std::string& path, std::uint32_t pixels)
    : spheres_(benchmark::ReadSpheres(path))
    , set_(this->scene_.Add())
  {
    this->settings_.width = this->settings_.height = pixels;
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (std::size_t i = 0; i < this->spheres_.centres.size(); ++i)
    {
      const float x = normal(random), y = normal(random), z = normal(random);
      this->ways_.push_back(glm::normalize(glm::vec3(x, y, z)));
    }
  }

  /// The spheres after that way. `keeps`: in the order of the instances before, whatever it has become.
  Timing After(float way, bool keeps, int repetitions)
  {
    rtg::GlyphInstances instances;
    instances.uniformSize = 2.0f * this->spheres_.radius;
    for (std::size_t i = 0; i < this->ways_.size(); ++i)
    {
      instances.centres.push_back(this->spheres_.centres[i] + way * this->ways_[i]);
    }
    rtg::Scene::State& state = this->scene_.GetState();
    state.orderDecay = keeps ? std::numeric_limits<double>::infinity() : 0.0;
    const double sorted = this->scene_.GetStatistics().sortSeconds;
    this->scene_.SetInstances(this->set_, instances);
    this->scene_.Commit();
    Timing timing;
    timing.sorting = this->scene_.GetStatistics().sortSeconds - sorted;

    const rtg::GlyphSet& set = state.sets.at(this->set_);
    std::vector<rtg::Box> boxes;
    for (const std::uint32_t i : set.sorted.order)
    {
      boxes.push_back({ instances.centres[i] - this->spheres_.radius, instances.centres[i] + this->spheres_.radius });
    }
    timing.surface = rtg::LeafSurface(boxes, set.sorted.leafBits - 3);
    for (int i = -1; i < repetitions; ++i) // the first one compiles
    {
      const double start = benchmark::CpuSeconds();
      this->tracer_.Trace(
        this->scene_, benchmark::SpheresCamera(), { rtg::Light() }, this->settings_, rtg::Pass::Opaque);
      timing.image = i < 0 ? timing.image : std::min(timing.image, benchmark::CpuSeconds() - start);
    }
    return timing;
  }

  float Spacing() const { return 100.0f / std::cbrt(static_cast<float>(this->ways_.size())); }

private:
  benchmark::Spheres spheres_;
  std::vector<glm::vec3> ways_;
  std::shared_ptr<rtg::Device> device_ = rtg::Device::Shared();
  rtg::Scene scene_{ device_ };
  rtg::Tracer tracer_{ device_ };
  rtg::TraceSettings settings_;
  rtg::Scene::SetId set_;
};

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: OrderBenchmark FILE [PIXELS] [REPETITIONS] [CSV]\n");
    return 2;
  }
  Series series(argv[1], argc > 2 ? std::uint32_t(std::atoi(argv[2])) : 1200);
  const int repetitions = argc > 3 ? std::atoi(argv[3]) : 3;
  std::ofstream csv(argc > 4 ? argv[4] : "/dev/null");
  csv << "way / spacing,growth,image kept s,image sorted s,sort s\n";
  std::printf("%14s %8s %14s %14s %8s\n", "way / spacing", "growth", "kept: CPU s", "sorted: CPU s", "sort s");
  for (const float way : { 0.0f, 0.1f, 0.2f, 0.35f, 0.5f, 1.0f, 2.0f, 4.0f })
  {
    series.After(0.0f, false, 0);
    const Timing kept = series.After(way * series.Spacing(), true, repetitions);
    const Timing sorted = series.After(way * series.Spacing(), false, repetitions);
    const double growth = kept.surface / sorted.surface;
    std::printf("%14.2f %8.3f %14.3f %14.3f %8.3f\n", way, growth, kept.image, sorted.image, sorted.sorting);
    csv << way << ',' << growth << ',' << kept.image << ',' << sorted.image << ',' << sorted.sorting << '\n';
  }
  return 0;
}
