/**
 * The lookup table and the scalar bar of numbers of tensors (GlyphTensorColoring), on the client. The table of a number
 * has a name of its own, so that nothing of the table of an array is left in it.
 */
#ifndef RayTracedTensorTable_h
#define RayTracedTensorTable_h

#include <string>

class vtkSMProxy;

namespace rtglyphs
{

class RayTracedTensorTable
{
public:
  /**
   * Chooses the table of what the glyphs show, with the range of the data, unless it is the user's, and shows its bar
   * in the view. Glyphs that are not shown have no bar.
   */
  void Update(vtkSMProxy* glyphs, vtkSMProxy* view, bool shown, bool isUsers);

private:
  std::string Name; // of the table and scalar bar that are in use; empty: none
  double Range[2] = { 1.0, -1.0 };
};

} // namespace rtglyphs

#endif
