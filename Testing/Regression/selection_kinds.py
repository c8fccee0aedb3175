"""The ways of selecting in a view's tool bar, each on glyphs: rectangle, through (frustum), polygon and blocks; point
labels stand before the glyphs.

Usage: pvpython selection_kinds.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkCollection, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import session
from checks import Checks

WIDTH, HEIGHT = 250, 200
#: 5 x 4 places in the picture's plane, and the same behind them: points 0 to 19 are before 20 to 39
PLACES = numpy.array([[x, y, -2.0 * z] for z in range(2) for y in range(4) for x in range(5)], dtype=float)
#: lower left and upper right corner of a rectangle around the places 6, 7, 11, 12
CORNERS = numpy.array([[0.5, 0.5, 0.0], [2.5, 2.5, 0.0]])
INSIDE = [6, 7, 11, 12]
#: a triangle around the places 0, 1, 5 and no others
TRIANGLE = numpy.array([[-0.6, -0.6, 0.0], [1.85, -0.6, 0.0], [-0.6, 1.85, 0.0]])
IN_TRIANGLE = [0, 1, 5]


def points(part=slice(0, 40)):
    """Points that are cells, too: cell i is point i."""
    data = session.poly_data(PLACES[part], number=numpy.arange(40.0)[part])
    return session.with_cells(data, "Verts", [[point] for point in range(data.GetNumberOfPoints())])


def blocks():
    """The lower and the upper two rows, all in front."""
    made = vtkMultiBlockDataSet()
    for i in range(2):
        made.SetBlock(i, points(slice(10 * i, 10 * i + 10)))
    return made


def selected(select, *arguments):
    """What a call of the view's proxy selects: {field type: sorted ids}; of block selections, the blocks' selectors."""
    representations, sources = vtkCollection(), vtkCollection()
    select(*arguments, representations, sources)
    found = {}
    for i in range(sources.GetNumberOfItems()):
        source = pv.servermanager._getPyProxy(sources.GetItemAsObject(i))
        kind = source.GetXMLName()
        if "Block" in kind:
            values = list(source.Blocks if source.GetProperty("Blocks") else source.Selectors)
            found["BLOCK"] = found.get("BLOCK", []) + values
        elif "Frustum" in kind:
            found["FRUSTUM"] = list(source.Frustum)
        else:
            step = 3 if "Composite" in kind or "Hierarchical" in kind else 2
            ids = list(source.IDs)[step - 1::step]
            found[source.FieldType.GetData()] = sorted(found.get(source.FieldType.GetData(), []) + ids)
    return found


def region(view):
    """The rectangle in pixels."""
    (x0, y0), (x1, y1) = (session.pixel_of(view, corner) for corner in CORNERS)
    return [x0, y0, x1, y1]


def polygon(view):
    """The triangle in pixels."""
    corners = vtkIntArray()
    corners.SetNumberOfComponents(2)
    for corner in TRIANGLE:
        corners.InsertNextTuple(session.pixel_of(view, corner))
    return corners


def on_surface(checks, view, source, what):
    """Rectangle and polygon give the glyphs that are seen."""
    proxy = view.SMProxy
    for kind, rectangle, lasso in (("POINT", proxy.SelectSurfacePoints, proxy.SelectPolygonPoints),
                                   ("CELL", proxy.SelectSurfaceCells, proxy.SelectPolygonCells)):
        found = selected(lambda *a, f=rectangle: f(*a, 0), region(view))
        checks.equal("%s: %ss in a rectangle" % (what, kind), found, {kind: INSIDE})
        found = selected(lambda *a, f=lasso: f(*a, 0), polygon(view))
        checks.equal("%s: %ss in a polygon" % (what, kind), found, {kind: IN_TRIANGLE})


def through(checks, view, source, what):
    """A frustum gives all glyphs whose points are in it, those behind others, too, as ParaView asks the data themselves."""
    for kind, select, extract in (("POINT", view.SMProxy.SelectFrustumPoints, "POINT"), ("CELL", view.SMProxy.SelectFrustumCells, "CELL")):
        representations, sources = vtkCollection(), vtkCollection()
        select(region(view), representations, sources, 0)
        checks.equal("%s: %ss through: displays" % (what, kind), sources.GetNumberOfItems(), 1)
        if not sources.GetNumberOfItems():
            continue
        selection = pv.servermanager._getPyProxy(sources.GetItemAsObject(0))
        source.SMProxy.SetSelectionInput(0, selection.SMProxy, 0)
        extracted = pv.ExtractSelection(Input=source)
        extracted.UpdatePipeline()
        numbers = sorted(int(number) for number in session.array_of(extracted, "number"))
        checks.equal("%s: %ss through" % (what, kind), numbers, sorted(INSIDE + [i + 20 for i in INSIDE]))
        pv.Delete(extracted)
        source.SMProxy.CleanSelectionInputs(0)


def before_a_render(checks, view, source):
    """A selection that comes before the picture of the last one finds the glyphs that are seen."""
    pv.SelectPoints("number == 7", source)
    checks.equal("points after a new selection", selected(lambda *a: view.SMProxy.SelectSurfacePoints(*a, 0), region(view)), {"POINT": INSIDE})
    pv.Render(view)
    pv.ClearSelection(source)
    checks.equal("points after none", selected(lambda *a: view.SMProxy.SelectSurfacePoints(*a, 0), region(view)), {"POINT": INSIDE})
    pv.Render(view)


def with_a_bar(checks, view, source, shown):
    """Renders after a selection, with a scalar bar or without, leave OpenGL in order."""
    table = pv.GetColorTransferFunction("number")
    pv.ColorBy(shown, ("POINTS", "number"))
    bar = pv.GetScalarBar(table, view)
    bar.Visibility = 1
    pv.Render(view)
    selected(lambda *a: view.SMProxy.SelectSurfacePoints(*a, 0), region(view))
    for what, change in (("without the bar", lambda: setattr(bar, "Visibility", 0)), ("hidden", lambda: pv.Hide(source, view)),
                         ("shown again", lambda: pv.Show(source, view)), ("with the bar", lambda: setattr(bar, "Visibility", 1))):
        change()
        checks.no_message("after a selection, " + what, session.messages(lambda: pv.Render(view)))
    bar.Visibility = 0
    pv.ColorBy(shown, None)


def in_blocks(checks, view):
    """Selecting blocks gives the block of the glyph that is seen, as it does of ParaView's own points."""
    source = session.source(blocks())
    shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.7)
    shown.PointSize = 20.0
    found = {}
    for kind in ("Points", session.REPRESENTATION):
        shown.SetRepresentationType(kind)
        pv.Render(view)
        found[kind] = []
        for place in (3, 8, 17):
            at = session.pixel_of(view, PLACES[place])
            found[kind].append(selected(lambda *a: view.SMProxy.SelectSurfaceCells(*a, False, 0, True), [at[0], at[1], at[0], at[1]]))
    print("blocks: %s" % found)
    checks.true("ParaView's own points: no blocks are selected: %s" % found["Points"], all(len(one) == 1 for one in found["Points"]))
    checks.equal("blocks", found[session.REPRESENTATION], found["Points"])
    pv.Delete(shown)
    pv.Delete(source)


def labels(checks, view):
    """The label of a selected point is seen before its glyph, whose middle is behind the surface."""
    source = session.source(points(slice(0, 20)))
    shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.9)
    session.solid(shown, (0.9, 0.3, 0.3))
    shown.SelectionColor = [0.0, 1.0, 0.0]
    pv.SelectPoints("number == 7", source)
    counts = []
    for on in (0, 1):
        shown.SelectionPointLabelVisibility = on
        shown.SelectionPointFieldDataArrayName = "number"
        shown.SelectionPointLabelColor = [0.0, 0.0, 1.0]
        pv.Render(view)
        picture = session.capture(view, "selection-kinds-label-%d" % on).astype(int)
        x, y = session.pixel_of(view, PLACES[7])
        part = picture[HEIGHT - 1 - y - 15:HEIGHT - 1 - y + 15, x - 15:x + 15]
        counts.append(int(((part[..., 2] > 120) & (part[..., 2] > 2 * part[..., 1]) & (part[..., 2] > 2 * part[..., 0])).sum()))
    checks.equal("pixels of a label that is off", counts[0], 0)
    checks.within("pixels of a label over its glyph", counts[1], 10, 400)
    pv.ClearSelection(source)
    pv.Delete(shown)


def main():
    """All in one view, seen along z."""
    session.load()
    checks = Checks()
    view = session.view(WIDTH, HEIGHT, background=(0, 0, 0))
    session.look(view, (2.0, 1.5, 10.0), (2.0, 1.5, 0.0), parallel_scale=2.2)
    for shape in ("Sphere", "Box", "Mesh"):
        source = session.source(points())
        shown = session.glyphs(source, view, shape, Orient=0, ScaleFactor=0.7)
        if shape == "Mesh":
            shown.GlyphType = session.triangles(pv.Sphere())
        pv.Render(view)
        on_surface(checks, view, source, shape)
        if shape == "Sphere":
            through(checks, view, source, shape)
            before_a_render(checks, view, source)
            with_a_bar(checks, view, source, shown)
        pv.Delete(shown)
        pv.Delete(source)
    in_blocks(checks, view)
    labels(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
