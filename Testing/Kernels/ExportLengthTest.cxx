// Lengths of .glb files, whose numbers have 32 bits.
#include "GlyphGLTFWriter.h"

#include <gtest/gtest.h>

namespace
{

TEST(ExportLength, CountsHeadersAndPadding)
{
  EXPECT_EQ(rtglyphs::GlyphGLTFWriter::LengthTogether(0, 0), 28u);
  EXPECT_EQ(rtglyphs::GlyphGLTFWriter::LengthTogether(4, 8), 40u);
  EXPECT_EQ(rtglyphs::GlyphGLTFWriter::LengthTogether(5, 9), 48u);
}

TEST(ExportLength, IsWholeAboveFourGigabytes)
{
  constexpr std::uint64_t text = 2000, room = rtglyphs::GlyphGLTFWriter::MostTogether - 28 - text;
  EXPECT_LE(rtglyphs::GlyphGLTFWriter::LengthTogether(text, room / 4 * 4), rtglyphs::GlyphGLTFWriter::MostTogether);
  EXPECT_GT(rtglyphs::GlyphGLTFWriter::LengthTogether(text, room / 4 * 4 + 1), rtglyphs::GlyphGLTFWriter::MostTogether);
  // Of 77 million colored glyphs, 56 bytes each
  EXPECT_EQ(rtglyphs::GlyphGLTFWriter::LengthTogether(text, 77'000'000ull * 56), 4'312'002'028ull);
}

} // namespace
