"""Runs inside ParaView's window: whatever is done in whatever order, the image gets all its samples, nothing is said, and memory stays bounded.

Usage: RTGLYPHS_MONKEY=SECONDS RTGLYPHS_SEED=N paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=monkey.py
Without them two minutes, and the seed of the day. Prints what it does, and MONKEY TEST PASSED as its last line.
"""
import datetime
import faulthandler
import os
import random
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402

import session  # noqa: E402
from checks import Checks, cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

VIEW = "Viewport"
SECONDS = float(os.environ.get("RTGLYPHS_MONKEY", "120"))
SEED = int(os.environ.get("RTGLYPHS_SEED", datetime.date.today().strftime("%Y%m%d")))
#: seconds of this process's CPU time, which other processes do not use up, within which an image that is not finished gets nearer to its end
LIMIT = 120.0
#: bytes of the process in the end over those after the first steps: what is done again leaves nothing behind
GROWTH = 1.5e9
#: the number of last steps that a failure names
TOLD = 5


class Monkey:
    """A window and what is in it."""

    def __init__(self):
        self.random, self.window, self.done = random.Random(SEED), Window(), []
        self.view = pv.GetActiveViewOrCreate("RenderView")
        pv.GetLayout().PreviewMode = [500, 300]
        self.window.resize("pqClientMainWindow", 2600, 900)  # so that all of the toolbar is in sight
        self.open()

    def open(self):
        """Data, shown as glyphs."""
        self.source = cloud(3000, seed=self.random.randrange(100))
        self.shown = session.glyphs(self.source, self.view, "Sphere", samples=8, Orient=0, ScaleFactor=0.1)
        pv.SetActiveSource(self.source)
        self.look()

    def look(self):
        """From somewhere."""
        session.look(self.view, (self.random.uniform(-2.0, 2.0), self.random.uniform(-2.0, 2.0), 6.0))
        self.view.CameraViewAngle = 30.0
        pv.Render(self.view)

    def place(self):
        """Somewhere in the view."""
        return self.random.randrange(20, 480), self.random.randrange(20, 280)

    def turn(self):
        """The mouse is dragged, perhaps beyond the end of the image's first step."""
        self.window.drag(VIEW, self.place(), self.place())

    def tool(self):
        """A tool of the view, used or canceled."""
        action = self.random.choice(["actionSelectSurfacePoints", "actionSelectSurfaceCells", "actionPolygonSelectionPoints", "actionZoomToBox"])
        if self.window.trigger(action):
            self.window.wait(lambda: False, 0.2)
            self.window.drag(VIEW, self.place(), self.place())
            self.window.wait(lambda: False, 0.2)
            self.window.wait(lambda: self.view.InteractionMode == "3D" or self.window.trigger(action) and False, 1.0)

    def clear(self):
        """No selection."""
        pv.ClearSelection(self.source)
        pv.Render(self.view)

    def widget(self):
        """A widget comes, is dragged, and goes."""
        made = self.random.choice([lambda: pv.Slice(Input=self.source), lambda: pv.Clip(Input=self.source, ClipType="Box"), pv.Ruler])()
        pv.SetActiveSource(made)
        pv.Render(self.view)
        for _ in range(2):
            self.turn()
            self.window.wait(lambda: False, 0.2)
        pv.SetActiveSource(self.source)
        pv.Delete(made)
        pv.Render(self.view)

    def representation(self):
        """Another one, and back."""
        for name in (self.random.choice(["Surface", "Points", "3D Glyphs", "Point Gaussian", "Outline"]), session.REPRESENTATION):
            self.shown.SetRepresentationType(name)
            pv.Render(self.view)
            self.window.wait(lambda: False, self.random.uniform(0.0, 0.3))

    def change(self):
        """A property."""
        name, value = self.random.choice([("GlyphShape", "Superquadric"), ("GlyphShape", "None"), ("Opacity", 0.5), ("Opacity", 1.0), ("ScaleFactor", 0.3),
                                          ("ScaleFactor", 0.15), ("Specular", 0.5), ("UseSeparateColorMap", 1)])
        setattr(self.shown, name, value)
        pv.Render(self.view)

    def color(self):
        """By an array, or one color."""
        if self.random.randrange(2):
            pv.ColorBy(self.shown, ("POINTS", "scalar"))
        else:
            session.solid(self.shown, (0.9, 0.6, 0.3))
        pv.Render(self.view)

    def quality(self):
        """A button of the toolbar, with few samples soon after."""
        self.window.click("RayTracedGlyphs/" + self.random.choice(["Fast", "Balanced", "Publication", "PathTracing"]))
        self.window.wait(lambda: False, self.random.uniform(0.1, 1.0))
        self.shown.SamplesPerPixel = 8
        pv.Render(self.view)

    def undo(self):
        """Undo, perhaps redo."""
        for action in self.random.sample(["actionEditUndo", "actionEditRedo"], self.random.randrange(1, 3)):
            self.window.trigger(action)
            self.window.wait(lambda: False, 0.2)
        self.shown.SamplesPerPixel = 8
        pv.Render(self.view)

    def capture(self):
        """Of any size."""
        session.capture(self.view, "monkey", ImageResolution=self.random.choice([[500, 300], [650, 400], [150, 220]]), TransparentBackground=self.random.randrange(2))

    def stop(self):
        """Esc, and then another camera."""
        self.window.escape(VIEW)
        self.window.wait(lambda: False, 0.1)
        self.look()

    def other_view(self):
        """A view beside it comes and goes."""
        other = pv.CreateView("RenderView")
        layout = pv.GetLayout(self.view)
        pv.AssignViewToLayout(other, layout, 0)
        pv.Show(self.source, other)
        pv.Render(other)
        self.window.wait(lambda: False, self.random.uniform(0.0, 0.5))
        cell = layout.GetViewLocation(other)
        pv.Delete(other)
        layout.Collapse(cell)
        pv.SetActiveView(self.view)
        pv.Render(self.view)

    def hide(self):
        """And show."""
        for visible in (0, 1):
            self.shown.Visibility = visible
            pv.Render(self.view)
            self.window.wait(lambda: False, self.random.uniform(0.0, 0.2))

    def reopen(self):
        """Everything is closed, and opened anew."""
        pv.Delete(self.source)
        pv.Render(self.view)
        self.window.wait(lambda: False, 0.1)
        self.open()

    def step(self, checks):
        """Something happens; then the image is finished."""
        actions = [self.turn, self.tool, self.clear, self.widget, self.representation, self.change, self.color, self.quality, self.undo, self.capture, self.stop,
                   self.other_view, self.hide, self.reopen]
        action = self.random.choice(actions)
        self.done.append(action.__name__)
        said = session.messages(lambda: self.finish(checks, action))
        checks.no_message("after %s" % self.done[-TOLD:], said)

    def finish(self, checks, action):
        """The image has all samples in the end. What is on its way comes first."""
        action()
        begin = time.monotonic()
        self.window.wait(lambda: False, 0.3)
        shown, state, since = self.shown, None, 0.0

        def ended():
            nonlocal state, since
            now = [information(shown, name) for name in ("AccumulatedSamples", "RefinementProgress", "RefinementStep")]
            since = since if now == state else time.process_time()
            state = now
            return now[1] >= 1.0 and now[0] >= shown.SamplesPerPixel or time.process_time() - since > LIMIT
        while not self.window.wait(ended, LIMIT):
            pass
        done = not pending(shown) and information(shown, "AccumulatedSamples") >= shown.SamplesPerPixel
        say("%-14s %4.1f s, %d of %d samples, %d MB" % (action.__name__, time.monotonic() - begin, information(shown, "AccumulatedSamples"), shown.SamplesPerPixel,
                                                       session.memory("VmRSS") >> 20))
        checks.true("after %s: %d of %d samples, %s, bar '%s'" % (self.done[-TOLD:], information(shown, "AccumulatedSamples"), shown.SamplesPerPixel,
                                                                  information(shown, "RefinementStep"), self.window.text("ProgressBar")), done)


def main():
    """Steps until the time is over."""
    faulthandler.dump_traceback_later(SECONDS + 900.0, file=sys.__stderr__)
    say("RTGLYPHS_SEED=%d" % SEED)
    pv._DisableFirstRenderCameraReset()
    checks, monkey = Checks(), Monkey()
    monkey.window.wait(lambda: False, 2.0)  # the device has been named
    end, first = time.monotonic() + SECONDS, 0
    while time.monotonic() < end and len(checks.failures) < TOLD:
        monkey.step(checks)
        first = session.memory("VmRSS") if len(monkey.done) == 10 else first
    say("%d steps" % len(monkey.done))
    checks.true("no steps", bool(monkey.done))
    checks.within("growth of memory in bytes", session.memory("VmRSS") - first if first else 0, -1e12, GROWTH)
    return checks.failures


run("MONKEY", main)
