"""The point in space under a pixel, which is where ParaView's window puts a picked center of rotation: it lies on the
glyph that is seen there.

Usage: pvpython picked_point.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

SIZE = 0.8
CENTERS = numpy.array([[-0.7, 0.0, 0.4], [0.7, 0.2, -0.3]])


def sources():
    """Points without cells, and the same as vertices."""
    vertices = session.with_cells(session.poly_data(CENTERS), "Verts", [[point] for point in range(len(CENTERS))])
    return (("points without cells", session.poly_data(CENTERS)), ("vertices", vertices))


def distance(shape, center, place):
    """How far a place is from the surface of a glyph."""
    offset = numpy.array(place) - center
    surface = numpy.linalg.norm(offset) if shape == "Sphere" else numpy.abs(offset).max()
    return abs(surface - SIZE / 2)


def main():
    """Spheres and boxes, before a plane that must not be taken, with both projections."""
    session.load()
    checks = Checks()
    view = session.view(240, 180)
    pv.Show(pv.Plane(Origin=[-2, -1.5, -1], Point1=[2, -1.5, -1], Point2=[-2, 1.5, -1]), view)
    for name, data in sources():
        shown = session.glyphs(session.source(data), view, Orient=0, ScaleFactor=SIZE)
        for scale in (None, 1.5):
            session.look(view, (0.0, 0.0, 6.0), parallel_scale=scale)
            for shape in ("Sphere", "Box"):
                session.assign_shape(shown, shape)
                pv.Render(view)
                for center in CENTERS:
                    what = "%s as %s, %s projection" % (name, shape, "perspective" if scale is None else "parallel")
                    seen = center + (0.1, 0.15, 0.35)
                    place, normal = [0.0] * 3, [0.0] * 3
                    hit = view.SMProxy.ConvertDisplayToPointOnSurface(session.pixel_of(view, seen), place, normal, False)
                    print(what, hit, numpy.round(place, 4))
                    checks.true(what + ": no surface is found", hit)
                    off = distance(shape, center, place)
                    checks.true("%s: %s is %.3f from the glyph's surface" % (what, numpy.round(place, 3), off), off <= 0.01 * SIZE)
                    checks.true("%s: %s is not under the pixel" % (what, numpy.round(place, 3)),
                                numpy.abs(numpy.array(place) - seen)[:2].max() <= 0.05)
        pv.Delete(shown)
    checks.report()


if __name__ == "__main__":
    main()
