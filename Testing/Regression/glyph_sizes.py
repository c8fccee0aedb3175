"""Sizes of glyphs: functions of magnitudes, limits, and ratios that are kept.

Usage: pvpython glyph_sizes.py
"""
import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

WIDTH, HEIGHT = 900, 300
#: world units from the middle of the picture to its upper edge
SCALE = 0.5
POINTS = numpy.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
MAGNITUDES = numpy.array([0.5, 4.0, 1000.0])
#: error of a length that is measured in pixels
PIXEL = 1.5 * 2 * SCALE / HEIGHT

FUNCTIONS = {
    "Linear": lambda s: s,
    "Square Root": numpy.sqrt,
    "Cube Root": numpy.cbrt,
    "Logarithm": lambda s: numpy.log10(1.0 + s),
    "All the Same": lambda s: s / s,
}


def extents(view, name):
    """Width and height of what each third of the picture shows, in world units."""
    covered = comparison.covered(session.capture(view, "glyph-sizes-" + name.lower().replace(" ", "-")))
    found = []
    for third in numpy.split(covered, 3, axis=1):
        found.append([float(third.any(axis=axis).sum()) * 2 * SCALE / HEIGHT for axis in (0, 1)])
    return numpy.array(found)


def glyphs(stage, shape, **properties):
    """The representation of the three points."""
    vectors = MAGNITUDES[:, None] * numpy.array([1.0, 0.5, 0.25])
    tensors = numpy.array([numpy.diag(-0.5 * vector) for vector in vectors]).reshape(-1, 9)
    shown = stage.show(session.poly_data(POINTS, s=-MAGNITUDES, v=vectors, t=tensors), shape, Orient=0, **properties)
    session.solid(shown, (0.9, 0.8, 0.3))
    pv.Render(stage.view)
    return shown


def functions(checks, stage):
    """Scalars, components and tensors; the largest glyph is 0.6 wide."""
    for name, function in FUNCTIONS.items():
        for kind, properties, factor in (
                ("magnitudes", {"SelectScaleArray": "s", "ScaleMode": "Magnitude"}, 1.0),
                ("components", {"SelectScaleArray": "v", "ScaleMode": "Vector Components"}, 1.0),
                ("tensors", {"GlyphTensorArray": "t"}, 0.5)):
            lengths = function(factor * MAGNITUDES)
            largest = 0.6 / lengths.max()
            shape = "Tensor Ellipsoid" if kind == "tensors" else "Sphere"
            glyphs(stage, shape, ScaleFactor=largest, GlyphScaleFunction=name, **properties)
            found = extents(stage.view, kind + "-" + name)
            ratio = 1.0 if kind == "magnitudes" else 0.5
            wanted = largest * lengths[:, None] * numpy.array([1.0, ratio])
            print(kind, name, numpy.round(found, 3).tolist(), numpy.round(wanted, 3).tolist())
            checks.true("%s, %s: sizes %s, not %s" % (kind, name, numpy.round(found, 3).tolist(), numpy.round(wanted, 3).tolist()),
                        numpy.abs(found - wanted).max() <= PIXEL)


def limits(checks, stage):
    """Nothing smaller or larger than the limits, with the ratios of its axes."""
    for limit, wanted in (((0.2, 0.0), [0.2, 0.2, 0.6]), ((0.0, 0.4), [0.0003, 0.0024, 0.4]), ((0.2, 0.4), [0.2, 0.2, 0.4])):
        glyphs(stage, "Sphere", SelectScaleArray="v", ScaleMode="Vector Components", ScaleFactor=0.0006,
               GlyphSizeRange=limit)
        found = extents(stage.view, "limits %g %g" % limit)
        wanted = numpy.array(wanted)[:, None] * numpy.array([1.0, 0.5])
        checks.true("limits %s: sizes %s, not %s" % (limit, numpy.round(found, 3).tolist(), numpy.round(wanted, 3).tolist()),
                    numpy.abs(found - wanted).max() <= PIXEL)


def bounds(checks, stage):
    """What the camera is reset to holds the glyphs, and not much more."""
    for name, properties in (("scalars", {"shape": "Sphere", "ScaleMode": "Magnitude", "SelectScaleArray": "s"}),
                             ("tensors", {"shape": "Tensor Superquadric", "GlyphTensorArray": "t"})):
        for how in ({"GlyphScaleFunction": "All the Same"}, {"GlyphSizeRange": [0.6, 0.6]}):
            glyphs(stage, ScaleFactor=0.6, **{**properties, **how})
            box = numpy.array(stage.view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
            checks.within("bounds of %s with %s" % (name, how), round(float(box[0, 1]), 3), 1.299, 1.3 + 0.3 * (3.0 ** 0.5 - 1) * 3)


def radii(checks, stage):
    """Lengths by one array, radii by another; an arrow's is its shaft's, and its head belongs to its shaft."""
    lengths, widths = numpy.array([0.3, 0.5, 0.6]), numpy.array([-0.04, 0.02, 0.03])
    thick = 2 * numpy.abs(widths) * 1.5
    # The head is three times as wide as the shaft; it is 7/6 of its width long, and the first arrow is shorter than that.
    head = 3 * thick
    short = 0.3 * lengths
    cases = {
        "Cylinder": ({"GlyphType": "Cylinder"}, lengths, thick), "Sphere": ({"GlyphType": "Sphere"}, lengths, thick),
        "Box": ({"GlyphType": "Box"}, lengths, thick),
        "fixed heads": ({"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.05, "GlyphType.TipRadius": 0.15, "GlyphType.TipLength": 0.35, "ArrowHeads": "Fixed"},
                        lengths, numpy.minimum(head, 6 / 7 * lengths)),
        "scaled heads": ({"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.05, "GlyphType.TipRadius": 0.15, "ArrowHeads": "Scaled"},
                         lengths, head),
        # Heads as long as the unit arrow: with these radii arrows are shorter than their heads and shrink as a whole.
        "short arrows": ({"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.05, "GlyphType.TipRadius": 0.25, "GlyphType.TipLength": 1.0,
                          "ArrowHeads": "Fixed", "ScaleFactor": 0.3}, short, numpy.minimum(5 * thick, 0.5 * short)),
        # Without a shaft the radius is the head's, and only heads are seen.
        "heads alone": ({"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.0, "GlyphType.TipRadius": 0.15, "GlyphType.TipLength": 0.35, "ArrowHeads": "Fixed"},
                        numpy.minimum(lengths, 7 / 6 * thick), thick),
    }
    data = session.poly_data(POINTS - [0.2, 0.0, 0.0], s=lengths, w=1.5 * widths, zero=numpy.array([0.0, 0.02, numpy.nan]))
    view = stage.view
    for name, (properties, long, wide) in cases.items():
        properties = {"ScaleFactor": 1.0, **properties}
        shown = stage.show(data, None, Orient=0, ScaleMode="Magnitude", SelectScaleArray="s",
                           GlyphRadiusArray="w", **properties)
        session.solid(shown, (0.9, 0.8, 0.3))
        pv.Render(view)
        found = extents(view, "radii " + name)
        wanted = numpy.stack([long, wide], axis=1)
        checks.true("radii, %s: sizes %s, not %s" % (name, numpy.round(found, 3).tolist(), numpy.round(wanted, 3).tolist()),
                    numpy.abs(found - wanted).max() <= PIXEL)
        box = numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
        checks.within("radii, %s: bounds along y" % name, float(box[1, 1]), 0.5 * wide.max(), 0.66)
    stage.close()
    shown = stage.show(data, "Cylinder", Orient=0, ScaleFactor=0.5)
    shown.GlyphRadiusArray = "zero"
    checks.one_message("radii that are not finite", session.messages(lambda: pv.Render(view)), "radius", "zero", "not finite", "1 of 3")
    checks.equal("glyphs without a radius", session.statistics(shown)["skippedGlyphs"], 2)
    shown.GlyphRadiusArray = "nowhere"
    checks.one_message("radii that are missing", session.messages(lambda: pv.Render(view)), "GlyphRadiusArray", "nowhere")
    stage.close()


def heads(checks, stage):
    """Fixed heads have their size on an arrow of the high quantile of lengths, which are those of the function."""
    glyphs(stage, "Arrow", ArrowHeads="Fixed", ScaleMode="Magnitude", SelectScaleArray="s", GlyphScaleFunction="All the Same", ScaleFactor=0.4, **{"GlyphType.TipRadius": 0.25})
    found = extents(stage.view, "heads")
    checks.true("arrows of unit length are %s long and thick" % numpy.round(found, 3).tolist(),
                numpy.abs(found - [0.4, 0.2]).max() <= PIXEL)


def wrong(checks, stage):
    """One message each."""
    shown = glyphs(stage, "Sphere", ScaleMode="Magnitude", SelectScaleArray="s", GlyphScaleFunction="Logarithm", ScaleFactor=0.1)
    said = session.messages(lambda: (setattr(shown, "GlyphSizeRange", [0.4, 0.2]), pv.Render(stage.view)))
    checks.one_message("GlyphSizeRange", said, "GlyphSizeRange", "0.4, 0.2")


def main():
    """All parts in one view."""
    session.load()
    checks = Checks()
    view = session.view(WIDTH, HEIGHT)
    session.look(view, (0.0, 0.0, 10.0), parallel_scale=SCALE)
    stage = session.Stage(view)
    for part in (functions, limits, bounds, radii, heads, wrong):
        part(checks, stage)
    checks.report()


if __name__ == "__main__":
    main()
