/**
 * Names of the arrays that travel from where the data are to where they are rendered, besides the input's own.
 */
#ifndef RayTracedArrays_h
#define RayTracedArrays_h

#include "vtkAbstractArray.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <new>
#include <string>

namespace rtglyphs::RayTracedArrays
{
/// Of each point: its id in the input's block, or EncodeCellId() the cell's whose center it is. Missing where it would
/// be the identity.
constexpr const char* PointIds = "vtkRayTraced_PointIds";
/// Of each point, or of each cell of a surface: the cell of the input's block that it stands for. Missing where there
/// is none.
constexpr const char* CellIds = "vtkRayTraced_CellIds";
/// Field data of each block, and of each point of several: its flat index in the input. Missing where the input is a
/// single data set.
constexpr const char* CompositeIndex = "vtkRayTraced_CompositeIndex";
/// Of each point: the rank that it comes from. Missing where there is one.
constexpr const char* ProcessId = "vtkRayTraced_ProcessId";
/// Of each point: its velocity since the step shown before, which VelocityArray names. Optional.
constexpr const char* StepVelocity = "From Previous Step";
/// Of each point: where it was in earlier steps (GlyphSteps). Missing unless requested.
constexpr const char* Trail = "vtkRayTraced_Trail";
/// Of each point of a surface: the normal that it is shaded by, the input's or a computed one. Optional.
constexpr const char* Normals = "vtkRayTraced_Normals";
/// Of each point, and of each cell of lines: 1 where the selection has its glyph, else 0. Missing where it has none.
constexpr const char* Selected = "vtkRayTraced_Selected";
/// Of each point that stands for several (GlyphReduction): their number, the sum of the areas of their glyphs, and the
/// factor of its size. Missing otherwise.
constexpr const char* Reduced = "vtkRayTraced_Reduced";
/// Field data of each block: names of the arrays that some ranks have, and others, with points, have not. Missing where
/// there is none.
constexpr const char* PartialArrays = "vtkRayTraced_PartialArrays";
/// Field data of each block, as ParaView's own surfaces have them.
constexpr const char* BlockColors = "vtkBlockColors";

///@{
/// The id that a selector of points gets for a glyph of a cell, and one of cells for a glyph of a
/// point: a number that neither has, from which vtkRayTracedSelectionEncoder finds what is meant. Selectors keep 48
/// bits of a number.
constexpr vtkTypeInt64 CellIdOffset = vtkTypeInt64(1) << 47;
constexpr bool IsCellId(vtkTypeInt64 id)
{
  return id >= CellIdOffset;
}
constexpr vtkTypeInt64 EncodeCellId(vtkTypeInt64 id)
{
  return id + CellIdOffset;
}
/// The id of the point, or of the cell.
constexpr vtkTypeInt64 InputId(vtkTypeInt64 id)
{
  return IsCellId(id) ? id - CellIdOffset : id;
}
///@}

/// Whether an array is one of the above that the input does not have.
inline bool IsOwn(const std::string& name)
{
  return name.rfind("vtkRayTraced_", 0) == 0 || name == StepVelocity;
}

///@{
/// SetNumberOfTuples() that throws std::bad_alloc where memory does not suffice: VTK ends the process then, in builds
/// for debugging, as Debian's are. And the check alone, for so many bytes.
inline std::size_t BytesOf(vtkAbstractArray* array, vtkIdType tuples)
{
  return static_cast<std::size_t>(tuples) * array->GetNumberOfComponents() * std::max(array->GetDataTypeSize(), 1);
}
inline void Check(std::size_t bytes)
{
  ::operator delete(::operator new(bytes));
}
inline void Resize(vtkAbstractArray* array, vtkIdType tuples)
{
  Check(BytesOf(array, tuples));
  array->SetNumberOfTuples(tuples);
}
///@}

/// Whether a property that names an array names none.
inline bool IsNone(const std::string& name)
{
  return name.empty() || name == "None";
}
}

#endif
