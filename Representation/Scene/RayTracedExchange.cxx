#include "RayTracedExchange.h"

#include "Scene.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <exception>

namespace
{
constexpr std::size_t mostBytes = 0x7fffffff; // MPI counts in int

void Check(std::size_t bytes, const std::string& where)
{
  if (bytes > mostBytes)
  {
    throw rtg::Error(std::to_string(bytes) + " bytes " + where);
  }
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedExchange::Try(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    this->Problem = error.what();
  }
}

//----------------------------------------------------------------------------
// Every rank takes part in every collective call.
bool rtglyphs::RayTracedExchange::Send(vtkMultiProcessController* controller, std::vector<std::vector<char>> messages)
{
  const auto ranks = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const auto own = static_cast<std::size_t>(controller->GetLocalProcessId());
  messages.resize(ranks);
  std::vector<vtkIdType> lengths(ranks), matrix(ranks * ranks), arriving(ranks), begins(ranks);
  for (std::size_t to = 0; to < ranks; ++to)
  {
    lengths[to] = static_cast<vtkIdType>(messages[to].size());
  }
  controller->AllGather(lengths.data(), matrix.data(), static_cast<vtkIdType>(ranks));
  vtkIdType total = 0;
  for (std::size_t from = 0; from < ranks; ++from)
  {
    begins[from] = total;
    arriving[from] = matrix[from * ranks + own];
    total += arriving[from];
  }
  this->Try(
    [&]
    {
      for (std::size_t to = 0; to < ranks; ++to)
      {
        Check(messages[to].size(), "for rank " + std::to_string(to));
      }
      Check(static_cast<std::size_t>(total), "from other ranks");
      this->Bytes.resize(static_cast<std::size_t>(total));
    });
  const int good = this->Problem.empty() ? 1 : 0;
  int onAll = 0;
  controller->AllReduce(&good, &onAll, 1, vtkCommunicator::MIN_OP);
  if (!onAll)
  {
    return false;
  }
  for (std::size_t to = 0; to < ranks; ++to)
  {
    controller->GatherV(
      messages[to].data(), this->Bytes.data(), lengths[to], arriving.data(), begins.data(), static_cast<int>(to));
    messages[to] = {};
  }
  return true;
}
