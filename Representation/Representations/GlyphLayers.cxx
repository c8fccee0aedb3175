#include "GlyphLayers.h"

#include "RayTracedParts.h"

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::Layer::Follow(
  const rtglyphs::RayTracedBlocks& blocks, vtkActor* main, const std::array<double, 3>& selectionColor)
{
  this->Mapper->SetSelectionColor(selectionColor);
  this->Mapper->SetBlocks(blocks);
  rtglyphs::RayTracedParts::Copy(main, this->Actor);
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::Resize(std::size_t size, const Part& add, const Part& remove)
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
void rtglyphs::GlyphLayers::SetVisibility(bool visible)
{
  for (const auto& layer : this->Layers)
  {
    layer->Actor->SetVisibility(visible);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::SetAside(bool aside)
{
  for (const auto& layer : this->Layers)
  {
    layer->Mapper->SetAside(aside);
  }
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphLayers::SetKnownBounds(const double bounds[6])
{
  for (const auto& layer : this->Layers)
  {
    layer->Mapper->SetKnownBounds(bounds);
  }
}
