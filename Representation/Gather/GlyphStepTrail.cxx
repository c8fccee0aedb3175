#include "GlyphStepTrail.h"

#include "RayTracedParallel.h"
#include "RayTracedRanks.h"
#include "RayTracedTree.h"
#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
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
#include <utility>

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
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphStepTrail::SetSteps(int steps)
{
  return std::exchange(this->Steps, std::max(steps, 0)) != this->Steps;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphStepTrail::SetPointIdArray(const std::string& name)
{
  const bool changed = this->PointIdArray != name;
  if (changed)
  {
    this->PointIdArray = name;
    this->Forget();
  }
  return changed;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepTrail::Forget()
{
  this->Kept.clear();
  this->Said.clear();
}

//----------------------------------------------------------------------------
std::optional<double> rtglyphs::GlyphStepTrail::GetMissing() const
{
  return this->Missing.empty() ? std::nullopt : std::optional<double>(this->Missing.back());
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphStepTrail::Take(vtkDataObject* gathered, double time, vtkInformation* from, vtkAlgorithm* source)
{
  GlyphStep step(gathered, this->PointIdArray);
  if (!this->Missing.empty())
  {
    this->Kept[this->Missing.back()] = std::move(step);
    this->Missing.pop_back();
    this->Returns = this->Missing.empty();
    return true;
  }
  this->Shown = std::move(step);
  if (std::exchange(this->Returns, false))
  {
    return false;
  }
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(source->GetExecutive());
  const vtkMTimeType sourceTime = pipeline ? pipeline->GetPipelineMTime() : 0;
  if (this->Source != source || this->SourceTime != sourceTime)
  {
    this->Forget();
    this->Source = source;
    this->SourceTime = sourceTime;
  }
  this->FindMissing(time, from);
  return !this->Missing.empty();
}

//----------------------------------------------------------------------------
// Alike on all ranks: readers may work together.
void rtglyphs::GlyphStepTrail::FindMissing(double time, vtkInformation* from)
{
  std::vector<double> known{ this->Shown.LacksIds() ? 0.0 : 1.0, std::isfinite(time) ? time : -HUGE_VAL };
  rtglyphs::RayTracedRanks::Reduce(known, vtkCommunicator::MAX_OP);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  std::vector<double> times(from->Get(key), from->Get(key) + std::max(from->Length(key), 0));
  std::sort(times.begin(), times.end());
  const auto end = std::lower_bound(times.begin(), times.end(), known[1]);
  const auto count = std::min<std::ptrdiff_t>(end - times.begin(), this->Steps);
  this->Earlier.assign(std::make_reverse_iterator(end), std::make_reverse_iterator(end - count));
  this->Problem = times.size() < 2
    ? "TrailSteps needs data of several time steps, and these have one; so there are no trails. Open them as a time "
      "series, or set TrailSteps to 0."
    : this->Shown.LacksIds() ? GlyphStep::IdsNeeded("TrailSteps", "there are no trails")
                             : std::string();
  if (known[0] == 0.0)
  {
    this->Earlier.clear();
  }

  std::erase_if(this->Kept,
    [this](const auto& step)
    { return std::find(this->Earlier.begin(), this->Earlier.end(), step.first) == this->Earlier.end(); });
  std::vector<double> missing;
  for (const double earlier : this->Earlier)
  {
    missing.push_back(this->Kept.count(earlier) == 0 ? 1.0 : 0.0);
  }
  rtglyphs::RayTracedRanks::Reduce(missing, vtkCommunicator::MAX_OP);
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    if (missing[i] > 0.0)
    {
      this->Missing.push_back(this->Earlier[i]);
    }
  }
  if (end != times.end() && *end == known[1])
  {
    this->Kept[known[1]] = this->Shown;
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepTrail::AddTo(vtkDataObject* gathered, const rtg::PeriodicImages& images) const
{
  rtglyphs::RayTracedTree::ForEach(
    gathered, [](vtkPolyData* points) { points->GetPointData()->RemoveArray(rtglyphs::RayTracedArrays::Trail); });
  if (this->Steps == 0 || this->Earlier.empty())
  {
    return;
  }
  std::vector<vtkDataArray*> trails;
  rtglyphs::RayTracedTree::ForEach(gathered,
    [&](vtkPolyData* points)
    {
      vtkDataArray* positions = points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
      auto trail =
        vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(positions ? positions->GetDataType() : VTK_FLOAT));
      trail->SetName(rtglyphs::RayTracedArrays::Trail);
      trail->SetNumberOfComponents(3 * static_cast<int>(this->Earlier.size()));
      rtglyphs::RayTracedArrays::Resize(trail, points->GetNumberOfPoints());
      trail->Fill(vtkMath::Nan());
      points->GetPointData()->AddArray(trail);
      trails.push_back(trail);
    });

  const std::vector<glm::dvec3> translations = Translations(images);
  std::vector<GlyphStep::Entry> later = this->Shown.GetEntries(); // those whose trails go on, with their last places
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
std::string rtglyphs::GlyphStepTrail::TakeMessage()
{
  return this->Problem == this->Said ? std::string() : this->Said = this->Problem;
}
