/**
 * Glyphs as glTF 2.0 with the extension EXT_mesh_gpu_instancing: a mesh and the copies of it for each part of a
 * display's glyphs. Colors of copies are the attribute _COLOR_0.
 */
#ifndef GlyphGLTFWriter_h
#define GlyphGLTFWriter_h

#include "GlyphTessellatedSet.h"

namespace rtglyphs::GlyphGLTFWriter
{
struct File
{
  std::string Text;   // JSON
  std::string Binary; // its buffer
};

/// `binaryName`: where the buffer will lie, relative to the JSON; empty: in the same file (.glb).
File Make(const std::vector<GlyphTessellatedSet>& sets, const std::string& binaryName);

///@{
/// Both in one (.glb), and how many bytes that has: a header, and before each of two chunks, which are filled up to a
/// multiple of 4, another one. The format has 32 bits for this number.
std::string Together(const File& file);
constexpr std::uint64_t MostTogether = 0xFFFFFFFF;
constexpr std::uint64_t LengthTogether(std::uint64_t text, std::uint64_t binary)
{
  return 12 + 8 + (text + 3) / 4 * 4 + 8 + (binary + 3) / 4 * 4;
}
///@}
}

#endif
