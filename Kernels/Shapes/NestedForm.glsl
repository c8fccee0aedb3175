// The form of a superquadric with two profiles (NestedSuperquadric.glsl), and p-norms.
#ifndef RTG_NESTED_FORM
#define RTG_NESTED_FORM

#define RTG_NESTED_LEAST 1.0e-6 // exponent
// Where 1 - z^q is less than what the logarithms know of it, it counts as outside: the end of the axis.
#define RTG_NESTED_END (16.0 * RTG_ROUNDOFF * RTG_ROUNDOFF + 1.0e-22)
#define RTG_NESTED_TINY (RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF * RTG_ROUNDOFF)

struct NestedForm
{
  real p;
  real q;
  real r;
  real3 exponents; // alpha, beta, c, which p, q and r are rounded from
  bool convex;
  bool twoProfiles;
  real2 steepAt; // of a profile with q < 1: |z| where -d(log R)/d|z| is least, and that; 0 for others
  real2 leastFall;
};

// Where z^(q - 1) / (1 - z^q) is least: z^q = 1 - q.
RTG_FN real LeastFallAt(real q)
{
  return q < real(1.0) ? exp2(max(log2(max(real(1.0) - q, real(1e-6))) / q, real(-60.0))) : real(0.0);
}

RTG_FN NestedForm MakeNestedForm(real3 exponents)
{
  real3 e = max(exponents, real3(real(RTG_NESTED_LEAST)));
  NestedForm form;
  form.exponents = e;
  form.p = real(2.0) / e.x;
  form.q = real(2.0) / e.y;
  form.r = real(2.0) / e.z;
  form.twoProfiles = e.y != e.z;
  form.convex = !form.twoProfiles && e.x <= real(2.0) && e.y <= real(2.0);
  form.steepAt = real2(real(0.0));
  form.leastFall = real2(real(0.0));
  if (!form.convex)
  {
    form.steepAt = real2(LeastFallAt(form.q), LeastFallAt(form.r));
    form.leastFall.x = form.q < real(1.0) ? exp2((form.q - real(1.0)) * log2(form.steepAt.x)) / form.q : real(0.0);
    form.leastFall.y = form.r < real(1.0) ? exp2((form.r - real(1.0)) * log2(form.steepAt.y)) / form.r : real(0.0);
  }
  return form;
}

// 2^x without underflow.
RTG_FN real SafeExp2(real x)
{
  return x > real(-100.0) ? exp2(min(x, real(100.0))) : real(0.0);
}

// The p-norm of (high, low) with high >= low >= 0, and its derivatives.
struct NestedNorm
{
  real value;
  real byHigh;
  real byLow;
};

RTG_FN NestedNorm PNorm(real high, real low, real p)
{
  NestedNorm norm;
  norm.value = high;
  norm.byHigh = real(1.0);
  norm.byLow = real(0.0);
  real ratio = high > real(0.0) ? low / high : real(0.0);
  if (ratio > real(RTG_NESTED_TINY))
  {
    real power = SafeExp2(p * log2(ratio));
    real root = exp2(log2(real(1.0) + power) / p);
    norm.value = high * root;
    norm.byHigh = root / (real(1.0) + power);
    norm.byLow = norm.byHigh * (power / ratio);
  }
  return norm;
}

#endif
