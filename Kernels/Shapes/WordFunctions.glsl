// Powers and logarithms in double words. The built-in ones are good to about 1e-6 (Vulkan allows log2 an error of
// 2^-21, which an exponent then multiplies), but a surface met at a grazing angle wants 1e-12.
//
//   x^e = 2^(e log2 x),   log2 x = l + log2(x 2^-l)
//
// with l from the built-in logarithm: what that lacks is the logarithm of a number next to one, so the only function
// needed with many digits is 2^y = 2^k 2^(j/8) exp(r): k integer, 2^(j/8) from a table, j = -4 .. 4, and
// |r| <= ln(2) / 16 by the Taylor series, its first terms in double words.
// The relative error of x^e is below 8 u^2 (1 + e (1 + |log2 x|)), in double with 2^-101 for u^2: the constants have no
// more digits.

// The logarithm of zero.
#define RTG_LOG_ZERO -1.0e5

// Terms of the series, and how many of them in double words: x^n / n! < u^2 and < u / 8 from there on.
#define RTG_EXP_TERMS (real(RTG_ROUNDOFF) > real(1e-12) ? 6 : 16)
#define RTG_EXP_WORDS (real(RTG_ROUNDOFF) > real(1e-12) ? 2 : 8)

// A constant from four numbers of 24 bits that follow each other: float keeps the first two, double all.
RTG_FN DoubleWord FromParts(const real c0, const real c1, const real c2, const real c3)
{
  real hi = c0 + c1;
  return DoubleWord(hi, ((c0 - hi) + c1) + (c2 + c3));
}

// 2^(i/8 - 1/2), i = 0 .. 8.
RTG_FN DoubleWord EighthPower(const int i)
{
  const real c0[9] = { real(0.70710676908493042), real(0.77110540866851807), real(0.84089642763137817),
    real(0.9170040488243103), real(1.0), real(1.0905077457427979), real(1.1892070770263672), real(1.2968395948410034),
    real(1.4142135381698608) };
  const real c1[9] = { real(1.2101617485882343e-08), real(4.0354524166730243e-09), real(-1.2377663338725142e-08),
    real(-5.6196389763840671e-09), real(0.0), real(-1.3077539939843064e-08), real(3.7976352729174323e-08),
    real(-4.0189995331729733e-08), real(2.4203234971764687e-08) };
  if (real(RTG_ROUNDOFF) > real(1e-12))
  {
    return FromParts(c0[i], c1[i], real(0.0), real(0.0));
  }
  const real c2[9] = { real(-3.8140337191820564e-16), real(-7.1273130743014973e-17), real(-2.9207186269919851e-16),
    real(-9.4606764240057911e-17), real(0.0), real(-2.5251243297732769e-16), real(1.1500432081458837e-15),
    real(1.5796947414099967e-15), real(-7.6280674383641129e-16) };
  const real c3[9] = { real(-2.036605946098386e-24), real(2.3289873798572387e-24), real(5.414559026567919e-24),
    real(-2.1012296286693176e-24), real(0.0), real(7.2541716134906454e-24), real(-3.1206072077651253e-23),
    real(-4.1398891769192201e-24), real(-4.073211892196772e-24) };
  return FromParts(c0[i], c1[i], c2[i], c3[i]);
}

// 2^y for y.hi <= 126; what is below 2^-120 counts as zero.
RTG_FN DoubleWord Exp2(const DoubleWord y)
{
  if (!(y.hi > real(-120.0)))
  {
    return Word(real(0.0));
  }
  real k = floor(y.hi + real(0.5));
  real j = floor(real(8.0) * (y.hi - k) + real(0.5));
  DoubleWord r = FastTwoSum((y.hi - k) - real(0.125) * j, y.lo);
  DoubleWord x = Multiply(r,
    FromParts(real(0.69314718246459961), real(-1.9046542121259336e-09), real(-8.7831837385893394e-17),
      real(3.0618407385293692e-24)));

  // exp(x) = 1 + x (1 + t), t_n = x / (n + 1) (1 + t_(n+1)), t = t_1.
  real plain = real(0.0);
  for (int n = RTG_EXP_TERMS; n > RTG_EXP_WORDS; --n)
  {
    plain = (x.hi / real(n + 1)) * (real(1.0) + plain);
  }
  DoubleWord t = Word(plain);
  for (int n = RTG_EXP_WORDS; n > 0; --n)
  {
    DoubleWord q = Divide(x, real(n + 1));
    t = AddSloppy(q, Multiply(q, t));
  }
  DoubleWord minusOne = AddSloppy(x, Multiply(x, t));
  DoubleWord eighth = EighthPower(int(j) + 4);
  DoubleWord power = AddSloppy(eighth, Multiply(eighth, minusOne));
  real scale = ldexp(real(1.0), int(k));
  return DoubleWord(scale * power.hi, scale * power.lo);
}

// log2 of x >= 0; RTG_LOG_ZERO for x <= 1e-36.
RTG_FN DoubleWord Log2(const DoubleWord x)
{
  if (!(x.hi > real(1e-36)))
  {
    return Word(real(RTG_LOG_ZERO));
  }
  real l = log2(x.hi);
  real rho = Add(Multiply(x, Exp2(Word(-l))), real(-1.0)).hi;
  return TwoSum(l, (rho - real(0.5) * rho * rho) * real(1.4426950408889634074));
}

// x^e for x >= 0, e > 0.
RTG_FN DoubleWord Power(const DoubleWord x, const real e)
{
  return e == real(1.0) ? x : e == real(2.0) ? Multiply(x, x) : Exp2(Multiply(Log2(x), e));
}
