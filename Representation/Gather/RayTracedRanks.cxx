#include "RayTracedRanks.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <numeric>
#include <stdexcept>

namespace
{
int together = 0; // how many calls of Together() this thread is in

// Null: there is one rank.
vtkMultiProcessController* Controller()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

// Before each exchange, and at the end.
void Agree(bool good)
{
  vtkMultiProcessController* controller = Controller();
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

// MPI counts in int.
void CheckLength(std::size_t length)
{
  if (length > 0x7fffffff)
  {
    throw std::length_error(std::to_string(length) + " bytes between ranks");
  }
}

// `ends` of what is each rank's.
template <typename Value>
std::vector<Value> GatherValues(const std::vector<Value>& own, std::vector<vtkIdType>& ends)
{
  const auto length = static_cast<vtkIdType>(own.size());
  ends.assign(1, length);
  vtkMultiProcessController* controller = Controller();
  if (!controller)
  {
    return own;
  }
  ends.resize(controller->GetNumberOfProcesses());
  std::vector<vtkIdType> lengths(ends.size()), begins(ends.size(), 0);
  Agree(true);
  controller->AllGather(&length, lengths.data(), 1);
  std::partial_sum(lengths.begin(), lengths.end(), ends.begin());
  std::copy(ends.begin(), ends.end() - 1, begins.begin() + 1);
  std::vector<Value> all(ends.back());
  Agree(true);
  controller->AllGatherV(own.data(), all.data(), length, lengths.data(), begins.data());
  return all;
}
}

//----------------------------------------------------------------------------
int rtglyphs::RayTracedRanks::Count()
{
  vtkMultiProcessController* controller = Controller();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

//----------------------------------------------------------------------------
int rtglyphs::RayTracedRanks::Own()
{
  vtkMultiProcessController* controller = Controller();
  return controller ? controller->GetLocalProcessId() : 0;
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
  catch (const std::exception&)
  {
    Agree(false);
    throw;
  }
  Agree(true);
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedRanks::Problem(const std::function<void()>& work)
{
  try
  {
    Together(work);
  }
  catch (const FailedElsewhere&)
  {
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return std::string();
}

//----------------------------------------------------------------------------
template <class Value>
void rtglyphs::RayTracedRanks::Reduce(std::vector<Value>& values, int operation)
{
  if (vtkMultiProcessController* controller = Controller())
  {
    const std::vector<Value> own = values;
    Agree(true);
    controller->AllReduce(own.data(), values.data(), static_cast<vtkIdType>(own.size()), operation);
  }
}
template void rtglyphs::RayTracedRanks::Reduce(std::vector<double>&, int);
template void rtglyphs::RayTracedRanks::Reduce(std::vector<unsigned char>&, int);

//----------------------------------------------------------------------------
double rtglyphs::RayTracedRanks::Largest(double value)
{
  std::vector<double> values{ value };
  Reduce(values, vtkCommunicator::MAX_OP);
  return values[0];
}

//----------------------------------------------------------------------------
vtkBoundingBox rtglyphs::RayTracedRanks::Union(const vtkBoundingBox& own)
{
  vtkBoundingBox all = own;
  if (vtkMultiProcessController* controller = Controller())
  {
    Agree(true);
    controller->AllReduce(own, all);
  }
  return all;
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::RayTracedRanks::Gather(const std::vector<double>& own)
{
  std::vector<vtkIdType> ends;
  return GatherValues(own, ends);
}

//----------------------------------------------------------------------------
std::vector<std::vector<std::string>> rtglyphs::RayTracedRanks::Gather(const std::vector<std::string>& own)
{
  std::vector<char> characters;
  for (const std::string& text : own)
  {
    characters.insert(characters.end(), text.c_str(), text.c_str() + text.size() + 1);
  }
  std::vector<vtkIdType> ends;
  const std::vector<char> all = GatherValues(characters, ends);
  std::vector<std::vector<std::string>> texts;
  vtkIdType at = 0;
  for (vtkIdType end : ends)
  {
    for (texts.emplace_back(); at < end; at += static_cast<vtkIdType>(texts.back().back().size() + 1))
    {
      texts.back().emplace_back(&all[at]);
    }
  }
  return texts;
}

//----------------------------------------------------------------------------
std::vector<char> rtglyphs::RayTracedRanks::Exchange(std::vector<std::vector<char>> messages)
{
  vtkMultiProcessController* controller = Controller();
  if (!controller)
  {
    return messages[0];
  }
  const auto ranks = static_cast<std::size_t>(Count());
  const auto own = static_cast<std::size_t>(Own());
  std::vector<vtkIdType> lengths(ranks), matrix(ranks * ranks), arriving(ranks), begins(ranks);
  for (std::size_t to = 0; to < ranks; ++to)
  {
    lengths[to] = static_cast<vtkIdType>(messages[to].size());
    CheckLength(messages[to].size());
  }
  Agree(true);
  controller->AllGather(lengths.data(), matrix.data(), static_cast<vtkIdType>(ranks));
  vtkIdType total = 0;
  for (std::size_t from = 0; from < ranks; ++from)
  {
    begins[from] = total;
    arriving[from] = matrix[from * ranks + own];
    total += arriving[from];
  }
  CheckLength(static_cast<std::size_t>(total));
  std::vector<char> arrived(static_cast<std::size_t>(total));
  Agree(true);
  for (std::size_t to = 0; to < ranks; ++to)
  {
    controller->GatherV(
      messages[to].data(), arrived.data(), lengths[to], arriving.data(), begins.data(), static_cast<int>(to));
    messages[to] = std::vector<char>(); // = {} would keep the memory
  }
  return arrived;
}
