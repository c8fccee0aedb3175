#include "GlyphStep.h"

#include "Finite.h"
#include "Parallel.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTree.h"
#include "vtkArrayDispatch.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

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

// Null: there are none.
vtkDataArray* IdsOf(vtkPolyData* points, const std::string& name)
{
  vtkPointData* data = points->GetPointData();
  vtkDataArray* ids = rtglyphs::RayTracedArrays::IsNone(name) ? data->GetGlobalIds() : data->GetArray(name.c_str());
  return ids && ids->GetNumberOfComponents() == 1 ? ids : nullptr;
}

// The longest displacements along each axis that are motion; longer ones cross a periodic boundary.
std::array<double, 3> LongestDisplacements(const rtglyphs::GlyphStep::Pairs& pairs)
{
  std::array<double, 3> longest{ { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
  const auto find = [&](std::size_t c)
  {
    std::vector<double> lengths;
    lengths.reserve(pairs.size());
    double least = HUGE_VAL, most = -HUGE_VAL, longestOfAll = 0.0;
    for (const auto& [now, before] : pairs)
    {
      lengths.push_back(std::abs(now->X[c] - before->X[c]));
      longestOfAll = std::max(longestOfAll, lengths.back());
      least = std::min({ least, now->X[c], before->X[c] });
      most = std::max({ most, now->X[c], before->X[c] });
    }
    if (longestOfAll <= 0.5 * (most - least))
    {
      return; // without sorting
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    longest[c] = *middle < 0.1 * (most - least) ? 0.5 * (most - least) : HUGE_VAL;
  };
  rtg::ParallelFor(pairs.empty() ? 0 : 3, find);
  return longest;
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphStep::GlyphStep(vtkDataObject* tree, const std::string& idArray)
{
  int leaf = 0;
  for (vtkPolyData* points : vtkCompositeDataSet::GetDataSets<vtkPolyData>(tree))
  {
    this->Points += points->GetNumberOfPoints();
    vtkDataArray* ids = points->GetNumberOfPoints() > 0 ? IdsOf(points, idArray) : nullptr;
    if (ids)
    {
      this->AnyIds = true;
      this->Add(points, ids, leaf);
    }
    ++leaf;
  }
  this->KeepUnique();
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStep::Add(vtkPolyData* points, vtkDataArray* ids, int leaf)
{
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<std::int64_t> numbers(count);
  ReadIds read;
  if (!vtkArrayDispatch::Dispatch::Execute(ids, read, numbers))
  {
    read(ids, numbers);
  }
  const std::size_t first = this->Entries.size();
  this->Entries.resize(first + count);
  const unsigned int block = rtglyphs::RayTracedTree::FlatIndex(points);
  rtglyphs::RayTracedParallel::ForEach(count,
    [&](vtkIdType i)
    {
      Entry& entry = this->Entries[first + i];
      entry.Id = numbers[i];
      entry.Block = block;
      entry.Leaf = leaf;
      entry.Point = i;
      points->GetPoint(i, entry.X);
    });
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStep::KeepUnique()
{
  std::vector<Entry>& entries = this->Entries;
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
rtglyphs::GlyphStep::Pairs rtglyphs::GlyphStep::Match(const std::vector<Entry>& now, const std::vector<Entry>& before)
{
  return rtglyphs::RayTracedParallel::Reduce(
    static_cast<vtkIdType>(now.size()), Pairs(),
    [&](vtkIdType begin, vtkIdType end, Pairs& own)
    {
      const auto precedes = [](const Entry& a, const Entry& b) { return a.Key() < b.Key(); };
      auto partner = std::lower_bound(before.begin(), before.end(), now[begin], precedes);
      for (vtkIdType i = begin; i < end; ++i)
      {
        partner = std::find_if(partner, before.end(), [&](const Entry& other) { return other.Key() >= now[i].Key(); });
        if (partner != before.end() && partner->Key() == now[i].Key())
        {
          own.emplace_back(&now[i], &*partner);
        }
      }
    },
    [](Pairs& all, const Pairs& own) { all.insert(all.end(), own.begin(), own.end()); });
}

//----------------------------------------------------------------------------
rtglyphs::GlyphStep::Pairs rtglyphs::GlyphStep::WithoutCrossings(Pairs pairs)
{
  const std::array<double, 3> longest = LongestDisplacements(pairs);
  std::erase_if(pairs,
    [&longest](const auto& pair)
    {
      bool crossed = false;
      for (int c = 0; c < 3; ++c)
      {
        crossed |= std::abs(pair.first->X[c] - pair.second->X[c]) > longest[c];
      }
      return crossed;
    });
  return pairs;
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphStep::IdsNeeded(const std::string& property, const std::string& consequence)
{
  return property +
    " must identify points, and the points have neither global ids nor the array that PointIdArray names, of one "
    "component; so " +
    consequence +
    ". Choose a PointIdArray; where points never change their order, the filter Point And Cell Ids makes one.";
}
