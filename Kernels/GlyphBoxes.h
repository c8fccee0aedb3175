// Boxes of glyphs, for acceleration structures.
#pragma once

#include "Box.h"
#include "Glyphs.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace rtg
{

/// Boxes of the glyphs relative to instances.origin, tight but for 2e-6 of a glyph's size and the outward rounding to
/// float: of glyphs that move, of all they touch between two fractions of the shutter's opening, 0 <= first <= last
/// <= 1.
std::vector<Box> GlyphBoxes(const GlyphInstances& instances, double first = 0.0, double last = 1.0);

/// Whether the glyphs are balls at rest, whose boxes are found as fast as read.
bool AreBalls(const GlyphInstances& instances);

/// GlyphBoxes() for a BoxReader: none of balls.
std::vector<Box> ListedBoxes(const GlyphInstances& instances);

/// The box of a ball about `center`, which is the sum of two.
Box BallBox(const glm::vec3& center, const glm::vec3& centerLow, float size);

/// Boxes that are read one by one: of a list, or of the balls of instances, which are computed when they are read. A
/// list of the boxes of many balls would take more memory than the balls, and a sorted copy of it more than a tree.
/// Lists, instances and orders must stay.
class BoxReader
{
public:
  BoxReader(const std::vector<Box>& boxes)
    : boxes_(&boxes)
  {
  }
  /// `boxes`: ListedBoxes() of the instances.
  BoxReader(const GlyphInstances& instances, const std::vector<Box>& boxes)
    : boxes_(AreBalls(instances) ? nullptr : &boxes)
    , balls_(&instances)
  {
  }
  /// These boxes in that order; in their own when it is empty.
  BoxReader(const BoxReader& boxes, const std::vector<std::uint32_t>& order)
    : BoxReader(boxes)
  {
    this->order_ = order.empty() ? nullptr : order.data();
  }

  std::size_t Count() const { return this->boxes_ ? this->boxes_->size() : this->balls_->Count(); }

  Box operator[](std::size_t place) const
  {
    const std::size_t i = this->order_ ? this->order_[place] : place;
    return this->boxes_ ? (*this->boxes_)[i] : this->BallBoxAt(i);
  }

  /// Half the extent, about, of a box in the boxes' own order.
  glm::vec3 HalfExtent(std::size_t i) const
  {
    return this->boxes_ ? 0.5f * ((*this->boxes_)[i].upper - (*this->boxes_)[i].lower)
                        : glm::vec3(0.5f * std::abs(this->BallSize(i)));
  }

private:
  float BallSize(std::size_t i) const
  {
    return this->balls_->sizes1.empty() ? this->balls_->uniformSize : this->balls_->sizes1[i];
  }
  Box BallBoxAt(std::size_t i) const
  {
    const glm::vec3 low = this->balls_->centersLow.empty() ? glm::vec3(0.0f) : this->balls_->centersLow[i];
    return BallBox(this->balls_->centers[i], low, this->BallSize(i));
  }

  const std::vector<Box>* boxes_ = nullptr;
  const GlyphInstances* balls_ = nullptr;
  const std::uint32_t* order_ = nullptr;
};

/// The box of all.
Box UnionOf(const BoxReader& boxes);

/// A list of the boxes in that order; in their own when it is empty.
std::vector<Box> InOrder(const BoxReader& boxes, const std::vector<std::uint32_t>& order);

/// The box of a glyph of these sizes, not rotated, relative to its center; of polynomials the largest. None of
/// Shape::Mesh.
DoubleBox GlyphExtent(Shape shape, const ArrowForm& arrow, const glm::dvec3& size);

/// ChooseSliceBits() of glyphs (TimeSlices.h).
std::uint32_t TimeSliceBits(const GlyphInstances& instances, std::size_t bytesPerSlice);

} // namespace rtg
