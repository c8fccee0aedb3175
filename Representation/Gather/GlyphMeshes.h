/**
 * @class   GlyphMeshes
 * @brief   the meshes of mesh glyphs: gathered from the second input, as the view delivers them, and their sizes
 */
#ifndef GlyphMeshes_h
#define GlyphMeshes_h

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace rtg
{
struct TriangleMesh;
}

namespace rtglyphs
{
class GlyphMeshes
{
public:
  /**
   * Gathers the polygons of `data` (may be null) as one mesh, or each block of a composite as a mesh of its own.
   */
  void Gather(vtkDataObject* data, bool blocksAreMeshes);

  /**
   * The gathered meshes, for the view. In a composite, because data of several ranks that are put together do not stay
   * apart otherwise.
   */
  vtkDataObject* GetPiece() const { return this->Piece; }

  /**
   * The meshes are those of a piece that the view has delivered (may be null), until the next Gather().
   */
  void SetDelivered(vtkDataObject* piece);

  /**
   * Number of meshes, and mesh i; null: there is none.
   */
  std::size_t GetNumberOfMeshes() const { return this->Meshes.size(); }
  vtkPolyData* GetMesh(std::size_t i) const { return i < this->Meshes.size() ? this->Meshes[i].Get() : nullptr; }

  /**
   * Two opposite corners of each mesh's box, as a mesh for GlyphBounds; without points where there is no mesh.
   */
  const std::vector<std::shared_ptr<const rtg::TriangleMesh>>& GetExtents() const { return this->Extents; }

  /**
   * The longest side of the meshes' boxes; 0 without any.
   */
  double GetLargestSide() const;

private:
  vtkNew<vtkMultiBlockDataSet> Piece; // its only block is the mesh, or a composite of them
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;
  std::vector<std::shared_ptr<const rtg::TriangleMesh>> Extents;
  std::vector<vtkMTimeType> ExtentsTimes;
};

} // namespace rtglyphs

#endif
