#include "RayTracedFrameStatus.h"

#include "RayTracedDisplays.h"
#include "RayTracedImages.h"
#include "RayTracedRanks.h"
#include "vtkActor.h"
#include "vtkCommunicator.h"
#include "vtkMath.h"
#include "vtkRayTracedMapper.h"
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <utility>

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
  PARTS_CUT, // of ranks, of which a section takes something, and of which it leaves something
  PARTS_LEFT,
  DISPLAY_NUMBERS
};

// Whether a section takes something within the display's bounds, and whether it leaves something.
std::pair<bool, bool> TakesAndLeaves(const rtglyphs::RayTracedDisplays::Display& display)
{
  const rtg::Section& section = display.Mapper->GetSection();
  const double* bounds = display.Actor ? display.Actor->GetBounds() : nullptr;
  bool inside = bounds && vtkMath::AreBoundsInitialized(bounds), outside = false;
  for (std::size_t i = 0; inside && i < section.planes.size(); ++i)
  {
    int beyond = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at(bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)]);
      beyond += glm::dot(section.planes[i].normal, at - section.planes[i].point) > 0.0 ? 1 : 0;
    }
    outside |= beyond > 0;
    inside = beyond < 8;
  }
  return section.keepsInside ? std::pair(outside, inside) : std::pair(inside, outside);
}

std::vector<double> OwnNumbers(const rtg::Statistics& statistics, const rtglyphs::RayTracedDisplays& displays)
{
  std::vector<double> numbers(VIEW_NUMBERS);
  numbers[DEVICE_BYTES] = static_cast<double>(statistics.deviceBytes);
  numbers[PRIMARY_RAYS] = static_cast<double>(statistics.primaryRays);
  numbers[NEIGHBOR_GLYPHS] = static_cast<double>(displays.GetNeighbors().GetNumberOfGlyphs());
  numbers[NEIGHBOR_BYTES] = static_cast<double>(displays.GetNeighbors().GetNumberOfBytes());
  for (const rtglyphs::RayTracedDisplays::Display& display : displays.GetAll())
  {
    numbers.push_back(static_cast<double>(display.Mapper->GetNumberOfGlyphs()));
    numbers.push_back(static_cast<double>(display.Mapper->GetSkippedGlyphs()));
    const auto [takes, leaves] = TakesAndLeaves(display);
    numbers.push_back(takes ? 1.0 : 0.0);
    numbers.push_back(leaves ? 1.0 : 0.0);
  }
  return numbers;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedFrameStatus::SetFrame(Frame frame, bool collective)
{
  if (collective)
  {
    std::vector<double> least{ frame.Progress, frame.Samples };
    rtglyphs::RayTracedRanks::Reduce(least, vtkCommunicator::MIN_OP);
    frame.Progress = least[0];
    frame.Samples = least[1];
  }
  this->Eye = frame.Eye;
  this->Eyes[frame.Eye] = frame;
}

//----------------------------------------------------------------------------
// Where ranks have different displays, which should not be, each keeps its own numbers.
void rtglyphs::RayTracedFrameStatus::SumNumbers(
  const rtglyphs::RayTracedDisplays& displays, const rtglyphs::RayTracedImages& images)
{
  std::vector<double> numbers = OwnNumbers(images.GetStatistics(), displays);
  const auto length = static_cast<double>(numbers.size());
  std::vector<double> largest{ length, -length };
  rtglyphs::RayTracedRanks::Reduce(largest, vtkCommunicator::MAX_OP);
  this->SummedNumbers.clear();
  if (largest[0] == -largest[1])
  {
    rtglyphs::RayTracedRanks::Reduce(numbers, vtkCommunicator::SUM_OP);
    this->SummedNumbers = std::move(numbers);
  }
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedFrameStatus::GetStatistics(
  const rtglyphs::RayTracedDisplays& displays, const rtglyphs::RayTracedImages& images)
{
  const rtg::Statistics s = images.GetStatistics();
  std::vector<double> numbers = OwnNumbers(s, displays);
  if (this->SummedNumbers.size() == numbers.size())
  {
    numbers = this->SummedNumbers;
  }
  const auto count = [&](std::size_t number) { return static_cast<std::uint64_t>(numbers[number]); };
  const Frame& last = this->Eyes[this->Eye];
  const auto least = [&](double Frame::*number)
  { return last.Stereo ? std::min(this->Eyes[0].*number, this->Eyes[1].*number) : last.*number; };
  const double progress = least(&Frame::Progress);
  nlohmann::ordered_json json = {
    { "DeviceName", images.GetDeviceName() },
    { "AccumulatedSamples", static_cast<int>(least(&Frame::Samples)) },
    { "RefinementProgress", progress },
    { "RefinementStep", last.Compiling || progress < 1.0 ? NameOfStep(last.Compiling) : "" },
    { "pulls", ++this->Pulls },
    { "neighborGlyphs", count(NEIGHBOR_GLYPHS) },
    { "neighborBytes", count(NEIGHBOR_BYTES) },
    { "structureBuilds", s.structureBuilds },
    { "topLevelBuilds", s.topLevelBuilds },
    { "instanceUploads", s.instanceUploads },
    { "colorUploads", s.colorUploads },
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
  for (const rtglyphs::RayTracedDisplays::Display& display : displays.GetAll())
  {
    const vtkRayTracedMapper& mapper = *display.Mapper;
    const vtkRayTracedMapper::DataStatistics& data = mapper.GetDataStatistics();
    if (data.Representation != 0)
    {
      const bool cut = !mapper.GetSection().planes.empty() && count(own + GLYPHS) > 0;
      const bool takes = count(own + PARTS_CUT) > 0, leaves = count(own + PARTS_LEFT) > 0;
      representations[std::to_string(data.Representation)] = {
        { "glyphs", count(own + GLYPHS) },
        { "skippedGlyphs", count(own + SKIPPED_GLYPHS) },
        { "missingInput", mapper.GetMissingInput() },
        { "section",
          !cut       ? ""
            : !takes ? "Section has no effect: it does not meet what is shown"
            : leaves ? ""
                     : "Section cuts off all that is shown" },
        { "gathers", data.Gathers },
        { "boundsBuilds", data.BoundsBuilds },
        { "instanceBuilds", mapper.GetInstanceBuilds() },
        { "colorBuilds", mapper.GetColorBuilds() },
        { "gatherSeconds", data.GatherSeconds },
        { "boundsSeconds", data.BoundsSeconds },
        { "instanceSeconds", mapper.GetInstanceSeconds() },
        { "colorSeconds", mapper.GetColorSeconds() },
      };
    }
    own += DISPLAY_NUMBERS;
  }
  // Names of arrays may not be UTF-8.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}
