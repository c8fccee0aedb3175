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
  Q_PROPERTY(QString array MEMBER Array NOTIFY linked)
  Q_PROPERTY(QString mode MEMBER Mode NOTIFY linked)
  Q_PROPERTY(bool on MEMBER On NOTIFY linked)

public:
  pqRayTracedGlyphsArray(vtkSMProxy* display, vtkSMProperty* property, QWidget* parent = nullptr);

Q_SIGNALS:
  void chosen(); // by the user
  void linked(); // a value has come from the display

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
