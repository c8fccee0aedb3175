/**
 * Loops over points or cells on all cores.
 *
 * Work is cut into chunks of a fixed length. What is put together chunk by chunk, in their order, is the same for any
 * number of threads. Memory is allocated before the loop.
 */
#ifndef RayTracedParallel_h
#define RayTracedParallel_h

#include "Box.h"
#include "vtkType.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
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
 * Progress of work that takes `whole`, which is not empty, from one fraction to another.
 */
inline Progress Part(const Progress& whole, double first, double last)
{
  return [whole, first, last](double share) { whole(first + share * (last - first)); };
}

/**
 * work(begin, end) for each chunk of [0, count).
 *
 * The threads are those of the kernels (Kernels/Parallel.h), which from then on are as many as VTK's SMP tools would
 * take. Where these know no threads, as in Debian's packages, and VTK_SMP_BACKEND_IN_USE does not ask for that, there
 * is one a core.
 */
void ForChunks(vtkIdType count, const std::function<void(vtkIdType, vtkIdType)>& work, const Progress& progress = {});

/**
 * work(i) for each i of [0, count).
 */
template <class Work>
void ForEach(vtkIdType count, const Work& work, const Progress& progress = {})
{
  ForChunks(
    count,
    [&work](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(i);
      }
    },
    progress);
}

/**
 * What add(begin, end, own) makes of `nothing` for each chunk, which join(all, own) puts together.
 */
template <class Value, class Add, class Join>
Value Reduce(vtkIdType count, const Value& nothing, const Add& add, const Join& join)
{
  std::vector<Value> parts(NumberOfChunks(count), nothing);
  ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      // Threads would wait for each other's cache lines if they wrote beside each other at each point.
      Value own = nothing;
      add(begin, end, own);
      parts[ChunkOf(begin)] = std::move(own);
    });
  Value all = nothing;
  for (const Value& own : parts)
  {
    join(all, own);
  }
  return all;
}

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
  return Reduce(
    count, 0.0,
    [&value](vtkIdType begin, vtkIdType end, double& own)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        own = std::max(own, value(i)); // the first where the second is NaN
      }
    },
    [](double& all, double own) { all = std::max(all, own); });
}

/**
 * The box of what add(begin, end, box) adds to the box of its chunk.
 */
template <class Add>
rtg::DoubleBox BoxOf(vtkIdType count, const Add& add)
{
  return Reduce(count, rtg::DoubleBox(), add, [](rtg::DoubleBox& all, const rtg::DoubleBox& own) { all.Include(own); });
}
}

#endif
