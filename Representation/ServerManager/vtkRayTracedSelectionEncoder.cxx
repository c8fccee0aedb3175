#include "vtkRayTracedSelectionEncoder.h"

#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRayTracedArrays.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkVersion.h"

#ifndef VTK_FUTURE_CONST // VTK before 9.3
#define VTK_FUTURE_CONST
#endif

vtkStandardNewMacro(vtkRayTracedSelectionEncoder);

namespace
{
class Factory : public vtkObjectFactory
{
public:
  static Factory* New();
  vtkTypeMacro(Factory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override
  {
    return "RayTracedGlyphs: selection of points without cells";
  }

protected:
  Factory()
  {
    this->RegisterOverride("vtkPVEncodeSelectionForServer", "vtkRayTracedSelectionEncoder",
      "selection of points without cells", /*enabled=*/1,
      []() -> vtkObject* { return vtkRayTracedSelectionEncoder::New(); });
  }
};
vtkStandardNewMacro(Factory);

// Moves the marked points of a selection of cells to `points`; false: there were none.
bool TakePoints(vtkSelectionNode* cells, vtkSelectionNode* points)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(cells->GetSelectionList());
  if (cells->GetFieldType() != vtkSelectionNode::CELL || !ids)
  {
    return false;
  }
  vtkNew<vtkIdTypeArray> cellIds, pointIds;
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    const bool marked = vtkRayTracedArrays::IsMarkedPoint(id);
    (marked ? pointIds : cellIds)->InsertNextValue(marked ? vtkRayTracedArrays::UnmarkedPoint(id) : id);
  }
  if (pointIds->GetNumberOfValues() == 0)
  {
    return false;
  }
  points->GetProperties()->Copy(cells->GetProperties());
  points->SetFieldType(vtkSelectionNode::POINT);
  points->SetSelectionList(pointIds);
  cells->SetSelectionList(cellIds);
  return true;
}
}

//----------------------------------------------------------------------------
vtkRayTracedSelectionEncoder::vtkRayTracedSelectionEncoder() = default;

//----------------------------------------------------------------------------
vtkRayTracedSelectionEncoder::~vtkRayTracedSelectionEncoder() = default;

//----------------------------------------------------------------------------
void vtkRayTracedSelectionEncoder::Register()
{
  static bool registered = false;
  if (!registered)
  {
    registered = true;
    vtkNew<Factory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
}

//----------------------------------------------------------------------------
bool vtkRayTracedSelectionEncoder::ProcessSelection(vtkSelection* rawSelection, vtkSMRenderViewProxy* viewProxy,
  bool multipleSelectionsAllowed, vtkCollection* selectedRepresentations, vtkCollection* selectionSources, int modifier,
  bool selectBlocks)
{
  for (unsigned int i = rawSelection->GetNumberOfNodes(); i-- > 0;)
  {
    vtkSelectionNode* cells = rawSelection->GetNode(i);
    vtkNew<vtkSelectionNode> points;
    if (TakePoints(cells, points))
    {
      if (cells->GetSelectionList()->GetNumberOfTuples() == 0)
      {
        rawSelection->RemoveNode(i);
      }
      rawSelection->AddNode(points);
    }
  }
  return this->Superclass::ProcessSelection(rawSelection, viewProxy, multipleSelectionsAllowed, selectedRepresentations,
    selectionSources, modifier, selectBlocks);
}
