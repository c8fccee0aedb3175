"""Every kind of data set with points draws its glyphs; blocks keep their visibility and colors.

Usage: pvpython data_types.py
For each kind the glyphs of eight known points must be where those points are.
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkRectilinearGrid,
    vtkStructuredGrid, vtkTable, vtkUnstructuredGrid)

import comparison
import session

#: the corners of the cube [-1, 1]^3, x fastest
CORNERS = numpy.array([[x, y, z] for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)])
#: from here no corner hides another
EYE = (2.2, 3.4, 8.0)


def coordinates(values):
    """vtkDoubleArray of a list."""
    array = vtkDoubleArray()
    for value in values:
        array.InsertNextValue(value)
    return array


def corner_points():
    """The corners as vtkPoints."""
    points = vtkPoints()
    for corner in CORNERS:
        points.InsertNextPoint(corner)
    return points


def image():
    """Image data with the corners as points."""
    data = vtkImageData()
    data.SetDimensions(2, 2, 2)
    data.SetOrigin(-1, -1, -1)
    data.SetSpacing(2, 2, 2)
    return data


def rectilinear():
    """Rectilinear grid with the corners as points."""
    data = vtkRectilinearGrid()
    data.SetDimensions(2, 2, 2)
    data.SetXCoordinates(coordinates([-1, 1]))
    data.SetYCoordinates(coordinates([-1, 1]))
    data.SetZCoordinates(coordinates([-1, 1]))
    return data


def structured():
    """Curvilinear grid with the corners as points."""
    data = vtkStructuredGrid()
    data.SetDimensions(2, 2, 2)
    data.SetPoints(corner_points())
    return data


def unstructured():
    """Unstructured grid without cells."""
    data = vtkUnstructuredGrid()
    data.SetPoints(corner_points())
    return data


def table():
    """The corners as a table with columns x, y, z."""
    data = vtkTable()
    for name, values in zip("xyz", CORNERS.T):
        column = coordinates(values)
        column.SetName(name)
        data.AddColumn(column)
    return data


def blocks(container):
    """The corners of the lower half in the first block, the upper half in the second."""
    halves = [session.poly_data(CORNERS[:4], half=numpy.zeros(4)), session.poly_data(CORNERS[4:], half=numpy.ones(4))]
    data = container()
    for index, half in enumerate(halves):
        if container is vtkMultiBlockDataSet:
            data.SetBlock(index, half)
            data.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), "half%d" % index)
        else:
            piece = vtkPartitionedDataSet()
            piece.SetPartition(0, half)
            data.SetPartitionedDataSet(index, piece)
    return data


KINDS = {
    "poly data": lambda: session.poly_data(CORNERS),
    "image data": image,
    "rectilinear grid": rectilinear,
    "structured grid": structured,
    "unstructured grid": unstructured,
    "multiblock": lambda: blocks(vtkMultiBlockDataSet),
    "partitioned collection": lambda: blocks(vtkPartitionedDataSetCollection),
}


def pixel(point, width, height):
    """Column and row at which the camera at EYE, looking at the origin, sees a point."""
    eye = numpy.array(EYE)
    forward = -eye / numpy.linalg.norm(eye)
    right = numpy.cross(forward, (0.0, 1.0, 0.0))
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, forward)
    offset = numpy.asarray(point) - eye
    scale = 0.5 * height / (offset @ forward * numpy.tan(numpy.radians(15.0)))
    return int(0.5 * width + scale * (offset @ right)), int(0.5 * height - scale * (offset @ up))


def seen(pixels):
    """For each corner, whether a glyph covers it."""
    mask = comparison.covered(pixels)
    height, width = mask.shape
    columns_rows = [pixel(corner, width, height) for corner in CORNERS]
    return [bool(mask[row, column]) for column, row in columns_rows]


def kinds(view):
    """Each kind of data set shows eight spheres and nothing else, by a display of its own: the picture of another one would pass, too."""
    failures, expected = [], None
    for name, make in KINDS.items():
        points = session.source(make())
        shown = session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=0.5)
        session.solid(shown, (1.0, 1.0, 0.0))
        pv.Render(view)
        pixels = session.capture(view, "data-" + name.replace(" ", "-"))
        if not all(seen(pixels)):
            failures.append("%s: glyphs seen at the corners: %s" % (name, seen(pixels)))
        if expected is None:
            expected = pixels
        elif (pixels != expected).any():
            failures.append("%s: looks different from poly data" % name)
        if name == "multiblock":
            failures += block_attributes(view, shown)
        pv.Delete(shown)
        pv.Delete(points)
    return failures


def block_attributes(view, shown):
    """Hiding and coloring one block of a multiblock, whose display is deleted then."""
    failures = []
    for selector, expected in (("/Root/half0", CORNERS[:, 2] < 0), ("/Root/half1", CORNERS[:, 2] > 0)):
        shown.BlockSelectors = [selector]
        pv.Render(view)
        found = seen(session.capture(view, "data-block" + selector[-1]))
        if found != list(expected):
            failures.append("BlockSelectors %s: glyphs seen %s" % (selector, found))
    shown.BlockSelectors = ["/"]
    shown.BlockColors = ["/Root/half1", "0", "0", "1"]
    pv.Render(view)
    pixels = session.capture(view, "data-blockcolor")
    column, row = pixel(CORNERS[7], pixels.shape[1], pixels.shape[0])
    first_column, first_row = pixel(CORNERS[0], pixels.shape[1], pixels.shape[0])
    if pixels[row, column, 2] <= pixels[row, column, 0] or pixels[first_row, first_column, 2] >= pixels[first_row, first_column, 0]:
        failures.append("BlockColors: colors are %s and %s" % (pixels[row, column], pixels[first_row, first_column]))
    return failures


def other_sources(view):
    """Sources of other kinds of data: something is drawn and nothing complains."""
    sources = {
        "hyper-tree grid": lambda: pv.HyperTreeGridRandom(),
        "table": lambda: pv.TableToPoints(Input=session.source(table()), XColumn="x", YColumn="y", ZColumn="z"),
        "AMR": lambda: pv.AMRGaussianPulseSource(),
        "hierarchical fractal": lambda: pv.HierarchicalFractal(),
    }
    failures = []
    for name, make in sources.items():
        try:
            points = make()
        except AttributeError as missing:
            print("%s: not tried, this ParaView has no such source (%s)" % (name, missing))
            continue

        def draw():
            shown = session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=0.3)
            session.solid(shown, (1.0, 1.0, 0.0))
            pv.ResetCamera(view)
            pv.Render(view)

        text = session.messages(draw)
        share = float(comparison.covered(session.capture(view, "data-" + name.replace(" ", "-"))).mean())
        print("%s: %.2f%% covered" % (name, 100 * share))
        if share < 0.005 or "ERR" in text:
            failures.append("%s: %.2f%% of the picture covered; %s" % (name, 100 * share, text.strip()))
        pv.Hide(points, view)
    return failures


def main():
    """All kinds."""
    session.load()
    view = session.view(400, 300)
    session.look(view, EYE)
    failures = kinds(view) + other_sources(view)
    session.finish(failures)


if __name__ == "__main__":
    main()
