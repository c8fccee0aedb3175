/**
 * ParaView's selection of a representation's input, as marks of what was gathered of that.
 *
 * ParaView draws what is selected of a source as points, which lie inside the glyphs. The filter that extracts them for
 * that purpose has the ids, and is an input of the representation.
 */
#ifndef RayTracedSelection_h
#define RayTracedSelection_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

class vtkAlgorithm;

namespace rtglyphs::RayTracedSelection
{
/**
 * Whether there is a selection: on all ranks alike, whether or not any of it is on this one.
 */
bool Exists(vtkAlgorithm* representation, int port);

/**
 * The tree with an array RayTracedArrays::Selected of the points of each leaf, 1 where the extracted data have the
 * point or the cell that the glyph stands for; lines have one of their cells, too. Data of several ranks, some without
 * a selected point, are put together, so all have the array.
 */
vtkSmartPointer<vtkDataObject> Mark(vtkDataObject* gathered, vtkDataObject* extracted);
}

#endif
