#include "GlyphMeshes.h"

#include "Glyphs.h"
#include "RayTracedSurfaceGatherer.h"
#include "RayTracedTree.h"
#include "vtkAppendPolyData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
// The polygons of a data set, or of all blocks of composite data. 3D Glyphs shade meshes by the normals they have, and
// compute none.
vtkSmartPointer<vtkPolyData> PolygonsOf(vtkDataObject* data)
{
  rtglyphs::RayTracedSurfaceGatherer::Settings settings;
  settings.ComputesNormals = false;
  vtkNew<vtkAppendPolyData> append;
  const vtkSmartPointer<vtkDataObject> surfaces = rtglyphs::RayTracedTree::Make(data, /*distinctColors=*/1,
    [&settings](vtkDataObject* leaf) { return rtglyphs::RayTracedSurfaceGatherer::Gather(leaf, settings); });
  for (vtkPolyData* polygons : vtkCompositeDataSet::GetDataSets<vtkPolyData>(surfaces))
  {
    if (polygons->GetNumberOfPolys() > 0)
    {
      append->AddInputData(polygons);
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
  }
  return append->GetOutput();
}
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMeshes::Gather(vtkDataObject* data, bool blocksAreMeshes)
{
  auto* blocks = vtkDataObjectTree::SafeDownCast(data);
  if (blocksAreMeshes && blocks)
  {
    vtkNew<vtkMultiBlockDataSet> table;
    for (vtkDataObject* block : vtk::Range(blocks, vtk::DataObjectTreeOptions::None))
    {
      table->SetBlock(table->GetNumberOfBlocks(), PolygonsOf(block));
    }
    this->Piece->SetBlock(0, table);
  }
  else
  {
    this->Piece->SetBlock(0, PolygonsOf(data));
  }
  this->Piece->Modified();
  this->SetDelivered(this->Piece);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphMeshes::SetDelivered(vtkDataObject* piece)
{
  auto* outer = vtkMultiBlockDataSet::SafeDownCast(piece);
  vtkDataObject* inner = outer && outer->GetNumberOfBlocks() > 0 ? outer->GetBlock(0) : nullptr;
  this->Meshes.clear();
  if (auto* table = vtkMultiBlockDataSet::SafeDownCast(inner))
  {
    for (unsigned int i = 0; i < table->GetNumberOfBlocks(); ++i)
    {
      this->Meshes.emplace_back(vtkPolyData::SafeDownCast(table->GetBlock(i)));
    }
  }
  else
  {
    this->Meshes.emplace_back(vtkPolyData::SafeDownCast(inner));
  }
  std::vector<vtkMTimeType> times;
  for (vtkPolyData* mesh : this->Meshes)
  {
    times.push_back(mesh && mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0);
  }
  if (times == this->ExtentsTimes)
  {
    return; // the extents stay the same objects, too
  }
  this->ExtentsTimes = times;
  this->Extents.clear();
  for (vtkPolyData* mesh : this->Meshes)
  {
    auto corners = std::make_shared<rtg::TriangleMesh>();
    if (mesh && mesh->GetNumberOfPoints() > 0)
    {
      double b[6];
      mesh->GetBounds(b);
      corners->positions = { glm::vec3(b[0], b[2], b[4]), glm::vec3(b[1], b[3], b[5]) };
    }
    this->Extents.push_back(std::move(corners));
  }
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphMeshes::GetLargestSide() const
{
  double largest = 0.0;
  for (const auto& corners : this->Extents)
  {
    if (!corners->positions.empty())
    {
      const glm::vec3 sides = corners->positions.back() - corners->positions.front();
      largest = std::max<double>(largest, std::max({ sides.x, sides.y, sides.z }));
    }
  }
  return largest;
}
