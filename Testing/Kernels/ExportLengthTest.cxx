// Lengths of .glb files, whose numbers have 32 bits.
#include "vtkGlyphGLTFWriter.h"

#include <gtest/gtest.h>

namespace
{

TEST(ExportLength, CountsHeadersAndPadding)
{
  EXPECT_EQ(vtkGlyphGLTFWriter::LengthTogether(0, 0), 28u);
  EXPECT_EQ(vtkGlyphGLTFWriter::LengthTogether(4, 8), 40u);
  EXPECT_EQ(vtkGlyphGLTFWriter::LengthTogether(5, 9), 48u);
}

TEST(ExportLength, IsWholeAboveFourGigabytes)
{
  constexpr std::uint64_t text = 2000, room = vtkGlyphGLTFWriter::MostTogether - 28 - text;
  EXPECT_LE(vtkGlyphGLTFWriter::LengthTogether(text, room / 4 * 4), vtkGlyphGLTFWriter::MostTogether);
  EXPECT_GT(vtkGlyphGLTFWriter::LengthTogether(text, room / 4 * 4 + 1), vtkGlyphGLTFWriter::MostTogether);
  // Of 77 million colored glyphs, 56 bytes each
  EXPECT_EQ(vtkGlyphGLTFWriter::LengthTogether(text, 77'000'000ull * 56), 4'312'002'028ull);
}

} // namespace
