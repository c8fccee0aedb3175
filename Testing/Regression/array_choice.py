"""Defaults of the properties that name arrays are chosen by what the arrays are; spheres that a radius or diameter scales have
exactly that size.

Usage: RTGLYPHS_DATA=FOLDER pvpython array_choice.py
"""
import os

import numpy
import paraview.simple as pv

import comparison
import scale_guess
import session
from checks import Checks

PROPERTIES = ("SelectScaleArray", "SelectOrientationVectors", "GlyphTensorArray", "VelocityArray")
COUNT = 20
#: arrays as name:components, an active one with its attribute behind it -> the defaults of PROPERTIES
CASES = (
    ("", "None None None None"),
    ("id:1 type:1", "None None None None"),
    ("id:1 pressure:1", "pressure None None None"),
    ("a:1 b:1=Scalars", "b None None None"),
    ("b:1=Scalars radius:1", "radius None None None"),
    ("c_diameter:1 mass:1", "c_diameter None None None"),
    ("ParticleRadius:1", "ParticleRadius None None None"),
    ("radiation:1=Scalars radius:3", "radius None None None"),
    ("a:3 velocity:3", "velocity velocity None velocity"),
    ("a:3=Vectors velocity:3", "a a None velocity"),
    ("force:3 displacement:3 angular_velocity:3 coords:3 omega:3", "displacement displacement None None"),
    ("omega:3 coords:3", "omega omega None None"),
    ("positions:3 EulerAngles:3 rgb:3 lengths:3", "lengths None None None"),
    ("positions:3 c_q:4 c_shape:3", "c_shape c_q None None"),
    ("positions:3 quaternion:4 c_shape:3 thing:3", "c_shape quaternion None None"),
    ("positions:3 thing:3", "thing thing None None"),
    ("a:3 b:3 c:3 d:3 e:3 f:3 g:3 h:3 Normals:3 j:3", "f f None None"),
    ("V:3 Pres:1", "V V None V"),
    # As codes for two dimensions write them
    ("p:1 range:2 uv:2=TCoords vel:2", "vel vel None vel"),
    ("range:2 uv:2=TCoords", "None None None None"),
    # As Stream Tracer makes them
    ("p:1 U:3 Vorticity:3 Normals:3=Vectors", "U U None U"),
    ("Vorticity:3 Normals:3=Vectors", "Vorticity Normals None None"),
    ("orientations:9 stress:6", "None None stress None"),
    ("rotation:9", "None None None None"),
    ("a:9 strain:9 b:9", "None None strain None"),
    ("a:9 strain:9 b:9=Tensors", "None None b None"),
    ("rotation:9 thing:6", "None None thing None"),
    ("evals:3 evec1:3", "evals evec1 None None"),
    ("xx:1 xy:1 xz:1 yy:1 yz:1 zz:1", "None None xx, yy, zz, xy, yz, xz None"),
    ("x:1 y:1 z:1", "x None None None"),
)


def data(arrays):
    """Points with random arrays."""
    random = numpy.random.default_rng(3)
    made = session.poly_data(random.uniform(size=(COUNT, 3)))
    for array in arrays.split():
        name, components = array.split("=")[0].split(":")
        components = int(components)
        session.add_arrays(made, **{name: random.uniform(size=(COUNT, components) if components > 1 else COUNT)})
        if "=" in array:
            getattr(made.GetPointData(), "SetActive" + array.split("=")[1])(name)
    return made


def arrays(shown):
    """The present values of PROPERTIES."""
    return [shown.SMProxy.GetProperty(name).GetElement(0) for name in PROPERTIES]


def choices(checks):
    """Each of the cases."""
    view = session.view(40, 30)
    for names, wanted in CASES:
        source = session.source(data(names))
        shown = session.glyphs(source, view, ScaleMode="Magnitude")
        checks.equal("%s of [%s]" % (", ".join(PROPERTIES), names), " ".join(arrays(shown)), wanted)
        pv.Delete(shown)
    colors = session.poly_data(numpy.zeros((3, 3)), light=numpy.zeros((3, 3), numpy.uint8))
    shown = session.glyphs(session.source(colors), view)
    checks.equal("SelectOrientationVectors of bytes", str(shown.GetPropertyValue("SelectOrientationVectors")).strip("'"), "None")
    pv.Delete(view)


def cells(checks):
    """With GlyphLocation the arrays are chosen among those of the cells, unless the user has chosen one that exists."""
    view = session.view(40, 30)
    source = pv.Calculator(Input=pv.PointDatatoCellData(Input=pv.Wavelet(WholeExtent=[0, 3] * 3), PassPointData=1),
                           AttributeType="Cell Data", Function="RTData*iHat", ResultArrayName="force")
    for name, explicit, wanted in (("not chosen", None, "force"), ("chosen", "None", "None"), ("chosen, wrong", "nonesuch", "nonesuch")):
        shown = session.glyphs(source, view, GlyphLocation="Points")
        checks.equal("SelectOrientationVectors of points, " + name, shown.SMProxy.GetProperty("SelectOrientationVectors").GetElement(0), "None")
        shown.GlyphLocation = "Cells"
        if explicit:
            shown.SelectOrientationVectors = explicit
        shown.ScaleMode = "Magnitude"
        session.messages(lambda: pv.Render(view))
        checks.equal("SelectOrientationVectors of cells, " + name, shown.SMProxy.GetProperty("SelectOrientationVectors").GetElement(0), wanted)
        checks.equal("SelectScaleArray of cells, " + name, shown.SMProxy.GetProperty("SelectScaleArray").GetElement(0), "force")
        shown.GlyphLocation = "Points"
        session.messages(lambda: pv.Render(view))
        checks.equal("SelectOrientationVectors of points again, " + name,
                     shown.SMProxy.GetProperty("SelectOrientationVectors").GetElement(0), explicit or "None")
        pv.Delete(shown)
    pv.Delete(view)


def location(checks):
    """Glyphs stand at cells where only cells have directions or tensors, also when a later time step has them first."""
    view = session.view(40, 30)
    wavelet = pv.Wavelet(WholeExtent=[0, 3] * 3)
    vector = dict(Function="RTData*iHat", ResultArrayName="force")
    script = "import numpy\noutput.CellData.append(numpy.tile([1.0, 2.0, 3.0, 0.0, 0.0, 0.0], (27, 1)), 'stress')"
    moved = pv.PointDatatoCellData(Input=wavelet)
    cases = {"no vectors": (wavelet, 0, "None"), "points": (pv.Calculator(Input=wavelet, **vector), 0, "force"),
             "cells": (pv.Calculator(Input=moved, AttributeType="Cell Data", **vector), 1, "force"),
             "both": (pv.PointDatatoCellData(Input=pv.Calculator(Input=wavelet, **vector), PassPointData=1), 0, "force"),
             "tensors of cells": (pv.ProgrammableFilter(Input=wavelet, CopyArrays=1, Script=script), 1, "None")}
    for name, (source, wanted, direction) in cases.items():
        shown = session.glyphs(source, view, "Arrow" if direction == "force" else "Sphere")
        where = shown.SMProxy.GetProperty("GlyphLocation")
        checks.no_message(name, session.messages(lambda: pv.Render(view)))
        checks.equal("GlyphLocation of " + name, where.GetElement(0), wanted)
        checks.equal("SelectOrientationVectors of " + name, arrays(shown)[1], direction)
        checks.equal("glyphs of " + name, session.statistics(shown)["glyphs"], 27 if wanted else 64)
        pv.Delete(shown)
    script = "import numpy\noutput.CellData.append(numpy.tile(%s, (27, 1)), 'stress')" % list(range(1, 7))
    parts = pv.ProgrammableFilter(Input=cases["points"][0], CopyArrays=1, Script=script)  # displacements of points, stresses of cells
    shown = session.glyphs(parts, view, "Arrow")
    for shape, wanted, tensor in (("Arrow", 0, "None"), ("Tensor Ellipsoid", 1, "stress"), ("Normal Stress", 1, "stress"), ("Arrow", 0, "None")):
        session.assign_shape(shown, shape)
        checks.no_message("stresses of cells", session.messages(lambda: pv.Render(view)))
        checks.equal("GlyphLocation of %s" % shape, shown.SMProxy.GetProperty("GlyphLocation").GetElement(0), wanted)
        checks.equal("glyphs of %s" % shape, session.statistics(shown)["glyphs"], 27 if wanted else 64)
        checks.equal("arrays of %s" % shape, arrays(shown)[1:3], ["None", tensor] if wanted else ["force", tensor])
    pv.Delete(shown)
    shown = session.glyphs(cases["cells"][0], view, GlyphLocation="Points")
    pv.Render(view)
    checks.equal("GlyphLocation that a script has chosen", shown.SMProxy.GetProperty("GlyphLocation").GetElement(0), 0)
    pv.Delete(view)

    view = session.view(40, 30)
    source = pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=STEPS % ((0, 20), (0, 1)) + CELLS,
                                   ScriptRequestInformation=scale_guess.TIMES % ([0.0, 1.0], 0.0, 1.0))
    shown = session.glyphs(source, view, "Arrow")
    session.messages(lambda: pv.Render(view))
    for time in (1.0, 0.0, 1.0):
        view.ViewTime = time
        checks.no_message("cells at time %g" % time, session.messages(lambda: pv.Render(view)))
        checks.equal("GlyphLocation at time %g" % time, shown.SMProxy.GetProperty("GlyphLocation").GetElement(0), 1)
        checks.equal("arrays of cells at time %g" % time, arrays(shown)[:3], ["None", "velocity", "stress"])
    checks.equal("glyphs of the second step", session.statistics(shown)["glyphs"], 20)
    pv.Delete(view)


#: Steps 0, 1, ... of a series, of `counts` points each; only those of steps whose number is in `having` have arrays.
STEPS = """
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
counts, having = %r, %r
info, key = self.GetOutputInformation(0), vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
step = int(info.Get(key)) if info.Has(key) else 0
random, count = numpy.random.default_rng(2), counts[step]
output = dataset_adapter.WrapDataObject(self.GetOutputDataObject(0))
output.Points = random.uniform(size=(count, 3))
if step in having:
    for name, components in (("radius", 1), ("velocity", 3), ("stress", 6)):
        output.PointData.append(random.uniform(size=(count, components) if components > 1 else count), name)
"""


#: To be put behind STEPS: vertices have the arrays, and points have none.
CELLS = """
from vtkmodules.vtkCommonDataModel import vtkCellArray
vertices = vtkCellArray()
for point in range(count):
    vertices.InsertNextCell(1, [point])
output.VTKObject.SetVerts(vertices)
output.VTKObject.GetCellData().ShallowCopy(output.VTKObject.GetPointData())
output.VTKObject.GetPointData().Initialize()
"""


def steps(checks):
    """Steps without points, or whose points have no arrays, do not decide for those that follow; who has chosen has chosen for good."""
    wanted = ["radius", "velocity", "stress", "velocity"]
    for what, counts, having in (("no points", (0, 20, 20), (0, 1)), ("no points and no arrays", (0, 20, 20), (1, )),
                                 ("no arrays", (20, 20, 20), (1, ))):
        view = session.view(60, 40)
        times = [float(step) for step in range(len(counts))]
        sources = [pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=STEPS % (counts, having),
                                         ScriptRequestInformation=scale_guess.TIMES % (times, times[0], times[-1])) for _ in range(3)]
        view.ViewTime = 0.0
        shown = session.glyphs(sources[0], view, ScaleMode="Magnitude")
        chosen = session.glyphs(sources[1], view, ScaleMode="Magnitude", SelectScaleArray="velocity", SelectOrientationVectors="radius")
        tubes = session.show(sources[2], view, "Ray Traced Tubes")
        session.messages(lambda: pv.Render(view))
        found = [arrays(shown)]
        for time in times[1:] + [0.0, 1.0]:
            view.ViewTime = time
            said = session.messages(lambda: pv.Render(view))
            found.append(arrays(shown))
            if time == 1.0:
                checks.equal("%s first: factor at time 1" % what, shown.ScaleFactor, 2.0)
                checks.equal("%s first: array that a script has chosen" % what, arrays(chosen)[0], "velocity")
                checks.equal("%s first: direction that a script has chosen" % what, arrays(chosen)[1], "radius")
        if 0 not in having:
            checks.equal("%s first: arrays of the first step" % what, found[0], ["None"] * 4)
        for step, arrays_found in enumerate(found[1:]):
            checks.equal("%s first: arrays of change %d" % (what, step), arrays_found, wanted)
        bounds = numpy.reshape(sources[2].GetDataInformation().GetBounds(), (3, 2))
        checks.within("%s first: TubeRadius" % what, tubes.TubeRadius / numpy.ptp(bounds, axis=1).max(), 0.0099, 0.0101)
        checks.equal("%s first: VelocityArray of tubes" % what, arrays(tubes)[3], "velocity")
        pv.Delete(view)


#: By time: points, and the arrays that they have
LATE = """
import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
count, arrays = %r[int(self.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()))]
random = numpy.random.default_rng(5)
points = vtkPoints()
points.SetData(numpy_to_vtk(random.uniform(size=(count, 3)), deep=True))
self.GetOutput().SetPoints(points)
for name, components, factor in arrays:
    array = numpy_to_vtk(factor * random.uniform(0.03, 0.05, (count, components)), deep=True)
    array.SetName(name)
    self.GetOutput().GetPointData().AddArray(array)
"""


def forms(checks):
    """Spheres of steps that have nothing, or zeros, become what later steps are shown by, in the window also tensors and sizes; not once the data had something,
    and not where the user has chosen a form."""
    none, sizes = [], [("radius", 1, 1.0)]
    wind = [("wind", 3, 1.0)]
    vectors, zeros, tensors = [("velocity", 3, 1.0)], [("velocity", 3, 0.0)], [("stress", 6, 1.0)]
    for what, window, steps, user, wanted in (
            ("no points", False, ((0, none), (20, vectors)), None, ("SphereSource", "ArrowSource")),
            ("no array", False, ((20, none), (20, vectors)), None, ("SphereSource", "ArrowSource")),
            ("at rest", False, ((20, zeros), (20, vectors), (20, zeros)), None, ("SphereSource", "ArrowSource", "ArrowSource")),
            ("at rest beside a force", False, ((20, zeros + wind), (20, vectors + wind)), None, ("ArrowSource wind", "ArrowSource wind")),
            ("at rest again, with others", False, ((20, vectors + wind), (20, zeros + wind), (20, vectors + wind)), None, ("ArrowSource velocity", ) * 3),
            ("sizes first", False, ((20, sizes), (20, sizes + vectors)), None, ("SphereSource", "SphereSource")),
            ("the user's", False, ((20, none), (20, vectors)), "Box", ("CubeSource", "CubeSource")),
            ("tensors", True, ((0, none), (20, tensors)), None, ("SphereSource None", "SphereSource Tensor Ellipsoid")),
            ("sizes", True, ((20, none), (20, sizes)), None, ("SphereSource No Data Scaling Off", "SphereSource Magnitude"))):
        view = session.view(60, 40)
        times = [float(time) for time in range(len(steps))]
        source = pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=LATE % (steps, ),
                                       ScriptRequestInformation=scale_guess.TIMES % (times, times[0], times[-1]))
        view.ViewTime = 0.0
        shown = pv.Show(source, view)
        if window:
            shown.SMProxy.GetProperty("SamplesPerRender").SetElement(0, -1)
        shown.SetRepresentationType(session.REPRESENTATION)
        for time, form in zip(times, wanted):
            view.ViewTime = time
            said = session.messages(lambda: pv.Render(view))
            if user and time == 0.0:
                shown.GlyphType = user
            shown.Specular = 0.1 * (time + 1.0)  # what has nothing to do with it
            said += session.messages(lambda: pv.Render(view))
            found = [shown.GlyphType.SMProxy.GetXMLName(), arrays(shown)[1], *(str(value).strip("'") for value in (shown.GlyphShape, shown.ScaleMode))]
            checks.true("%s, time %g: %s, not %s" % (what, time, found, form), set(form.split(maxsplit=1)) <= set(found))
            checks.no_message("%s, time %g" % (what, time), said if time < 2.0 and "again" not in what else "")
        pv.Delete(view)
    view = session.view(60, 40)
    source = pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=LATE % (((20, sizes[:0]), (20, vectors)), ),
                                   ScriptRequestInformation=scale_guess.TIMES % ([0.0, 1.0], 0.0, 1.0))
    view.ViewTime = 0.0
    shown = pv.Show(source, view)
    shown.SetRepresentationType(session.REPRESENTATION)
    pv.Render(view)
    shown.Orient = 0
    view.ViewTime = 1.0
    pv.Render(view)
    checks.equal("GlyphType after the user has set Orient", shown.GlyphType.SMProxy.GetXMLName(), "SphereSource")
    pv.Delete(view)


def other_data(checks):
    """Other data at the same time may have others."""
    view = session.view(40, 30)
    source = session.source(data("radius:1 velocity:3 mass:1"))
    shown = session.glyphs(source, view, ScaleMode="Magnitude")
    pv.Render(view)
    session.replace_data(source, data("mass:1 force:3 stress:6"))
    checks.no_message("other arrays", session.messages(lambda: pv.Render(view)))
    checks.equal("arrays of other data", arrays(shown), ["force", "force", "stress", "None"])
    shown.SelectScaleArray = "mass"
    session.replace_data(source, data("radius:1 mass:1 velocity:3"))
    pv.Render(view)
    checks.equal("arrays of other data, one being chosen", arrays(shown), ["mass", "velocity", "None", "velocity"])
    pv.Delete(view)


def lengths(checks):
    """Lengths of arrows follow their direction's array until another one is set; those of spheres do not."""
    view = session.view(40, 30)
    source = session.source(data("radius:1 velocity:3 force:3"))
    for shape, followed in (("Arrow", "force"), ("Sphere", "radius")):
        shown = session.glyphs(source, view, shape, ScaleMode="Magnitude")
        pv.Render(view)
        checks.equal(shape + ": arrays", arrays(shown)[:2], ["velocity" if shape == "Arrow" else "radius", "velocity"])
        shown.SelectOrientationVectors = "force"
        pv.Render(view)
        checks.equal(shape + ": arrays after another direction", arrays(shown)[:2], [followed, "force"])
        shown.SelectScaleArray = "radius"
        shown.SelectOrientationVectors = "velocity"
        pv.Render(view)
        checks.equal(shape + ": arrays after a size of its own", arrays(shown)[:2], ["radius", "velocity"])
        pv.Delete(shown)
    pv.Delete(view)


def files(checks):
    """A legacy file without active vectors: arrows follow its velocity."""
    view = session.view(40, 30)
    shown = session.glyphs(pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact_04.vtk"), view)
    checks.equal("arrays of impact_04.vtk", arrays(shown), ["None", "velocity", "stress", "velocity"])
    scale = shown.SMProxy.GetProperty("SelectScaleArray")
    for name, value, wanted in (("GlyphType", "Box", "None"), ("ScaleMode", "Magnitude", "diameter"),
                                ("GlyphType", "Arrow", "velocity"), ("ScaleMode", "No Data Scaling Off", "velocity"),
                                ("SelectScaleArray", "acceleration", "acceleration"), ("GlyphType", "Arrow", "acceleration")):
        setattr(shown, name, value)
        checks.equal("SelectScaleArray of impact_04.vtk after %s = %s" % (name, value), scale.GetElement(0), wanted)
    # Tensors are given in the data's frame: velocities do not turn them.
    for shape, wanted in (("Normal Stress", "None"), ("Split Vector", "velocity"), ("Tensor Ellipsoid", "None"), ("None", "velocity")):
        shown.GlyphShape = shape
        checks.equal("SelectOrientationVectors of %s" % shape, arrays(shown)[1], wanted)
    pv.Delete(view)


def exact_sizes(checks):
    """Spheres of radius 1 and 2, far apart: the covered pixels are those of their disks."""
    width, height, scale = 300, 200, 5.0
    points = numpy.array([[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]])
    radii = numpy.array([1.0, 2.0])
    for name, values, factor in (("radius", radii, 2.0), ("my_diameter", 2.0 * radii, 1.0), ("Radius", radii, 2.0)):
        view = session.view(width, height)
        shown = session.glyphs(session.source(session.poly_data(points, **{name: values})), view)
        shown.ScaleMode = "Magnitude"
        session.look(view, (0.0, 0.0, 30.0), parallel_scale=scale)
        pixels = session.capture(view, "array-choice-" + name)
        checks.equal("factor with the array " + name, shown.ScaleFactor, factor)
        pixel = 2.0 * scale / height
        wanted = numpy.pi * (radii**2).sum() / pixel**2
        checks.within("pixels of spheres with the array " + name, float(comparison.covered(pixels).sum()), 0.98 * wanted, 1.02 * wanted)
        shown.GlyphScaleFunction = "Square Root"
        pv.Render(view)
        checks.true("the square roots of %s count as exact" % name, shown.ScaleFactor not in (1.0, 2.0))
        pv.Delete(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    choices(checks)
    files(checks)
    cells(checks)
    location(checks)
    steps(checks)
    forms(checks)
    other_data(checks)
    lengths(checks)
    exact_sizes(checks)
    checks.report()


if __name__ == "__main__":
    main()
