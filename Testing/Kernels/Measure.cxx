#include "Measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

template struct rtg::shapes::Kernel<float>;
template struct rtg::shapes::Kernel<double>;

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

/// |dt| may be this much; `sizeInT` is the glyph's size in units of t.
template <class Real>
double BoundOfT(const ReferenceGlyph& glyph, double t, double sizeInT)
{
  const double sizes = glyph.IsPolynomial() ? boundSizesOfPolynomials : boundSizes;
  return boundUlps * UlpOf<Real>(t) + sizes * relativeRoundoff<Real> * sizeInT;
}

/// How far the silhouette is, as the fraction by which the glyph must grow or shrink for the line to cross its
/// surface another number of times; at least this of the widths tried.
double SilhouetteWidth(ReferenceGlyph& glyph, const HardRay& ray, std::size_t crossings)
{
  for (double width = 1e-11; width < 2.0 * band; width *= 10.0)
  {
    if (glyph.Crossings(ray.origin, ray.direction, 1.0 - 2.0 * width).size() != crossings ||
      glyph.Crossings(ray.origin, ray.direction, 1.0 + 2.0 * width).size() != crossings)
    {
      return width;
    }
  }
  return 1.0;
}

/// The larger one; of a number and one that is none, the latter, which std::max may lose.
double Largest(double a, double b)
{
  return a >= b || std::isnan(a) ? a : b;
}

template <class Real>
void CompareHit(const ReferenceGlyph& glyph, const HardRay& ray, const Answer& answer,
  const ReferenceCrossing& crossing, Verdict& verdict)
{
  const double sizeInT = glyph.Size() / glm::length(glm::dvec3(ray.direction));
  const double t = double(crossing.t);
  const double error = std::abs(double(crossing.t - Quad(answer.t)));
  verdict.bothHit = true;
  verdict.t = t;
  verdict.ulps = error / UlpOf<Real>(t);
  verdict.sizes = error / sizeInT;
  verdict.excess = error / BoundOfT<Real>(glyph, t, sizeInT);

  // At an apex there is no normal.
  const double cosine = std::abs(glm::dot(glm::normalize(glm::dvec3(ray.direction)), ToDouble(crossing.normal)));
  verdict.distanceExcess = (std::isnan(cosine) ? 1.0 : cosine) * error /
    (boundUlps * UlpOf<Real>(t) + boundSizes * relativeRoundoff<Real> * sizeInT);

  verdict.hasNormal = crossing.edgeDistance > edgeBand && crossing.edgeSizes > edgeBandSizes;
  const glm::dvec3 normal = ToDouble(crossing.normal);
  verdict.radians = glm::length(glm::cross(normal, answer.normal));
  if (glm::dot(normal, answer.normal) <= 0.0)
  {
    verdict.radians = std::numbers::pi - verdict.radians;
  }
  verdict.normalExcess = verdict.radians / (boundRadians * relativeRoundoff<Real>);
}

} // namespace

template <class Real>
Verdict Judge(ReferenceGlyph& glyph, const std::vector<ReferenceCrossing>& exact, const HardRay& ray, double tMin,
  const Answer& answer)
{
  const double sizeInT = glyph.Size() / glm::length(glm::dvec3(ray.direction));
  const glm::dvec3 direction = glm::normalize(glm::dvec3(ray.direction));

  // The crossings that may be the first at or after tMin, given the bound on t.
  std::vector<const ReferenceCrossing*> candidates;
  bool mayMiss = true, grazes = false;
  for (const ReferenceCrossing& crossing : exact)
  {
    const double t = double(crossing.t);
    const double bound = BoundOfT<Real>(glyph, t, sizeInT);
    grazes = grazes || std::abs(glm::dot(direction, ToDouble(crossing.normal))) < grazingAngle * relativeRoundoff<Real>;
    if (mayMiss && t >= tMin - bound)
    {
      candidates.push_back(&crossing);
      mayMiss = t <= tMin + bound;
    }
  }

  // The silhouette costs many evaluations of the reference: it is looked for only where something is wrong.
  Verdict verdict;
  verdict.hit = !mayMiss;
  if (!answer.hit || candidates.empty())
  {
    const bool wrong = answer.hit || !mayMiss;
    verdict.nearSilhouette = wrong && SilhouetteWidth(glyph, ray, exact.size()) <= band;
    verdict.excused = verdict.nearSilhouette;
    verdict.falseHit = answer.hit && !verdict.excused;
    verdict.falseMiss = !answer.hit && wrong && !verdict.excused;
    return verdict;
  }
  const auto closest = std::min_element(candidates.begin(), candidates.end(),
    [&](const auto* a, const auto* b) { return fabs(double(a->t - answer.t)) < fabs(double(b->t - answer.t)); });
  CompareHit<Real>(glyph, ray, answer, **closest, verdict);
  const bool wrongT = !(verdict.excess <= 1.0);
  const bool wrongNormal = verdict.hasNormal && !(verdict.normalExcess <= 1.0);
  if (wrongT || wrongNormal)
  {
    const double width = SilhouetteWidth(glyph, ray, exact.size());
    verdict.nearSilhouette = width <= band;
    const bool nothing = grazes || width <= bandOfT;
    const bool noNormal = nothing || (wrongNormal && width <= band);
    verdict.excused = nothing || noNormal;
    verdict.bothHit = !nothing;
    verdict.hasNormal = verdict.hasNormal && !noNormal;
  }
  return verdict;
}

double Quantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto at =
    values.begin() + std::ptrdiff_t(std::min(values.size() - 1, std::size_t(share * double(values.size()))));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

CaseReport Summarise(const std::vector<Verdict>& verdicts)
{
  CaseReport report;
  std::vector<double> ulps, sizes, radians;
  for (const Verdict& verdict : verdicts)
  {
    ++report.rays;
    report.hits += verdict.hit;
    report.excused += verdict.excused;
    report.falseHits += verdict.falseHit;
    report.falseMisses += verdict.falseMiss;
    report.wrongSides += verdict.wrongSide;
    if (verdict.bothHit)
    {
      ++report.compared;
      ulps.push_back(verdict.ulps);
      sizes.push_back(verdict.sizes);
      report.outOfBound += !(verdict.excess <= 1.0);
      report.maxExcess = Largest(report.maxExcess, verdict.excess);
      report.maxDistanceExcess = Largest(report.maxDistanceExcess, verdict.distanceExcess);
    }
    if (verdict.bothHit && verdict.hasNormal)
    {
      radians.push_back(verdict.radians);
      report.normalsOutOfBound += !(verdict.normalExcess <= 1.0);
      report.maxNormalExcess = Largest(report.maxNormalExcess, verdict.normalExcess);
    }
  }
  const auto maximum = [](const std::vector<double>& values)
  { return std::accumulate(values.begin(), values.end(), 0.0, Largest); };
  report.medianUlps = Quantile(ulps, 0.5);
  report.maxUlps = maximum(ulps);
  report.medianSizes = Quantile(sizes, 0.5);
  report.maxSizes = maximum(sizes);
  report.medianRadians = Quantile(radians, 0.5);
  report.maxRadians = maximum(radians);
  return report;
}

ReferenceCase::ReferenceCase(HardCase hard)
  : hard_(std::move(hard))
{
  for (std::uint32_t i = 0; i < this->hard_.instances.Count(); ++i)
  {
    this->glyphs_.emplace_back(this->hard_.instances, i);
  }
  for (const HardRay& ray : this->hard_.rays)
  {
    this->crossings_.push_back(this->glyphs_[ray.glyph].Crossings(ray.origin, ray.direction));
  }
}

std::optional<bool> ReferenceCase::StartsInside(std::size_t ray) const
{
  const HardRay& hardRay = this->hard_.rays[ray];
  const double rounding = 1e-5 * this->glyphs_[hardRay.glyph].Size() / glm::length(glm::dvec3(hardRay.direction));
  bool inside = false;
  for (const ReferenceCrossing& crossing : this->crossings_[ray])
  {
    const double t = double(crossing.t);
    if (std::abs(t) <= rounding)
    {
      return {};
    }
    inside = inside != (t < 0.0);
  }
  return inside;
}

template <class Real>
Verdict ReferenceCase::Judge(std::size_t ray, const Answer& answer)
{
  const HardRay& hardRay = this->hard_.rays[ray];
  return testing::Judge<Real>(this->glyphs_[hardRay.glyph], this->crossings_[ray], hardRay, 0.0, answer);
}

template <class Real>
std::vector<Verdict> JudgeKernel(ReferenceCase& reference)
{
  using Kernel = shapes::Kernel<Real>;
  const HardCase& hard = reference.Hard();
  std::vector<Verdict> verdicts;
  verdicts.reserve(hard.rays.size());
  std::uint32_t index = ~0u;
  typename Kernel::Glyph glyph{};
  for (std::size_t i = 0; i < hard.rays.size(); ++i)
  {
    const HardRay& ray = hard.rays[i];
    if (ray.glyph != index)
    {
      index = ray.glyph;
      glyph = KernelGlyph<Real>(hard.instances, index);
    }
    const typename Kernel::GlyphRay kernelRay = KernelRay<Real>(ray);
    Answer answer;
    const typename Kernel::GlyphHit hit =
      Kernel::IntersectGlyph(hard.instances.shape, kernelRay, glyph, Real(0), Real(1e30), false);
    answer.hit = hit.found;
    answer.t = double(hit.t);
    if (answer.hit)
    {
      answer.normal = glm::dvec3(Kernel::GlyphNormal(hard.instances.shape, kernelRay, glyph, hit.t));
    }
    Verdict verdict = reference.Judge<Real>(i, answer);
    const std::optional<bool> inside = reference.StartsInside(i);
    // From inside the next crossing may be missed near a silhouette, from outside the surface is entered anyhow.
    verdict.wrongSide = hit.found && inside && hit.leaves != *inside && !(*inside && verdict.nearSilhouette);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

template Verdict
Judge<float>(ReferenceGlyph&, const std::vector<ReferenceCrossing>&, const HardRay&, double, const Answer&);
template Verdict
Judge<double>(ReferenceGlyph&, const std::vector<ReferenceCrossing>&, const HardRay&, double, const Answer&);
template Verdict ReferenceCase::Judge<float>(std::size_t, const Answer&);
template Verdict ReferenceCase::Judge<double>(std::size_t, const Answer&);
template std::vector<Verdict> JudgeKernel<float>(ReferenceCase&);
template std::vector<Verdict> JudgeKernel<double>(ReferenceCase&);

} // namespace rtg::testing
