/**
 * @class   pqRayTracedGlyphsReference
 * @brief   a window that says what the groups of display properties, and each property in them, mean
 *
 * The words are those of the properties' XML, so that they are the same as in tooltips.
 */
#ifndef pqRayTracedGlyphsReference_h
#define pqRayTracedGlyphsReference_h

#include <QDialog>

class pqRayTracedGlyphsReference : public QDialog
{
  Q_OBJECT

public:
  pqRayTracedGlyphsReference(QWidget* parent = nullptr);
  ~pqRayTracedGlyphsReference() override;

private:
  Q_DISABLE_COPY(pqRayTracedGlyphsReference)
};

#endif
