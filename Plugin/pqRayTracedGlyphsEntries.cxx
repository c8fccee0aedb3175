#include "pqRayTracedGlyphsEntries.h"

#include "pqCoreUtilities.h"
#include "pqPropertyWidget.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRayTracedArrayListDomain.h"

#include <QComboBox>
#include <QStandardItemModel>
#include <QStringList>

//----------------------------------------------------------------------------
pqRayTracedGlyphsEntries::pqRayTracedGlyphsEntries(vtkPVXMLElement* xml, pqPropertyWidget* row)
  : pqPropertyWidgetDecorator(xml, row)
{
  pqCoreUtilities::connect(row->proxy()->GetProperty("GlyphShape"), vtkCommand::ModifiedEvent, this, SLOT(enable()));
  pqCoreUtilities::connect(
    row->proxy()->GetProperty("GlyphTensorArray"), vtkCommand::ModifiedEvent, this, SIGNAL(visibilityChanged()));
  this->enable();
}

//----------------------------------------------------------------------------
// As long as there is no array any one may come.
bool pqRayTracedGlyphsEntries::canShowWidget(bool) const
{
  const QStringList numbers = QString(this->xml()->GetAttribute("components")).split(' ');
  vtkSMProperty* tensors = this->parentWidget()->proxy()->GetProperty("GlyphTensorArray");
  auto* listed = tensors->FindDomain<vtkSMRayTracedArrayListDomain>();
  using Array = vtkSMRayTracedArrayListDomain::Array;
  const Array array =
    listed && !numbers[0].isEmpty() ? listed->Find(vtkSMPropertyHelper(tensors).GetAsString()) : Array();
  const bool named = array.HasTensorNames || !array.Columns.empty();
  return !array || (numbers.contains(QString::number(array.Components)) && (array.Components > 6 || !named));
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsEntries::enable()
{
  const pqPropertyWidget* row = this->parentWidget();
  const QString shape = QString::number(vtkSMPropertyHelper(row->proxy(), "GlyphShape").GetAsInt());
  QStringList used;
  for (unsigned int i = 0; i < this->xml()->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* shapes = this->xml()->GetNestedElement(i);
    if (QString(shapes->GetAttribute("values")).split(' ').contains(shape))
    {
      used = QString(shapes->GetAttribute("entries")).split(' ');
    }
  }
  auto* list = row->findChild<QComboBox*>();
  auto* entries = list ? qobject_cast<QStandardItemModel*>(list->model()) : nullptr;
  auto* domain = row->property()->FindDomain<vtkSMEnumerationDomain>();
  for (int i = 0; entries && domain && i < list->count(); ++i)
  {
    entries->item(i)->setEnabled(used.isEmpty() || used.contains(QString::number(domain->GetEntryValue(i))));
  }
}
