#include "vtkRayTracedSelectionEncoder.h"

#include "RayTracedArrays.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
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
  const char* GetDescription() VTK_FUTURE_CONST override { return "RayTracedGlyphs: selection of glyphs"; }

protected:
  Factory()
  {
    this->RegisterOverride("vtkPVEncodeSelectionForServer", "vtkRayTracedSelectionEncoder", "selection of glyphs",
      /*enabled=*/1, []() -> vtkObject* { return vtkRayTracedSelectionEncoder::New(); });
  }
};
vtkStandardNewMacro(Factory);

// Moves ids of points out of a selection of cells, or the reverse, into another one; false: there are none.
bool MoveForeignIds(vtkSelectionNode* from, vtkSelectionNode* to)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(from->GetSelectionList());
  const bool cells = from->GetFieldType() == vtkSelectionNode::CELL;
  if ((!cells && from->GetFieldType() != vtkSelectionNode::POINT) || !ids)
  {
    return false;
  }
  vtkNew<vtkIdTypeArray> kept, moved;
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    (rtglyphs::RayTracedArrays::IsCellId(id) ? moved : kept)->InsertNextValue(rtglyphs::RayTracedArrays::InputId(id));
  }
  if (moved->GetNumberOfValues() == 0)
  {
    return false;
  }
  to->GetProperties()->Copy(from->GetProperties());
  to->SetFieldType(cells ? vtkSelectionNode::POINT : vtkSelectionNode::CELL);
  to->SetSelectionList(moved);
  from->SetSelectionList(kept);
  return true;
}
}

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
    vtkSelectionNode* node = rawSelection->GetNode(i);
    vtkNew<vtkSelectionNode> other;
    if (MoveForeignIds(node, other))
    {
      if (node->GetSelectionList()->GetNumberOfTuples() == 0)
      {
        rawSelection->RemoveNode(i);
      }
      rawSelection->AddNode(other);
    }
  }
  return this->Superclass::ProcessSelection(rawSelection, viewProxy, multipleSelectionsAllowed, selectedRepresentations,
    selectionSources, modifier, selectBlocks);
}
