/**
 * Which point or cell each glyph or triangle stands for. Where each stands for that of its own number, as mostly, the
 * list is not kept: of many glyphs it would be the longest one.
 */
#ifndef RayTracedSources_h
#define RayTracedSources_h

#include "vtkType.h"

#include <numeric>
#include <utility>
#include <vector>

namespace rtglyphs
{

class RayTracedSources
{
public:
  RayTracedSources() = default;
  RayTracedSources(std::vector<vtkIdType> sources)
    : Count(static_cast<vtkIdType>(sources.size()))
  {
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      if (sources[i] != i)
      {
        this->List = std::move(sources);
        break;
      }
    }
  }

  vtkIdType operator[](vtkIdType i) const { return this->List.empty() ? i : this->List[i]; }
  vtkIdType size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }

  std::vector<vtkIdType> ToVector() const
  {
    std::vector<vtkIdType> sources = this->List;
    if (sources.empty())
    {
      sources.resize(this->Count);
      std::iota(sources.begin(), sources.end(), vtkIdType(0));
    }
    return sources;
  }

private:
  vtkIdType Count = 0;
  std::vector<vtkIdType> List; // empty: each its own
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedSources.h
