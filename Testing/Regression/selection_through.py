"""What a click selects: the glyph or the surface that is seen there, and never what lies behind it.

Usage: pvpython selection_through.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

SURFACE = "Ray Traced Surface"
WIDTH, HEIGHT = 240, 180
#: world units from the middle of the picture to its upper edge
SCALE = 1.5


def pixel(x, y):
    """The pixel of a place in the plane of the picture."""
    return round(WIDTH / 2 + x * HEIGHT / 2 / SCALE), round(HEIGHT / 2 + y * HEIGHT / 2 / SCALE)


def expect(checks, what, view, kind, at, source, wanted, of=None):
    """A click for points or cells selects that point or cell of the source and nothing else; of: what, where not as asked."""
    found = session.picked(view, kind, at)
    print("%s: %s" % (what, [("its own" if entry[0] == source.SMProxy else "another's",) + entry[1:] for entry in found]))
    checks.equal(what + ": selected of what is seen", [entry[1:] for entry in found if entry[0] == source.SMProxy],
                 [(of or kind, wanted)])
    checks.equal(what + ": selected of what lies behind", [entry[1:] for entry in found if entry[0] != source.SMProxy], [])


def stage():
    """A view with an ordinary plane behind all that is shown in it."""
    view = session.view(WIDTH, HEIGHT)
    plane = pv.Plane(XResolution=16, YResolution=12, Origin=[-2, -1.5, -1], Point1=[2, -1.5, -1], Point2=[-2, 1.5, -1])
    pv.Show(plane, view)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=SCALE)
    return view, plane


def glyphs(checks):
    """Glyphs are points; where the data are vertices, they are cells, too. Without cells of their own they are points always."""
    view, plane = stage()
    points = numpy.array([[-1.0, 0.0, 0.0], [0.0, 0.5, 0.0], [1.0, 0.0, 0.0]])
    bare = session.poly_data(points)
    vertices = session.with_cells(session.poly_data(points), "Verts", [[2], [0], [1]])  # cell 0 is point 2, and so on
    triangle = session.with_cells(session.poly_data(points), "Polys", [[0, 1, 2]])
    displays = session.Stage(view)
    for name, data, cell_ids in (("points without cells", bare, (None,) * 3), ("vertices", vertices, (1, 2, 0)),
                                 ("corners of a triangle", triangle, (None,) * 3)):
        for shape in ("Sphere", "Mesh"):
            shown = displays.show(data, shape, Orient=0, ScaleFactor=0.6)
            source = displays.source
            if shape == "Mesh":
                shown.GlyphType = session.triangles(pv.Sphere())
            pv.Render(view)
            for i, (x, y, _) in enumerate(points):
                at = pixel(x + 0.05, y)
                expect(checks, "%s as %s, point %d" % (name, shape, i), view, "POINT", at, source, i)
                cell = cell_ids[i]
                expect(checks, "%s as %s, cell of point %d" % (name, shape, i), view, "CELL", at, source,
                       i if cell is None else cell, of="POINT" if cell is None else None)
    displays.close()
    found = session.picked(view, "CELL", pixel(0.05, 0.05))
    checks.equal("where no glyph is, the plane", [entry[0] for entry in found], [plane.SMProxy])
    pv.Delete(view)


def surfaces(checks):
    """A surface gives out the cell that is hit, and the corner of the hit triangle that is nearest to the click."""
    view, _ = stage()
    quads = pv.Plane(XResolution=4, YResolution=3, Origin=[-2, -1.5, 0], Point1=[2, -1.5, 0], Point2=[-2, 1.5, 0])
    shown = pv.Show(quads, view)
    shown.SetRepresentationType(SURFACE)
    pv.Render(view)
    for column, row in ((0, 0), (1, 1), (3, 2)):
        cell, corner = row * 4 + column, row * 5 + column
        for dx, dy, point in ((0.2, 0.1, corner), (0.9, 0.2, corner + 1), (0.1, 0.8, corner + 5), (0.8, 0.9, corner + 6)):
            at = pixel(column - 2 + dx, row - 1.5 + dy)
            expect(checks, "surface, cell %d" % cell, view, "CELL", at, quads, cell)
            expect(checks, "surface, point %d" % point, view, "POINT", at, quads, point)
    pv.Delete(shown)
    pv.Delete(view)


def hyper_tree_grid(checks):
    """Glyphs of a hyper tree grid are its cells, and so are the parts of its surface."""
    data, leaves = session.hyper_tree_grid()
    view, _ = stage()
    source = session.source(data)
    for kind in (session.REPRESENTATION, SURFACE):
        shown = session.glyphs(source, view, Orient=0, ScaleFactor=0.6)
        shown.SetRepresentationType(kind)
        pv.Render(view)
        for cell, center in leaves.items():
            at = pixel(*(center[:2] + 0.03))
            expect(checks, "hyper tree grid as %s, cell %d" % (kind, cell), view, "CELL", at, source, cell)
        pv.Delete(shown)
    pv.Delete(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    glyphs(checks)
    surfaces(checks)
    hyper_tree_grid(checks)
    checks.report()


if __name__ == "__main__":
    main()
