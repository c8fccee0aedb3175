/**
 * @class   RayTracedSelected
 * @brief   marks in what is gathered of a representation's input what ParaView's selection has of it
 *
 * ParaView draws what is selected of a source as points, which lie inside the glyphs. The filter that extracts them for
 * that purpose has the ids, and is an input of the representation. Another selection gathers nothing anew.
 */
#ifndef RayTracedSelected_h
#define RayTracedSelected_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <functional>

class vtkAlgorithm;

namespace rtglyphs
{

class RayTracedSelected
{
public:
  /**
   * What the filter at that input has extracted; nothing without a selection.
   */
  void Take(vtkAlgorithm* representation, int port, vtkDataObject* extracted);

  /**
   * What `gather` makes of the input with these options, called where one of them is another than before.
   */
  vtkSmartPointer<vtkDataObject> Gather(vtkDataObject* input, const std::array<int, 4>& options, bool marks,
    const std::function<vtkSmartPointer<vtkDataObject>()>& gather);

private:
  vtkSmartPointer<vtkDataObject> Gathered; // of an input of these times
  vtkDataObject* Input = nullptr;          // only to be compared
  std::array<vtkMTimeType, 2> Times{};
  std::array<int, 4> Options{};
  vtkSmartPointer<vtkDataObject> Extracted;
};

} // namespace rtglyphs

#endif
