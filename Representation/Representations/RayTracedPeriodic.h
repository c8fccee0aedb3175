/**
 * How a display repeats along the edges of a periodic box, as its properties say.
 */
#ifndef RayTracedPeriodic_h
#define RayTracedPeriodic_h

#include "Glyphs.h"
#include "vtkType.h"

#include <array>
#include <string>

class vtkDataObject;
class vtkMatrix4x4;

namespace rtglyphs
{
struct RayTracedPeriodic
{
  bool Boundary = false;
  std::array<double, 9> Vectors{}; // edges of the box one after the other; all zero: those of the data
  std::array<int, 3> Images{};     // that are shown on either side along each edge

  /**
   * The images in the data's coordinates, of a RayTracedTree of points (null: none). The field data of it, or of
   * `data`, or of a block may have the edges, else they are those of the points' bounds. `together`: all ranks ask at
   * once, each of which has a part of the data. Where there is a `problem`, which is to be reported, there are none.
   */
  rtg::PeriodicImages Make(vtkDataObject* points, vtkDataObject* data, bool together, std::string& problem) const;

  /**
   * Whether a field array of that name and number of values has the edges.
   */
  static bool AreEdges(const char* name, vtkIdType numbers);
};

/**
 * Adds the shown images of what lies within the bounds.
 */
void ExtendBounds(const rtg::PeriodicImages& images, double bounds[6]);

/**
 * The same images of what a matrix moves.
 */
rtg::PeriodicImages Moved(rtg::PeriodicImages images, vtkMatrix4x4* matrix);
}

#endif
