/**
 * @class   GlyphBlockAttributes
 * @brief   which blocks are visible, by their flat index (RayTracedArrays::CompositeIndex)
 */
#ifndef GlyphBlockAttributes_h
#define GlyphBlockAttributes_h

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace rtglyphs
{

class GlyphBlockAttributes
{
public:
  struct Block
  {
    bool Visible = true;
  };
  using Table = std::unordered_map<unsigned int, Block>;

  /**
   * The flat indices of the blocks that are not visible, by rising number.
   */
  static std::vector<unsigned int> Hidden(const Table& blocks)
  {
    std::vector<unsigned int> hidden;
    for (const auto& [index, block] : blocks)
    {
      if (!block.Visible)
      {
        hidden.push_back(index);
      }
    }
    std::sort(hidden.begin(), hidden.end());
    return hidden;
  }
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: GlyphBlockAttributes.h
