// The points p with |p| <= |f(p / |p|)|, f a homogeneous polynomial of even degree k (PolynomialForm.glsl), of which
// |f| <= 1 on the unit sphere, in the frame where the half-lengths are 1; and its affine images.
//
// In the plane of a ray and the center the surface is r = |f(phi)|, and a ray at the distance q crosses it where |h| =
// q, h = cos(phi) f(phi); inside the glyph |h| > q. README.md, Polynomials, has the method and its proof. After C.
// Peters, T. Patel, W. Usher and C. R. Johnson, "Ray Tracing Spherical Harmonics Glyphs", Vision, Modeling, and
// Visualization 2023.

// Evaluations that a ray may take; some tens are usual.
#define RTG_WINDOWS 600
#define RTG_LEAST_DISTANCE 1.0e-9

// Where the search along a ray stands.
struct PolynomialSearch
{
  PlanePoint a; // no crossing is left before it
  bool inside;  // whether the ray is inside behind it
  real2 step;   // cosine and sine of the next window's width
  real width;
  real sign; // of f at the crossing
  real low;  // the crossing is between these, which count along the ray from the point next to the center
  real high;
  real near;
  bool atExtremum; // of h, at `a`
  // Only double words decide whether there is one: `near` is where the surface comes closest and, where it turns back
  // there, else where it goes farthest.
  bool touches;
  bool turnsBack;
  real2 pad;  // how far before and behind its bracket rounding may have put it
  bool known; // `inside` is known at `near`, where the search goes on
  int steps;
};

// A ray in its plane through the center: at `distance` from the center, and where it may be inside.
struct PlaneRay
{
  real distance;
  real start;
  real end;
};

RTG_FN real2 DirectionAt(const PlaneRay ray, const real t)
{
  real2 n = real2(ray.distance, t);
  return n / max(length(n), real(1e-30));
}

// The angle whose sine is given, up to 0.6.
RTG_FN real SmallAngle(const real sine)
{
  real s = sine * sine;
  return sine *
    (real(1.0) + s * (real(1.0 / 6.0) + s * (real(3.0 / 40.0) + s * (real(5.0 / 112.0) + s * real(35.0 / 1152.0)))));
}

// h and its slope at both ends of a window, and Bezier coefficients of the cubic through them.
struct HermiteWindow
{
  real4 value;
  real3 slope;
};

RTG_FN HermiteWindow WindowOf(const PlanePoint a, const PlanePoint b, const real width)
{
  real ha = a.n.x * a.f;
  real hb = b.n.x * b.f;
  real sa = a.n.x * a.slope - a.n.y * a.f;
  real sb = b.n.x * b.slope - b.n.y * b.f;
  real third = width * real(1.0 / 3.0);
  return HermiteWindow(
    real4(ha, ha + third * sa, hb - third * sb, hb), real3(sa, real(3.0) * (hb - ha) / width - sa - sb, sb));
}

// Where the cubic's slope changes its sign, as a fraction of the window.
RTG_FN real ExtremeOf(const HermiteWindow window)
{
  real3 d = window.slope;
  real a = d.x - real(2.0) * d.y + d.z;
  real b = real(2.0) * (d.y - d.x);
  real root = sqrt(max(b * b - real(4.0) * a * d.x, real(0.0)));
  real divisor = d.x > real(0.0) ? root - b : -root - b;
  return divisor != real(0.0) ? clamp(real(2.0) * d.x / divisor, real(0.0), real(1.0)) : real(0.5);
}

#define RTG_PASS 0  // no crossing in the window
#define RTG_CROSS 1 // one
#define RTG_HALVE 2
#define RTG_EXTREMUM 3 // the cubic is h, and has an extremum in the window

// `bound`, `slopeBound`: how far h may be from the cubic. `halves`: too far; `wide`: it may be halved all the same.
RTG_FN int LookAt(const HermiteWindow window, const PolynomialSearch search, const PlanePoint b, const bool endInside,
  const real distance, const real bound, const real slopeBound, const bool halves, const bool wide)
{
  real4 h = window.value;
  real3 d = window.slope;
  // Out of where f has the sign of `a`, or into where it has that of b
  real side = (search.inside ? search.a.f : b.f) < real(0.0) ? real(-1.0) : real(1.0);
  bool crosses = search.inside ? side * h.w < distance : endInside;
  // Where h has an extremum at a, its slope there says nothing.
  bool level = search.atExtremum && abs(d.x) <= slopeBound;
  d.x = level ? d.y : d.x;
  bool monotone = min(d.x, min(d.y, d.z)) > slopeBound || max(d.x, max(d.y, d.z)) < -slopeBound;
  real least = min(min(h.x, h.y), min(h.z, h.w)) - bound;
  real most = max(max(h.x, h.y), max(h.z, h.w)) + bound;
  bool empty = (most < distance && least > -distance) || least > distance || most < -distance;
  if (monotone || empty)
  {
    return crosses ? RTG_CROSS : RTG_PASS;
  }
  bool hasExtremum = d.x * d.z < real(0.0) || (abs(d.x) <= slopeBound && !level) || abs(d.z) <= slopeBound;
  if (halves || (!hasExtremum && wide))
  {
    return RTG_HALVE;
  }
  return hasExtremum ? RTG_EXTREMUM : crosses ? RTG_CROSS : RTG_PASS;
}

// Rounding of f in plain arithmetic: its terms cancel up to 3^(k / 2) times, usually much less.
RTG_FN real PlaneError(const int degree)
{
  real error = real(8.0 / 3.0 * RTG_ROUNDOFF);
  for (int i = 0; i < degree; i += 2)
  {
    error *= real(3.0);
  }
  return error;
}

// Parameter of the point of the ray in that direction
RTG_FN real ParameterOf(const PlaneRay ray, const real2 n, const real otherwise)
{
  return n.x > real(0.0) ? ray.distance * n.y / n.x : otherwise;
}

// The next crossing behind search.near: between search.low and search.high, close to the new search.near.
RTG_FN bool NextCrossing(
  const PlaneForm form, const int degree, const PlaneRay ray, PolynomialSearch search, RTG_OUT(PolynomialSearch) after)
{
  real error = PlaneError(degree);
  real2 end = DirectionAt(ray, ray.end);
  real order = real(degree + 1);
  real fourth = order * order * order * order * form.most;
  real widest = real(1.5707963) / order;
  bool found = false;
  bool resumes = true;
  bool solving = false;
  bool towardExtremum = false;
  bool peak = false; // whether |h| is largest there, not least
  real t = search.near;
  bool more = true;
  while (more && search.steps < RTG_WINDOWS)
  {
    ++search.steps;
    // The next point: the crossing from which to go on, a point of the bracket, or the end of the next window
    real2 n = ComplexProduct(search.a.n, search.step);
    real width = search.width;
    bool last = false;
    if (resumes || solving || towardExtremum)
    {
      n = DirectionAt(ray, t);
    }
    else if (n.x <= real(0.0) || n.x * end.y - n.y * end.x <= real(0.0))
    {
      n = end;
      last = true;
    }
    if (last || towardExtremum)
    {
      width = max(SmallAngle(search.a.n.x * n.y - search.a.n.y * n.x), real(RTG_TINY));
    }
    PlanePoint b = PlaneAt(form, degree, n);
    bool inside = !last && abs(b.n.x * b.f) > ray.distance;
    if (resumes)
    {
      search.a = b;
      search.inside = search.known ? search.inside : inside;
      search.atExtremum = search.touches && (search.turnsBack ? search.near != search.high : true);
      search.touches = false;
      resumes = false;
    }
    else if (solving)
    {
      real radius = length(real2(ray.distance, t));
      real g = radius - search.sign * b.f;
      real slope = n.y - search.sign * b.slope * ray.distance / max(radius * radius, real(RTG_TINY));
      bool before = (g > real(0.0)) != search.inside;
      search.low = before ? t : search.low;
      search.high = before ? search.high : t;
      real step = -g / slope;
      bool inBracket = t + step > search.low && t + step < search.high && (slope < real(0.0)) != search.inside;
      real next = inBracket ? t + step : real(0.5) * (search.low + search.high);
      found = (inBracket && abs(step) * order <= real(1.0e-4) * radius) ||
        !(search.high - search.low > real(4.0 * RTG_ROUNDOFF) * (abs(search.low) + abs(search.high)));
      more = !found;
      search.near = found && !inBracket ? t : next;
      // Next to where the slope vanishes a root moves by the square root of what the value does; the angle changes by
      // n.x / radius.
      search.pad = real2(real(8.0) * error / max(abs(slope), order * sqrt(error) * n.x / max(radius, error)));
      t = next;
    }
    else
    {
      HermiteWindow window = WindowOf(search.a, b, width);
      real cube = width * width * width * fourth;
      real bound = cube * width * real(1.0 / 384.0);
      real rounding = error * max(search.a.n.x, b.n.x);
      bool halves = bound > rounding;
      // Up to its extremum h is monotone.
      real slopeBound =
        towardExtremum ? -real(RTG_NEVER) : real(0.0080188) * cube + error + rounding * (order + real(6.0) / width);
      int verdict = LookAt(
        window, search, b, inside, ray.distance, bound + rounding, slopeBound, halves, order * width > real(0.02));
      bool uncertain = towardExtremum && abs(abs(b.n.x * b.f) - ray.distance) <= real(8.0) * error * b.n.x;
      if (uncertain)
      {
        search.touches = true;
        search.sign = b.f < real(0.0) ? real(-1.0) : real(1.0);
        search.near = t;
        search.turnsBack = peak != search.inside;
        search.high = search.turnsBack ? search.high : t;
        search.pad = search.turnsBack ? search.pad : real2(real(0.0));
        found = true;
        more = false;
      }
      else if (verdict == RTG_HALVE)
      {
        real2 whole = last ? ComplexProduct(n, real2(search.a.n.x, -search.a.n.y)) : search.step;
        real cosine = sqrt(real(0.5) + real(0.5) * whole.x);
        search.step = real2(cosine, real(0.5) * whole.y / cosine);
        search.width = real(0.5) * width;
      }
      else if (verdict == RTG_EXTREMUM)
      {
        real fraction = search.atExtremum ? max(ExtremeOf(window), real(0.5)) : ExtremeOf(window);
        real2 between = (real(1.0) - fraction) * search.a.n + fraction * b.n;
        peak = (window.slope.x > window.slope.z) == (window.value.y + window.value.z > real(0.0));
        search.low = ParameterOf(ray, search.a.n, ray.start);
        search.high = ParameterOf(ray, b.n, ray.end);
        // Half a window, by the angle
        real2 beyond = real(0.5) * (b.n - search.a.n);
        search.pad = real2(search.low - ParameterOf(ray, search.a.n - beyond, ray.start),
          ParameterOf(ray, b.n + beyond, ray.end) - search.high);
        t = ParameterOf(ray, between, real(0.5) * (search.low + search.high));
      }
      else if (verdict == RTG_CROSS)
      {
        solving = true;
        search.sign = (search.inside ? search.a.f : b.f) < real(0.0) ? real(-1.0) : real(1.0);
        search.low = ParameterOf(ray, search.a.n, ray.start);
        search.high = ParameterOf(ray, b.n, ray.end);
        real fraction =
          clamp((search.sign * window.value.x - ray.distance) / (search.sign * (window.value.x - window.value.w)),
            real(0.0625), real(0.9375));
        real2 between = (real(1.0) - fraction) * search.a.n + fraction * b.n;
        t = ParameterOf(ray, between, search.low);
        t = t > search.low && t < search.high ? t : real(0.5) * (search.low + search.high);
      }
      else
      {
        search.a = b;
        search.inside = inside;
        search.atExtremum = towardExtremum;
        more = !last;
        if (search.width < real(0.75) * widest)
        {
          search.width = real(2.0) * search.width;
          search.step = ComplexProduct(search.step, search.step);
        }
      }
      towardExtremum = verdict == RTG_EXTREMUM;
    }
  }
  after = search;
  return found;
}

#define RTG_NONE 0       // no zero, though some point is behind one
#define RTG_ALL_BEFORE 1 // nor that
#define RTG_ZERO 2       // a zero; where the surface comes close, before it does
#define RTG_LATE_ZERO 3  // a zero behind that

// The zero of |p| - sign f along a ray, in double words, close to its parameter `near` and between `low` and `high`.
// Where the surface only comes close there, what is looked for first is where it comes closest, by the slope of
// |f| / |p|, which changes its sign once but for rounding: at last `high` is tried, too, where f may have the other
// sign. `sign` is that of f at the zero.
RTG_FN int SettleCrossing(const Glyph glyph, const LocalRay ray, const PolynomialSearch search, const real near,
  real low, real high, RTG_OUT(LocalRay) at, RTG_OUT(real) sign)
{
  sign = search.sign;
  // Positive before the crossing
  real outward = search.inside ? real(-1.0) : real(1.0);
  real order = real(glyph.degree + 1);
  real bend = order * order * dot(ray.direction.hi, ray.direction.hi);
  real slopeLow = real(0.0);
  real slopeHigh = real(0.0);
  bool wasBefore = search.touches;
  bool wasBehind = false;
  bool found = false;
  bool more = true;
  bool atEnd = false;
  at = Advance(ray, near);
  low -= near;
  high -= near;
  real end = high;
  for (int i = 0; i < 64 && more; ++i)
  {
    FormPoint point = FormAt(glyph, at.origin, false);
    sign = atEnd && !wasBehind && !search.inside ? (point.f.hi < real(0.0) ? real(-1.0) : real(1.0)) : sign;
    real g = outward * Add(point.distance, Multiply(point.f, -sign)).hi;
    real distance = max(point.distance.hi, real(1e-20));
    real slope = outward * dot(at.origin.hi / distance - sign * point.gradient.hi, at.direction.hi);
    bool before = g > real(0.0);
    wasBefore = wasBefore || before;
    wasBehind = wasBehind || !before;
    real step = real(0.0);
    if (search.touches && !wasBehind && (atEnd || !search.turnsBack))
    {
      more = false;
    }
    else if (search.touches && !wasBehind)
    {
      real ratio =
        outward * sign * dot(at.origin.hi * (point.f.hi / (distance * distance)) - point.gradient.hi, at.direction.hi);
      bool falls = ratio < real(0.0);
      low = falls ? real(0.0) : low;
      slopeLow = falls ? ratio : slopeLow;
      high = falls ? high : real(0.0);
      slopeHigh = falls ? slopeHigh : ratio;
      real fraction = slopeLow < real(0.0) && slopeHigh > real(0.0) && (i & 3) != 3
        ? clamp(slopeLow / (slopeLow - slopeHigh), real(0.02), real(0.98))
        : real(0.5);
      step = low + fraction * (high - low);
      // The least is not less than at the nearer end what the slope there takes away.
      real rest = falls ? high : low;
      real curvature = real(0.5) * bend * rest * rest / (distance * distance);
      atEnd = !(high - low > real(1e-7) * distance) || g - abs(slope * rest) > curvature;
      low = atEnd ? real(0.0) : low;
      high = atEnd ? end : high;
      step = atEnd ? end : step;
      more = !atEnd || end > real(0.0);
    }
    else
    {
      low = before ? real(0.0) : low;
      high = before ? high : real(0.0);
      step = -g / slope;
      bool newton = slope < real(0.0) && step >= low && step <= high && (i < 24 || (i & 1) == 0);
      // The error after Newton's step is half the second derivative times its square, over the slope.
      found = newton && step * step * bend <= real(1e-11) * distance * distance * -slope;
      bool narrow = !(high - low > real(1e-11) * distance);
      found = found || (narrow && wasBefore && wasBehind);
      more = !found && !narrow;
      step = newton ? step : real(0.5) * (low + high);
      step = narrow ? real(0.0) : step;
    }
    at = Advance(at, step);
    low -= step;
    high -= step;
    end -= step;
  }
  return found ? (atEnd ? RTG_LATE_ZERO : RTG_ZERO) : wasBehind ? RTG_NONE : RTG_ALL_BEFORE;
}

// Some unit vector at right angles to a unit vector.
RTG_FN real3 Across(const real3 d)
{
  real3 size = abs(d);
  real3 axis = size.x <= size.y && size.x <= size.z ? real3(real(1.0), real(0.0), real(0.0))
    : size.y <= size.z                              ? real3(real(0.0), real(1.0), real(0.0))
                                                    : real3(real(0.0), real(0.0), real(1.0));
  return normalize(cross(d, axis));
}

// The nearest crossing in [tMin, tMax] and the sign of f there. All crossings before it are found anew, so that the
// answer does not depend on the range.
RTG_FN SurfaceCrossing PolynomialCrossing(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, RTG_OUT(real) sign)
{
  sign = real(1.0);
  Chord chord;
  bool near = ToChord(ray, glyph, tMin, tMax, chord);
  SurfaceCrossing crossing = NoSurfaceCrossing(chord.ray);
  if (!near)
  {
    return crossing;
  }
  real3 d = chord.unit.direction.hi;
  real perLength = real(1.0) / length(d);
  d = d * perLength;
  real offset = dot(chord.unit.origin.hi, d);
  real3 foot = chord.unit.origin.hi - offset * d;
  PlaneRay plane;
  plane.distance = length(foot);
  real3 extents = FormExtents(glyph) * real(1.0001) + real3(real(1.0e-5));
  if (plane.distance > real(1.00001) || !BoxChord(foot, d, extents, plane.start, plane.end))
  {
    return crossing;
  }
  int degree = RTG_DEGREE(glyph);
  PlaneForm form = MakePlaneForm(glyph, plane.distance > real(1.0e-20) ? foot / plane.distance : Across(d), d);
  // In plain arithmetic a ray through the center passes it, so that its angles are parameters.
  plane.distance = max(plane.distance, real(RTG_LEAST_DISTANCE));
  form.most = min(form.most, real(1.0)) + real(4.0) * PlaneError(degree);
  if (plane.distance >= form.most)
  {
    return crossing;
  }
  real reach = sqrt((form.most - plane.distance) * (form.most + plane.distance));
  plane.start = max(plane.start, -reach);
  plane.end = min(plane.end, reach);

  // Outside where it starts
  PlanePoint first = PlanePoint(DirectionAt(plane, plane.start), real(0.0), real(0.0));
  PolynomialSearch search = PolynomialSearch(first, false, QuarterStep(degree), real(1.5707963) / real(degree + 1),
    real(1.0), plane.start, plane.start, plane.start, false, false, false, real2(real(0.0)), true, 0);
  real passed = -real(RTG_NEVER); // where the last crossing was
  bool more = plane.start < plane.end;
  while (more)
  {
    more = NextCrossing(form, degree, plane, search, search);
    real low = max(passed, perLength * (search.low - search.pad.x - offset));
    real high = perLength * (search.high + search.pad.y - offset);
    more = more && RayParameter(chord.ray, Word(chord.scale * low)).hi <= tMax;
    if (more)
    {
      // An end before tMin counts as a crossing where plain float is certain.
      int settled = search.touches ? RTG_NONE : RTG_ZERO;
      if (RayParameter(chord.ray, Word(chord.scale * high)).hi >= tMin)
      {
        LocalRay at;
        bool again = true;
        while (again)
        {
          settled = SettleCrossing(glyph, chord.unit, search, perLength * (search.near - offset), low, high, at, sign);
          // Rounding has been taken for a crossing: the surface may still come close, or be crossed later.
          again = settled == RTG_ALL_BEFORE && !search.touches;
          search.high = again ? search.high + search.pad.y : search.high;
          search.turnsBack = again || search.turnsBack;
          search.touches = again || search.touches;
        }
        DoubleWord s = DoubleWord(chord.scale * at.start.hi, chord.scale * at.start.lo);
        real t = RayParameter(chord.ray, s).hi;
        passed = settled >= RTG_ZERO ? at.start.hi : passed;
        if (settled >= RTG_ZERO && t >= tMin)
        {
          more = false;
          crossing = SurfaceCrossing(t <= tMax, search.inside, t, at, crossing.gradient, 0);
        }
      }
      bool crosses = settled >= RTG_ZERO;
      search.near = settled == RTG_ZERO ? search.near : search.high;
      search.known = crosses || search.touches;
      search.inside = search.inside != crosses;
    }
  }
  crossing.steps = search.steps;
  return crossing;
}

// Its box is that of its own extents.
RTG_FN Enclosure PolynomialEnclosure(const Glyph glyph)
{
  Enclosure outer = BoxedEnclosure(glyph);
  real3 extents = FormExtents(glyph);
  outer.halfSize = outer.halfSize * extents;
  outer.radius = min(outer.radius, real(1.000001) / LeastOf(extents));
  return outer;
}

// `sign`: of f there.
RTG_FN real3 PolynomialNormal(const Glyph glyph, const DoubleWord3 at, const real sign)
{
  FormPoint point = FormAt(glyph, at, true);
  real3 outward = Subtract(Divide(at, Word3(point.distance)), Multiply(point.gradient, real3(sign))).hi;
  return normalize(RotateToWorld(glyph, OverSize(glyph, outward)));
}

RTG_FN GlyphHit IntersectPolynomial(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsNormal)
{
  real sign;
  SurfaceCrossing crossing = PolynomialCrossing(ray, glyph, tMin, tMax, sign);
  return GlyphHit(crossing.found, crossing.leaves, crossing.t,
    crossing.found && wantsNormal ? PolynomialNormal(glyph, crossing.at.origin, sign) : -ray.direction);
}

// The sign of f in the direction of a point that is given from the center, in the glyph's frame.
RTG_FN bool PolynomialIsNegative(const Glyph glyph, const real3 p)
{
  return FormAt(glyph, Word3(p / glyph.size), false).f.hi < real(0.0);
}

// The box of its extents, and no more than the box of the ellipsoid round it.
RTG_FN Bounds PolynomialBounds(const Glyph glyph)
{
  real3 halfSize = real(0.5) * glyph.size;
  return SymmetricBounds(min(BoxReach(glyph, halfSize * FormExtents(glyph)), EllipsoidReach(glyph, halfSize)));
}
