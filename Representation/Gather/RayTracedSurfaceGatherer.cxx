#include "RayTracedSurfaceGatherer.h"

#include "GlyphLeaves.h"
#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVTrivialProducer.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <vector>

namespace
{
using Settings = rtglyphs::RayTracedSurfaceGatherer::Settings;

// The outer faces of one data set.
vtkSmartPointer<vtkPolyData> FacesOf(vtkDataObject* data, const Settings& settings)
{
  vtkNew<vtkPVTrivialProducer> producer;
  vtkSmartPointer<vtkHyperTreeGrid> numbered;
  if (auto* grid = vtkHyperTreeGrid::SafeDownCast(data))
  {
    numbered = rtglyphs::GlyphLeaves::Number(grid);
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

// Without a copy of the values.
void AddAs(vtkDataSetAttributes* data, vtkDataArray* array, const char* name)
{
  vtkSmartPointer<vtkDataArray> named = vtk::TakeSmartPointer(array->NewInstance());
  named->ShallowCopy(array);
  named->SetName(name);
  data->AddArray(named);
}

void Rename(vtkDataSetAttributes* data, const char* from, const char* to)
{
  if (vtkDataArray* array = data->GetArray(from))
  {
    AddAs(data, array, to);
    data->RemoveArray(from);
  }
}

// The ids that ParaView's filter leaves under names that an input may have, too.
void RenameIds(vtkPolyData* surface)
{
  Rename(surface->GetPointData(), "vtkOriginalPointIds", rtglyphs::RayTracedArrays::PointIds);
  if (!surface->GetCellData()->GetArray(rtglyphs::RayTracedArrays::CellIds))
  {
    Rename(surface->GetCellData(), "vtkOriginalCellIds", rtglyphs::RayTracedArrays::CellIds);
  }
}

// Triangles with their points and arrays.
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* polygons, bool computesNormals)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(polygons);
  triangles->Update();
  vtkSmartPointer<vtkPolyData> surface = triangles->GetOutput();
  if (vtkDataArray* normals = surface->GetPointData()->GetNormals())
  {
    AddAs(surface->GetPointData(), normals, rtglyphs::RayTracedArrays::Normals);
  }
  else if (computesNormals && surface->GetNumberOfPolys() > 0)
  {
    // VTK's filter takes this name for its own.
    constexpr const char* taken = "Normals";
    constexpr const char* kept = "vtkRayTraced_Kept";
    Rename(surface->GetPointData(), taken, kept);
    vtkNew<vtkPolyDataNormals> filter;
    filter->SetFeatureAngle(30.0);
    filter->SetInputData(surface);
    filter->Update();
    surface = filter->GetOutput();
    Rename(surface->GetPointData(), taken, rtglyphs::RayTracedArrays::Normals);
    Rename(surface->GetPointData(), kept, taken);
  }
  return surface;
}

// Lines with their points and arrays.
vtkSmartPointer<vtkPolyData> ExtractLines(vtkPolyData* data)
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
  lines->GetPointData()->CopyData(data->GetPointData(), kept);
  lines->GetCellData()->CopyData(data->GetCellData(), cells);
  return lines;
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> rtglyphs::RayTracedSurfaceGatherer::Gather(vtkDataObject* data, const Settings& settings)
{
  vtkSmartPointer<vtkPolyData> faces = data ? FacesOf(data, settings) : nullptr;
  if (!faces || faces->GetNumberOfPoints() == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkSmartPointer<vtkPolyData> surface =
    settings.Lines ? ExtractLines(faces) : Triangulate(faces, settings.ComputesNormals);
  RenameIds(surface);
  surface->GetFieldData()->PassData(data->GetFieldData());
  if (rtglyphs::RayTracedRanks::Count() > 1)
  {
    vtkNew<vtkUnsignedIntArray> ranks;
    ranks->SetName(rtglyphs::RayTracedArrays::ProcessId);
    rtglyphs::RayTracedArrays::Resize(ranks, surface->GetNumberOfPoints());
    ranks->FillValue(static_cast<unsigned int>(rtglyphs::RayTracedRanks::Own()));
    surface->GetPointData()->AddArray(ranks);
  }
  return surface;
}
