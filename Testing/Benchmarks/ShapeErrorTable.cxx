// Prints the error of every shape's kernel on the hard cases, and how fast superquadrics are and formulas for spheres.
// Usage: ShapeErrorTable [file.csv]            (the CSV holds every case, float and double)
//        ShapeErrorTable --speed [file.csv]    families of superquadrics, also out of range: speed against error
//        ShapeErrorTable --million [file.csv]  spherical functions, capsules and round cones: a million rays of each
//        ShapeErrorTable --spheres [file.csv]  spheres beside the formulas that other renderers use

#include "Measure.h"
#include "Measures.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

using namespace rtg;
using namespace rtg::testing;

namespace
{

/// The call that traces all of the case's rays, each against its glyph.
template <class Real>
std::size_t AddCall(benchmark::Turns& turns, const HardCase& hard)
{
  using Kernel = shapes::Kernel<Real>;
  std::vector<typename Kernel::GlyphRay> rays;
  std::vector<typename Kernel::Glyph> glyphs;
  for (const HardRay& ray : hard.rays)
  {
    rays.push_back(KernelRay<Real>(ray));
    glyphs.push_back(KernelGlyph<Real>(hard.instances, ray.glyph));
  }
  return turns.Add(
    [rays = std::move(rays), glyphs = std::move(glyphs), shape = hard.instances.shape]
    {
      Real sum = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        Real t = 0;
        sum += Kernel::IntersectGlyph(shape, rays[i], glyphs[i], Real(0), Real(1e30), t) ? t : Real(0);
      }
      const volatile Real sink = sum;
      (void)sink;
    });
}

void WriteRow(std::ostream& csv, const HardCase& hard, const char* arithmetic, const CaseReport& r)
{
  csv << '"' << hard.subject << "\",\"" << hard.situation << "\"," << arithmetic << ',' << r.rays << ',' << r.hits
      << ',' << r.excused << ',' << r.falseHits << ',' << r.falseMisses << ',' << r.outOfBound << ',' << r.medianUlps
      << ',' << r.maxUlps << ',' << r.medianSizes << ',' << r.maxSizes << ',' << r.maxExcess << ',' << r.medianRadians
      << ',' << r.maxRadians << ',' << r.maxNormalExcess << '\n';
}

/// What verdicts say together.
struct Tally
{
  std::vector<double> sizes; ///< of t, beyond what t itself can hold
  std::vector<double> radians;
  std::size_t rays = 0, falseHits = 0, falseMisses = 0, outOfBound = 0, wrongNormals = 0;

  void Add(const std::vector<Verdict>& verdicts)
  {
    this->rays += verdicts.size();
    for (const Verdict& verdict : verdicts)
    {
      this->falseHits += verdict.falseHit;
      this->falseMisses += verdict.falseMiss;
      if (verdict.bothHit)
      {
        this->sizes.push_back(verdict.ulps > 1.0 ? verdict.sizes * (1.0 - 1.0 / verdict.ulps) : 0.0);
        this->outOfBound += !(verdict.excess <= 1.0);
      }
      if (verdict.bothHit && verdict.hasNormal)
      {
        this->radians.push_back(verdict.radians);
        this->wrongNormals += !(verdict.normalExcess <= 1.0);
      }
    }
  }
};

/// The hard cases of one family together.
struct Family
{
  std::string name;
  const char *range, *arithmetic;
  Tally tally;
  std::vector<std::size_t> calls, random; ///< of all cases, and of random rays alone
  std::size_t randomRays = 0;

  template <class Real>
  void Judge(const Subject& subject, benchmark::Turns& turns)
  {
    for (const HardCase& hard : HardCaseMaker(subject, 12, 50, 21).All())
    {
      ReferenceCase reference(hard);
      this->tally.Add(JudgeKernel<Real>(reference));
      this->calls.push_back(AddCall<Real>(turns, hard));
      if (hard.situation == "turned")
      {
        this->random = { this->calls.back() };
        this->randomRays = hard.rays.size();
      }
    }
  }

  void Write(std::ostream& csv, const benchmark::Turns& turns) const
  {
    const Tally& all = this->tally;
    const benchmark::Measured ns = turns.ARay(this->calls, all.rays),
                              plain = turns.ARay(this->random, this->randomRays);
    csv << '"' << this->name << "\"," << this->range << ',' << this->arithmetic << ',' << all.rays << ',' << plain
        << ',' << ns << ',' << Quantile(all.sizes, 0.5) << ',' << Quantile(all.sizes, 0.999) << ','
        << Quantile(all.sizes, 1) << ',' << Quantile(all.radians, 0.5) << ',' << Quantile(all.radians, 0.999) << ','
        << Quantile(all.radians, 1) << ',' << all.outOfBound << ',' << all.wrongNormals << ',' << all.falseHits << ','
        << all.falseMisses << '\n';
    std::printf("| %s | %s | %s | %.0f | %.0f | %.1e | %.1e | %.1e | %.1e | %zu / %zu | %zu / %zu |\n",
      this->name.c_str(), this->range, this->arithmetic, plain.Median(), ns.Median(), Quantile(all.sizes, 0.5),
      Quantile(all.sizes, 0.999), Quantile(all.sizes, 1), Quantile(all.radians, 1), all.outOfBound, all.wrongNormals,
      all.falseHits, all.falseMisses);
  }
};

void HeadOfFamilies(std::ostream& csv)
{
  csv << "family,range,arithmetic,rays,ns_per_ray_random,ns_per_ray_all,"
         "t_median_sizes,t_p999_sizes,t_max_sizes,normal_median_radians,normal_p999_radians,normal_max_radians,"
         "t_out_of_bound,normals_out_of_bound,false_hits,false_misses\n";
  std::printf("| glyphs | range | arithmetic | ns a ray, random | all | dt median | 99.9 %% | max "
              "(sizes) | normal max (rad) "
              "| t / normals out of bound | false hits / misses "
              "|\n|---|---|---|---|---|---|---|---|---|---|---|\n");
}

/// What a million rays say of one family.
struct ManyVerdicts
{
  std::vector<double> sizes; ///< of t, beyond what t itself can hold
  std::size_t rays = 0, hits = 0, falseHits = 0, falseMisses = 0, excused = 0, lobes = 0, outOfBound = 0,
              wrongNormals = 0;
  double worst = 0.0, radians = 0.0;

  void Add(const Verdict& verdict)
  {
    ++this->rays;
    this->hits += verdict.hit;
    this->falseHits += verdict.falseHit;
    this->falseMisses += verdict.falseMiss;
    const bool beyond = verdict.bothHit && !(verdict.excess <= 1.0);
    this->lobes += beyond && verdict.nearSilhouette;
    this->outOfBound += beyond && !verdict.nearSilhouette;
    this->excused += !verdict.bothHit && verdict.nearSilhouette;
    if (verdict.bothHit && !(beyond && verdict.nearSilhouette))
    {
      this->sizes.push_back(verdict.ulps > 1.0 ? verdict.sizes * (1.0 - 1.0 / verdict.ulps) : 0.0);
      this->worst = std::max(this->worst, verdict.excess);
      if (verdict.hasNormal && !verdict.nearSilhouette)
      {
        this->radians = std::max(this->radians, verdict.radians);
        this->wrongNormals += !(verdict.normalExcess <= 1.0);
      }
    }
  }
};

/// A million rays of each family, on all cores: one hard case after the other.
void TableOfMillions(std::ostream& csv)
{
  std::vector<Subject> subjects{ PolynomialSubject(2, Forms::Harmonics), PolynomialSubject(4, Forms::Harmonics),
    PolynomialSubject(8, Forms::Harmonics), PolynomialSubject(8, Forms::Bundles), PolynomialSubject(2, Forms::Stress),
    PolynomialSubject(4, Forms::Stiffness) };
  for (const Subject& subject : HardSubjects())
  {
    if (subject.shape == Shape::RoundCone || subject.shape == Shape::Capsule)
    {
      subjects.push_back(subject);
    }
  }
  csv << "family,rays,hits,t_median_sizes,t_p999_sizes,t_max_sizes,t_max_over_bound,t_out_of_bound,normal_max_radians,"
         "normals_out_of_bound,false_hits,false_misses,silhouettes,lobes\n";
  std::printf(
    "| glyphs | rays | dt median | 99.9 %% | max (sizes) | over bound | t / normals out of bound | normal max "
    "(rad) | false hits / misses | at silhouettes | at lobes |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Subject& subject : subjects)
  {
    const std::vector<HardCase> cases = HardCaseMaker(subject, 210, 200, 21).All();
    ManyVerdicts all;
    std::atomic<std::size_t> next{ 0 };
    std::mutex mutex;
    const auto work = [&]
    {
      for (std::size_t i = next++; i < cases.size(); i = next++)
      {
        ReferenceCase reference(cases[i]);
        const std::vector<Verdict> verdicts = JudgeKernel<float>(reference);
        const std::lock_guard<std::mutex> lock(mutex);
        std::for_each(verdicts.begin(), verdicts.end(), [&all](const Verdict& verdict) { all.Add(verdict); });
      }
    };
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads)
    {
      thread = std::thread(work);
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    csv << '"' << subject.name << "\"," << all.rays << ',' << all.hits << ',' << Quantile(all.sizes, 0.5) << ','
        << Quantile(all.sizes, 0.999) << ',' << Quantile(all.sizes, 1) << ',' << all.worst << ',' << all.outOfBound
        << ',' << all.radians << ',' << all.wrongNormals << ',' << all.falseHits << ',' << all.falseMisses << ','
        << all.excused << ',' << all.lobes << std::endl;
    std::printf("| %s | %zu | %.1e | %.1e | %.1e | %.2f | %zu / %zu | %.1e | %zu / %zu | %zu | %zu |\n",
      subject.name.c_str(), all.rays, Quantile(all.sizes, 0.5), Quantile(all.sizes, 0.999), Quantile(all.sizes, 1),
      all.worst, all.outOfBound, all.wrongNormals, all.radians, all.falseHits, all.falseMisses, all.excused, all.lobes);
    std::fflush(stdout);
  }
}

/// Superquadrics and tensor glyphs within the range in which the bounds are promised, and beyond it.
void TableOfSpeed(std::ostream& csv)
{
  const auto family = [](const std::string& name, Shape shape, const glm::vec3& least, const glm::vec3& most) {
    return Subject{ name, shape, {}, false, least, most };
  };
  std::vector<Subject> within, beyond;
  for (const Subject& subject : HardSubjects())
  {
    const std::string& name = subject.name;
    if (name == "superquadric, 1 to 2" || name == "superquadric, 2 to 20" || name == "superquadric, 0.3 to 20")
    {
      within.push_back(subject);
    }
  }
  const std::vector<Subject> nested = NestedSubjects();
  within.insert(within.end(), nested.begin(), nested.end());
  beyond.push_back(family("superquadric, 0.1 to 0.3", Shape::Superquadric, glm::vec3(0.1f), glm::vec3(0.3f)));
  beyond.push_back(family("superquadric, 20 to 100", Shape::Superquadric, glm::vec3(20.0f), glm::vec3(100.0f)));
  beyond.push_back(family("nested, 0.1 to 0.3", Shape::NestedSuperquadric, { 20.0f / 3, 20.0f / 3, 1 }, { 20, 20, 0 }));
  beyond.push_back(family("nested, 20 to 100", Shape::NestedSuperquadric, { 0.02f, 0.02f, 0.02f }, { 0.1f, 0.1f, 0 }));
  beyond.push_back(family("nested, sharpness 10", Shape::NestedSuperquadric, { 0.01f, 5, 5 }, { 1, 12, 0 }));
  benchmark::Turns turns;
  std::vector<Family> families;
  const auto add = [&](const std::vector<Subject>& subjects, const char* range)
  {
    for (const Subject& subject : subjects)
    {
      families.push_back({ subject.name, range, "float", {}, {}, {} });
      families.back().Judge<float>(subject, turns);
      families.push_back({ subject.name, range, "double", {}, {}, {} });
      families.back().Judge<double>(subject, turns);
    }
  };
  add(within, "within");
  add(beyond, "beyond");
  turns.Take();
  HeadOfFamilies(csv);
  for (const Family& family : families)
  {
    family.Write(csv, turns);
  }
}

/// Formulas of others for spheres, in plain float. `o`: the ray's origin from the center, which is the exact difference
/// rounded once, so that only what the formula itself loses shows.
using SphereFormula = bool (*)(const glm::vec3& o, const glm::vec3& d, float radius, float& t);

bool Nearest(float first, float second, float& t)
{
  t = first >= 0.0f ? first : second;
  return t >= 0.0f;
}

bool Textbook(const glm::vec3& o, const glm::vec3& d, float radius, float& t)
{
  const float a = glm::dot(d, d), b = 2.0f * glm::dot(o, d), c = glm::dot(o, o) - radius * radius;
  const float discriminant = b * b - 4.0f * a * c;
  if (discriminant < 0.0f)
  {
    return false;
  }
  const float root = std::sqrt(discriminant);
  return Nearest((-b - root) / (2.0f * a), (-b + root) / (2.0f * a), t);
}

/// The origin moved to two radii before the center, then the textbook's.
bool MovedOrigin(const glm::vec3& o, const glm::vec3& d, float radius, float& t)
{
  const float a = glm::dot(d, d);
  const float moved = std::max(0.0f, (-glm::dot(o, d) - 2.0f * radius * std::sqrt(a)) / a);
  const bool hit = Textbook(o + moved * d, d, radius, t);
  t += moved;
  return hit;
}

/// Haines et al., "Precision improvements for ray/sphere intersection", Ray Tracing Gems, chapter 7, 2019.
bool RayTracingGems(const glm::vec3& o, const glm::vec3& d, float radius, float& t)
{
  const float a = glm::dot(d, d), b = -glm::dot(o, d);
  const glm::vec3 apart = o + (b / a) * d;
  const float discriminant = radius * radius - glm::dot(apart, apart);
  if (discriminant < 0.0f)
  {
    return false;
  }
  const float q = b + std::copysign(std::sqrt(a * discriminant), b), c = glm::dot(o, o) - radius * radius;
  return Nearest(std::min(c / q, q / a), std::max(c / q, q / a), t);
}

/// The center projected onto the ray, as in Embree's sphere_intersector.h (versions 3 and 4).
bool EmbreesProjection(const glm::vec3& o, const glm::vec3& d, float radius, float& t)
{
  const float perSquare = 1.0f / glm::dot(d, d);
  const glm::vec3 center = -o;
  const float projected = glm::dot(center, d) * perSquare;
  const glm::vec3 apart = center - projected * d;
  const float square = glm::dot(apart, apart);
  if (square > radius * radius)
  {
    return false;
  }
  const float half = std::sqrt((radius * radius - square) * perSquare);
  return Nearest(projected - half, projected + half, t);
}

std::vector<Verdict> JudgeFormula(ReferenceCase& reference, SphereFormula formula)
{
  const HardCase& hard = reference.Hard();
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < hard.rays.size(); ++i)
  {
    const HardRay& ray = hard.rays[i];
    const glm::vec3 o(ray.origin - glm::dvec3(hard.instances.centers[ray.glyph]));
    Answer answer;
    float t = 0.0f;
    answer.hit = formula(o, ray.direction, 0.5f * hard.instances.sizes1[ray.glyph], t);
    answer.t = t;
    answer.normal = glm::dvec3(glm::normalize(o + t * ray.direction));
    verdicts.push_back(reference.Judge<float>(i, answer));
  }
  return verdicts;
}

std::size_t AddCall(benchmark::Turns& turns, const HardCase& hard, SphereFormula formula)
{
  return turns.Add(
    [&hard, formula]
    {
      float sum = 0.0f;
      for (const HardRay& ray : hard.rays)
      {
        float t = 0.0f;
        const glm::vec3 o(ray.origin - glm::dvec3(hard.instances.centers[ray.glyph]));
        sum += formula(o, ray.direction, 0.5f * hard.instances.sizes1[ray.glyph], t) ? t : 0.0f;
      }
      const volatile float sink = sum;
      (void)sink;
    });
}

void TableOfSpheres(std::ostream& csv)
{
  const std::pair<const char*, SphereFormula> formulas[] = { { "textbook", Textbook }, { "moved origin", MovedOrigin },
    { "Ray Tracing Gems", RayTracingGems }, { "Embree's projection", EmbreesProjection } };
  csv << "case,formula,rays,ns_per_ray,t_median_sizes,t_max_sizes,t_out_of_bound,normal_max_radians,false_hits,false_"
         "misses\n";
  std::printf(
    "| hard case | formula | ns a ray | dt median | max (sizes) | out of bound | normal max (rad) | false hits "
    "/ misses |\n|---|---|---|---|---|---|---|---|\n");
  struct Row
  {
    std::string situation;
    const char* formula;
    std::size_t call;
    Tally tally;
  };
  benchmark::Turns turns;
  std::vector<Row> rows;
  const auto add = [&rows](const HardCase& hard, const char* formula, std::size_t call, const std::vector<Verdict>& all)
  {
    rows.push_back({ hard.situation, formula, call, {} });
    rows.back().tally.Add(all);
  };
  const std::vector<Subject> subjects = HardSubjects();
  const auto sphere =
    std::find_if(subjects.begin(), subjects.end(), [](const Subject& s) { return s.name == "sphere"; });
  const std::vector<HardCase> cases = HardCaseMaker(*sphere, 40, 100).All();
  for (const HardCase& hard : cases)
  {
    ReferenceCase reference(hard);
    add(hard, "plugin", AddCall<float>(turns, hard), JudgeKernel<float>(reference));
    for (const auto& [name, formula] : formulas)
    {
      add(hard, name, AddCall(turns, hard, formula), JudgeFormula(reference, formula));
    }
  }
  turns.Take();
  for (const auto& [situation, formula, call, tally] : rows)
  {
    const benchmark::Measured ns = turns.ARay({ call }, tally.rays);
    csv << '"' << situation << "\"," << formula << ',' << tally.rays << ',' << ns << ',' << Quantile(tally.sizes, 0.5)
        << ',' << Quantile(tally.sizes, 1) << ',' << tally.outOfBound << ',' << Quantile(tally.radians, 1) << ','
        << tally.falseHits << ',' << tally.falseMisses << '\n';
    std::printf("| %s | %s | %.0f | %.1e | %.1e | %zu of %zu | %.1e | %zu / %zu |\n", situation.c_str(), formula,
      ns.Median(), Quantile(tally.sizes, 0.5), Quantile(tally.sizes, 1), tally.outOfBound, tally.sizes.size(),
      Quantile(tally.radians, 1), tally.falseHits, tally.falseMisses);
  }
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc > 1 && std::string(argv[1]) == "--speed")
  {
    std::ofstream csv = benchmark::Written(argc > 2 ? argv[2] : "superquadric-errors.csv");
    TableOfSpeed(csv);
    return 0;
  }
  if (argc > 1 && std::string(argv[1]) == "--million")
  {
    std::ofstream csv = benchmark::Written(argc > 2 ? argv[2] : "million-errors.csv");
    TableOfMillions(csv);
    return 0;
  }
  if (argc > 1 && std::string(argv[1]) == "--spheres")
  {
    std::ofstream csv = benchmark::Written(argc > 2 ? argv[2] : "sphere-formulas.csv");
    TableOfSpheres(csv);
    return 0;
  }
  if (argc > 1 && argv[1][0] == '-')
  {
    std::fprintf(stderr, "Usage: ShapeErrorTable [--speed | --million | --spheres] [file.csv], not %s\n", argv[1]);
    return 2;
  }
  std::ofstream file;
  if (argc > 1)
  {
    file = benchmark::Written(argv[1]);
    file << "shape,case,arithmetic,rays,hits,excused,false_hits,false_misses,out_of_bound,"
            "t_median_ulps,t_max_ulps,t_median_sizes,t_max_sizes,t_max_over_bound,"
            "normal_median_radians,normal_max_radians,normal_max_over_bound\n";
  }
  std::printf("| shape | case | hits / rays | dt median, max (ulps) | dt median, max (sizes) | of bound | "
              "normal max (rad) | false hits, misses |\n|---|---|---|---|---|---|---|---|\n");
  for (const HardCase& hard : MakeHardCases())
  {
    ReferenceCase reference(hard);
    const CaseReport r = Summarise(JudgeKernel<float>(reference));
    std::printf("| %s | %s | %zu / %zu | %.2g, %.2g | %.1e, %.1e | %.2f | %.1e (%.1f) | %zu, %zu |\n",
      hard.subject.c_str(), hard.situation.c_str(), r.hits, r.rays, r.medianUlps, r.maxUlps, r.medianSizes, r.maxSizes,
      r.maxExcess, r.maxRadians, r.maxNormalExcess, r.falseHits, r.falseMisses);
    if (file.is_open())
    {
      WriteRow(file, hard, "float", r);
      WriteRow(file, hard, "double", Summarise(JudgeKernel<double>(reference)));
    }
  }
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "ShapeErrorTable: %s\n", error.what());
  return 1;
}
