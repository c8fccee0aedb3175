#include "pqRayTracedGlyphsDevice.h"

#include "vtkOutputWindow.h"
#include "vtkRayTracedView.h"

#include <QTimer>

#include <string>

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
        vtkOutputWindow::GetInstance()->DisplayWarningText((words + "\n").c_str());
      }
    });
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsDevice::shutdown() {}
