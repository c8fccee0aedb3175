"""Every kind of data set with points draws its glyphs; blocks keep their visibility and colors.

Usage: pvpython data_types.py
For each kind the glyphs of eight known points must be where those points are. Molecules have the picture of their atoms and bonds.
"""
import numpy
import paraview.simple as pv
from paraview import smtrace
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkRectilinearGrid,
    vtkStructuredGrid, vtkTable, vtkUnstructuredGrid)

import comparison
import session
from checks import Checks, stepwise
from state_and_trace import traced

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


#: Two steps of water and a part of chloromethane, as ParaView's readers of chemistry take them.
ATOMS = (("O", 8, 0.0, 0.0, 0.0), ("H", 1, 0.96, 0.0, 0.0), ("H", 1, -0.24, 0.93, 0.0), ("C", 6, 3.0, 0.0, 0.0), ("H", 1, 3.6, 0.6, 0.6), ("Cl", 17, 4.2, -1.2, 0.0))


def written(name, content):
    """The path of a file."""
    path = session.output(name)
    with open(path, "w", encoding="ascii") as file:
        file.write(content)
    return path


def xyz():
    """A file with two time steps."""
    steps = ("%d\nstep\n" % len(ATOMS) + "".join("%s %g %g %g\n" % (symbol, stretch * x, y, z) for symbol, _, x, y, z in ATOMS) for stretch in (1.0, 1.2))
    return pv.XYZReader(FileName=written("atoms.xyz", "".join(steps)))


def cml():
    """Atoms and a bond of Chemical Markup Language."""
    atoms = "".join('<atom id="a%d" elementType="%s" x3="%g" y3="%g" z3="%g"/>' % (i, symbol, x, y, z) for i, (symbol, _, x, y, z) in enumerate(ATOMS))
    return pv.CMLMoleculeReader(FileName=written("atoms.cml", '<?xml version="1.0"?><molecule><atomArray>%s</atomArray><bondArray><bond atomRefs2="a0 a1" '
                                                 'order="1"/></bondArray></molecule>' % atoms))


def cube():
    """Atoms of a Gaussian cube, whose lengths are in bohr."""
    atoms = "".join("%d %d %g %g %g\n" % (number, number, x, y, z) for _, number, x, y, z in ATOMS)
    return pv.GaussianCubeReader(FileName=written("atoms.cube", "c\nc\n%d 0 0 0\n2 1 0 0\n2 0 1 0\n2 0 0 1\n%s1 2 3 4 5 6 7 8\n" % (len(ATOMS), atoms)))


def charged():
    """Points that ParaView makes a molecule of, with charges."""
    points = session.poly_data([atom[2:] for atom in ATOMS], charge=numpy.linspace(-1.0, 1.0, 6), number=numpy.array([atom[1] for atom in ATOMS], numpy.uint16))
    return pv.ConvertIntoMolecule(Input=session.source(points), AtomicNumbers=["POINTS", "number"])


def molecules(view, checks):
    """A molecule has the picture of what Molecule To Lines makes of it, with nothing set, as in ParaView's window; and its own one stays."""
    for make in (cml, cube, charged, xyz):
        name = make.__name__
        molecule = pv.ComputeMoleculeBonds(Input=make())
        pictures, found = [], []
        for source in (pv.MoleculeToLines(Input=molecule), molecule):
            shown = stepwise(pv.Show(source, view))
            pv.ResetCamera(view)
            first = session.capture(view, "molecule-" + name)
            for representation in ("Ray Traced Glyphs", "Ray Traced Tubes"):
                shown.SetRepresentationType(representation)
                checks.no_message("molecule, %s, %s" % (name, representation), session.messages(lambda: pv.Render(view)))
                pictures.append(session.capture(view, "molecule-%s-%s" % (name, representation[-5:].lower())))
            found.append([shown.SMProxy.GetProperty(value).GetElement(0) for value in ("SelectScaleArray", "ScaleMode", "ScaleFactor", "TubeRadius")])
            pv.Delete(shown) if source is not molecule else None
        checks.equal("molecule, %s: what is chosen" % name, found[1], found[0])
        checks.equal("molecule, %s: sizes" % name, found[1][:3], ["Van der Waals radii of Atomic Numbers", 1, 2.0])
        for i, what in enumerate(("atoms", "bonds")):
            checks.picture("molecule, %s, %s" % (name, what), pictures[2 + i], pictures[i])
            checks.within("part of the picture with %s of %s" % (what, name), float(comparison.covered(pictures[i]).mean()), 0.002, 0.9)
        shown.SetRepresentationType("Molecule")
        checks.picture("molecule, %s, ParaView's" % name, session.capture(view, "molecule-%s-again" % name), first)
        if make is xyz:
            molecule_used(view, checks, molecule, shown, pictures[2])
        pv.Delete(shown)


def molecule_used(view, checks, molecule, shown, wanted):
    """Time, settings, a state, a trace, and a click."""
    shown.SetRepresentationType("Ray Traced Glyphs")
    view.ViewTime = 1.0
    pv.Render(view)
    checks.true("atoms do not move", comparison.difference(session.capture(view, "molecule-moved"), wanted)[0] > 0.01)
    view.ViewTime = 0.0
    pv.Render(view)
    checks.picture("atoms at the first step again", session.capture(view, "molecule-back"), wanted)
    smtrace.start_trace()
    with traced(shown):
        shown.ScaleFactor, shown.ShadingMode = 1.0, "Ambient Occlusion"
    trace = smtrace.stop_trace().replace(" = ", "=")
    checks.true("trace of a molecule: " + trace, "ScaleFactor=1.0" in trace and "ShadingMode='Ambient Occlusion'" in trace)
    small = session.capture(view, "molecule-small")
    checks.within("atoms of half the size", float(comparison.covered(small).mean() / comparison.covered(wanted).mean()), 0.2, 0.7)
    said = session.messages(lambda: session.picked(view, "POINT", session.pixel_of(view, (0.0, 0.0, 0.0))))
    checks.no_message("a click at an atom", said)
    shown.ColorArrayName = [None, ""]
    plain = session.capture(view, "molecule-plain")
    checks.true("atoms keep their colors", comparison.difference(plain, small)[0] > 0.01)
    pv.SaveState(session.output("molecule.pvsm"))
    pv.Hide(molecule, view)
    said = session.messages(lambda: pv.LoadState(session.output("molecule.pvsm")))  # sources made here have no data in a state
    checks.true("state of a molecule: " + said, "RayTraced" not in said and "ToLines" not in said)
    loaded = pv.GetActiveView()
    checks.picture("molecule of a state", session.capture(loaded, "molecule-state"), plain)
    pv.Delete(loaded)
    pv.SetActiveView(view)


def main():
    """All kinds."""
    session.load()
    view = session.view(400, 300)
    session.look(view, EYE)
    checks = Checks()
    checks.failures += kinds(view) + other_sources(view)
    molecules(view, checks)
    checks.report()


if __name__ == "__main__":
    main()
