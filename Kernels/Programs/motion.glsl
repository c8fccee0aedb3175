// Where a glyph is at the time of the ray in flight (Kernels/Motion.h). Specialised per hit group.
layout(constant_id = 30) const bool hasVelocities = false;
layout(constant_id = 31) const bool hasAccelerations = false;
layout(constant_id = 32) const bool spins = false;
layout(constant_id = 40) const bool meshVelocities = false;  // the positions of the set's mesh move
layout(constant_id = 41) const bool meshAccelerations = false;
const bool displaced = hasVelocities || hasAccelerations;
const bool setMoves = displaced || spins || meshVelocities || meshAccelerations;

// Where a set's motion is found, and the time: read once a program, not once a glyph.
struct MotionSource
{
  Vec3Array velocities;
  Vec3Array accelerations;
  Vec3Array angularVelocities;
  float time;
};

MotionSource CurrentMotion(GlyphSetRecord set)
{
  MotionSource source;
  source.velocities = set.velocities;
  source.accelerations = set.accelerations;
  source.angularVelocities = set.angularVelocities;
  source.time = 0.0;
  if (setMoves)
  {
    source.time = set.shutterOpen + frame.rays.at[LaunchIndex()].time * set.shutterLength;
  }
  return source;
}

// Which of the tree's versions the ray in flight needs.
uint CurrentSlice(GlyphSetRecord set)
{
  return setMoves ? uint(frame.rays.at[LaunchIndex()].time * float(1u << set.timeSliceBits)) : 0u;
}

// Unit quaternion (x, y, z, w) of a turn by the vector's length round its direction.
vec4 TurnBy(vec3 rotation)
{
  vec3 halfway = 0.5 * rotation;
  float angle = length(halfway);
  return angle > 0.0 ? vec4(halfway * (sin(angle) / angle), cos(angle)) : vec4(0.0, 0.0, 0.0, 1.0);
}

void Move(inout Glyph glyph, MotionSource source, uint primitive)
{
  if (displaced)
  {
    vec3 displacement = vec3(0.0);
    if (hasAccelerations)
    {
      displacement = (0.5 * source.time) * source.accelerations.at[primitive];
    }
    if (hasVelocities)
    {
      displacement += source.velocities.at[primitive];
    }
    // What rounding the new centre would lose stays in the low part.
    DoubleWord3 centre = TwoSum(glyph.centre, displacement * source.time);
    glyph.centre = centre.hi;
    glyph.centreLow += centre.lo;
  }
  if (spins)
  {
    // First the glyph's own rotation b, then the turn a.
    vec4 a = TurnBy(source.time * source.angularVelocities.at[primitive]);
    vec4 b = glyph.rotation;
    vec4 product = vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
    glyph.rotation = normalize(product);
  }
}
