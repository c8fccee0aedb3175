// Double-word arithmetic: a number is the unevaluated sum hi + lo with |lo| <= ulp(hi) / 2.
// Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic, ACM TOMS 44(2), 2017 ("JMP"). u is the unit roundoff of `real`.
// fma is not used: Vulkan allows it to be rounded twice.

struct DoubleWord
{
  real hi;
  real lo;
};

struct DoubleWord3
{
  real3 hi;
  real3 lo;
};

#define RTG_WORD real
#define RTG_WORDS DoubleWord
#include "DoubleWordOperations.glsl"
#undef RTG_WORD
#undef RTG_WORDS

#define RTG_WORD real3
#define RTG_WORDS DoubleWord3
#include "DoubleWordOperations.glsl"
#undef RTG_WORD
#undef RTG_WORDS

RTG_FN DoubleWord Word(const real hi)
{
  return DoubleWord(hi, real(0.0));
}

RTG_FN DoubleWord3 Word3(const real3 hi)
{
  return DoubleWord3(hi, real3(real(0.0)));
}

// The same in all components.
RTG_FN DoubleWord3 Word3(const DoubleWord a)
{
  return DoubleWord3(real3(a.hi), real3(a.lo));
}

RTG_FN DoubleWord3 Words(const DoubleWord x, const DoubleWord y, const DoubleWord z)
{
  return DoubleWord3(real3(x.hi, y.hi, z.hi), real3(x.lo, y.lo, z.lo));
}

RTG_FN DoubleWord WordOf(const DoubleWord3 a, const int axis)
{
  return DoubleWord(axis == 0 ? a.hi.x : axis == 1 ? a.hi.y : a.hi.z, axis == 0 ? a.lo.x : axis == 1 ? a.lo.y : a.lo.z);
}

RTG_FN DoubleWord WordX(const DoubleWord3 a)
{
  return DoubleWord(a.hi.x, a.lo.x);
}

RTG_FN DoubleWord WordY(const DoubleWord3 a)
{
  return DoubleWord(a.hi.y, a.lo.y);
}

RTG_FN DoubleWord WordZ(const DoubleWord3 a)
{
  return DoubleWord(a.hi.z, a.lo.z);
}

RTG_FN DoubleWord SumOf(const DoubleWord3 a)
{
  return Add(Add(WordX(a), WordY(a)), WordZ(a));
}

// Square root with one Heron step on the exact residual; 0 for negative numbers. Error of a few u^2.
RTG_FN DoubleWord SquareRoot(const DoubleWord a)
{
  if (!(a.hi > real(0.0)))
  {
    return Word(real(0.0));
  }
  real root = sqrt(a.hi);
  DoubleWord square = TwoProduct(root, root);
  return FastTwoSum(root, (((a.hi - square.hi) - square.lo) + a.lo) / (real(2.0) * root));
}
