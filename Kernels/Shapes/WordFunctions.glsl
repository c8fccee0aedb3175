// Exponential and logarithm in double words, for shapes whose surfaces are sums of real powers. The hardware's
// exp2 and log2 only give a first guess that a residual corrects: GPUs and lavapipe promise little of them.
// In float the relative error is below 2e-14, in double below 1e-23 (Testing/Kernels/DoubleWordTest.cxx).
#ifndef RTG_WORD_FUNCTIONS
#define RTG_WORD_FUNCTIONS

#include "DoubleWord.glsl"

// The logarithm of zero, and below its half powers of e count as zero.
#define RTG_LOG_ZERO -1.0e5
#define RTG_LOG_LEAST -80.0

// 2^-n for 0 <= n < 128, exactly; exp2 need not be.
RTG_FN real InversePowerOfTwo(int n)
{
  real power = real(1.0);
  power *= (n & 1) != 0 ? real(0.5) : real(1.0);
  power *= (n & 2) != 0 ? real(0.25) : real(1.0);
  power *= (n & 4) != 0 ? real(0.0625) : real(1.0);
  power *= (n & 8) != 0 ? real(0.00390625) : real(1.0);
  power *= (n & 16) != 0 ? real(1.52587890625e-5) : real(1.0);
  power *= (n & 32) != 0 ? real(2.3283064365386962890625e-10) : real(1.0);
  power *= (n & 64) != 0 ? real(5.42101086242752217003726400434970855712890625e-20) : real(1.0);
  return power;
}

// e^a for a <= 1; 0 below RTG_LOG_LEAST. a = k log 2 + 16 x with |x| < 0.022; a series for e^x - 1, squared
// four times.
RTG_FN DoubleWord Exponential(DoubleWord a)
{
  if (!(a.hi > real(RTG_LOG_LEAST)))
  {
    return Word(real(0.0));
  }
  real k = floor(a.hi * real(1.44269504088896340736) + real(0.5));
  // log 2 in three parts, of which two have few bits: their products with k are exact.
  RTG_PRECISE real first = k * real(-0.693145751953125);
  RTG_PRECISE real second = k * real(-0.0000014281831681728363037109375);
  RTG_PRECISE real third = k * real(-4.23652136580928410521e-10);
  DoubleWord rest = Add(Add(Add(a, first), second), third);
  DoubleWord x;
  x.hi = real(0.0625) * rest.hi;
  x.lo = real(0.0625) * rest.lo;

  // Terms up to the fourth power in double words; the tail is small enough for plain numbers.
  real h = x.hi;
  real tail = real(1.0 / 120.0) +
    h *
      (real(1.0 / 720.0) +
        h * (real(1.0 / 5040.0) + h * (real(1.0 / 40320.0) + h * (real(1.0 / 362880.0) + h * real(1.0 / 3628800.0)))));
  DoubleWord square = Multiply(x, x);
  square.hi *= real(0.5);
  square.lo *= real(0.5);
  DoubleWord cube = Divide(Multiply(square, x), real(3.0));
  DoubleWord fourth = Multiply(cube, x);
  fourth.hi *= real(0.25);
  fourth.lo *= real(0.25);
  RTG_PRECISE real fifth = fourth.hi * h * (real(24.0) * tail);
  DoubleWord e = Add(Add(x, square), Add(cube, Add(fourth, fifth)));
  for (int i = 0; i < 4; ++i)
  {
    DoubleWord twice;
    twice.hi = real(2.0) * e.hi;
    twice.lo = real(2.0) * e.lo;
    e = Add(twice, Multiply(e, e));
  }
  DoubleWord power = Add(e, real(1.0));
  int exponent = int(k);
  real scale = exponent > 0 ? real(2.0) : InversePowerOfTwo(-exponent);
  power.hi *= scale;
  power.lo *= scale;
  return power;
}

// log a for 0 <= a <= 2; RTG_LOG_ZERO for zero and what is nearly that.
RTG_FN DoubleWord Logarithm(DoubleWord a)
{
  if (!(a.hi > real(1e-34)))
  {
    return Word(real(RTG_LOG_ZERO));
  }
  RTG_PRECISE real guess = log(a.hi);
  DoubleWord power = Exponential(Word(guess));
  DoubleWord d = Divide(Subtract(a, power), power);
  RTG_PRECISE real bend = d.hi * d.hi * (real(0.5) - d.hi * (real(1.0 / 3.0) - real(0.25) * d.hi));
  return Add(Add(d, -bend), guess);
}

#endif
