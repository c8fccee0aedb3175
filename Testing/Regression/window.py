"""For scripts that run inside ParaView's window: its events, mouse and keys, and output that reaches the test.

Environment: RTGLYPHS_WINDOW_PROBE is the library of WindowProbe.cxx.
"""
import ctypes
import os
import re
import time
import traceback


def say(text):
    """ParaView's window catches print(); ctest reads the process's own output."""
    os.write(1, (text + "\n").encode())


def run(name, main):
    """Ends the process with what main() returns: sentences about what has failed. NAME TEST PASSED, or FAILED, is the last line."""
    try:
        failures = main()
    except Exception:  # the window would stay open for ever
        failures = [traceback.format_exc()]
    for failure in failures:
        say("FAILED: %s" % failure)
    say("%s TEST %s" % (name, "FAILED" if failures else "PASSED"))
    os._exit(1 if failures else 0)


class Window:
    """What a user of the window does and sees; widgets are named as ParaView names them."""

    def __init__(self):
        # Events run ParaView's own Python, its trace for one: the interpreter stays locked for this script.
        self.probe = ctypes.PyDLL(os.environ["RTGLYPHS_WINDOW_PROBE"])

    def events(self):
        """Lets the window take its events: scripts run inside one."""
        self.probe.probe_events()

    def click(self, name):
        """Posts a click; False: there is no such widget, or it is disabled."""
        return bool(self.probe.probe_click(name.encode()))

    def hover(self, name, at):
        """Moves the mouse to a pixel of a widget, from its lower left; False: there is no such widget."""
        return bool(self.probe.probe_hover(name.encode(), *at))

    def mouse(self, name, what, at):
        """Posts what the left button does, press, move or release, on a pixel of a widget, from its lower left; False: there is no such widget."""
        return bool(self.probe.probe_mouse(name.encode(), ("press", "move", "release").index(what), *at))

    def drag(self, name, start, end, release=True):
        """Posts a drag with the left button between two pixels of a widget, first sideways and then up or down; False: there is no such widget."""
        moves = ((start[0] + end[0]) // 2, start[1]), (end[0], start[1]), end
        return self.mouse(name, "press", start) and all(self.mouse(name, "move", at) for at in moves) and (
            not release or self.mouse(name, "release", end))

    def right_click(self, name, at):
        """Posts a click with the right button on a pixel of a widget, from its lower left; False: there is no such widget."""
        return bool(self.probe.probe_right_click(name.encode(), *at))

    def menu(self, chosen=""):
        """The entries of the menu that is open, which is closed; one may be chosen."""
        return self._words(self.probe.probe_menu, chosen).splitlines()

    def escape(self, name):
        """Posts the Esc key; False: there is no such widget."""
        return bool(self.probe.probe_escape(name.encode()))

    def type(self, name, letter):
        """Posts a letter; False: there is no such widget."""
        return bool(self.probe.probe_type(name.encode(), letter.encode()))

    def write(self, name, text):
        """Fills a line of text; False: there is no such widget."""
        return bool(self.probe.probe_write(name.encode(), text.encode()))

    def float(self, name):
        """Makes a widget, a toolbar for one, a window of its own; False: there is no such widget."""
        return bool(self.probe.probe_float(name.encode()))

    def enabled(self, name):
        """Whether a visible widget takes input."""
        return bool(self.probe.probe_enabled(name.encode()))

    def visible(self, name):
        """Whether there is such a widget in sight."""
        return bool(self.probe.probe_visible(name.encode()))

    def count(self, name):
        """How many widgets in sight have that name."""
        return self.probe.probe_count(name.encode())

    def checked(self, name):
        """Whether a button is pressed."""
        return bool(self.probe.probe_checked(name.encode()))

    def choose(self, name, entry):
        """Chooses an entry of a combo box; False: there is none."""
        return bool(self.probe.probe_choose(name.encode(), entry.encode()))

    def trigger(self, name):
        """Does what a menu's action does; False: there is none, or it is disabled."""
        return bool(self.probe.probe_trigger(name.encode()))

    def confirm(self):
        """Presses the default button of message boxes from now on."""
        self.probe.probe_confirm()

    def _words(self, function, name):
        """What a function of the probe copies."""
        text = ctypes.create_string_buffer(200000)
        function(name.encode(), text, len(text))
        return text.value.decode()

    def text(self, name):
        """What a label, a button, a line or page of text, a progress bar or a status bar says."""
        return self._words(self.probe.probe_text, name)

    def value(self, name):
        """How far a progress bar is."""
        return self.probe.probe_value(name.encode())

    def tip(self, name):
        """The tool tip of a widget."""
        return self._words(self.probe.probe_tip, name)

    def rows(self, name):
        """The rows of the lists in a widget, which need not be visible, each once."""
        return list(dict.fromkeys(self._words(self.probe.probe_rows, name).splitlines()))

    def labels(self, name, cut=False):
        """The labels of rows and check boxes that a widget shows, from the upper to the lower; only those that are cut off."""
        words = self._words(lambda name, text, size: self.probe.probe_labels(name, cut, text, size), name)
        return [re.sub("<[^>]*>", "", line) for line in words.splitlines()]

    def sideways(self, name):
        """How far a widget, or one in it, can be scrolled sideways, in pixels."""
        return self.probe.probe_sideways(name.encode())

    def resize(self, name, width, height):
        """Gives the window around a widget a size; False: there is no such widget."""
        return bool(self.probe.probe_resize(name.encode(), width, height))

    def picture(self, name, file):
        """Leaves what a widget looks like in a file; False: there is no such widget."""
        return bool(self.probe.probe_picture(name.encode(), file.encode()))

    def wait(self, until, seconds):
        """Handles events until the condition holds; False after that many seconds."""
        end = time.time() + seconds
        while time.time() < end:
            self.events()
            if until():
                return True
            time.sleep(0.002)
        return False
