// Speed against error of ways to intersect a superquadric with a ray, in C++, one thread.
// Usage: SuperquadricSolvers [FILE.csv] [GLYPHS] [RAYS]      (plotted by plots.py)
//
// The rays are those of Testing/Kernels/HardCases.h: random ones and every hard case, GLYPHS glyphs with RAYS rays each
// in every case. The reference has 113 bits. Hits and misses are judged except within 1e-5 of the scale round the
// silhouette; errors of t are in glyph sizes, beyond what t itself can hold (an ulp).
#include "Measure.h"
#include "Measures.h"
#include "SuperquadricRivals.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <utility>

using namespace rtg;
using namespace rtg::testing;

namespace
{

/// What the reference says of one ray.
struct Truth
{
  bool judged = false; ///< neither near the silhouette nor starting on the surface
  bool hit = false;
  bool hasNormal = false;
  long double t = 0;
  glm::dvec3 normal{ 0 };
  double sizeInT = 1;
};

struct Scene
{
  std::string family;
  HardCase hard;
  std::vector<Truth> truths;
};

Truth Judge(ReferenceGlyph& glyph, const HardRay& ray)
{
  Truth truth;
  truth.sizeInT = glyph.Size() / glm::length(glm::dvec3(ray.direction));
  const auto crossings = glyph.Crossings(ray.origin, ray.direction);
  const auto count = [&](double factor) { return glyph.Crossings(ray.origin, ray.direction, factor).size(); };
  truth.judged = count(1 - 2 * band) == crossings.size() && count(1 + 2 * band) == crossings.size();
  for (const ReferenceCrossing& crossing : crossings)
  {
    truth.judged = truth.judged && std::abs(double(crossing.t)) > 1e-5 * truth.sizeInT;
    if (crossing.t > 0 && !truth.hit)
    {
      truth.hit = true;
      truth.t = static_cast<long double>(crossing.t);
      truth.normal = { double(crossing.normal.x), double(crossing.normal.y), double(crossing.normal.z) };
      truth.hasNormal = crossing.edgeDistance > edgeBand && crossing.edgeSizes > edgeBandSizes;
    }
  }
  return truth;
}

std::vector<Scene> MakeScenes(int glyphs, int rays)
{
  const std::map<std::string, std::string> families = {
    { "superquadric, 1 to 2", "convex" },
    { "superquadric, 2 to 20", "convex" },
    { "superquadric, 0.3 to 1", "concave" },
    { "superquadric, 0.3 to 20", "concave" },
  };
  std::vector<Scene> scenes;
  for (const Subject& subject : HardSubjects())
  {
    const auto family = families.find(subject.name);
    if (family == families.end())
    {
      continue;
    }
    for (HardCase& hard : HardCaseMaker(subject, glyphs, rays).All())
    {
      Scene scene{ family->second, std::move(hard), {} };
      std::uint32_t index = ~0u;
      std::vector<ReferenceGlyph> reference;
      for (const HardRay& ray : scene.hard.rays)
      {
        if (ray.glyph != index)
        {
          index = ray.glyph;
          reference = { ReferenceGlyph(scene.hard.instances, index) };
        }
        scene.truths.push_back(Judge(reference[0], ray));
      }
      scenes.push_back(std::move(scene));
    }
  }
  return scenes;
}

struct Report
{
  std::vector<std::size_t> calls; ///< that trace the rays
  std::size_t rays = 0, falseHits = 0, misses = 0;
  std::vector<double> sizes, radians;

  void Add(const Report& other)
  {
    this->calls.insert(this->calls.end(), other.calls.begin(), other.calls.end());
    this->rays += other.rays;
    this->falseHits += other.falseHits;
    this->misses += other.misses;
    this->sizes.insert(this->sizes.end(), other.sizes.begin(), other.sizes.end());
    this->radians.insert(this->radians.end(), other.radians.begin(), other.radians.end());
  }
};

template <class Real>
using Solver = typename benchmark::Rivals<Real>::Hit (*)(
  const typename benchmark::Rivals<Real>::GlyphRay&, const typename benchmark::Rivals<Real>::Glyph&, Real, bool);

template <class Real>
Report Run(Solver<Real> solver, const Scene& scene, benchmark::Turns& turns)
{
  using Rivals = benchmark::Rivals<Real>;
  std::vector<typename Rivals::GlyphRay> rays;
  std::vector<typename Rivals::Glyph> glyphs;
  for (const HardRay& ray : scene.hard.rays)
  {
    rays.push_back(KernelRay<Real>(ray));
    glyphs.push_back(KernelGlyph<Real>(scene.hard.instances, ray.glyph));
  }
  Report report;
  report.rays = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const Truth& truth = scene.truths[i];
    const auto hit = solver(rays[i], glyphs[i], Real(0), true);
    if (!truth.judged)
    {
      continue;
    }
    report.falseHits += hit.found && !truth.hit;
    report.misses += !hit.found && truth.hit;
    if (hit.found && truth.hit)
    {
      const double ulp = double(std::nextafter(Real(truth.t), Real(INFINITY)) - Real(truth.t));
      const double error = std::abs(double(truth.t - static_cast<long double>(hit.t)));
      report.sizes.push_back(std::max(0.0, error - ulp) / truth.sizeInT);
      if (truth.hasNormal)
      {
        const glm::dvec3 normal(hit.normal);
        const double sine = glm::length(glm::cross(normal, truth.normal));
        report.radians.push_back(std::atan2(sine, glm::dot(normal, truth.normal)));
      }
    }
  }
  // Time without normals and judging.
  report.calls.push_back(turns.Add(
    [solver, rays = std::move(rays), glyphs = std::move(glyphs)]
    {
      Real sum = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        sum += solver(rays[i], glyphs[i], Real(0), false).t;
      }
      const volatile Real sink = sum;
      (void)sink;
    }));
  return report;
}

/// A row of the file.
struct ReportRow
{
  const char* family;
  std::string situation;
  const char *solver, *arithmetic;
  Report report;
};

void Write(std::ostream& csv, const ReportRow& row, const benchmark::Turns& turns)
{
  const Report& r = row.report;
  const double rays = double(std::max<std::size_t>(1, r.rays));
  const benchmark::Measured ns = turns.ARay(r.calls, r.rays);
  csv << row.family << ",\"" << row.situation << "\",\"" << row.solver << "\"," << row.arithmetic << ',' << r.rays
      << ',' << ns << ',' << Quantile(r.sizes, 0.5) << ',' << Quantile(r.sizes, 0.999) << ',' << Quantile(r.sizes, 1)
      << ',' << Quantile(r.radians, 0.5) << ',' << Quantile(r.radians, 0.999) << ',' << Quantile(r.radians, 1) << ','
      << 1e6 * double(r.falseHits) / rays << ',' << 1e6 * double(r.misses) / rays << '\n';
  if (row.situation == "random" || row.situation == "all")
  {
    std::printf("| %s | %s | %s | %s | %.0f | %.1e | %.1e | %.1e | %.1e | %.1e | %.0f / %.0f |\n", row.family,
      row.situation.c_str(), row.solver, row.arithmetic, ns.Median(), Quantile(r.sizes, 0.5), Quantile(r.sizes, 0.999),
      Quantile(r.sizes, 1), Quantile(r.radians, 0.5), Quantile(r.radians, 1), 1e6 * double(r.falseHits) / rays,
      1e6 * double(r.misses) / rays);
  }
}

template <class Real>
void RunAll(
  const std::vector<Scene>& scenes, const char* arithmetic, benchmark::Turns& turns, std::vector<ReportRow>& rows)
{
  using Rivals = benchmark::Rivals<Real>;
  struct Entry
  {
    const char* name;
    const char* families; ///< those it is for
    Solver<Real> solver;
  };
  const Entry entries[] = {
    { "plugin", "convex concave", Rivals::Plugin },
    { "plugin, no last step", "convex concave", Rivals::PluginPlain },
    { "Newton from outside", "convex", Rivals::ConvexNewton },
    { "Illinois", "convex", Rivals::ConvexIllinois },
    { "ITP", "convex", Rivals::ConvexItp },
    { "Lipschitz steps", "convex", Rivals::ConvexLipschitz },
    { "intervals, Illinois", "convex concave", Rivals::Intervals },
    { "line stepping", "convex concave", Rivals::LineStepping },
    { "64 samples, Illinois", "convex concave", Rivals::Samples },
    { "damped Newton, as published", "convex concave", Rivals::template Damped<true> },
    { "damped Newton, right gradient", "convex concave", Rivals::template Damped<false> },
  };
  for (const char* family : { "convex", "concave" })
  {
    for (const Entry& entry : entries)
    {
      if (std::string(entry.families).find(family) == std::string::npos)
      {
        continue;
      }
      std::map<std::string, Report> reports;
      for (const Scene& scene : scenes)
      {
        if (scene.family == family)
        {
          const Report report = Run<Real>(entry.solver, scene, turns);
          reports[scene.hard.situation].Add(report);
          reports["all"].Add(report);
          if (scene.hard.situation == "plain" || scene.hard.situation == "turned")
          {
            reports["random"].Add(report);
          }
        }
      }
      for (auto& [situation, report] : reports)
      {
        rows.push_back({ family, situation, entry.name, arithmetic, std::move(report) });
      }
    }
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  std::ofstream csv = benchmark::Written(argc > 1 ? argv[1] : "superquadric-solvers.csv");
  const int glyphs = argc > 2 ? std::atoi(argv[2]) : 12, rays = argc > 3 ? std::atoi(argv[3]) : 50;
  csv << "family,case,solver,arithmetic,rays,ns_per_ray,"
         "t_median_sizes,t_p999_sizes,t_max_sizes,normal_median_radians,normal_p999_radians,normal_max_radians,"
         "false_hits_per_million,misses_per_million\n";
  const std::vector<Scene> scenes = MakeScenes(glyphs, rays);
  std::printf("| glyphs | rays | solver | arithmetic | ns a ray | dt median | 99.9 %% | max (sizes) | normal "
              "median | max "
              "(rad) | false hits / misses a million |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  benchmark::Turns turns;
  std::vector<ReportRow> rows;
  RunAll<float>(scenes, "float", turns, rows);
  RunAll<double>(scenes, "double", turns, rows);
  turns.Take();
  for (const ReportRow& row : rows)
  {
    Write(csv, row, turns);
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "SuperquadricSolvers: %s\n", error.what());
  return 1;
}
