#include "SurfaceContent.h"

#include "RayTracedSurfaceGatherer.h"

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> rtglyphs::SurfaceContent::Gather(
  vtkDataObject* data, const int* wholeExtent, bool, const rtglyphs::RayTracedParallel::Progress&) const
{
  rtglyphs::RayTracedSurfaceGatherer::Settings settings;
  settings.WholeExtent = wholeExtent;
  settings.ComputesNormals = this->Smooth;
  settings.NonlinearSubdivisionLevel = this->NonlinearSubdivisionLevel;
  return rtglyphs::RayTracedSurfaceGatherer::Gather(data, settings);
}

//----------------------------------------------------------------------------
// Glyphs without size at the surface's points.
rtglyphs::GlyphSettings rtglyphs::SurfaceContent::GetSizes(vtkPolyData*, double&)
{
  rtglyphs::GlyphSettings settings;
  settings.ScaleFactor = 0.0;
  settings.Motion = this->Common.Time.GetMotionOfPoints();
  return settings;
}

//----------------------------------------------------------------------------
void rtglyphs::SurfaceContent::Configure(const Frame&)
{
  auto* surface = static_cast<vtkRayTracedSurfaceMapper*>(this->Common.Parts.Mapper.Get());
  surface->SetSettings({ this->Smooth, this->Common.Time.GetMotionOfPoints() });
}
