/**
 * Ranges of points, or of cells, each of one block.
 */
#ifndef RayTracedRanges_h
#define RayTracedRanges_h

#include "vtkType.h"

#include <algorithm>
#include <string>
#include <vector>

namespace rtglyphs
{

struct RayTracedRange
{
  vtkIdType First = 0, End = 0;
  std::string Block; // name

  bool operator==(const RayTracedRange&) const = default;
};

/**
 * By rising number.
 */
struct RayTracedRanges : std::vector<RayTracedRange>
{
  bool Has(vtkIdType i) const
  {
    const auto next = std::upper_bound(
      this->begin(), this->end(), i, [](vtkIdType at, const RayTracedRange& range) { return at < range.First; });
    return next != this->begin() && i < (next - 1)->End;
  }
};

} // namespace rtglyphs

#endif
