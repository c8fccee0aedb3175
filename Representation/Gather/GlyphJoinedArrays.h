/**
 * Vectors, quaternions and tensors whose components are in several arrays, as particle codes write them: 'vx, vy, vz'
 * names the array of three components that these three make, 'c_q[1-3], c_q[4]' that of four.
 */
#ifndef GlyphJoinedArrays_h
#define GlyphJoinedArrays_h

#include <string>

class vtkPolyData;

namespace rtglyphs::GlyphJoinedArrays
{
/**
 * Begins the name of an array that is made of one of atomic numbers, whose name follows.
 */
inline const std::string vanDerWaals = "Van der Waals radii of ";

/**
 * Adds a point array of that name with all components of its parts, one after another, where each part is a point array
 * and there is none of that name yet. Parts of different types make an array of doubles. Or one of the radii of
 * atomic numbers (vanDerWaals).
 */
void Add(vtkPolyData* points, const std::string& name);
}

#endif
