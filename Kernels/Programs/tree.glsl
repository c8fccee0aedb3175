// Traversal of a GlyphTree (Kernels/GlyphTree.h), over glyphs or over the triangles of a mesh.
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer TreeNodes
{
  uint64_t word[];
};

// A path through the tree without a stack: the node is known by level and index, and for every level above it
// eight bits say which of the children are still to be visited, the first to be visited highest, and four in what
// order they are numbered.
struct TreePosition
{
  uint level;
  uint node;
  uvec2 pending; // levels 0 to 3, and 4 to 7
  uint orders;
};

TreePosition RootOfTree()
{
  return TreePosition(0u, 0u, uvec2(0u), 0u);
}

// Which of the `count` things are in the current node, when it is a leaf: from x up to y; otherwise none.
uvec2 LeafRange(const TreePosition position, const TreeRecord tree, const uint64_t count)
{
  return position.level == tree.levels
    ? uvec2((uint64_t(position.node) * count) >> tree.leafBits, (uint64_t(position.node + 1u) * count) >> tree.leafBits)
    : uvec2(0u);
}

// The ray prepared for boxes. Rounding moves the parameters t at which it meets their planes: by 2^-20 of the distance
// to the node, and by what it has left of the ray's origin (`tolerance`). A ray keeps that clear of planes itself, so
// that no glyph far away makes the boxes of others wider (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013); what the
// planes lie apart within a node adds to it, its boxes allow for (GlyphTree.cxx).
struct BoxRay
{
  vec3 origin;
  vec3 inverse;   // of the direction
  vec3 tolerance; // of t, >= 0
  uint signs;     // bit i: component i of the direction is negative
};

// `rounded`: as large as the numbers whose rounding the origin has.
BoxRay MakeBoxRay(const vec3 origin, const vec3 rounded, const vec3 direction)
{
  float longest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  float farthest = max(max(rounded.x, rounded.y), rounded.z);
  // Components next to zero count as 2^-64 of the longest, along which no ray gets far; as more, up to 2^-24, where
  // that would be no normal number, or overflow at boxes a million times as far away as the origin.
  float enough = max(max(longest * 5.4210108624275222e-20, farthest * 6.1629758220391547e-33), 1e-37);
  float least = min(longest * 5.9604644775390625e-8, enough);
  vec3 safe = mix(direction, vec3(least), lessThan(abs(direction), vec3(least)));
  vec3 inverse = 1.0 / safe;
  uint signs = (safe.x < 0.0 ? 1u : 0u) | (safe.y < 0.0 ? 2u : 0u) | (safe.z < 0.0 ? 4u : 0u);
  return BoxRay(origin, inverse, 2.384185791015625e-7 * rounded * abs(inverse), signs);
}

// Parameters at which the ray meets four planes along one axis.
vec4 PlaneParameters(const uint quantised, const float step, const float offset)
{
  vec4 q = vec4(quantised & 255u, (quantised >> 8) & 255u, (quantised >> 16) & 255u, quantised >> 24);
  return q * step + offset;
}

// min and max as one machine instruction, which gives the second where the first is NaN: planes whose parameters
// overflow leave nothing out.
vec4 Lesser(const vec4 a, const vec4 b)
{
  return vec4(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z, a.w < b.w ? a.w : b.w);
}

vec4 Greater(const vec4 a, const vec4 b)
{
  return vec4(a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z, a.w > b.w ? a.w : b.w);
}

uint Bits(const bvec4 set)
{
  return (set.x ? 1u : 0u) | (set.y ? 2u : 0u) | (set.z ? 4u : 0u) | (set.w ? 8u : 0u);
}

// Takes note of the children of the current node that the ray meets between tMin and tMax: bit 7 - rank for the child
// visited as number `rank`, and the order: child = rank ^ order.
void VisitNode(inout TreePosition position, const TreeRecord tree, const uint firstNode, const BoxRay ray,
  const float tMin, const float tMax)
{
  TreeNodes nodes = TreeNodes(tree.nodes);
  // 1 + 8 + 64 + ... nodes are on the levels above it.
  uint at = 8u * (firstNode + (0x09249249u & ((1u << (3u * position.level)) - 1u)) + position.node);
  // The root may have but 1, 2 or 4 children: where rounding is larger than all of the tree, rays would meet others.
  uint children = position.level > 0u ? 0xffu : (1u << (1u << (tree.leafBits - 3u * (tree.levels - 1u)))) - 1u;
  uvec2 originXY = unpack32(nodes.word[at]);
  uvec2 originZ = unpack32(nodes.word[at + 1u]);
  // Near planes are the lower ones where the direction is positive.
  uvec3 negative = uvec3(ray.signs & 1u, (ray.signs >> 1) & 1u, ray.signs >> 2);
  uvec3 nearAt = uvec3(at) + uvec3(2u, 4u, 6u) + negative;
  uvec3 farAt = uvec3(at) + uvec3(3u, 5u, 7u) - negative;
  uvec2 nearX = unpack32(nodes.word[nearAt.x]), farX = unpack32(nodes.word[farAt.x]);
  uvec2 nearY = unpack32(nodes.word[nearAt.y]), farY = unpack32(nodes.word[farAt.y]);
  uvec2 nearZ = unpack32(nodes.word[nearAt.z]), farZ = unpack32(nodes.word[farAt.z]);

  vec3 origin = vec3(uintBitsToFloat(originXY.x), uintBitsToFloat(originXY.y), uintBitsToFloat(originZ.x));
  uint exponents = originZ.y;
  vec3 step = vec3(uintBitsToFloat((exponents & 255u) << 23), uintBitsToFloat((exponents & 0xff00u) << 15),
                uintBitsToFloat((exponents & 0xff0000u) << 7)) *
    ray.inverse;
  vec3 offset = (origin - ray.origin) * ray.inverse;
  vec3 tolerance = abs(offset) * 9.5367431640625e-7 + ray.tolerance;
  vec3 toNear = offset - tolerance, toFar = offset + tolerance;

  vec4 near0 = Greater(PlaneParameters(nearX.x, step.x, toNear.x),
    Greater(
      PlaneParameters(nearY.x, step.y, toNear.y), Greater(PlaneParameters(nearZ.x, step.z, toNear.z), vec4(tMin))));
  vec4 far0 = Lesser(PlaneParameters(farX.x, step.x, toFar.x),
    Lesser(PlaneParameters(farY.x, step.y, toFar.y), Lesser(PlaneParameters(farZ.x, step.z, toFar.z), vec4(tMax))));
  vec4 near1 = Greater(PlaneParameters(nearX.y, step.x, toNear.x),
    Greater(
      PlaneParameters(nearY.y, step.y, toNear.y), Greater(PlaneParameters(nearZ.y, step.z, toNear.z), vec4(tMin))));
  vec4 far1 = Lesser(PlaneParameters(farX.y, step.x, toFar.x),
    Lesser(PlaneParameters(farY.y, step.y, toFar.y), Lesser(PlaneParameters(farZ.y, step.z, toFar.z), vec4(tMax))));
  uint met = (Bits(lessThanEqual(near0, far0)) | (Bits(lessThanEqual(near1, far1)) << 4)) & children;

  // Rank r visits child r ^ order: along each split's axis the ray's near side comes first.
  uint axes = exponents >> 24;
  uint order = (((ray.signs >> (axes & 3u)) & 1u) << 2) | (((ray.signs >> ((axes >> 2) & 3u)) & 1u) << 1) |
    ((ray.signs >> (axes >> 4)) & 1u);
  // From bit child to bit 7 - rank = child ^ order ^ 7.
  uint flips = order ^ 7u;
  met = (flips & 4u) != 0u ? ((met & 0x0fu) << 4) | (met >> 4) : met;
  met = (flips & 2u) != 0u ? ((met & 0x33u) << 2) | ((met >> 2) & 0x33u) : met;
  uint mask = (flips & 1u) != 0u ? ((met & 0x55u) << 1) | ((met >> 1) & 0x55u) : met;

  uint bits = mask << (8u * (position.level & 3u));
  position.pending |= position.level < 4u ? uvec2(bits, 0u) : uvec2(0u, bits);
  uint shift = 4u * position.level;
  position.orders = (position.orders & ~(15u << shift)) | (order << shift);
}

// Moves to the next child: the first pending one on the deepest level that has any. False: none is left.
bool PopChild(inout TreePosition position)
{
  bool deep = position.pending.y != 0u;
  uint word = deep ? position.pending.y : position.pending.x;
  if (word == 0u)
  {
    return false;
  }
  uint highest = uint(findMSB(word));
  uint bit = 1u << highest;
  position.pending ^= deep ? uvec2(0u, bit) : uvec2(bit, 0u);
  uint parentLevel = (highest >> 3) + (deep ? 4u : 0u);
  uint child = (7u - (highest & 7u)) ^ ((position.orders >> (4u * parentLevel)) & 7u);
  uint parent = position.node >> (3u * (position.level - parentLevel));
  position.node = 8u * parent + child;
  position.level = parentLevel + 1u;
  return true;
}
