#include "RayTracedPeriodic.h"

#include "GlyphPlacement.h"
#include "RayTracedRanks.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace
{
// Names under which codes and readers keep the edges of a box, nine numbers.
constexpr const char* names[] = { "lattice", "lattice_vectors", "latticevectors", "lattice vectors", "cell",
  "cell_vectors", "unitcell", "unit_cell", "box", "box_vectors", "boxvectors", "vectors" };

bool IsNamed(const char* name, const char* known)
{
  return name && vtksys::SystemTools::LowerCase(name) == known;
}

// The first array of such a name that has nine numbers; null: there is none.
vtkDataArray* FindEdges(vtkFieldData* field)
{
  for (const char* name : names)
  {
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = field->GetArray(i);
      if (array && IsNamed(array->GetName(), name) && array->GetNumberOfValues() == 9)
      {
        return array;
      }
    }
  }
  return nullptr;
}

// The edges that data have in their own field data, or else in that of their blocks.
vtkDataArray* FindEdges(vtkDataObject* data)
{
  vtkDataArray* edges = data ? FindEdges(data->GetFieldData()) : nullptr;
  for (vtkPolyData* block : vtkCompositeDataSet::GetDataSets<vtkPolyData>(data))
  {
    edges = edges ? edges : FindEdges(block->GetFieldData());
  }
  return edges;
}
}

//----------------------------------------------------------------------------
rtg::PeriodicImages
rtglyphs::RayTracedPeriodic::Make(vtkDataObject* points, vtkDataObject* data, bool together, std::string& problem) const
{
  rtg::PeriodicImages images;
  if (!this->Boundary)
  {
    return images;
  }
  vtkBoundingBox box;
  if (points)
  {
    for (vtkPolyData* leaf : vtkCompositeDataSet::GetDataSets<vtkPolyData>(points))
    {
      if (leaf->GetNumberOfPoints() > 0)
      {
        box.AddBounds(leaf->GetBounds());
      }
    }
  }
  if (together)
  {
    box = RayTracedRanks::Union(box);
  }
  if (!box.IsValid())
  {
    return images;
  }
  std::array<double, 9> edges = this->Vectors;
  if (edges == std::array<double, 9>{})
  {
    vtkDataArray* own = FindEdges(points);
    if (vtkDataArray* found = own ? own : FindEdges(data))
    {
      const int components = found->GetNumberOfComponents();
      for (int i = 0; i < 9; ++i)
      {
        edges[i] = found->GetComponent(i / components, i % components);
      }
    }
    else
    {
      for (int i = 0; i < 3; ++i)
      {
        edges[4 * i] = box.GetLength(i);
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    images.edges[i] = { edges[3 * i], edges[3 * i + 1], edges[3 * i + 2] };
    const double length = glm::length(images.edges[i]);
    const int shown = std::clamp(this->Images[i], 0, 4);
    if (!std::isfinite(length) || (!(length > 0.0) && shown > 0))
    {
      std::ostringstream message;
      message << "Ray Traced Glyphs: edge " << i + 1 << " of the periodic box is " << edges[3 * i] << ' '
              << edges[3 * i + 1] << ' ' << edges[3 * i + 2]
              << ", so nothing repeats; give the box in PeriodicVectors, or switch PeriodicBoundary off.";
      problem = message.str();
      return {};
    }
    images.shown[i] = shown;
    images.lit[i] = length > 0.0 ? shown + 1 : 0;
  }
  return images;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedPeriodic::AreEdges(const char* name, vtkIdType numbers)
{
  return numbers == 9 &&
    std::any_of(std::begin(names), std::end(names), [name](const char* known) { return IsNamed(name, known); });
}

//----------------------------------------------------------------------------
void rtglyphs::ExtendBounds(const rtg::PeriodicImages& images, double bounds[6])
{
  for (int i = 0; i < 3 && vtkMath::AreBoundsInitialized(bounds); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double reach = images.shown[i] * std::abs(images.edges[i][axis]);
      bounds[2 * axis] -= reach;
      bounds[2 * axis + 1] += reach;
    }
  }
}

//----------------------------------------------------------------------------
rtg::PeriodicImages rtglyphs::Moved(rtg::PeriodicImages images, vtkMatrix4x4* matrix)
{
  const glm::dmat3 linear = GlyphPlacement(matrix).Linear;
  for (glm::dvec3& edge : images.edges)
  {
    edge = linear * edge;
  }
  return images;
}
