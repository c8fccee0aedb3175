#include "GlyphStepVelocity.h"

#include "Finite.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTree.h"
#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Without going through double, which has not room for all 64-bit ids.
struct ReadIds
{
  template <typename Array>
  void operator()(Array* array, std::vector<std::int64_t>& ids) const
  {
    const auto values = vtk::DataArrayValueRange<1>(array);
    std::transform(
      values.begin(), values.end(), ids.begin(), [](auto value) { return static_cast<std::int64_t>(value); });
  }
};
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::Reset()
{
  this->Now = this->Before = Step();
  this->Outcome = FOUND;
  this->Said = {};
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphStepVelocity::SetPointIdArray(const std::string& name)
{
  if (this->PointIdArray == name)
  {
    return false;
  }
  this->PointIdArray = name;
  this->Reset();
  return true;
}

//----------------------------------------------------------------------------
vtkDataArray* rtglyphs::GlyphStepVelocity::IdsOf(vtkPolyData* points) const
{
  vtkPointData* data = points->GetPointData();
  const bool named = !rtglyphs::RayTracedArrays::IsNone(this->PointIdArray);
  vtkDataArray* ids = named ? data->GetArray(this->PointIdArray.c_str()) : data->GetGlobalIds();
  return ids && ids->GetNumberOfComponents() == 1 ? ids : nullptr;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::AddTo(vtkDataObject* gathered, vtkDataObject* input, vtkAlgorithm* source)
{
  if (this->Source != source)
  {
    this->Reset();
    this->Source = source;
  }
  vtkInformation* info = input->GetInformation();
  this->Follow(
    gathered, info->Has(vtkDataObject::DATA_TIME_STEP()) ? info->Get(vtkDataObject::DATA_TIME_STEP()) : vtkMath::Nan());
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::AddEntries(
  vtkPolyData* points, vtkDataArray* ids, vtkDataArray* velocities, std::vector<Entry>& entries)
{
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<std::int64_t> numbers(count);
  ReadIds read;
  if (!vtkArrayDispatch::Dispatch::Execute(ids, read, numbers))
  {
    read(ids, numbers);
  }
  const std::size_t first = entries.size();
  entries.resize(first + count);
  const unsigned int block = rtglyphs::RayTracedTree::FlatIndex(points);
  rtglyphs::RayTracedParallel::ForChunks(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Entry& entry = entries[first + i];
        entry.Id = numbers[i];
        entry.Block = block;
        entry.Velocities = velocities;
        entry.Point = i;
        points->GetPoint(i, entry.X);
      }
    });
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::KeepUnique(std::vector<Entry>& entries)
{
  const auto before = [](const Entry& a, const Entry& b) { return a.Key() < b.Key(); };
  if (!std::is_sorted(entries.begin(), entries.end(), before))
  {
    std::sort(entries.begin(), entries.end(), before);
  }
  // Duplicate ids of a block identify no point.
  std::size_t kept = 0;
  const auto endOf = [&](std::size_t first, const auto& key)
  {
    std::size_t last = first + 1;
    while (last < entries.size() && key(entries[last]) == key(entries[first]))
    {
      ++last;
    }
    return last;
  };
  for (std::size_t first = 0; first < entries.size();)
  {
    const std::size_t last = endOf(first, [](const Entry& entry) { return entry.Id; });
    const bool unique = last == first + 1;
    while (first < last)
    {
      const std::size_t next = endOf(first, [](const Entry& entry) { return entry.Key(); });
      if (next == first + 1 && rtg::IsFinite(entries[first].X))
      {
        entries[kept] = entries[first];
        entries[kept].Block = unique ? 0 : entries[first].Block;
        ++kept;
      }
      first = next;
    }
  }
  entries.resize(kept);
}

//----------------------------------------------------------------------------
// Half of the extent along each axis where most points move less than a tenth of it, else infinite.
std::array<double, 3> rtglyphs::GlyphStepVelocity::LongestWays(const Pairs& pairs)
{
  std::array<double, 3> longest{ { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
  for (int c = 0; c < 3 && !pairs.empty(); ++c)
  {
    std::vector<double> ways;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const auto& [now, before] : pairs)
    {
      ways.push_back(std::abs(now->X[c] - before->X[c]));
      least = std::min({ least, now->X[c], before->X[c] });
      most = std::max({ most, now->X[c], before->X[c] });
    }
    const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
    std::nth_element(ways.begin(), middle, ways.end());
    longest[c] = *middle < 0.1 * (most - least) ? 0.5 * (most - least) : HUGE_VAL;
  }
  return longest;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::Follow(vtkDataObject* gathered, double time)
{
  std::vector<Entry> entries;
  this->Points = 0;
  this->WithoutPartner = 0;
  bool anyIds = false;
  rtglyphs::RayTracedTree::ForEach(gathered,
    [&](vtkPolyData* points)
    {
      vtkNew<vtkFloatArray> velocities;
      velocities->SetName(Name());
      velocities->SetNumberOfComponents(3);
      rtglyphs::RayTracedArrays::Resize(velocities, points->GetNumberOfPoints());
      velocities->FillValue(0.0f);
      points->GetPointData()->AddArray(velocities);
      this->Points += points->GetNumberOfPoints();
      vtkDataArray* ids = points->GetNumberOfPoints() > 0 ? this->IdsOf(points) : nullptr;
      if (ids)
      {
        anyIds = true;
        AddEntries(points, ids, velocities, entries);
      }
    });
  if (this->Points > 0 && !anyIds)
  {
    this->Outcome = NO_IDS;
    return;
  }
  if (!std::isfinite(time))
  {
    this->Outcome = NO_TIME;
    return;
  }

  // Data of the same time that come again, as after a change of a filter, take the place of what they were. A step
  // without points counts: those of the next have come from nowhere.
  if (this->Now.Seen && this->Now.Time != time)
  {
    std::swap(this->Before, this->Now);
  }
  this->Now.Seen = true;
  this->Now.Time = time;
  KeepUnique(entries);
  this->Now.Entries = std::move(entries);
  if (!this->Before.Seen)
  {
    this->Outcome = FOUND;
    return;
  }

  const double length = time - this->Before.Time;
  vtkIdType partners = 0;
  Pairs pairs;
  auto partner = this->Before.Entries.begin();
  for (const Entry& now : this->Now.Entries)
  {
    partner = std::find_if(
      partner, this->Before.Entries.end(), [&now](const Entry& before) { return before.Key() >= now.Key(); });
    if (partner == this->Before.Entries.end())
    {
      break;
    }
    if (partner->Key() == now.Key())
    {
      pairs.emplace_back(&now, &*partner);
      ++partners;
    }
  }
  const std::array<double, 3> longest = LongestWays(pairs);
  for (const auto& [now, before] : pairs)
  {
    bool crossed = false;
    for (int c = 0; c < 3; ++c)
    {
      crossed |= std::abs(now->X[c] - before->X[c]) > longest[c];
    }
    for (int c = 0; c < 3 && !crossed; ++c)
    {
      now->Velocities->SetComponent(now->Point, c, (now->X[c] - before->X[c]) / length);
    }
  }
  this->WithoutPartner = this->Points - partners;
  this->Outcome = this->WithoutPartner > 0 ? WITHOUT_PARTNER : FOUND;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphStepVelocity::GetStepLength() const
{
  return this->Before.Seen ? std::abs(this->Now.Time - this->Before.Time) : 0.0;
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphStepVelocity::TakeMessage()
{
  bool& said = this->Said[this->Outcome];
  if (said || this->Outcome == FOUND)
  {
    return "";
  }
  said = true;
  return this->Describe();
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphStepVelocity::Describe() const
{
  switch (this->Outcome)
  {
    case NO_IDS:
      return "VelocityFromPreviousStep must identify points, and the points have "
             "neither global ids nor the "
             "array that PointIdArray names, of one component; so the glyphs stand still. Choose a "
             "PointIdArray; where "
             "points never change their order, the filter Point And Cell Ids makes one.";
    case NO_TIME:
      return "VelocityFromPreviousStep needs the time of the data, which they lack; so the "
             "glyphs stand still. Open "
             "them as a time series, or choose a VelocityArray.";
    case WITHOUT_PARTNER:
    {
      std::ostringstream text;
      text << this->WithoutPartner << " of " << this->Points
           << " points stand still, because VelocityFromPreviousStep finds no single point of the "
              "same id in the step "
              "shown before, at time "
           << this->Before.Time << ". Later steps give no such message.";
      return text.str();
    }
    default:
      return "";
  }
}
