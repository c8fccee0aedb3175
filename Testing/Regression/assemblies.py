"""Blocks are hidden and colored by selectors in the data's own assembly, or in the hierarchy of its blocks, as the display's Assembly says.

Usage: pvpython assemblies.py
Since ParaView 5.13 blocks may also have arrays and color maps of their own. Before ParaView 5.12 displays have no such property, and selectors are paths in the hierarchy.
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataAssembly, vtkPartitionedDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource

import session
from checks import Checks

GRAY, GREEN = (0.8, 0.8, 0.8), (0.0, 1.0, 0.0)
#: where the blocks are
LEFT, RIGHT = -1.0, 1.0


def point(x):
    """A point."""
    return session.poly_data(numpy.array([[x, 0.0, 0.0]]))


def square(x):
    """A square of side 1."""
    source = vtkPlaneSource()
    source.SetOrigin(x - 0.5, -0.5, 0.0)
    source.SetPoint1(x + 0.5, -0.5, 0.0)
    source.SetPoint2(x - 0.5, 0.5, 0.0)
    source.Update()
    return source.GetOutput()


def line(x):
    """An upright line."""
    source = vtkLineSource()
    source.SetPoint1(x, -0.5, 0.0)
    source.SetPoint2(x, 0.5, 0.0)
    source.Update()
    return source.GetOutput()


#: what a block is made of, and properties
REPRESENTATIONS = {
    "Surface": (square, {}),
    "Ray Traced Glyphs": (point, {"GlyphType": "Sphere", "ScaleFactor": 1.0}),
    "Ray Traced Surface": (square, {}),
    "Ray Traced Tubes": (line, {"TubeRadius": 0.4}),
}


def collection(block):
    """An empty data set, one at the left and one at the right; the assembly has them in the other order, and other names."""
    data, assembly = vtkPartitionedDataSetCollection(), vtkDataAssembly()
    for index, (name, x) in enumerate((("nothing", None), ("west", LEFT), ("east", RIGHT))):
        data.SetPartitionedDataSet(index, vtkPartitionedDataSet())
        data.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
        if x is not None:
            leaf = block(x)
            session.add_arrays(leaf, value=numpy.full(leaf.GetNumberOfPoints(), 0.5))
            data.GetPartitionedDataSet(index).SetPartition(0, leaf)
    assembly.SetRootNodeName("IOSS")
    sides = assembly.AddNode("sides")
    assembly.AddDataSetIndex(assembly.AddNode("right", sides), 2)
    assembly.AddDataSetIndex(assembly.AddNode("left", sides), 1)
    data.SetDataAssembly(assembly)
    return data


def look_at(view, name):
    """Colors of the middles of the blocks: left, right."""
    pv.Render(view)
    pixels = session.capture(view, name)[..., :3].astype(int)
    middle = pixels.shape[1] // 2
    shift = int(round(pixels.shape[0] / 4.0))  # the view is 4 high
    return pixels[pixels.shape[0] // 2, middle - shift], pixels[pixels.shape[0] // 2, middle + shift]


def selectors(checks, view, shown, what, everything, left, right):
    """The three properties, with paths of one tree."""
    name = "assemblies-" + what.lower().replace(" ", "-").replace(",", "")
    background = numpy.array(session.BACKGROUND)
    whole = look_at(view, name)
    for side, color in zip(("left", "right"), whole):
        checks.true("%s: the %s block is not there" % (what, side), (color != background).any())
    for selected, seen in (([left], (1, 0)), ([right], (0, 1)), ([everything], (1, 1)), ([left, right], (1, 1))):
        shown.BlockSelectors = selected
        found = [int((color != background).any()) for color in look_at(view, name)]
        checks.equal("%s: left and right blocks that are seen with BlockSelectors %s" % (what, selected), found, list(seen))
    shown.BlockSelectors = ["/"]
    shown.BlockColors = [right] + [str(channel) for channel in GREEN]
    found = look_at(view, name)
    checks.true("%s: BlockColors change the other block" % what, (found[0] == whole[0]).all())
    checks.true("%s: BlockColors: the color is %s" % (what, found[1]), found[1][1] > 100 and found[1][0] < 10 and found[1][2] < 10)
    shown.BlockColors = []
    shown.BlockOpacities = [right, "0.5"]
    found = look_at(view, name)
    checks.true("%s: BlockOpacities change the other block" % what, (found[0] == whole[0]).all())
    for other, color in (("an opaque block", whole[1]), ("no block", background)):
        checks.true("%s: BlockOpacities: as %s" % (what, other), abs(found[1] - color).max() > 20)
    shown.BlockOpacities = []


def own_array(checks, view, shown, what, left):
    """Since ParaView 5.13 a block may have an array and a color map of its own; the others stay as they are."""
    name = "assemblies-own-array-" + what.lower().replace(" ", "-")
    before = look_at(view, name)
    table = pv.GetColorTransferFunction("value")
    table.RGBPoints = [0.0, *GREEN, 1.0, *GREEN]
    display = shown.SMProxy
    names = display.GetProperty("BlockColorArrayNames")
    names.SetNumberOfElements(3)
    for i, element in enumerate((left, "0", "value")):
        names.SetElement(i, element)
    display.GetProperty("BlockLookupTables").AddProxy(table.SMProxy)
    display.UpdateVTKObjects()
    # Surface of ParaView 6.1 shows arrays of blocks once its own has changed.
    shown.ColorArrayName = ["POINTS", "value"]
    look_at(view, name)
    shown.ColorArrayName = ["POINTS", ""]
    found = look_at(view, name)
    checks.true("%s: BlockColorArrayNames: the color is %s" % (what, found[0]), found[0][1] > 100 and found[0][0] < 10 and found[0][2] < 10)
    checks.true("%s: BlockColorArrayNames change the other block" % what, (found[1] == before[1]).all())


def main():
    """ParaView's own surface, which shows that this is what it does, and each of the plugin's representations."""
    session.load()
    checks = Checks()
    for representation, (block, properties) in REPRESENTATIONS.items():
        view = session.view(400, 200)
        session.look(view, (0.0, 0.0, 10.0), parallel_scale=2.0)
        source = session.source(collection(block))
        shown = session.show(source, view, representation, **properties)
        session.solid(shown, GRAY)
        has_assembly = shown.SMProxy.GetProperty("Assembly") is not None
        if has_assembly:
            checks.equal("%s: Assembly of data that has one" % representation, shown.SMProxy.GetProperty("Assembly").GetElement(0), "Assembly")
            selectors(checks, view, shown, representation + ", assembly", "/IOSS", "/IOSS/sides/left", "/IOSS/sides/right")
            shown.Assembly = "Hierarchy"
        if has_assembly or representation != "Surface":
            selectors(checks, view, shown, representation + ", hierarchy", "/Root", "/Root/west", "/Root/east")
        if shown.SMProxy.GetProperty("BlockColorArrayNames") is not None:
            own_array(checks, view, shown, representation, "/Root/west")
        pv.Delete(view)
        pv.Delete(source)
    checks.report()


if __name__ == "__main__":
    main()
