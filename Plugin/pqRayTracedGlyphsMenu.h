/**
 * @class   pqRayTracedGlyphsMenu
 * @brief   "Add Surface" in the menu of a click with the right button on ray-traced glyphs
 *
 * ParaView has one display of a source in a view, so that its surface beside its glyphs is the display of a filter,
 * Extract Surface, as Ray Traced Surface.
 */
#ifndef pqRayTracedGlyphsMenu_h
#define pqRayTracedGlyphsMenu_h

#include "pqContextMenuInterface.h"

#include <QObject>

class pqRayTracedGlyphsMenu
  : public QObject
  , public pqContextMenuInterface
{
  Q_OBJECT
  Q_INTERFACES(pqContextMenuInterface)

public:
  pqRayTracedGlyphsMenu(QObject* parent = nullptr);
  ~pqRayTracedGlyphsMenu() override;

  bool contextMenu(QMenu* menu, pqView* view, const QPoint& place, pqRepresentation* display,
    const QList<unsigned int>& blocks) const override;

private:
  Q_DISABLE_COPY(pqRayTracedGlyphsMenu)
};

#endif
