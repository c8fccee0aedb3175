/**
 * @class   pqRayTracedGlyphsReference
 * @brief   a window that shows the shapes and says what each display property means, with an index and a search
 *
 * The words are those of the properties' XML: the tool tip's sentence and the rest.
 */
#ifndef pqRayTracedGlyphsReference_h
#define pqRayTracedGlyphsReference_h

#include <QDialog>

class pqRayTracedGlyphsReference : public QDialog
{
  Q_OBJECT

public:
  pqRayTracedGlyphsReference(QWidget* parent = nullptr);
};

#endif
