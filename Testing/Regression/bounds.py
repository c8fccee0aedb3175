"""Bounds of tensor glyphs: they take the largest product of scale and eigenvalue, not the largest of either.

Usage: pvpython bounds.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

POINTS = numpy.array([[-0.4, -0.4, 0.0], [0.4, -0.4, 0.0], [-0.4, 0.4, 0.0], [0.4, 0.4, 0.0]])
#: one large scale and one large tensor, on different points: each glyph is 0.3 wide
SCALES = numpy.array([1.0, 100.0, 0.1, 1.0])
WIDTH = 0.3
#: half of the box around the glyphs: as tight as it can be, and with balls around glyphs that might be turned anyhow
TIGHT = numpy.array([0.4, 0.4, 0.0]) + WIDTH / 2
LOOSE = numpy.array([0.4, 0.4, 0.0]) + WIDTH / 2 * numpy.sqrt(3.0)


def tensors(matrix):
    """The matrix at each point, over the point's scale."""
    return (numpy.array(matrix, dtype=float)[None] / SCALES[:, None, None]).reshape(-1, 9)


def distance(half):
    """How far from its middle ParaView's ResetCamera looks at a box, with a view angle of 30 degrees."""
    return float(numpy.linalg.norm(half) / numpy.sin(numpy.radians(15.0)))


def check(checks, name, array, **properties):
    """Camera, clipping range and axes grid of one kind of glyphs."""
    view = session.view(160, 120)
    source = session.source(session.poly_data(POINTS, t=array, s=SCALES))
    shown = session.glyphs(source, view, "Tensor Ellipsoid", GlyphTensorArray="t", ScaleMode="Magnitude", SelectScaleArray="s",
                           ScaleFactor=WIDTH, **properties)
    session.solid(shown, (0.9, 0.8, 0.3))
    session.look(view, (0.0, 0.0, 5.0))
    view.AxesGrid.Visibility = 1
    pv.Render(view)
    pv.ResetCamera(view)
    pv.Render(view)
    away = float(numpy.linalg.norm(numpy.subtract(view.CameraPosition, view.CameraFocalPoint)))
    bounds = numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
    near, far = view.SMProxy.GetRenderer().GetActiveCamera().GetClippingRange()
    print("%s: camera %.3f away, clipping range %.3f to %.3f, bounds %s" % (name, away, near, far, numpy.round(bounds, 3).tolist()))
    low, high = distance(TIGHT), distance(LOOSE)
    checks.within(name + ": distance of the camera", round(away, 3), round(0.98 * low, 3), round(1.02 * high, 3))
    checks.within(name + ": depth of the clipping range", round(far - near, 3), 0.2, round(0.5 * away, 3))
    half = numpy.abs(bounds).max(axis=1)
    # The axes grid adds a little for its own.
    checks.true("%s: bounds reach to %s, glyphs to %s" % (name, numpy.round(half, 3), TIGHT), (half >= 0.999 * TIGHT).all())
    checks.true("%s: bounds reach to %s, glyphs that may be turned to %s" % (name, numpy.round(half, 3), LOOSE),
                (half <= 1.2 * LOOSE).all())
    view.AxesGrid.Visibility = 0
    checks.covered(name, session.capture(view, "bounds-" + name.replace(" ", "-")), 0.03)
    pv.Delete(view)


def check_shrinking(checks):
    """Glyphs that have become smaller: the clipping range is theirs at once, so that an edit without effect traces nothing."""
    view = session.view(160, 120)
    shown = session.glyphs(session.source(session.poly_data(POINTS)), view, "Box", Orient=0, ScaleFactor=2.0)
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    ranges, traced = [], []
    for factor, heads in ((0.2, "Fixed"), (0.2, "Scaled")):
        shown.ScaleFactor, shown.ArrowHeads = factor, heads
        pv.Render(view)
        ranges.append(view.SMProxy.GetRenderer().GetActiveCamera().GetClippingRange())
        traced.append(session.statistics(shown)["dispatches"])
    checks.equal("clipping range after an edit without effect", ranges[1], ranges[0])
    checks.equal("images traced after an edit without effect", traced[1], traced[0])
    pv.Delete(view)


def main():
    """Eigenvalues, and the axes of antisymmetric parts, which have a reach of their own."""
    session.load()
    checks = Checks()
    check(checks, "eigenvalues", tensors(numpy.eye(3)))
    # An axis as long as the balls are wide, along x, where the symmetric part is the ball.
    turning = [[1.0, 0.0, 0.0], [0.0, 1.0, -0.5], [0.0, 0.5, 1.0]]
    check(checks, "axes", tensors(turning), GlyphTensorAxis=1)
    check_shrinking(checks)
    checks.report()


if __name__ == "__main__":
    main()
