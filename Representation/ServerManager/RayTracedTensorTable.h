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
   * A property of the glyphs has been set: another number gets its own table, until a table is chosen.
   */
  void Follow(const std::string& name);

  /**
   * Chooses the table of what the glyphs show, with the range of the data, and shows its bar in the view.
   */
  void Update(vtkSMProxy* glyphs, vtkSMProxy* view);

private:
  std::string Name; // of the table and scalar bar that are in use; empty: none
  double Range[2] = { 1.0, -1.0 };
  bool IsChosen = false; // by the user
};

} // namespace rtglyphs

#endif
