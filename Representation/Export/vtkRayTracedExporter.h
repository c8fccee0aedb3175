/**
 * @class   vtkRayTracedExporter
 * @brief   writes what a window shows as Ray Traced Glyphs: meshes and the places of their copies
 *
 * The extension of the file name chooses the format: .usda (Universal Scene Description), .gltf with a .bin beside it,
 * or .glb (glTF 2.0 with EXT_mesh_gpu_instancing). The window has been rendered before. ParaView does that, with the
 * data brought to the process that exports.
 *
 * Surfaces are left out: ParaView's own exporters write them.
 */
#ifndef vtkRayTracedExporter_h
#define vtkRayTracedExporter_h

#include "vtkExporter.h"
#include "vtkRayTracedGlyphsModule.h" // for export macro

#include <string>

class VTKRAYTRACEDGLYPHS_EXPORT vtkRayTracedExporter : public vtkExporter
{
public:
  static vtkRayTracedExporter* New();
  vtkTypeMacro(vtkRayTracedExporter, vtkExporter);

  ///@{
  /**
   * The path of the file.
   */
  void SetFileName(const char* name) { this->FileName = name ? name : ""; }
  const char* GetFileName() const { return this->FileName.c_str(); }
  ///@}

protected:
  vtkRayTracedExporter() = default;
  ~vtkRayTracedExporter() override = default;

  void WriteData() override;

private:
  std::string FileName;
};

#endif
