/**
 * @class   pqRayTracedGlyphsStatistics
 * @brief   what the panel says of the last picture: RenderStatistics in words
 */
#ifndef pqRayTracedGlyphsStatistics_h
#define pqRayTracedGlyphsStatistics_h

#include "pqPropertyWidget.h"

class QLabel;

class pqRayTracedGlyphsStatistics : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString statistics READ statistics WRITE setStatistics)

public:
  pqRayTracedGlyphsStatistics(vtkSMProxy* display, vtkSMProperty* property, QWidget* parent = nullptr);

  QString statistics() const { return this->Statistics; }
  void setStatistics(const QString& json);

Q_SIGNALS:
  void unused(); // read only

private:
  QLabel* Words;
  QString Statistics;
};

#endif
