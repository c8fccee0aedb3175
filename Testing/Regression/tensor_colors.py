"""Trace and Fractional Anisotropy have a color table and a scalar bar of their own, whatever ColorArrayName has left.

Usage: pvpython tensor_colors.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

EIGENVALUES = numpy.array([[1.0, 1.0, 1.0], [0.9, 0.3, 0.2], [-0.8, -0.7, 0.2], [0.8, 0.4, 0.4]])
POINTS = numpy.array([[-1.5, 0.0, 0.0], [-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [1.5, 0.0, 0.0]])
SIZE = (240, 90)
#: world units from the middle of the picture to its upper edge
SCALE = 0.75
#: levels of 255 that a color may be off
LEVELS = 3


def value_of(coloring, eigenvalues):
    """The number that a color stands for."""
    if coloring == "Trace":
        return eigenvalues.sum()
    deviation = eigenvalues - eigenvalues.mean()
    return numpy.sqrt(1.5 * (deviation @ deviation) / (eigenvalues @ eigenvalues))


VALUES = {coloring: numpy.array([value_of(coloring, row) for row in EIGENVALUES]) for coloring in ("Trace", "Fractional Anisotropy")}


def scene():
    """(view, representation): four unlit tensor glyphs beside each other."""
    view = session.view(*SIZE)
    source = session.source(session.poly_data(
        POINTS, stress=numpy.array([numpy.diag(row) for row in EIGENVALUES]).reshape(4, 9),
        tiny=1e-6 * numpy.arange(4.0), large=1e3 * numpy.arange(4.0)))
    shown = session.glyphs(source, view, "Tensor Ellipsoid", GlyphTensorArray="stress", GlyphScaleFactor=0.8)
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=SCALE)
    pv.Render(view)
    return view, shown


def table_of(shown):
    """The table of the tensors' numbers, or None."""
    proxy = shown.SMProxy.GetProperty("GlyphTensorLookupTable")
    return pv.servermanager._getPyProxy(proxy.GetProxy(0)) if proxy and proxy.GetNumberOfProxies() else None


def bars(view, table):
    """The view's visible scalar bars of a table."""
    return [bar for bar in view.Representations if getattr(bar, "LookupTable", None) == table and hasattr(bar, "ComponentTitle")
            and bar.Visibility]


def centers(pixels):
    """Colors in the middle of the glyphs."""
    return [pixels[SIZE[1] // 2, round(SIZE[0] / 2 + x * SIZE[1] / 2 / SCALE), :3].astype(int) for x in POINTS[:, 0]]


def check(checks, coloring, left):
    """The picture with a coloring after an array, or none, has colored the glyphs."""
    view, shown = scene()
    what = "%s after %s" % (coloring, left or "nothing")
    if left:
        pv.ColorBy(shown, ("POINTS", left))
        pv.Render(view)
    shown.GlyphTensorColoring = coloring
    pv.Render(view)
    title = "stress " + coloring
    table = table_of(shown)
    checks.true(what + ": no GlyphTensorLookupTable is set", table is not None)
    if table is not None:
        checks.true(what + ": the table is not the session's of '%s'" % title, table == pv.GetColorTransferFunction(title))
        low, high = table.RGBPoints[0], table.RGBPoints[-4]
        checks.true("%s: the table's range is %g to %g" % (what, low, high),
                    numpy.allclose((low, high), (VALUES[coloring].min(), VALUES[coloring].max()), rtol=1e-4, atol=1e-6))
        found = bars(view, table)
        checks.equal(what + ": visible scalar bars", len(found), 1)
        for bar in found:
            checks.equal(what + ": title of the scalar bar", (bar.Title + " " + bar.ComponentTitle).strip(), title)
            bar.Visibility = 0
    for other in view.Representations:
        if hasattr(other, "ComponentTitle"):
            other.Visibility = 0
    pixels = session.capture(view, "tensor-colors-" + what.replace(" ", "-").lower())
    if table is not None:
        mapping = table.GetClientSideObject()
        for value, color in zip(VALUES[coloring], centers(pixels)):
            rgb = [0.0] * 3
            mapping.GetColor(float(value), rgb)
            wanted = numpy.round(255 * numpy.array(rgb)).astype(int)
            checks.true("%s: %.3f has color %s, not %s" % (what, value, color, wanted), numpy.abs(color - wanted).max() <= LEVELS)
    # What maps the array has no say any more.
    shown.ColorArrayName = [None, ""]
    checks.picture(what + ", then cleared", session.capture(view, "tensor-colors-cleared"), pixels, pixels=0.0, mean=0.0)
    shown.GlyphTensorColoring = "None"
    pv.Render(view)
    session.solid(shown, (0.2, 0.4, 0.6))
    off = centers(session.capture(view, "tensor-colors-off"))
    checks.true("%s, then off: colors %s" % (what, off), all(numpy.abs(color - (51, 102, 153)).max() <= LEVELS for color in off))
    pv.Delete(view)
    return pixels


def main():
    """Both numbers, after arrays of a tiny and of a large range have colored the glyphs."""
    session.load()
    checks = Checks()
    for coloring in VALUES:
        plain = check(checks, coloring, None)
        for left in ("tiny", "large"):
            checks.picture("%s, colors after %s" % (coloring, left), check(checks, coloring, left), plain, pixels=0.0, mean=0.0)
    checks.report()


if __name__ == "__main__":
    main()
