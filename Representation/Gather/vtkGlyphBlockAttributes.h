/**
 * @class   vtkGlyphBlockAttributes
 * @brief   visibility, color and opacity of a composite data set's blocks, as selectors say
 *
 * Selectors are paths in the data set's hierarchy, as the Multiblock Inspector writes them, or in the assembly that the
 * data have. A deeper selector wins
 * over the one of a node above it. Without a hierarchy (not a composite) everything is visible.
 */
#ifndef vtkGlyphBlockAttributes_h
#define vtkGlyphBlockAttributes_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

class vtkPolyData;

class vtkGlyphBlockAttributes
{
public:
  ///@{
  /**
   * Each returns whether it changed something. Default is the selector "/" (all blocks), no colors, no opacities, the
   * hierarchy.
   */
  bool SetAssembly(const char* name);
  bool AddSelector(const char* selector);
  bool RemoveAllSelectors();
  bool SetColor(const char* selector, double r, double g, double b);
  bool RemoveAllColors();
  bool SetOpacity(const char* selector, double opacity);
  bool RemoveAllOpacities();
  ///@}

  /**
   * True when some opacity lies between 0 and 1.
   */
  bool HasTranslucent() const;

  struct Block
  {
    bool Visible = true;
    bool HasColor = false;
    std::array<double, 3> Color{ { 1.0, 1.0, 1.0 } };
    double Opacity = 1.0;

    bool operator==(const Block&) const = default;
  };
  /**
   * Block by flat index; empty when `points` does not come from a composite.
   */
  using Table = std::unordered_map<unsigned int, Block>;

  /**
   * The flat indices of the blocks that are not visible, by rising number.
   */
  static std::vector<unsigned int> Hidden(const Table& blocks);

  /**
   * What holds for the blocks of `points`; kept until the attributes or the hierarchy change.
   */
  const Table& Resolve(vtkPolyData* points);

  /**
   * Two objects of the same version say the same.
   */
  std::uint64_t GetVersion() const { return this->Version; }

private:
  Table Resolved(vtkPolyData* points) const;
  bool Note(bool changed);

  std::uint64_t Version = 0;
  Table Known;
  std::array<vtkMTimeType, 3> KnownFor{}; // hierarchy, leaves, version + 1
  std::string Assembly;
  std::set<std::string> Selectors{ "/" };
  std::map<std::string, std::array<double, 3>> Colors;
  std::map<std::string, double> Opacities;
};

#endif
