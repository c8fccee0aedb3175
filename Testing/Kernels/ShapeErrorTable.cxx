// Prints the error of every shape's kernel on the hard cases, and how fast it is; the tables of README.md.
// Usage: ShapeErrorTable [file.csv]   (the CSV holds every case, float and double)

#include "Measure.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>

using namespace rtg;
using namespace rtg::testing;

namespace
{

/// Nanoseconds of processor time for one ray against one glyph, the best of some repetitions.
double NanosecondsPerRay(const HardCase& hard)
{
  using Kernel = shapes::Kernel<float>;
  std::vector<Kernel::GlyphRay> rays;
  std::vector<Kernel::Glyph> glyphs;
  for (const HardRay& ray : hard.rays)
  {
    rays.push_back(KernelRay<float>(ray));
    glyphs.push_back(KernelGlyph<float>(hard.instances, ray.glyph));
  }
  if (rays.empty())
  {
    return 0.0;
  }
  double best = 1e30;
  volatile float sink = 0;
  for (int repetition = 0; repetition < 7; ++repetition)
  {
    const std::clock_t start = std::clock();
    float sum = 0;
    for (int round = 0; round < 20; ++round)
    {
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        float t = 0;
        sum +=
          Kernel::Intersect(hard.instances.shape, rays[i], glyphs[i], 0.0f, 1e30f, t) ? t : 0.0f;
      }
    }
    sink = sink + sum;
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, seconds / 20 / double(rays.size()));
  }
  return 1e9 * best;
}

void WriteRow(std::ostream& csv, const HardCase& hard, const char* arithmetic, const CaseReport& r)
{
  csv << '"' << hard.subject << "\",\"" << hard.situation << "\"," << arithmetic << ',' << r.rays
      << ',' << r.hits << ',' << r.excused << ',' << r.falseHits << ',' << r.falseMisses
      << ',' << r.outOfBound << ',' << r.medianUlps << ',' << r.maxUlps << ',' << r.medianSizes
      << ',' << r.maxSizes << ',' << r.maxExcess << ',' << r.medianRadians << ',' << r.maxRadians
      << ',' << r.maxNormalExcess << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  std::ofstream file;
  if (argc > 1)
  {
    file.open(argv[1]);
    file << "shape,case,arithmetic,rays,hits,excused,false_hits,false_misses,out_of_bound,"
            "t_median_ulps,t_max_ulps,t_median_sizes,t_max_sizes,t_max_over_bound,"
            "normal_median_radians,normal_max_radians,normal_max_over_bound\n";
  }
  std::printf(
    "| shape | case | hits / rays | dt median, max (ulps) | dt median, max (sizes) | of bound | "
    "normal max (rad) | false hits, misses | ns |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const HardCase& hard : MakeHardCases())
  {
    const CaseReport r = Summarise(JudgeKernel<float>(hard));
    std::printf(
      "| %s | %s | %zu / %zu | %.2g, %.2g | %.1e, %.1e | %.2f | %.1e (%.1f) | %zu, %zu | %.0f |\n",
      hard.subject.c_str(), hard.situation.c_str(), r.hits, r.rays, r.medianUlps, r.maxUlps,
      r.medianSizes, r.maxSizes, r.maxExcess, r.maxRadians, r.maxNormalExcess, r.falseHits,
      r.falseMisses, NanosecondsPerRay(hard));
    if (file)
    {
      WriteRow(file, hard, "float", r);
      WriteRow(file, hard, "double", Summarise(JudgeKernel<double>(hard)));
    }
  }
  return 0;
}
