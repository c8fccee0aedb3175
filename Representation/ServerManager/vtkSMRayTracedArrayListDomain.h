/**
 * @class   vtkSMRayTracedArrayListDomain
 * @brief   a list of arrays whose default is chosen by what the arrays are
 *
 * ParaView's own list takes the active attribute, and without one the first array. The attribute `choice` in the
 * XML says which role it has (GlyphArrayRoles): direction, velocity, tensor, harmonics, exponents or scale. Bodies are
 * turned by rotations first, and arrows are as long as their direction. Without any: None.
 */
#ifndef vtkSMRayTracedArrayListDomain_h
#define vtkSMRayTracedArrayListDomain_h

#include "GlyphArrayRoles.h"
#include "vtkNew.h"
#include "vtkSMArrayListDomain.h"

#include <optional>
#include <string>
#include <vector>

class vtkPVDataInformation;
class vtkPVDataSetAttributesInformation;
class vtkSMProxy;

class vtkSMRayTracedArrayListDomain : public vtkSMArrayListDomain
{
public:
  vtkAbstractTypeMacro(vtkSMRayTracedArrayListDomain, vtkSMArrayListDomain);

  /**
   * Of a property of glyphs.
   */
  static vtkSMRayTracedArrayListDomain* Of(vtkSMProxy* glyphs, const char* property);

  /**
   * The array that a property names; empty: none.
   */
  static std::string Named(vtkSMProxy* proxy, const char* property);

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

  using Array = rtglyphs::GlyphArrayRoles::Array;
  using Choice = rtglyphs::GlyphArrayRoles::Choice;

  /**
   * Information on the listed arrays.
   */
  std::vector<Array> Listed();
  Array Find(const std::string& name); // without a name: it is not listed

  /**
   * The default, and why; of one array whether it can be that.
   */
  Choice Choose(const char* only = nullptr);
  bool HasBetterThan(const char* array) { return !this->Choose(array) && this->Choose(); }
  Choice ChooseFor(rtglyphs::GlyphArrayRoles::Role role, const std::vector<Array>& arrays);

  /**
   * Whether glyphs have a shape that rotations change.
   */
  static bool IsBody(vtkSMProxy* glyphs);

  /**
   * Whether glyphs are arrows or cones, which follow directions.
   */
  static bool AreArrows(vtkSMProxy* glyphs);

  /**
   * Whether glyphs of the data stand at cells: where only these have what GlyphShape shows. Empty: neither has.
   */
  static std::optional<bool> AreAtCells(vtkPVDataInformation* data, int shape);

protected:
  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

  /**
   * Columns that can be joined, as arrays of these names, and velocities from the previous step, for the list.
   */
  vtkPVDataInformation* GetExtraDataInformation() override;

private:
  std::vector<Array> InputArrays();

  rtglyphs::GlyphArrayRoles::Role Chosen = rtglyphs::GlyphArrayRoles::SIZE; // by the attribute `choice`
  vtkNew<vtkPVDataInformation> JoinedArrays;
};

#endif
