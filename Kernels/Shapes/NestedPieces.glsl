// Rays and superquadrics with two profiles (NestedSuperquadric.glsl), or with one that is not convex.
//
// Inside one octant x / Rx along the ray has at most one extremum, at z^(1-q) = (z x' - x z') / x', and so
// has y / Ry. The chord is cut there and at the three coordinate planes, whose order double words tell: at most twelve
// pieces, on each of which both quotients are monotone. What a window [a, b] of a piece holds is known from its ends
// (NestedLook):
//   - Both quotients rise or both fall, or one is all there is: their p-norm N is monotone, and has one crossing or
//   none.
//   - N lies between the p-norms of the smaller and of the larger quotients at the ends: all outside, or all inside.
//   - The slope of N^p / p is |x|^(p-1) Rx^-p x' + (x / Rx)^p fall z' and the same of y, whose factors are monotone, so
//     that the ends bound it: N may be monotone, or lines from the ends tell that it does not come near 1.
// Else it is cut where those lines leave room. Every value comes with a bound of its rounding, and what is less than
// that, a sign at a window's end or a window in which N touches 1 within rounding, is left to double words. Nothing is
// sampled; windows in which all coordinates and quotients change by less than 0.4 % (for sharp edges: less than the
// rounding of the edge) count as having one extremum at most. A crossing is bracketed and found by Chandrupatla's
// method (Advances in Engineering Software 28(3), 1997), which never leaves its bracket. Probes are counted: 3 on
// average, above RTG_NESTED_BUDGET only for rays that lie within rounding of the surface all along.
#ifndef RTG_NESTED_PIECES
#define RTG_NESTED_PIECES

#include "NestedProbe.glsl"
#include "NestedWords.glsl"

#define RTG_NESTED_BUDGET 1024

// What is known of a window.
#define RTG_NESTED_EMPTY 0
#define RTG_NESTED_UNIQUE 1 // it has one crossing, which plain arithmetic finds
#define RTG_NESTED_SETTLE 2 // only double words can tell
#define RTG_NESTED_SPLIT 3  // at `next`

RTG_FN int NestedLook(NestedForm form, NestedProbe a, NestedProbe b, real3 towards, RTG_OUT(real) next)
{
  real way = a.outside ? real(1.0) : real(-1.0);
  bool changes = a.outside != b.outside;
  int unique = changes ? RTG_NESTED_UNIQUE : RTG_NESTED_EMPTY;
  real width = Subtract(b.where, a.where).hi;
  bool narrow = !(width > real(64.0 * RTG_ROUNDOFF));
  real noise = a.noise + b.noise;
  next = a.where.hi;

  real2 rises = b.logs - a.logs;
  real2 doubts = a.doubts + b.doubts;
  bool together = abs(rises.x) > doubts.x && abs(rises.y) > doubts.y && (rises.x > real(0.0)) == (rises.y > real(0.0));
  // One of the quotients is all there is.
  real apart =
    max(min(a.logs.x, b.logs.x) - max(a.logs.y, b.logs.y), min(a.logs.y, b.logs.y) - max(a.logs.x, b.logs.x));
  bool alone = form.p * (apart - max(doubts.x, doubts.y)) > real(60.0);
  if ((together || alone) && !narrow)
  {
    return unique;
  }
  real bound = a.outside ? LogNorm(form, min(a.logs - a.doubts, b.logs - b.doubts))
                         : -LogNorm(form, max(a.logs + a.doubts, b.logs + b.doubts));
  if (!changes && bound > real(32.0 * RTG_ROUNDOFF))
  {
    return RTG_NESTED_EMPTY;
  }
  if (narrow)
  {
    return RTG_NESTED_SETTLE;
  }

  // Over the largest term, so that nothing that counts under- or overflows; f' = slope 2^(p (most - f)) with least <= f
  real2 largest = max(a.logs, b.logs);
  real most = max(largest.x, largest.y);
  real least = LogNorm(form, min(a.logs, b.logs));
  real2 heights = real2(a.height, b.height);
  real2 slopes =
    NestedSlopeOfTerm(form.p, most, real2(a.lows.x, b.lows.x), real2(a.logs.x, b.logs.x), real2(a.falls.x, b.falls.x),
      heights, form.steepAt.x, form.leastFall.x, real2(a.doubts.x, b.doubts.x), towards.x, towards.z) +
    NestedSlopeOfTerm(form.p, most, real2(a.lows.y, b.lows.y), real2(a.logs.y, b.logs.y), real2(a.falls.y, b.falls.y),
      heights, form.steepAt.y, form.leastFall.y, real2(a.doubts.y, b.doubts.y), towards.y, towards.z);
  real low = real(1.4426950408889634074) * (a.outside ? slopes.x : -slopes.y);
  real high = real(1.4426950408889634074) * (a.outside ? slopes.y : -slopes.x);
  if (low >= real(0.0) || high <= real(0.0))
  {
    return unique;
  }
  real stretch = form.p * (most - least);
  stretch = stretch < real(60.0) ? exp2(stretch) : real(1e18);
  low *= stretch;
  high *= stretch;

  // Lines below way f from both ends.
  real fa = max(way * a.f - a.noise, real(0.0));
  real fb = max(way * b.f - b.noise, real(0.0));
  real left = max(a.where.hi, a.where.hi - fa / low);
  real right = changes ? b.where.hi : min(b.where.hi, b.where.hi - fb / high);
  if (!changes && left >= right)
  {
    return RTG_NESTED_EMPTY;
  }
  real meet = (fa + high * width - fb) / (high - low);
  real depth = changes ? max(abs(a.f), abs(b.f)) : -(fa + low * meet);
  next = real(0.5) * (left + right);
  // So short that nothing but one extremum is in it.
  real3 change = real3(abs(rises.x), abs(rises.y), abs(b.height - a.height) / max(a.height, b.height));
  bool tiny =
    depth <= real(4.0) * noise && max(change.x, max(change.y, change.z)) < real(0.004) + real(0.0004) * form.p;
  return tiny || !(next > a.where.hi) || !(next < b.where.hi) ? RTG_NESTED_SETTLE : RTG_NESTED_SPLIT;
}

// `unit` is the ray with a direction of length one to two, its start zero; s counts in its lengths, `scale` of them are
// one of the ray's.
RTG_FN NestedCrossing NestedPieces(
  NestedForm form, LocalRay ray, LocalRay unit, real scale, real sIn, real sOut, real tMin, real tMax)
{
  NestedCrossing crossing = NoCrossing(ray);
  real3 o = unit.origin.hi;
  real3 d = unit.direction.hi;
  NestedPlanes planes = MakeNestedPlanes(unit);

  // The window is [a, b], its piece ends at `end`.
  NestedProbe a = NestedProbeAt(form, o, d, Word(sIn), -1);
  a.outside = true;
  NestedProbe end = a;
  NestedProbe b = a;
  NestedProbe beyond = a; // where the window ended before it was split
  int octant = -1;
  DoubleWord octantEnd = Word(sIn);
  int octantAxis = -1;
  real turnLow = sIn;
  real turnHigh = sIn;
  real3 towards = d;
  bool newPiece = true;
  bool resumes = false;
  DoubleWord next = Word(sIn);
  for (int step = 0; step < RTG_NESTED_BUDGET; ++step)
  {
    int axis = -1;
    if (newPiece)
    {
      if (!IsLess(end.where, octantEnd))
      {
        // On to the next octant
        do
        {
          ++octant;
          octantAxis = octant == 0 ? planes.first : octant == 1 ? planes.second : octant == 2 ? planes.third : -1;
          octantEnd = octant < 3 ? PlaneOf(planes, octantAxis) : Word(sOut);
        } while (octant < 3 && !(IsLess(end.where, octantEnd) && octantEnd.hi < sOut));
        if (octant > 3 || !IsLess(end.where, octantEnd))
        {
          return crossing;
        }
        real3 m = o + (real(0.5) * (end.where.hi + octantEnd.hi)) * d;
        real3 signs = real3(m.x < real(0.0) ? real(-1.0) : real(1.0), m.y < real(0.0) ? real(-1.0) : real(1.0),
          m.z < real(0.0) ? real(-1.0) : real(1.0));
        real3 v = signs * o;
        towards = signs * d;
        real turnX = NestedExtremum(v.x, towards.x, v.z, towards.z, form.q, sIn);
        real turnY = NestedExtremum(v.y, towards.y, v.z, towards.z, form.r, sIn);
        turnLow = min(turnX, turnY);
        turnHigh = max(turnX, turnY);
      }
      real turn = turnLow > end.where.hi ? turnLow : turnHigh;
      bool turns = turn > end.where.hi && turn < octantEnd.hi;
      next = octantEnd;
      if (turns)
      {
        next = Word(turn);
      }
      axis = turns ? -1 : octantAxis;
    }

    // A probe, and for certain whether it is outside
    NestedProbe probe = NestedProbeAt(form, o, d, next, axis);
    if (!(abs(probe.f) > probe.noise))
    {
      probe.outside = NestedProfileAt(form, RayFrom(unit, next, axis)).value.hi > real(0.0);
    }
    probe.outside = probe.outside || (octant == 3 && axis == -1 && next.hi == sOut);
    if (resumes)
    {
      probe.outside = !a.outside;
      a = probe;
    }
    else
    {
      b = probe;
      if (newPiece)
      {
        end = probe;
        beyond = probe;
      }
    }
    newPiece = false;
    resumes = false;

    bool looking = true;
    while (looking)
    {
      real split;
      int verdict = NestedLook(form, a, b, towards, split);
      looking = false;
      if (verdict == RTG_NESTED_SPLIT)
      {
        next = Word(split);
        beyond = b;
      }
      else
      {
        bool changes = a.outside != b.outside;
        bool crosses = false;
        if (verdict != RTG_NESTED_EMPTY)
        {
          real way = a.outside ? real(1.0) : real(-1.0);
          real width = Subtract(b.where, a.where).hi;
          LocalRay base;
          real from = real(0.0);
          if (verdict == RTG_NESTED_UNIQUE)
          {
            real least = real(RTG_NESTED_TINY);
            real fa = a.outside ? max(a.f, least) : min(a.f, -least);
            real fb = b.outside ? max(b.f, least) : min(b.f, -least);
            from = NestedBracketed(form, o, d, a.where.hi, fa, b.where.hi, fb) - a.where.hi;
          }
          else
          {
            from = real(0.5) * width;
          }
          from = max(real(0.0), min(width, from));
          base = Advance(RayFrom(unit, a.where, a.axis), from);
          LocalRay at;
          crosses = NestedSettle(form, base, -from, width - from, way, changes, at) || changes;
          if (crosses)
          {
            DoubleWord s;
            s.hi = scale * at.start.hi;
            s.lo = scale * at.start.lo;
            real t = RayParameter(ray, s).hi;
            if (t >= tMin)
            {
              crossing.found = t <= tMax;
              crossing.t = t;
              crossing.at = at;
              return crossing;
            }
            if (!changes)
            {
              // It touched before tMin: the other crossing is still to come.
              resumes = true;
              next = at.start;
            }
          }
        }
        if (!resumes)
        {
          a = b;
          newPiece = !IsLess(b.where, end.where);
          b = beyond;
          beyond = end;
          looking = !newPiece;
        }
      }
    }
  }
  return crossing;
}

#endif
