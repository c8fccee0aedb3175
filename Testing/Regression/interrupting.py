"""Runs inside ParaView's window: long work reports its progress, reacts to Esc and the Abort button, and goes on afterwards.

Usage: paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=interrupting.py
Prints INTERRUPTING TEST PASSED as its last line.
"""
import faulthandler
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402

import session  # noqa: E402
from checks import Checks, cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

#: names of ParaView's widgets
ABORT, BAR, VIEW = "AbortButton", "ProgressBar", "Viewport"
#: and of one in the plugin's toolbar
SAMPLES = "RayTracedGlyphs/Samples"
#: samples that take long, and samples that do not
MANY, FEW = 4000, 3
#: seconds within which what is waited for must have happened
LIMIT = 60.0
#: seconds after which a screenshot that does not end is ended in any way: the test goes on, and says what took so long
IN_VAIN = 15.0


class Renders:
    """How long the renders of a view take."""

    def __init__(self, view):
        self.seconds, self.start = [], 0.0
        view.SMProxy.AddObserver("StartEvent", lambda *_: self.begin())
        view.SMProxy.AddObserver("EndEvent", lambda *_: self.seconds.append(time.monotonic() - self.start))

    def begin(self):
        """A render starts."""
        self.start = time.monotonic()


def scene():
    """(view, display): a cloud of spheres with ambient occlusion."""
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [channel / 255.0 for channel in session.BACKGROUND]
    shown = session.glyphs(cloud(1000), view, "Sphere", Orient=0, ScaleFactor=0.15)
    session.solid(shown, (0.9, 0.9, 0.9))
    shown.ShadingMode = "Ambient Occlusion"
    session.look(view, (0.0, 0.0, 6.0))
    return view, shown


def capture(view, name):
    """A small screenshot, which has all samples."""
    return session.capture(view, "interrupting-" + name, ImageResolution=[300, 200])


def samples_of(shown):
    """Of the image in the window."""
    return information(shown, "AccumulatedSamples")


def progress_told(checks, view, shown):
    """Progress is reported, and the progress bar is painted, while a picture is captured; the picture stays the same."""
    shown.SamplesPerPixel = 24  # several launches on any machine
    pv.Render(view)
    expected = capture(view, "quick")
    checks.covered("quick picture", expected, 0.2)
    session.look(view, (0.0, 0.0, 5.0))
    capture(view, "other")  # the first picture is forgotten
    session.look(view, (0.0, 0.0, 6.0))
    handler, told = pv.servermanager.ActiveConnection.Session.GetProgressHandler(), []
    window = view.SMProxy.GetRenderWindow()
    # The window is asked after each launch whether to go on, and takes its time to answer.
    asked = window.AddObserver("AbortCheckEvent", lambda *_: time.sleep(0.2))
    progress = handler.AddObserver("ProgressEvent", lambda *_: told.append(handler.GetLastProgressText()))
    slow = capture(view, "slow")
    window.RemoveObserver(asked)
    handler.RemoveObserver(progress)
    say("progress reported while a picture is captured: %s" % told)
    checks.true("no progress of tracing was reported: %s" % told, "Ray Tracing" in told)
    checks.picture("picture that was captured while progress was reported", slow, expected)
    pv.Render(view)
    checks.picture("next picture", capture(view, "after"), expected)


def larger_than_window(checks, view, shown):
    """What ParaView draws in a picture after a trace that takes long: the window has listened to its user meanwhile."""
    shown.SamplesPerPixel = 16
    view.OrientationAxesVisibility = 1
    window = view.SMProxy.GetRenderWindow()
    asked = window.AddObserver("AbortCheckEvent", lambda *_: time.sleep(0.05))
    said = session.messages(lambda: session.capture(view, "interrupting-large", ImageResolution=[700, 400]))
    window.RemoveObserver(asked)
    view.OrientationAxesVisibility = 0
    checks.no_message("a picture larger than the window", said)


def stopping(checks, window, view, shown, name, stop):
    """Refinement shows its progress, ends when the user stops it, and begins again with another camera."""
    shown.SamplesPerPixel = MANY
    session.look(view, (1.0, len(name) / 20.0, 6.0))
    pv.Render(view)
    checks.true("%s: nothing is refined" % name, window.wait(lambda: samples_of(shown) >= 2, LIMIT))
    checks.true("%s: the progress bar says '%s'" % (name, window.text(BAR)), " of %d" % MANY in window.text(BAR))
    checks.true("%s: the Abort button is disabled" % name, window.enabled(ABORT))
    checks.true("%s: there is nothing to press" % name, stop())
    window.wait(lambda: False, 0.3)
    stopped = samples_of(shown)
    window.wait(lambda: False, 1.0)
    pv.Render(view)
    window.wait(lambda: False, 0.5)
    say("%s: stopped at %d samples of %d, then %d" % (name, stopped, MANY, samples_of(shown)))
    checks.within("%s: samples" % name, stopped, 1, MANY - 1)
    checks.equal("%s: samples of an image that was stopped" % name, samples_of(shown), stopped)
    checks.true("%s: a stopped image is pending" % name, not pending(shown))
    checks.true("%s: the progress bar still says '%s'" % (name, window.text(BAR)), " of %d" % MANY not in window.text(BAR))
    checks.true("%s: the Abort button is enabled" % name, not window.enabled(ABORT))
    session.look(view, (-1.0, 0.0, 6.0))
    shown.SamplesPerPixel = FEW
    pv.Render(view)
    checks.true("%s: the next image is not refined" % name, window.wait(lambda: not pending(shown), LIMIT))
    checks.true("%s: %d samples at rest" % (name, samples_of(shown)), samples_of(shown) >= FEW)


def turned_after_stop(checks, window, view, shown):
    """Nothing but the camera changes."""
    shown.SamplesPerPixel = MANY
    session.look(view, (0.0, 1.0, 6.0))
    pv.Render(view)
    window.wait(lambda: samples_of(shown) >= 1, LIMIT)
    window.click(ABORT)
    window.wait(lambda: False, 0.3)
    checks.true("stopped: the image is pending", not pending(shown))
    session.look(view, (0.0, 1.0, 5.0))
    pv.Render(view)
    checks.true("an image is not refined when the camera was turned after a stop", pending(shown))
    window.click(ABORT)
    window.wait(lambda: False, 0.3)


def aborted_capture(checks, window, view, shown, name, stop):
    """A screenshot with many samples ends soon, and says what it lacks; the next one is whole."""
    shown.SamplesPerPixel = FEW
    pv.Render(view)
    window.wait(lambda: not pending(shown), LIMIT)
    expected = capture(view, "whole")
    shown.SamplesPerPixel = MANY
    handler, pressed = pv.servermanager.ActiveConnection.Session.GetProgressHandler(), []

    def press(*_):
        if not pressed and stop():
            pressed.append(time.monotonic())
        elif pressed and time.monotonic() > pressed[0] + IN_VAIN:
            window.click(ABORT)
            window.escape(VIEW)

    observer = handler.AddObserver("ProgressEvent", press)
    said = session.messages(lambda: capture(view, "aborted"))
    handler.RemoveObserver(observer)
    seconds = time.monotonic() - pressed[0] if pressed else -1.0
    say("%s: %.2f s from the press to the end of the screenshot" % (name, seconds))
    checks.true("%s: there is nothing to press" % name, bool(pressed))
    checks.within("%s: seconds from the press to the end" % name, seconds, 0.0, 5.0)
    checks.one_message(name, said, "samples", "stopped")
    shown.SamplesPerPixel = FEW
    # An image that has more than these by now, in some of its rows too, is left as it is: another camera forgets it.
    at = list(view.CameraPosition)
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    session.look(view, at)
    pv.Render(view)
    window.wait(lambda: not pending(shown), LIMIT)
    checks.picture("%s: next picture" % name, capture(view, "next"), expected, pixels=0.002)
    window.wait(lambda: False, 0.3)
    checks.true("%s: the Abort button or Stop stays enabled" % name, not window.enabled(ABORT) and not window.enabled("Stop"))


def runs(toolbar, words):
    """When these words came and when others did, each time."""
    starts = [i for i, (_, text) in enumerate(toolbar) if text == words and (i == 0 or toolbar[i - 1][1] != words)]
    ends = [next((i for i in range(start, len(toolbar)) if toolbar[i][1] != words), len(toolbar) - 1) for start in starts]
    return [(toolbar[start][0], toolbar[end][0]) for start, end in zip(starts, ends)]


def compiling(checks, window, view, shown):
    """While programs are compiled the window answers, and its progress bar says what it waits for."""
    told, toolbar, shape, mode = [], [], shown.GlyphShape, shown.ShadingMode
    shown.GlyphShape, shown.ShadingMode, shown.SamplesPerPixel = "Nested Superquadric", "Path Tracing", 4
    pv.Render(view)
    checks.true("compiling: no end of it", window.wait(
        lambda: told.append(window.text(BAR)) or toolbar.append((time.monotonic(), window.text(SAMPLES))) or not pending(shown), LIMIT))
    said = sorted(set(told))
    say("while programs were compiled and the image was refined the bar said %s" % said)
    for text in ("Compiling", " of 4"):
        checks.true("compiling: the progress bar did not say '%s' but %s" % (text, said), any(text in one for one in said))
    # The time comes after two seconds, which not every driver takes.
    words = [text for _, text in toolbar]
    checks.true("compiling: the toolbar said %s, not 'Compiling'" % sorted(set(words)), "Compiling" in words)
    untimed = [last - first for first, last in runs(toolbar, "Compiling")]
    checks.true("compiling: the toolbar did not say how long, in %s s" % untimed, max(untimed, default=0.0) < 3.0)
    shown.GlyphShape, shown.ShadingMode = shape, mode
    pv.Render(view)
    window.wait(lambda: not pending(shown), LIMIT)


def main():
    """All of it in one window."""
    faulthandler.dump_traceback_later(session.HANGS, file=sys.__stderr__)
    checks, window = Checks(), Window()
    pv._DisableFirstRenderCameraReset()
    window.resize("pqClientMainWindow", 2600, 900)  # so that all of the toolbar is in sight, beside ParaView 6's own
    view, shown = scene()
    pv.Render(view)  # programs are compiled
    window.wait(lambda: not pending(shown), LIMIT)
    progress_told(checks, view, shown)
    larger_than_window(checks, view, shown)
    renders = Renders(view)
    compiling(checks, window, view, shown)
    stopping(checks, window, view, shown, "Abort button", lambda: window.click(ABORT))
    stopping(checks, window, view, shown, "Esc", lambda: window.escape(VIEW))
    turned_after_stop(checks, window, view, shown)
    say("%d renders, the longest %.3f s" % (len(renders.seconds), max(renders.seconds)))
    aborted_capture(checks, window, view, shown, "Abort button in a screenshot", lambda: window.click(ABORT))
    aborted_capture(checks, window, view, shown, "Esc in a screenshot", lambda: window.escape(VIEW))
    aborted_capture(checks, window, view, shown, "Stop in a screenshot", lambda: window.click("Stop"))
    return checks.failures


run("INTERRUPTING", main)
