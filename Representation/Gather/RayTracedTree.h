/**
 * Composite data keep their structure from the input to the renderer, as ParaView's own representations deliver it, so
 * that vtkGeometryRepresentation finds the blocks that selectors mean. A single data set is a tree of one leaf.
 */
#ifndef RayTracedTree_h
#define RayTracedTree_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkDataObjectTree;
class vtkPolyData;

namespace rtglyphs::RayTracedTree
{
/**
 * The results of make(leaf) for each data set of `input`: one poly data, or a tree of them. Of composite data make() is
 * called for empty leaves (null), too; there every leaf gets its flat index in the input, and what ParaView calls
 * vtkBlockColors, of which so many are distinct. All ranks do it at once.
 */
vtkSmartPointer<vtkDataObject>
Make(vtkDataObject* input, int distinctColors, const std::function<vtkSmartPointer<vtkPolyData>(vtkDataObject*)>& make);

/**
 * The same structure with change(leaf) in place of each leaf.
 */
vtkSmartPointer<vtkDataObject>
Change(vtkDataObject* tree, const std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData*)>& change);

/**
 * Children that are not empty, with their names: of those that have none block0 and so on, as in ParaView's hierarchy,
 * of pieces that of the tree.
 */
void ForEachChild(vtkDataObjectTree* tree, const std::string& name,
  const std::function<void(vtkDataObject* child, const std::string& name)>& work);

/**
 * Adds RayTracedArrays::PartialArrays to the leaves. All ranks do it at once.
 */
void AddPartialArrays(vtkDataObject* tree);

/**
 * Of a leaf, in the input; 0 of a single data set.
 */
unsigned int FlatIndex(vtkPolyData* leaf);
}

#endif
