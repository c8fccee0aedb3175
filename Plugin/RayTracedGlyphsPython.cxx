#include "RayTracedGlyphsPython.h"

#include "raytracedglyphsSource.h"

#include <vtkNew.h>
#include <vtkPVPythonModule.h>

//----------------------------------------------------------------------------
void RegisterRayTracedGlyphsPython()
{
  vtkNew<vtkPVPythonModule> module;
  module->SetFullName("raytracedglyphs");
  module->SetSource(raytracedglyphsSource);
  module->SetIsPackage(0);
  vtkPVPythonModule::RegisterModule(module);
}
