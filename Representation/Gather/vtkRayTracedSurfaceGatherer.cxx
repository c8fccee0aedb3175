#include "vtkRayTracedSurfaceGatherer.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkGlyphPointGatherer.h"
#include "vtkHyperTreeGrid.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVTrivialProducer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRayTracedArrays.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace
{
using Settings = vtkRayTracedSurfaceGatherer::Settings;

// The outer faces of one data set.
vtkSmartPointer<vtkPolyData> FacesOf(vtkDataObject* data, const Settings& settings)
{
  vtkNew<vtkPVTrivialProducer> producer;
  vtkNew<vtkHyperTreeGrid> numbered;
  if (auto* grid = vtkHyperTreeGrid::SafeDownCast(data))
  {
    numbered->ShallowCopy(grid);
    vtkGlyphPointGatherer::NumberCells(numbered);
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
  faces->SetNonlinearSubdivisionLevel(1);
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

struct Kind
{
  std::size_t Blocks = 0;
  int Type = 0, Components = 0;
  bool SameType = true;
};

// Only arrays that all blocks have, of one type, survive appending: makes the numeric ones so. Normals are an attribute
// and told apart by that, not by their name.
void CompleteArrays(const std::vector<vtkSmartPointer<vtkPolyData>>& blocks, bool cells)
{
  const auto attributesOf = [cells](vtkPolyData* block)
  {
    return cells ? static_cast<vtkDataSetAttributes*>(block->GetCellData())
                 : static_cast<vtkDataSetAttributes*>(block->GetPointData());
  };
  std::map<std::string, Kind> kinds;
  for (const auto& block : blocks)
  {
    vtkDataSetAttributes* attributes = attributesOf(block);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && array != attributes->GetNormals())
      {
        Kind& kind = kinds[array->GetName()];
        if (kind.Blocks == 0)
        {
          kind.Type = array->GetDataType();
          kind.Components = array->GetNumberOfComponents();
        }
        // Arrays of one name and different lengths of tuple are different things: the first kind wins.
        kind.Blocks += kind.Components == array->GetNumberOfComponents() ? 1 : 0;
        kind.SameType &= kind.Type == array->GetDataType();
      }
    }
  }
  for (const auto& item : kinds)
  {
    const Kind& kind = item.second;
    if (kind.Blocks == blocks.size() && kind.SameType)
    {
      continue;
    }
    for (const auto& block : blocks)
    {
      vtkDataSetAttributes* attributes = attributesOf(block);
      vtkDataArray* old = attributes->GetArray(item.first.c_str());
      // A hole becomes NaN, which colour maps know; integer types have none.
      vtkNew<vtkDoubleArray> array;
      if (old && old->GetNumberOfComponents() == kind.Components)
      {
        array->DeepCopy(old);
      }
      else
      {
        array->SetNumberOfComponents(kind.Components);
        array->SetNumberOfTuples(cells ? block->GetNumberOfCells() : block->GetNumberOfPoints());
        array->Fill(vtkMath::Nan());
      }
      array->SetName(item.first.c_str());
      attributes->AddArray(array);
    }
  }
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData>
vtkRayTracedSurfaceGatherer::Triangulate(vtkPolyData* polygons, const Settings& settings)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(polygons);
  triangles->Update();
  vtkSmartPointer<vtkPolyData> surface = triangles->GetOutput();
  if (settings.ComputesNormals && !surface->GetPointData()->GetNormals() &&
    surface->GetNumberOfPolys() > 0)
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
vtkSmartPointer<vtkPolyData>
vtkRayTracedSurfaceGatherer::Gather(vtkDataObject* input, const Settings& settings)
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
    vtkSmartPointer<vtkPolyData> surface = Triangulate(faces, settings);
    RenameIds(surface);
    if (isBlock)
    {
      AddIndex(surface, vtkRayTracedArrays::CompositeIndex, flatIndex);
      AddIndex(surface, vtkRayTracedArrays::BlockColors, block % vtkRayTracedArrays::DistinctBlockColors);
    }
    if (settings.Processes > 1)
    {
      AddIndex(surface, vtkRayTracedArrays::ProcessId,
        static_cast<unsigned int>(settings.Process));
    }
    blocks.push_back(surface);
  };

  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (composite)
  {
    vtkSmartPointer<vtkCompositeDataIterator> iterator;
    iterator.TakeReference(composite->NewIterator());
    iterator->SkipEmptyNodesOff(); // an empty block has a number, too
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem(), ++block)
    {
      if (vtkDataObject* data = iterator->GetCurrentDataObject())
      {
        add(data, true, iterator->GetCurrentFlatIndex());
      }
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
