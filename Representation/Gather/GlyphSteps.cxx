#include "GlyphSteps.h"

#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedRanks.h"
#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>

namespace
{
// Along the edges of the box and the diagonals of it and of its faces.
std::vector<glm::dvec3> Translations(const rtg::PeriodicImages& images)
{
  std::vector<glm::dvec3> all;
  for (int number = 14; number < 27 && images.Any(); ++number) // the other half are their opposites
  {
    const glm::dvec3 translation = double(number / 9 - 1) * images.edges[0] +
      double(number / 3 % 3 - 1) * images.edges[1] + double(number % 3 - 1) * images.edges[2];
    if (translation != glm::dvec3(0.0))
    {
      all.push_back(translation);
    }
  }
  return all;
}

// Added to the displacement of a point, it gives that of the point's nearest image.
glm::dvec3 ShiftToNearest(const glm::dvec3& displacement, const std::vector<glm::dvec3>& translations)
{
  constexpr int enough = 16; // rounds, each of which makes it shorter
  glm::dvec3 shift(0.0);
  bool changed = true;
  for (int round = 0; changed && round < enough; ++round)
  {
    changed = false;
    for (const glm::dvec3& translation : translations)
    {
      const double count = std::round(glm::dot(displacement + shift, translation) / glm::dot(translation, translation));
      shift -= count * translation;
      changed |= count != 0.0;
    }
  }
  return shift;
}

// VTK_VOID: of the type of the positions.
std::vector<vtkDataArray*> AddArrays(vtkDataObject* tree, const char* name, int components, int type, double fill)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPolyData* points : vtkCompositeDataSet::GetDataSets<vtkPolyData>(tree))
  {
    const int own = points->GetPoints() ? points->GetPoints()->GetDataType() : VTK_FLOAT;
    auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type == VTK_VOID ? own : type));
    array->SetName(name);
    array->SetNumberOfComponents(components);
    rtglyphs::RayTracedArrays::Resize(array, points->GetNumberOfPoints());
    array->Fill(fill);
    points->GetPointData()->AddArray(array);
    arrays.push_back(array);
  }
  return arrays;
}
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphSteps::SetTrailSteps(int steps)
{
  steps = std::clamp(steps, 0, 1000);
  return std::exchange(this->TrailSteps, steps) != steps;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphSteps::SetVelocities(bool on)
{
  if (std::exchange(this->Velocities, on) == on)
  {
    return false;
  }
  this->Shown.reset();
  this->Before.reset();
  this->Reported.clear();
  return true;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphSteps::SetPointIdArray(const std::string& name)
{
  if (std::exchange(this->PointIdArray, name) == name)
  {
    return false;
  }
  this->Forget();
  return this->Velocities || this->TrailSteps > 0;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::Forget()
{
  this->Shown.reset();
  this->Before.reset();
  this->Kept.clear();
  this->Reported.clear();
}

//----------------------------------------------------------------------------
std::vector<double> rtglyphs::GlyphSteps::Show(
  vtkDataObject* gathered, vtkDataObject* input, double time, vtkInformation* from, vtkAlgorithm* source, bool trails)
{
  if (!trails && !this->Velocities)
  {
    return {};
  }
  if (this->Source != source)
  {
    this->Forget();
    this->Source = source;
  }
  GlyphStep points(gathered, this->PointIdArray); // before anything changes: the memory may not suffice
  vtkInformation* info = input->GetInformation();
  const double own = info->Has(vtkDataObject::DATA_TIME_STEP()) ? info->Get(vtkDataObject::DATA_TIME_STEP()) : NAN;
  // Data of the same time that come again, as after a change of a filter, take the place of what they were. A step
  // without points counts: those of the next have come from nowhere.
  if (this->Velocities && this->Shown && this->Shown->Time != own)
  {
    this->Before = std::move(this->Shown);
  }
  this->Shown = { own, std::move(points) };
  return trails ? this->FindMissing(std::isfinite(own) ? own : time, from, source) : std::vector<double>();
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::Keep(double time, vtkDataObject* gathered)
{
  this->Kept[time] = gathered ? GlyphStep(gathered, this->PointIdArray) : GlyphStep();
  if (!gathered)
  {
    std::ostringstream text;
    text << "The time step at " << time << " cannot be read, so trails end after it. Later steps are not reported.";
    this->AddMessage(text.str(), "unreadable");
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::Replace(vtkDataObject* gathered)
{
  this->Shown->Points = GlyphStep(gathered, this->PointIdArray);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::AddTo(
  vtkDataObject* gathered, bool trails, const std::function<rtg::PeriodicImages()>& images)
{
  if (trails)
  {
    this->AddTrails(gathered, images());
  }
  if (this->Velocities)
  {
    this->AddVelocities(gathered);
  }
}

//----------------------------------------------------------------------------
// All ranks request the same steps: readers may work together.
std::vector<double> rtglyphs::GlyphSteps::FindMissing(double time, vtkInformation* from, vtkAlgorithm* source)
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(source->GetExecutive());
  const vtkMTimeType sourceTime = pipeline ? pipeline->GetPipelineMTime() : 0;
  if (std::exchange(this->SourceTime, sourceTime) != sourceTime)
  {
    this->Kept.clear();
  }
  const GlyphStep& shown = this->Shown->Points;
  std::vector<double> known{ shown.LacksIds() ? 0.0 : 1.0, std::isfinite(time) ? time : -HUGE_VAL };
  rtglyphs::RayTracedRanks::Reduce(known, vtkCommunicator::MAX_OP);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  std::vector<double> times(from->Get(key), from->Get(key) + std::max(from->Length(key), 0));
  std::sort(times.begin(), times.end());
  const auto end = std::lower_bound(times.begin(), times.end(), known[1]);
  const auto count = std::min<std::ptrdiff_t>(end - times.begin(), this->TrailSteps);
  this->Earlier.assign(std::make_reverse_iterator(end), std::make_reverse_iterator(end - count));
  if (times.size() < 2)
  {
    this->AddMessage(
      "TrailSteps needs data of several time steps, and these have one; so there are no trails. Open them as a "
      "time series, or set TrailSteps to 0.",
      "one step");
  }
  else if (shown.LacksIds())
  {
    this->AddMessage(GlyphStep::IdsNeeded("TrailSteps", "there are no trails"), "trails without ids");
  }
  if (known[0] == 0.0)
  {
    this->Earlier.clear();
  }

  std::erase_if(this->Kept,
    [this](const auto& step)
    { return std::find(this->Earlier.begin(), this->Earlier.end(), step.first) == this->Earlier.end(); });
  std::vector<double> lacks;
  for (const double earlier : this->Earlier)
  {
    lacks.push_back(this->Kept.count(earlier) == 0 ? 1.0 : 0.0);
  }
  rtglyphs::RayTracedRanks::Reduce(lacks, vtkCommunicator::MAX_OP);
  std::vector<double> missing; // the first first
  for (std::size_t i = lacks.size(); i-- > 0;)
  {
    if (lacks[i] > 0.0)
    {
      missing.push_back(this->Earlier[i]);
    }
  }
  if (end != times.end() && *end == known[1])
  {
    this->Kept.insert_or_assign(known[1], shown);
  }
  return missing;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::AddTrails(vtkDataObject* gathered, const rtg::PeriodicImages& images) const
{
  for (vtkPolyData* points : vtkCompositeDataSet::GetDataSets<vtkPolyData>(gathered))
  {
    points->GetPointData()->RemoveArray(rtglyphs::RayTracedArrays::Trail);
  }
  if (this->Earlier.empty())
  {
    return;
  }
  const std::vector<vtkDataArray*> trails = AddArrays(
    gathered, rtglyphs::RayTracedArrays::Trail, 3 * static_cast<int>(this->Earlier.size()), VTK_VOID, vtkMath::Nan());
  const std::vector<glm::dvec3> translations = Translations(images);
  std::vector<GlyphStep::Entry> later =
    this->Shown->Points.GetEntries(); // those whose trails go on, with their last places
  for (std::size_t step = 0; step < this->Earlier.size(); ++step)
  {
    GlyphStep::Pairs pairs = GlyphStep::Match(later, this->Kept.at(this->Earlier[step]).GetEntries());
    if (translations.empty())
    {
      pairs = GlyphStep::WithoutCrossings(std::move(pairs));
    }
    std::vector<GlyphStep::Entry> going(pairs.size());
    rtglyphs::RayTracedParallel::ForEach(static_cast<vtkIdType>(pairs.size()),
      [&](vtkIdType i)
      {
        const auto [now, before] = pairs[i];
        const glm::dvec3 displacement(before->X[0] - now->X[0], before->X[1] - now->X[1], before->X[2] - now->X[2]);
        const glm::dvec3 shift = ShiftToNearest(displacement, translations);
        going[i] = *now;
        for (int c = 0; c < 3; ++c)
        {
          going[i].X[c] = before->X[c] + shift[c];
          trails[now->Leaf]->SetComponent(now->Point, static_cast<int>(3 * step) + c, going[i].X[c]);
        }
      });
    later = std::move(going);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::AddVelocities(vtkDataObject* gathered)
{
  const std::vector<vtkDataArray*> velocities =
    AddArrays(gathered, rtglyphs::RayTracedArrays::StepVelocity, 3, VTK_FLOAT, 0.0);
  const GlyphStep& now = this->Shown->Points;
  if (now.LacksIds())
  {
    this->AddMessage(
      GlyphStep::IdsNeeded("VelocityArray From Previous Step", "the glyphs stand still"), "velocities without ids");
    return;
  }
  if (!std::isfinite(this->Shown->Time))
  {
    this->AddMessage(
      "VelocityArray From Previous Step needs the time of the data, which they lack; so the glyphs stand still. Open "
      "them as a time series, or choose an array.",
      "no time");
    return;
  }
  if (!(this->GetStepLength() > 0.0))
  {
    return;
  }
  const double length = this->Shown->Time - this->Before->Time;
  GlyphStep::Pairs pairs = GlyphStep::Match(now.GetEntries(), this->Before->Points.GetEntries());
  if (const vtkIdType alone = now.GetPoints() - static_cast<vtkIdType>(pairs.size()); alone > 0)
  {
    std::ostringstream text;
    text << alone << " of " << now.GetPoints()
         << " points stand still, because VelocityArray From Previous Step finds no point, or several, with their ids "
            "in the "
            "step shown before, at time "
         << this->Before->Time << ". Choose another PointIdArray if they were there. Later steps are not reported.";
    this->AddMessage(text.str(), "no partner");
  }
  pairs = GlyphStep::WithoutCrossings(std::move(pairs));
  for (const auto& [here, before] : pairs)
  {
    for (int c = 0; c < 3; ++c)
    {
      velocities[here->Leaf]->SetComponent(here->Point, c, (here->X[c] - before->X[c]) / length);
    }
  }
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphSteps::GetStepLength() const
{
  const double length = this->Shown && this->Before ? std::abs(this->Shown->Time - this->Before->Time) : 0.0;
  return std::isfinite(length) ? length : 0.0;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphSteps::AddMessage(const std::string& message, const std::string& kind)
{
  if (this->Reported.insert(kind).second)
  {
    this->Message += (this->Message.empty() ? "" : " ") + message;
  }
}
