"""Runs inside ParaView's window: how long the first frame of a turned camera takes, and a letter that is typed, while 100,000 glyphs are refined.

Usage, with the environment of the test Selecting (ctest -N -V -R Selecting):
    RTGLYPHS_SCRIPT=ANY FILE OF Testing/Regression paraview --dr --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=latency.py
The mouse is pressed and moved, and the letter typed, when a step of the refinement begins: at the worst moment. Prints for each shading mode the
seconds of all tries, the best first, and in brackets those of all cores: the window may share its machine.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ["RTGLYPHS_SCRIPT"])))

import numpy  # noqa: E402
import paraview.simple as pv  # noqa: E402

import session  # noqa: E402
from checks import cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

VIEW, LINE = "Viewport", "SearchBox/SearchLineEdit"
GLYPHS, TRIES = 100000, 8
LIMIT = 120.0


def now():
    """Seconds of the clock, and of all cores."""
    return numpy.array([time.monotonic(), time.process_time()])


class Steps:
    """What happens when a render of a view begins or ends."""

    def __init__(self, view):
        self.begin = self.end = None
        view.SMProxy.AddObserver("StartEvent", lambda *_: self.begin and self.begin())
        view.SMProxy.AddObserver("EndEvent", lambda *_: self.end and self.end())


def turned(window, view, shown, steps):
    """(Seconds, of all cores) from the press of the mouse to the end of the first render with another camera."""
    camera = view.GetActiveCamera()
    start, found, before = [], [], camera.GetPosition()

    def press():
        if not start:
            start.append(now())
            window.mouse(VIEW, "press", (300, 200))
            window.mouse(VIEW, "move", (330, 210))

    def look():
        if start and not found and camera.GetPosition() != before:
            found.append(now() - start[0])
    steps.begin, steps.end = press, look
    window.wait(lambda: found, LIMIT)
    steps.begin = steps.end = None
    window.mouse(VIEW, "release", (330, 210))
    window.wait(lambda: pending(shown), 5.0)
    return found[0]


def typed(window, steps):
    """(Seconds, of all cores) until a line of text shows what was typed."""
    start, found, before = [], [], window.text(LINE)

    def press():
        # Between two steps the window has painted the result of the first.
        if start and not found and window.text(LINE) != before:
            found.append(now() - start[0])
        if not start:
            start.append(now())
            window.type(LINE, "q")
    steps.begin = press
    window.wait(lambda: found, LIMIT)
    steps.begin = None
    return found[0]


def main():
    """Each mode."""
    window = Window()
    pv._DisableFirstRenderCameraReset()
    window.resize("pqClientMainWindow", 1600, 1000)
    view = pv.GetActiveViewOrCreate("RenderView")
    source = cloud(GLYPHS)
    shown = session.glyphs(source, view, "Sphere", samples=4, Orient=0, ScaleFactor=0.02)
    session.look(view, (0.0, 0.0, 5.0))
    pv.SetActiveSource(source)
    steps = Steps(view)
    say("view of %d x %d pixels" % tuple(view.ViewSize))
    for mode in ("Local", "Ambient Occlusion", "Path Tracing"):
        shown.ShadingMode, shown.SamplesPerPixel = mode, 4
        pv.Render(view)
        window.wait(lambda: information(shown, "AccumulatedSamples") >= 1, LIMIT)  # its program is there
        shown.SamplesPerPixel = 100000
        pv.Render(view)
        window.wait(lambda: False, 1.0)
        for what, seconds in (("first changed frame", [turned(window, view, shown, steps) for _ in range(TRIES)]),
                              ("typed letter", [typed(window, steps) for _ in range(TRIES)])):
            say("%-18s %-20s %s" % (mode, what, "  ".join("%.3f (%.3f)" % tuple(each) for each in sorted(seconds, key=tuple))))
    return []


run("LATENCY", main)
