"""GlyphAnchor: glyphs that begin, end or have their middle at their points are those of points moved along the glyphs.

Usage: pvpython anchors.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

FACTOR = 0.8
#: where the unit glyph begins and ends along its own x axis
EXTENTS = {"Arrow": (0.0, 1.0), "Cone": (-0.5, 0.5), "Capsule": (-1.0, 1.0), "Sphere": (-0.5, 0.5), "Mesh": (0.0, 1.0)}
SHIFTS = {"Origin": lambda lower, upper: 0.0, "Tail": lambda lower, upper: -lower, "Center": lambda lower, upper: -0.5 * (lower + upper),
          "Tip": lambda lower, upper: -upper}
#: far from the origin, where centers need more than a float
MIDDLE = numpy.array([3e5, -2e5, 1e5])


def vectors():
    """Of different lengths and directions."""
    made = numpy.random.default_rng(5).normal(size=(24, 3))
    return made * (numpy.linspace(0.5, 1.2, 24) / numpy.linalg.norm(made, axis=1))[:, None]


def drawn(stage, shape, points, name, **properties):
    """(picture, bounds) of glyphs along vectors."""
    shown = stage.show(session.poly_data(points, along=vectors()), shape, Orient=1, SelectOrientationVectors="along", ScaleMode="Magnitude",
                       SelectScaleArray="along", ScaleFactor=FACTOR, **({"GlyphType.TipRadius": 0.2} if shape == "Arrow" else {}), **properties)
    session.solid(shown, (0.9, 0.8, 0.5))
    pv.Render(stage.view)
    picture = session.capture(stage.view, "anchors-%s-%s" % (shape.lower(), name.lower()))
    return picture, numpy.array(stage.view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2).T


def main():
    """All shapes and anchors; each where the other way of saying the same has it."""
    session.load()
    checks = Checks()
    view = session.view(240, 200)
    session.look(view, MIDDLE + [0.0, 0.0, 12.0], MIDDLE)
    stage = session.Stage(view)
    points = MIDDLE + numpy.random.default_rng(6).uniform(-2.0, 2.0, (24, 3))
    lengths = FACTOR * numpy.linalg.norm(vectors(), axis=1)
    directions = vectors() / numpy.linalg.norm(vectors(), axis=1)[:, None]
    for shape, (lower, upper) in EXTENTS.items():
        plain = None
        for anchor, shift in SHIFTS.items():
            by = shift(lower, upper)
            found, box = drawn(stage, shape, points, anchor, GlyphAnchor=anchor)
            moved = points + by * lengths[:, None] * directions
            wanted, _ = drawn(stage, shape, moved, anchor + "-moved")
            checks.picture("%s, %s" % (shape, anchor), found, wanted, pixels=0.0005, mean=0.05)
            checks.covered("%s, %s" % (shape, anchor), found, 0.01)
            ends = numpy.concatenate([moved + end * lengths[:, None] * directions for end in (lower, upper)])
            checks.true("%s, %s: bounds %s do not hold %s, %s" % (shape, anchor, box.tolist(), ends.min(axis=0), ends.max(axis=0)),
                        (box[0] <= ends.min(axis=0)).all() and (box[1] >= ends.max(axis=0)).all())
            plain = found if anchor == "Origin" else plain
            checks.true("%s: %s %s Origin" % (shape, anchor, "is not" if by == 0.0 else "is"), (found == plain).all() == (by == 0.0))
    checks.report()


if __name__ == "__main__":
    main()
