#include "RayTracedParallel.h"

#include "Parallel.h"

#include "vtkSMPTools.h"

#include <cstdlib>
#include <string>
#include <thread>

namespace
{
// Chunks between two calls of a Progress, some tenths of a second of work; shorter work has none.
constexpr vtkIdType chunksPerReport = 32;

// As many as VTK's SMP tools would take. Where these know no threads, as in Debian's packages, and
// VTK_SMP_BACKEND_IN_USE does not ask for that, one a core, or VTK_SMP_MAX_THREADS.
std::size_t Threads()
{
  const char* most = std::getenv("VTK_SMP_MAX_THREADS");
  const bool threaded = std::string(vtkSMPTools::GetBackend()) != "Sequential";
  if (threaded || std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  }
  const int wanted = most ? std::atoi(most) : 0;
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedParallel::ForChunks(
  vtkIdType count, const std::function<void(vtkIdType, vtkIdType)>& work, const Progress& progress)
{
  const vtkIdType chunks = NumberOfChunks(count);
  rtg::SetThreadCount(Threads());
  const vtkIdType step = progress ? chunksPerReport : std::max<vtkIdType>(1, chunks);
  for (vtkIdType first = 0; first < chunks; first += step)
  {
    const vtkIdType last = std::min(chunks, first + step);
    rtg::ParallelFor(static_cast<std::size_t>(last - first),
      [&](std::size_t i)
      {
        const vtkIdType begin = (first + static_cast<vtkIdType>(i)) * ChunkSize;
        work(begin, std::min(count, begin + ChunkSize));
      });
    if (progress && last < chunks)
    {
      progress(static_cast<double>(last) / static_cast<double>(chunks));
    }
  }
}
