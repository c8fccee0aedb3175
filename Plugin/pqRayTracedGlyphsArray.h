/**
 * @class   pqRayTracedGlyphsArray
 * @brief   one row of the panel for an array and whether it is used
 *
 * 3D Glyphs' properties of size are a tick (Scaling), a mode (ScaleMode) and an array (SelectScaleArray), those of
 * direction a tick (Orient) and an array (SelectOrientationVectors). The row Size By, or Direction By, says None where
 * tick or mode leave the array unused; choosing an array sets all of them.
 */
#ifndef pqRayTracedGlyphsArray_h
#define pqRayTracedGlyphsArray_h

#include "pqPropertyWidget.h"

class QComboBox;

class pqRayTracedGlyphsArray : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString array READ array WRITE setArray)
  Q_PROPERTY(QString mode READ mode WRITE setMode)
  Q_PROPERTY(bool on READ isOn WRITE setOn)

public:
  pqRayTracedGlyphsArray(vtkSMProxy* display, vtkSMProperty* property, QWidget* parent = nullptr);

  QString array() const { return this->Array; }
  void setArray(const QString& array);
  QString mode() const { return this->Mode; }
  void setMode(const QString& mode);
  bool isOn() const { return this->On; }
  void setOn(bool on);

Q_SIGNALS:
  void chosen();

protected:
  void showEvent(QShowEvent* event) override;

private Q_SLOTS:
  void list();
  void choose(int entry);

private: // NOLINT(readability-redundant-access-specifiers)
  void Show();

  QComboBox* Arrays;
  QString Array, Mode; // no mode: directions have none
  bool On = false;
};

#endif
