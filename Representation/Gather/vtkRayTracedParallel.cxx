#include "vtkRayTracedParallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace
{
// Chunks between two calls of a Progress, some tenths of a second of work.
constexpr vtkIdType chunksPerReport = 32;

vtkSMPTools::Config Configuration()
{
  vtkSMPTools::Config config(vtk::detail::smp::vtkSMPToolsAPI::GetInstance());
  if (config.Backend == "Sequential" && !std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    config.Backend = "STDThread";
  }
  return config;
}
}

//----------------------------------------------------------------------------
vtkRayTracedParallel::Progress vtkRayTracedParallel::Part(const Progress& whole, double first, double last)
{
  if (!whole)
  {
    return {};
  }
  return [whole, first, last](double share) { whole(first + share * (last - first)); };
}

//----------------------------------------------------------------------------
void vtkRayTracedParallel::ForChunks(
  vtkIdType count, const std::function<void(vtkIdType, vtkIdType)>& work, const Progress& progress)
{
  const vtkIdType chunks = NumberOfChunks(count);
  const auto run = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType chunk = first; chunk < last; ++chunk)
    {
      work(chunk * ChunkSize, std::min(count, (chunk + 1) * ChunkSize));
    }
  };
  if (chunks < 2)
  {
    run(0, chunks);
    return;
  }
  vtkSMPTools::LocalScope(Configuration(),
    [&]
    {
      const vtkIdType step = progress ? chunksPerReport : chunks;
      for (vtkIdType first = 0; first < chunks; first += step)
      {
        const vtkIdType last = std::min(chunks, first + step);
        vtkSMPTools::For(first, last, 1, run);
        if (progress && last < chunks)
        {
          progress(static_cast<double>(last) / static_cast<double>(chunks));
        }
      }
    });
}

//----------------------------------------------------------------------------
vtkRayTracedParallel::Box
vtkRayTracedParallel::BoxOf(vtkIdType count, const std::function<void(vtkIdType, vtkIdType, Box&)>& add)
{
  std::vector<Box> boxes(NumberOfChunks(count));
  ForChunks(count, [&](vtkIdType begin, vtkIdType end) { add(begin, end, boxes[ChunkOf(begin)]); });
  Box all;
  for (const Box& box : boxes)
  {
    all.Add(box.Lower, box.Upper);
  }
  return all;
}
