"""For scripts that run inside ParaView's window: its events, and output that reaches the test."""
import ctypes
import os
import re
import time


def say(text):
    """ParaView's window catches print(); ctest reads the process's own output."""
    os.write(1, (text + "\n").encode())


def event_loop():
    """A function that lets the window take its events: scripts run inside one."""
    # Only the library that the window uses: another version may be installed as well.
    with open("/proc/self/maps", encoding="utf-8") as maps:
        loaded = re.search(r"/\S*libQt[56]Core\.so\.[56]\S*", maps.read())
    if loaded:
        process = ctypes.CDLL(loaded.group(), mode=ctypes.RTLD_GLOBAL)[
            "_ZN16QCoreApplication13processEventsE6QFlagsIN10QEventLoop17ProcessEventsFlagEE"]
        process.argtypes, process.restype = [ctypes.c_int], None
        return lambda: process(0)
    raise RuntimeError("ParaView's window uses neither Qt 5 nor Qt 6")


def wait(events, until, seconds):
    """Handles events until the condition holds; False after that many seconds."""
    end = time.time() + seconds
    while time.time() < end:
        events()
        if until():
            return True
        time.sleep(0.002)
    return False
