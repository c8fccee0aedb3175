"""Runs inside ParaView's window: with 'Hover Points On' and 'Hover Cells On' a tooltip names the glyph under the mouse.

Usage: paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=hovering.py
Prints HOVERING TEST PASSED as its last line.
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import numpy  # noqa: E402
import paraview.simple as pv  # noqa: E402

import session  # noqa: E402
from checks import Checks  # noqa: E402
from window import Window, run, say  # noqa: E402

PLACES = numpy.array([[x, y, 0.0] for y in range(2) for x in range(3)], dtype=float)
#: names of ParaView's widgets
VIEW, TOOLTIP = "Viewport", "qtooltip_label"
#: seconds within which a tooltip must be there, and how long the mouse rests before it stirs again
LIMIT = 20.0
REST = 4.0


def points():
    """Points with a number; cell i is point 5 - i."""
    return session.with_cells(session.poly_data(PLACES, number=numpy.arange(6.0) + 10.0), "Verts", [[point] for point in reversed(range(6))])


def told(window, view, place):
    """The tooltip's id while the mouse is on a place, a little beside the point; None: no tooltip.

    ParaView asks once when the mouse comes to rest. It may take the two moves for one, or come to ask between them, so the mouse
    stirs until there is an answer.
    """
    x, y = session.pixel_of(view, place + [0.2, 0.15, 0.0])
    before = window.text(TOOLTIP)

    def answered():
        return window.text(TOOLTIP) not in ("", before)

    for stirring in range(int(LIMIT / REST)):
        window.hover(VIEW, (x - 1, y))
        window.wait(answered, 0.1)
        window.hover(VIEW, (x, y))
        if window.wait(answered, REST):
            break
        say("%s: no tooltip after %d s" % (place, (stirring + 1) * REST))
    found = re.search(r"\bId: *(?:</[^>]*> *)*(\d+)", window.text(TOOLTIP))
    say("%s: %s" % (place, window.text(TOOLTIP)))
    return int(found.group(1)) if found else None


def main():
    """Points, then cells."""
    checks, window = Checks(), Window()
    pv._DisableFirstRenderCameraReset()
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    source = session.source(points())
    session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.8)
    session.look(view, (1.0, 0.5, 10.0), (1.0, 0.5, 0.0), parallel_scale=1.2)
    pv.SetActiveSource(source)
    window.confirm()  # ParaView explains the mode once
    pv.Render(view)
    for action, of_point in (("actionHoveringSurfacePoints", lambda i: i), ("actionHoveringSurfaceCells", lambda i: 5 - i)):
        checks.true("%s cannot be chosen" % action, window.wait(lambda action=action: window.trigger(action), LIMIT))
        window.wait(lambda: False, 0.3)
        for i in (0, 4):
            checks.equal("%s: id in the tooltip of point %d" % (action, i), told(window, view, PLACES[i]), of_point(i))
        window.trigger(action)
    return checks.failures


run("HOVERING", main)
