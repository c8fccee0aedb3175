// Where a glyph is at the time of the ray in flight (Kernels/Motion.h).

// When in the shutter's opening the path of the ray in flight runs, in [0, 1).
float shutterTime = 0.0;

// The same as a time of the set's own.
float TimeOf(const GlyphSetRecord set)
{
  return set.shutterOpen + shutterTime * (set.shutterClose - set.shutterOpen);
}

// Which of the versions of a set's tree the ray in flight needs.
uint SliceOf(const uint sliceBits)
{
  return uint(shutterTime * float(1u << sliceBits));
}

// Sine and cosine of an angle >= 0, right to 2^-22 below 1000. Vulkan's are right to 2^-11, and that between -pi and
// pi only. Taylor polynomials within an eighth of a revolution; pi/2 is subtracted in three parts whose products are
// exact (W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980).
vec2 SineCosine(const float angle)
{
  float quarters = floor(0.63661977 * angle + 0.5);
  float x = ((angle - quarters * 1.5703125) - quarters * 4.837512969970703125e-4) - quarters * 7.549789948768648e-8;
  float x2 = x * x;
  float sine = x + x * x2 * (-1.0 / 6.0 + x2 * (1.0 / 120.0 + x2 * (-1.0 / 5040.0 + x2 * (1.0 / 362880.0))));
  float cosine = 1.0 + x2 * (-0.5 + x2 * (1.0 / 24.0 + x2 * (-1.0 / 720.0 + x2 * (1.0 / 40320.0))));
  uint quadrant = uint(quarters) & 3u;
  vec2 result = (quadrant & 1u) == 0u ? vec2(sine, cosine) : vec2(cosine, -sine);
  return quadrant < 2u ? result : -result;
}

// Unit quaternion (x, y, z, w) of a rotation by the vector's length round its direction.
vec4 RotationBy(const vec3 rotation)
{
  vec3 halfway = 0.5 * rotation;
  float angle = length(halfway);
  vec2 sineCosine = SineCosine(angle);
  return angle > 0.0 ? vec4(halfway * (sineCosine.x / angle), sineCosine.y) : vec4(0.0, 0.0, 0.0, 1.0);
}

// How far a glyph or a corner has moved since time zero, by these arrays of its set.
#define RTG_DISPLACEMENT(VELOCITY, velocity, ACCELERATION, acceleration, index)                                        \
  (((Has(set.variants, ACCELERATION) ? (0.5 * time) * set.acceleration.at[InSet(set, ACCELERATION, index)]             \
                                     : vec3(0.0)) +                                                                    \
     (Has(set.variants, VELOCITY) ? set.velocity.at[InSet(set, VELOCITY, index)] : vec3(0.0))) *                       \
    time)

vec3 Displacement(const GlyphSetRecord set, const uint primitive, const float time)
{
  return RTG_DISPLACEMENT(VELOCITIES, velocities, ACCELERATIONS, accelerations, primitive);
}

// Its rotation since then: a unit quaternion.
vec4 RotationSince(const GlyphSetRecord set, const uint primitive, const float time)
{
  return RotationBy(time * set.angularVelocities.at[InSet(set, ANGULAR_VELOCITIES, primitive)]);
}

// Moves a glyph to where it is at that time.
void Move(inout Glyph glyph, const GlyphSetRecord set, const uint primitive, const float time)
{
  if (Has(set.variants, VELOCITIES | ACCELERATIONS))
  {
    // The low part keeps the rounding of the new center.
    DoubleWord3 center = TwoSum(glyph.center, Displacement(set, primitive, time));
    glyph.center = center.hi;
    glyph.centerLow += center.lo;
  }
  if (Has(set.variants, ANGULAR_VELOCITIES))
  {
    // First the glyph's own rotation b, then a.
    vec4 a = RotationSince(set, primitive, time);
    vec4 b = glyph.rotation;
    vec4 product = vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
    glyph.rotation = product / sqrt(dot(product, product));
  }
}
