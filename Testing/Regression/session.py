"""A pvpython session with the plugin loaded: sources from numpy, glyph representations, pictures as arrays.

Environment: RTGLYPHS_PLUGIN is the plugin's library, RTGLYPHS_OUTPUT the folder that pictures are written to.
"""
import ctypes
import faulthandler
import gc
import json
import os
import sys

import numpy
import paraview.simple as pv
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCollection, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkHyperTreeGridSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

REPRESENTATION = "Ray Traced Glyphs"
#: No shaded glyph has this color, so what differs from it is covered by glyphs.
BACKGROUND = (255, 0, 255)
#: seconds after which a test is taken for hanging; CTest's limit is longer (CMakeLists.txt)
HANGS = 540

#: Script of a source of which each rank keeps the points of a slab. RedistributeDataSet would do, but Debian 12's ParaView
#: sends data sets between ranks as XML with raw data, which its libexpat rejects since a security update.
SPREAD = """
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
reader = vtkGenericDataObjectReader()
reader.SetFileName(%r)
reader.ReadAllScalarsOn()
reader.ReadAllVectorsOn()
reader.Update()
whole = reader.GetOutput()
part = self.GetOutput()
points, cells, values = vtkPoints(), vtkCellArray(), part.GetPointData()
values.CopyAllocate(whole.GetPointData())
rank, ranks, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses(), whole.GetNumberOfPoints()
along_x = sorted(range(count), key=lambda i: whole.GetPoint(i)[0])
for i in along_x[count * rank // ranks:count * (rank + 1) // ranks]:
    at = points.InsertNextPoint(whole.GetPoint(i))
    cells.InsertNextCell(1, [at])
    values.CopyData(whole.GetPointData(), i, at)
part.SetPoints(points)
part.SetVerts(cells)
"""


def spread(path):
    """A source: the points of a legacy VTK file as vertices, each rank having a slab of them."""
    return pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=SPREAD % path)


def load():
    """Loads the plugin; every test calls it first."""
    # Says where a test hangs before CTest ends it.
    faulthandler.dump_traceback_later(HANGS, file=sys.__stderr__)
    pv._DisableFirstRenderCameraReset()
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=vars(pv))


def finish(failures=()):
    """Ends the process: 0 when the list of failures is empty. Debian's pvpython crashes at exit unless disconnected.

    On several ranks the script ends by itself: ParaView 6 ends the other ranks again, which have gone when disconnected.
    """
    for failure in failures:
        print("FAILED:", failure)
    print("%d failures" % len(failures), flush=True)
    if pv.servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() > 1:
        return
    pv.Disconnect()
    sys.exit(1 if failures else 0)


def memory(name):
    """Bytes of this process by its status: VmRSS, VmHWM, VmSize."""
    with open("/proc/self/status", encoding="ascii", errors="replace") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(name + ":"))


class MallocInformation(ctypes.Structure):
    """glibc's struct mallinfo2."""
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


def allocated():
    """Bytes of this process's heap that are in use. What it has from the system says little: it keeps what was freed."""
    gc.collect()
    ask = ctypes.CDLL(None).mallinfo2
    ask.restype = MallocInformation
    information = ask()
    return information.uordblks + information.hblkhd


def output(name):
    """Path of a result file."""
    folder = os.environ.get("RTGLYPHS_OUTPUT", ".")
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name)


def poly_data(points, **arrays):
    """vtkPolyData without cells: one point per row of points, one point array per keyword."""
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    data.SetPoints(coordinates)
    add_arrays(data, **arrays)
    return data


def with_cells(data, kind, cells):
    """vtkPolyData, given these cells: lists of points; kind: Verts, Lines or Polys."""
    array = vtkCellArray()
    for cell in cells:
        array.InsertNextCell(len(cell), list(cell))
    getattr(data, "Set" + kind)(array)
    return data


def add_arrays(data, attributes=None, /, **arrays):
    """Adds arrays to a vtkDataSet: to its points, or to other attributes of it, which VTK 9.6 takes for false while they are empty."""
    attributes = data.GetPointData() if attributes is None else attributes
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        array.SetName(name)
        attributes.AddArray(array)


def hyper_tree_grid():
    """(two trees in a row, of which the second one is refined; {number: center} of the cells that have no children)."""
    maker = vtkHyperTreeGridSource()
    maker.SetDimensions(3, 2, 1)
    maker.SetGridScale(1.5, 1.5, 1.5)
    maker.SetOrigin(-1.5, -0.75, 0.0)
    maker.SetBranchFactor(2)
    maker.SetMaxDepth(2)
    maker.SetDescriptor(".R | ....")
    maker.Update()
    data, leaves, bounds = maker.GetOutput(), {}, [0.0] * 6
    for tree, child in ((0, None), (1, 0), (1, 1), (1, 2), (1, 3)):
        cursor = data.NewNonOrientedGeometryCursor(tree)
        if child is not None:
            cursor.ToChild(child)
        cursor.GetBounds(bounds)
        leaves[cursor.GetGlobalNodeIndex()] = numpy.reshape(bounds, (3, 2)).mean(axis=1)
    return data, leaves


def source(data):
    """A pipeline source that gives out a VTK data object made here."""
    producer = pv.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


#: What stands before and behind the script of a source of which each rank has a part of the points.
BEFORE_POINTS = """
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
"""
BEHIND_POINTS = """
coordinates, cells = vtkPoints(), vtkCellArray()
for i, point in enumerate(points[mine]):
    coordinates.InsertNextPoint(point)
    cells.InsertNextCell(1, [i])
self.GetOutput().SetPoints(coordinates)
self.GetOutput().SetVerts(cells)
for name, values in arrays.items():
    array = numpy_to_vtk(numpy.ascontiguousarray(values[mine]), deep=True)
    array.SetName(name)
    self.GetOutput().GetPointData().AddArray(array)
"""


def points_of_ranks(script, information=""):
    """A source, run on each rank of a server, too. Of `rank` and `ranks` the script makes `points` and `arrays` (values by names)
    of all ranks, and `mine`, the slice of this one; information: the script for ParaView's request for information.
    """
    return pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=BEFORE_POINTS + script + BEHIND_POINTS,
                                 ScriptRequestInformation=information)


#: Script of a source of four blocks in a row, squares that are dealt out to the ranks. Each has a number of its own as field data; the
#: second alone has heights, and the third alone colors of bytes.
BLOCKS = """
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData
blocks = self.GetOutput()
blocks.SetNumberOfBlocks(4)
for number in range(4):
    blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), "block%d" % number)
    if number % ranks != rank:
        continue
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    for x, y in ((0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8)):
        points.InsertNextPoint(number + x, y, 0.0)
    cells.InsertNextCell(4, [0, 1, 2, 3])
    data.SetPoints(points)
    data.SetPolys(cells)
    for field, name, values in ((data.GetFieldData(), "material", numpy.array([1.0 + number])),
                                (data.GetPointData(), "height", numpy.arange(4.0) if number == 1 else None),
                                (data.GetPointData(), "rgb", numpy.full((4, 3), (200, 100, 50), numpy.uint8) if number == 2 else None)):
        if values is not None:
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            field.AddArray(array)
    blocks.SetBlock(number, data)
"""


def blocks_of_ranks(before=""):
    """A source of blocks that only one rank has, run on each rank of a server, too; before: what each does first."""
    return pv.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=BEFORE_POINTS + before + BLOCKS)


def replace_data(producer, data):
    """Gives a source new data, as a new time step would."""
    producer.GetClientSideObject().SetOutput(data)
    producer.MarkModified(producer)
    producer.UpdatePipeline()


def view(width=400, height=300, background=BACKGROUND):
    """A render view with one plain background color and nothing in it."""
    made = pv.CreateView("RenderView")
    made.ViewSize = [width, height]
    made.OrientationAxesVisibility = 0
    made.UseFXAA = 0
    made.UseColorPaletteForBackground = 0
    made.BackgroundColorMode = "Single Color"
    made.Background = [channel / 255.0 for channel in background]
    return made


def look(at_view, position, focal_point=(0.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), parallel_scale=None):
    """Sets the camera; with parallel_scale, parallel projection."""
    at_view.CameraPosition = list(position)
    at_view.CameraFocalPoint = list(focal_point)
    at_view.CameraViewUp = list(up)
    at_view.CameraParallelProjection = 0 if parallel_scale is None else 1
    if parallel_scale is not None:
        at_view.CameraParallelScale = parallel_scale


def pixel_of(in_view, place):
    """The pixel of a rendered view in which a place is seen, from the lower left."""
    renderer = in_view.SMProxy.GetRenderer()
    renderer.SetWorldPoint(*place, 1.0)
    renderer.WorldToDisplay()
    return tuple(int(value) for value in renderer.GetDisplayPoint()[:2])


def picked(view, kind, at):
    """What a click at a pixel selects: a list of (source, what, id)."""
    representations, sources = vtkCollection(), vtkCollection()
    select = view.SMProxy.SelectSurfaceCells if kind == "CELL" else view.SMProxy.SelectSurfacePoints
    select([at[0], at[1], at[0], at[1]], representations, sources, 0)
    found = []
    for i in range(sources.GetNumberOfItems()):
        shown = pv.servermanager._getPyProxy(representations.GetItemAsObject(i))
        selected = pv.servermanager._getPyProxy(sources.GetItemAsObject(i))
        step = 3 if "Composite" in selected.GetXMLName() or "Hierarchical" in selected.GetXMLName() else 2
        found += [(shown.Input.SMProxy, selected.FieldType.GetData(), number) for number in list(selected.IDs)[step - 1::step]]
    return found


def glyphs(of_source, in_view, shape="Sphere", samples=None, **properties):
    """Shows a source as ray-traced glyphs; properties as in the property reference, samples as show() has them."""
    return show(of_source, in_view, REPRESENTATION, samples, **{**shaped(shape), **properties})


#: the sources of 3D Glyphs that are traced exactly
SOURCES = ("Sphere", "Box", "Cylinder", "Cone", "Arrow")


def triangles(source):
    """A source whose triangles are the glyphs, as it does not come from a source that is traced exactly."""
    return pv.ExtractSurface(Input=source)


def shaped(shape):
    """The properties of a shape: of a source, of "Mesh", the triangles of an arrow, or of another GlyphShape."""
    if shape == "Mesh":
        return {"GlyphType": triangles(pv.Arrow())}
    return {"GlyphType": shape} if shape in SOURCES else {"GlyphShape": shape}


def assign_shape(shown, shape):
    """Gives a display a shape, whatever it had."""
    for name, value in {"GlyphShape": "None", **shaped(shape)}.items():
        setattr(shown, name, value)


def assign(shown, name, value):
    """Sets a property, or with "GlyphType.Radius" one of its value's. What can be called makes the value."""
    value = value() if callable(value) else value
    owner, _, last = name.rpartition(".")
    setattr(getattr(shown, owner) if owner else shown, last, value)


def show(of_source, in_view, representation, samples=None, **properties):
    """Shows a source as a representation.

    samples: SamplesPerPixel of the view; None: 1 for the first display of a view, and what holds there for others.
    """
    if samples is None and len(in_view.Representations) == 0:
        samples = 1
    shown = pv.Show(of_source, in_view)
    shown.SetRepresentationType(representation)
    if samples is not None:
        shown.SamplesPerPixel = samples
    for name, value in properties.items():
        assign(shown, name, value)
    return shown


def value_of(shown, name):
    """A property's value, as a script would set it."""
    if "." in name:
        owner, _, last = name.rpartition(".")
        return value_of(getattr(shown, owner), last)
    value = shown.GetPropertyValue(name)
    if name == "ColorArrayName":
        return [value.GetAssociation(), value.GetArrayName()] if value.GetArrayName() else [None, ""]
    value = list(value) if isinstance(value, pv.servermanager.VectorProperty) else value
    return value[0] if isinstance(value, list) and len(value) == 1 else value


class Settings:
    """Properties of one display for one case after another: a new display takes ParaView a fifth of a second, most of a case's time."""

    def __init__(self, shown):
        self.shown, self.first, self.now = shown, {}, set()

    def set(self, properties):
        """Sets these, and those that were set before back to what they were at first."""
        for name in sorted(self.now - set(properties), key=lambda name: "." not in name): # of values before these
            assign(self.shown, name, self.first[name])
        self.now &= set(properties)
        self.add(properties)

    def add(self, properties):
        """Sets these beside those that are set."""
        for name, value in properties.items():
            if name not in self.first:
                self.first[name] = value_of(self.shown, name)
            assign(self.shown, name, value)
            self.now.add(name)


class Stage:
    """A view with one display, whose data and properties change from case to case. Cases state what the first one's data would otherwise choose
    for all: ScaleFactor, TubeRadius.
    """

    def __init__(self, in_view, representation=REPRESENTATION):
        self.view, self.representation, self.source, self.settings = in_view, representation, None, None

    def show(self, data, shape=None, **properties):
        """The display, of these data and with these properties; all others are those of a fresh one. shape: as shaped() has it."""
        if self.source is None:
            self.source = source(data)
            self.settings = Settings(show(self.source, self.view, self.representation))
        else:
            replace_data(self.source, data)
        self.settings.set({**(shaped(shape or "Sphere") if self.representation == REPRESENTATION else {}), **properties})
        return self.settings.shown

    def hide(self):
        """Until the next case."""
        self.settings.add({"Visibility": 0})

    def close(self):
        """Deletes display and data."""
        pv.Delete(self.settings.shown)
        pv.Delete(self.source)
        self.source = self.settings = None


def solid(shown, color):
    """One color for all."""
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = list(color)
    shown.AmbientColor = list(color)


def signs(positive, negative):
    """The table of two colors for GlyphTensorColoring Sign."""
    return pv.CreateLookupTable(RGBPoints=[-1.0, *negative, 1.0, *positive], ColorSpace="RGB")


def cool_to_warm(name):
    """Gives an array's lookup table the colors that were ParaView's default before ParaView 6."""
    pv.GetColorTransferFunction(name).ApplyPreset("Cool to Warm", True)


def capture(of_view, name, **options):
    """Saves the view as name.png and returns it as an array (rows from the top, columns, channels). options: of SaveScreenshot, which
    is called for these alone: it takes ParaView 15 ms more than a screenshot without a file.
    """
    path = output(name + ".png")
    if options:
        pv.SaveScreenshot(path, of_view, **options)
        return read_image(path)
    image = of_view.SMProxy.CaptureWindow(1)
    write_png(path, image)
    return pixels_of(image)


def write_png(path, image):
    """Writes a vtkImageData of two dimensions."""
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.SetCompressionLevel(1)
    writer.Write()


def read_image(path):
    """A PNG file as uint8 array (rows from the top, columns, channels)."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return pixels_of(reader.GetOutput())


def pixels_of(image):
    """A vtkImageData of two dimensions as an array (rows from the top, columns, channels)."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def statistics(of_representation):
    """The representation's RenderStatistics as a dictionary."""
    of_representation.UpdatePropertyInformation()
    return json.loads(of_representation.GetProperty("RenderStatistics").GetElement(0))


def messages(action):
    """Errors and warnings that VTK and ParaView print while action() runs, as one text."""
    before = vtkOutputWindow.GetInstance()
    collector = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(collector)
    try:
        action()
    finally:
        vtkOutputWindow.SetInstance(before)
    return collector.GetOutput() or ""


def array_of(of_source, name):
    """A point array of a source as numpy; of several blocks one after another."""
    data = dataset_adapter.WrapDataObject(of_source.GetClientSideObject().GetOutputDataObject(0))
    values = data.PointData[name]
    return numpy.concatenate([numpy.asarray(part) for part in values.Arrays if part is not None and len(part)]) \
        if hasattr(values, "Arrays") else numpy.asarray(values)
