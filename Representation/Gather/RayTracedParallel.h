/**
 * Loops over points, cells or bytes on all cores.
 *
 * Work is cut into chunks of a fixed length. What is put together chunk by chunk, in their order, is the same for any
 * number of threads. Memory is allocated before the loop.
 */
#ifndef RayTracedParallel_h
#define RayTracedParallel_h

#include "vtkType.h"

#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numeric>
#include <vector>

namespace rtglyphs::RayTracedParallel
{
constexpr vtkIdType ChunkSize = 1 << 14;

inline vtkIdType NumberOfChunks(vtkIdType count)
{
  return (count + ChunkSize - 1) / ChunkSize;
}

inline vtkIdType ChunkOf(vtkIdType i)
{
  return i / ChunkSize;
}

/**
 * Gets the fraction of the work done, in [0, 1], from the thread that started the loop; may be empty.
 */
using Progress = std::function<void(double)>;

/**
 * `progress`, or an empty one where work on that many items takes too short a time for a message.
 */
Progress Worthwhile(const Progress& progress, vtkIdType count);

/**
 * Progress of work that takes `whole` from one fraction to another.
 */
Progress Part(const Progress& whole, double first, double last);

/**
 * work(begin, end) for each chunk of [0, count).
 *
 * The threads are those of the kernels (Kernels/Parallel.h), which from then on are as many as VTK's SMP tools would
 * take. Where these know no threads, as in Debian's packages, and VTK_SMP_BACKEND_IN_USE does not ask for that, there
 * is one a core.
 */
void ForChunks(vtkIdType count, const std::function<void(vtkIdType, vtkIdType)>& work, const Progress& progress = {});

/**
 * The wanted ones of 0, ..., count - 1, in this order. isWanted(i) is called twice.
 */
template <class IsWanted>
std::vector<vtkIdType> Select(vtkIdType count, const IsWanted& isWanted)
{
  std::vector<vtkIdType> ends(NumberOfChunks(count) + 1, 0);
  ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType wanted = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        wanted += isWanted(i) ? 1 : 0;
      }
      ends[ChunkOf(begin) + 1] = wanted;
    });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<vtkIdType> selected(ends.back());
  ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType next = ends[ChunkOf(begin)];
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (isWanted(i))
        {
          selected[next++] = i;
        }
      }
    });
  return selected;
}

/**
 * The largest of zero and value(0), ..., value(count - 1). NaN does not count.
 */
template <class Value>
double Largest(vtkIdType count, const Value& value)
{
  std::vector<double> largest(NumberOfChunks(count), 0.0);
  ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      double& own = largest[ChunkOf(begin)];
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double v = value(i);
        own = v > own ? v : own;
      }
    });
  double all = 0.0;
  for (double own : largest)
  {
    all = own > all ? own : all;
  }
  return all;
}

/**
 * A box without points has Lower above Upper.
 */
struct Box
{
  glm::dvec3 Lower{ HUGE_VAL }, Upper{ -HUGE_VAL };
  bool IsEmpty() const { return !(this->Lower.x <= this->Upper.x); }
  glm::dvec3 Center() const { return 0.5 * (this->Lower + this->Upper); }
  void Add(const glm::dvec3& lower, const glm::dvec3& upper)
  {
    this->Lower = glm::min(this->Lower, lower);
    this->Upper = glm::max(this->Upper, upper);
  }
};

/**
 * The box of what add(begin, end, box) adds to the box of its chunk.
 */
Box BoxOf(vtkIdType count, const std::function<void(vtkIdType, vtkIdType, Box&)>& add);
}

#endif
