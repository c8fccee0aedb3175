/**
 * @class   pqRayTracedGlyphsDevice
 * @brief   says once, when ParaView's window has started, which Vulkan device will trace, and when a server lacks the
 * plugin
 *
 * A device is plain information among ParaView's output messages; a server without the plugin is a warning.
 */
#ifndef pqRayTracedGlyphsDevice_h
#define pqRayTracedGlyphsDevice_h

#include <QObject>

class pqRayTracedGlyphsDevice : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  void startup();
  void shutdown() {}
};

#endif
