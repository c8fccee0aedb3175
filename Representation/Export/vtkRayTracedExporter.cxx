#include "vtkRayTracedExporter.h"

#include "GlyphGLTFWriter.h"
#include "GlyphTessellatedSet.h"
#include "GlyphUSDWriter.h"
#include "vtkCollectionRange.h"
#include "vtkObjectFactory.h"
#include "vtkRayTracedScene.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <vtksys/SystemTools.hxx>

#include <fstream>
#include <vector>

vtkStandardNewMacro(vtkRayTracedExporter);

namespace
{
bool WriteFile(const std::string& name, const std::string& text)
{
  std::ofstream file(name, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  return !file.fail();
}
}

//----------------------------------------------------------------------------
void vtkRayTracedExporter::WriteData()
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(this->FileName));
  if (extension != ".usda" && extension != ".gltf" && extension != ".glb")
  {
    vtkErrorMacro(<< "The glyphs are not exported: '" << this->FileName << "' ends neither in .usda nor in .gltf or "
                  << ".glb. Choose one of these.");
    return;
  }

  std::vector<rtglyphs::GlyphTessellatedSet> sets;
  std::vector<std::string> messages;
  bool surfaces = false;
  for (vtkRenderer* renderer : vtk::Range(this->RenderWindow->GetRenderers()))
  {
    if (vtkRayTracedScene* scene = vtkRayTracedScene::Find(renderer))
    {
      scene->ForEachShown(
        [&](const rtg::GlyphInstances& instances, const rtg::GlyphColors& colors, const rtg::Material& material)
        {
          surfaces |= instances.identifyTriangles;
          auto set = instances.identifyTriangles
            ? rtglyphs::GlyphTessellatedSet()
            : rtglyphs::GlyphTessellatedSet::Make(std::to_string(sets.size()), instances, colors, material, messages);
          if (!set.Parts.empty())
          {
            sets.push_back(std::move(set));
          }
        });
    }
  }
  if (surfaces)
  {
    messages.push_back("Ray-traced surfaces are left out of the exported file. Show them as Surface, and export them "
                       "with one of ParaView's exporters.");
  }
  for (const std::string& message : messages)
  {
    vtkWarningMacro(<< message << (sets.empty() ? " No file is written, because nothing is left." : ""));
  }
  if (sets.empty() && messages.empty())
  {
    vtkErrorMacro(
      << "There is nothing to export to '" << this->FileName
      << "': the view shows no glyphs as Ray Traced Glyphs. Choose that as the Representation of a display.");
  }
  if (sets.empty())
  {
    return;
  }

  bool written = true;
  if (extension == ".usda")
  {
    written = WriteFile(this->FileName, rtglyphs::GlyphUSDWriter::Text(sets));
  }
  else if (extension == ".glb")
  {
    const rtglyphs::GlyphGLTFWriter::File file = rtglyphs::GlyphGLTFWriter::Make(sets, "");
    const std::uint64_t length = rtglyphs::GlyphGLTFWriter::LengthTogether(file.Text.size(), file.Binary.size());
    if (length > rtglyphs::GlyphGLTFWriter::MostTogether)
    {
      vtkErrorMacro(<< "The glyphs are not exported: '" << this->FileName << "' would have " << length
                    << " bytes, and a .glb file has at most " << rtglyphs::GlyphGLTFWriter::MostTogether
                    << ". Choose .gltf, which puts the numbers into a .bin file beside it, or .usda.");
      return;
    }
    written = WriteFile(this->FileName, rtglyphs::GlyphGLTFWriter::Together(file));
  }
  else
  {
    const std::string binary = vtksys::SystemTools::GetFilenameWithoutLastExtension(this->FileName) + ".bin";
    const std::string folder = vtksys::SystemTools::GetFilenamePath(this->FileName);
    const rtglyphs::GlyphGLTFWriter::File file = rtglyphs::GlyphGLTFWriter::Make(sets, binary);
    written =
      WriteFile(this->FileName, file.Text) && WriteFile(folder.empty() ? binary : folder + "/" + binary, file.Binary);
  }
  if (!written)
  {
    vtkErrorMacro(<< "The glyphs could not be written to '" << this->FileName
                  << "'. Give the path of a file in a folder that exists and may be written to.");
  }
}
