#include "Measure.h"

#include <algorithm>
#include <cmath>

namespace rtg::testing
{
namespace
{

template <class Real>
double UlpOf(double t)
{
  const Real magnitude = Real(std::abs(t));
  return double(std::nextafter(magnitude, std::numeric_limits<Real>::infinity()) - magnitude);
}

double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

template <class Real>
Verdict Judge(ReferenceGlyph& glyph, const HardRay& ray, double tMin, const Answer& answer)
{
  const std::vector<ReferenceCrossing> exact = glyph.Crossings(ray.origin, ray.direction);
  Verdict verdict;
  const auto within = [&](double width) {
    return glyph.Crossings(ray.origin, ray.direction, 1.0 - 2.0 * width).size() != exact.size() ||
      glyph.Crossings(ray.origin, ray.direction, 1.0 + 2.0 * width).size() != exact.size();
  };
  verdict.nearSilhouette = within(band);

  const double sizeInT = glyph.Size() / glm::length(glm::dvec3(ray.direction));
  const auto bound = [&](double t) {
    return boundUlps * UlpOf<Real>(t) + boundSizes * relativeRoundoff<Real> * sizeInT;
  };

  // The crossings that may be the first at or after tMin, given the bound on t.
  std::vector<const ReferenceCrossing*> candidates;
  bool mayMiss = true;
  for (const ReferenceCrossing& crossing : exact)
  {
    const double t = double(crossing.t);
    if (t < tMin - bound(t))
    {
      continue;
    }
    candidates.push_back(&crossing);
    if (t > tMin + bound(t))
    {
      mayMiss = false;
      break;
    }
    verdict.nearStart = true;
  }
  verdict.hit = !candidates.empty() && !mayMiss;

  if (!answer.hit || candidates.empty())
  {
    verdict.falseHit = answer.hit && !verdict.nearSilhouette;
    verdict.falseMiss = !answer.hit && !mayMiss && !verdict.nearSilhouette;
    return verdict;
  }

  if (verdict.nearSilhouette && within(bandOfT))
  {
    return verdict;
  }
  verdict.bothHit = true;
  const ReferenceCrossing* closest = candidates.front();
  for (const ReferenceCrossing* candidate : candidates)
  {
    if (fabs(double(candidate->t - answer.t)) < fabs(double(closest->t - answer.t)))
    {
      closest = candidate;
    }
  }
  const double t = double(closest->t);
  const double error = std::abs(double(closest->t - Quad(answer.t)));
  verdict.ulps = error / UlpOf<Real>(t);
  verdict.sizes = error / sizeInT;
  verdict.excess = error / bound(t);

  verdict.hasNormal = !verdict.nearSilhouette && closest->edgeDistance > edgeBand;
  if (verdict.hasNormal)
  {
    const glm::dvec3 normal(
      double(closest->normal.x), double(closest->normal.y), double(closest->normal.z));
    verdict.radians = glm::length(glm::cross(normal, answer.normal));
    if (glm::dot(normal, answer.normal) <= 0.0)
    {
      verdict.radians = M_PI - verdict.radians;
    }
    verdict.normalExcess =
      verdict.radians / (boundRadians * relativeRoundoff<Real>);
  }
  return verdict;
}

CaseReport Summarise(const std::vector<Verdict>& verdicts)
{
  CaseReport report;
  std::vector<double> ulps, sizes, radians;
  for (const Verdict& verdict : verdicts)
  {
    ++report.rays;
    report.hits += verdict.hit;
    report.nearSilhouette += verdict.nearSilhouette;
    report.falseHits += verdict.falseHit;
    report.falseMisses += verdict.falseMiss;
    if (verdict.bothHit)
    {
      ++report.compared;
      ulps.push_back(verdict.ulps);
      sizes.push_back(verdict.sizes);
      report.outOfBound += !(verdict.excess <= 1.0);
      report.maxExcess = std::max(report.maxExcess, verdict.excess);
    }
    if (verdict.hasNormal)
    {
      radians.push_back(verdict.radians);
      report.maxNormalExcess = std::max(report.maxNormalExcess, verdict.normalExcess);
    }
  }
  const auto maximum = [](const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  };
  report.medianUlps = Median(ulps);
  report.maxUlps = maximum(ulps);
  report.medianSizes = Median(sizes);
  report.maxSizes = maximum(sizes);
  report.medianRadians = Median(radians);
  report.maxRadians = maximum(radians);
  return report;
}

template <class Real>
std::vector<Verdict> JudgeKernel(const HardCase& hard)
{
  using Kernel = shapes::Kernel<Real>;
  std::vector<Verdict> verdicts;
  verdicts.reserve(hard.rays.size());
  std::uint32_t index = ~0u;
  std::vector<ReferenceGlyph> reference;
  typename Kernel::Glyph glyph{};
  for (const HardRay& ray : hard.rays)
  {
    if (ray.glyph != index)
    {
      index = ray.glyph;
      reference = { ReferenceGlyph(hard.instances, index) };
      glyph = KernelGlyph<Real>(hard.instances, index);
    }
    const typename Kernel::GlyphRay kernelRay = KernelRay<Real>(ray);
    Answer answer;
    Real t = 0;
    answer.hit =
      Kernel::Intersect(hard.instances.shape, kernelRay, glyph, Real(0), Real(1e30), t);
    answer.t = double(t);
    if (answer.hit)
    {
      answer.normal = glm::dvec3(Kernel::Normal(hard.instances.shape, kernelRay, glyph, t));
    }
    verdicts.push_back(Judge<Real>(reference[0], ray, 0.0, answer));
  }
  return verdicts;
}

template Verdict Judge<float>(ReferenceGlyph&, const HardRay&, double, const Answer&);
template Verdict Judge<double>(ReferenceGlyph&, const HardRay&, double, const Answer&);
template std::vector<Verdict> JudgeKernel<float>(const HardCase&);
template std::vector<Verdict> JudgeKernel<double>(const HardCase&);

} // namespace rtg::testing
