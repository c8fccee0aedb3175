// A mesh glyph that moves: a shape like the others, whose intersection goes through the tree of its triangles
// (Kernels/MeshTree.h) in its own frame, at the time of the ray in flight.
#include "../Shapes/Dialect.glsl"
#include "../Shapes/Estimate.glsl"
#include "motion.glsl"
#include "tree.glsl"

// The glyph as if its centre were the middle of its mesh, which the positions on the device are relative to.
Glyph AboutMiddle(Glyph glyph, GlyphSetRecord set)
{
  DoubleWord3 middle = TwoSum(glyph.centre, RotateToWorld(glyph, glyph.size * set.meshMiddle));
  glyph.centre = middle.hi;
  glyph.centreLow += middle.lo;
  return glyph;
}

// The ray in the mesh's frame, from where it passes the middle; its parameter counts from the world ray's `start`.
struct MeshRay
{
  vec3 origin;
  vec3 direction;
  DoubleWord start;
};

MeshRay ToMesh(GlyphRay ray, Glyph glyph, GlyphSetRecord set)
{
  Glyph centred = AboutMiddle(glyph, set);
  LocalRay local = TurnToLocal(NearRay(ray, centred), centred);
  vec3 origin = local.origin.hi / glyph.size;
  MeshRay found;
  found.direction = local.direction.hi / glyph.size;
  // Sizes that differ move the nearest point.
  local = Advance(local, -dot(origin, found.direction) / dot(found.direction, found.direction));
  found.origin = local.origin.hi / glyph.size;
  found.start = local.start;
  return found;
}

// Time of the ray in flight for positions of meshes.
float MeshTime(GlyphSetRecord set)
{
  return meshVelocities || meshAccelerations ? set.shutterOpen + frame.rays.at[LaunchIndex()].time * set.shutterLength
                                             : 0.0;
}

// The same numbers whatever triangle asks.
vec3 CornerAt(GlyphSetRecord set, uint corner, float time)
{
  precise vec3 position = set.meshPositions.at[corner];
  if (meshVelocities || meshAccelerations)
  {
    precise vec3 displacement = vec3(0.0);
    if (meshAccelerations)
    {
      displacement = (0.5 * time) * set.meshAccelerations.at[corner];
    }
    if (meshVelocities)
    {
      displacement += set.meshVelocities.at[corner];
    }
    position += time * displacement;
  }
  return position;
}

// Makes the axis the last.
vec3 Cycled(vec3 v, uint axis)
{
  return axis == 0u ? v.yzx : axis == 1u ? v.zxy : v;
}

// A ray ready for triangles: shears that make it run along the last axis. After Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013. Rounding is monotone, so that the
// sign of an edge's function is right or zero, and zero counts as inside: rays find no gap between neighbours.
struct ShearedRay
{
  vec3 origin;
  vec3 shear;
  uint axis;
};

ShearedRay Shear(MeshRay ray)
{
  vec3 size = abs(ray.direction);
  ShearedRay sheared;
  sheared.origin = ray.origin;
  sheared.axis = size.x > size.y ? (size.x > size.z ? 0u : 2u) : (size.y > size.z ? 1u : 2u);
  vec3 d = Cycled(ray.direction, sheared.axis);
  sheared.shear = vec3(d.xy / d.z, 1.0 / d.z);
  return sheared;
}

vec3 Sheared(vec3 position, ShearedRay ray)
{
  precise vec3 p = Cycled(position - ray.origin, ray.axis);
  precise vec3 sheared = vec3(p.x - ray.shear.x * p.z, p.y - ray.shear.y * p.z, ray.shear.z * p.z);
  return sheared;
}

// Whether the line meets the triangle, where, and the weights of the corners there.
bool MeetsTriangle(ShearedRay ray, vec3 a, vec3 b, vec3 c, out float s, out vec3 weight)
{
  a = Sheared(a, ray);
  b = Sheared(b, ray);
  c = Sheared(c, ray);
  precise vec3 edges = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  float sum = edges.x + edges.y + edges.z;
  weight = edges / sum;
  s = dot(weight, vec3(a.z, b.z, c.z));
  bool negative = edges.x < 0.0 || edges.y < 0.0 || edges.z < 0.0;
  bool positive = edges.x > 0.0 || edges.y > 0.0 || edges.z > 0.0;
  return negative != positive && sum != 0.0;
}

// Nearest t in [tMin, tMax] where the ray meets a triangle, either side of it.
bool IntersectGlyph(GlyphRay worldRay, Glyph glyph, float tMin, float tMax, out float t, out uint triangle)
{
  GlyphSetRecord set = SetRecord(gl_InstanceCustomIndexEXT);
  MeshRay ray = ToMesh(worldRay, glyph, set);
  BoxRay boxRay = MakeBoxRay(ray.origin, ray.direction);
  ShearedRay sheared = Shear(ray);
  TreeNodes nodes = TreeNodes(set.meshTree);
  float time = MeshTime(set);
  uint slice = meshVelocities || meshAccelerations
    ? uint(frame.rays.at[LaunchIndex()].time * float(1u << set.meshTimeSliceBits))
    : 0u;
  uint firstNode = slice * set.meshNodesPerSlice;
  uint levels = set.meshTreeLevels;
  uint64_t count = uint64_t(set.meshTriangleCount);
  bool any = (gl_IncomingRayFlagsEXT & gl_RayFlagsTerminateOnFirstHitEXT) != 0u;

  float least = (tMin - ray.start.hi) - ray.start.lo;
  float nearest = (tMax - ray.start.hi) - ray.start.lo;
  bool found = false;
  triangle = nothing;
  TreePosition position = RootOfTree();
  uint i = 0u, end = 0u;
  bool going = true;
  do
  {
    if (position.level < levels)
    {
      uint mask, order;
      float behind;
      IntersectNode(nodes, firstNode + NodeNumber(position), boxRay, least, nearest, mask, order, behind);
      PushChildren(position, mask, order, behind);
    }
    else if (i < end)
    {
      uvec3 corner =
        uvec3(set.meshTriangles.at[3u * i], set.meshTriangles.at[3u * i + 1u], set.meshTriangles.at[3u * i + 2u]);
      float s;
      vec3 weight;
      if (MeetsTriangle(sheared, CornerAt(set, corner.x, time), CornerAt(set, corner.y, time),
            CornerAt(set, corner.z, time), s, weight) &&
        s >= least && s <= nearest)
      {
        found = true;
        nearest = s;
        triangle = i;
        DropHidden(position, nearest);
        going = !any;
      }
      ++i;
    }
    if (i >= end && going)
    {
      going = PopChild(position);
      uvec2 range = LeafRange(position, levels, count, set.meshTreeLeafBits);
      i = range.x;
      end = range.y;
    }
  } while (going);
  t = clamp(Add(ray.start, nearest).hi, tMin, tMax);
  return found;
}

// Says no more than that the ray passes the ball round the mesh.
int EstimateGlyph(GlyphRay ray, Glyph glyph, float tMin, float tMax, out float low, out float high)
{
  low = tMin;
  high = tMax;
  GlyphSetRecord set = SetRecord(gl_InstanceCustomIndexEXT);
  vec3 size = abs(glyph.size);
  vec3 middle = RotateToWorld(glyph, glyph.size * set.meshMiddle);
  float radius =
    set.meshRadius * max(size.x, max(size.y, size.z)) + 1e-6 * (abs(middle.x) + abs(middle.y) + abs(middle.z));
  return MissesBall(ray, glyph, middle, radius) ? RTG_MISSED : RTG_UNKNOWN;
}
