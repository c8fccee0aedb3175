// Superquadric with two profiles, its axis along z: in the frame of the half-lengths, for |z| <= 1,
//
//   |x / Rx(z)|^p + |y / Ry(z)|^p = 1,   Rx(z) = (1 - |z|^q)^(1/q),   Ry(z) = (1 - |z|^r)^(1/r),
//   p = 2 / alpha,  q = 2 / beta,  r = 2 / c.
//
// This is the base form of Schultz and Kindlmann: Superquadric Glyphs for Symmetric Second-Order Tensors, IEEE TVCG
// 16(6), 2010, written implicitly; c = beta is the nested superquadric (|x|^p + |y|^p)^(q/p) + |z|^q = 1 of
// Kindlmann 2004 and of granular matter codes. alpha = 0 is the square cross-section, beta = c = 0 the cylinder.
// Glyph.exponents holds alpha, beta, c; those below 1e-6 count as that.
//
// The solver is ImplicitSearch.glsl's; what it solves is in NestedField.glsl.

RTG_FN GlyphHit IntersectNestedSuperquadric(
  const GlyphRay ray, const Glyph glyph, const real tMin, const real tMax, const bool wantsNormal)
{
  return HitAt(NestedSuperquadricCrossing(ray, glyph, tMin, tMax, wantsNormal), ray, glyph, wantsNormal);
}

#define NestedSuperquadricEnclosure BoxedEnclosure

// The norm dual to the p-norm, p = 2 / exponent, of non-negative a, b: the reach of the p-norm's unit ball. Not
// convex (exponent > 2) it reaches as far as its convex hull, the octahedron's.
RTG_FN real DualNorm(const real a, const real b, const real exponent)
{
  real high = max(a, b);
  if (exponent >= real(2.0) || high == real(0.0))
  {
    return high;
  }
  real dual = real(1.0) / (real(1.0) - real(0.5) * exponent);
  return high * pow(real(1.0) + pow(min(a, b) / high, dual), real(1.0) / dual);
}

// Half the extent along each world axis is the glyph's support function there: of the dual norms, one in the other. A
// profile that is convex toward the axis (beta > 2) reaches as far as its hull. Of two profiles the fuller one counts,
// which is exact when both are straight or convex toward the axis.
RTG_FN Bounds NestedSuperquadricBounds(const Glyph glyph)
{
  Axes axes = WorldAxes(glyph, real(0.5) * glyph.size);
  real3 x = abs(axes.x);
  real3 y = abs(axes.y);
  real3 z = abs(axes.z);
  real3 e = max(glyph.exponents, real3(real(RTG_NESTED_LEAST)));
  real profile = min(e.y, e.z);
  return SymmetricBounds(real3(DualNorm(DualNorm(x.x, y.x, e.x), z.x, profile),
    DualNorm(DualNorm(x.y, y.y, e.x), z.y, profile), DualNorm(DualNorm(x.z, y.z, e.x), z.z, profile)));
}
