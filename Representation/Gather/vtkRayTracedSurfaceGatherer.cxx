#include "vtkRayTracedSurfaceGatherer.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDataSetRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkGlyphLeaves.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkHyperTreeGrid.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVTrivialProducer.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRayTracedArrayUnion.h"
#include "vtkRayTracedArrays.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
using Settings = vtkRayTracedSurfaceGatherer::Settings;

// The outer faces of one data set.
vtkSmartPointer<vtkPolyData> FacesOf(vtkDataObject* data, const Settings& settings)
{
  vtkNew<vtkPVTrivialProducer> producer;
  vtkSmartPointer<vtkHyperTreeGrid> numbered;
  if (auto* grid = vtkHyperTreeGrid::SafeDownCast(data))
  {
    numbered = vtkGlyphLeaves::Number(grid);
    data = numbered;
  }
  producer->SetOutput(data);
  if (settings.WholeExtent)
  {
    int extent[6];
    std::copy_n(settings.WholeExtent, 6, extent);
    producer->SetWholeExtent(extent);
  }
  vtkNew<vtkPVGeometryFilter> faces;
  // Processes may have different numbers of blocks: none waits for another here.
  faces->SetController(nullptr);
  faces->SetGenerateProcessIds(false);
  faces->SetUseOutline(0);
  faces->SetNonlinearSubdivisionLevel(settings.NonlinearSubdivisionLevel);
  faces->SetPassThroughCellIds(1);
  faces->SetPassThroughPointIds(1);
  faces->SetInputConnection(producer->GetOutputPort());
  faces->Update();
  return vtkPolyData::SafeDownCast(faces->GetOutputDataObject(0));
}

void AddIndex(vtkPolyData* surface, const char* name, unsigned int value)
{
  vtkNew<vtkUnsignedIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->FillValue(value);
  surface->GetPointData()->AddArray(array);
}

// The ids that ParaView's filter leaves under names that an input may have, too.
void RenameIds(vtkPolyData* surface)
{
  const auto rename = [](vtkDataSetAttributes* data, const char* from, const char* to)
  {
    if (vtkDataArray* array = data->GetArray(from))
    {
      vtkSmartPointer<vtkDataArray> renamed = vtk::TakeSmartPointer(array->NewInstance());
      renamed->ShallowCopy(array);
      renamed->SetName(to);
      data->RemoveArray(from);
      data->AddArray(renamed);
    }
  };
  rename(surface->GetPointData(), "vtkOriginalPointIds", vtkRayTracedArrays::PointIds);
  if (!surface->GetCellData()->GetArray(vtkRayTracedArrays::CellIds))
  {
    rename(surface->GetCellData(), "vtkOriginalCellIds", vtkRayTracedArrays::CellIds);
  }
}

// Only arrays that all blocks have, of one type, survive appending: makes them so. Normals are an attribute and told
// apart by that, not by their name.
void CompleteArrays(const std::vector<vtkSmartPointer<vtkPolyData>>& blocks, bool cells)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (const auto& block : blocks)
  {
    sets.push_back(cells ? static_cast<vtkDataSetAttributes*>(block->GetCellData()) : block->GetPointData());
  }
  const vtkRayTracedArrayUnion all(
    sets, [](vtkDataSetAttributes* set, vtkAbstractArray* array) { return array != set->GetNormals(); });
  // Added at the end: until then the union speaks of the blocks' own arrays.
  std::vector<std::pair<vtkDataSetAttributes*, vtkSmartPointer<vtkAbstractArray>>> completed;
  for (const auto& [name, item] : all.Items())
  {
    if (all.IsExact(item))
    {
      continue;
    }
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      const vtkIdType tuples = cells ? blocks[i]->GetNumberOfCells() : blocks[i]->GetNumberOfPoints();
      const vtkSmartPointer<vtkAbstractArray> array = item.Make(tuples, /*exact=*/false);
      if (vtkAbstractArray* old = item.Of(sets[i]))
      {
        array->DeepCopy(old);
        array->SetName(name.c_str());
      }
      else
      {
        vtkRayTracedArrayUnion::Holes::Fill(array, 0, tuples);
      }
      completed.emplace_back(sets[i], array);
    }
  }
  for (const auto& [set, array] : completed)
  {
    set->AddArray(array);
  }
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSurfaceGatherer::Triangulate(vtkPolyData* polygons, const Settings& settings)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(polygons);
  triangles->Update();
  vtkSmartPointer<vtkPolyData> surface = triangles->GetOutput();
  if (settings.ComputesNormals && !surface->GetPointData()->GetNormals() && surface->GetNumberOfPolys() > 0)
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetFeatureAngle(settings.FeatureAngle);
    normals->SetInputData(surface);
    normals->Update();
    surface = normals->GetOutput();
  }
  return surface;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSurfaceGatherer::ExtractLines(vtkPolyData* data)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  if (data->GetNumberOfCells() == data->GetNumberOfLines() || data->GetNumberOfLines() == 0)
  {
    lines->SetPoints(data->GetPoints());
    lines->SetLines(data->GetLines());
    lines->GetPointData()->ShallowCopy(data->GetPointData());
    if (data->GetNumberOfLines() > 0)
    {
      lines->GetCellData()->ShallowCopy(data->GetCellData());
    }
    return lines;
  }
  // Only the points of lines: others would count for the bounds.
  std::vector<vtkIdType> place(data->GetNumberOfPoints(), -1);
  vtkNew<vtkIdList> kept, cells, corners;
  vtkNew<vtkCellArray> cut;
  vtkIdType cell = data->GetNumberOfVerts();
  auto iterator = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell)
  {
    iterator->GetCurrentCell(corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      vtkIdType& at = place[corners->GetId(i)];
      at = at < 0 ? kept->InsertNextId(corners->GetId(i)) : at;
      corners->SetId(i, at);
    }
    cut->InsertNextCell(corners);
    cells->InsertNextId(cell);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(data->GetPoints()->GetDataType());
  data->GetPoints()->GetPoints(kept, points);
  lines->SetPoints(points);
  lines->SetLines(cut);
  lines->GetPointData()->CopyAllOn();
  lines->GetPointData()->CopyAllocate(data->GetPointData(), kept->GetNumberOfIds());
  lines->GetCellData()->CopyAllOn();
  lines->GetCellData()->CopyAllocate(data->GetCellData(), cells->GetNumberOfIds());
  for (vtkIdType i = 0; i < kept->GetNumberOfIds(); ++i)
  {
    lines->GetPointData()->CopyData(data->GetPointData(), kept->GetId(i), i);
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
  {
    lines->GetCellData()->CopyData(data->GetCellData(), cells->GetId(i), i);
  }
  return lines;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRayTracedSurfaceGatherer::Gather(vtkDataObject* input, const Settings& settings)
{
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  unsigned int block = 0;
  const auto add = [&](vtkDataObject* data, bool isBlock, unsigned int flatIndex)
  {
    vtkSmartPointer<vtkPolyData> faces = FacesOf(data, settings);
    if (!faces || faces->GetNumberOfPoints() == 0)
    {
      return;
    }
    vtkSmartPointer<vtkPolyData> surface = settings.Lines ? ExtractLines(faces) : Triangulate(faces, settings);
    RenameIds(surface);
    if (isBlock)
    {
      AddIndex(surface, vtkRayTracedArrays::CompositeIndex, flatIndex);
      AddIndex(surface, vtkRayTracedArrays::BlockColors, block % vtkRayTracedArrays::DistinctBlockColors);
    }
    if (settings.Processes > 1)
    {
      AddIndex(surface, vtkRayTracedArrays::ProcessId, static_cast<unsigned int>(settings.Process));
    }
    blocks.push_back(surface);
  };

  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (composite)
  {
    for (auto node : vtk::Range(composite)) // an empty block has a number, too
    {
      if (node.GetDataObject())
      {
        add(node.GetDataObject(), true, node.GetFlatIndex());
      }
      ++block;
    }
  }
  else if (input)
  {
    add(input, false, 0);
  }

  auto surface = vtkSmartPointer<vtkPolyData>::New();
  if (blocks.size() == 1)
  {
    surface->ShallowCopy(blocks.front());
  }
  else if (!blocks.empty())
  {
    CompleteArrays(blocks, /*cells=*/false);
    CompleteArrays(blocks, /*cells=*/true);
    vtkNew<vtkAppendPolyData> append;
    for (const auto& block : blocks)
    {
      append->AddInputData(block);
    }
    append->Update();
    surface->ShallowCopy(append->GetOutput());
  }
  if (composite)
  {
    vtkGlyphPointGatherer::AddHierarchy(composite, surface);
  }
  return surface;
}
