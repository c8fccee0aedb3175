#include "pqRayTracedGlyphsArray.h"

#include "GlyphShapes.h"
#include "RayTracedChoices.h"
#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMStringListDomain.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <cstring>

namespace
{
const char* const unscaled = "No Data Scaling Off"; // ScaleMode's

bool IsSize(vtkSMProxy* display, vtkSMProperty* property)
{
  return property == display->GetProperty("SelectScaleArray");
}

// The property of that name that ray-traced glyphs have themselves; null: there is none.
vtkSMProperty* OwnOf(vtkSMProxy* display, vtkSMProperty* property)
{
  vtkSMProxy* glyphs = rtglyphs::RayTracedChoices::GlyphsOf(display);
  return glyphs ? glyphs->GetProperty(display->GetPropertyName(property)) : nullptr;
}

// The arrays that 3D Glyphs takes, or, with `own`, those that ray-traced glyphs take.
vtkSMStringListDomain* ArraysOf(vtkSMProxy* display, vtkSMProperty* property, bool own)
{
  vtkSMProperty* listed = own ? OwnOf(display, property) : property;
  return listed ? listed->FindDomain<vtkSMStringListDomain>() : nullptr;
}

// Whose vectors are what they show, whatever Orient is.
bool IsVector(vtkSMProxy* display)
{
  return rtglyphs::GlyphShapes::IsVector(vtkSMPropertyHelper(display, "GlyphShape").GetAsInt());
}
}

//----------------------------------------------------------------------------
pqRayTracedGlyphsArray::pqRayTracedGlyphsArray(vtkSMProxy* display, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(display, parent)
  , Arrays(new QComboBox(this))
{
  this->Arrays->setObjectName("ComboBox");
  this->Arrays->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->setProperty(property);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Arrays);
  for (const bool own : { false, true })
  {
    if (auto* arrays = ArraysOf(display, property, own))
    {
      pqCoreUtilities::connect(arrays, vtkCommand::DomainModifiedEvent, this, SLOT(list()));
    }
  }
  pqCoreUtilities::connect(display->GetProperty("Representation"), vtkCommand::ModifiedEvent, this, SLOT(list()));
  QObject::connect(this->Arrays, QOverload<int>::of(&QComboBox::activated), this, &pqRayTracedGlyphsArray::choose);
  QObject::connect(this, &pqRayTracedGlyphsArray::linked, this, &pqRayTracedGlyphsArray::Show);
  this->addPropertyLink(this, "array", SIGNAL(chosen()), property);
  if (IsSize(display, property))
  {
    this->addPropertyLink(this, "mode", SIGNAL(chosen()), display->GetProperty("ScaleMode"));
    this->addPropertyLink(this, "on", SIGNAL(chosen()), display->GetProperty("Scaling"));
  }
  else
  {
    this->addPropertyLink(this, "on", SIGNAL(chosen()), display->GetProperty("Orient"));
    pqCoreUtilities::connect(display->GetProperty("GlyphShape"), vtkCommand::ModifiedEvent, this, SLOT(list()));
  }
  this->list();
}

//----------------------------------------------------------------------------
// The first entry is None in any translation.
void pqRayTracedGlyphsArray::list()
{
  this->Arrays->clear();
  this->Arrays->addItem(tr("None"));
  const bool own = rtglyphs::RayTracedChoices::ShowsGlyphs(this->proxy());
  auto* arrays = ArraysOf(this->proxy(), this->property(), own);
  for (unsigned int i = 0; arrays && i < arrays->GetNumberOfStrings(); ++i)
  {
    const char* name = arrays->GetString(i);
    const char* none = arrays->GetNoneString();
    if (!none || strcmp(name, none) != 0)
    {
      this->Arrays->addItem(name);
    }
  }
  this->Show();
}

//----------------------------------------------------------------------------
// An array that the data lack is listed as long as it is chosen.
void pqRayTracedGlyphsArray::Show()
{
  const bool on = this->On || (!IsSize(this->proxy(), this->property()) && IsVector(this->proxy()));
  const bool used = on && this->Mode != unscaled && !this->Array.isEmpty() && this->Array != "None";
  int entry = used ? this->Arrays->findText(this->Array) : 0;
  if (entry < 0)
  {
    entry = this->Arrays->count();
    this->Arrays->addItem(this->Array);
  }
  this->Arrays->setCurrentIndex(entry);
}

//----------------------------------------------------------------------------
// Without an array sizes are one, ScaleFactor's, and directions are off, or there are no vectors.
void pqRayTracedGlyphsArray::choose(int entry)
{
  const bool used = entry > 0, size = IsSize(this->proxy(), this->property());
  this->On = used || (size && this->On);
  if (used || (!size && IsVector(this->proxy())))
  {
    this->Array = used ? this->Arrays->itemText(entry) : "None";
  }
  if (size && (!used || this->Mode == unscaled))
  {
    this->Mode = used ? "Magnitude" : unscaled;
  }
  Q_EMIT this->chosen();
}

//----------------------------------------------------------------------------
// ParaView labels and describes a row as its property, which is 3D Glyphs' here.
void pqRayTracedGlyphsArray::showEvent(QShowEvent* event)
{
  this->pqPropertyWidget::showEvent(event);
  vtkSMProperty* own = OwnOf(this->proxy(), this->property());
  this->setToolTip(pqPropertyWidget::getTooltip(own ? own : this->property()));
  auto* rows = qobject_cast<QGridLayout*>(this->parentWidget()->layout());
  int row = 0, column = 0, height = 0, width = 0;
  if (rows && rows->indexOf(this) >= 0)
  {
    rows->getItemPosition(rows->indexOf(this), &row, &column, &height, &width);
    QLayoutItem* first = column > 0 ? rows->itemAtPosition(row, 0) : nullptr;
    if (auto* label = first ? qobject_cast<QLabel*>(first->widget()) : nullptr)
    {
      label->setText(IsSize(this->proxy(), this->property()) ? tr("Size By") : tr("Direction By"));
    }
  }
}
