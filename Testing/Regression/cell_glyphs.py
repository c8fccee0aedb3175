"""Glyphs at the centers of cells, with GlyphLocation Cells and of hyper tree grids: lists offer the arrays of cells, pictures are those of points
put at the centers by hand, ghost cells have no glyph, and selecting picks cells.

Usage: pvpython cell_glyphs.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_EMPTY_CELL, VTK_HEXAHEDRON, VTK_TETRA, VTK_TRIANGLE, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet, vtkUnstructuredGrid)


import session
from checks import Checks

#: the arrays that the properties of a hyper tree grid's glyphs are to offer
OFFERED = {
    "SelectScaleArray": ("size", "extent"), "SelectOrientationVectors": ("flow",), "GlyphTensorArray": ("stress",),
    "VelocityArray": ("flow",), "AccelerationArray": ("flow",), "AngularVelocityArray": ("flow",),
    "GlyphExponentArray": ("size", "extent"), "PointIdArray": ("size",), "GlyphTableIndexArray": ("size",)}
GHOST = vtkDataSetAttributes.DUPLICATECELL
RANDOM = numpy.random.default_rng(7)


def arrays(count):
    """Cell arrays of each kind."""
    half = RANDOM.normal(size=(count, 3, 3))
    return {"size": RANDOM.uniform(0.3, 0.9, count), "extent": RANDOM.uniform(0.3, 0.9, (count, 3)), "flow": RANDOM.normal(size=(count, 3)),
            "stress": (0.2 * half @ half.transpose(0, 2, 1)).reshape(count, 9)}


def with_arrays(data, values, ghosts=None):
    """Cells get the arrays; points one of another name, which no list may offer then."""
    session.add_arrays(data, data.GetCellData(), **values)
    if data.IsA("vtkDataSet"):
        session.add_arrays(data, **{"of points": numpy.ones(data.GetNumberOfPoints())})
    if ghosts is not None:
        session.add_arrays(data, data.GetCellData(), vtkGhostType=numpy.array(ghosts, dtype=numpy.uint8))
    return data


def image():
    """(data, centers of the cells that show, their numbers): 3 x 2 cells, of which one is another process's."""
    data = vtkImageData()
    data.SetDimensions(4, 3, 2)
    data.SetOrigin(-1.5, -1.0, -0.5)
    centers = numpy.array([[x, y - 0.5, 0.0] for y in range(2) for x in (-1, 0, 1)], dtype=float)
    values = arrays(6)
    return with_arrays(data, values, [0, 0, GHOST, 0, 0, 0]), centers, [0, 1, 3, 4, 5], values


def grid():
    """The same of an unstructured grid with an empty cell, which has no center."""
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float) - (1.3, 0.5, 0.5)
    points = vtkPoints()
    for corner in numpy.concatenate([corners, corners + (1.5, 0.0, 0.0)]):
        points.InsertNextPoint(corner)
    data = vtkUnstructuredGrid()
    data.SetPoints(points)
    for kind, ids in ((VTK_HEXAHEDRON, range(8)), (VTK_EMPTY_CELL, ()), (VTK_TETRA, (8, 9, 11, 12)), (VTK_TRIANGLE, (13, 14, 15))):
        data.InsertNextCell(kind, len(ids), list(ids))
    # vtkCell's parametric centers: means of the corners, and those of all corners for a hexahedron.
    place = lambda ids: numpy.mean([points.GetPoint(i) for i in ids], axis=0)
    centers = numpy.array([place(range(8)), [0.0, 0.0, 0.0], place((8, 9, 11, 12)), place((13, 14, 15))])
    values = arrays(4)
    return with_arrays(data, values), centers, [0, 2, 3], values


def trees():
    """The same of a hyper tree grid: two trees beside each other, one of them refined and so without a glyph of its own."""
    data, leaves = session.hyper_tree_grid()
    numbers, centers = list(leaves), numpy.zeros((data.GetNumberOfCells(), 3))
    centers[numbers] = list(leaves.values())
    values, ghosts = arrays(len(centers)), numpy.zeros(len(centers))
    ghosts[numbers[1]] = GHOST
    return with_arrays(data, values, ghosts), centers, numbers[:1] + numbers[2:], values


def offered(shown, name):
    """The arrays that a property's list shows."""
    domain = shown.SMProxy.GetProperty(name).GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


def lists(checks, stage, data):
    """They follow GlyphLocation both ways, which hyper tree grids have no need of."""
    shown = stage.show(data, "Sphere", Orient=0)
    if not data.IsA("vtkDataSet"):
        for name, wanted in OFFERED.items():
            found = offered(shown, name)
            checks.true("%s offers %s, not %s" % (name, found, list(wanted)), set(wanted) <= set(found))
        return
    for location, wanted, other in (("Points", "of points", "size"), ("Cells", "size", "of points"), ("Points", "of points", "size")):
        stage.settings.add({"GlyphLocation": location})
        found = offered(shown, "GlyphRadiusArray")
        checks.true("%s: GlyphRadiusArray offers %s" % (location, found), wanted in found and other not in found)


def pictures(checks, what, stages, count):
    """Of cells, beside those of points at their centers; stages: by GlyphLocation, with their data and hidden."""
    cases = (("size", "Sphere", {"ScaleMode": "Magnitude", "SelectScaleArray": "size", "Orient": 0}), ("direction", "Arrow", {"SelectOrientationVectors": "flow"}),
             ("extent", "Box", {"SelectScaleArray": "extent", "ScaleMode": "Vector Components", "Orient": 0}),
             ("tensor", "Tensor Ellipsoid", {"GlyphTensorArray": "stress"}),
             ("velocity", "Sphere", {"MotionBlur": 1, "VelocityArray": "flow", "Orient": 0, "SamplesPerPixel": 8}))
    for name, shape, properties in cases:
        seen = []
        for location, association in (("Points", "POINTS"), ("Cells", "CELLS")):
            settings, view = stages[location].settings, stages[location].view
            shown = settings.shown

            def draw():
                where = {"GlyphLocation": location} if what != "trees" else {}
                settings.set({"Visibility": 1, **where, **session.shaped(shape), "ScaleFactor": 0.5, **properties})
                pv.ColorBy(shown, (association, "size"))
                shown.LookupTable.RescaleTransferFunction(0.0, 1.0)
                shown.SetScalarBarVisibility(view, False)
                pv.Render(view)

            said = session.messages(draw)
            checks.no_message("%s, %s of %s" % (what, name, location), said)
            checks.equal("%s, %s: glyphs" % (what, name), session.statistics(shown)["glyphs"], count)
            seen.append(session.capture(view, "cell-glyphs-%s-%s-%s" % (what, name, location)))
            stages[location].hide()
        checks.covered("%s, %s" % (what, name), seen[0], 0.005)
        checks.picture("%s, %s" % (what, name), seen[1], seen[0], pixels=0.001, mean=0.1)


def selecting(checks, stage, what, data, centers, numbers):
    """Cells are selected, also where points are asked for."""
    stage.show(data, "Sphere", ScaleFactor=0.5, GlyphLocation="Cells", Orient=0)
    view = stage.view
    pv.Render(view)
    for number in numbers:
        x, y = session.pixel_of(view, centers[number])
        for kind in ("CELL", "POINT"):
            found = session.picked(view, kind, (x, y))
            checks.equal("%s: selecting a %s at the center of cell %d" % (what, kind, number), found, [(stage.source.SMProxy, "CELL", number)])
    stage.hide()


def blocks(checks, view):
    """Cells of a composite, one of whose blocks has no cells."""
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, grid()[0])
    data.SetBlock(1, session.poly_data(numpy.zeros((2, 3))))
    data.SetBlock(2, image()[0])
    shown = session.glyphs(session.source(data), view, GlyphLocation="Cells", Orient=0)
    said = session.messages(lambda: pv.Render(view))
    checks.no_message("blocks", said)
    checks.equal("blocks: glyphs", session.statistics(shown)["glyphs"], 8)
    pv.Delete(shown)


def vertices(checks, view):
    """Points of a composite by the colors of their vertices, behind a block of points that has none."""
    pictures = []
    for count in (0, 1000):
        points = session.with_cells(session.poly_data(numpy.array([[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]])), "Verts", [[0], [1]])
        session.add_arrays(points, points.GetCellData(), value=numpy.array([0.0, 1.0]))
        data = vtkMultiBlockDataSet()
        data.SetBlock(0, session.poly_data(numpy.full((count, 3), 100.0)))
        data.SetBlock(1, points)
        shown = session.glyphs(session.source(data), view, Orient=0, ScaleFactor=0.5)
        pv.ColorBy(shown, ("CELLS", "value"))
        shown.LookupTable.RescaleTransferFunction(0.0, 1.0)
        shown.SetScalarBarVisibility(view, False)
        pv.Render(view)
        checks.equal("vertices: glyphs", session.statistics(shown)["glyphs"], count + 2)
        pictures.append(session.capture(view, "cell-glyphs-vertices-%d" % count))
        pv.Delete(shown)
    middle = pictures[0].shape[0] // 2
    left, right = (pictures[0][middle, session.pixel_of(view, (x, 0.0, 0.0))[0]].astype(int) for x in (-0.5, 0.5))
    checks.true("vertices: blue %s and red %s" % (left, right), left[2] > left[0] + 50 and right[0] > right[2] + 50)
    checks.equal("vertices behind points: pixels that differ", int((pictures[0] != pictures[1]).sum()), 0)


def main():
    """Of a structured and an unstructured grid, and of a hyper tree grid."""
    session.load()
    checks = Checks()
    view = session.view(200, 150)
    session.look(view, (0.0, 0.0, 5.0))
    points = session.Stage(view)
    for what, (data, centers, numbers, values) in (("image", image()), ("grid", grid()), ("trees", trees())):
        # ParaView has a kind of display for each kind of data.
        cells = session.Stage(view)
        lists(checks, cells, data)
        cells.hide()
        # Before the pictures, which leave a coloring.
        if what != "trees":  # selection_through.py
            selecting(checks, cells, what, data, centers, numbers)
        points.show(session.poly_data(centers[numbers], **{name: array[numbers] for name, array in values.items()}))
        points.hide()
        pictures(checks, what, {"Points": points, "Cells": cells}, len(numbers))
        cells.close()
    points.close()
    blocks(checks, view)
    vertices(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
