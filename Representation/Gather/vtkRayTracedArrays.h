/**
 * Names of the arrays that travel from where the data are to where they are rendered, besides the input's own. They
 * begin as the input's arrays never should: nobody's arrays of the same name are lost.
 */
#ifndef vtkRayTracedArrays_h
#define vtkRayTracedArrays_h

#include "vtkType.h"

#include <string>

namespace vtkRayTracedArrays
{
/// Of each point: its id in the input's block. Missing where it would be the identity.
constexpr const char* PointIds = "vtkRayTraced_PointIds";
/// Of each point, or of each cell of a surface: the cell of the input's block that it stands for. Missing where there
/// is none.
constexpr const char* CellIds = "vtkRayTraced_CellIds";
/// Of each point: flat index of its block. Missing where the input is a single data set.
constexpr const char* CompositeIndex = "vtkRayTraced_CompositeIndex";
/// Of each point: the rank that it comes from. Missing where there is one.
constexpr const char* ProcessId = "vtkRayTraced_ProcessId";
/// Of each point: its velocity since the step shown before. Missing unless asked for.
constexpr const char* StepVelocity = "vtkRayTraced_StepVelocity";
/// Of each point of composite input: what ParaView calls vtkBlockColors, its field data of each block.
constexpr const char* BlockColors = "vtkBlockColors";
/// vtkPVGeometryFilter's default number of them, after which they repeat.
constexpr unsigned int DistinctBlockColors = 7;
///@{
/// Field data of composite input: the tree that block selectors are paths in, as XML, and pairs (flat index, index of
/// the data set in the tree).
constexpr const char* Hierarchy = "vtkRayTraced_Hierarchy";
constexpr const char* Leaves = "vtkRayTraced_Leaves";
///@}

///@{
/// What a selector of cells is told of a point that has none: a number that no cell has, from which
/// vtkRayTracedSelectionEncoder finds the point. Selectors keep 48 bits of a number.
constexpr vtkTypeInt64 PointMark = vtkTypeInt64(1) << 47;
constexpr bool IsMarkedPoint(vtkTypeInt64 id)
{
  return id >= PointMark;
}
constexpr vtkTypeInt64 MarkedPoint(vtkTypeInt64 point)
{
  return point + PointMark;
}
constexpr vtkTypeInt64 UnmarkedPoint(vtkTypeInt64 id)
{
  return id - PointMark;
}
///@}

/// Whether a property that names an array names none.
inline bool IsNone(const std::string& name)
{
  return name.empty() || name == "None";
}
}

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedArrays.h
