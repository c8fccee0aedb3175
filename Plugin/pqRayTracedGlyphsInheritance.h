/**
 * @class   pqRayTracedGlyphsInheritance
 * @brief   what is cut out of ray-traced data is shown as these are
 *
 * When Apply first shows a clip, a slice, a threshold or another part of a source that the view shows ray-traced, the
 * part's display takes over representation and settings, and the source is hidden: ParaView does the one with its
 * setting Inherit Representation Properties, but not for shapes and arrays, and the other for surfaces only.
 */
#ifndef pqRayTracedGlyphsInheritance_h
#define pqRayTracedGlyphsInheritance_h

#include <QList>
#include <QObject>
#include <QPointer>

class pqProxy;
class pqRepresentation;

class pqRayTracedGlyphsInheritance : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  ///@{
  /**
   * ParaView calls these when the plugin is loaded and when it ends.
   */
  void startup();
  void shutdown() {}
  ///@}

private:
  void added(pqRepresentation* display);
  void inherit();

  QList<QPointer<pqRepresentation>> Fresh; // made by this Apply
  QList<QPointer<pqProxy>> Applied;
};

#endif
