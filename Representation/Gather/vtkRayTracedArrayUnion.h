/**
 * @class   vtkRayTracedArrayUnion
 * @brief   which arrays several data sets together have
 *
 * An array that all of them have, of one type, stays what it is. A numeric array that some lack, or have of another
 * type, becomes one of double with NaN in the holes, which color maps know. vtkDataSetAttributes::FieldList, VTK's own,
 * keeps arrays of one name and different types apart and leaves holes undefined.
 */
#ifndef vtkRayTracedArrayUnion_h
#define vtkRayTracedArrayUnion_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkDoubleArray;
class vtkStringArray;

class vtkRayTracedArrayUnion
{
public:
  struct Item
  {
    vtkAbstractArray* First = nullptr; // the one that decides on the length of tuples
    std::size_t Sets = 0;              // number of data sets that have it, with tuples of this length
    bool SameType = true;

    /// That of a data set, or null where it lacks this one.
    vtkAbstractArray* Of(vtkDataSetAttributes* set) const;

    /// An array for the values of all data sets; numbers that are not exact are doubles.
    vtkSmartPointer<vtkAbstractArray> Make(vtkIdType tuples, bool exact) const;
  };

  /**
   * Tuples of data sets that lack the array, in one that Make() has made: numbers that are none, told apart from those
   * of the data, or empty texts. operator(): whether a tuple is such a hole, in any thread.
   */
  class Holes
  {
  public:
    explicit Holes(vtkAbstractArray* array = nullptr);
    bool operator()(vtkIdType tuple) const;
    static void Fill(vtkAbstractArray* array, vtkIdType first, vtkIdType count);

  private:
    vtkDoubleArray* Numbers;
    vtkStringArray* Texts;
  };

  /**
   * Arrays that isWanted(set, array), but for those without a name. Of data sets without attributes (null) nothing is
   * known.
   */
  vtkRayTracedArrayUnion(const std::vector<vtkDataSetAttributes*>& sets,
    const std::function<bool(vtkDataSetAttributes*, vtkAbstractArray*)>& isWanted);

  /**
   * Whether all data sets have an array as it is.
   */
  bool IsExact(const Item& item) const { return item.Sets == this->Sets && item.SameType; }

  const std::map<std::string, Item>& Items() const { return this->Known; }

private:
  std::size_t Sets;
  std::map<std::string, Item> Known;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedArrayUnion.h
