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
// A server without the plugin has no such representations, and ParaView does not say why. Those who load it there when
// a server is connected come first.
void CheckServer(pqServer* server)
{
  QTimer::singleShot(0, server,
    [server]()
    {
      if (!server->proxyManager()->GetProxyDefinitionManager()->HasDefinition(
            "representations", "RayTracedRepresentation"))
      {
        const std::string words = "Ray Traced Glyphs: the server " + server->getResource().toURI().toStdString() +
          " has not loaded the plugin RayTracedGlyphs, so data there cannot be shown with it. Load it on the server, "
          "too: Tools > Manage Plugins, Remote Plugins.\n";
        vtkOutputWindow::GetInstance()->DisplayWarningText(words.c_str());
      }
    });
}
}

//----------------------------------------------------------------------------
// Plugins are loaded before the window is shown, and drivers take some tenths of a second: events come first. What is
// missing is said when something is to be drawn, which a server may do.
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
    });
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::serverAdded, this, &CheckServer);
  for (pqServer* server : model->findItems<pqServer*>())
  {
    CheckServer(server);
  }
}
