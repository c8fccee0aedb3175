// A homogeneous polynomial f of even degree k in the coordinates of a glyph's own frame, of which |f| <= 1 on the unit
// sphere, and its restriction to a plane through the center.
//
// A glyph's values are half the extents of its unit glyph along its axes and then the (k + 1) (k + 2) / 2 coefficients
// of x^a y^b z^c, a + b + c = k, by falling a and, where that is the same, by falling b: coefficient
// (b + c) (b + c + 1) / 2 + c.

#define RTG_FORM_EXTENTS 3  // values before the coefficients
#define RTG_MOST_SAMPLES 13 // the largest degree + 1
#define RTG_MOST_WAVES 7    // half of it + 1

RTG_FN real3 FormExtents(const Glyph glyph)
{
  return real3(RTG_VALUE(glyph, 0), RTG_VALUE(glyph, 1), RTG_VALUE(glyph, 2));
}

// f on the unit circle of a plane: sum of cosine[m] cos(2 m phi) + sine[m] sin(2 m phi). In this basis rounding stays
// that of the sum; powers of two coordinates cancel against each other.
struct PlaneForm
{
  real cosine[RTG_MOST_WAVES];
  real sine[RTG_MOST_WAVES];
  real most; // |f| is not larger on that circle
};

// Cosine and sine of pi / (2 k + 2).
RTG_FN real2 QuarterStep(const int degree)
{
  real2 step = real2(real(0.8660254037844386), real(0.5));
  step = degree == 4 ? real2(real(0.9510565162951535), real(0.3090169943749474)) : step;
  step = degree == 6 ? real2(real(0.9749279121818236), real(0.2225209339563144)) : step;
  step = degree == 8 ? real2(real(0.984807753012208), real(0.1736481776669303)) : step;
  step = degree == 10 ? real2(real(0.9898214418809327), real(0.1423148382732851)) : step;
  step = degree == 12 ? real2(real(0.992708874098054), real(0.1205366802553230)) : step;
  return step;
}

// The product of complex numbers: a direction a rotated by b.
RTG_FN real2 ComplexProduct(const real2 a, const real2 b)
{
  return real2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// f at the angles i pi / (k + 1) from the unit vector e to the unit vector d, which determine it on the whole circle.
RTG_FN PlaneForm MakePlaneForm(const Glyph glyph, const real3 e, const real3 d)
{
  int degree = RTG_DEGREE(glyph);
  real2 halfStep = QuarterStep(degree);
  real2 step = ComplexProduct(halfStep, halfStep);
  real2 angle = real2(real(1.0), real(0.0));
  real x[RTG_MOST_SAMPLES];
  real y[RTG_MOST_SAMPLES];
  real z[RTG_MOST_SAMPLES];
  real sum[RTG_MOST_SAMPLES];
  real row[RTG_MOST_SAMPLES];
  real power[RTG_MOST_SAMPLES];
  RTG_UNROLL for (int i = 0; i <= degree; ++i)
  {
    real3 n = angle.x * e + angle.y * d;
    angle = ComplexProduct(angle, step);
    x[i] = n.x;
    y[i] = n.y;
    z[i] = n.z;
    sum[i] = real(0.0);
  }
  // Horner's rule in x over rows of the same power of x, for all directions at once: each coefficient is read once.
  int at = RTG_FORM_EXTENTS;
  for (int n = 0; n <= glyph.degree; ++n)
  {
    RTG_UNROLL for (int i = 0; i <= degree; ++i)
    {
      row[i] = real(0.0);
      power[i] = real(1.0);
    }
    for (int c = 0; c <= n; ++c)
    {
      real value = RTG_VALUE(glyph, at);
      ++at;
      RTG_UNROLL for (int i = 0; i <= degree; ++i)
      {
        row[i] = row[i] * y[i] + value * power[i];
        power[i] = power[i] * z[i];
      }
    }
    RTG_UNROLL for (int i = 0; i <= degree; ++i)
    {
      sum[i] = sum[i] * x[i] + row[i];
    }
  }
  // Their discrete Fourier transform
  PlaneForm form;
  real2 wave = real2(real(1.0), real(0.0));
  real2 twice = ComplexProduct(step, step);
  form.most = real(0.0);
  RTG_UNROLL for (int m = 0; 2 * m <= degree; ++m)
  {
    real2 total = real2(real(0.0));
    RTG_UNROLL for (int i = degree; i >= 0; --i)
    {
      total = ComplexProduct(total, wave);
      total.x += sum[i];
    }
    real weight = (m == 0 ? real(1.0) : real(2.0)) / real(degree + 1);
    form.cosine[m] = weight * total.x;
    form.sine[m] = weight * total.y;
    form.most += weight * length(total);
    wave = ComplexProduct(wave, twice);
  }
  return form;
}

// A direction in the plane, and there f and its derivative by the angle.
struct PlanePoint
{
  real2 n;
  real f;
  real slope;
};

// By Horner's rule in exp(2 i phi).
RTG_FN PlanePoint PlaneAt(const PlaneForm form, const int degree, const real2 n)
{
  real2 z = real2(n.x * n.x - n.y * n.y, real(2.0) * n.x * n.y);
  real2 f = real2(real(0.0));
  real2 slope = real2(real(0.0));
  RTG_UNROLL for (int m = degree / 2; m > 0; --m)
  {
    real2 coefficient = real2(form.cosine[m], -form.sine[m]);
    f = ComplexProduct(f + coefficient, z);
    slope = ComplexProduct(slope + real(m) * coefficient, z);
  }
  return PlanePoint(n, f.x + form.cosine[0], real(-2.0) * slope.y);
}

// f in the direction of a point and its gradient there, from double words.
struct FormPoint
{
  DoubleWord f;
  DoubleWord3 gradient; // of f(p / |p|) by p
  DoubleWord distance;  // |p|
};

// By Horner's rule in the ratios to the largest coordinate. With `exact` the gradient is right to the last digits.
RTG_FN FormPoint FormAt(const Glyph glyph, const DoubleWord3 p, const bool exact)
{
  real3 size = abs(p.hi);
  int w = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = w == 2 ? 0 : w + 1;
  int v = w == 0 ? 2 : w - 1;
  DoubleWord largest = WordOf(p, w);
  largest = abs(largest.hi) > real(1e-30) ? largest : Word(real(1e-30));
  DoubleWord x = Divide(WordOf(p, u), largest);
  DoubleWord y = Divide(WordOf(p, v), largest);
  DoubleWord sum = Word(real(0.0));
  DoubleWord byX = Word(real(0.0));
  DoubleWord byY = Word(real(0.0));
  for (int i = glyph.degree; i >= 0; --i)
  {
    DoubleWord row = Word(real(0.0));
    DoubleWord rowByY = Word(real(0.0));
    for (int j = glyph.degree - i; j >= 0; --j)
    {
      int rest = glyph.degree - i - j;
      int c = w == 2 ? rest : u == 2 ? i : j;
      int b = w == 1 ? rest : u == 1 ? i : j;
      int n = b + c;
      real value = RTG_VALUE(glyph, RTG_FORM_EXTENTS + n * (n + 1) / 2 + c);
      if (exact)
      {
        rowByY = AddSloppy(Multiply(rowByY, y), row);
      }
      else
      {
        rowByY.hi = rowByY.hi * y.hi + row.hi;
      }
      row = Add(Multiply(row, y), value);
    }
    if (exact)
    {
      byX = AddSloppy(Multiply(byX, x), sum);
      byY = AddSloppy(Multiply(byY, x), rowByY);
    }
    else
    {
      byX.hi = byX.hi * x.hi + sum.hi;
      byY.hi = byY.hi * x.hi + rowByY.hi;
    }
    sum = AddSloppy(Multiply(sum, x), row);
  }
  // |p| / |largest|, and its k-th power
  DoubleWord square = Add(Add(Multiply(x, x), Multiply(y, y)), real(1.0));
  DoubleWord power = Word(real(1.0));
  for (int i = 0; 2 * i < glyph.degree; ++i)
  {
    power = Multiply(power, square);
  }
  FormPoint point;
  point.f = Divide(sum, power);
  point.distance = Multiply(SquareRoot(square), largest.hi < real(0.0) ? Minus(largest) : largest);
  // d f / d x = (d sum / d x - k x sum / square) / power
  DoubleWord radial = Multiply(Divide(sum, square), real(glyph.degree));
  power = Multiply(power, largest);
  DoubleWord slopeX = Divide(Subtract(byX, Multiply(radial, x)), power);
  DoubleWord slopeY = Divide(Subtract(byY, Multiply(radial, y)), power);
  DoubleWord slopeW = Minus(Add(Multiply(x, slopeX), Multiply(y, slopeY)));
  point.gradient = w == 0 ? Words(slopeW, slopeX, slopeY)
    : w == 1              ? Words(slopeY, slopeW, slopeX)
                          : Words(slopeX, slopeY, slopeW);
  return point;
}
