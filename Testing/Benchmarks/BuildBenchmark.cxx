// Wall-clock seconds of what the host does with new glyphs: their boxes, their order, their tree; and, of spheres, from
// data in memory to the first picture, with the memory that takes.
// Usage: BuildBenchmark shapes [COUNT] [REPETITIONS] [CSV]
//        BuildBenchmark picture [COUNT] [PIXELS] [CSV] [TURNS]
//
// Glyphs lie in a cube at random, turned at random where it says so. Shapes are measured in turns over all, and of each
// stage the median is printed (the file has all turns), on one thread and on all cores, beside the processor seconds of
// all together, which other work on the machine disturbs less. The picture is measured in each turn by a process that
// has done nothing else, so programs are compiled in it.
#include "Crowds.h"
#include "GlyphBoxes.h"
#include "GlyphTree.h"
#include "Measures.h"
#include "Parallel.h"
#include "Scene.h"
#include "Stopwatch.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

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
  std::ofstream csv = benchmark::Written(path);
  csv << "shape,glyphs,threads";
  for (const char* column : { "boxes s", "order s", "tree s", "processor s" })
  {
    csv << ',' << column;
  }
  csv << '\n';
  std::printf(
    "%-34s %9s %8s %8s %8s %8s %8s %8s\n", "shape", "glyphs", "threads", "boxes", "order", "tree", "sum", "CPU");
  const std::size_t cores = rtg::ThreadCount();
  struct Subject
  {
    const char* name;
    rtg::GlyphInstances instances;
    Seconds one, all;
  };
  std::vector<Subject> subjects;
  for (const benchmark::Crowd& crowd : crowds)
  {
    subjects.push_back({ crowd.name, benchmark::MakeInstances(crowd, count), {}, {} });
  }
  for (int i = 0; i < repetitions; ++i)
  {
    for (Subject& subject : subjects)
    {
      rtg::SetThreadCount(1);
      Build(subject.instances, subject.one);
      rtg::SetThreadCount(cores);
      Build(subject.instances, subject.all);
    }
  }
  for (const Subject& subject : subjects)
  {
    for (const Seconds* seconds : { &subject.one, &subject.all })
    {
      const std::size_t threads = seconds == &subject.one ? 1 : cores;
      const benchmark::Measured boxes(seconds->boxes), order(seconds->order), tree(seconds->tree),
        processor(seconds->processor);
      std::printf("%-34s %9zu %8zu %8.4f %8.4f %8.4f %8.4f %8.4f\n", subject.name, count, threads, boxes.Median(),
        order.Median(), tree.Median(), boxes.Median() + order.Median() + tree.Median(), processor.Median());
      csv << '"' << subject.name << "\"," << count << ',' << threads << ',' << boxes << ',' << order << ',' << tree
          << ',' << processor << '\n';
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

constexpr const char* pictureColumns[] = { "commit s", "sort s", "build s", "upload s", "picture s", "all s", "peak MB",
  "MB before" };
using PictureFigures = std::array<double, std::size(pictureColumns)>;

PictureFigures MeasurePicture(std::size_t count, std::uint32_t pixels)
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
  return { commit, statistics.sortSeconds, statistics.buildSeconds, statistics.uploadSeconds, first, sum,
    PeakMegabytes(), before };
}

// What a process of its own finds.
PictureFigures MeasureApart(std::size_t count, std::uint32_t pixels)
{
  int ends[2];
  const pid_t child = pipe(ends) == 0 ? fork() : -1;
  PictureFigures figures;
  if (child == 0)
  {
    figures = MeasurePicture(count, pixels);
    const bool written = write(ends[1], figures.data(), sizeof figures) == sizeof figures;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  const bool found = child > 0 && read(ends[0], figures.data(), sizeof figures) == sizeof figures;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!found)
  {
    throw std::runtime_error("a turn has ended without its figures");
  }
  return figures;
}

int MeasurePictures(std::size_t count, std::uint32_t pixels, const char* path, int turns)
{
  std::vector<std::vector<double>> found(std::size(pictureColumns));
  for (int turn = 0; turn < turns; ++turn)
  {
    const PictureFigures figures = MeasureApart(count, pixels);
    for (std::size_t i = 0; i < figures.size(); ++i)
    {
      found[i].push_back(figures[i]);
    }
  }
  std::ofstream csv = benchmark::Written(path);
  csv << "glyphs,pixels,threads";
  for (const char* column : pictureColumns)
  {
    csv << ',' << column;
  }
  csv << '\n' << count << ',' << pixels << ',' << rtg::ThreadCount();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const benchmark::Measured turned(found[i]);
    std::printf("%-12s %8.2f\n", pictureColumns[i], turned.Median());
    csv << ',' << turned;
  }
  csv << '\n';
  return 0;
}

} // namespace

int main(int argc, char** argv)
try
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
    return MeasurePictures(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10000000,
      argc > 3 ? std::uint32_t(std::atoi(argv[3])) : 1200, csv, argc > 5 ? std::atoi(argv[5]) : 7);
  }
  std::fprintf(stderr, "usage: BuildBenchmark shapes|picture [COUNT] [REPETITIONS|PIXELS] [CSV] [TURNS]\n");
  return 2;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "BuildBenchmark: %s\n", error.what());
  return 1;
}
