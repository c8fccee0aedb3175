/**
 * @class   pqRayTracedGlyphsEntries
 * @brief   disables the entries of a combo box that have no effect on the shape of the glyphs
 *
 *     <PropertyWidgetDecorator type="RayTracedGlyphsEntries">
 *       <Shapes values="..." entries="..." />
 *     </PropertyWidgetDecorator>
 *
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

private Q_SLOTS:
  void enable();
};

#endif
