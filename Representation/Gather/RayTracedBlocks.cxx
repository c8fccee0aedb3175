#include "RayTracedBlocks.h"

#include "RayTracedArrays.h"
#include "RayTracedNumbers.h"
#include "RayTracedTree.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <sstream>

namespace
{
using Attributes = rtglyphs::RayTracedBlocks::Attributes;
using Block = rtglyphs::RayTracedBlocks::Block;

// Information of joined points: the range of each block. Of a joined array: the ranges of blocks without it.
class Ranges : public vtkObject
{
public:
  static Ranges* New();
  vtkTypeMacro(Ranges, vtkObject);
  rtglyphs::RayTracedRanges All;

  static void Set(vtkInformation* of, rtglyphs::RayTracedRanges all)
  {
    vtkNew<Ranges> ranges;
    ranges->All = std::move(all);
    of->Set(Key(), ranges);
  }
  static const rtglyphs::RayTracedRanges& Get(vtkInformation* of)
  {
    static const rtglyphs::RayTracedRanges none;
    auto* ranges = Ranges::SafeDownCast(of->Get(Key()));
    return ranges ? ranges->All : none;
  }

private:
  static vtkInformationObjectBaseKey* Key()
  {
    static auto* const key = vtkInformationObjectBaseKey::MakeKey("Ranges", "RayTracedBlocks");
    return key;
  }
};
vtkStandardNewMacro(Ranges);

// A template, because VTK has these since ParaView 5.13.
template <class Display>
void ReadScalars(Display* from, vtkDataObject* node, rtglyphs::RayTracedBlocks::Coloring& scalars)
{
  if constexpr (requires { from->HasBlockArrayName(node); })
  {
    scalars.On = from->HasBlockScalarVisibility(node) ? from->GetBlockScalarVisibility(node) : scalars.On;
    scalars.Array = from->HasBlockArrayName(node) ? from->GetBlockArrayName(node) : scalars.Array;
    scalars.ScalarMode = from->HasBlockScalarMode(node) ? from->GetBlockScalarMode(node) : scalars.ScalarMode;
    scalars.ColorMode = from->HasBlockColorMode(node) ? from->GetBlockColorMode(node) : scalars.ColorMode;
    scalars.FieldDataTuple =
      from->HasBlockFieldDataTupleId(node) ? from->GetBlockFieldDataTupleId(node) : scalars.FieldDataTuple;
    scalars.InterpolatesScalars = from->HasBlockInterpolateScalarsBeforeMapping(node)
      ? from->GetBlockInterpolateScalarsBeforeMapping(node)
      : scalars.InterpolatesScalars;
    scalars.Table = from->HasBlockLookupTable(node) ? from->GetBlockLookupTable(node) : scalars.Table;
  }
}

void Visit(vtkDataObject* node, const std::string& name, vtkCompositeDataDisplayAttributes* from, Attributes attributes,
  std::vector<Block>& out)
{
  attributes.Visible = from->HasBlockVisibility(node) ? from->GetBlockVisibility(node) : attributes.Visible;
  if (from->HasBlockOpacity(node))
  {
    attributes.Opacity = rtglyphs::RayTracedNumbers::InRange(from->GetBlockOpacity(node), 0.0, 1.0, 1.0);
  }
  if (from->HasBlockColor(node))
  {
    double color[3];
    from->GetBlockColor(node, color);
    attributes.Color = rtglyphs::RayTracedNumbers::ColorInRange(color[0], color[1], color[2]);
    attributes.Scalars.On = false;
  }
  ReadScalars(from, node, attributes.Scalars);
  if (auto* data = vtkPolyData::SafeDownCast(node))
  {
    out.push_back({ attributes, data, rtglyphs::RayTracedTree::FlatIndex(data), name });
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(node))
  {
    rtglyphs::RayTracedTree::ForEachChild(
      tree, name, [&](vtkDataObject* child, const std::string& own) { Visit(child, own, from, attributes, out); });
  }
}

vtkDataSetAttributes* AttributesOf(vtkPolyData* data, bool cells)
{
  if (cells)
  {
    return data->GetCellData();
  }
  return data->GetPointData();
}

// The arrays of one name, of each block; null where it has none, or one of another length of tuple than the first.
using Alike = std::vector<vtkDataArray*>;

std::map<std::string, Alike> FindArrays(const std::vector<vtkDataSetAttributes*>& sets)
{
  std::map<std::string, Alike> all;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    for (int k = 0; k < sets[i]->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = sets[i]->GetArray(k); // texts make no glyphs
      const std::string name = array && array->GetName() ? array->GetName() : "";
      if (!name.empty() && name != vtkDataSetAttributes::GhostArrayName() && name != rtglyphs::RayTracedArrays::CellIds)
      {
        Alike& alike = all.try_emplace(name, sets.size()).first->second;
        const auto first =
          std::find_if(alike.begin(), alike.end(), [](vtkDataArray* other) { return other != nullptr; });
        const bool fits = first == alike.end() || (*first)->GetNumberOfComponents() == array->GetNumberOfComponents();
        alike[i] = fits ? array : nullptr;
      }
    }
  }
  return all;
}

// For their values; not an instance of the first one's class, which may be an array that cannot be written to.
vtkSmartPointer<vtkDataArray> NewArray(const Alike& alike, vtkIdType tuples)
{
  vtkDataArray* first = *std::find_if(alike.begin(), alike.end(), [](vtkDataArray* array) { return array != nullptr; });
  const bool exact = std::all_of(alike.begin(), alike.end(),
    [first](vtkDataArray* array) { return !array || array->GetDataType() == first->GetDataType(); });
  auto joined = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(exact ? first->GetDataType() : VTK_DOUBLE));
  joined->SetName(first->GetName());
  joined->SetNumberOfComponents(first->GetNumberOfComponents());
  rtglyphs::RayTracedArrays::Resize(joined, tuples);
  if (std::find(alike.begin(), alike.end(), nullptr) != alike.end())
  {
    joined->Fill(0.0);
  }
  return joined;
}

// One number for each point of a block.
vtkSmartPointer<vtkDataArray> Numbers(const std::vector<Block>& blocks, vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkUnsignedIntArray>::New();
  rtglyphs::RayTracedArrays::Resize(numbers, count);
  for (const Block& block : blocks)
  {
    std::fill_n(numbers->GetPointer(block.FirstPoint), block.Data->GetNumberOfPoints(), block.FlatIndex);
  }
  numbers->SetName(rtglyphs::RayTracedArrays::CompositeIndex);
  return numbers;
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::Update(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, const Attributes& common)
{
  const bool joined = data && data == this->Joined && data->GetMTime() == this->JoinedTime;
  if (joined && attributes->GetMTime() == this->AttributesTime && common == this->Common)
  {
    return;
  }
  ++this->Version;
  this->AttributesTime = attributes->GetMTime();
  this->Common = common;
  this->Blocks.clear();
  if (data)
  {
    Visit(data, std::string(), attributes, common, this->Blocks);
  }
  this->Hidden.clear();
  vtkIdType points = 0, cells = 0;
  for (Block& block : this->Blocks)
  {
    block.FirstPoint = points;
    block.FirstCell = cells;
    points += block.Data->GetNumberOfPoints();
    cells += block.Data->GetNumberOfCells();
    if (!block.Visible && points > block.FirstPoint)
    {
      this->Hidden.push_back({ block.FirstPoint, points, block.Name });
    }
  }
  if (!joined)
  {
    this->PolyData = nullptr;
    this->Joined = data;
    this->JoinedTime = data ? data->GetMTime() : 0;
    if (data)
    {
      this->Join();
    }
  }
}

//----------------------------------------------------------------------------
const rtglyphs::RayTracedRanges& rtglyphs::RayTracedBlocks::MissingTuples(vtkDataArray* joined)
{
  static const rtglyphs::RayTracedRanges none;
  return joined && joined->HasInformation() ? Ranges::Get(joined->GetInformation()) : none;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedBlocks::IsOnOtherRanks(vtkPolyData* points, const std::string& array)
{
  auto* names =
    vtkStringArray::SafeDownCast(points->GetFieldData()->GetAbstractArray(rtglyphs::RayTracedArrays::PartialArrays));
  return names && names->LookupValue(array) >= 0;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::ReportMissing(vtkPolyData* points, const std::string& array,
  const rtglyphs::RayTracedRanges& hidden, const char* property, const char* consequence,
  std::vector<std::string>& messages)
{
  vtkDataArray* ofPoints = points->GetPointData()->GetArray(array.c_str());
  vtkDataArray* ofCells = ofPoints ? nullptr : points->GetCellData()->GetArray(array.c_str());
  const bool onOtherRanks = !ofPoints && !ofCells && IsOnOtherRanks(points, array);
  rtglyphs::RayTracedRanges missing =
    onOtherRanks ? Ranges::Get(points->GetInformation()) : MissingTuples(ofCells ? ofCells : ofPoints);
  if (onOtherRanks && missing.empty())
  {
    missing.push_back({ 0, points->GetNumberOfPoints(), std::string() });
  }
  constexpr int most = 3; // that are named
  std::string names;
  int blocks = 0;
  vtkIdType count = 0;
  for (const rtglyphs::RayTracedRange& range : missing)
  {
    const bool isHidden =
      std::any_of(hidden.begin(), hidden.end(), [&](const auto& other) { return other.Block == range.Block; });
    if (!isHidden && range.End > range.First)
    {
      count += range.End - range.First;
      ++blocks;
      names += blocks > most ? std::string() : (blocks > 1 ? ", '" : " '") + range.Block + "'";
    }
  }
  const std::string what = "no array '" + array + "'";
  const bool reported = std::any_of(messages.begin(), messages.end(),
    [&what](const std::string& message) { return message.find(what) != std::string::npos; });
  if (count == 0 || reported)
  {
    return;
  }
  const bool one = blocks == 1;
  std::ostringstream text;
  text << (names == " ''" ? "A part of the data, which one rank has," : one ? "Block" + names : "Blocks" + names);
  if (blocks > most)
  {
    text << " and " << blocks - most << " more";
  }
  text << (one ? " has " : " have ") << what;
  if (vtkDataArray* other = ofCells ? ofCells : ofPoints; other && !onOtherRanks)
  {
    text << " of " << other->GetNumberOfComponents()
         << (other->GetNumberOfComponents() == 1 ? " component" : " components");
  }
  text << ", which " << property << " names: " << (one ? "its " : "their ") << count
       << (ofCells ? " cells " : " points ") << consequence << ". Choose another array, or leave "
       << (one ? "this block" : "these blocks") << " out with BlockSelectors.";
  messages.push_back(text.str());
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::Join()
{
  this->PolyData = vtkSmartPointer<vtkPolyData>::New();
  if (this->Blocks.size() == 1 && this->Blocks.front().FlatIndex == 0)
  {
    this->PolyData->ShallowCopy(this->Blocks.front().Data);
    return;
  }
  this->JoinPoints();
  rtglyphs::RayTracedRanges ranges;
  for (const Block& block : this->Blocks)
  {
    if (block.Data->GetNumberOfPoints() > 0)
    {
      ranges.push_back({ block.FirstPoint, block.FirstPoint + block.Data->GetNumberOfPoints(), block.Name });
    }
    if (vtkAbstractArray* partial =
          block.Data->GetFieldData()->GetAbstractArray(rtglyphs::RayTracedArrays::PartialArrays))
    {
      this->PolyData->GetFieldData()->AddArray(partial);
    }
  }
  Ranges::Set(this->PolyData->GetInformation(), std::move(ranges));
  this->JoinCells(
    "lines", [](vtkPolyData* data) { return data->GetLines(); },
    [](vtkPolyData* data, vtkCellArray* cells) { data->SetLines(cells); });
  this->JoinCells(
    "polygons", [](vtkPolyData* data) { return data->GetPolys(); },
    [](vtkPolyData* data, vtkCellArray* cells) { data->SetPolys(cells); });
  this->UsedArrays.clear();
  this->JoinArrays(false);
  if (this->PolyData->GetNumberOfCells() > 0)
  {
    this->JoinArrays(true);
  }
  this->Arrays = std::move(this->UsedArrays);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::JoinPoints()
{
  Times times;
  vtkIdType count = 0;
  bool anyDouble = false;
  for (const Block& block : this->Blocks)
  {
    vtkPoints* points = block.Data->GetPoints();
    const bool some = points && points->GetNumberOfPoints() > 0;
    times.push_back(some ? points->GetData()->GetMTime() : 0);
    count += some ? points->GetNumberOfPoints() : 0;
    anyDouble |= some && points->GetDataType() != VTK_FLOAT;
  }
  if (!this->Places.second || this->Places.first != times)
  {
    auto joined = vtkSmartPointer<vtkPoints>::New();
    joined->SetDataType(anyDouble ? VTK_DOUBLE : VTK_FLOAT);
    rtglyphs::RayTracedArrays::Resize(joined->GetData(), count);
    for (const Block& block : this->Blocks)
    {
      if (block.Data->GetNumberOfPoints() > 0)
      {
        joined->InsertPoints(block.FirstPoint, block.Data->GetNumberOfPoints(), 0, block.Data->GetPoints());
      }
    }
    this->Places = { std::move(times), joined };
  }
  this->PolyData->SetPoints(this->Places.second);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::JoinCells(
  const char* what, vtkCellArray* (*cellsOf)(vtkPolyData*), void (*set)(vtkPolyData*, vtkCellArray*))
{
  Times times = this->Places.first;
  vtkIdType count = 0;
  for (const Block& block : this->Blocks)
  {
    times.push_back(cellsOf(block.Data)->GetMTime());
    count += cellsOf(block.Data)->GetNumberOfCells();
  }
  auto& [known, joined] = this->Cells[what];
  if (!joined || known != times)
  {
    known = std::move(times);
    joined = vtkSmartPointer<vtkCellArray>::New();
    for (const Block& block : this->Blocks)
    {
      joined->Append(cellsOf(block.Data), block.FirstPoint);
    }
  }
  if (count > 0)
  {
    set(this->PolyData, joined);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedBlocks::JoinArrays(bool cells)
{
  const auto countOf = [cells](vtkPolyData* data)
  { return cells ? data->GetNumberOfCells() : data->GetNumberOfPoints(); };
  std::vector<const Block*> blocks; // an empty one lacks nothing
  std::vector<vtkDataSetAttributes*> sets;
  for (const Block& block : this->Blocks)
  {
    if (countOf(block.Data) > 0)
    {
      blocks.push_back(&block);
      sets.push_back(AttributesOf(block.Data, cells));
    }
  }
  if (blocks.empty())
  {
    return;
  }
  vtkDataSetAttributes* out = AttributesOf(this->PolyData, cells);
  const auto keep = [&](const std::string& name, Times times, const auto& make)
  {
    const std::pair<bool, std::string> key(cells, name);
    const auto known = this->Arrays.find(key);
    const bool same = known != this->Arrays.end() && known->second.first == times;
    auto& used = this->UsedArrays[key];
    used = { std::move(times), same ? known->second.second : make() };
    out->AddArray(used.second);
  };
  const vtkIdType count = countOf(this->PolyData);
  for (const auto& [name, alike] : FindArrays(sets))
  {
    Times times;
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      times.push_back(alike[i] ? alike[i]->GetMTime() : 0);
      times.push_back(static_cast<vtkMTimeType>(countOf(blocks[i]->Data)));
    }
    keep(name, std::move(times),
      [&, &alike = alike]
      {
        vtkSmartPointer<vtkDataArray> joined = NewArray(alike, count);
        rtglyphs::RayTracedRanges missing;
        for (std::size_t i = 0; i < blocks.size(); ++i)
        {
          const vtkIdType first = cells ? blocks[i]->FirstCell : blocks[i]->FirstPoint;
          const vtkIdType tuples = countOf(blocks[i]->Data);
          if (alike[i])
          {
            joined->InsertTuples(first, tuples, 0, alike[i]);
          }
          else
          {
            missing.push_back({ first, first + tuples, blocks[i]->Name });
          }
        }
        if (!missing.empty())
        {
          Ranges::Set(joined->GetInformation(), std::move(missing));
        }
        return joined;
      });
  }
  if (!cells)
  {
    Times times;
    for (const Block& block : this->Blocks)
    {
      times.push_back(block.FlatIndex);
      times.push_back(static_cast<vtkMTimeType>(block.FirstPoint));
    }
    times.push_back(static_cast<vtkMTimeType>(count));
    keep(rtglyphs::RayTracedArrays::CompositeIndex, std::move(times), [&] { return Numbers(this->Blocks, count); });
  }
}
