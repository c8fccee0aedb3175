#include "vtkGlyphLayers.h"

#include "vtkGlyphBlockAttributes.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"

//----------------------------------------------------------------------------
void vtkGlyphLayers::Layer::Follow(vtkPolyData* points, vtkRayTracedActor* main, const vtkGlyphBlockAttributes& blocks,
  const std::array<double, 3>& selectionColor)
{
  this->Mapper->SetSelectionColor(selectionColor);
  this->Mapper->SetPoints(points);
  this->Mapper->SetBlocks(blocks);
  this->Actor->GetProperty()->DeepCopy(main->GetProperty());
  vtkNew<vtkMatrix4x4> matrix;
  main->GetMatrix(matrix);
  this->Actor->SetUserMatrix(matrix);
  this->Actor->SetPickable(main->GetPickable());
  this->Actor->SetVisibility(main->GetVisibility());
}

//----------------------------------------------------------------------------
void vtkGlyphLayers::Layer::FollowColors(vtkRayTracedMapper* main)
{
  this->Mapper->SetScalarVisibility(main->GetScalarVisibility());
  this->Mapper->SelectColorArray(main->GetArrayName());
  this->Mapper->SetUseLookupTableScalarRange(main->GetUseLookupTableScalarRange());
  this->Mapper->SetScalarMode(main->GetScalarMode());
  this->Mapper->SetColorMode(main->GetColorMode());
  // Asked for its table, a mapper without one makes one.
  if (main->GetScalarVisibility())
  {
    this->Mapper->SetLookupTable(main->GetLookupTable());
  }
}

//----------------------------------------------------------------------------
void vtkGlyphLayers::Resize(std::size_t size, const Part& add, const Part& remove)
{
  while (this->Layers.size() > size)
  {
    remove(this->Layers.back()->Actor, this->Layers.back()->Mapper);
    this->Layers.pop_back();
  }
  while (this->Layers.size() < size)
  {
    this->Layers.push_back(std::make_unique<Layer>());
    add(this->Layers.back()->Actor, this->Layers.back()->Mapper);
  }
}

//----------------------------------------------------------------------------
void vtkGlyphLayers::SetVisibility(bool visible)
{
  for (const auto& layer : this->Layers)
  {
    layer->Actor->SetVisibility(visible);
  }
}

//----------------------------------------------------------------------------
void vtkGlyphLayers::SetKnownBounds(const double bounds[6])
{
  for (const auto& layer : this->Layers)
  {
    layer->Mapper->SetKnownBounds(bounds);
  }
}
