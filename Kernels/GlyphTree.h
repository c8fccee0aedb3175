#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace rtg
{

/// An axis-aligned box in single precision.
struct Box
{
  glm::vec3 lower;
  glm::vec3 upper;
};

/// A node of GlyphTree: the boxes of its four children, quantised to 8 bits a plane relative to its own.
/// After Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
/// High-Performance Graphics 2017, with four children instead of eight and without pointers.
struct GlyphTreeNode
{
  glm::vec3 origin;         ///< lower corner of the node's box
  std::uint8_t exponent[3]; ///< biased by 127: plane = origin + 2^(exponent - 127) * quantised
  std::uint8_t axes;        ///< split axes, 2 bits each: first split, lower pair, upper pair
  std::uint8_t lowerX[4], upperX[4]; ///< lower > upper: no child
  std::uint8_t lowerY[4], upperY[4];
  std::uint8_t lowerZ[4], upperZ[4];
};
static_assert(sizeof(GlyphTreeNode) == 40, "read by Programs/tree.glsl as five 64-bit words");

/// A bounding volume hierarchy over a set's glyphs whose shape follows from their number alone, so that it needs
/// no pointers: 2^leafBits leaves, leaf j holding the glyphs [start(j), start(j + 1)), start(j) = j * count >> leafBits;
/// four-way nodes level by level, node i of a level having nodes 4 i .. 4 i + 3 of the next as children. When
/// leafBits is odd, the root has two children.
///
/// Why it exists: on a CPU device every load of the driver's own traversal is a gather of eight lanes, the
/// most expensive thing there is, and lavapipe's binary nodes take fourteen for two boxes; these take five for four.
struct GlyphTree
{
  std::uint32_t leafBits = 0;
  std::uint32_t levels = 0; ///< of nodes, at least 1
  std::vector<GlyphTreeNode> nodes;

  /// Leaves hold two to four glyphs from `glyphsPerLeaf` = 4 on; at least one level.
  static std::uint32_t LeafBits(std::size_t count, std::size_t glyphsPerLeaf);
  static std::size_t Start(std::size_t leaf, std::size_t count, std::uint32_t leafBits)
  {
    return leaf * count >> leafBits;
  }
};

/// The order in which the glyphs must lie for a tree of 2^leafBits leaves to be a kd tree over their centres, and the
/// axes of its splits (in heap order: split i has splits 2 i + 1 and 2 i + 2 below it).
struct KdOrder
{
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> axes;
};
KdOrder MakeKdOrder(const std::vector<glm::vec3>& centres, std::uint32_t leafBits);

/// Builds the nodes over boxes that are in that order. The boxes must be padded for the arithmetic of the
/// traversal (see Scene.cxx).
GlyphTree BuildGlyphTree(
  const std::vector<Box>& boxes, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes);

} // namespace rtg
