"""Glyphs of hyper tree grids: cell arrays are offered for size, direction, tensors and velocity, and act as point arrays
of the cells' centers do.

Usage: pvpython hyper_tree_grid.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkHyperTreeGridSource

import session
from checks import Checks

#: the arrays that each property is to offer
OFFERED = {
    "SelectScaleArray": ("size", "extent"), "SelectOrientationVectors": ("flow",), "GlyphTensorArray": ("stress",),
    "VelocityArray": ("flow",), "AccelerationArray": ("flow",), "AngularVelocityArray": ("flow",),
    "GlyphExponentArray": ("size", "extent"), "PointIdArray": ("size",), "GlyphTableIndexArray": ("size",)}


def grid():
    """Two trees beside each other, one of them refined."""
    maker = vtkHyperTreeGridSource()
    maker.SetDimensions(3, 2, 1)
    maker.SetGridScale(1.5, 1.5, 1.5)
    maker.SetOrigin(-1.5, -0.75, 0.0)
    maker.SetBranchFactor(2)
    maker.SetMaxDepth(2)
    maker.SetDescriptor(".R | ....")
    maker.Update()
    return maker.GetOutput()


def leaves(data):
    """(centers, global numbers) of the cells that have no children."""
    centers, numbers, bounds = [], [], [0.0] * 6
    for tree, child in ((0, None), (1, 0), (1, 1), (1, 2), (1, 3)):
        cursor = data.NewNonOrientedGeometryCursor(tree)
        if child is not None:
            cursor.ToChild(child)
        cursor.GetBounds(bounds)
        centers.append([(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2])
        numbers.append(cursor.GetGlobalNodeIndex())
    return numpy.array(centers), numbers


def arrays(count):
    """An array of each kind."""
    generator = numpy.random.default_rng(2)
    half = generator.normal(size=(count, 3, 3))
    return {"size": generator.uniform(0.3, 0.9, count), "extent": generator.uniform(0.3, 0.9, (count, 3)),
            "flow": generator.normal(size=(count, 3)), "stress": (0.2 * half @ half.transpose(0, 2, 1)).reshape(count, 9)}


def offered(shown, name):
    """The arrays that a property's list shows."""
    domain = shown.SMProxy.GetProperty(name).GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


def main():
    """The lists, then pictures."""
    session.load()
    checks = Checks()
    data = grid()
    centers, numbers = leaves(data)
    values = arrays(data.GetNumberOfCells())
    for name, array in values.items():
        cells = numpy_to_vtk(array, deep=True)
        cells.SetName(name)
        data.GetCellData().AddArray(cells)
    trees = session.source(data)
    points = session.source(session.poly_data(centers, **{name: array[numbers] for name, array in values.items()}))
    view = session.view(160, 120)
    session.look(view, (0.0, 0.0, 5.0))
    cases = (
        ("size", "Sphere", {"ScaleMode": "Magnitude", "SelectScaleArray": "size", "Orient": 0}),
        ("extent", "Box", {"SelectScaleArray": "extent", "ScaleMode": "Vector Components", "Orient": 0}),
        ("direction", "Arrow", {"SelectOrientationVectors": "flow"}),
        ("tensor", "Tensor Ellipsoid", {"GlyphTensorArray": "stress"}),
        ("velocity", "Sphere", {"MotionBlur": 1, "VelocityArray": "flow", "Orient": 0, "SamplesPerPixel": 8}),
    )
    displays = [session.Settings(session.glyphs(source, view)) for source in (points, trees)]
    for name, wanted in OFFERED.items():
        found = offered(displays[1].shown, name)
        checks.true("%s offers %s, not %s" % (name, found, list(wanted)), set(wanted) <= set(found))
    for settings in displays:
        session.solid(settings.shown, (0.9, 0.8, 0.5))
        settings.add({"Visibility": 0})
    for name, shape, properties in cases:
        pictures, said = [], []
        for settings, of in zip(displays, ("points", "cells")):
            def draw():
                settings.set({"Visibility": 1, **session.shaped(shape), "ScaleFactor": 0.5, **properties})
                pv.Render(view)

            said.append(session.messages(draw))
            pictures.append(session.capture(view, "hyper-tree-grid-%s-%s" % (name, of)))
            settings.set({"Visibility": 0})
        checks.covered(name + " of points", pictures[0], 0.005)
        checks.no_message(name + " of cells", said[1])
        checks.picture(name + " of cells", pictures[1], pictures[0], pixels=0.001, mean=0.1)

    # Cells that another rank shows, too
    shown = displays[1]
    shown.set({"Visibility": 1, "GlyphType": "Sphere", "ScaleFactor": 0.5, "Orient": 0})
    pv.Render(view)
    checks.equal("glyphs of all cells", session.statistics(shown.shown)["glyphs"], len(numbers))
    ghosts = numpy.zeros(data.GetNumberOfCells(), numpy.uint8)
    ghosts[numbers[:2]] = 1
    marks = numpy_to_vtk(ghosts, deep=True)
    marks.SetName("vtkGhostType")
    marked = data.NewInstance()
    marked.ShallowCopy(data)
    marked.GetCellData().AddArray(marks)
    session.replace_data(trees, marked)
    pv.Render(view)
    checks.equal("glyphs of cells of which two are ghosts", session.statistics(shown.shown)["glyphs"], len(numbers) - 2)
    checks.report()


if __name__ == "__main__":
    main()
