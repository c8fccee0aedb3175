// The solver of implicit surfaces (ImplicitSurface.glsl), included once for each family: RTG_FIELD is f along one ray,
// RTG_PROBE its value at one point in plain arithmetic, with at least
//   DoubleWord where; int axis (of the coordinate plane that the point is on, else -1); bool outside;
//   real f, slope, error (bound of the rounding of f); TaylorError taylor.
//
// Isolation. NextBreak cuts the ray into pieces, and each piece is searched in windows [a, b]. Outside the glyph f > 0;
// inside, the same holds for -f. Straight lines below it through both ends leave of a window what lies between their
// zeros; if that is nothing, there is no crossing: that is proven, nothing is sampled. For a convex f the line at a is
// Newton's, which never passes the first crossing. Where the signs at a and b differ and the family proves that there
// is but one crossing, that is it. Else the window is cut where the bounds are loosest. What is less than
// rounding, a sign at the end of a window or a window in which f touches zero, is left to double words.
//
// Solution. Newton's method inside a bracket of certain signs, with bisection where it leaves the bracket or stalls.
// The last steps are done in double words: f is then known to about 1e-13, which a grazing ray wants.
//
// Why it cannot loop: each iteration evaluates f or removes a window, and evaluations are counted. Behind the last one
// the signs at the ends of what is left of a piece decide. Why it cannot invent hits: a crossing needs a certain change
// of sign, or the last steps must find its root in double words.

// Where the search along a ray stands.
struct RTG_SEARCH
{
  RTG_PROBE a;      // no crossing is left before it
  RTG_PROBE b;      // end of the window
  RTG_PROBE beyond; // its end before it was cut
  RTG_PROBE end;    // of the piece
  real low;         // the crossing is between these, which count from a on
  real high;
  real near;    // close to it
  bool resumes; // the other crossing of a window is left: `from` lies between them
  DoubleWord from;
  int steps;
};

RTG_FN RTG_SEARCH StartSearch(const RTG_FIELD field, const Chord chord)
{
  RTG_PROBE start = ProbeAt(field, Word(chord.sIn), -1);
  start.outside = true;
  return RTG_SEARCH(start, start, start, start, real(0.0), real(0.0), real(0.0), false, Word(chord.sIn), 1);
}

// On to the window behind this one.
RTG_FN RTG_SEARCH NextWindow(const RTG_SEARCH search)
{
  RTG_SEARCH next = search;
  next.a = search.b;
  next.b = search.beyond;
  next.beyond = search.end;
  return next;
}

// Crossings in a window. next: where to search, from a on. exhausted: no evaluations are left, the signs at its ends
// decide.
RTG_FN int
Classify(const RTG_FIELD field, const RTG_PROBE a, const RTG_PROBE b, const bool exhausted, RTG_OUT(real) next)
{
  real sign = a.outside ? real(1.0) : real(-1.0);
  bool changes = a.outside != b.outside;
  real width = Subtract(b.where, a.where).hi;
  bool narrow = !(width > real(64.0 * RTG_ROUNDOFF));
  next = real(0.5) * width;
  if (exhausted)
  {
    return changes ? RTG_SETTLE : RTG_EMPTY;
  }
  Window window = WindowOf(field, a, b, sign, max(width, real(RTG_TINY)));

  // Lowered by the rounding of f: what is empty is certain to be.
  real fa = max(sign * a.f - a.error, real(0.0));
  real fb = max(sign * b.f - b.error, real(0.0));
  real left = window.slopeA < real(0.0) ? -fa / window.slopeA : real(0.0);
  real right = !changes && window.slopeB > real(0.0) ? width - fb / window.slopeB : width;
  bool empty = window.empty || window.slopeA >= real(0.0) || window.slopeB <= real(0.0) || left >= right;
  if (changes ? window.unique && !narrow : empty)
  {
    // Newton's point where that is certain not to pass the crossing, else the secant's
    real least = real(RTG_TINY); // both values may be zero
    real fraction = (abs(a.f) + least) / (abs(a.f) + abs(b.f) + real(2.0) * least);
    real secant = width * clamp(fraction, real(0.0625), real(0.9375));
    next = window.convex && left > real(0.0) && left < width ? left : secant;
    return changes ? RTG_UNIQUE : RTG_EMPTY;
  }
  if (narrow)
  {
    return RTG_SETTLE;
  }
  real meet = (fa + window.slopeB * width - fb) / (window.slopeB - window.slopeA);
  // Where both ends are within rounding, cutting gives no new bound, however deep the lines let f go in between.
  real depth = max(abs(a.f), abs(b.f));
  depth = changes ? depth : min(depth, -(fa + window.slopeA * meet));
  real middle = real(0.5) * (left + right);
  bool settles = (window.single && depth <= real(4.0) * (a.error + b.error)) || !(middle > real(0.0) && middle < width);
  // What is left at one end the slopes of the whole window leave there: cut there, it would shrink to where no number
  // lies between the ends.
  bool inside = min(middle, width - middle) > real(0.0625) * width;
  next = settles ? next : inside ? middle : real(0.5) * width;
  return settles ? RTG_SETTLE : RTG_SPLIT;
}

// Walks to the next window that has a crossing, or may have one that only double words resolve. Each step evaluates f
// once or removes a window.
RTG_FN bool NextRoot(const RTG_FIELD field, const Chord chord, RTG_SEARCH search, RTG_OUT(RTG_SEARCH) after)
{
  bool solving = false;
  bool found = false;
  bool more = true;
  int iterations = 0;
  while (more && search.steps < RTG_STEPS + RTG_PIECES)
  {
    bool newPiece = !search.resumes && !solving && !IsLess(search.a.where, search.end.where);
    bool probes = true;
    DoubleWord next = search.from;
    int axis = -1;
    bool exhausted = search.steps >= RTG_STEPS;
    if (newPiece)
    {
      more = search.a.where.hi < chord.sOut;
      next = NextBreak(field, search.a.where, axis);
    }
    else if (!search.resumes)
    {
      if (!solving)
      {
        if (exhausted)
        {
          search.b = search.end;
          search.beyond = search.end;
        }
        real where;
        int verdict = Classify(field, search.a, search.b, exhausted, where);
        probes = verdict == RTG_UNIQUE || verdict == RTG_SPLIT;
        solving = verdict == RTG_UNIQUE;
        found = verdict == RTG_SETTLE;
        more = !found;
        search.low = real(0.0);
        search.high = Subtract(search.b.where, search.a.where).hi;
        search.near = where;
        if (verdict == RTG_SPLIT)
        {
          search.beyond = search.b;
        }
        if (verdict == RTG_EMPTY)
        {
          search = NextWindow(search);
        }
      }
      next = Word(Add(search.a.where, search.near).hi);
    }
    if (more && probes)
    {
      RTG_PROBE probe = ProbeAt(field, next, axis);
      ++search.steps;
      bool uncertain = !(abs(probe.f) > probe.error);
      if (solving)
      {
        real sign = search.a.outside ? real(1.0) : real(-1.0);
        real side = uncertain ? real(0.0) : sign * probe.f;
        search.low = side > real(0.0) ? search.near : search.low;
        search.high = side < real(0.0) ? search.near : search.high;
        real step = -probe.f / probe.slope;
        bool falls = sign * probe.slope < real(0.0);
        found = uncertain || exhausted || !(search.high - search.low > real(64.0 * RTG_ROUNDOFF)) ||
          (falls && TaylorRemainder(probe.taylor, step) <= field.accuracy * abs(probe.slope));
        more = !found;
        ++iterations;
        real stepped = search.near + step;
        bool inside = stepped > search.low && stepped < search.high && (iterations < 8 || (iterations & 1) == 0);
        real middle = real(0.5) * (search.low + search.high);
        search.near = found ? search.near : inside ? stepped : middle;
      }
      else
      {
        if (uncertain)
        {
          probe = WithSign(field, chord.unit, probe);
        }
        probe.outside = probe.outside || next.hi == chord.sOut;
        if (search.resumes)
        {
          probe.outside = !search.a.outside;
          search.a = probe;
          search.resumes = false;
        }
        else
        {
          search.b = probe;
        }
        if (newPiece)
        {
          search.beyond = probe;
          search.end = probe;
        }
      }
    }
  }
  after = search;
  return found;
}

// The zero of f on a part of the ray, `low` to `high` from its origin, in double words. At `low` f times the sign
// `sign` is positive. `changes`: at high it is not, and the zero is Newton's, by a parabola where the second derivative
// is known, or, where that leaves the bracket or stalls, bisection's. Else the least of f is searched by its slopes,
// which change their sign once. False: there is none. Where it is wanted, the gradient is that at the zero: one more
// evaluation. With `changes` f may rise only where the window has two extrema: then the part before is searched for its
// least, too.
RTG_FN bool Settle(const RTG_FIELD field, const LocalRay ray, real low, real high, const real sign, const bool changes,
  const bool wantsGradient, RTG_OUT(LocalRay) at, RTG_OUT(real3) gradient)
{
  bool root = changes;
  bool mayRise = changes;
  bool searchesPart = false;
  real end = high; // of the bracket while a part is searched
  bool more = true;
  bool settled = false;
  real slopeLow = real(0.0);
  real slopeHigh = real(0.0);
  at = ray;
  gradient = real3(real(0.0));
  for (int i = 0; i < 64 && more; ++i)
  {
    ImplicitPoint point = PointAt(field, at);
    gradient = point.gradient;
    real f = sign * (point.value.hi + point.value.lo);
    real slope = sign * point.slope;
    real second = sign * point.second;
    if (mayRise && !settled && f > real(0.0) && slope > real(0.0))
    {
      mayRise = false;
      searchesPart = true;
      root = false;
      end = high;
    }
    root = root || f <= real(0.0);
    real step = real(0.0);
    if (settled)
    {
      more = false;
    }
    else if (root)
    {
      low = f > real(0.0) ? real(0.0) : low;
      high = f > real(0.0) ? high : real(0.0);
      // The root of f + slope x + second x^2 / 2 where that falls
      real discriminant = slope * slope - real(2.0) * second * f;
      real fall = sqrt(max(discriminant, real(0.0)));
      step = slope < real(0.0) ? real(2.0) * f / (fall - slope) : -(slope + fall) / second;
      bool newton = discriminant >= real(0.0) && (slope < real(0.0) || second > real(0.0)) && abs(f) < real(0.5);
      settled = newton &&
        (abs(step) <= real(1e-3) * point.accuracy || TaylorRemainder(point.taylor, step) <= point.accuracy * fall);
      bool inside = newton && step >= low && step <= high && (i < 12 || (i & 1) == 0);
      if (!settled && !inside)
      {
        step = real(0.5) * (low + high);
        settled = !(high - low > field.accuracy);
      }
      more = !settled || wantsGradient;
    }
    else
    {
      bool falls = slope < real(0.0);
      low = falls ? real(0.0) : low;
      slopeLow = falls ? slope : slopeLow;
      high = falls ? high : real(0.0);
      slopeHigh = falls ? slopeHigh : slope;
      // The tangent of a convex function stays below it.
      real rest = falls ? high : low;
      real curvature = high - low < field.convexWidth
        ? real(0.0)
        : TaylorRemainder(point.taylor, rest) - min(real(0.5) * second, real(0.0)) * rest * rest;
      more = high - low > field.accuracy && !(f - abs(slope * rest) > curvature);
      real fraction = slopeLow < real(0.0) && slopeHigh > real(0.0) && (i & 3) != 3
        ? max(real(0.02), min(real(0.98), slopeLow / (slopeLow - slopeHigh)))
        : real(0.5);
      if (!more && searchesPart)
      {
        more = true;
        searchesPart = false;
        root = true;
        fraction = real(0.5);
        low = high;
        high = end;
      }
      step = more ? low + fraction * (high - low) : real(0.0);
    }
    at = Advance(at, step);
    end -= step;
    low -= step;
    high -= step;
  }
  return root;
}

// The nearest crossing in [tMin, tMax].
RTG_FN SurfaceCrossing RTG_CROSSING(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsGradient)
{
  Chord chord;
  bool near = ToChord(ray, glyph, tMin, tMax, chord);
  SurfaceCrossing crossing = NoSurfaceCrossing(chord.ray);
  if (!near)
  {
    return crossing;
  }
  RTG_FIELD field = RTG_MAKE_FIELD(chord, glyph.exponents);
  RTG_SEARCH search = StartSearch(field, chord);
  real margin = real(64.0 * RTG_ROUNDOFF) * (chord.sOut - chord.sIn);
  bool more = true;
  while (more)
  {
    more = NextRoot(field, chord, search, search);
    // The crossing lies behind a: beyond tMax there is nothing to gain.
    more = more && RayParameter(chord.ray, Word(chord.scale * (search.a.where.hi + search.low - margin))).hi <= tMax;
    if (more)
    {
      bool changes = search.a.outside != search.b.outside;
      real sign = search.a.outside ? real(1.0) : real(-1.0);
      LocalRay base = Advance(RayFrom(chord.unit, search.a.where, search.a.axis), search.near);
      LocalRay at;
      real3 gradient;
      bool crosses = Settle(
        field, base, search.low - search.near, search.high - search.near, sign, changes, wantsGradient, at, gradient);
      DoubleWord s = DoubleWord(chord.scale * at.start.hi, chord.scale * at.start.lo);
      real t = RayParameter(chord.ray, s).hi;
      more = !(crosses && t >= tMin);
      if (!more)
      {
        crossing = SurfaceCrossing(t <= tMax, !search.a.outside, t, at, gradient, 0);
      }
      else if (crosses && !changes)
      {
        // It touched before tMin: the other crossing is still to come.
        search.resumes = true;
        search.from = at.start;
      }
      else
      {
        search = NextWindow(search);
      }
    }
  }
  crossing.steps = search.steps;
  return crossing;
}

#undef RTG_FIELD
#undef RTG_MAKE_FIELD
#undef RTG_PROBE
#undef RTG_SEARCH
#undef RTG_CROSSING
