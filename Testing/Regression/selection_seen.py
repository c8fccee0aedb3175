"""Selected glyphs and tubes have the selection's color, the others keep theirs, and nothing but colors is built anew.

Usage: pvpython selection_seen.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import session
from checks import Checks
from tubes import line_data

GREEN = (0.0, 1.0, 0.0)
#: 5 x 4 places in the picture's plane
PLACES = numpy.array([[x, y, 0.0] for y in range(4) for x in range(5)], dtype=float)
BUILDS = ("boundsBuilds", "instanceBuilds", "sorts", "structureBuilds")


def points():
    """A row of numbers, colors for them, and tensors with eigenvalues of both signs."""
    tensors = numpy.tile(numpy.diag([1.0, 0.6, -0.8]).reshape(9), (20, 1))
    return session.poly_data(PLACES, number=numpy.arange(20.0), tensor=tensors)


def blocks():
    """The same in two blocks of ten."""
    made = vtkMultiBlockDataSet()
    for i in range(2):
        part = slice(10 * i, 10 * i + 10)
        made.SetBlock(i, session.poly_data(PLACES[part], number=numpy.arange(20.0)[part]))
    return made


def is_green(color):
    """Whatever light falls on it."""
    return int(color[1]) > 60 and int(color[1]) > 2 * max(int(color[0]), int(color[2]))


def green_places(view, picture):
    """Numbers of the places whose glyphs have the selection's color."""
    at = [session.pixel_of(view, place) for place in PLACES]
    return [i for i, (x, y) in enumerate(at) if is_green(picture[picture.shape[0] - 1 - y, x])]


CASES = {
    "Sphere": (points, {"Scaling": 1, "ScaleMode": "Magnitude", "SelectScaleArray": "Van der Waals radii of number", "ScaleFactor": 0.3}, "number", range(7, 12)),
    "Box": (points, {"Orient": 0}, "number", range(19)),
    "Mesh": (points, {"Orient": 0}, "number", [3]),
    "Signed Tensor Superquadric": (points, {"GlyphTensorArray": "tensor", "GlyphTensorColoring": "Sign", "ScaleFactor": 0.35}, None, [0, 19]),
    "Tensor Ellipsoid": (points, {"GlyphTensorArray": "tensor", "GlyphTensorColoring": "Trace", "ScaleFactor": 0.35}, "number", [4, 5]),
    "Spherical Harmonics": (points, {"GlyphHarmonicsArray": "number", "GlyphTensorColoring": "Radius", "ScaleFactor": 0.06}, None, [5, 6, 11]),
    "Capsule": (blocks, {"Orient": 0, "ScaleFactor": 0.4}, "number", [2, 8, 9, 10, 17]),
}


def query(numbers):
    """The query of points with these numbers."""
    return " | ".join("(number == %d)" % number for number in numbers)


def shape_case(checks, stage, shape):
    """One shape: select, look, clear."""
    make, properties, array, wanted = CASES[shape]
    shown = stage.show(make(), shape, **{"ScaleFactor": 0.7, **properties})
    view, source = stage.view, stage.source
    if shape == "Mesh":
        shown.GlyphType = session.triangles(pv.Sphere())
    if array:
        pv.ColorBy(shown, ("POINTS", array))
        session.cool_to_warm(array)
    else:
        session.solid(shown, (0.9, 0.3, 0.3))
    shown.SelectionColor = list(GREEN)
    pv.Render(view)
    pv.HideUnusedScalarBars(view)
    shown.SetScalarBarVisibility(view, False)
    before = session.capture(view, "selection-seen-before")
    built = session.statistics(shown)
    checks.equal(shape + ": selected before anything is", green_places(view, before), [])
    pv.SelectPoints(query(wanted), source)
    pv.Render(view)
    found = session.capture(view, "selection-seen-" + shape.replace(" ", "-").lower())
    checks.equal(shape + ": selected", green_places(view, found), sorted(wanted))
    pv.ClearSelection(source)
    pv.Render(view)
    after = session.capture(view, "selection-seen-after")
    checks.true(shape + ": the picture is another one after the selection", (after == before).all())
    now = session.statistics(shown)
    for name in BUILDS:
        checks.equal("%s: %s of a selection" % (shape, name), now[name] - built[name], 0)


def cells(checks, view):
    """Glyphs of cells show what is selected of the cells, and nothing of the points."""
    grid = pv.Wavelet(WholeExtent=[0, 5, 0, 4, 0, 1])
    moved = pv.Transform(Input=grid)
    moved.Transform.Translate = [-0.5, -0.5, -0.5]
    shown = session.glyphs(moved, view, "Sphere", GlyphLocation="Cells", ScaleFactor=0.7)
    session.solid(shown, (0.9, 0.3, 0.3))
    shown.SelectionColor = list(GREEN)
    pv.Render(view)
    pv.SelectCells("(id == 6) | (id == 13)", moved)
    pv.Render(view)
    checks.equal("cells: selected", green_places(view, session.capture(view, "selection-seen-cells")), [6, 13])
    pv.ClearSelection(moved)
    pv.SelectPoints("id < 9", moved)
    pv.Render(view)
    checks.equal("cells: selected, of points", green_places(view, session.capture(view, "selection-seen-points")), [])
    pv.Delete(shown)


def bars(blocks):
    """Four lines of two pieces each beside each other, of which every other one is of another block, with arrays of points and of cells."""
    made = vtkMultiBlockDataSet()
    for part in range(2 if blocks else 1):
        lines = [y for y in range(4) if not blocks or y % 2 == part]
        data = line_data([[(0.0, y, 0.0), (2.0, y, 0.0), (4.0, y, 0.0)] for y in lines], {"line": numpy.array(lines, dtype=float)},
                         number=numpy.array([3.0 * y + i for y in lines for i in range(3)]))
        made.SetBlock(part, data)
    return made if blocks else made.GetBlock(0)


def tubes(checks, view):
    """Selected lines, and the pieces next to selected points; the others keep their colors, however these are made: to a level of 255, to which one color for all is rounded."""
    middles = [[1.0 + 2.0 * piece, y, 0.0] for y in range(4) for piece in range(2)]
    for name, colored, before in (("solid", None, 1), ("cells", ("CELLS", "line"), 1), ("points", ("POINTS", "number"), 1),
                                  ("colors of points", ("POINTS", "number"), 0)):
        source = session.source(bars(name == "cells"))
        shown = session.show(source, view, "Ray Traced Tubes", 1, TubeRadius=0.3, InterpolateScalarsBeforeMapping=before)
        if colored:
            pv.ColorBy(shown, colored)
            pv.GetColorTransferFunction(colored[1]).ApplyPreset("Cool to Warm", True)
            shown.SetScalarBarVisibility(view, False)
        else:
            session.solid(shown, (0.9, 0.3, 0.3))
        shown.SelectionColor = list(GREEN)
        pv.Render(view)
        plain = session.capture(view, "selection-seen-tubes")
        built = session.statistics(shown)
        for what, select, query_text, wanted in (("lines", pv.SelectCells, "(line == 1) | (line == 2)", [2, 3, 4, 5]),
                                                 ("a point", pv.SelectPoints, "number == 10", [6, 7]),
                                                 ("an end", pv.SelectPoints, "number == 0", [0])):
            select(query_text, source)
            pv.Render(view)
            picture = session.capture(view, "selection-seen-tubes-%s-%s" % (name.replace(" ", "-"), what.replace(" ", "-")))
            found = [i for i, (x, y) in enumerate(session.pixel_of(view, at) for at in middles) if is_green(picture[picture.shape[0] - 1 - y, x])]
            checks.equal("tubes, %s, %s: pieces in the color of the selection" % (name, what), found, wanted)
            others = numpy.zeros(picture.shape[:2], dtype=bool)
            for i, at in enumerate(middles):
                if i not in wanted:
                    x, y = session.pixel_of(view, at)
                    others[picture.shape[0] - 1 - y - 5:picture.shape[0] + 4 - y, x - 10:x + 11] = True
            checks.equal("tubes, %s, %s: pixels of others that have changed" % (name, what), int((numpy.abs(picture.astype(int) - plain).max(axis=2) > 1)[others].sum()), 0)
        pv.ClearSelection(source)
        pv.Render(view)
        checks.true("tubes, %s: the picture is another one after the selection" % name,
                    (session.capture(view, "selection-seen-tubes-after") == plain).all())
        now = session.statistics(shown)
        for count in BUILDS:
            checks.equal("tubes, %s: %s of a selection" % (name, count), now[count] - built[count], 0)
        pv.Delete(shown)
        pv.Delete(source)


def color(checks, view):
    """The color of ParaView's palette, and another one while something is selected."""
    source = session.source(points())
    shown = session.glyphs(source, view, "Sphere", ScaleFactor=0.7, Ambient=1.0, Diffuse=0.0)
    session.solid(shown, (0.9, 0.3, 0.3))
    pv.SelectPoints("number == 7", source)
    for wanted in (None, (0.0, 0.5, 1.0)):
        if wanted:
            shown.SelectionColor = list(wanted)
        pv.Render(view)
        x, y = session.pixel_of(view, PLACES[7] + [0.2, 0.2, 0.0])
        picture = session.capture(view, "selection-seen-color")
        expected = [round(255 * channel) for channel in wanted or shown.SelectionColor]
        checks.equal("color of a selected glyph", picture[picture.shape[0] - 1 - y, x, :3].tolist(), expected)
    pv.Delete(shown)


def main():
    """All in one view, seen along z."""
    session.load()
    checks = Checks()
    view = session.view(250, 200, background=(0, 0, 0))
    session.look(view, (2.0, 1.5, 10.0), (2.0, 1.5, 0.0), parallel_scale=2.2)
    stage = session.Stage(view)
    for shape in CASES:
        shape_case(checks, stage, shape)
    stage.close()
    cells(checks, view)
    tubes(checks, view)
    color(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
