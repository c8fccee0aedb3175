// Included by DoubleWord.glsl once for numbers and once, component by component, for vectors:
// RTG_WORD is the type of a word, RTG_WORDS that of an unevaluated sum of two.

// hi + lo = a + b exactly. JMP algorithm 2 (Knuth).
RTG_FN RTG_WORDS TwoSum(const RTG_WORD a, const RTG_WORD b)
{
  RTG_WORD s = a + b;
  RTG_WORD aRounded = s - b;
  return RTG_WORDS(s, (a - aRounded) + (b - (s - aRounded)));
}

// The same when |a| >= |b| or a = 0. JMP algorithm 1 (Dekker).
RTG_FN RTG_WORDS FastTwoSum(const RTG_WORD a, const RTG_WORD b)
{
  RTG_WORD s = a + b;
  return RTG_WORDS(s, b - (s - a));
}

// a = hi + lo with at most half the bits in each. Veltkamp; Dekker 1971, section 5.
RTG_FN RTG_WORDS Split(const RTG_WORD a)
{
  RTG_WORD c = real(RTG_SPLITTER) * a;
  RTG_WORD hi = c - (c - a);
  return RTG_WORDS(hi, a - hi);
}

// hi + lo = a b exactly, short of under- and overflow. Dekker 1971, equation 5.10.
RTG_FN RTG_WORDS TwoProduct(const RTG_WORD a, const RTG_WORD b)
{
  RTG_WORDS x = Split(a);
  RTG_WORDS y = Split(b);
  RTG_WORD p = a * b;
  return RTG_WORDS(p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo);
}

RTG_FN RTG_WORDS Minus(const RTG_WORDS a)
{
  return RTG_WORDS(-a.hi, -a.lo);
}

// a + b with relative error below 2 u^2, also under cancellation. JMP algorithm 4 (DWPlusFP).
RTG_FN RTG_WORDS Add(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_WORDS s = TwoSum(a.hi, b);
  return FastTwoSum(s.hi, a.lo + s.lo);
}

// a + b with relative error below 3 u^2, also under cancellation. JMP algorithm 6 (AccurateDWPlusDW).
RTG_FN RTG_WORDS Add(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORDS s = TwoSum(a.hi, b.hi);
  RTG_WORDS t = TwoSum(a.lo, b.lo);
  RTG_WORDS v = FastTwoSum(s.hi, s.lo + t.hi);
  return FastTwoSum(v.hi, t.lo + v.lo);
}

RTG_FN RTG_WORDS Subtract(const RTG_WORDS a, const RTG_WORDS b)
{
  return Add(a, Minus(b));
}

// a + b with an error below 3 u^2 (|a| + |b|): cheaper, for sums whose terms are themselves rounded.
// JMP algorithm 5 (SloppyDWPlusDW).
RTG_FN RTG_WORDS AddSloppy(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORDS s = TwoSum(a.hi, b.hi);
  return FastTwoSum(s.hi, s.lo + (a.lo + b.lo));
}

// a b with relative error below 3 u^2. JMP algorithm 8 (DWTimesFP2).
RTG_FN RTG_WORDS Multiply(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_WORDS p = TwoProduct(a.hi, b);
  return FastTwoSum(p.hi, p.lo + a.lo * b);
}

// a b with relative error below 7 u^2. JMP algorithm 10 (DWTimesDW1).
RTG_FN RTG_WORDS Multiply(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORDS p = TwoProduct(a.hi, b.hi);
  return FastTwoSum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

// a / b with relative error of a few u^2: one step on the exact residual, so that a division that is
// only good to some ulps (Vulkan allows 2.5) still serves. JMP algorithm 15 (DWDivFP3).
RTG_FN RTG_WORDS Divide(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_WORD q = a.hi / b;
  RTG_WORDS p = TwoProduct(q, b);
  return FastTwoSum(q, (((a.hi - p.hi) - p.lo) + a.lo) / b);
}

// As above. JMP algorithm 17 (DWDivDW2), the products as in DWTimesFP2.
RTG_FN RTG_WORDS Divide(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORD q = a.hi / b.hi;
  RTG_WORDS p = Multiply(b, q);
  return FastTwoSum(q, ((a.hi - p.hi) + (a.lo - p.lo)) / b.hi);
}
