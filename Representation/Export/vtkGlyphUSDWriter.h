/**
 * Glyphs as Universal Scene Description (.usda): a PointInstancer for each display.
 *
 * Coordinates are the data's; up is z, so that programs that stand on z leave them as they are.
 */
#ifndef vtkGlyphUSDWriter_h
#define vtkGlyphUSDWriter_h

#include "vtkGlyphTessellatedSet.h"

namespace vtkGlyphUSDWriter
{
std::string Text(const std::vector<vtkGlyphTessellatedSet>& sets);
}

#endif
// VTK-HeaderTest-Exclude: vtkGlyphUSDWriter.h
