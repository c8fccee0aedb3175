#include "RayTracedFrameStatus.h"

#include "RayTracedContent.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkRayTracedMapper.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>

namespace
{
// In what is summed over all ranks; behind the view's numbers come those of each display.
enum ViewNumbers
{
  DEVICE_BYTES,
  PRIMARY_RAYS,
  NEIGHBOR_GLYPHS,
  NEIGHBOR_BYTES,
  VIEW_NUMBERS
};
enum DisplayNumbers
{
  GLYPHS,
  SKIPPED_GLYPHS,
  DISPLAY_NUMBERS
};

std::vector<double> OwnNumbers(const rtg::Statistics& statistics, const rtglyphs::RayTracedContent& content)
{
  std::vector<double> numbers(VIEW_NUMBERS);
  numbers[DEVICE_BYTES] = static_cast<double>(statistics.deviceBytes);
  numbers[PRIMARY_RAYS] = static_cast<double>(statistics.primaryRays);
  numbers[NEIGHBOR_GLYPHS] = static_cast<double>(content.Neighbors.GetNumberOfGlyphs());
  numbers[NEIGHBOR_BYTES] = static_cast<double>(content.Neighbors.GetNumberOfBytes());
  for (const rtglyphs::RayTracedDisplays::Display& display : content.Displays.GetAll())
  {
    numbers.push_back(static_cast<double>(display.Mapper->GetNumberOfGlyphs()));
    numbers.push_back(static_cast<double>(display.Mapper->GetSkippedGlyphs()));
  }
  return numbers;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFrameStatus::SetFrame(Frame frame, vtkMultiProcessController* ranks)
{
  if (ranks)
  {
    const double own[2] = { frame.Progress, frame.Samples };
    double least[2];
    ranks->AllReduce(own, least, 2, vtkCommunicator::MIN_OP);
    frame.Progress = least[0];
    frame.Samples = least[1];
  }
  this->Compiling = frame.Compiling;
  this->Stereo = frame.Stereo;
  this->Eye = frame.Eye;
  this->Progress[frame.Eye] = frame.Progress;
  this->Samples[frame.Eye] = frame.Samples;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFrameStatus::Finish()
{
  std::fill_n(this->Progress, 2, 1.0);
}

//----------------------------------------------------------------------------
// Where ranks have different displays, which should not be, each keeps its own numbers.
void rtglyphs::RayTracedFrameStatus::SumNumbers(
  vtkMultiProcessController* ranks, const rtglyphs::RayTracedContent& content)
{
  const std::vector<double> own = OwnNumbers(content.Images.GetStatistics(), content);
  const int lengths[2] = { static_cast<int>(own.size()), -static_cast<int>(own.size()) };
  int largest[2];
  ranks->AllReduce(lengths, largest, 2, vtkCommunicator::MAX_OP);
  this->SummedNumbers.clear();
  if (largest[0] == -largest[1])
  {
    this->SummedNumbers.resize(own.size());
    ranks->AllReduce(
      own.data(), this->SummedNumbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  }
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedFrameStatus::GetStatistics(const rtglyphs::RayTracedContent& content)
{
  const rtg::Statistics s = content.Images.GetStatistics();
  std::vector<double> numbers = OwnNumbers(s, content);
  if (this->SummedNumbers.size() == numbers.size())
  {
    numbers = this->SummedNumbers;
  }
  const auto count = [&](std::size_t number) { return static_cast<std::uint64_t>(numbers[number]); };
  const auto least = [this](const double* ofEyes)
  { return this->Stereo ? std::min(ofEyes[0], ofEyes[1]) : ofEyes[this->Eye]; };
  const double progress = least(this->Progress);
  nlohmann::ordered_json json = {
    { "DeviceName", content.Images.GetDeviceName() },
    { "AccumulatedSamples", static_cast<int>(least(this->Samples)) },
    { "RefinementProgress", progress },
    { "RefinementStep", this->Compiling || progress < 1.0 ? NameOfStep(this->Compiling) : "" },
    { "pulls", ++this->Pulls },
    { "neighborGlyphs", count(NEIGHBOR_GLYPHS) },
    { "neighborBytes", count(NEIGHBOR_BYTES) },
    { "structureBuilds", s.structureBuilds },
    { "topLevelBuilds", s.topLevelBuilds },
    { "instanceUploads", s.instanceUploads },
    { "colorUploads", s.colourUploads },
    { "pipelineBuilds", s.pipelineBuilds },
    { "programsAhead", s.programsAhead },
    { "dispatches", s.dispatches },
    { "primaryRays", count(PRIMARY_RAYS) },
    { "deviceBytes", count(DEVICE_BYTES) },
    { "sorts", s.sorts },
    { "sortSeconds", s.sortSeconds },
    { "buildSeconds", s.buildSeconds },
    { "uploadSeconds", s.uploadSeconds },
    { "traceSeconds", s.traceSeconds },
    { "denoiseSeconds", s.denoiseSeconds },
  };
  nlohmann::ordered_json& representations = json["representations"] = nlohmann::ordered_json::object();
  std::size_t own = VIEW_NUMBERS;
  for (const rtglyphs::RayTracedDisplays::Display& display : content.Displays.GetAll())
  {
    if (display.Data.Representation != 0)
    {
      const vtkRayTracedMapper& mapper = *display.Mapper;
      representations[std::to_string(display.Data.Representation)] = {
        { "glyphs", count(own + GLYPHS) },
        { "skippedGlyphs", count(own + SKIPPED_GLYPHS) },
        { "unfinished", mapper.GetUnfinished() },
        { "gathers", display.Data.Gathers },
        { "boundsBuilds", display.Data.BoundsBuilds },
        { "instanceBuilds", mapper.GetInstanceBuilds() },
        { "colorBuilds", mapper.GetColorBuilds() },
        { "gatherSeconds", display.Data.GatherSeconds },
        { "boundsSeconds", display.Data.BoundsSeconds },
        { "instanceSeconds", mapper.GetInstanceSeconds() },
        { "colorSeconds", mapper.GetColorSeconds() },
      };
    }
    own += DISPLAY_NUMBERS;
  }
  return json.dump();
}
