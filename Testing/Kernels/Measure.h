// Compares one answer of a kernel or of the pipeline with the reference.
#pragma once

#include "HardCases.h"
#include "Reference.h"

#include <limits>
#include <optional>
#include <vector>

namespace rtg::testing
{

/// What a kernel says of one ray.
struct Answer
{
  bool hit = false;
  double t = 0.0;
  glm::dvec3 normal{ 0.0 };
};

/// Half the width of the band around the silhouette in which hit or miss are both accepted, in glyph sizes.
/// A ray is in the band when the number of times its line crosses the surface changes as the glyph's scale
/// changes by 2 band (ReferenceGlyph::Crossings): no point of the surface moves by more than `band`
/// glyph sizes, and a thin glyph's sides move by `band` of its thickness only.
constexpr double band = 1e-5;

/// Where t is not compared although both hit: within 1e-9 of the scale of a silhouette, also of one inside
/// the outline (an arrow's head before its shaft), or on a surface met at less than this angle (float; for
/// double it shrinks with the roundoff). Double words resolve the surface to about 5 u^2 = 2e-14 glyph
/// sizes, which is 1e-6 sizes along a ray at 2e-8 radians; such a ray stays within 2e-8 glyph sizes of
/// that surface all along the glyph.
constexpr double bandOfT = 1e-9;
constexpr double grazingAngle = 2e-8;

/// Normals are compared where the nearest edge or apex is at least this far away in the unit form, and also
/// in glyph sizes: about as much as t may be wrong by.
constexpr double edgeBand = 1e-4;
constexpr double edgeBandSizes = 2e-6;

/// The bound on t: ulps of t, and glyph sizes in float arithmetic; for double it shrinks with the roundoff.
constexpr double boundUlps = 8.0;
constexpr double boundSizes = 1e-6;
/// Of polynomials: a thin one has lobes before lobes, whose silhouettes double words resolve to 1e-8 of its thickness.
/// That is along the ray: from its surface, too, the point found lies no farther than with other shapes, which is what
/// rays that leave it rely on (Programs/surface.glsl).
constexpr double boundSizesOfPolynomials = 1e-5;

/// The bound on the normal's angle in float arithmetic; for double it shrinks with the roundoff.
constexpr double boundRadians = 4e-6;

template <class Real>
constexpr double
  relativeRoundoff = double(std::numeric_limits<Real>::epsilon()) / double(std::numeric_limits<float>::epsilon());

/// A crossing within the bound of tMin is accepted and may be missed.
struct Verdict
{
  bool hit = false;     ///< of the reference
  bool excused = false; ///< something is beyond its bound, but so near a silhouette that it does not count
  bool falseHit = false, falseMiss = false; ///< outside the band only
  bool nearSilhouette = false;              ///< something is beyond its bound, and the ray is in the band
  bool wrongSide = false;      ///< said to be left where it is entered, or entered where it is left, also in the band
  bool bothHit = false;        ///< and t is compared
  double t = 0.0;              ///< of the reference's crossing
  double ulps = 0.0;           ///< |dt| in ulps of t
  double sizes = 0.0;          ///< |dt| in glyph sizes
  double excess = 0.0;         ///< |dt| over the bound: at most 1
  double distanceExcess = 0.0; ///< of the point found from the surface, likewise
  bool hasNormal = false;      ///< the normal is compared: not near an edge, nor excused
  double radians = 0.0;        ///< error of the normal
  double normalExcess = 0.0;   ///< the same over its bound
};

/// `Real` is the arithmetic whose ulps count. The ray's range is [tMin, infinity). `exact` is what
/// glyph.Crossings() gives for the ray.
template <class Real>
Verdict Judge(ReferenceGlyph& glyph, const std::vector<ReferenceCrossing>& exact, const HardRay& ray, double tMin,
  const Answer& answer);

extern template Verdict
Judge<float>(ReferenceGlyph&, const std::vector<ReferenceCrossing>&, const HardRay&, double, const Answer&);
extern template Verdict
Judge<double>(ReferenceGlyph&, const std::vector<ReferenceCrossing>&, const HardRay&, double, const Answer&);

/// A hard case with the reference's crossings. The reference costs more than a kernel: found once, the
/// crossings judge several arithmetics.
class ReferenceCase
{
public:
  explicit ReferenceCase(HardCase hard);

  const HardCase& Hard() const { return this->hard_; }

  /// The answer to the ray of that number in Hard().rays.
  template <class Real>
  Verdict Judge(std::size_t ray, const Answer& answer);

  /// Whether a ray starts inside its glyph; none where that is within rounding.
  std::optional<bool> StartsInside(std::size_t ray) const;

private:
  HardCase hard_;
  std::vector<ReferenceGlyph> glyphs_;
  std::vector<std::vector<ReferenceCrossing>> crossings_; ///< of each ray
};

extern template Verdict ReferenceCase::Judge<float>(std::size_t, const Answer&);
extern template Verdict ReferenceCase::Judge<double>(std::size_t, const Answer&);

/// Summary of a case: medians and maxima over rays where both hit, counts over all.
struct CaseReport
{
  std::size_t rays = 0, hits = 0, excused = 0, compared = 0, falseHits = 0, falseMisses = 0, wrongSides = 0,
              outOfBound = 0, normalsOutOfBound = 0;
  double medianUlps = 0, maxUlps = 0, medianSizes = 0, maxSizes = 0, maxExcess = 0, maxDistanceExcess = 0;
  double medianRadians = 0, maxRadians = 0, maxNormalExcess = 0;
};

CaseReport Summarise(const std::vector<Verdict>& verdicts);

/// The value below which that fraction of them lies, in [0, 1]; 0 of none.
double Quantile(std::vector<double> values, double share);

/// All rays of a case through the C++ kernel.
template <class Real>
std::vector<Verdict> JudgeKernel(ReferenceCase& reference);

extern template std::vector<Verdict> JudgeKernel<float>(ReferenceCase&);
extern template std::vector<Verdict> JudgeKernel<double>(ReferenceCase&);

} // namespace rtg::testing
