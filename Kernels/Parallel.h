// Loops on all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace rtg
{

/// How many threads loops take from now on, the calling one included; at least 1. Default: one a core. Results do not
/// depend on it.
void SetThreadCount(std::size_t count);
std::size_t ThreadCount();

/// work(0) ... work(count - 1), each once, in any order, on the calling thread and those of the process's pool; returns
/// when all is done. Loops may be nested, and started from any thread. When a call throws, no further ones begin, and
/// the first of the exceptions is thrown here.
///
/// The threads are made by the first loops that want them and stay: making a thread costs as much as a small loop.
void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& work);

/// Items of a loop that one thread takes at once. A constant, so that what is put together chunk by chunk is the same
/// for any number of threads.
constexpr std::size_t parallelChunk = 4096;

/// work(first, last) for each chunk of [0, count).
template <class Work>
void ParallelChunks(std::size_t count, Work&& work)
{
  ParallelFor((count + parallelChunk - 1) / parallelChunk,
    [&](std::size_t chunk) { work(chunk * parallelChunk, std::min(count, (chunk + 1) * parallelChunk)); });
}

/// work(i) for each i of [0, count), chunk by chunk.
template <class Work>
void ParallelEach(std::size_t count, Work&& work)
{
  ParallelChunks(count,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        work(i);
      }
    });
}

} // namespace rtg
