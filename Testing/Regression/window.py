"""For scripts that run inside ParaView's window: its events, mouse and keys, and output that reaches the test.

Environment: RTGLYPHS_WINDOW_PROBE is the library of WindowProbe.cxx.
"""
import ctypes
import os
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
        self.probe = ctypes.CDLL(os.environ["RTGLYPHS_WINDOW_PROBE"])

    def events(self):
        """Lets the window take its events: scripts run inside one."""
        self.probe.probe_events()

    def click(self, name):
        """Posts a click; False: there is no such widget, or it is disabled."""
        return bool(self.probe.probe_click(name.encode()))

    def escape(self, name):
        """Posts the Esc key; False: there is no such widget."""
        return bool(self.probe.probe_escape(name.encode()))

    def enabled(self, name):
        """Whether a visible widget takes input."""
        return bool(self.probe.probe_enabled(name.encode()))

    def text(self, name):
        """What a label says."""
        text = ctypes.create_string_buffer(200)
        self.probe.probe_text(name.encode(), text, len(text))
        return text.value.decode()

    def wait(self, until, seconds):
        """Handles events until the condition holds; False after that many seconds."""
        end = time.time() + seconds
        while time.time() < end:
            self.events()
            if until():
                return True
            time.sleep(0.002)
        return False
