/**
 * @class   vtkGlyphBlockAttributes
 * @brief   visibility, colour and opacity of a composite data set's blocks, as selectors say
 *
 * Selectors are paths in the data set's hierarchy, as the Multiblock Inspector writes them. A deeper selector wins
 * over the one of a node above it. Without a hierarchy (not a composite) everything is visible.
 */
#ifndef vtkGlyphBlockAttributes_h
#define vtkGlyphBlockAttributes_h

#include <array>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

class vtkPolyData;

class vtkGlyphBlockAttributes
{
public:
  ///@{
  /**
   * Each returns whether it changed something. Default is the selector "/" (all blocks), no colours, no opacities.
   */
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
    bool operator==(const Block& other) const
    {
      return this->Visible == other.Visible && this->HasColor == other.HasColor &&
        this->Color == other.Color && this->Opacity == other.Opacity;
    }
    bool operator!=(const Block& other) const { return !(*this == other); }
  };
  /**
   * Block by flat index; empty when `points` does not come from a composite.
   */
  using Table = std::unordered_map<unsigned int, Block>;
  Table Resolve(vtkPolyData* points) const;

private:
  std::set<std::string> Selectors{ "/" };
  std::map<std::string, std::array<double, 3>> Colors;
  std::map<std::string, double> Opacities;
};

#endif
