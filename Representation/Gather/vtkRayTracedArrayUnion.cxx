#include "vtkRayTracedArrayUnion.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkStringArray.h"
#include "vtkType.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace
{
// A quiet NaN that no computation makes.
constexpr std::uint64_t hole = 0x7ff8'0000'5261'5947;

// Arrays of one name and different lengths of tuple, or numbers and texts, are different things.
bool AreAlike(vtkAbstractArray* a, vtkAbstractArray* b)
{
  const bool numbers = vtkDataArray::SafeDownCast(a) && vtkDataArray::SafeDownCast(b);
  return a->GetNumberOfComponents() == b->GetNumberOfComponents() && (numbers || a->GetDataType() == b->GetDataType());
}
}

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
      item.Sets += AreAlike(item.First, array) ? 1 : 0; // the first kind wins
    }
  }
}

//----------------------------------------------------------------------------
vtkAbstractArray* vtkRayTracedArrayUnion::Item::Of(vtkDataSetAttributes* set) const
{
  vtkAbstractArray* array = set ? set->GetAbstractArray(this->First->GetName()) : nullptr;
  return array && AreAlike(this->First, array) ? array : nullptr;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> vtkRayTracedArrayUnion::Item::Make(vtkIdType tuples, bool exact) const
{
  // Not an instance of the first one's class, which may be an array that cannot be written to.
  const int type = exact || !vtkDataArray::SafeDownCast(this->First) ? this->First->GetDataType() : VTK_DOUBLE;
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

//----------------------------------------------------------------------------
vtkRayTracedArrayUnion::Holes::Holes(vtkAbstractArray* array)
  : Numbers(vtkDoubleArray::SafeDownCast(array))
  , Texts(vtkStringArray::SafeDownCast(array))
{
}

//----------------------------------------------------------------------------
bool vtkRayTracedArrayUnion::Holes::operator()(vtkIdType tuple) const
{
  if (this->Texts)
  {
    return this->Texts->GetValue(tuple * this->Texts->GetNumberOfComponents()).empty();
  }
  return this->Numbers &&
    std::bit_cast<std::uint64_t>(this->Numbers->GetValue(tuple * this->Numbers->GetNumberOfComponents())) == hole;
}

//----------------------------------------------------------------------------
void vtkRayTracedArrayUnion::Holes::Fill(vtkAbstractArray* array, vtkIdType first, vtkIdType count)
{
  const int components = array->GetNumberOfComponents();
  if (auto* numbers = vtkDoubleArray::SafeDownCast(array))
  {
    std::fill_n(numbers->GetPointer(first * components), count * components, std::bit_cast<double>(hole));
  }
  else if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    std::fill_n(texts->GetPointer(first * components), count * components, vtkStdString());
  }
}
