/**
 * Glyphs as glTF 2.0 with the extension EXT_mesh_gpu_instancing: a mesh and the copies of it for each part of a
 * display's glyphs. Colors of copies are the attribute _COLOR_0.
 */
#ifndef vtkGlyphGLTFWriter_h
#define vtkGlyphGLTFWriter_h

#include "vtkGlyphExportSet.h"

namespace vtkGlyphGLTFWriter
{
struct File
{
  std::string Text;   // JSON
  std::string Binary; // its buffer
};

/// `binaryName`: where the buffer will lie, relative to the JSON; empty: in the same file (.glb).
File Make(const std::vector<vtkGlyphExportSet>& sets, const std::string& binaryName);

/// Both in one (.glb).
std::string Together(const File& file);
}

#endif
// VTK-HeaderTest-Exclude: vtkGlyphGLTFWriter.h
