/**
 * @class   pqRayTracedGlyphsMenu
 * @brief   "Add Surface", "Focus Lens Here" and "Lens Off" in the menu of a click with the right button
 *
 * ParaView has one display of a source in a view, so that its surface beside its glyphs is the display of a filter,
 * Extract Surface, as Ray Traced Surface.
 *
 * The lens is that of ParaView's camera, CameraFocalDistance and CameraFocalDisk of the view.
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
  using QObject::QObject;

  bool contextMenu(QMenu* menu, pqView* view, const QPoint& place, pqRepresentation* display,
    const QList<unsigned int>& blocks) const override;
};

#endif
