#include "pqRayTracedGlyphsDevice.h"

#include "pqApplicationCore.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqServerResource.h"
#include "vtkOutputWindow.h"
#include "vtkRayTracedView.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMSessionProxyManager.h"

#include <QTimer>

#include <string>

namespace
{
void Warn(const std::string& words)
{
  vtkOutputWindow::GetInstance()->DisplayWarningText((words + "\n").c_str());
}

// A server without the plugin has no such representations, and ParaView does not say why. Those who load it there when
// a server is connected come first.
void CheckServer(pqServer* server)
{
  QTimer::singleShot(0, server,
    [server]()
    {
      if (!server->proxyManager()->GetProxyDefinitionManager()->HasDefinition(
            "representations", "RayTracedGlyphRepresentation"))
      {
        Warn("Ray Traced Glyphs: the server " + server->getResource().toURI().toStdString() +
          " has not loaded the plugin RayTracedGlyphs, so data there cannot be shown with it. Load it on the server, "
          "too: "
          "Tools > Manage Plugins, Remote Plugins.");
      }
    });
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsDevice::pqRayTracedGlyphsDevice(QObject* parent)
  : QObject(parent)
{
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsDevice::~pqRayTracedGlyphsDevice() = default;

//----------------------------------------------------------------------------
// Plugins are loaded before the window is shown, and drivers take some tenths of a second: events come first.
void pqRayTracedGlyphsDevice::startup()
{
  QTimer::singleShot(0, this,
    []()
    {
      std::string words;
      if (vtkRayTracedView::FindDevice(words))
      {
        vtkOutputWindow::GetInstance()->DisplayText((words + "\n").c_str());
      }
      else
      {
        Warn(words);
      }
    });
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::serverAdded, this, &CheckServer);
  for (pqServer* server : model->findItems<pqServer*>())
  {
    CheckServer(server);
  }
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsDevice::shutdown() {}
