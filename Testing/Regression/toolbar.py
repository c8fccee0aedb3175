"""Runs inside ParaView's window: the plugin's toolbar chooses a quality, stops and shows the progress of the image; undo, redo
and the Python trace have what was chosen. ParaView's messages name the device that traces.

Usage: paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=toolbar.py
Prints TOOLBAR TEST PASSED as its last line.
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402
from paraview import smtrace  # noqa: E402

import session  # noqa: E402
from checks import Checks, cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

QUALITIES = ("Fast", "Balanced", "Publication", "PathTracing", "Custom")
BAR, PAGE = "RayTracedGlyphs", "RayTracedGlyphsReference"
#: samples that take long, and samples that do not
MANY, FEW = 4000, 3
#: seconds within which what is waited for must have happened
LIMIT = 60.0


class Bar:
    """The toolbar as a user sees it."""

    def __init__(self, window):
        self.window = window

    def enabled(self):
        """Names of the buttons that can be pressed."""
        return [name for name in QUALITIES + ("Stop",) if self.window.enabled(BAR + "/" + name)]

    def pressed(self):
        """Names of the qualities that are chosen."""
        return [name for name in QUALITIES if self.window.checked(BAR + "/" + name)]

    def samples(self):
        """What is said of the samples."""
        return self.window.text(BAR + "/Samples")

    def waits(self, checks, what, holds):
        """A state that the toolbar must reach."""
        checks.true("%s: the toolbar has %s, pressed %s, '%s'" % (what, self.enabled(), self.pressed(), self.samples()),
                    self.window.wait(holds, LIMIT))


def device(checks, window):
    """One plain message names the device, and no window is opened for it; this before anything is rendered."""
    checks.true("no message of a device: %s" % window.rows("outputWidget"),
                window.wait(lambda: any("traces with" in row for row in window.rows("outputWidget")), LIMIT))
    said = [row for row in window.rows("outputWidget") if "Ray Traced Glyphs" in row]
    say("said: %s" % said)
    checks.equal("number of the plugin's messages", len(said), 1)
    checks.true("the window of messages is open", not window.visible("outputWidgetDock"))
    return said[0] if said else ""


def quality(checks, window, bar, shown):
    """Each button, with undo and redo, and a change elsewhere."""
    was = "Custom"
    shown.SamplesPerPixel = 5
    pv.Render()
    bar.waits(checks, "Custom", lambda: bar.pressed() == ["Custom"] and bar.samples() == "5 of 5")
    for name, samples in (("Fast", 4), ("Balanced", 32)):
        smtrace.start_trace()
        checks.true("%s cannot be pressed" % name, window.click(BAR + "/" + name))
        chosen = window.wait(lambda name=name: shown.RenderingQuality == name, LIMIT)
        trace = smtrace.stop_trace()
        checks.true("%s: RenderingQuality is %s" % (name, shown.RenderingQuality), chosen)
        checks.true("%s: the trace does not say so: %s" % (name, trace), re.search(r"\bRenderingQuality ?= ?'%s'" % name, trace))
        bar.waits(checks, name, lambda name=name, samples=samples: bar.pressed() == [name] and (" of %d" % samples) in bar.samples())
        found = []
        for action, wanted in (("actionEditUndo", was), ("actionEditRedo", name)):
            checks.true("%s: %s cannot be chosen" % (name, action), window.wait(lambda action=action: window.trigger(action), LIMIT))
            window.wait(lambda wanted=wanted: shown.RenderingQuality == wanted, 5.0)
            # As text: what properties give out changes with them.
            found.append((str(shown.RenderingQuality).strip("'"), shown.SamplesPerPixel, str(shown.ShadingMode).strip("'")))
        say("%s: after undo %s, after redo %s" % (name, *found))
        before = {"Custom": ("Custom", 5, "Local"), "Fast": ("Fast", 4, "Local")}[was]
        checks.equal("%s: after undo" % name, found[0], before)
        checks.equal("%s: after redo" % name, found[1], (name, samples, "Local" if name == "Fast" else "Ambient Occlusion"))
        was = name
    shown.SamplesPerPixel = 6
    pv.Render()
    bar.waits(checks, "Custom again", lambda: bar.pressed() == ["Custom"] and " of 6" in bar.samples())


def stopping(checks, window, bar, view, shown):
    """Progress grows until Stop is pressed; then there is nothing to stop."""
    shown.SamplesPerPixel = MANY
    session.look(view, (1.0, 0.5, 6.0))
    pv.Render(view)
    told = set()
    bar.waits(checks, "refining", lambda: told.add(bar.samples()) or (len(told) >= 4 and information(shown, "AccumulatedSamples") > 0))
    bar.waits(checks, "time left", lambda: re.fullmatch(r"\d+ of %d, about \d+ (s|min|h) left" % MANY, bar.samples()))
    window.wait(lambda: False, 0.0)
    checks.true("the window's bar says '%s', the toolbar '%s'" % (window.text("ProgressBar"), bar.samples()),
                window.wait(lambda: window.text("ProgressBar").startswith(bar.samples()), LIMIT))
    say("shown: %s" % sorted(told))
    checks.true("nothing shows %d: %s" % (MANY, told), any("of %d" % MANY in one for one in told))
    checks.true("refining: %s" % bar.enabled(), "Stop" in bar.enabled())
    window.picture(BAR, session.output("toolbar-refining.png"))
    checks.true("Stop cannot be pressed", window.click(BAR + "/Stop"))
    bar.waits(checks, "stopped", lambda: "Stop" not in bar.enabled())
    checks.true("a stopped image is pending", not pending(shown))
    stopped = information(shown, "AccumulatedSamples")
    window.wait(lambda: False, 0.5)
    checks.equal("samples of an image that was stopped", information(shown, "AccumulatedSamples"), stopped)
    checks.equal("said of an image that was stopped", bar.samples(), "Stopped at %d of %d" % (stopped, MANY))
    checks.within("the toolbar's bar of an image that was stopped, in thousandths", window.value(BAR + "/Samples"), 1000 * stopped // MANY - 1, 1000 * stopped // MANY + 1)
    shown.SamplesPerPixel = FEW


def stopped_at_once(checks, window, bar, view, shown):
    """An image that is stopped before its first sample says so."""
    shown.SamplesPerPixel, shown.ShadingMode = MANY, "Path Tracing"
    session.look(view, (0.5, 1.0, 6.0))
    pv.Render(view)
    for _ in range(20):
        view.CameraPosition = [view.CameraPosition[0] + 0.1, 1.0, 6.0]
        pv.Render(view)
        checks.true("Stop cannot be pressed at once", window.wait(lambda: window.click(BAR + "/Stop"), LIMIT))
        bar.waits(checks, "stopped at once", lambda: "Stop" not in bar.enabled())
        if information(shown, "AccumulatedSamples") == 0:
            break
    checks.equal("samples of an image that was stopped at once", information(shown, "AccumulatedSamples"), 0)
    checks.equal("said of an image that was stopped at once", bar.samples(), "Stopped at 0 of %d" % MANY)
    shown.SamplesPerPixel, shown.ShadingMode = FEW, "Local"


def reference(checks, window):
    """One page explains the properties, however often it is asked for, also those of 3D Glyphs in the plugin's words."""
    for _ in range(3):
        checks.true("? cannot be pressed", window.click(BAR + "/?"))
        window.wait(lambda: False, 0.5)
    checks.equal("pages of properties", window.count(PAGE), 1)
    words = window.text(PAGE + "/Page")
    for wanted in ("Size By", "Direction By", "Orientation Mode", "Glyph Type", "Use Glyph Table", "SectionOrigin", "SectionLength", "Whether ScaleFactor and, by ScaleMode,",
                   "Whether SelectOrientationVectors rotates the glyphs."):
        checks.true("the page of properties says nothing of '%s'" % wanted, wanted in words)
    checks.true("the page of properties has words of ParaView: %s" % words, "source geometry" not in words)


def views(checks, bar, view, shown):
    """Enabled only while the active view shows something ray-traced; of each view its own."""
    other = pv.CreateView("RenderView")
    pv.SetActiveView(other)
    bar.waits(checks, "an empty view", lambda: bar.enabled() == [] and bar.pressed() == [] and not bar.samples())
    pv.SetActiveView(view)
    bar.waits(checks, "back in the view", lambda: bar.enabled()[:5] == list(QUALITIES))
    pv.Delete(other)
    shown.Visibility = 0
    pv.Render(view)
    bar.waits(checks, "hidden glyphs", lambda: bar.enabled() == [])
    shown.Visibility = 1
    pv.Render(view)
    bar.waits(checks, "glyphs again", lambda: bar.enabled()[:5] == list(QUALITIES))
    shown.RenderingQuality = "Fast"
    source = shown.Input
    pv.Delete(shown)
    pv.Render(view)
    bar.waits(checks, "no display", lambda: bar.enabled() == [])
    shown = pv.Show(source, view)
    shown.SetRepresentationType("Ray Traced Glyphs")
    pv.Render(view)
    bar.waits(checks, "another display", lambda: bar.pressed() == ["Fast"] and " of 4" in bar.samples())
    shown.SetRepresentationType("Surface")
    pv.Render(view)
    bar.waits(checks, "an ordinary surface", lambda: bar.enabled() == [])
    shown.SetRepresentationType("Ray Traced Surface")
    pv.Render(view)
    bar.waits(checks, "a ray-traced surface", lambda: bar.enabled()[:5] == list(QUALITIES))


def long(checks, window, bar, view, source):
    """What takes long says so as soon as that is measured, and not before, also while the toolbar floats."""
    checks.true("the toolbar cannot float", window.float(BAR))
    pv.GetLayout().PreviewMode = [1200, 800]
    shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.15, RenderingQuality="Fast")
    pv.Render(view)
    bar.waits(checks, "a larger view", lambda: bar.samples() == "4 of 4")
    checks.true("tool tip of what is not measured: %s" % window.tip(BAR + "/Publication"), window.tip(BAR + "/Publication").endswith("not measured yet."))
    checks.true("Publication cannot be pressed", window.click(BAR + "/Publication"))
    told = r"Publication takes about \d+ (s|min|h)(, (Balanced|Fast) \d+ (s|min|h))*\. Stop keeps the samples so far."
    checks.true("nothing shows how long it takes: %s" % window.text("statusbar"), window.wait(lambda: re.search(told, window.text("statusbar")), LIMIT))
    checks.true("tool tip of what is measured: %s" % window.tip(BAR + "/Publication"), re.search(r"about \d+ (s|min|h) here", window.tip(BAR + "/Publication")))
    say("said: %s" % window.text("statusbar"))
    shown.RenderingQuality = "Fast"


def main():
    """All of it in one window."""
    checks, window = Checks(), Window()
    window.resize("pqClientMainWindow", 2600, 900)  # so that all of the toolbar is in sight, beside ParaView 6's own
    bar = Bar(window)
    device(checks, window)
    checks.equal("enabled before anything is shown", bar.enabled(), [])
    pv._DisableFirstRenderCameraReset()
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    shown = session.glyphs(cloud(1000), view, "Sphere", Orient=0, ScaleFactor=0.15)
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    quality(checks, window, bar, shown)
    stopping(checks, window, bar, view, shown)
    stopped_at_once(checks, window, bar, view, shown)
    reference(checks, window)
    views(checks, bar, view, shown)
    long(checks, window, bar, view, cloud(20000))
    return checks.failures


run("TOOLBAR", main)
