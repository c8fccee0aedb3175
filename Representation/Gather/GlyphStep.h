/**
 * @class   GlyphStep
 * @brief   where the points of a time step are, by their ids
 *
 * A point is known by its id, where that occurs once in the step; else by its id and block, where it occurs once in
 * that. What else has no known id, or no finite position, is left out. An entry takes 48 bytes.
 */
#ifndef GlyphStep_h
#define GlyphStep_h

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

namespace rtglyphs
{

class GlyphStep
{
public:
  struct Entry
  {
    std::int64_t Id;
    unsigned int Block; // of an id that several blocks have; else 0: points may go from block to block
    int Leaf;           // of the tree, by number, and its point
    vtkIdType Point;
    double X[3];

    std::pair<std::int64_t, unsigned int> Key() const { return { this->Id, this->Block }; }
  };

  GlyphStep() = default;

  /**
   * Of a RayTracedTree. `idArray`: the point array of one component that identifies points; "None" or empty:
   * the global ids.
   */
  GlyphStep(vtkDataObject* tree, const std::string& idArray);

  const std::vector<Entry>& GetEntries() const { return this->Entries; } // by rising key, each key once
  vtkIdType GetPoints() const { return this->Points; }                   // with or without an entry

  /// Whether there are points, and none has an id.
  bool LacksIds() const { return this->Points > 0 && !this->AnyIds; }

  /// The message then for a property that needs them.
  static std::string IdsNeeded(const std::string& property, const std::string& consequence);

  ///@{
  /**
   * The entries of the same points in two steps; both lists have the order of GetEntries().
   */
  using Pairs = std::vector<std::pair<const Entry*, const Entry*>>; // now and before
  static Pairs Match(const std::vector<Entry>& now, const std::vector<Entry>& before);
  ///@}

  /**
   * The pairs but for those that move farther along an axis than half of the extent, where most points move less than a
   * tenth of it: these have crossed the border of a periodic box, whose length is not in the data.
   */
  static Pairs WithoutCrossings(Pairs pairs);

private:
  void Add(vtkPolyData* points, vtkDataArray* ids, int leaf);
  void KeepUnique();

  std::vector<Entry> Entries;
  vtkIdType Points = 0;
  bool AnyIds = false;
};

} // namespace rtglyphs

#endif
