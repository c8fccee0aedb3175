#include "GlyphReduction.h"

#include "Finite.h"
#include "GlyphBounds.h"
#include "GlyphTuples.h"
#include "Parallel.h"
#include "RayTracedArrays.h"
#include "RayTracedParallel.h"
#include "RayTracedTree.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Settings = rtglyphs::GlyphSettings;
namespace parallel = rtglyphs::RayTracedParallel;

constexpr double fewer = 0.25; // at most this fraction of the points is left, else all are
// Of the points, each sorted by itself; a constant, so that the order does not depend on the number of threads.
constexpr std::size_t shares = 8;

// The sides of a glyph's box along its own axes; zero where it has none.
glm::dvec3 SidesOf(vtkIdType point, const rtglyphs::GlyphSizes& sizes, rtglyphs::GlyphSizes::Tuples& tuples,
  const rtglyphs::GlyphUnturnedBox& boxes)
{
  if (sizes.GetTensors()) // whose boxes have one side for all
  {
    rtglyphs::GlyphSizes::Glyph glyph;
    const bool shown = sizes.Make(point, tuples, glyph, nullptr) == rtglyphs::GlyphOutcomes::SHOWN;
    return shown ? glm::abs(glyph.Size) : glm::dvec3(0.0);
  }
  const rtg::DoubleBox box = boxes(point, tuples);
  return box.upper - box.lower;
}

// The mean of a box's three faces.
double AreaOf(const glm::dvec3& sides)
{
  return (sides.x * sides.y + sides.y * sides.z + sides.z * sides.x) / 3.0;
}

// What glyphs cover of their boxes' faces, on average; of arrows, of vtkArrowSource's.
double FillOf(rtg::Shape shape)
{
  return shape == rtg::Shape::Arrow ? 0.41 : shape == rtg::Shape::Cone ? 0.6 : 0.785;
}

// The faces of a box that covers what `count` glyphs of this area in all do, seen through a side of a cell.
double Covered(double area, std::uint32_t count, double cell, double fill)
{
  const double side = cell * cell / fill;
  return count == 1 ? area : side * (1.0 - std::pow(std::max(0.0, 1.0 - area / (side * count)), count));
}

// Lists of points, one after the other.
struct Groups
{
  std::vector<std::uint32_t> Points, Ends;
  std::size_t size() const { return this->Ends.size(); }
  std::uint32_t Begin(std::size_t group) const { return group == 0 ? 0 : this->Ends[group - 1]; }
  std::uint32_t Count(std::size_t group) const { return this->Ends[group] - this->Begin(group); }
  std::uint32_t Chosen(std::size_t group) const
  {
    const auto chance = static_cast<std::uint32_t>(((group + 1) * 0x9e3779b97f4a7c15ull) >> 32);
    return this->Points[this->Begin(group) + chance % this->Count(group)];
  }
};

class Reducer
{
public:
  Reducer(const rtglyphs::RayTracedBlocks& blocks, const Settings& settings, double cell)
    : Joined(blocks.GetPoints())
    , How(settings)
    , Left(rtglyphs::GlyphReduction::SettingsFor(settings))
    , Cell(cell)
    , Sizes(this->Joined, this->How)
    , Boxes(this->How, this->Sizes)
  {
    for (vtkDataArray* array : rtglyphs::GlyphArrays::All(this->Joined, this->How))
    {
      if (array && array->GetName())
      {
        this->Used.insert(array->GetName());
      }
    }
  }

  vtkSmartPointer<vtkPolyData> operator()(const rtglyphs::RayTracedBlocks::Block& block)
  {
    auto out = vtkSmartPointer<vtkPolyData>::New();
    out->GetFieldData()->PassData(block.Data->GetFieldData());
    if (!block.Visible || block.Data->GetNumberOfPoints() == 0)
    {
      return out;
    }
    std::vector<float> areas;
    const Groups groups = this->Sort(block, areas);
    if (groups.size() == 0)
    {
      return block.Data;
    }
    vtkNew<vtkIdList> chosen;
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
      chosen->InsertNextId(groups.Chosen(i));
    }
    vtkNew<vtkPoints> places;
    places->SetDataType(block.Data->GetPoints()->GetDataType());
    block.Data->GetPoints()->GetPoints(chosen, places);
    out->SetPoints(places);
    vtkNew<vtkPointData> used;
    for (int i = 0; i < block.Data->GetPointData()->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = block.Data->GetPointData()->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      const bool colors = block.Scalars.On && block.Scalars.Array == name;
      if (!name.empty() && (colors || this->Used.count(name) || rtglyphs::RayTracedArrays::IsOwn(name)))
      {
        used->AddArray(array);
      }
    }
    CopyOf(used, chosen, out->GetPointData());
    for (int i = 0; i < used->GetNumberOfArrays(); ++i)
    {
      if (this->HasMean(used->GetAbstractArray(i)))
      {
        out->GetPointData()->AddArray(Mean(used->GetArray(i), groups));
      }
    }
    if (block.Data->GetNumberOfVerts() > 0) // one of each point
    {
      vtkNew<vtkCellArray> vertices;
      for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
      {
        vertices->InsertNextCell(1, &i);
      }
      out->SetVerts(vertices);
      CopyOf(block.Data->GetCellData(), chosen, out->GetCellData());
    }
    this->AddAreas(out, groups, areas);
    return out;
  }

private:
  // Points by cells, and those with large glyphs each by itself; none: they would hardly be fewer.
  Groups Sort(const rtglyphs::RayTracedBlocks::Block& block, std::vector<float>& areas) const
  {
    constexpr std::uint32_t none = UINT32_MAX, alone = none - 1;
    Groups groups;
    const vtkIdType count = block.Data->GetNumberOfPoints();
    vtkDataArray* positions = block.Data->GetPoints()->GetData();
    const double* bounds = block.Data->GetPoints()->GetBounds();
    const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]), upper(bounds[1], bounds[3], bounds[5]);
    const glm::dvec3 sides = glm::floor((upper - lower) / this->Cell) + 1.0;
    const double all = sides.x * sides.y * sides.z;
    if (!(all <= 2.0 * static_cast<double>(count)) || count >= alone)
    {
      return groups;
    }
    areas.resize(count);
    std::vector<std::uint32_t> cells(count, none);
    parallel::ForChunks(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphTuples tuples(positions);
        rtglyphs::GlyphSizes::Tuples sizes(this->Sizes);
        for (vtkIdType i = begin; i < end; ++i)
        {
          const double* x = tuples.Get(i);
          const glm::dvec3 size = SidesOf(block.FirstPoint + i, this->Sizes, sizes, this->Boxes);
          areas[i] = static_cast<float>(AreaOf(size));
          if (rtg::IsFinite(x) && rtg::IsPositive(areas[i]))
          {
            const glm::dvec3 place = glm::floor((glm::dvec3(x[0], x[1], x[2]) - lower) / this->Cell);
            cells[i] = std::max({ size.x, size.y, size.z }) > this->Cell
              ? alone
              : static_cast<std::uint32_t>((place.z * sides.y + place.y) * sides.x + place.x);
          }
        }
      });

    // Counting sort, which keeps the order of the points in a cell.
    const auto number = static_cast<std::size_t>(all);
    std::vector<std::uint32_t> next(shares * number);
    const auto forShares = [&](const auto& work)
    {
      rtg::ParallelFor(shares,
        [&](std::size_t share)
        {
          const auto end = static_cast<vtkIdType>((share + 1) * count / shares);
          for (auto i = static_cast<vtkIdType>(share * count / shares); i < end; ++i)
          {
            if (cells[i] < alone)
            {
              work(i, next[share * number + cells[i]]);
            }
          }
        });
    };
    forShares([](vtkIdType, std::uint32_t& counted) { ++counted; });
    std::uint32_t last = 0;
    for (std::size_t cell = 0; cell < number; ++cell)
    {
      const std::uint32_t first = last;
      for (std::size_t share = 0; share < shares; ++share)
      {
        last += std::exchange(next[share * number + cell], last);
      }
      if (last > first)
      {
        groups.Ends.push_back(last);
      }
    }
    const std::vector<vtkIdType> large = parallel::Select(count, [&](vtkIdType i) { return cells[i] == alone; });
    if (static_cast<double>(groups.size() + large.size()) > fewer * static_cast<double>(count))
    {
      return {};
    }
    groups.Points.resize(last);
    forShares([&](vtkIdType i, std::uint32_t& place) { groups.Points[place++] = static_cast<std::uint32_t>(i); });
    for (const vtkIdType i : large)
    {
      groups.Points.push_back(static_cast<std::uint32_t>(i));
      groups.Ends.push_back(static_cast<std::uint32_t>(groups.Points.size()));
    }
    return groups;
  }

  // Rotations and whole numbers have none.
  bool HasMean(vtkAbstractArray* array) const
  {
    const bool rotations = this->How.Orient && array->GetName() == this->How.OrientationArray &&
      rtglyphs::GlyphArrays::OrientationMode(vtkDataArray::SafeDownCast(array), this->How) != Settings::DIRECTION;
    return (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE) && !rotations;
  }

  static void CopyOf(vtkDataSetAttributes* from, vtkIdList* chosen, vtkDataSetAttributes* to)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, chosen->GetNumberOfIds());
    to->CopyData(from, chosen);
  }

  // Of the values that are finite.
  static vtkSmartPointer<vtkDoubleArray> Mean(vtkDataArray* from, const Groups& groups)
  {
    const auto count = static_cast<vtkIdType>(groups.size());
    const int components = from->GetNumberOfComponents();
    auto to = vtkSmartPointer<vtkDoubleArray>::New();
    to->SetName(from->GetName());
    to->SetNumberOfComponents(components);
    to->CopyComponentNames(from);
    rtglyphs::RayTracedArrays::Resize(to, count);
    double* const means = to->GetPointer(0);
    parallel::ForChunks(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphTuples tuples(from);
        std::vector<double> counted(components);
        for (vtkIdType group = begin; group < end; ++group)
        {
          double* const mean = means + group * components;
          std::fill_n(mean, components, 0.0);
          std::fill_n(counted.begin(), components, 0.0);
          for (std::uint32_t i = groups.Begin(group); i < groups.Ends[group]; ++i)
          {
            const double* tuple = tuples.Get(groups.Points[i]);
            for (int c = 0; c < components; ++c)
            {
              mean[c] += std::isfinite(tuple[c]) ? tuple[c] : 0.0;
              counted[c] += std::isfinite(tuple[c]);
            }
          }
          for (int c = 0; c < components; ++c)
          {
            mean[c] /= counted[c]; // NaN where there is none
          }
        }
      });
    return to;
  }

  void AddAreas(vtkPolyData* out, const Groups& groups, const std::vector<float>& areas) const
  {
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName(rtglyphs::RayTracedArrays::Reduced);
    numbers->SetNumberOfComponents(3);
    rtglyphs::RayTracedArrays::Resize(numbers, out->GetNumberOfPoints());
    const rtglyphs::GlyphSizes sizes(out, this->Left);
    const rtglyphs::GlyphUnturnedBox boxes(this->Left, sizes);
    parallel::ForChunks(out->GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphSizes::Tuples tuples(sizes);
        for (vtkIdType group = begin; group < end; ++group)
        {
          double area = 0.0;
          for (std::uint32_t i = groups.Begin(group); i < groups.Ends[group]; ++i)
          {
            area += areas[groups.Points[i]];
          }
          const double covered = Covered(area, groups.Count(group), this->Cell, FillOf(this->How.Shape));
          const double factor = std::sqrt(covered / AreaOf(SidesOf(group, sizes, tuples, boxes)));
          double* const tuple = numbers->GetPointer(3 * group);
          tuple[0] = groups.Count(group);
          tuple[1] = area;
          tuple[2] = rtg::IsPositive(factor) ? factor : 1.0;
        }
      });
    out->GetPointData()->AddArray(numbers);
  }

  vtkPolyData* const Joined;
  const Settings How, Left;
  const double Cell;
  const rtglyphs::GlyphSizes Sizes;
  const rtglyphs::GlyphUnturnedBox Boxes;
  std::set<std::string> Used; // names of arrays
};
}

//----------------------------------------------------------------------------
vtkDataObject* rtglyphs::GlyphReduction::Get(
  vtkDataObject* tree, const rtglyphs::RayTracedBlocks& blocks, const Settings& settings, double cell)
{
  std::vector<vtkMTimeType> colors;
  for (const rtglyphs::RayTracedBlocks::Block& block : blocks.GetBlocks())
  {
    for (const std::string& name : { block.Scalars.Array, std::string(rtglyphs::RayTracedArrays::Selected) })
    {
      vtkAbstractArray* array = block.Data->GetPointData()->GetAbstractArray(name.c_str());
      colors.push_back(array ? array->GetMTime() : 0);
    }
  }
  this->Known.Update(
    { rtglyphs::GlyphArrays::KeyOf(blocks.GetPoints(), { settings }, blocks.GetHidden()), colors, cell },
    [&]
    {
      Reducer reduce(blocks, settings, cell);
      vtkIdType left = 0;
      this->Reduced = rtglyphs::RayTracedTree::Change(tree,
        [&](vtkPolyData* leaf)
        {
          const auto& all = blocks.GetBlocks();
          const auto block = std::find_if(all.begin(), all.end(), [leaf](const auto& b) { return b.Data == leaf; });
          const vtkSmartPointer<vtkPolyData> made = reduce(*block);
          left += made->GetNumberOfPoints();
          return made;
        });
      if (static_cast<double>(left) > fewer * static_cast<double>(blocks.GetPoints()->GetNumberOfPoints()))
      {
        this->Reduced = nullptr;
      }
    });
  return this->Reduced;
}

//----------------------------------------------------------------------------
rtglyphs::GlyphSettings rtglyphs::GlyphReduction::SettingsFor(Settings settings)
{
  settings.Arrow.fixedHeads = false; // areas are those of whole arrows
  return settings;
}
