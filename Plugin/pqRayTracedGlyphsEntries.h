/**
 * @class   pqRayTracedGlyphsEntries
 * @brief   leaves out what has no effect on the glyphs: rows, by GlyphTensorArray, and entries of a combo box
 *
 *     <PropertyWidgetDecorator type="RayTracedGlyphsEntries" components="...">
 *       <Shapes values="..." entries="..." />
 *     </PropertyWidgetDecorator>
 *
 * components: those that a tensor must have for the row to be shown, up to 6 without names that are indices.
 * values: those of GlyphShape that take these entries only, of any other shape all.
 */
#ifndef pqRayTracedGlyphsEntries_h
#define pqRayTracedGlyphsEntries_h

#include "pqPropertyWidgetDecorator.h"

class pqRayTracedGlyphsEntries : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  pqRayTracedGlyphsEntries(vtkPVXMLElement* xml, pqPropertyWidget* row);

  bool canShowWidget(bool showAdvanced) const override;

private Q_SLOTS:
  void enable();
};

#endif
