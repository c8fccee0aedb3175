"""Superquadrics against ParaView's own source, finely tessellated; arrays of exponents; bad exponents.

Usage: pvpython superquadrics.py
"""
import numpy
import paraview.simple as pv

import comparison
import session

#: Their 256 by 256 facets against ours.
BOUNDS = {"silhouette": 0.0005, "color": 0.1}
SCALE, TURN = [1.0, 0.7, 0.5], 25.0
LINE = numpy.array([[-1.0, 0, 0], [0, 0, 0], [1.0, 0, 0]])


def theirs(view):
    """ParaView's superquadric of side 1, as a surface: (source, display)."""
    source = pv.Superquadric(Size=0.5, Scale=SCALE, ThetaResolution=256, PhiResolution=256, Toroidal=0)
    shown = pv.Show(source, view)
    shown.SetRepresentationType("Surface")
    if shown.ColorArrayName[1]:
        pv.ColorBy(shown, None)
    # The source's axis is y, with the third scale.
    shown.Orientation = [90.0, 0.0, TURN]
    shown.Visibility = 0
    return source, shown


def same_as_source(failures, view, shown, their, cases):
    """Exponents of ours, and those of theirs `along` the axis z and `across` it."""
    source, surface = their
    for name, exponents, along, across in cases:
        shown.GlyphExponents = exponents
        shown.Visibility = 1
        ours = session.capture(view, "superquadric-" + name)
        shown.Visibility = 0
        source.ThetaRoundness, source.PhiRoundness = 2.0 / across, 2.0 / along
        surface.Visibility = 1
        reference = session.capture(view, "superquadric-" + name + "-source")
        surface.Visibility = 0
        failures += comparison.against_paraview(ours, reference, "superquadric-" + name, **BOUNDS)
    shown.Visibility = 1


def one_glyph(failures, view):
    """Every form against the source; then exponents from an array against those of the property. One representation for all:
    its programs are compiled once for each form."""
    three = numpy.array([[4.0, 4.0, 1.0]])
    points = session.source(session.poly_data(numpy.zeros((1, 3)), size=numpy.array([SCALE]), turn=numpy.array([[0.0, 0.0, TURN]]),
                                              e1=numpy.array([4.0]), e2=three[:, 1:], e3=three,
                                              blockiness=numpy.array([[6.0, 1.5]])))
    shown = session.glyphs(points, view, "Superquadric", ScaleFactor=1.0, SelectScaleArray="size",
                           ScaleMode="Vector Components", Orient=1, SelectOrientationVectors="turn",
                           OrientationMode="Rotation")
    if shown.GlyphExponentArray != "blockiness":
        failures.append("GlyphExponentArray is %s by default" % shown.GlyphExponentArray)
    shown.GlyphExponentArray = "None"
    their = theirs(view)
    same_as_source(failures, view, shown, their, [("ball", (2, 2, 2), 2.0, 2.0), ("octahedron", (1, 1, 1), 1.0, 1.0),
                                                  ("box", (8, 8, 8), 8.0, 8.0), ("star", (0.7, 0.7, 0.7), 0.7, 0.7)])

    def picture(array, exponents=(3, 3, 3)):
        shown.GlyphExponentArray, shown.GlyphExponents = array, exponents
        return session.capture(view, "superquadrics-%s" % array)

    wanted, even = picture("None", (4, 4, 1)), picture("None", (4, 4, 4))
    for array, expected in (("e3", wanted), ("e2", wanted), ("e1", even)):
        if (picture(array) != expected).any():
            failures.append("the array %s makes another picture than the property" % array)
    if (even == wanted).all():
        failures.append("the exponents make no difference")

    # Of two components the first is across; in the nested form, along.
    shown.GlyphShape, shown.GlyphExponentArray = "Nested Superquadric", "blockiness"
    same_as_source(failures, view, shown, their, [("nested", (2, 2, 2), 6.0, 1.5)])
    pv.Delete(shown)
    pv.Delete(points)


def bad_exponents(failures, view):
    """Zero, negative and non-finite exponents make no glyph; of wrong arrays one hears, and the property counts."""
    bad = numpy.full((3, 3), 2.0)
    bad[0, 1], bad[2, 2] = -1.0, numpy.nan
    cases = [("bad", (2, 2, 2), "2 of 3 points", 1), ("None", (2, 0, 2), "GlyphExponents are 2, 0, 2", 0),
             ("four", (2, 2, 2), "4 components where 1, 2 or 3 are needed", 3), ("nonesuch", (2, 2, 2), "'nonesuch'", 3)]
    points = session.source(session.poly_data(LINE, bad=bad, four=numpy.ones((3, 4))))
    shown = session.glyphs(points, view, "Superquadric", ScaleFactor=0.5, Orient=0)
    for array, exponents, words, glyphs in cases:
        shown.GlyphExponentArray, shown.GlyphExponents = array, exponents
        text = session.messages(lambda: (pv.Render(view), pv.Render(view)))
        if text.count(words) != 1:
            failures.append("%s: '%s' is said %d times: %s" % (array, words, text.count(words), text))
        mask = comparison.covered(session.capture(view, "superquadrics-" + array))
        # Columns of pixels that are covered lie apart: one group for each glyph.
        seen = int((numpy.diff(mask.any(axis=0).astype(int), prepend=0) == 1).sum())
        print("%s: %d glyphs; %s" % (array, seen, text.strip()))
        if seen != glyphs:
            failures.append("%s: %d glyphs instead of %d" % (array, seen, glyphs))
    pv.Delete(shown)
    pv.Delete(points)


def main():
    failures = []
    view = session.view(320, 240)
    session.look(view, (0.9, 0.7, 2.2))
    one_glyph(failures, view)
    flat = session.view(300, 150)
    session.look(flat, (0.0, 0.0, 6.0))
    bad_exponents(failures, flat)
    session.finish(failures)


if __name__ == "__main__":
    session.load()
    main()
