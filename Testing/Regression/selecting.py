"""Runs inside ParaView's window: an image is refined after each tool of the view, used or canceled, beside each widget, after captures, and while
there is a selection when something changes. ParaView says nothing meanwhile.

Usage: paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=selecting.py
Prints SELECTING TEST PASSED as its last line.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402

import session  # noqa: E402
from checks import Checks, cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

VIEW = "Viewport"
#: the window's actions for which the mouse is dragged over the view, and whether something is selected by it
TOOLS = {"actionSelectSurfacePoints": True, "actionSelectSurfaceCells": True, "actionPolygonSelectionPoints": True, "actionZoomToBox": False}
#: what has a widget in the view
WIDGETS = {"ruler": lambda source: pv.Ruler(Point1=[-1.0, 0.0, 0.0], Point2=[1.0, 0.0, 0.0]),
           "plane": lambda source: pv.Slice(Input=source, SliceType="Plane"),
           "box": lambda source: pv.Clip(Input=source, ClipType="Box")}
#: captures: options of SaveScreenshot or, of more than one frame, SaveAnimation
CAPTURES = {"larger": {"ImageResolution": [420, 300]}, "larger, transparent": {"ImageResolution": [420, 300], "TransparentBackground": 1},
            "transparent": {"ImageResolution": [300, 200], "TransparentBackground": 1}, "animated": {"ImageResolution": [360, 240], "FrameWindow": [0, 1]}}
#: seconds within which what is waited for must have happened
LIMIT = 20.0


def refined(checks, window, shown, what):
    """The image gets all its samples. The first render may still be on its way."""
    window.wait(lambda: pending(shown), 0.5)
    done = window.wait(lambda: not pending(shown) and information(shown, "AccumulatedSamples") >= shown.SamplesPerPixel, LIMIT)
    said = "%d of %d samples" % (information(shown, "AccumulatedSamples"), shown.SamplesPerPixel)
    say("%s: %s" % (what, said))
    checks.true("%s: %s" % (what, said), done)


def press_escape(window):
    """The Esc key, as if the view had the focus."""
    window.escape(VIEW)
    window.wait(lambda: False, 0.1)


def tools(checks, window, view, shown, source):
    """Each tool, canceled before the mouse is used and while it is, and used."""
    for part, (action, selects) in enumerate(TOOLS.items()):
        place = (100 + 30 * part, 60), (130 + 30 * part, 140)
        for canceled in ("at once", "in the middle", ""):
            what = action + (", canceled " + canceled if canceled else "")
            session.look(view, (0.0, 0.0, 6.0 + 0.1 * part))
            pv.Render(view)
            checks.true("%s cannot be chosen" % action, window.wait(lambda action=action: window.trigger(action), LIMIT))
            window.wait(lambda: False, 0.3)
            if canceled:
                if canceled == "in the middle":
                    window.drag(VIEW, *place, release=False)
                # ParaView's zoom does not listen to Esc.
                press_escape(window) if selects else window.trigger(action)
                if canceled == "in the middle":
                    window.mouse(VIEW, "release", place[1])
                refined(checks, window, shown, what)
                # The mouse turns the camera again.
                checks.true("%s: the tool is still there" % what, window.wait(lambda: view.InteractionMode == "3D", 5.0))
                continue
            before = view.CameraViewAngle
            window.drag(VIEW, *place)
            done = window.wait(lambda: source.SMProxy.GetSelectionInput(0) is not None if selects else view.CameraViewAngle < before, LIMIT)
            checks.true("%s: nothing happened" % action, done)
            refined(checks, window, shown, what)
        if selects and action != "actionPolygonSelectionPoints":
            pv.ClearSelection(source)
            pv.Render(view)
            refined(checks, window, shown, "cleared")


def widgets(checks, window, view, shown, source):
    """Each widget, dragged, and while the camera is turned beside it; with Esc in the middle."""
    for name, make in WIDGETS.items():
        session.look(view, (0.0, 0.0, 6.0))
        pv.SetActiveSource(make(source))
        pv.Render(view)
        refined(checks, window, shown, name)
        for escaped in (False, True):
            for at in ((150, 100), (110, 100), (20, 20)):
                window.drag(VIEW, at, (at[0] + 25, at[1] + 20), release=not escaped)
                if escaped:
                    press_escape(window)
                    window.mouse(VIEW, "release", (at[0] + 25, at[1] + 20))
            what = "%s, dragged%s" % (name, " with Esc" if escaped else "")
            if escaped:  # it has stopped the image
                window.wait(lambda: False, 0.3)
                view.CameraPosition = [0.1, 0.0, 6.0]
                pv.Render(view)
            refined(checks, window, shown, what)
        if name == "box":
            captures(checks, window, view, shown)
        made = pv.GetActiveSource()
        pv.SetActiveSource(source)
        pv.Delete(made)
        pv.Render(view)


def captures(checks, window, view, shown):
    """Pictures while the image is refined, with axes and a widget in the view."""
    view.OrientationAxesVisibility = 1
    for number, (name, options) in enumerate(CAPTURES.items()):
        view.CameraPosition = [0.1 + 0.1 * number, 0.0, 6.0]
        pv.Render(view)
        save = pv.SaveAnimation if "FrameWindow" in options else pv.SaveScreenshot
        save(session.output("selecting-%s.png" % name.replace(", ", "-")), view, **options)
        refined(checks, window, shown, "captured: " + name)
    view.OrientationAxesVisibility = 0


def main():
    """Each tool, widget and capture; then other qualities, another camera and another size with a selection there."""
    checks, window = Checks(), Window()
    pv._DisableFirstRenderCameraReset()
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    source = cloud(1000)
    shown = session.glyphs(source, view, "Sphere", samples=6, Orient=0, ScaleFactor=0.15, ShadingMode="Ambient Occlusion")
    session.look(view, (0.0, 0.0, 6.0))
    pv.SetActiveSource(source)
    pv.Render(view)
    refined(checks, window, shown, "before any selection")
    said = session.messages(lambda: widgets(checks, window, view, shown, source))
    said += session.messages(lambda: tools(checks, window, view, shown, source))
    # Of Qt about ParaView 6's own timers
    said = "".join(line for line in said.splitlines(True) if "wildcard call disconnects" not in line and line != "warning: In unknown, line 0\n")
    checks.no_message("tools, widgets and captures", said.strip())

    shown.RenderingQuality = "Balanced"
    pv.Render(view)
    refined(checks, window, shown, "another quality, with a selection")
    before = list(view.CameraPosition)
    window.drag(VIEW, (150, 100), (190, 120))
    checks.true("the camera is not turned", window.wait(lambda: list(view.CameraPosition) != before, LIMIT))
    refined(checks, window, shown, "another camera, with a selection")
    pv.GetLayout().PreviewMode = [320, 240]
    checks.true("the view keeps its size", window.wait(lambda: list(view.ViewSize) == [320, 240], LIMIT))
    refined(checks, window, shown, "another size, with a selection")
    checks.true("the selection is gone", source.SMProxy.GetSelectionInput(0) is not None)
    return checks.failures


run("SELECTING", main)
