#include "GlyphLayers.h"

#include "RayTracedParts.h"

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::Layer::Update(
  const rtglyphs::RayTracedBlocks& blocks, vtkActor* main, const std::array<double, 3>& selectionColor)
{
  this->Mapper->SetSelectionColor(selectionColor);
  this->Mapper->SetBlocks(blocks);
  rtglyphs::RayTracedParts::Copy(main, this->Actor);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::Resize(
  std::size_t size, rtglyphs::RayTracedParts& parts, vtkPVDataRepresentation* owner, vtkPVRenderView* view)
{
  while (this->Layers.size() > size)
  {
    parts.Remove(owner, view, this->Layers.back()->Actor, this->Layers.back()->Mapper);
    this->Layers.pop_back();
  }
  while (this->Layers.size() < size)
  {
    this->Layers.push_back(std::make_unique<Layer>());
    parts.Add(owner, view, this->Layers.back()->Actor, this->Layers.back()->Mapper);
  }
}
