// Included by DoubleWord.glsl once for numbers and once, component by component, for vectors:
// RTG_WORD is the type of a word, RTG_WORDS that of an unevaluated sum of two.

// hi + lo = a + b exactly. JMP algorithm 2 (Knuth).
RTG_FN RTG_WORDS TwoSum(const RTG_WORD a, const RTG_WORD b)
{
  RTG_PRECISE RTG_WORD s = a + b;
  RTG_PRECISE RTG_WORD aRounded = s - b;
  RTG_PRECISE RTG_WORD bRounded = s - aRounded;
  RTG_PRECISE RTG_WORD aError = a - aRounded;
  RTG_PRECISE RTG_WORD bError = b - bRounded;
  RTG_PRECISE RTG_WORD e = aError + bError;
  return RTG_WORDS(s, e);
}

// The same when |a| >= |b| or a = 0. JMP algorithm 1 (Dekker).
RTG_FN RTG_WORDS FastTwoSum(const RTG_WORD a, const RTG_WORD b)
{
  RTG_PRECISE RTG_WORD s = a + b;
  RTG_PRECISE RTG_WORD bRounded = s - a;
  RTG_PRECISE RTG_WORD e = b - bRounded;
  return RTG_WORDS(s, e);
}

// a = hi + lo with at most half the bits in each. Veltkamp; Dekker 1971, section 5.
RTG_FN RTG_WORDS Split(const RTG_WORD a)
{
  RTG_PRECISE RTG_WORD c = real(RTG_SPLITTER) * a;
  RTG_PRECISE RTG_WORD rest = c - a;
  RTG_PRECISE RTG_WORD hi = c - rest;
  RTG_PRECISE RTG_WORD lo = a - hi;
  return RTG_WORDS(hi, lo);
}

// hi + lo = a b exactly, short of under- and overflow. Dekker 1971, equation 5.10.
RTG_FN RTG_WORDS TwoProduct(const RTG_WORD a, const RTG_WORD b)
{
  RTG_WORDS x = Split(a);
  RTG_WORDS y = Split(b);
  RTG_PRECISE RTG_WORD p = a * b;
  RTG_PRECISE RTG_WORD hh = x.hi * y.hi;
  RTG_PRECISE RTG_WORD hl = x.hi * y.lo;
  RTG_PRECISE RTG_WORD lh = x.lo * y.hi;
  RTG_PRECISE RTG_WORD ll = x.lo * y.lo;
  RTG_PRECISE RTG_WORD e = ((hh - p) + hl + lh) + ll;
  return RTG_WORDS(p, e);
}

RTG_FN RTG_WORDS Minus(const RTG_WORDS a)
{
  return RTG_WORDS(-a.hi, -a.lo);
}

// a + b with relative error below 2 u^2, also under cancellation. JMP algorithm 4 (DWPlusFP).
RTG_FN RTG_WORDS Add(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_WORDS s = TwoSum(a.hi, b);
  RTG_PRECISE RTG_WORD v = a.lo + s.lo;
  return FastTwoSum(s.hi, v);
}

// a + b with relative error below 3 u^2, also under cancellation. JMP algorithm 6 (AccurateDWPlusDW).
RTG_FN RTG_WORDS Add(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORDS s = TwoSum(a.hi, b.hi);
  RTG_WORDS t = TwoSum(a.lo, b.lo);
  RTG_PRECISE RTG_WORD c = s.lo + t.hi;
  RTG_WORDS v = FastTwoSum(s.hi, c);
  RTG_PRECISE RTG_WORD w = t.lo + v.lo;
  return FastTwoSum(v.hi, w);
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
  RTG_PRECISE RTG_WORD v = a.lo + b.lo;
  RTG_PRECISE RTG_WORD w = s.lo + v;
  return FastTwoSum(s.hi, w);
}

// a b with relative error below 3 u^2. JMP algorithm 8 (DWTimesFP2).
RTG_FN RTG_WORDS Multiply(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_WORDS p = TwoProduct(a.hi, b);
  RTG_PRECISE RTG_WORD c = a.lo * b;
  RTG_PRECISE RTG_WORD w = p.lo + c;
  return FastTwoSum(p.hi, w);
}

// a b with relative error below 7 u^2. JMP algorithm 10 (DWTimesDW1).
RTG_FN RTG_WORDS Multiply(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_WORDS p = TwoProduct(a.hi, b.hi);
  RTG_PRECISE RTG_WORD c = a.hi * b.lo;
  RTG_PRECISE RTG_WORD d = a.lo * b.hi;
  RTG_PRECISE RTG_WORD w = p.lo + (c + d);
  return FastTwoSum(p.hi, w);
}

// a / b with relative error of a few u^2: one step on the exact residual, so that a division that is
// only good to some ulps (Vulkan allows 2.5) still serves. JMP algorithm 15 (DWDivFP3).
RTG_FN RTG_WORDS Divide(const RTG_WORDS a, const RTG_WORD b)
{
  RTG_PRECISE RTG_WORD q = a.hi / b;
  RTG_WORDS p = TwoProduct(q, b);
  RTG_PRECISE RTG_WORD residual = ((a.hi - p.hi) - p.lo) + a.lo;
  RTG_PRECISE RTG_WORD correction = residual / b;
  return FastTwoSum(q, correction);
}

// As above. JMP algorithm 17 (DWDivDW2), the products as in DWTimesFP2.
RTG_FN RTG_WORDS Divide(const RTG_WORDS a, const RTG_WORDS b)
{
  RTG_PRECISE RTG_WORD q = a.hi / b.hi;
  RTG_WORDS p = Multiply(b, q);
  RTG_PRECISE RTG_WORD residual = (a.hi - p.hi) + (a.lo - p.lo);
  RTG_PRECISE RTG_WORD correction = residual / b.hi;
  return FastTwoSum(q, correction);
}
