/**
 * Vectors, quaternions and tensors whose components are arrays of their own, as particle codes write them: 'vx, vy, vz'
 * names the array of three components that these three make.
 */
#ifndef vtkGlyphJoinedArrays_h
#define vtkGlyphJoinedArrays_h

#include <string>

class vtkPolyData;

namespace vtkGlyphJoinedArrays
{
/**
 * Adds a point array of that name where each of its parts is a point array of one component and there is none yet.
 */
void Add(vtkPolyData* points, const std::string& name);
}

#endif
// VTK-HeaderTest-Exclude: vtkGlyphJoinedArrays.h
