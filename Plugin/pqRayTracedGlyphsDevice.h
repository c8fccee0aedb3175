/**
 * @class   pqRayTracedGlyphsDevice
 * @brief   says once, when ParaView's window has started, which Vulkan device will trace or what is missing, here or on
 * a server
 *
 * A device is plain information among ParaView's output messages; that there is none is a warning, and so is a server
 * without the plugin.
 */
#ifndef pqRayTracedGlyphsDevice_h
#define pqRayTracedGlyphsDevice_h

#include <QObject>

class pqRayTracedGlyphsDevice : public QObject
{
  Q_OBJECT

public:
  pqRayTracedGlyphsDevice(QObject* parent = nullptr);
  ~pqRayTracedGlyphsDevice() override;

  void startup();
  void shutdown();

private:
  Q_DISABLE_COPY(pqRayTracedGlyphsDevice)
};

#endif
