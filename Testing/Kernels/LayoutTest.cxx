// Records lie in memory as C++ and as GLSL have them: offsets of members and strides of arrays in the compiled
// programs.
#include "HostDevice.h"
#include "Shading/List.h"
#include "Vulkan/Programs.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace
{

constexpr std::uint32_t opName = 5, opMemberName = 6, opDecorate = 71, opMemberDecorate = 72, opTypeArray = 28,
                        opTypeRuntimeArray = 29;
constexpr std::uint32_t arrayStride = 6, offset = 35;

// By "structure.member" or by the structure whose array it is. Several: structures of that name differ.
struct Layout
{
  std::map<std::string, std::set<std::uint32_t>> offsets, strides;
};

std::string NameAt(const std::uint32_t* words)
{
  return reinterpret_cast<const char*>(words);
}

void Read(const rtg::programs::Code& code, Layout& layout)
{
  std::map<std::uint32_t, std::string> names;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> members;
  std::map<std::uint32_t, std::uint32_t> elements;
  const auto each = [&](const auto& visit)
  {
    for (std::size_t at = 5; at < code.bytes / sizeof(std::uint32_t); at += code.words[at] >> 16)
    {
      visit(code.words[at] & 0xffffu, code.words + at + 1);
    }
  };
  each(
    [&](std::uint32_t instruction, const std::uint32_t* words)
    {
      if (instruction == opName)
      {
        names[words[0]] = NameAt(words + 1);
      }
      else if (instruction == opMemberName)
      {
        members[{ words[0], words[1] }] = NameAt(words + 2);
      }
      else if (instruction == opTypeArray || instruction == opTypeRuntimeArray)
      {
        elements[words[0]] = words[1];
      }
    });
  each(
    [&](std::uint32_t instruction, const std::uint32_t* words)
    {
      if (instruction == opMemberDecorate && words[2] == offset)
      {
        layout.offsets[names[words[0]] + "." + members[{ words[0], words[1] }]].insert(words[3]);
      }
      else if (instruction == opDecorate && words[1] == arrayStride)
      {
        layout.strides[names[elements[words[0]]]].insert(words[2]);
      }
    });
}

} // namespace

TEST(LayoutTest, HostAndDeviceAgree)
{
  Layout layout;
#define RTG_COUNT(...) +1
  constexpr std::size_t programs = RTG_SHADINGS(RTG_COUNT);
#undef RTG_COUNT
  for (std::size_t program = 0; program < programs; ++program)
  {
    Read(rtg::programs::modules[program], layout);
  }
  namespace device = rtg::device;
  using Offsets = std::set<std::uint32_t>;
  // What lies behind others: were one of these elsewhere, it would be, too.
#define RTG_EXPECT(structure, member)                                                                                  \
  EXPECT_EQ(layout.offsets[#structure "." #member], Offsets{ offsetof(device::structure, member) })                    \
    << #structure "." #member
  RTG_EXPECT(TreeRecord, nodesPerSlice);
#define RTG_EXPECT_ARRAY(number, BIT, type, name, values, words) RTG_EXPECT(GlyphSetRecord, name);
  RTG_GLYPH_ARRAYS(RTG_EXPECT_ARRAY)
#undef RTG_EXPECT_ARRAY
  RTG_EXPECT(GlyphSetRecord, tree);
  RTG_EXPECT(GlyphSetRecord, shutterOpen);
  RTG_EXPECT(GlyphSetRecord, meshPositions);
  RTG_EXPECT(GlyphSetRecord, meshTree);
  RTG_EXPECT(GlyphSetRecord, meshVelocities);
  RTG_EXPECT(GlyphSetRecord, coatColor);
  RTG_EXPECT(LightRecord, exponent);
  RTG_EXPECT(PixelSums, depth);
  RTG_EXPECT(PixelFeatures, hits);
  RTG_EXPECT(FrameRecord, topLevels);
  RTG_EXPECT(FrameRecord, sets);
  RTG_EXPECT(FrameRecord, eye);
  RTG_EXPECT(FrameRecord, width);
  RTG_EXPECT(FrameRecord, environment);
  RTG_EXPECT(FrameRecord, environmentTexels);
  RTG_EXPECT(FrameRecord, toneMapping);
  RTG_EXPECT(FrameRecord, fewLights);
  RTG_EXPECT(FrameRecord, onlySet);
#undef RTG_EXPECT
  EXPECT_EQ(layout.strides["GlyphSetRecord"], Offsets{ sizeof(device::GlyphSetRecord) });
  EXPECT_EQ(layout.strides["LightRecord"], Offsets{ sizeof(device::LightRecord) });
  EXPECT_EQ(layout.strides["PixelSums"], Offsets{ sizeof(device::PixelSums) });
  EXPECT_EQ(layout.strides["PixelFeatures"], Offsets{ sizeof(device::PixelFeatures) });
}
