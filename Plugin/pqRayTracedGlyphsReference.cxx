#include "pqRayTracedGlyphsReference.h"

#include "vtkPVXMLElement.h"
#include "vtkSMDocumentation.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <QTextBrowser>
#include <QVBoxLayout>

#include <cstring>

namespace
{
QString WordsOf(vtkSMProperty* property)
{
  vtkSMDocumentation* documentation = property->GetDocumentation();
  const char* words = documentation ? documentation->GetDescription() : nullptr;
  return QString(words).simplified().toHtmlEscaped();
}

// What a group of this plugin means; null: it is of somebody else.
const char* MeaningOf(vtkSMPropertyGroup* group)
{
  vtkPVXMLElement* hints = group->GetHints();
  vtkPVXMLElement* ours = hints ? hints->FindNestedElementByName("RayTraced") : nullptr;
  return ours ? ours->GetAttribute("meaning") : nullptr;
}

// Displays of all types have the groups.
QString Page()
{
  vtkSMSessionProxyManager* proxies = vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkSMProxy* display = proxies ? proxies->GetPrototypeProxy("representations", "GeometryRepresentation") : nullptr;
  QString page;
  for (size_t i = 0; display && i < display->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = display->GetPropertyGroup(i);
    const char* meaning = MeaningOf(group);
    if (!meaning)
    {
      continue;
    }
    page +=
      QString("<h2>%1</h2><p>%2</p><table cellpadding=4>").arg(group->GetXMLLabel(), QString(meaning).toHtmlEscaped());
    for (unsigned int j = 0; j < group->GetNumberOfProperties(); ++j)
    {
      vtkSMProperty* property = group->GetProperty(j);
      const char* shown = property->GetPanelVisibility();
      if (shown && strcmp(shown, "never") == 0)
      {
        continue;
      }
      page += QString("<tr><td><b>%1</b><br><small>%2</small></td><td>%3</td></tr>")
                .arg(property->GetXMLLabel(), display->GetPropertyName(property), WordsOf(property));
    }
    page += "</table>";
  }
  return page;
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsReference::pqRayTracedGlyphsReference(QWidget* parent)
  : QDialog(parent)
{
  this->setObjectName("RayTracedGlyphsReference");
  this->setWindowTitle(tr("Properties of Ray Traced Glyphs"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  auto* browser = new QTextBrowser(this);
  browser->setObjectName("Page");
  browser->setHtml(Page());
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(browser);
  this->resize(this->fontMetrics().averageCharWidth() * 120, this->fontMetrics().height() * 45);
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsReference::~pqRayTracedGlyphsReference() = default;
