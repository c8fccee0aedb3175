#include "RayTracedRanks.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <numeric>

namespace
{
int together = 0; // how many calls of Together() this thread is in

// Before each exchange, and at the end.
void Agree(bool good)
{
  vtkMultiProcessController* controller = rtglyphs::RayTracedRanks::Controller();
  const int own = good ? 1 : 0;
  int all = own;
  if (controller && together > 0)
  {
    controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  }
  if (good && !all)
  {
    throw rtglyphs::RayTracedRanks::FailedElsewhere();
  }
}

struct Depth
{
  Depth() { ++together; }
  ~Depth() { --together; }
};
}

//----------------------------------------------------------------------------
vtkMultiProcessController* rtglyphs::RayTracedRanks::Controller()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRanks::Together(const std::function<void()>& work)
{
  const Depth depth;
  try
  {
    work();
  }
  catch (const FailedElsewhere&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    Agree(false);
    throw;
  }
  Agree(true);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedRanks::Reduce(std::vector<double>& values, int operation)
{
  if (vtkMultiProcessController* controller = Controller())
  {
    const std::vector<double> own = values;
    Agree(true);
    controller->AllReduce(own.data(), values.data(), static_cast<vtkIdType>(own.size()), operation);
  }
}

//----------------------------------------------------------------------------
double rtglyphs::RayTracedRanks::Largest(double value)
{
  std::vector<double> values{ value };
  Reduce(values, vtkCommunicator::MAX_OP);
  return values[0];
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::RayTracedRanks::Gather(const std::vector<double>& own)
{
  vtkMultiProcessController* controller = Controller();
  if (!controller)
  {
    return own;
  }
  const int ranks = controller->GetNumberOfProcesses();
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(ranks), offsets(ranks, 0);
  Agree(true);
  controller->AllGather(&length, lengths.data(), 1);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<double> all(offsets.back() + lengths.back());
  Agree(true);
  controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  return all;
}
