// A user of ParaView's window, for scripts that run inside it (window.py): mouse and keys at widgets that are found by
// their names, what a label says, and time for the window's events. Events are posted, as those of a window system are,
// and take the way through ParaView's filters.
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QString>
#include <QWidget>
#include <QWindow>

#include <cstring>

namespace
{
// The first visible widget of that name; "OUTER/NAME": inside one called OUTER. Null: there is none. Where it can be
// scrolled into sight it is.
QWidget* Find(const char* path)
{
  const QString name = QString(path).section('/', -1), outer = QString(path).section('/', -2, -2);
  for (QWidget* widget : QApplication::allWidgets())
  {
    bool inside = outer.isEmpty();
    QScrollArea* scroll = nullptr;
    for (QWidget* around = widget->parentWidget(); around; around = around->parentWidget())
    {
      inside = inside || around->objectName() == outer;
      scroll = scroll ? scroll : qobject_cast<QScrollArea*>(around);
    }
    if (inside && widget->objectName() == name && widget->isVisible())
    {
      if (scroll)
      {
        scroll->ensureWidgetVisible(widget);
      }
      return widget;
    }
  }
  return nullptr;
}

void PostMouse(QWindow* window, QEvent::Type type, QPoint at, Qt::MouseButtons buttons)
{
  QCoreApplication::postEvent(
    window, new QMouseEvent(type, at, window->mapToGlobal(at), Qt::LeftButton, buttons, Qt::NoModifier));
}
}

extern "C"
{
  Q_DECL_EXPORT void probe_events()
  {
    QCoreApplication::processEvents();
  }

  // 1: a click is on its way to the middle of the widget.
  Q_DECL_EXPORT int probe_click(const char* name)
  {
    const QWidget* widget = Find(name);
    QWindow* window = widget ? widget->window()->windowHandle() : nullptr;
    if (!window || !widget->isEnabled())
    {
      return 0;
    }
    const QPoint at = widget->mapTo(widget->window(), widget->rect().center());
    PostMouse(window, QEvent::MouseButtonPress, at, Qt::LeftButton);
    PostMouse(window, QEvent::MouseButtonRelease, at, Qt::NoButton);
    return 1;
  }

  // 1: Esc is on its way to the widget, as if that had the focus.
  Q_DECL_EXPORT int probe_escape(const char* name)
  {
    QWidget* widget = Find(name);
    if (!widget)
    {
      return 0;
    }
    QCoreApplication::postEvent(widget, new QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier));
    QCoreApplication::postEvent(widget, new QKeyEvent(QEvent::KeyRelease, Qt::Key_Escape, Qt::NoModifier));
    return 1;
  }

  Q_DECL_EXPORT int probe_enabled(const char* name)
  {
    const QWidget* widget = Find(name);
    return widget && widget->isEnabled();
  }

  // What a label says; copied, at most `size` characters with the 0 at the end.
  Q_DECL_EXPORT void probe_text(const char* name, char* text, int size)
  {
    const auto* label = qobject_cast<QLabel*>(Find(name));
    std::strncpy(text, label ? label->text().toUtf8().constData() : "", size - 1);
    text[size - 1] = 0;
  }
}
