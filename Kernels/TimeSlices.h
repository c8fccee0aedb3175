// The trees of what moves: of glyphs and of triangles.
#pragma once

#include "GlyphTree.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace rtg
{

/// Largest ChooseSliceBits().
constexpr std::uint32_t maxTimeSliceBits = 5;

/// Logarithm to base 2 of the number of slices of the shutter's opening in which boxes round paths have at most twice
/// the surface of those of things at rest, as far as memory for the trees allows. `still`: the box of thing i at a
/// fraction of the opening; `moving`: the one round its path between two.
std::uint32_t ChooseSliceBits(std::size_t count, std::size_t bytesPerSlice,
  const std::function<DoubleBox(std::size_t i, double at)>& still,
  const std::function<DoubleBox(std::size_t i, double first, double last)>& moving);

/// A GlyphTree of 2^sliceBits slices, whose things have a common order, the kd order of the middle of the opening, with
/// the splits `axes`. `boxesBetween` gives their padded boxes in that order between two fractions of the opening. With
/// `sorts`, slices in which the common order would leave the leaves much more surface than
/// one of their own are sorted for themselves.
GlyphTree BuildSlices(std::uint32_t sliceBits, std::uint32_t leafBits, const std::vector<std::uint8_t>& axes,
  bool sorts, const std::function<std::vector<Box>(double first, double last)>& boxesBetween);

} // namespace rtg
