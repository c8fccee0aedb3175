#include "pqRayTracedGlyphsReference.h"

#include "RayTracedChoices.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDocumentation.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <QLineEdit>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <cstring>

namespace
{
QString WordsOf(vtkSMProperty* property)
{
  vtkSMDocumentation* documentation = property->GetDocumentation();
  const char* first = documentation ? documentation->GetDescription() : nullptr;
  const char* rest = documentation ? documentation->GetLongHelp() : nullptr;
  return (QString(first) + ' ' + rest).simplified().toHtmlEscaped();
}

bool IsShown(vtkSMProperty* property)
{
  const char* shown = property->GetPanelVisibility();
  return !shown || strcmp(shown, "never") != 0;
}

// Pictures of the glyphs of 3D Glyphs' sources and of GlyphShape.
QString Shapes(vtkSMProxy* display)
{
  QStringList names{ "Sphere", "Box", "Cylinder", "Cone", "Arrow" };
  auto* shapes = display->GetProperty("GlyphShape")->FindDomain<vtkSMEnumerationDomain>();
  for (unsigned int i = 1; i < shapes->GetNumberOfEntries(); ++i)
  {
    names << shapes->GetEntryText(i);
  }
  QString table = "<a name='Shapes'></a><h2>Shapes</h2><table cellpadding=4>";
  constexpr int columns = 4;
  for (int i = 0; i < names.size(); ++i)
  {
    table += QString(i % columns == 0 ? "<tr>" : "") +
      QString("<td align='center'><img src=':/RayTracedGlyphs/Shapes/%1.png'><br>%1</td>").arg(names[i]);
  }
  return table + "</table>";
}

// The XML hint of a group of this plugin; null: the group is ParaView's.
vtkPVXMLElement* HintOf(vtkSMPropertyGroup* group)
{
  vtkPVXMLElement* hints = group->GetHints();
  return hints ? hints->FindNestedElementByName("RayTraced") : nullptr;
}

// Displays of all types have the groups.
QString Page()
{
  vtkSMSessionProxyManager* proxies = vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkSMProxy* display = proxies ? proxies->GetPrototypeProxy("representations", "GeometryRepresentation") : nullptr;
  QString index, page;
  for (size_t i = 0; display && i < display->GetNumberOfPropertyGroups(); ++i)
  {
    vtkSMPropertyGroup* group = display->GetPropertyGroup(i);
    vtkPVXMLElement* hint = HintOf(group);
    if (!hint)
    {
      continue;
    }
    const char* title = hint->GetAttribute("title") ? hint->GetAttribute("title") : group->GetXMLLabel();
    index += QString("<p><b>%1</b>: ").arg(title);
    page += QString("<h2>%1</h2><p>%2</p><table cellpadding=4>")
              .arg(title, QString(hint->GetAttribute("meaning")).simplified().toHtmlEscaped());
    QStringList entries;
    for (unsigned int j = 0; j < group->GetNumberOfProperties(); ++j)
    {
      vtkSMProperty* property = group->GetProperty(j);
      if (IsShown(property))
      {
        const QString name = display->GetPropertyName(property);
        vtkSMProperty* own = rtglyphs::RayTracedChoices::GlyphsOf(display)->GetProperty(qPrintable(name));
        property = own ? own : property; // 3D Glyphs describes its properties for itself
        entries << QString("<a href='#%1'>%2</a>").arg(name, property->GetXMLLabel());
        page += QString("<tr><td width='28%'><a name='%1'></a><b>%2</b><br><small>%1</small></td><td>%3</td></tr>")
                  .arg(name, property->GetXMLLabel(), WordsOf(property));
      }
    }
    index += entries.join(", ") + "</p>";
    page += "</table>";
  }
  return display ? "<p><a href='#Shapes'>Shapes</a></p>" + index + Shapes(display) + page : QString();
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
  auto* search = new QLineEdit(this);
  search->setObjectName("Search");
  search->setPlaceholderText(tr("Search; Enter for the next match"));
  search->setClearButtonEnabled(true);
  QObject::connect(search, &QLineEdit::textChanged, browser,
    [browser](const QString& words)
    {
      browser->moveCursor(QTextCursor::Start);
      browser->find(words);
    });
  QObject::connect(search, &QLineEdit::returnPressed, browser, [browser, search]() { browser->find(search->text()); });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search);
  layout->addWidget(browser);
  this->resize(this->fontMetrics().averageCharWidth() * 120, this->fontMetrics().height() * 45);
}
