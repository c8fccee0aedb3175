/**
 * @file    DataSummary.h
 * @brief   numbers that a representation finds in its data
 *
 * The client carries them from the processes that have the data to itself and to those that only render. Numbers are 0
 * where there is nothing to find, the range of tensors is 1 to -1.
 */
#ifndef DataSummary_h
#define DataSummary_h

#include <array>

namespace rtglyphs::DataSummary
{

enum Numbers
{
  SCALE_FACTOR,       // that the data suggest, GlyphScaleGuess
  SIZE_LIMIT,         // of the same
  LIMITED_FRACTION,   // of the glyphs, that have the limit
  SHUTTER_TIME,       // that the data suggest, GlyphShutterGuess
  LEAST_OF_TENSORS,   // of the numbers of GlyphTensorColoring
  LARGEST_OF_TENSORS, // the same
  NEGATIVE_TENSORS,   // the fraction that has a negative eigenvalue
  SCALE_PERCENTILE,   // of arrows with fixed heads, GlyphContent
  MESH_WIDTH,         // of mesh glyphs
  MESH_HEIGHT,        // the same
  LARGEST_MAGNITUDE,  // for the legend
  SIZE
};

using Values = std::array<double, SIZE>;

constexpr Values None()
{
  Values none{};
  none[LEAST_OF_TENSORS] = 1.0;
  none[LARGEST_OF_TENSORS] = -1.0;
  return none;
}

} // namespace rtglyphs::DataSummary

#endif
