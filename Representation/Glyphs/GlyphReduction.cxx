#include "GlyphReduction.h"

#include "Finite.h"
#include "GlyphBounds.h"
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
#include <vector>

namespace
{
using Settings = rtglyphs::GlyphSettings;
namespace parallel = rtglyphs::RayTracedParallel;

constexpr double fewer = 0.25; // at most this fraction of the points is left, else all are

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
double Covered(double area, double count, double cell, double fill)
{
  const double side = cell * cell / fill;
  return count == 1.0 ? area : side * (1.0 - std::pow(std::max(0.0, 1.0 - area / (side * count)), count));
}

class Reducer
{
public:
  Reducer(const rtglyphs::RayTracedBlocks& blocks, const Settings& settings, double cell)
    : Joined(blocks.GetPolyData())
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

  vtkSmartPointer<vtkPolyData> operator()(const rtglyphs::RayTracedBlocks::Block& block) const
  {
    auto out = vtkSmartPointer<vtkPolyData>::New();
    out->GetFieldData()->PassData(block.Data->GetFieldData());
    if (!block.Visible || block.Data->GetNumberOfPoints() == 0)
    {
      return out;
    }
    vtkNew<vtkPointData> copied;
    std::vector<vtkDataArray*> averaged;
    this->FindArrays(block, copied, averaged);
    Sums sums;
    if (!this->Add(block, averaged, sums))
    {
      return block.Data;
    }
    const std::vector<vtkIdType> groups = parallel::Select(
      static_cast<vtkIdType>(sums.Chosen.size()), [&sums](vtkIdType group) { return *sums.Get(group) > 0.0; });
    const auto count = static_cast<vtkIdType>(groups.size());
    vtkNew<vtkIdList> chosen;
    chosen->SetNumberOfIds(count);
    vtkNew<vtkPoints> places;
    places->SetDataType(block.Data->GetPoints()->GetDataType());
    rtglyphs::RayTracedArrays::Resize(places->GetData(), count);
    parallel::ForEach(count,
      [&](vtkIdType i)
      {
        chosen->SetId(i, sums.Chosen[groups[i]]);
        places->GetData()->SetTuple(i, chosen->GetId(i), block.Data->GetPoints()->GetData());
      });
    out->SetPoints(places);
    CopyOf(copied, chosen, out->GetPointData());
    std::size_t first = Sums::COMPONENTS;
    for (vtkDataArray* array : averaged)
    {
      const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
      const vtkSmartPointer<vtkDoubleArray> means = NewArray(array->GetName(), array->GetNumberOfComponents(), count);
      means->CopyComponentNames(array);
      parallel::ForEach(count,
        [&](vtkIdType i)
        {
          const double* sum = sums.Get(groups[i]);
          double* const mean = means->GetPointer(i * array->GetNumberOfComponents());
          for (std::size_t c = 0; c < components; ++c)
          {
            mean[c] = sum[first + c] / sum[Sums::NUMBER];
          }
        });
      out->GetPointData()->AddArray(means);
      first += components;
    }
    if (block.Data->GetNumberOfVerts() > 0) // one of each point
    {
      vtkNew<vtkCellArray> vertices;
      for (vtkIdType i = 0; i < count; ++i)
      {
        vertices->InsertNextCell(1, &i);
      }
      out->SetVerts(vertices);
      CopyOf(block.Data->GetCellData(), chosen, out->GetCellData());
    }
    this->AddAreas(out, groups, sums);
    return out;
  }

private:
  // Sums over each cell of the grid, and of each point with a large glyph.
  struct Sums
  {
    enum Values
    {
      NUMBER, // of points
      AREA,
      COMPONENTS // the sum of each one's finite values, as if the others had their mean
    };
    const double* Get(vtkIdType group) const { return &this->All[group * this->Width]; }

    std::size_t Width = COMPONENTS;
    std::vector<double> All;
    std::vector<std::uint32_t> Chosen; // one of the points
  };

  // Rotations and whole numbers have no mean.
  void FindArrays(
    const rtglyphs::RayTracedBlocks::Block& block, vtkPointData* copied, std::vector<vtkDataArray*>& averaged) const
  {
    for (int i = 0; i < block.Data->GetPointData()->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = block.Data->GetPointData()->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      const bool colors = block.Scalars.On && block.Scalars.Array == name;
      if (!name.empty() && (colors || this->Used.count(name) || rtglyphs::RayTracedArrays::IsOwn(name)))
      {
        auto* numbers = vtkDataArray::SafeDownCast(array);
        const bool rotations = this->How.Orient && name == this->How.OrientationArray &&
          rtglyphs::GlyphArrays::OrientationMode(numbers, this->How) != Settings::DIRECTION;
        if ((array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE) && !rotations)
        {
          averaged.push_back(numbers);
        }
        else
        {
          copied->AddArray(array);
        }
      }
    }
  }

  // The number of groups; 0: they would hardly be fewer than the points. Neighbors are far from each other, so that
  // threads have alike parts of the points.
  std::size_t FindGroups(
    const rtglyphs::RayTracedBlocks::Block& block, std::vector<std::uint32_t>& groups, std::vector<float>& areas) const
  {
    constexpr std::uint32_t alone = none - 1, apart = 64;
    const vtkIdType count = block.Data->GetNumberOfPoints();
    vtkDataArray* positions = block.Data->GetPoints()->GetData();
    const double* bounds = block.Data->GetPoints()->GetBounds();
    const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]), upper(bounds[1], bounds[3], bounds[5]);
    const glm::dvec3 sides = glm::floor((upper - lower) / this->Cell) + 1.0;
    const double all = sides.x * sides.y * sides.z;
    if (!(all <= static_cast<double>(count)) || count >= alone / 2)
    {
      return 0;
    }
    const std::uint32_t part = static_cast<std::uint32_t>(all) / apart + 1;
    areas.resize(count);
    groups.resize(count, none);
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
            const auto cell = static_cast<std::uint32_t>((place.z * sides.y + place.y) * sides.x + place.x);
            const bool large = std::max({ size.x, size.y, size.z }) > this->Cell;
            groups[i] = large ? alone : cell % apart * part + cell / apart;
          }
        }
      });
    const std::vector<vtkIdType> large = parallel::Select(count, [&](vtkIdType i) { return groups[i] == alone; });
    std::size_t number = apart * part;
    for (const vtkIdType i : large)
    {
      groups[i] = static_cast<std::uint32_t>(number++);
    }
    return number <= static_cast<std::size_t>(count) ? number : 0;
  }

  // False: the groups would hardly be fewer than the points.
  bool Add(const rtglyphs::RayTracedBlocks::Block& block, const std::vector<vtkDataArray*>& averaged, Sums& sums) const
  {
    std::vector<std::uint32_t> groups;
    std::vector<float> areas;
    const std::size_t number = this->FindGroups(block, groups, areas);
    if (number == 0)
    {
      return false;
    }
    for (vtkDataArray* array : averaged)
    {
      sums.Width += static_cast<std::size_t>(array->GetNumberOfComponents());
    }
    sums.All.resize(sums.Width * number);
    sums.Chosen.resize(number);
    // Each thread goes through all points and adds those of its own groups, in their order.
    const std::size_t threads = rtg::ThreadCount();
    rtg::ParallelFor(threads,
      [&](std::size_t thread)
      {
        const auto begin = static_cast<std::uint32_t>(thread * number / threads);
        const auto end = static_cast<std::uint32_t>((thread + 1) * number / threads);
        std::vector<rtglyphs::GlyphTuples> tuples(averaged.begin(), averaged.end());
        std::vector<std::size_t> lacking;   // sums, once for each value that is not finite
        constexpr std::size_t atOnce = 256; // so that their sums stay in the cache
        std::vector<std::uint32_t> own;
        for (std::size_t i = 0; i < groups.size();)
        {
          own.clear();
          for (const std::size_t next = std::min(i + atOnce, groups.size()); i < next; ++i)
          {
            if (groups[i] >= begin && groups[i] < end)
            {
              own.push_back(static_cast<std::uint32_t>(i));
            }
          }
          for (const std::uint32_t point : own)
          {
            double* const sum = &sums.All[sums.Width * groups[point]];
            sum[Sums::NUMBER] += 1.0;
            sum[Sums::AREA] += areas[point];
            const std::uint64_t chance = (point * 0x9e3779b97f4a7c15ull) >> 32;
            if ((chance * static_cast<std::uint32_t>(sum[Sums::NUMBER])) >> 32 == 0)
            {
              sums.Chosen[groups[point]] = point;
            }
          }
          std::size_t first = Sums::COMPONENTS;
          for (rtglyphs::GlyphTuples& values : tuples)
          {
            for (const std::uint32_t point : own)
            {
              const double* tuple = values.Get(point);
              for (int c = 0; c < values.Size(); ++c)
              {
                const std::size_t at = sums.Width * groups[point] + first + c;
                sums.All[at] += std::isfinite(tuple[c]) ? tuple[c] : 0.0;
                if (!std::isfinite(tuple[c]))
                {
                  lacking.push_back(at);
                }
              }
            }
            first += values.Size();
          }
        }
        std::sort(lacking.begin(), lacking.end());
        for (auto first = lacking.begin(); first != lacking.end();)
        {
          const auto last = std::upper_bound(first, lacking.end(), *first);
          const double all = sums.All[*first - *first % sums.Width + Sums::NUMBER];
          sums.All[*first] *= all / (all - static_cast<double>(last - first)); // NaN where there is none
          first = last;
        }
      });
    return true;
  }

  static vtkSmartPointer<vtkDoubleArray> NewArray(const char* name, int components, vtkIdType count)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    rtglyphs::RayTracedArrays::Resize(array, count);
    return array;
  }

  static void CopyOf(vtkDataSetAttributes* from, vtkIdList* chosen, vtkDataSetAttributes* to)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, chosen->GetNumberOfIds());
    to->CopyData(from, chosen);
  }

  void AddAreas(vtkPolyData* out, const std::vector<vtkIdType>& groups, const Sums& sums) const
  {
    const vtkSmartPointer<vtkDoubleArray> numbers =
      NewArray(rtglyphs::RayTracedArrays::Reduced, 3, out->GetNumberOfPoints());
    const rtglyphs::GlyphSizes sizes(out, this->Left);
    const rtglyphs::GlyphUnturnedBox boxes(this->Left, sizes);
    parallel::ForChunks(out->GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        rtglyphs::GlyphSizes::Tuples tuples(sizes);
        for (vtkIdType i = begin; i < end; ++i)
        {
          const double* sum = sums.Get(groups[i]);
          const double covered = Covered(sum[Sums::AREA], sum[Sums::NUMBER], this->Cell, FillOf(this->How.Shape));
          const double factor = std::sqrt(covered / AreaOf(SidesOf(i, sizes, tuples, boxes)));
          double* const tuple = numbers->GetPointer(3 * i);
          tuple[0] = sum[Sums::NUMBER];
          tuple[1] = sum[Sums::AREA];
          tuple[2] = rtg::IsPositive(factor) ? factor : 1.0;
        }
      });
    out->GetPointData()->AddArray(numbers);
  }

  static constexpr std::uint32_t none = UINT32_MAX; // group of points without a glyph
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
  this->Known.Update(
    { rtglyphs::GlyphArrays::KeyOf(blocks.GetPolyData(), { settings }, blocks.GetHidden()), blocks.GetVersion(), cell },
    [&]
    {
      const Reducer reduce(blocks, settings, cell);
      vtkIdType left = 0;
      this->Reduced = rtglyphs::RayTracedTree::Change(tree,
        [&](vtkPolyData* leaf)
        {
          vtkSmartPointer<vtkPolyData> made = leaf;
          for (const rtglyphs::RayTracedBlocks::Block& block : blocks.GetBlocks())
          {
            made = block.Data == leaf ? reduce(block) : made;
          }
          left += made->GetNumberOfPoints();
          return made;
        });
      if (static_cast<double>(left) > fewer * static_cast<double>(blocks.GetPolyData()->GetNumberOfPoints()))
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
