// A glyph that is a copy of a mesh. With a tree of our own (MESH_TREE) it is a shape like the others, whose
// intersection goes through the tree of its triangles (Kernels/MeshTree.h) in its own frame, at the time of the ray in
// flight; without one the driver's BVH has its triangles.
#include "tree.glsl"
#include "triangle.glsl"

// The ray in the mesh's frame, from where it passes the middle; its parameter counts from the world ray's `start`.
struct MeshRay
{
  vec3 origin;
  vec3 direction;
  DoubleWord start;
};

MeshRay ToMesh(const GlyphRay ray, const Glyph glyph, const GlyphSetRecord set)
{
  // The center is the middle of the mesh, which the positions on the device are relative to.
  Glyph centered = glyph;
  DoubleWord3 middle = TwoSum(glyph.center, RotateToWorld(glyph, glyph.size * set.meshMiddle));
  centered.center = middle.hi;
  centered.centerLow += middle.lo;
  LocalRay local = RotateToLocal(NearRay(ray, centered), centered);
  vec3 origin = local.origin.hi / glyph.size;
  vec3 direction = local.direction.hi / glyph.size;
  // Sizes that differ move the nearest point.
  local = Advance(local, -dot(origin, direction) / dot(direction, direction));
  return MeshRay(local.origin.hi / glyph.size, direction, local.start);
}

// Time of the ray in flight for positions of meshes.
float MeshTime(const GlyphSetRecord set)
{
  return Has(set.variants, MOVING_MESH) ? TimeOf(set) : 0.0;
}

// The same numbers for each triangle of the edge.
vec3 CornerAt(const GlyphSetRecord set, const uint corner, const float time)
{
  vec3 position = set.meshPositions.at[corner];
  if (Has(set.variants, MOVING_MESH))
  {
    position += RTG_DISPLACEMENT(MESH_VELOCITIES, meshVelocities, MESH_ACCELERATIONS, meshAccelerations, corner);
  }
  return position;
}

// Makes the axis the last.
vec3 Cycled(const vec3 v, const uint axis)
{
  return axis == 0u ? v.yzx : axis == 1u ? v.zxy : v;
}

// A ray ready for triangles: shears that make it run along the last axis. After Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013. Rounding is monotone, so that the
// sign of an edge's function is right or zero, and zero counts as inside: rays find no gap between neighbors.
struct ShearedRay
{
  vec3 origin;
  vec3 shear;
  uint axis;
};

ShearedRay Shear(const MeshRay ray)
{
  vec3 size = abs(ray.direction);
  uint axis = size.x > size.y ? (size.x > size.z ? 0u : 2u) : (size.y > size.z ? 1u : 2u);
  vec3 d = Cycled(ray.direction, axis);
  return ShearedRay(ray.origin, vec3(d.xy / d.z, 1.0 / d.z), axis);
}

vec3 Sheared(const vec3 position, const ShearedRay ray)
{
  vec3 p = Cycled(position - ray.origin, ray.axis);
  return vec3(p.x - ray.shear.x * p.z, p.y - ray.shear.y * p.z, ray.shear.z * p.z);
}

// Whether the line meets the triangle, where, and the weights of the corners there.
bool IntersectTriangle(const ShearedRay ray, vec3 a, vec3 b, vec3 c, out float s, out vec3 weight)
{
  a = Sheared(a, ray);
  b = Sheared(b, ray);
  c = Sheared(c, ray);
  vec3 edges = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  float sum = edges.x + edges.y + edges.z;
  weight = edges / sum;
  s = dot(weight, vec3(a.z, b.z, c.z));
  bool negative = edges.x < 0.0 || edges.y < 0.0 || edges.z < 0.0;
  bool positive = edges.x > 0.0 || edges.y > 0.0 || edges.z > 0.0;
  return negative != positive && sum != 0.0;
}

// Nearest t in [tMin, tMax] where the ray meets a triangle, either side of it.
bool IntersectMesh(const GlyphSetRecord set, const GlyphRay worldRay, const Glyph glyph, const float tMin,
  const float tMax, const bool any, out float t, out uint triangle)
{
  MeshRay ray = ToMesh(worldRay, glyph, set);
  // Triangles are met by the same rounded ray; their boxes allow for the rest.
  BoxRay boxRay = MakeBoxRay(ray.origin, vec3(0.0), ray.direction);
  ShearedRay sheared = Shear(ray);
  TreeRecord tree = set.meshTree;
  float time = MeshTime(set);
  uint slice = Has(set.variants, MOVING_MESH) ? SliceOf(tree.sliceBits) : 0u;
  uint firstNode = slice * tree.nodesPerSlice;
  uint64_t count = uint64_t(set.meshTriangleCount);

  float least = (tMin - ray.start.hi) - ray.start.lo;
  float nearest = (tMax - ray.start.hi) - ray.start.lo;
  bool found = false;
  triangle = nothing;
  TreePosition position = RootOfTree();
  uvec2 leaf = uvec2(0u); // what is left of the current one
  bool going = true;
  do
  {
    if (position.level < tree.levels)
    {
      VisitNode(position, tree, firstNode, boxRay, least, nearest);
    }
    else if (leaf.x < leaf.y)
    {
      uvec3 corner = CornersOf(set, leaf.x);
      float s;
      vec3 weight;
      if (IntersectTriangle(sheared, CornerAt(set, corner.x, time), CornerAt(set, corner.y, time),
            CornerAt(set, corner.z, time), s, weight) &&
        s >= least && s <= nearest)
      {
        found = true;
        nearest = s;
        triangle = leaf.x;
        going = !any;
      }
      ++leaf.x;
    }
    if (leaf.x >= leaf.y && going)
    {
      going = PopChild(position);
      leaf = LeafRange(position, tree, count);
    }
  } while (going);
  t = clamp(Add(ray.start, nearest).hi, tMin, tMax);
  return found;
}

// Whether the ray certainly misses the ball round the mesh.
bool MissesMesh(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph)
{
  vec3 middle = RotateToWorld(glyph, glyph.size * set.meshMiddle);
  float radius = set.meshRadius * LargestOf(glyph.size) + 1e-6 * (abs(middle.x) + abs(middle.y) + abs(middle.z));
  return MissesBall(ray, glyph, middle, radius);
}

// A triangle where a ray meets it.
struct TriangleCrossing
{
  float t;
  uvec3 corner;
  vec3 a, b, c; // the corners' positions at the time of the ray
  vec3 weight;  // of the corners
};

TriangleCrossing CrossTriangle(const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const uint triangle)
{
  TriangleCrossing crossing;
  crossing.corner = CornersOf(set, triangle);
  float time = MeshTime(set);
  crossing.a = CornerAt(set, crossing.corner.x, time);
  crossing.b = CornerAt(set, crossing.corner.y, time);
  crossing.c = CornerAt(set, crossing.corner.z, time);
  MeshRay meshRay = ToMesh(ray, glyph, set);
  float s;
  bool meets = IntersectTriangle(Shear(meshRay), crossing.a, crossing.b, crossing.c, s, crossing.weight);
  if (rayQueries && !meets)
  {
    // The driver's arithmetic lets a ray meet what it passes by a rounding error: there the nearest edge is met.
    vec3 inside = mix(vec3(0.0), crossing.weight, greaterThan(crossing.weight, vec3(0.0)));
    float sum = inside.x + inside.y + inside.z;
    crossing.weight = sum > 0.0 && !isinf(sum) ? inside / sum : vec3(1.0, 0.0, 0.0);
    vec3 direction = meshRay.direction;
    vec3 position = crossing.weight.x * crossing.a + crossing.weight.y * crossing.b + crossing.weight.z * crossing.c;
    s = dot(position - meshRay.origin, direction) / dot(direction, direction);
  }
  crossing.t = Add(meshRay.start, s).hi;
  return crossing;
}

vec4 TriangleColor(
  const GlyphSetRecord set, const GlyphRay ray, const Glyph glyph, const uint number, const uint triangle)
{
  TriangleCrossing crossing = CrossTriangle(set, ray, glyph, triangle);
  return TriangleColor(set, crossing.corner, crossing.weight, triangle, number);
}

// The shortest rotation that takes the direction `from` to the direction `to`, both unit, of v.
vec3 RotateByShortestArc(const vec3 from, const vec3 to, const vec3 v)
{
  float c = 1.0 + dot(from, to);
  vec3 sum = from + to;
  return c > 1e-6 ? v + 2.0 * dot(from, v) * to - (dot(sum, v) / c) * sum : -v;
}

SurfaceHit HitOnMesh(const uint record, const GlyphSetRecord set, const Glyph glyph, const GlyphRay ray,
  const uint number, const float t, const uint triangle)
{
  TriangleCrossing crossing = CrossTriangle(set, ray, glyph, triangle);
  uvec3 corner = crossing.corner;
  vec3 normal = NormalOf(crossing.b - crossing.a, crossing.c - crossing.a);
  vec3 smoothed = normal;
  if (Has(set.variants, MESH_NORMALS))
  {
    smoothed = SmoothNormal(set, corner, crossing.weight, normal);
    if (Has(set.variants, MOVING_MESH))
    {
      // The corners' normals are those of the mesh at rest: they rotate with the triangle.
      vec3 rest = set.meshPositions.at[corner.x];
      vec3 before = NormalOf(set.meshPositions.at[corner.y] - rest, set.meshPositions.at[corner.z] - rest);
      bool flat_ = min(dot(before, before), dot(normal, normal)) <= 0.0;
      smoothed = !flat_ ? RotateByShortestArc(normalize(before), normalize(normal), smoothed) : smoothed;
    }
  }
  SurfaceHit hit;
  hit.t = t;
  // Normals transform with the inverse transpose.
  vec3 size = glyph.size / LargestOf(glyph.size);
  hit.shadingNormal = UnitNormal(RotateToWorld(glyph, smoothed / size), ray.direction);
  // On the same side, in whichever order the corners are given.
  hit.normal = UnitNormal(RotateToWorld(glyph, normal / size), ray.direction);
  hit.normal = dot(hit.shadingNormal, hit.normal) < 0.0 ? -hit.normal : hit.normal;
  hit.record = record;
  hit.glyph = set.identifiesTriangles != 0u ? triangle : number;
  hit.error = leavesSurface ? 2e-6 * set.meshRadius * LargestOf(glyph.size) : 0.0;
  if (leavesSurface && rayQueries && !Has(set.variants, MESH_TREE))
  {
    // The driver's test of the next ray works with its origin rounded to float, in the mesh's frame once more.
    hit.error += 1e-6 * LargestOf(abs(ray.origin) + abs(ray.direction) * t);
  }
  hit.color = TriangleColor(set, corner, crossing.weight, triangle, number);
  return hit;
}
