#include "vtkRayTracedArrayUnion.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkType.h"

//----------------------------------------------------------------------------
vtkRayTracedArrayUnion::vtkRayTracedArrayUnion(const std::vector<vtkDataSetAttributes*>& sets,
  const std::function<bool(vtkDataSetAttributes*, vtkAbstractArray*)>& isWanted)
  : Sets(sets.size())
{
  for (vtkDataSetAttributes* set : sets)
  {
    for (int i = 0; set && i < set->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = set->GetAbstractArray(i);
      if (!array->GetName() || !isWanted(set, array))
      {
        continue;
      }
      Item& item = this->Known[array->GetName()];
      item.First = item.First ? item.First : array;
      item.SameType &= item.First->GetDataType() == array->GetDataType();
      // Arrays of one name and different lengths of tuple are different things: the first kind wins.
      item.Sets += item.First->GetNumberOfComponents() == array->GetNumberOfComponents() ? 1 : 0;
    }
  }
}

//----------------------------------------------------------------------------
vtkAbstractArray* vtkRayTracedArrayUnion::Item::Of(vtkDataSetAttributes* set) const
{
  vtkAbstractArray* array = set ? set->GetAbstractArray(this->First->GetName()) : nullptr;
  return array && array->GetNumberOfComponents() == this->First->GetNumberOfComponents() ? array : nullptr;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> vtkRayTracedArrayUnion::Item::Make(vtkIdType tuples, bool exact) const
{
  // Not an instance of the first one's class, which may be an array that cannot be written to.
  const int type = exact ? this->First->GetDataType() : VTK_DOUBLE;
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  array->SetName(this->First->GetName());
  array->SetNumberOfComponents(this->First->GetNumberOfComponents());
  for (int c = 0; c < this->First->GetNumberOfComponents(); ++c)
  {
    array->SetComponentName(c, this->First->GetComponentName(c));
  }
  array->SetNumberOfTuples(tuples);
  return array;
}
