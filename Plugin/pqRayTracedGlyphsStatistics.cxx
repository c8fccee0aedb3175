#include "pqRayTracedGlyphsStatistics.h"

#include "vtkSMProperty.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

//----------------------------------------------------------------------------
pqRayTracedGlyphsStatistics::pqRayTracedGlyphsStatistics(vtkSMProxy* display, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(display, parent)
  , Words(new QLabel(this))
{
  this->setProperty(property);
  this->setShowLabel(false); // the section's title says it
  this->Words->setObjectName("Words");
  this->Words->setWordWrap(true);
  this->Words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Words);
  this->addPropertyLink(this, "statistics", SIGNAL(unused()), property);
}

//----------------------------------------------------------------------------
void pqRayTracedGlyphsStatistics::setStatistics(const QString& json)
{
  this->Statistics = json;
  const QJsonObject numbers = QJsonDocument::fromJson(json.toUtf8()).object();
  const auto number = [&](const char* name) { return QLocale().toString(numbers.value(name).toDouble(), 'f', 0); };
  QStringList choices;
  for (const QJsonValue& sentence : numbers.value("choices").toArray())
  {
    choices.append(sentence.toString() + "\n");
  }
  this->Words->setText(numbers.isEmpty() ? tr("No picture yet")
                                         : choices.join("") +
        tr("%1\nSamples per pixel: %2\nGlyphs: %3\nDevice memory: %4")
          .arg(numbers.value("DeviceName").toString(), number("AccumulatedSamples"), number("glyphs"),
            QLocale().formattedDataSize(static_cast<qint64>(numbers.value("deviceBytes").toDouble()))));
}
