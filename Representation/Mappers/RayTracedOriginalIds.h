/**
 * Which point or cell each glyph or triangle stands for. Where each stands for that of its own number, as mostly, the
 * list is not kept: of many glyphs it would be the longest one.
 */
#ifndef RayTracedOriginalIds_h
#define RayTracedOriginalIds_h

#include "vtkType.h"

#include <numeric>
#include <utility>
#include <vector>

namespace rtglyphs
{

class RayTracedOriginalIds
{
public:
  RayTracedOriginalIds() = default;
  RayTracedOriginalIds(std::vector<vtkIdType> ids)
    : Count(static_cast<vtkIdType>(ids.size()))
  {
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      if (ids[i] != i)
      {
        this->List = std::move(ids);
        break;
      }
    }
  }

  vtkIdType operator[](vtkIdType i) const { return this->List.empty() ? i : this->List[i]; }
  vtkIdType size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }

  std::vector<vtkIdType> ToVector() const
  {
    std::vector<vtkIdType> ids = this->List;
    if (ids.empty())
    {
      ids.resize(this->Count);
      std::iota(ids.begin(), ids.end(), vtkIdType(0));
    }
    return ids;
  }

private:
  vtkIdType Count = 0;
  std::vector<vtkIdType> List; // empty: each its own
};

} // namespace rtglyphs

#endif
