/**
 * Glyphs as Universal Scene Description (.usda): a PointInstancer for each display.
 *
 * Coordinates are the data's; up is z, so programs with z up leave them as they are.
 */
#ifndef GlyphUSDWriter_h
#define GlyphUSDWriter_h

#include "GlyphTessellatedSet.h"

namespace rtglyphs::GlyphUSDWriter
{
std::string Text(const std::vector<GlyphTessellatedSet>& sets);
}

#endif
