#pragma once

#include "GlyphBoxes.h"

#include <cstdint>
#include <vector>

namespace rtg
{

/// A node of GlyphTree: the boxes of its eight children, quantized to 8 bits a plane relative to its own.
/// After Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
/// High-Performance Graphics 2017, without pointers.
///
/// Child c lies on the upper side of the node's first split when bit 2 of c is set, of its second and third when bits 1
/// and 0 are: visiting children in the order of c ^ s, where s has the bit of every split whose axis the ray runs
/// down, goes from near to far.
struct GlyphTreeNode
{
  glm::vec3 origin;         ///< lower corner of the node's box
  std::uint8_t exponent[3]; ///< biased by 127: plane = origin + 2^(exponent - 127) * quantized
  std::uint8_t axes;        ///< of the three splits, 2 bits each, the first split's lowest
  /// [axis][0: lower, 1: upper][child]; lower > upper: no child.
  std::uint8_t planes[3][2][8];
};
static_assert(sizeof(GlyphTreeNode) == 64, "read by Programs/tree.glsl as eight 64-bit words");

/// A bounding volume hierarchy over a set's glyphs whose shape follows from their number alone, so that it needs
/// no pointers: 2^leafBits leaves, leaf j holding the glyphs [start(j), start(j + 1)), start(j) = j * count >>
/// leafBits; eight-way nodes level by level, node i of a level having nodes 8 i .. 8 i + 7 of the next as children.
/// When leafBits is no multiple of three, the root has two or four children.
///
/// Why it exists: on a CPU device every load of the driver's own traversal is a gather of eight lanes, the
/// most expensive thing there is, and lavapipe's binary nodes take fourteen for two boxes; these take eight for eight.
struct GlyphTree
{
  std::uint32_t leafBits = 0;
  std::uint32_t levels = 0; ///< of nodes, 1 to maxLevels
  /// A tree of moving things has a version for each of 2^sliceBits slices of the shutter's opening. A ray reads the one
  /// in whose slice its time falls, where boxes are little longer than the things.
  std::uint32_t sliceBits = 0;
  std::uint32_t nodesPerSlice = 0;
  std::vector<GlyphTreeNode> nodes; ///< slice by slice
  /// Slice by slice, the place in the common order of the thing at each place of its tree; empty: all slices have that
  /// order.
  std::vector<std::uint32_t> order;

  static constexpr std::uint32_t maxLevels = 8; ///< what the traversal's 64-bit words hold

  /// Leaves hold about half to all of `glyphsPerLeaf`; at least two leaves.
  static std::uint32_t LeafBits(std::size_t count, std::size_t glyphsPerLeaf);
  static std::uint32_t Levels(std::uint32_t leafBits) { return (leafBits + 2) / 3; }
  static std::size_t Start(std::size_t leaf, std::size_t count, std::uint32_t leafBits)
  {
    return leaf * count >> leafBits;
  }
  /// Number of nodes on the levels above `level`, every level thought full: 1 + 8 + 64 + ...
  static std::size_t LevelOffset(std::uint32_t level) { return ((std::size_t(1) << (3 * level)) - 1) / 7; }
};

/// The order in which the glyphs must lie for a tree of 2^leafBits leaves to be a kd tree over the centers of their
/// boxes, and the axes of every node's splits, packed as GlyphTreeNode has them, node by node.
struct KdOrder
{
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> axes;
};
KdOrder MakeKdOrder(const BoxReader& boxes, std::uint32_t leafBits);

/// The surface of all leaves' boxes, to which the number of rays that meet them is in proportion: measures how good an
/// order is. Of very many leaves some ten thousand stand for all.
double LeafSurface(const BoxReader& boxes, std::uint32_t leafBits);

/// An order serves boxes that have moved until they leave the leaves this much more surface than when it was found.
constexpr double orderDecay = 1.2;

/// Builds the nodes over boxes in the order of MakeKdOrder(), so much wider than these as the arithmetic of the
/// traversal needs (BoxRay in Programs/tree.glsl).
GlyphTree BuildGlyphTree(const BoxReader& boxes, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes);

} // namespace rtg
