/**
 * @class   RayTracedBlocks
 * @brief   the blocks of gathered or delivered data, each with the visibility and colors that ParaView gives it
 *
 * vtkGeometryRepresentation fills the attributes of a tree's nodes; a block has those of the nearest node above it that
 * has some, as with vtkCompositePolyDataMapper.
 *
 * GetPolyData() puts the blocks together, one after the other. Arrays that some block lacks are zero there, and know
 * where that is. As long as an array of all blocks stays the same, so does theirs.
 */
#ifndef RayTracedBlocks_h
#define RayTracedBlocks_h

#include "RayTracedRanges.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkCellArray;
class vtkCompositeDataDisplayAttributes;
class vtkDataArray;
class vtkDataObject;
class vtkPoints;

namespace rtglyphs
{

class RayTracedBlocks
{
public:
  /**
   * How arrays color a block, as a vtkMapper has it.
   */
  struct Coloring
  {
    bool On = false;
    std::string Array;
    int ScalarMode = 0, ColorMode = 0;
    vtkIdType FieldDataTuple = 0;
    bool InterpolatesScalars = true;
    vtkSmartPointer<vtkScalarsToColors> Table;
    bool MissingIsNan = false; // a block without the array has the table's color of NaN

    bool operator==(const Coloring&) const = default;
  };

  struct Attributes
  {
    bool Visible = true;
    std::optional<std::array<double, 3>> Color;
    double Opacity = 1.0;
    Coloring Scalars;

    bool operator==(const Attributes&) const = default;
  };

  struct Block : Attributes
  {
    vtkSmartPointer<vtkPolyData> Data;
    unsigned int FlatIndex = 0; // in the input
    std::string Name;
    vtkIdType FirstPoint = 0, FirstCell = 0; // of GetPolyData()
  };

  /**
   * `data` is a RayTracedTree; `attributes` are those of its nodes, `common` those of nodes without.
   * As long as these stay the same, so does the version.
   */
  void Update(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, const Attributes& common);
  std::uint64_t GetVersion() const { return this->Version; }

  const std::vector<Block>& GetBlocks() const { return this->Blocks; }
  vtkPolyData* GetPolyData() const { return this->PolyData; }       // null: without data
  const RayTracedRanges& GetHidden() const { return this->Hidden; } // points of blocks that are not visible

  /**
   * The tuples of one of GetPolyData()'s arrays (may be null) that belong to blocks without it.
   */
  static const RayTracedRanges& MissingTuples(vtkDataArray* joined);

  /**
   * Whether GetPolyData(), or a block, lack an array that other ranks have.
   */
  static bool IsOnOtherRanks(vtkPolyData* points, const std::string& array);

  /**
   * Says of which points that are not hidden the blocks lack a point array that others, or other ranks, have:
   * `consequence` completes 'its 120 points'. Of one array it speaks once.
   */
  static void ReportMissing(vtkPolyData* points, const std::string& array, const RayTracedRanges& hidden,
    const char* property, const char* consequence, std::vector<std::string>& messages);

private:
  using Times = std::vector<vtkMTimeType>;
  using Memo = std::map<std::pair<bool, std::string>, std::pair<Times, vtkSmartPointer<vtkDataArray>>>;

  void Join();
  void JoinPoints();
  void JoinArrays(bool cells);
  void JoinCells(const char* what, vtkCellArray* (*cellsOf)(vtkPolyData*), void (*set)(vtkPolyData*, vtkCellArray*));

  std::uint64_t Version = 0;
  std::vector<Block> Blocks;
  RayTracedRanges Hidden;
  Attributes Common;
  vtkMTimeType AttributesTime = 0;
  vtkDataObject* Joined = nullptr; // only to be compared
  vtkMTimeType JoinedTime = 0;
  vtkSmartPointer<vtkPolyData> PolyData;
  Memo Arrays, UsedArrays;
  std::map<std::string, std::pair<Times, vtkSmartPointer<vtkCellArray>>> Cells;
  std::pair<Times, vtkSmartPointer<vtkPoints>> Places;
};

} // namespace rtglyphs

#endif
