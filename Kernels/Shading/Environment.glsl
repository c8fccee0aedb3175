// Light from an image in longitude and latitude (Kernels/Environment.h), in two parts: what is below the threshold is
// found by rays that scatter there, what exceeds it is sampled as a light.

const float environmentPi = 3.14159265358979;

vec3 EnvironmentTexel(uvec2 at)
{
  at = min(at, frame.environmentSize - 1u);
  return frame.environmentTexels.at[at.y * frame.environmentSize.x + at.x];
}

// Radiance of a scattered ray, times the environment's color and strength.
vec3 ClampedEnvironment(const vec3 direction)
{
  vec3 d = normalize(direction);
  vec3 front = cross(frame.environmentRight, frame.environmentUp);
  float longitude = atan(dot(d, front), dot(d, frame.environmentRight));
  float latitude = asin(clamp(dot(d, frame.environmentUp), -1.0, 1.0));
  vec2 at = vec2(longitude / (2.0 * environmentPi) + 0.5, latitude / environmentPi + 0.5);
  vec3 seen = EnvironmentTexel(uvec2(clamp(at, 0.0, 1.0) * vec2(frame.environmentSize)));
  return frame.environment * min(seen, vec3(frame.environmentThreshold));
}

// A direction toward what exceeds the threshold, and that radiance over the density of the direction.
vec3 SampleEnvironment(const vec2 pick, const vec2 place, out vec3 direction)
{
  uint count = frame.environmentCellColumns * frame.environmentCellRows;
  uint cell = min(uint(pick.x * float(count)), count - 1u);
  bool aliased = pick.y >= uintBitsToFloat(frame.environmentCells.at[3u * cell]);
  cell = aliased ? frame.environmentCells.at[3u * cell + 1u] : cell;
  float density = uintBitsToFloat(frame.environmentCells.at[3u * cell + 2u]);
  uvec2 first =
    uvec2(cell % frame.environmentCellColumns, cell / frame.environmentCellColumns) * frame.environmentCellSide;
  uvec2 last = min(first + frame.environmentCellSide, frame.environmentSize);
  // Evenly over the cell's solid angle: the sine of the latitude is even.
  float low = -cos(environmentPi * float(first.y) / float(frame.environmentSize.y));
  float high = -cos(environmentPi * float(last.y) / float(frame.environmentSize.y));
  float sine = clamp(low + place.y * (high - low), -1.0, 1.0);
  float column = float(first.x) + place.x * float(last.x - first.x);
  float row = (asin(sine) / environmentPi + 0.5) * float(frame.environmentSize.y);
  float longitude = (column / float(frame.environmentSize.x) - 0.5) * 2.0 * environmentPi;
  float cosine = sqrt(max(1.0 - sine * sine, 0.0));
  vec3 front = cross(frame.environmentRight, frame.environmentUp);
  direction =
    normalize(cosine * (cos(longitude) * frame.environmentRight + sin(longitude) * front) + sine * frame.environmentUp);
  uvec2 at = clamp(uvec2(column, max(row, 0.0)), first, last - 1u);
  vec3 above = max(EnvironmentTexel(at) - frame.environmentThreshold, vec3(0.0));
  return density > 0.0 ? frame.environment * above / density : vec3(0.0);
}
