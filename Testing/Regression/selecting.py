"""Runs inside ParaView's window: an image is refined after a selection, and while there is one when something changes.

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
#: the window's actions for which the mouse is dragged over the view
ACTIONS = ("actionSelectSurfacePoints", "actionSelectSurfaceCells", "actionPolygonSelectionPoints")
#: seconds within which what is waited for must have happened
LIMIT = 60.0


def refined(checks, window, shown, what):
    """The image gets all its samples. The first render may still be on its way."""
    window.wait(lambda: pending(shown), 1.0)
    done = window.wait(lambda: not pending(shown) and information(shown, "AccumulatedSamples") >= shown.SamplesPerPixel, LIMIT)
    said = "%d of %d samples" % (information(shown, "AccumulatedSamples"), shown.SamplesPerPixel)
    say("%s: %s" % (what, said))
    checks.true("%s: %s" % (what, said), done)


def main():
    """Each way to select with the mouse; then other qualities, another camera and another size with a selection there."""
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
    for part, action in enumerate(ACTIONS):
        checks.true("%s cannot be chosen" % action, window.wait(lambda action=action: window.trigger(action), LIMIT))
        window.wait(lambda: False, 0.3)
        window.drag(VIEW, (100 + 30 * part, 60), (130 + 30 * part, 140))
        selected = window.wait(lambda: source.SMProxy.GetSelectionInput(0) is not None, LIMIT)
        checks.true("%s: nothing is selected" % action, selected)
        refined(checks, window, shown, action)
        if action != ACTIONS[-1]:
            pv.ClearSelection(source)
            pv.Render(view)
            refined(checks, window, shown, "cleared")

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
