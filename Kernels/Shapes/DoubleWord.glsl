// Double-word arithmetic: a number is the unevaluated sum hi + lo with |lo| <= ulp(hi) / 2.
// Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic, ACM TOMS 44(2), 2017 ("JMP"). u is the unit roundoff of `real`.
// fma is not used: Vulkan allows it to be rounded twice.
#ifndef RTG_DOUBLE_WORD
#define RTG_DOUBLE_WORD

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
  DoubleWord word;
  word.hi = hi;
  word.lo = real(0.0);
  return word;
}

RTG_FN DoubleWord3 Word3(const real3 hi)
{
  DoubleWord3 word;
  word.hi = hi;
  word.lo = real3(real(0.0));
  return word;
}

RTG_FN DoubleWord WordX(const DoubleWord3 a)
{
  DoubleWord word;
  word.hi = a.hi.x;
  word.lo = a.lo.x;
  return word;
}

RTG_FN DoubleWord WordY(const DoubleWord3 a)
{
  DoubleWord word;
  word.hi = a.hi.y;
  word.lo = a.lo.y;
  return word;
}

RTG_FN DoubleWord WordZ(const DoubleWord3 a)
{
  DoubleWord word;
  word.hi = a.hi.z;
  word.lo = a.lo.z;
  return word;
}

// Square root with one Heron step on the exact residual; 0 for negative numbers. Error of a few u^2.
RTG_FN DoubleWord SquareRoot(const DoubleWord a)
{
  if (!(a.hi > real(0.0)))
  {
    return Word(real(0.0));
  }
  RTG_PRECISE real root = sqrt(a.hi);
  DoubleWord square = TwoProduct(root, root);
  RTG_PRECISE real residual = ((a.hi - square.hi) - square.lo) + a.lo;
  RTG_PRECISE real correction = residual / (real(2.0) * root);
  return FastTwoSum(root, correction);
}

#endif
