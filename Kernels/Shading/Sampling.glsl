// Where the samples of a pixel lie. Deterministic: a function of the sample's number alone.

// Sample s >= 1 in [0,1)^2: the R2 sequence (Roberts 2018, the plastic number's additive recurrence) started at the
// pixel's centre, so that with sample 0 there the first samples spread evenly round it.
vec2 PixelSample(uint s)
{
  return fract(vec2(0.5) + float(s) * vec2(0.7548776662466927, 0.5698402909980532));
}
