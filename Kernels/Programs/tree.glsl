// Traversal of a set's GlyphTree (Kernels/GlyphTree.h) inside its intersection program.
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer TreeNodes { uint64_t word[]; };

// A path through the tree without a stack: the node is known by level and index, and for every level
// on the way to it four bits say which of the children are still to be visited, in the order of visits,
// and four in what order that is.
struct TreePosition
{
  uint level;
  uint node;
  uint64_t pending;
  uint64_t orders;
};

// The ray prepared for boxes.
struct BoxRay
{
  vec3 origin;
  vec3 inverse;  // of the direction; components below 2^-60 of the longest count as that
  uint signs;    // bit i: component i of the direction is negative
};

BoxRay MakeBoxRay(vec3 origin, vec3 direction)
{
  float longest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  vec3 least = vec3(longest * 8.67361737988403547e-19);
  vec3 safe = mix(direction, least, lessThan(abs(direction), least));
  BoxRay ray;
  ray.origin = origin;
  ray.inverse = 1.0 / safe;
  ray.signs = (safe.x < 0.0 ? 1u : 0u) | (safe.y < 0.0 ? 2u : 0u) | (safe.z < 0.0 ? 4u : 0u);
  return ray;
}

// Parameters at which the ray meets four planes along one axis.
vec4 PlaneParameters(uint quantised, float step, float offset)
{
  vec4 q = vec4(quantised & 255u, (quantised >> 8) & 255u, (quantised >> 16) & 255u, quantised >> 24);
  return q * step + offset;
}

// Which of a node's four children the ray meets between tMin and tMax, in the order of visits, and that order.
void IntersectNode(TreeNodes nodes, uint index, BoxRay ray, float tMin, float tMax, out uint mask, out uint order)
{
  uint at = 5u * index;
  uvec2 originXY = unpack32(nodes.word[at]);
  uvec2 originZ = unpack32(nodes.word[at + 1u]);
  uvec2 planesX = unpack32(nodes.word[at + 2u]);
  uvec2 planesY = unpack32(nodes.word[at + 3u]);
  uvec2 planesZ = unpack32(nodes.word[at + 4u]);

  vec3 origin = vec3(uintBitsToFloat(originXY.x), uintBitsToFloat(originXY.y), uintBitsToFloat(originZ.x));
  uint exponents = originZ.y;
  vec3 step = vec3(uintBitsToFloat((exponents & 255u) << 23), uintBitsToFloat((exponents & 0xff00u) << 15),
    uintBitsToFloat((exponents & 0xff0000u) << 7)) * ray.inverse;
  vec3 offset = (origin - ray.origin) * ray.inverse;

  // Near planes are the lower ones where the direction is positive.
  bvec3 swap = bvec3((ray.signs & 1u) != 0u, (ray.signs & 2u) != 0u, (ray.signs & 4u) != 0u);
  vec4 nearT = max(max(PlaneParameters(swap.x ? planesX.y : planesX.x, step.x, offset.x),
                       PlaneParameters(swap.y ? planesY.y : planesY.x, step.y, offset.y)),
    max(PlaneParameters(swap.z ? planesZ.y : planesZ.x, step.z, offset.z), vec4(tMin)));
  vec4 farT = min(min(PlaneParameters(swap.x ? planesX.x : planesX.y, step.x, offset.x),
                      PlaneParameters(swap.y ? planesY.x : planesY.y, step.y, offset.y)),
    min(PlaneParameters(swap.z ? planesZ.x : planesZ.y, step.z, offset.z), vec4(tMax)));
  // One more ulp or two for the rounding of t itself (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
  bvec4 met = lessThanEqual(nearT, farT * 1.0000004);

  // Rank r visits child (r1 ^ s0, r0 ^ s1 or s2): along each split's axis the ray's near side comes first.
  uint axes = exponents >> 24;
  uint s0 = (ray.signs >> (axes & 3u)) & 1u;
  uint s1 = (ray.signs >> ((axes >> 2) & 3u)) & 1u;
  uint s2 = (ray.signs >> ((axes >> 4) & 3u)) & 1u;
  order = s0 | (s1 << 1) | (s2 << 2);
  uint lowerPair = (met.x ? 1u : 0u) | (met.y ? 2u : 0u);
  uint upperPair = (met.z ? 1u : 0u) | (met.w ? 2u : 0u);
  lowerPair = s1 != 0u ? (lowerPair >> 1) | ((lowerPair & 1u) << 1) : lowerPair;
  upperPair = s2 != 0u ? (upperPair >> 1) | ((upperPair & 1u) << 1) : upperPair;
  mask = s0 != 0u ? upperPair | (lowerPair << 2) : lowerPair | (upperPair << 2);
}

uint ChildOfRank(uint rank, uint order)
{
  uint upper = (rank >> 1) ^ (order & 1u);
  uint second = (rank & 1u) ^ ((upper != 0u ? order >> 2 : order >> 1) & 1u);
  return 2u * upper + second;
}

// Takes note of the children of the current node that are to be visited.
void PushChildren(inout TreePosition position, uint mask, uint order)
{
  uint shift = 4u * position.level;
  position.pending |= uint64_t(mask) << shift;
  position.orders = (position.orders & ~(uint64_t(15u) << shift)) | (uint64_t(order) << shift);
}

// Moves to the next child: the first pending one on the deepest level that has any. False: none is left.
bool PopChild(inout TreePosition position)
{
  uvec2 halves = unpack32(position.pending);
  if ((halves.x | halves.y) == 0u)
  {
    return false;
  }
  uint highest = halves.y != 0u ? 32u + uint(findMSB(halves.y)) : uint(findMSB(halves.x));
  uint parentLevel = highest >> 2;
  uint shift = 4u * parentLevel;
  uint mask = uint(position.pending >> shift) & 15u;
  uint rank = uint(findLSB(mask));
  position.pending &= ~(uint64_t(1u) << (shift + rank));
  uint order = uint(position.orders >> shift) & 15u;
  uint parent = position.node >> (2u * (position.level - parentLevel));
  position.node = 4u * parent + ChildOfRank(rank, order);
  position.level = parentLevel + 1u;
  return true;
}
