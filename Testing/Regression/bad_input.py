"""Bad input: one clear message each, the view stays alive, the good glyphs show.

Usage: pvpython bad_input.py [no-device WORDS...]
With no-device, the process was started where no device can trace, which the only message says in these words.
"""
import sys

import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

import comparison
import session

LINE = numpy.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])


class Case:
    """One render of one bad input and what is expected of it."""

    def __init__(self):
        self.failures = []
        self.view = session.view(200, 100)
        self.stage = session.Stage(self.view)
        session.look(self.view, (0.0, 0.0, 6.0))

    def render(self, name, data, visible, message=None, skipped=None, shape="Sphere", **properties):
        """Draws data; visible: x positions (of -1, 0, 1) where a glyph must be seen; message: words of the only message;
        skipped: how many points RenderStatistics must count as left out."""
        def twice():
            self.stage.show(data, shape, **{"Orient": 0, "ScaleFactor": 0.5, **properties})
            pv.Render(self.view)
            session.look(self.view, (0.0, 0.0, 6.001))
            pv.Render(self.view)

        text = session.messages(twice)
        session.look(self.view, (0.0, 0.0, 6.0))
        mask = comparison.covered(session.capture(self.view, "bad-" + name.replace(" ", "-")))
        for x in (-1, 0, 1):
            # 6 units away, view angle 30 degrees: half the height is 6 tan 15 degrees = 1.608 units.
            column = int(round(99.5 + x * 50.0 / 1.608))
            seen = bool(mask[50, column])
            if seen != (x in visible):
                self.failures.append("%s: the glyph at %d is %s" % (name, x, "visible" if seen else "missing"))
        count = text.count("ERR:") + text.count("ERROR:") + text.count("Warning:") + text.count("WARN")
        print("%s: %s" % (name, text.strip() or "no message"))
        if message is None and text.strip():
            self.failures.append("%s: unexpected message: %s" % (name, text.strip()))
        if message is not None:
            for word in message:
                if word not in text:
                    self.failures.append("%s: the message does not speak of '%s': %s" % (name, word, text.strip()))
            if count > 1:
                self.failures.append("%s: %d messages instead of one" % (name, count))
        counted = session.statistics(self.stage.settings.shown).get("skippedGlyphs")
        if skipped is not None and counted != skipped:
            self.failures.append("%s: %s points are counted as left out, not %d" % (name, counted, skipped))
        self.stage.hide()


def degenerate(case):
    """Points and scales that make no glyph: the others show, and the missing are reported once."""
    infinity, nothing = numpy.inf, numpy.nan
    broken = LINE.copy()
    broken[1, 1] = nothing

    def scaled(name, scale):
        case.render(name, session.poly_data(LINE, size=numpy.array([1.0, scale, 1.0])), (-1, 1), ("1 of 3", "'size'", "not finite"),
                    SelectScaleArray="size", ScaleMode="Magnitude")

    # Not both scales one after another: what is wrong in the same words is said once.
    scaled("NaN scale", nothing)
    case.render("NaN position", session.poly_data(broken), (-1, 1), ("1 of 3",))
    scaled("infinite scale", infinity)
    case.render("negative scale", session.poly_data(LINE, size=numpy.array([1.0, -1.0, 1.0])), (-1, 0, 1), None,
                SelectScaleArray="size", ScaleMode="Magnitude")
    # A box, because spheres of one size are not turned and need no vector.
    case.render("NaN vector", session.poly_data(LINE, v=numpy.array([[1, 0, 0], [nothing, 0, 0], [0, 1, 0.0]])), (-1, 1), ("1 of 3",),
                shape="Box", Orient=1, SelectOrientationVectors="v", OrientationMode="Direction")


def zeros(case):
    """Scales, directions and tensors of zero are ordinary: counted, and spoken of only where no glyph is left."""
    for name, property_name, properties in (
            ("scale", "SelectScaleArray", {"ScaleMode": "Magnitude"}), ("vector", "SelectOrientationVectors", {"shape": "Cone", "Orient": 1, "ScaleFactor": 0.9}),
            ("tensor", "GlyphTensorArray", {"shape": "Tensor Ellipsoid"})):
        values = {"scale": numpy.ones(3), "vector": numpy.eye(3), "tensor": numpy.tile(numpy.eye(3).ravel(), (3, 1))}[name]
        some, none, bad = values.copy(), 0.0 * values, values.copy()
        some[1] = 0.0
        bad[0], bad[1] = 0.0, numpy.nan
        properties[property_name] = "a"
        case.render("zero " + name, session.poly_data(LINE, a=some), (-1, 1), None, skipped=1, **properties)
        case.render("all zero " + name, session.poly_data(LINE, a=none), (), ("3 of 3", "is zero", "'a'"), skipped=3, **properties)
        case.render("zero and NaN " + name, session.poly_data(LINE, a=bad), (1,), ("1 of 3", "not finite"), skipped=2, **properties)
    case.render("boxes without direction", session.poly_data(LINE, a=numpy.zeros((3, 3))), (-1, 0, 1), None, skipped=0,
                shape="Box", Orient=1, SelectOrientationVectors="a")


def arrays(case):
    """Arrays that are missing or have the wrong number of components are named in the message."""
    data = session.poly_data(LINE, scalar=numpy.ones(3))
    case.render("missing array", data, (-1, 0, 1), ("nonesuch",),
                SelectScaleArray="nonesuch", ScaleMode="Magnitude")
    words = vtkStringArray()
    words.SetName("words")
    for word in "abc":
        words.InsertNextValue(word)
    data.GetPointData().AddArray(words)
    case.render("words", data, (-1, 0, 1), ("'words', which SelectScaleArray names, has no numbers",), SelectScaleArray="words", ScaleMode="Magnitude")
    case.render("wrong components", session.poly_data(LINE, scalar=numpy.ones(3)), (-1, 0, 1), ("scalar", "1"),
                Orient=1, SelectOrientationVectors="scalar", OrientationMode="Quaternion")


def names(case):
    """An array whose name is not UTF-8, as files of other programs have them; a number that an enumeration does not have."""
    name = session.output("bad-names.vtk")
    with open(name, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOINT_DATA 1\nVECTORS gr\xf6\xdfe float\n0 0 1\n")
    shown = session.glyphs(pv.OpenDataFile(name), case.view, "Arrow")
    text = session.messages(lambda: pv.Render(case.view))
    choices = session.statistics(shown)["choices"]
    if text.strip() or not any("gr\ufffd\ufffde" in sentence for sentence in choices):
        case.failures.append("a name that is not UTF-8: %s %s" % (text, choices))
    pv.Delete(shown)
    shown = session.glyphs(session.source(session.poly_data(LINE, t=numpy.tile([3.0, 2.0, 1.0, 0.0, 0.0, 0.0], (3, 1)))), case.view, "Tensor Ellipsoid")
    shown.SMProxy.GetProperty("GlyphTensorLayout").SetElement(0, 17)
    shown.GlyphTensorArray = "t"
    pv.Render(case.view)
    if session.statistics(shown)["glyphs"] != 3:
        case.failures.append("GlyphTensorLayout 17: %s" % session.statistics(shown))
    pv.Delete(shown)


def factors(case):
    """Of sizes that are good the factor is what is wrong."""
    data = session.poly_data(LINE, size=numpy.ones(3))
    for factor in (0.0, float("nan"), 1e300, 1e-300):
        case.render("ScaleFactor %g" % factor, data, (), ("3 of 3", "ScaleFactor"), ScaleFactor=factor, ScaleMode="Magnitude", SelectScaleArray="size")
        case.render("a good one, after which the same is said again", data, (-1, 0, 1))


def amounts(case):
    """No points, one point, no data."""
    case.render("no points", session.poly_data(numpy.zeros((0, 3))), ())
    case.render("empty data", vtkPolyData(), ())
    case.render("one point", session.poly_data(LINE[1:2]), (0,))


def sizes(case):
    """A view of one pixel renders and comes back."""
    points = session.source(session.poly_data(LINE))
    shown = session.glyphs(points, case.view, Orient=0, ScaleFactor=0.5)
    for size in ([1, 1], [1, 200], [200, 100]):
        case.view.ViewSize = size
        text = session.messages(lambda: pv.Render(case.view))
        if text.strip():
            case.failures.append("view of %s: %s" % (size, text.strip()))
    pv.Delete(shown)
    case.render("after one pixel", session.poly_data(LINE), (-1, 0, 1))


def settings(case):
    """Numbers out of range count as the nearest that makes sense, NaN as the default: the picture is that of those."""
    points = session.source(session.poly_data(LINE))
    # One representation for all, which is what a fresh one takes longest for.
    shown = session.glyphs(points, case.view, Orient=0, ScaleFactor=0.9, samples=2)
    nothing = numpy.nan
    # The number before is another one, which a bad value that is not heeded would leave.
    for name, mode, bad, good, before in (
            ("SamplesPerPixel", "Ambient Occlusion", (0, -7), 1, 4),
            ("AmbientOcclusionRadius", "Ambient Occlusion", (-1.0, nothing), 0.0, 0.2),
            ("Exposure", "Local", (1e9,), 100.0, 1.0),
            ("Exposure", "Local", (-1e9,), -100.0, 1.0), ("Exposure", "Local", (nothing,), 0.0, 1.0)):
        pictures = []
        shown.ShadingMode = mode
        default = getattr(shown, name)
        for value in (good,) + bad:
            setattr(shown, name, before)
            setattr(shown, name, value)
            text = session.messages(lambda: pv.Render(case.view))
            pictures.append(session.capture(case.view, "bad-settings"))
            if text.strip():
                case.failures.append("%s %s: unexpected message: %s" % (name, value, text.strip()))
        setattr(shown, name, default)
        for value, picture in zip(bad, pictures[1:]):
            same = (picture == pictures[0]).all()
            print("%s %s: %s" % (name, value, "as %s" % good if same else "another picture"))
            if not same or not comparison.covered(picture).any():
                case.failures.append("%s %s does not count as %s" % (name, value, good))
    pv.Delete(shown)
    pv.Delete(points)


def lost(case):
    """A state whose sources give nothing, not even an empty data set."""
    for kind in (session.REPRESENTATION, "Ray Traced Surface", "Ray Traced Tubes"):
        line = session.with_cells(session.poly_data(LINE), "Lines", [range(len(LINE))])
        pv.Show(session.source(line), case.view).SetRepresentationType(kind)
    pv.SaveState(session.output("bad-lost.pvsm"))
    pv.ResetSession()
    session.messages(lambda: (pv.LoadState(session.output("bad-lost.pvsm")), pv.Render(pv.GetActiveView())))
    found = [session.statistics(shown).get("glyphs", 0) for shown in pv.GetActiveView().Representations if "Ray Traced" in str(getattr(shown, "Representation", ""))]
    if len(found) < 3 or any(found):
        case.failures.append("glyphs of sources that are lost: %s" % found)


def main(no_device):
    """Runs the cases."""
    session.load()
    case = Case()
    if no_device:
        case.render("no device", session.poly_data(LINE), (), no_device)
        surface = pv.Sphere()
        pv.Show(surface, case.view)
        if not comparison.covered(session.capture(case.view, "bad-no-device-surface")).any():
            case.failures.append("no device: the view does not draw other things any more")
        session.finish(case.failures)
    degenerate(case)
    zeros(case)
    arrays(case)
    names(case)
    factors(case)
    amounts(case)
    sizes(case)
    settings(case)
    lost(case)
    session.finish(case.failures)


if __name__ == "__main__":
    main(sys.argv[2:])
