"""One particle that lies far away moves no other: the picture of the rest is that without it.

Usage: pvpython outlier.py
"""
import numpy

import comparison
import session

#: glyphs side by side, each some 40 pixels wide
POINTS = numpy.array([[x, y, 0.1 * x * y] for x in (-0.9, -0.3, 0.31, 0.87) for y in (-0.7, 0.02, 0.65)])
SIZE = 0.3


def picture(stage, outlier, shape, name):
    """The view along z: what lies far away along x is in no picture and moves no clipping plane."""
    points = POINTS if outlier is None else numpy.vstack([POINTS, [[outlier, 0.0, 0.0]]])
    shown = stage.show(session.poly_data(points, v=numpy.tile([1.0, 0.5, 0.3], (len(points), 1))), shape, ScaleFactor=SIZE, Orient=1,
                       SelectOrientationVectors="v", OrientationMode="Direction")
    session.solid(shown, (0.9, 0.8, 0.3))
    return session.capture(stage.view, "outlier-%s-%s" % (shape, name)).astype(float)


def main():
    """Compares the pictures."""
    session.load()
    failures = []
    view = session.view(300, 250)
    session.look(view, (0.0, 0.0, 5.0))
    stage = session.Stage(view)
    for shape in ("Sphere", "Box", "Arrow"):
        alone = picture(stage, None, shape, "none")
        if not comparison.covered(alone).any():
            failures.append("%s: nothing is shown" % shape)
        for outlier in (1e5, 1e7, 1e12, 1e30):
            difference = numpy.abs(picture(stage, outlier, shape, "%g" % outlier) - alone)
            if difference.max() > 2.0:
                failures.append("%s, one at %g: %d pixels differ by up to %g levels" %
                                (shape, outlier, (difference.max(axis=2) > 2.0).sum(), difference.max()))
    session.finish(failures)


if __name__ == "__main__":
    main()
