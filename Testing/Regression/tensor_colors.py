"""Numbers of tensors have a color table and a scalar bar of their own, whatever ColorArrayName has left; eigenvalues as red, green and blue.

Usage: pvpython tensor_colors.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import session
from checks import Checks

EIGENVALUES = numpy.array([[1.0, 1.0, 1.0], [0.9, 0.3, 0.2], [-0.8, -0.7, 0.2], [0.8, 0.4, 0.4]])
POINTS = numpy.array([[-1.5, 0.0, 0.0], [-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [1.5, 0.0, 0.0]])
SIZE = (240, 90)
#: world units from the middle of the picture to its upper edge
SCALE = 0.75
#: levels of 255 that a color may be off
LEVELS = 3


#: number -> which of the eigenvalues it is, largest first
SINGLE = {"Major Eigenvalue": 0, "Middle Eigenvalue": 1, "Minor Eigenvalue": 2}


def value_of(coloring, eigenvalues):
    """The number that a color stands for."""
    if coloring == "Trace":
        return eigenvalues.sum()
    if coloring in SINGLE:
        return numpy.sort(eigenvalues)[2 - SINGLE[coloring]]
    deviation = eigenvalues - eigenvalues.mean()
    return numpy.sqrt(1.5 * (deviation @ deviation) / (eigenvalues @ eigenvalues))


VALUES = {coloring: numpy.array([value_of(coloring, row) for row in EIGENVALUES]) for coloring in ("Trace", "Fractional Anisotropy", *SINGLE)}


#: what a case changes, as a new display has it
UNCHANGED = {"ColorArrayName": [None, ""], "DiffuseColor": [1.0] * 3, "AmbientColor": [1.0] * 3, "GlyphTensorColoring": "None",
             "GlyphTensorLookupTable": None, "GlyphShape": "Tensor Ellipsoid", "LookupTable": None}


def scene(stage, others=numpy.zeros((0, 3))):
    """(view, representation): four unlit tensor glyphs beside each other, and one more for each of some eigenvalues out of sight; no scalar bars."""
    view = stage.view
    for bar in list(view.Representations):
        if hasattr(bar, "ComponentTitle"):
            pv.Delete(bar)
    values = numpy.concatenate([EIGENVALUES, others])
    points = numpy.concatenate([POINTS, [[0.0, 100.0 + i, 0.0] for i in range(len(others))]]) if len(others) else POINTS
    data = session.poly_data(
        points, stress=numpy.array([numpy.diag(row) for row in values]).reshape(len(values), 9),
        major=values.max(axis=1), ball=numpy.tile([0.8 * numpy.sqrt(4.0 * numpy.pi), 0, 0, 0, 0, 0], (len(values), 1)),
        tiny=1e-6 * numpy.arange(float(len(values))), large=1e3 * numpy.arange(float(len(values))))
    shown = stage.show(data, "Tensor Ellipsoid", GlyphTensorArray="stress", ScaleFactor=0.8, Ambient=1.0, Diffuse=0.0,
                       **(UNCHANGED if stage.source else {}))
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


def hide_bars(view):
    """No scalar bar of the view stays visible."""
    for bar in view.Representations:
        if hasattr(bar, "ComponentTitle"):
            bar.Visibility = 0


def centers(pixels):
    """Colors in the middle of the glyphs."""
    return [pixels[SIZE[1] // 2, round(SIZE[0] / 2 + x * SIZE[1] / 2 / SCALE), :3].astype(int) for x in POINTS[:, 0]]


def check(checks, stage, coloring, left):
    """The picture with a coloring after an array, or none, has colored the glyphs."""
    view, shown = scene(stage)
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
    hide_bars(view)
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
    return pixels


def check_eigenvalues(checks, stage, others):
    """Magnitudes, the largest eigenvalue first, over the largest of the data, of which `others` may have some more: tables have no say."""
    view, shown = scene(stage, others)
    pv.ColorBy(shown, ("POINTS", "large"))
    shown.GlyphTensorColoring = "Trace"
    pv.Render(view)
    shown.GlyphTensorColoring = "Eigenvalues"
    pv.Render(view)
    what = "eigenvalues with %d others" % len(others)
    seen = [bar for bar in view.Representations if hasattr(bar, "ComponentTitle") and bar.Visibility and "Trace" in bar.Title]
    checks.equal(what + ": scalar bars of the trace", len(seen), 0)
    hide_bars(view)
    largest = numpy.abs(numpy.concatenate([EIGENVALUES, others])).max(axis=1)
    shown.UpdatePropertyInformation()
    found = numpy.array(shown.GetPropertyValue("DataSummary"))[4:6]
    checks.true("%s: the range of numbers in DataSummary is %s" % (what, found), numpy.allclose(found, (largest.min(), largest.max()), rtol=1e-9))
    pixels = session.capture(view, "tensor-colors-eigenvalues-%d" % len(others))
    for row, color in zip(EIGENVALUES, centers(pixels)):
        wanted = numpy.round(255 * numpy.abs(numpy.sort(row)[::-1]) / largest.max())
        checks.true("%s: %s have color %s, not %s" % (what, row, color, wanted), numpy.abs(color - wanted).max() <= 1)
    # Shapes that show no tensors keep the array's colors.
    session.assign_shape(shown, "Sphere")
    plain = session.capture(view, "tensor-colors-sphere")
    shown.GlyphTensorColoring = "None"
    checks.picture(what + ": spheres", session.capture(view, "tensor-colors-sphere-none"), plain, pixels=0.0, mean=0.0)
    shown.GlyphShape, shown.GlyphTensorColoring, shown.GlyphTensorArray = "Tensor Ellipsoid", "Eigenvalues", "None"
    checks.one_message(what + ", no array", session.messages(lambda: pv.Render(view)), "GlyphTensorArray")


def check_opacities(checks, stage):
    """A table's opacities are those that it gives the same numbers of an array, on tensors and on surfaces of polynomials."""
    view, shown = scene(stage)
    table = pv.GetColorTransferFunction("see through")
    table.ColorSpace, table.RGBPoints = "RGB", [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    opacity = pv.GetOpacityTransferFunction("see through")
    opacity.Points = [0.0, 0.1, 0.5, 0.0, 1.0, 0.9, 0.5, 0.0]
    table.ScalarOpacityFunction = opacity
    pictures = {}
    for mapping in (0, 1):
        table.EnableOpacityMapping = mapping
        for what in ("numbers", "array"):
            shown.GlyphTensorColoring = "Major Eigenvalue" if what == "numbers" else "None"
            shown.GlyphTensorLookupTable = table
            shown.ColorArrayName, shown.LookupTable = (["POINTS", "major"], table) if what == "array" else ([None, ""], None)
            pv.Render(view)
            hide_bars(view)
            pictures[what, mapping] = session.capture(view, "tensor-colors-opacity-%s-%d" % (what, mapping))
        checks.picture("opacities %d of an array and of eigenvalues" % mapping, pictures["numbers", mapping], pictures["array", mapping], pixels=0.0, mean=0.5)
    checks.true("opacity mapping shows nothing", numpy.abs(pictures["numbers", 1].astype(int) - pictures["numbers", 0]).max() > 50)
    # |f| of a ball is the same everywhere: 0.8 of the table, at its surface.
    shown.GlyphShape, shown.GlyphHarmonicsArray, shown.GlyphTensorColoring = "Spherical Harmonics", "ball", "Radius"
    pv.Render(view)
    shown.GlyphTensorLookupTable = table
    balls = []
    for mapping in (0, 1):
        table.EnableOpacityMapping = mapping
        pv.Render(view)
        balls.append(numpy.array(centers(session.capture(view, "tensor-colors-opacity-radius-%d" % mapping))))
    expected = balls[0] + 0.26 ** 2 * (numpy.array(session.BACKGROUND) - balls[0])
    checks.true("opacities of radii: %s, not %s" % (balls[1].tolist(), expected.tolist()), numpy.abs(balls[1] - expected).max() <= LEVELS + 2)
    table.EnableOpacityMapping = 0


def check_covariances(checks, stage):
    """Confidence ellipsoids have a table and a bar, too, and the number's table comes back where none is set."""
    view, shown = scene(stage)
    shown.GlyphShape, shown.GlyphTensorColoring = "Confidence Ellipsoid", "Trace"
    pv.Render(view)
    table = table_of(shown)
    checks.true("covariances: the table is not the session's of 'stress Trace'", table is not None and table == pv.GetColorTransferFunction("stress Trace"))
    checks.equal("covariances: visible scalar bars", len(bars(view, table)), 1)
    shown.GlyphTensorLookupTable = None
    pv.Render(view)
    checks.true("None: the number has no table", table_of(shown) == table)
    shown.GlyphShape, shown.GlyphTensorColoring = "Tensor Ellipsoid", "None"
    pv.Render(view)


def check_range(checks, stage):
    """The range of a table follows the data, but for one that the user has locked, and one that a state file brings."""
    data = [session.poly_data(POINTS, stress=factor * EIGENVALUES[:, [0, 1, 2, 0, 0, 0]] * [1, 1, 1, 0, 0, 0]) for factor in (1.0, 2.0)]
    traces = VALUES["Trace"].min(), VALUES["Trace"].max()
    for mode, wanted in (("Never", (-9.0, 9.0)), ("Grow and update on 'Apply'", (2.0 * traces[0], 2.0 * traces[1]))):
        stage.show(data[0], "Tensor Ellipsoid", GlyphTensorArray="stress", GlyphTensorColoring="Trace")
        pv.Render(stage.view)
        table = pv.GetColorTransferFunction("stress Trace")
        table.AutomaticRescaleRangeMode = mode
        table.RescaleTransferFunction(-9.0, 9.0)
        stage.show(data[1], "Tensor Ellipsoid", GlyphTensorArray="stress", GlyphTensorColoring="Trace")
        pv.Render(stage.view)
        found = table.RGBPoints[0], table.RGBPoints[-4]
        checks.true("the range with %s is %s, not %s" % (mode, found, wanted), numpy.allclose(found, wanted, rtol=1e-4))
    stage.close()
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data[0])
    writer.SetFileName(session.output("tensor-colors.vtp"))
    writer.Write()
    shown = session.glyphs(pv.XMLPolyDataReader(FileName=[writer.GetFileName()]), stage.view, "Tensor Ellipsoid", GlyphTensorArray="stress",
                           GlyphTensorColoring="Trace")
    pv.Render(stage.view)
    table_of(shown).RescaleTransferFunction(-9.0, 9.0)
    pv.SaveState(session.output("tensor-colors.pvsm"))
    pv.ResetSession()
    pv.LoadState(session.output("tensor-colors.pvsm"))
    pv.Render(pv.GetActiveView())
    table = pv.GetColorTransferFunction("stress Trace")
    checks.equal("the range that a state brings", (table.RGBPoints[0], table.RGBPoints[-4]), (-9.0, 9.0))


def check_shared_bar(checks, stage):
    """The scalar bar stays while any glyphs in the view are colored by the number."""
    shown = [session.glyphs(session.source(session.poly_data(numpy.zeros((1, 3)) + number, stress=numpy.array([[1.0, 2.0, 3.0, 0.0, 0.0, 0.0]]))), stage.view,
                            "Tensor Ellipsoid", GlyphTensorArray="stress", GlyphTensorColoring="Trace") for number in range(3)]
    pv.Render(stage.view)
    table = table_of(shown[0])
    for what, change, visible in (("another surface", lambda: shown[1].SetRepresentationType("Surface"), 1),
                                  ("hidden", lambda: setattr(shown[2], "Visibility", 0), 1),
                                  ("another number", lambda: setattr(shown[0], "GlyphTensorColoring", "Fractional Anisotropy"), 0)):
        change()
        pv.Render(stage.view)
        checks.equal("three displays, one is %s: visible scalar bars" % what, len(bars(stage.view, table)), visible)
    for display in shown:
        pv.Delete(display)


def main():
    """All numbers, after arrays of a tiny and of a large range have colored the glyphs."""
    session.load()
    checks = Checks()
    stage = session.Stage(session.view(*SIZE))
    session.look(stage.view, (0.0, 0.0, 5.0), parallel_scale=SCALE)
    for others in (numpy.zeros((0, 3)), numpy.array([[0.1, 0.0, -2.0]])):
        check_eigenvalues(checks, stage, others)
    check_opacities(checks, stage)
    check_covariances(checks, stage)
    # The first number colors a new display.
    stage.close()
    for coloring in VALUES:
        plain = check(checks, stage, coloring, None)
        for left in ("tiny", "large") if coloring not in SINGLE else ("large",):
            checks.picture("%s, colors after %s" % (coloring, left), check(checks, stage, coloring, left), plain, pixels=0.0, mean=0.0)
    stage.close()
    check_shared_bar(checks, stage)
    check_range(checks, stage)
    checks.report()


if __name__ == "__main__":
    main()
