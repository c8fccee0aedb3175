// Wall-clock seconds of what the host does with new glyphs: their boxes, their order, their tree; and, of spheres, from
// data in memory to the first picture, with the memory that takes.
// Usage: BuildBenchmark shapes [COUNT] [REPETITIONS] [CSV]
//        BuildBenchmark picture [COUNT] [PIXELS] [CSV]
//
// Glyphs lie in a cube at random, turned at random where it says so. Shapes are measured in turns, and of each stage
// the median is printed, on one thread and on all cores, beside the processor seconds of all together, which other work
// on the machine disturbs less. The picture is measured once, in a process that has done nothing else, so programs are
// compiled in it.
#include "Crowds.h"
#include "GlyphBoxes.h"
#include "GlyphTree.h"
#include "Measures.h"
#include "Parallel.h"
#include "Scene.h"
#include "Stopwatch.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/resource.h>

namespace
{

const benchmark::Crowd crowds[] = {
  { "spheres", rtg::Shape::Sphere, false },
  { "ellipsoids, turned", rtg::Shape::Sphere, true },
  { "boxes, turned", rtg::Shape::Box, true },
  { "cylinders, turned", rtg::Shape::Cylinder, true },
  { "arrows, turned", rtg::Shape::Arrow, true },
  { "superquadrics, 1 to 20, turned", rtg::Shape::Superquadric, true, 1.0f, 20.0f },
  { "superquadrics, 0.3 to 20, turned", rtg::Shape::Superquadric, true, 0.3f, 20.0f },
  { "nested superquadrics, turned", rtg::Shape::NestedSuperquadric, true, 0.1f, 1.0f },
};

struct Seconds
{
  std::vector<double> boxes, order, tree, processor;
};

void Build(const rtg::GlyphInstances& instances, Seconds& seconds)
{
  const double before = benchmark::CpuSeconds();
  rtg::Stopwatch watch;
  std::vector<rtg::Box> boxes = rtg::GlyphBoxes(instances);
  seconds.boxes.push_back(watch.Lap());
  const std::uint32_t leafBits = rtg::GlyphTree::LeafBits(instances.Count(), 2);
  const rtg::KdOrder kd = rtg::MakeKdOrder(boxes, leafBits);
  seconds.order.push_back(watch.Lap());
  const rtg::GlyphTree tree = rtg::BuildGlyphTree({ boxes, kd.order }, leafBits, kd.axes);
  seconds.tree.push_back(watch.Lap());
  seconds.processor.push_back(benchmark::CpuSeconds() - before);
}

int MeasureShapes(std::size_t count, int repetitions, const char* path)
{
  std::ofstream csv(path);
  csv << "shape,glyphs,threads";
  for (const char* column : { "boxes s", "order s", "tree s", "processor s" })
  {
    csv << ',' << benchmark::Spread::Columns(column);
  }
  csv << '\n';
  std::printf(
    "%-34s %9s %8s %8s %8s %8s %8s %8s\n", "shape", "glyphs", "threads", "boxes", "order", "tree", "sum", "CPU");
  const std::size_t cores = rtg::ThreadCount();
  for (const benchmark::Crowd& crowd : crowds)
  {
    const rtg::GlyphInstances instances = benchmark::MakeInstances(crowd, count);
    Seconds one, all;
    for (int i = 0; i < repetitions; ++i)
    {
      rtg::SetThreadCount(1);
      Build(instances, one);
      rtg::SetThreadCount(cores);
      Build(instances, all);
    }
    for (const Seconds* seconds : { &one, &all })
    {
      const std::size_t threads = seconds == &one ? 1 : cores;
      const benchmark::Spread boxes(seconds->boxes), order(seconds->order), tree(seconds->tree),
        processor(seconds->processor);
      std::printf("%-34s %9zu %8zu %8.4f %8.4f %8.4f %8.4f %8.4f\n", crowd.name, count, threads, boxes.median,
        order.median, tree.median, boxes.median + order.median + tree.median, processor.median);
      csv << '"' << crowd.name << "\"," << count << ',' << threads << ',' << boxes << ',' << order << ',' << tree << ','
          << processor << '\n';
    }
  }
  return 0;
}

double PeakMegabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

int MeasurePicture(std::size_t count, std::uint32_t pixels, const char* path)
{
  rtg::GlyphInstances instances = benchmark::MakeInstances(crowds[0], count);
  const double before = PeakMegabytes();
  rtg::Stopwatch watch, total;
  const std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene(device);
  rtg::Tracer tracer(device);
  const rtg::Scene::SetId set = scene.Add();
  scene.SetInstances(set, std::move(instances));
  scene.Commit();
  const double commit = watch.Lap();
  rtg::TraceSettings settings;
  settings.width = settings.height = pixels;
  tracer.Trace(scene, benchmark::CrowdCamera(), { rtg::Light() }, settings, rtg::Pass::Opaque);
  const double first = watch.Lap();
  const double sum = total.Lap();
  const rtg::Statistics& statistics = scene.GetStatistics();
  std::printf("%zu spheres, %u x %u pixels, %zu threads\n", count, pixels, pixels, rtg::ThreadCount());
  std::printf("commit %.2f s: sorting %.2f, building %.2f, sending %.2f\n", commit, statistics.sortSeconds,
    statistics.buildSeconds, statistics.uploadSeconds);
  std::printf("programs and picture %.2f s; all %.2f s\n", first, sum);
  std::printf("peak memory %.0f MB, of which %.0f before; on the device %.0f MB\n", PeakMegabytes(), before,
    static_cast<double>(statistics.deviceBytes) / 1048576.0);
  std::ofstream csv(path);
  csv << "glyphs,pixels,threads,commit s,sort s,build s,upload s,picture s,all s,peak MB,MB before\n"
      << count << ',' << pixels << ',' << rtg::ThreadCount() << ',' << commit << ',' << statistics.sortSeconds << ','
      << statistics.buildSeconds << ',' << statistics.uploadSeconds << ',' << first << ',' << sum << ','
      << PeakMegabytes() << ',' << before << '\n';
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string what = argc > 1 ? argv[1] : "";
  const char* csv = argc > 4 ? argv[4] : "/dev/null";
  if (what == "shapes")
  {
    return MeasureShapes(
      argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 280000, argc > 3 ? std::atoi(argv[3]) : 5, csv);
  }
  if (what == "picture")
  {
    return MeasurePicture(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10000000,
      argc > 3 ? std::uint32_t(std::atoi(argv[3])) : 1200, csv);
  }
  std::fprintf(stderr, "usage: BuildBenchmark shapes|picture [COUNT] [REPETITIONS|PIXELS] [CSV]\n");
  return 2;
}
