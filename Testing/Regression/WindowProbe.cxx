// A user of ParaView's window, for scripts that run inside it (window.py): mouse and keys at widgets that are found by
// their names, what they say and show, and time for the window's events. Events are posted, as those of a window system
// are, and take the way through ParaView's filters.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCursor>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QString>
#include <QTextEdit>
#include <QTimer>
#include <QWidget>
#include <QWindow>

#include <algorithm>
#include <cstring>

// As QTest has them, which tests of windows would otherwise need for these alone.
Q_GUI_EXPORT bool qt_sendShortcutOverrideEvent(QObject* to, ulong time, int key, Qt::KeyboardModifiers modifiers,
  const QString& text = QString(), bool repeated = false, ushort count = 1);
Q_GUI_EXPORT void qt_handleMouseEvent(QWindow* window, const QPointF& at, const QPointF& onScreen,
  Qt::MouseButtons buttons, Qt::MouseButton button, QEvent::Type type, Qt::KeyboardModifiers modifiers, int time);

namespace
{
// The first visible widget of that name; "OUTER/NAME": inside one called OUTER. Null: there is none. Where it can be
// scrolled into sight it is.
QWidget* Find(const char* path)
{
  const QString name = QString(path).section('/', -1), outer = QString(path).section('/', -2, -2);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // rows may be about to move
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

void PostMouse(
  QWindow* window, QEvent::Type type, QPoint at, Qt::MouseButtons buttons, Qt::MouseButton button = Qt::LeftButton)
{
  const auto happens = [=]()
  {
    static int time = 0;
    qt_handleMouseEvent(window, at, window->mapToGlobal(at), buttons, type == QEvent::MouseMove ? Qt::NoButton : button,
      type, Qt::NoModifier, time += 1000); // no two clicks are a double click
  };
  QMetaObject::invokeMethod(window, happens, Qt::QueuedConnection);
}
}

extern "C"
{
  Q_DECL_EXPORT void probe_events()
  {
    QCoreApplication::processEvents();
  }

  // 1: a click is on its way to the middle of what is seen of the widget.
  Q_DECL_EXPORT int probe_click(const char* name)
  {
    const QWidget* widget = Find(name);
    QWindow* window = widget ? widget->window()->windowHandle() : nullptr;
    if (!window || !widget->isEnabled())
    {
      return 0;
    }
    QRect rect = widget->rect();
    if (qobject_cast<const QAbstractButton*>(widget))
    {
      rect.setWidth(std::min(rect.width(), widget->sizeHint().width())); // beside a check box's words is nothing
    }
    const QRect seen = rect & widget->visibleRegion().boundingRect(); // wide panels are scrolled sideways
    const QPoint at = widget->mapTo(widget->window(), (seen.isEmpty() ? rect : seen).center());
    PostMouse(window, QEvent::MouseButtonPress, at, Qt::LeftButton);
    PostMouse(window, QEvent::MouseButtonRelease, at, Qt::NoButton);
    return 1;
  }

  // 1: the mouse is on its way to a place in the widget, in pixels from its lower left corner. ParaView asks the
  // display where it is, so it is moved there.
  Q_DECL_EXPORT int probe_hover(const char* name, int x, int y)
  {
    const QWidget* widget = Find(name);
    if (!widget)
    {
      return 0;
    }
    QCursor::setPos(widget->mapToGlobal(QPoint(x, widget->height() - 1 - y)));
    return 1;
  }

  // 1: what the left button does is on its way to a place in the widget, in pixels from its lower left corner.
  // `what`: 0 it is pressed, 1 the mouse is moved with it down, 2 it is released.
  Q_DECL_EXPORT int probe_mouse(const char* name, int what, int x, int y)
  {
    const QWidget* widget = Find(name);
    QWindow* window = widget ? widget->window()->windowHandle() : nullptr;
    if (!window)
    {
      return 0;
    }
    constexpr QEvent::Type types[] = { QEvent::MouseButtonPress, QEvent::MouseMove, QEvent::MouseButtonRelease };
    PostMouse(window, types[what], widget->mapTo(widget->window(), QPoint(x, widget->height() - 1 - y)),
      what == 2 ? Qt::NoButton : Qt::LeftButton);
    return 1;
  }

  // 1: a click of the right button is on its way to a place in the widget, in pixels from its lower left corner.
  Q_DECL_EXPORT int probe_right_click(const char* name, int x, int y)
  {
    const QWidget* widget = Find(name);
    QWindow* window = widget ? widget->window()->windowHandle() : nullptr;
    if (!window)
    {
      return 0;
    }
    const QPoint at = widget->mapTo(widget->window(), QPoint(x, widget->height() - 1 - y));
    PostMouse(window, QEvent::MouseButtonPress, at, Qt::RightButton, Qt::RightButton);
    PostMouse(window, QEvent::MouseButtonRelease, at, Qt::NoButton, Qt::RightButton);
    return 1;
  }

  // The entries of the menu that is open, a line each; copied as below. The menu is closed, one of that name
  // chosen.
  Q_DECL_EXPORT void probe_menu(const char* chosen, char* text, int size)
  {
    QString said;
    if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget()))
    {
      for (QAction* action : menu->actions())
      {
        said += action->text() + '\n';
        if (action->text() == chosen)
        {
          QMetaObject::invokeMethod(action, "trigger", Qt::QueuedConnection);
        }
      }
      menu->close();
    }
    std::strncpy(text, said.toUtf8().constData(), size - 1);
    text[size - 1] = 0;
  }

  // 1: Esc is pressed, as if the widget had the focus: shortcuts come first.
  Q_DECL_EXPORT int probe_escape(const char* name)
  {
    QWidget* widget = Find(name);
    if (!widget)
    {
      return 0;
    }
    QApplication::setActiveWindow(widget->window()); // a display without window manager has none
    if (qt_sendShortcutOverrideEvent(widget, 0, Qt::Key_Escape, Qt::NoModifier))
    {
      return 1;
    }
    QCoreApplication::postEvent(widget, new QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier));
    QCoreApplication::postEvent(widget, new QKeyEvent(QEvent::KeyRelease, Qt::Key_Escape, Qt::NoModifier));
    return 1;
  }

  // 1: a letter is on its way to the widget.
  Q_DECL_EXPORT int probe_type(const char* name, const char* letter)
  {
    QWidget* widget = Find(name);
    if (!widget)
    {
      return 0;
    }
    for (const QEvent::Type type : { QEvent::KeyPress, QEvent::KeyRelease })
    {
      QCoreApplication::postEvent(
        widget, new QKeyEvent(type, QString(letter).toUpper().at(0).unicode(), Qt::NoModifier, letter));
    }
    return 1;
  }

  // 1: a line of text says that.
  Q_DECL_EXPORT int probe_write(const char* name, const char* text)
  {
    auto* line = qobject_cast<QLineEdit*>(Find(name));
    return line && (line->setText(text), true);
  }

  // 1: the widget, a toolbar for one, is a window of its own.
  Q_DECL_EXPORT int probe_float(const char* name)
  {
    QWidget* widget = Find(name);
    return widget && (widget->setWindowFlag(Qt::Tool), widget->show(), true);
  }

  Q_DECL_EXPORT int probe_enabled(const char* name)
  {
    const QWidget* widget = Find(name);
    return widget && widget->isEnabled();
  }

  Q_DECL_EXPORT int probe_visible(const char* name)
  {
    return Find(name) != nullptr;
  }

  // How many visible widgets have that name.
  Q_DECL_EXPORT int probe_count(const char* name)
  {
    const QWidgetList all = QApplication::allWidgets();
    return static_cast<int>(std::count_if(all.begin(), all.end(),
      [name](const QWidget* widget) { return widget->objectName() == name && widget->isVisible(); }));
  }

  Q_DECL_EXPORT int probe_checked(const char* name)
  {
    const auto* button = qobject_cast<QAbstractButton*>(Find(name));
    return button && button->isChecked();
  }

  // Presses the default button of message boxes that come up from now on.
  Q_DECL_EXPORT void probe_confirm()
  {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer,
      []()
      {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box && box->defaultButton())
        {
          box->defaultButton()->click();
        }
        else if (box)
        {
          box->accept();
        }
      });
    timer->start(200);
  }

  // 1: the entry of a combo box is on its way to be chosen, which must be enabled.
  Q_DECL_EXPORT int probe_choose(const char* name, const char* entry)
  {
    auto* box = qobject_cast<QComboBox*>(Find(name));
    const int index = box ? box->findText(entry) : -1;
    if (index < 0 || !(box->model()->flags(box->model()->index(index, 0)) & Qt::ItemIsEnabled))
    {
      return 0;
    }
    box->setCurrentIndex(index);
    return QMetaObject::invokeMethod(box, "activated", Qt::QueuedConnection, Q_ARG(int, index));
  }

  // 1: a menu's action is on its way.
  Q_DECL_EXPORT int probe_trigger(const char* name)
  {
    // Menus that are closed have actions of the same names, which are never disabled.
    QList<QAction*> actions;
    for (QWidget* window : QApplication::topLevelWidgets())
    {
      actions += window->inherits("QMainWindow") ? window->findChildren<QAction*>(name) : QList<QAction*>();
    }
    const auto enabled =
      std::find_if(actions.begin(), actions.end(), [](QAction* action) { return action->isEnabled(); });
    return enabled != actions.end() && QMetaObject::invokeMethod(*enabled, "trigger", Qt::QueuedConnection);
  }

  // What a label, a button, a line or page of text, a progress bar or a status bar says; copied, at most `size`
  // characters with the 0 at the end.
  Q_DECL_EXPORT void probe_text(const char* name, char* text, int size)
  {
    const QWidget* widget = Find(name);
    QString said;
    if (const auto* label = qobject_cast<const QLabel*>(widget))
    {
      said = label->text();
    }
    else if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
    {
      said = button->text();
    }
    else if (const auto* line = qobject_cast<const QLineEdit*>(widget))
    {
      said = line->text();
    }
    else if (const auto* page = qobject_cast<const QTextEdit*>(widget))
    {
      said = page->toPlainText();
    }
    else if (const auto* bar = qobject_cast<const QProgressBar*>(widget))
    {
      said = bar->text();
    }
    else if (const auto* status = qobject_cast<const QStatusBar*>(widget))
    {
      said = status->currentMessage();
    }
    std::strncpy(text, said.toUtf8().constData(), size - 1);
    text[size - 1] = 0;
  }

  // How far a progress bar is; -1: there is none.
  Q_DECL_EXPORT int probe_value(const char* name)
  {
    const auto* bar = qobject_cast<QProgressBar*>(Find(name));
    return bar ? bar->value() : -1;
  }

  // The tool tip of a widget; copied as above.
  Q_DECL_EXPORT void probe_tip(const char* name, char* text, int size)
  {
    const QWidget* widget = Find(name);
    std::strncpy(text, widget ? widget->toolTip().toUtf8().constData() : "", size - 1);
    text[size - 1] = 0;
  }

  // The rows of all lists in a widget, which need not be visible, a line each; copied as above.
  Q_DECL_EXPORT void probe_rows(const char* name, char* text, int size)
  {
    QString said;
    for (QWidget* widget : QApplication::allWidgets())
    {
      for (const auto* list :
        widget->objectName() == name ? widget->findChildren<QAbstractItemView*>() : QList<QAbstractItemView*>())
      {
        const QAbstractItemModel* rows = list->model();
        for (int row = 0; rows && row < rows->rowCount(); ++row)
        {
          said += rows->index(row, 0).data().toString() + '\n';
        }
      }
    }
    std::strncpy(text, said.toUtf8().constData(), size - 1);
    text[size - 1] = 0;
  }

  // How many pixels a widget is wider than what is seen of it: the longest way that it can be scrolled sideways.
  Q_DECL_EXPORT int probe_sideways(const char* name)
  {
    const QWidget* widget = Find(name);
    int pixels = 0;
    for (const auto* area : widget ? widget->findChildren<QAbstractScrollArea*>() : QList<QAbstractScrollArea*>())
    {
      pixels = area->isVisible() ? std::max(pixels, area->horizontalScrollBar()->maximum()) : pixels;
    }
    return pixels;
  }

  // The labels of the rows that a widget shows, and what its check boxes say, from the upper to the lower, a line each;
  // copied as above. Only those that are cut off: a word is wider than its label, or there are more lines than room.
  Q_DECL_EXPORT void probe_labels(const char* name, int cut, char* text, int size)
  {
    QMap<int, QString> labels;
    const QWidget* outer = Find(name);
    for (QWidget* widget : outer ? outer->findChildren<QWidget*>() : QList<QWidget*>())
    {
      const auto* label = qobject_cast<QLabel*>(widget);
      const auto* box = qobject_cast<QCheckBox*>(widget);
      const QString words = label ? label->text() : box ? box->text() : QString();
      const bool fits = !label || !label->wordWrap() ? widget->width() >= widget->sizeHint().width()
                                                     : widget->width() >= label->minimumSizeHint().width() &&
          widget->height() >= label->heightForWidth(widget->width());
      if (widget->isVisible() && !words.isEmpty() && !(cut && fits))
      {
        labels.insert(widget->mapTo(outer, QPoint(0, 0)).y() * 4096 + widget->mapTo(outer, QPoint(0, 0)).x(), words);
      }
    }
    const QString said = labels.values().join('\n');
    std::strncpy(text, said.toUtf8().constData(), size - 1);
    text[size - 1] = 0;
  }

  // 1: the window around a widget has that size.
  Q_DECL_EXPORT int probe_resize(const char* name, int width, int height)
  {
    const QWidget* widget = Find(name);
    if (!widget)
    {
      return 0;
    }
    widget->window()->resize(width, height);
    return 1;
  }

  // 1: what a widget looks like is in the file.
  Q_DECL_EXPORT int probe_picture(const char* name, const char* file)
  {
    QWidget* widget = Find(name);
    return widget && widget->grab().save(file);
  }
}
