"""Data as the codes of others write them are right at once: which arrays are chosen, how large the glyphs are, how many there are, and what
is said, with nothing set but what a row says.

Usage: pvpython cases.py [WORD OF A ROW'S NAME...]
"""
import sys

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet

import comparison
import scale_guess
import session
from checks import Checks, number_of_messages

RANDOM = numpy.random.default_rng(11)
ARROWS = {"GlyphType": "Arrow", "ScaleMode": "Magnitude"}
SIZED = {"GlyphType": "Sphere", "ScaleMode": "Magnitude"}


def grid(*sides):
    """Points of a regular grid."""
    return numpy.stack(numpy.meshgrid(*[numpy.arange(float(side)) for side in sides], indexing="ij"), axis=-1).reshape(-1, 3)


def attributes(data, **active):
    """The data with these active arrays: Vectors="velocity", ..."""
    for attribute, name in active.items():
        getattr(data.GetPointData(), "SetActive" + attribute)(name)
    return data


def components(data, name, names):
    """The data with names of an array's components."""
    for i, each in enumerate(names):
        data.GetPointData().GetArray(name).SetComponentName(i, each)
    return data


def blocks(**parts):
    """A multi-block data set."""
    data = vtkMultiBlockDataSet()
    for i, (name, part) in enumerate(parts.items()):
        data.SetBlock(i, part)
        data.GetMetaData(i).Set(vtkMultiBlockDataSet.NAME(), name)
    return data


def lines(points, runs):
    """Poly-lines through the points of each run."""
    return session.with_cells(session.poly_data(points), "Lines", runs)


def box():
    """100 places in a box."""
    return RANDOM.uniform(0.0, 1.0, (100, 3))


def molecule():
    """A file of Cartesian coordinates: ParaView's readers of chemistry give a molecule, of which Molecule To Lines makes points."""
    path = session.output("molecule.xyz")
    with open(path, "w", encoding="ascii") as file:
        file.write("6\nwater and a part of chloromethane\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\nC 3 0 0\nH 3.6 0.6 0.6\nCl 4.2 -1.2 0\n")
    return pv.MoleculeToLines(Input=pv.XYZReader(FileName=path))


def pdb():
    """Atoms as ParaView's reader of PDB files gives them: radii of three equal components and colors are active."""
    radii = numpy.repeat(RANDOM.choice([1.2, 1.5, 1.7], 100)[:, None], 3, axis=1)
    colors = RANDOM.integers(0, 255, (100, 3)).astype(numpy.uint8)
    return attributes(session.poly_data(5.0 * grid(10, 10, 1), radius=radii, rgb_colors=colors), Scalars="rgb_colors", Vectors="radius")


def at_cells(**arrays):
    """Vertices with cell arrays, and nothing at the points."""
    data = session.with_cells(session.poly_data(box()), "Verts", [[i] for i in range(100)])
    session.add_arrays(data, data.GetCellData(), **arrays)
    return data


def cloud(mesh, drops):
    """A mesh with its velocity, and a cloud of drops."""
    return blocks(internalMesh=mesh, cloud=drops)


def openfoam():
    """As ParaView's OpenFOAM reader gives a mesh and a Lagrangian cloud."""
    cavity = 0.01 * grid(11, 11, 2)
    drops = RANDOM.uniform(0.0, 0.1, (37, 3)) * [1.0, 1.0, 0.1]
    return cloud(session.poly_data(cavity, U=RANDOM.normal(size=(242, 3))),
                 session.poly_data(drops, d=RANDOM.uniform(2e-3, 5e-3, 37), U=RANDOM.normal(size=(37, 3)), origProcId=numpy.zeros(37)))


def part_and_node_sets():
    """A part that has displacements and four node sets that have not."""
    part = grid(4, 2, 2) * [0.66, 0.3, 0.3]
    sets = {"set%d" % i: session.poly_data(part[i:i + 10]) for i in range(4)}
    return blocks(part=session.poly_data(part, displacement=0.002 * part[:, [1, 0, 2]] + 1e-4), **sets)


def with_nan(arrays):
    """Points of which two have velocities that are no numbers."""
    velocity = RANDOM.normal(size=(100, 3))
    velocity[[3, 50]] = numpy.nan
    return session.poly_data(box(), velocity=velocity, **arrays)


def tensors(layout, count=8):
    """Shears, stretches and turns as 9 numbers, and those of the symmetric part that an order names."""
    matrix = numpy.array([[3.0, 1.0, 0.5], [1.0, 2.0, -0.7], [0.5, -0.7, 1.0]])
    if all("z" not in index for index in layout):
        matrix[2], matrix[:, 2] = 0.0, 0.0
    if "zz" in layout and "xz" not in layout and "zx" not in layout:
        matrix[2, :2] = matrix[:2, 2] = 0.0
    if len(layout) == 5:
        matrix -= numpy.trace(matrix) / 3.0 * numpy.eye(3)
    chosen = [1.0 if index == "confidence" else matrix["xyz".index(index[0]), "xyz".index(index[1])] for index in layout]
    turning = numpy.array([[0.0, 0.5, -1.0], [-0.5, 0.0, 3.0], [1.0, -3.0, 0.0]])
    return numpy.tile((matrix + turning).reshape(-1), (count, 1)), numpy.tile(chosen, (count, 1))


class Row:
    """One case: data, what is set, and what must come out.

    arrays: property -> name; factor: of ScaleFactor, the lowest and highest; glyphs: their number; says: words of the only message, or None
    """

    def __init__(self, name, data, properties=None, arrays=None, factor=None, glyphs=None, says=None, shown=None):
        self.name, self.data, self.properties = name, data, properties or {}
        self.arrays, self.factor, self.glyphs, self.says, self.shown = arrays or {}, factor, glyphs, says, shown

    def check(self, view, checks):
        """Shows the data."""
        data = self.data()
        display = session.glyphs(session.source(data) if isinstance(data, vtkDataObject) else data, view, shape="Sphere")
        for name, value in self.properties.items():
            session.assign(display, name, value)
        said = session.messages(lambda: (pv.ResetCamera(view), pv.Render(view)))
        for name, wanted in self.arrays.items():
            checks.equal("%s: %s" % (self.name, name), display.SMProxy.GetProperty(name).GetElement(0), wanted)
        if self.factor:
            checks.within(self.name + ": factor", display.ScaleFactor, *self.factor)
        if self.glyphs is not None:
            checks.equal(self.name + ": glyphs", session.statistics(display)["glyphs"], self.glyphs)
        if self.says:
            checks.one_message(self.name, said, *self.says)
        else:
            checks.no_message(self.name, said)
        if self.shown:
            self.shown(self.name, display, view, checks)
        print("%-40s factor %-9.4g %5d glyphs %s" % (self.name, display.ScaleFactor, session.statistics(display)["glyphs"],
                                                     "%d messages" % number_of_messages(said) if said else ""), flush=True)
        pv.Delete(display)


#: (name, order, GlyphTensorLayout): tensors as codes write them, which make the glyphs of the same matrix of nine components
ORDERS = (
    ("xx yy zz xy yz xz", "xx yy zz xy yz xz", "CalculiX, Ansys, OpenFOAM's reader"),
    ("xx xy xz yy yz zz", "xx xy xz yy yz zz", "FSL, NRRD"),
    ("xx yy zz xy xz yz", "xx yy zz xy xz yz", "LAMMPS, Abaqus, TORTOISE, Code_Aster"),
    ("xx xy yy xz yz zz", "xx xy yy xz yz zz", "NIfTI, AFNI"),
    ("xx yy zz yz xz xy", "xx yy zz yz xz xy", "GEOS, ASE, deal.II, MFEM"),
    ("confidence xx xy xz yy yz zz", "xx yy zz xy yz xz", "Teem, Slicer"),
    ("xx yy zz xy", "xx yy zz xy yz xz", "plane strain: Abaqus, Code_Aster, CalculiX"),
    ("xx xy yx yy", "Matrix", "FEniCS in the plane"),
    ("xx yy xy", "xx yy zz xy yz xz", "plane stress: Voigt's order"),
    ("xx xy yy", "xx xy xz yy yz zz", "the upper triangle of a matrix of the plane"),
    ("xx xy xz yy yz", "xx yy zz xy yz xz", "nematics, without a trace: openQmin, Ludwig"),
)


def orders(view, checks):
    """Each order has the picture of the matrix."""
    for order, layout, codes in ORDERS:
        whole, part = tensors(order.split())
        named = tensors(list(reversed(order.replace("confidence ", "").split())))[1]
        columns = {"s_" + index: part[:, i] for i, index in enumerate(order.split()) if index != "confidence"}
        data = session.poly_data(3.0 * grid(2, 2, 2), matrix=whole, part=part, named=named, **columns)
        letters = ["S" + index for index in reversed(order.replace("confidence ", "").split())]
        source = session.source(components(data, "named", letters) if len(letters) not in (1, ) else data)
        shown = session.glyphs(source, view, "Tensor Ellipsoid", GlyphTensorArray="matrix", ScaleFactor=0.5)
        shown.ColorArrayName = [None, ""]
        pv.ResetCamera(view)
        wanted = session.capture(view, "cases-tensors-matrix")
        shown.GlyphTensorArray, shown.GlyphTensorLayout = "part", layout
        said = session.messages(lambda: pv.Render(view))
        checks.no_message("tensors %s (%s)" % (order, codes), said)
        checks.picture("tensors %s" % order, session.capture(view, "cases-tensors-part"), wanted)
        for array, what in (("named", "components named"), (", ".join(reversed(columns)), "columns named")):
            shown.GlyphTensorArray, shown.GlyphTensorLayout = array, "xx yy zz xy yz xz"
            checks.no_message(what + " " + order, session.messages(lambda: pv.Render(view)))
            checks.picture("%s %s, reversed" % (what, order), session.capture(view, "cases-tensors-named"), wanted)
        pv.Delete(shown)


#: Points of a periodic box that all move by 0.3 along x in a step; they come back on the other side.
PERIODIC = """
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
info, key = self.GetOutputInformation(0), vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
time = info.Get(key) if info.Has(key) else 0.0
output = dataset_adapter.WrapDataObject(self.GetOutputDataObject(0))
points = numpy.random.default_rng(1).uniform(0.0, 10.0, (80, 3))
points[:, 0] = (points[:, 0] + 0.3 * time) % 10.0
output.Points = points
output.PointData.append(numpy.arange(80), "id")
output.VTKObject.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
"""


def periodic(view, checks):
    """Points that cross the border of a periodic box make no streak through the picture."""
    source = pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=PERIODIC,
                                   ScriptRequestInformation=scale_guess.TIMES % ([0.0, 1.0], 0.0, 1.0))
    shown = session.glyphs(source, view, "Sphere", MotionBlur=1, VelocityArray="From Previous Step", PointIdArray="id", ShutterTime=1.0,
                           ScaleFactor=0.3)
    view.ViewTime = 0.0
    session.messages(lambda: (pv.ResetCamera(view), pv.Render(view)))
    view.ViewTime = 1.0
    checks.no_message("periodic", session.messages(lambda: pv.Render(view)))
    velocity = delivered(shown, "From Previous Step")
    points = numpy.random.default_rng(1).uniform(0.0, 10.0, (80, 3))
    crossing = points[:, 0] + 0.3 >= 10.0
    checks.true("no point crosses the border", crossing.any())
    checks.within("fastest way in a periodic box", float(numpy.linalg.norm(velocity, axis=1).max()), 0.299, 0.301)
    checks.equal("points that stand still", int((velocity[:, 0] == 0.0).sum()), int(crossing.sum()))
    view.ViewTime = 0.0
    pv.Delete(shown)


def tubes(view, checks):
    """Radii of tubes: separators of lines that are not finite, diameters, vectors."""
    run = numpy.array([[0.1 * i, numpy.sin(0.1 * i), 0.0] for i in range(151)])
    apart = numpy.concatenate([run, [[numpy.nan] * 3, [numpy.inf] * 3]])
    throats = lines(2.0 * grid(3, 1, 1), [(0, 1), (1, 2)])
    session.add_arrays(throats, **{"throat.diameter": numpy.full(3, 0.3), "force": numpy.tile([3.0, 4.0, 0.0], (3, 1))})
    for name, data, properties, wanted in (
            ("lines with separators", lines(apart, [range(151)]), {}, 0.15),
            ("throats by their diameters", throats, {"TubeRadiusArray": "throat.diameter"}, 0.5),
            ("chains by their forces", throats, {"TubeRadiusArray": "force"}, 0.01 * 4.0 / 5.0)):
        shown = session.show(session.source(data), view, "Ray Traced Tubes", **properties)
        checks.no_message(name, session.messages(lambda: pv.Render(view)))
        checks.within("TubeRadius of " + name, shown.TubeRadius, 0.99 * wanted, 1.01 * wanted)
        pv.Delete(shown)
    weak = lines(2.0 * grid(3, 1, 1), [(0, 1), (1, 2)])
    session.add_arrays(weak, force=numpy.tile([3e-3, 4e-3, 0.0], (3, 1)))
    for name, steps, properties, wanted in (("paths that grow", (lines(1e-3 * run, [range(151)]), lines(run, [range(151)])), {}, 0.15),
                                            ("forces that grow", (weak, throats), {"TubeRadiusArray": "force"}, 0.01 * 4.0 / 5.0)):
        view.ViewTime = 0.0
        shown = session.show(session.source(steps[0]), view, "Ray Traced Tubes", **properties)
        pv.Render(view)
        for time, data in ((1.0, steps[1]), (2.0, steps[0])):
            view.ViewTime = time
            session.replace_data(shown.Input, data)
            checks.no_message(name, session.messages(lambda: pv.Render(view)))
            checks.within("TubeRadius of %s at time %g" % (name, time), shown.TubeRadius, 0.99 * wanted, 1.01 * wanted)
        pv.Delete(shown)
    view.ViewTime = 0.0


def ramp(view, checks):
    """A displacement that grows from nothing in blocks of which only one has it."""
    part = part_and_node_sets()
    shown = session.glyphs(session.source(part), view, "Arrow", ScaleMode="Magnitude")
    said = session.messages(lambda: pv.Render(view))
    for factor in (2.0, 4.0, 8.0, 16.0):
        grown = part_and_node_sets()
        array = grown.GetBlock(0).GetPointData().GetArray("displacement")
        for i in range(3):
            for k in range(array.GetNumberOfTuples()):
                array.SetComponent(k, i, factor * array.GetComponent(k, i))
        view.ViewTime = factor
        session.replace_data(shown.Input, grown)
        said += session.messages(lambda: pv.Render(view))
    checks.one_message("a ramp", said, "Blocks 'set0', 'set1', 'set2' and 1 more have no array 'displacement'", "40 points have no glyph")
    view.ViewTime = 0.0
    pv.Delete(shown)


VECTORS, TENSORS, ODF = ("Arrow", "SelectOrientationVectors"), ("Tensor Ellipsoid", "GlyphTensorArray"), ("Spherical Harmonics", "GlyphHarmonicsArray")
#: what writes such a table: its columns, shape and property, columns that are joined (none: None)
TABLES = (
    ("Fluent", "pressure x-velocity y-velocity z-velocity", VECTORS, "x-velocity, y-velocity, z-velocity"),
    ("CFX-Post", "Pressure_[Pa] Velocity_u_[m/s] Velocity_v_[m/s] Velocity_w_[m/s]", VECTORS, "Velocity_u_[m/s], Velocity_v_[m/s], Velocity_w_[m/s]"),
    ("STAR-CCM+", "Velocity[i] Velocity[j] Velocity[k]", VECTORS, "Velocity[i], Velocity[j], Velocity[k]"),
    ("velocities of one letter", "U V W p", VECTORS, "U, V, W"),
    ("AMReX, yt", "xvel yvel zvel density", VECTORS, "xvel, yvel, zvel"),
    ("Copernicus, currents", "uo vo wo thetao so", VECTORS, "uo, vo, wo"),
    ("CMIP, winds in the plane", "ua va ta", VECTORS, "ua, va"),
    ("GNSS, east, north, up", "ve vn vu se sn su", VECTORS, "ve, vn, vu"),
    ("heat fluxes", "x_flux y_flux z_flux T", VECTORS, "x_flux, y_flux, z_flux"),
    ("SU2", "Momentum_x Momentum_y Momentum_z", VECTORS, "Momentum_x, Momentum_y, Momentum_z"),
    ("velocities and accelerations", "id x_vel y_vel z_vel x_acc y_acc z_acc mass", VECTORS, "x_vel, y_vel, z_vel"),
    ("ParaView, vectors", "Points:0 Points:1 Points:2 U:0 U:1 U:2 p", VECTORS, "U:0, U:1, U:2"),
    ("FLEXI in the plane", "Density MomentumX MomentumY", VECTORS, "MomentumX, MomentumY"),
    ("Trixi in the plane", "rho v1 v2 p", VECTORS, "v1, v2"),
    ("PLUTO", "Bx1 Bx2 Bx3 vx1 vx2 vx3", VECTORS, "vx1, vx2, vx3"),
    ("CST, a complex field", "ExIm EyIm EzIm ExRe EyRe EzRe", VECTORS, "ExRe, EyRe, EzRe"),
    ("MPAS in the plane", "velocityZonal velocityMeridional", VECTORS, "velocityZonal, velocityMeridional"),
    ("MPAS on a sphere", "velocityZonal velocityMeridional", VECTORS, None),
    ("stations", "vel_east vel_north vel_up", VECTORS, "vel_east, vel_north, vel_up"),
    ("LAMMPS, coordinates", "xu yu zu xs ys zs", VECTORS, None),
    ("coordinates", "xParticle yParticle zParticle", VECTORS, None),
    ("two species", "u v", VECTORS, None),
    ("LAMMPS, dipoles", "id q mux muy muz", VECTORS, "mux, muy, muz"),
    ("LAMMPS, periodic images as whole numbers", "ix iy iz", VECTORS, None),
    ("a histogram", " ".join("bin%d" % i for i in range(32)), VECTORS, None),
    ("LAMMPS, stress", " ".join("c_stress[%d]" % i for i in range(1, 7)), TENSORS, "c_stress[1], c_stress[2], c_stress[3], c_stress[4], c_stress[6], c_stress[5]"),
    ("MOOSE", "disp_x disp_y disp_z stress_xx stress_yy stress_zz stress_xy stress_yz stress_zx", TENSORS,
     "stress_xx, stress_yy, stress_zz, stress_xy, stress_yz, stress_zx"),
    ("MOOSE in the plane", "disp_x disp_y stress_xx stress_yy stress_zz stress_xy", TENSORS, "stress_xx, stress_yy, stress_zz, stress_xy"),
    ("Abaqus", "S.S11 S.S22 S.S33 S.S12 S.S13 S.S23", TENSORS, "S.S11, S.S22, S.S33, S.S12, S.S23, S.S13"),
    ("plane stress", "sxx syy sxy", TENSORS, "sxx, syy, sxy"),
    ("openQmin", "Qxx Qxy Qxz Qyy Qyz type", TENSORS, "Qxx, Qxy, Qxz, Qyy, Qyz"),
    ("active nematics in the plane", "Qxx Qxy", TENSORS, "Qxx, Qxy"),
    ("ParaView, matrices", " ".join("DTI:%d" % i for i in range(9)), TENSORS, ", ".join("DTI:%d" % i for i in range(9))),
    ("ParaView, symmetric tensors", " ".join("S:%d" % i for i in range(6)), TENSORS, ", ".join("S:%d" % i for i in range(6))),
    ("ParaView, harmonics", " ".join("odf:%d" % i for i in range(15)), ODF, ", ".join("odf:%d" % i for i in range(15))),
)


def tables(view, checks):
    """Columns of tables are joined to the vectors and tensors that codes write in them; what only looks like that is not."""
    shown = session.glyphs(session.source(session.poly_data(box())), view, "Sphere", ScaleFactor=0.1)
    for code, names, (shape, where), wanted in TABLES + (("wind in the plane", "u10 v10 t2m", VECTORS, "u10, v10"), ):
        places = box() * [1.0, 1.0, 0.0 if "plane" in code else 1.0]
        session.assign_shape(shown, "Sphere")
        session.replace_data(shown.Input, session.poly_data(places, **{
            name.replace("_[", " ["): (8.0 * RANDOM.normal(size=100)).astype(int if "whole" in code else float) for name in names.split()}))
        session.assign_shape(shown, shape)
        session.messages(lambda: pv.Render(view))
        wanted = wanted.replace("_[", " [") if wanted else "None"
        checks.equal("columns of " + code, shown.SMProxy.GetProperty(where).GetElement(0), wanted)
        listed = shown.SMProxy.GetProperty(where).GetDomain("array_list")
        listed = [listed.GetString(i) for i in range(listed.GetNumberOfStrings())]
        checks.true("the list of %s lacks %s: %s" % (code, wanted, listed), wanted in listed or where == DIRECTION)  # DIRECTION's domain is 3D Glyphs'
    pv.Delete(shown)


#: what is set -> the sentence that says that it has no effect, or what it does
IDLE = (
    ({"PeriodicImages": [1, 0, 0]}, "PeriodicImages has no effect"),
    ({"PeriodicBoundary": 1}, "PeriodicBoundary has no effect"),
    ({"PeriodicBoundary": 1, "PeriodicImages": [1, 0, 0]}, "The periodic box is that of the points' bounds"),
    ({"PeriodicBoundary": 1, "PeriodicImages": [1, 0, 0], "PeriodicVectors": [4.0, 0, 0, 0, 4.0, 0, 0, 0, 4.0]}, None),
    ({"PeriodicBoundary": 1, "ShadingMode": "Ambient Occlusion", "AmbientOcclusionRadius": 1.0, "PeriodicVectors": [4.0, 0, 0, 0, 4.0, 0, 0, 0, 4.0]}, None),
    ({"Section": "Plane", "SectionOrigin": [9.0, 0.0, 0.0]}, "Section has no effect"),
    ({"Section": "Plane", "SectionOrigin": [-9.0, 0.0, 0.0]}, "Section cuts off all"),
    ({"Section": "Plane", "SectionOrigin": [3.2, 0.0, 0.0]}, None),  # outside the points, inside their glyphs
    ({"Section": "Box", "SectionPosition": [-1.0] * 3, "SectionLength": [5.0] * 3}, "Section has no effect"),
    ({"Section": "Box", "SectionPosition": [-1.0] * 3, "SectionLength": [5.0] * 3, "SectionInvert": 0}, "Section cuts off all"),
    ({"Section": "Box", "SectionPosition": [0.0] * 3, "SectionLength": [2.0, 0.0, 0.0], "SectionInvert": 0}, None),
)


def idle(view, checks):
    """Statistics says what is set and has no effect."""
    for properties, wanted in IDLE:
        shown = session.glyphs(session.source(session.poly_data(grid(4, 4, 4))), view, "Sphere", ScaleFactor=0.9, **properties)
        checks.no_message("%s" % properties, session.messages(lambda: (pv.ResetCamera(view), pv.Render(view))))
        said = [sentence for sentence in session.statistics(shown)["choices"] if "eriodic" in sentence or "Section" in sentence]
        checks.true("%s says %s, not %s" % (properties, said, wanted), len(said) == (1 if wanted else 0) and all(wanted in sentence for sentence in said))
        pv.Delete(shown)
    view.ViewTime = 0.0
    boxed = session.poly_data(grid(4, 4, 4))
    lattice = vtkDoubleArray()
    lattice.SetName("Lattice")
    lattice.SetNumberOfComponents(3)
    for i in range(3):
        lattice.InsertNextTuple([4.0 * (i == k) for k in range(3)])
    boxed.GetFieldData().AddArray(lattice)
    shown = session.glyphs(session.source(boxed), view, "Sphere", PeriodicBoundary=1, PeriodicImages=[1, 0, 0])
    pv.Render(view)
    checks.true("a box of the data: %s" % session.statistics(shown)["choices"], not any("eriodic" in each for each in session.statistics(shown)["choices"]))
    wanted = view.SMProxy.GetRenderer().ComputeVisiblePropBounds()
    pv.Delete(shown)
    # The box may be that of a block, or of all blocks.
    for owner in ("a block", "all blocks"):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, session.poly_data(grid(4, 4, 4)))
        (blocks.GetBlock(0) if owner == "a block" else blocks).GetFieldData().AddArray(lattice)
        shown = session.glyphs(session.source(blocks), view, "Sphere", PeriodicBoundary=1, PeriodicImages=[1, 0, 0])
        pv.Render(view)
        checks.equal("bounds with the box of " + owner, view.SMProxy.GetRenderer().ComputeVisiblePropBounds(), wanted)
        pv.Delete(shown)


def unit(count, components):
    """Tuples of length 1."""
    tuples = RANDOM.normal(size=(count, components))
    return tuples / numpy.linalg.norm(tuples, axis=1, keepdims=True)


SIZE, DIRECTION = "SelectScaleArray", "SelectOrientationVectors"
PLACES = grid(5, 5, 4)
#: what has such arrays, and by shape which of them properties must have
SHUFFLED = (
    ("grains", {"radius": RANDOM.uniform(0.3, 0.5, 100), "velocity": 30.0 * RANDOM.normal(size=(100, 3)), "id": numpy.arange(100), "place": PLACES,
                "turn": unit(100, 4), "density": RANDOM.uniform(900.0, 1100.0, 100)},
     {"Sphere": {SIZE: "radius"}, "Arrow": {DIRECTION: "velocity", SIZE: "velocity"}, "Superquadric": {DIRECTION: "turn", SIZE: "radius"}}),
    ("a flow", {"U": RANDOM.normal(size=(100, 3)), "p": RANDOM.normal(size=100), "k": RANDOM.uniform(0.0, 1e-3, 100), "omega": 1e4 + numpy.zeros(100)},
     {"Arrow": {DIRECTION: "U", SIZE: "U"}}),
    ("a part", {"displacement": 1e-4 * RANDOM.normal(size=(100, 3)), "stress": 1e8 * RANDOM.normal(size=(100, 6)), "T": 300.0 + RANDOM.normal(size=100)},
     {"Arrow": {DIRECTION: "displacement", SIZE: "displacement"}, "Tensor Ellipsoid": {"GlyphTensorArray": "stress"}}),
    ("ellipsoids", {"id": numpy.arange(100), "type": 1 + numpy.arange(100) % 2, "q": unit(100, 4), "v": 30.0 * RANDOM.normal(size=(100, 3)),
                    "diameter": RANDOM.uniform(0.5, 0.9, 100)},
     {"Superquadric": {DIRECTION: "q", SIZE: "diameter"}, "Arrow": {DIRECTION: "v", SIZE: "v"}}),
    ("a fluid of particles", {"velocity": RANDOM.normal(size=(100, 3)), "density": 1000.0 + RANDOM.normal(size=100), "spacing": numpy.full(100, 0.9)},
     {"Arrow": {DIRECTION: "velocity", SIZE: "velocity"}, "Sphere": {SIZE: "spacing"}}),
    ("voxels", {"tensor": (lambda turns: numpy.einsum("nij,j,nkj->nik", turns, [1.7e-3, 4e-4, 2e-4], turns).reshape(-1, 9))(
        numpy.linalg.qr(RANDOM.normal(size=(100, 3, 3)))[0]), "FA": numpy.full(100, 0.8), "rotation": numpy.linalg.qr(RANDOM.normal(size=(100, 3, 3)))[0].reshape(-1, 9)},
     {"Tensor Ellipsoid": {"GlyphTensorArray": "tensor"}}),
)


def shuffled(view, checks):
    """Where names say nothing values do, or the choice says that it is one of several."""
    shown = session.glyphs(session.source(session.poly_data(PLACES)), view, "Arrow", ScaleMode="Magnitude", ScaleFactor=0.1)
    right = wrong = 0
    for what, arrays, shapes in SHUFFLED * 3:
        names = dict(zip(arrays, RANDOM.permutation(list("abdfhquv"))))
        session.assign_shape(shown, "Sphere")
        session.replace_data(shown.Input, session.poly_data(PLACES, **{names[name]: arrays[name] for name in sorted(arrays, key=names.get)}))
        for shape, wanted in shapes.items():
            session.assign_shape(shown, shape)
            session.messages(lambda: pv.Render(view))
            reasons = session.statistics(shown)["choices"]
            for name, array in wanted.items():
                found = shown.SMProxy.GetProperty(name).GetElement(0)
                said = found == "None" or any(" by %s:" % found in reason and "equal candidates" in reason for reason in reasons)
                right, wrong = right + (found == names[array]), wrong + (found != names[array])
                checks.true("%s, %s: %s is %s, not %s (%s), without a hint" % (what, shape, name, found, array, reasons), found == names[array] or said)
    checks.within("share of the right guesses without names", right / (right + wrong), 0.8, 1.0)
    pv.Delete(shown)
    vectors = session.poly_data(PLACES, a=RANDOM.normal(size=(100, 3)), b=RANDOM.normal(size=(100, 3)), c=PLACES)
    shown = session.glyphs(session.source(vectors), view, "Arrow", ScaleMode="Magnitude")
    pv.Render(view)
    reasons = session.statistics(shown)["choices"]
    checks.true("two vectors: %s" % reasons, any("first of 2 equal candidates" in reason for reason in reasons))
    session.assign_shape(shown, "Tensor Ellipsoid")
    for tensor, vector in ("ab", "ba"):
        session.replace_data(shown.Input, session.poly_data(PLACES, **{tensor: RANDOM.normal(size=(100, 6)), vector: RANDOM.normal(size=(100, 3))}))
        checks.no_message("tensors are " + tensor, session.messages(lambda: pv.Render(view)))
        checks.equal("tensors after others of that name", shown.SMProxy.GetProperty("GlyphTensorArray").GetElement(0), tensor)
    pv.Delete(shown)


def delivered(display, array):
    """Values of an array of the points that glyphs are made of."""
    display.SMProxy.UpdatePropertyInformation()
    leaf = display.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0).NewIterator()
    leaf.InitTraversal()
    return vtk_to_numpy(leaf.GetCurrentDataObject().GetPointData().GetArray(array))


def elements(name, display, view, checks):
    """Radii of O, H, H, C, H, Cl as in the Blue Obelisk Data Repository."""
    found = delivered(display, display.SMProxy.GetProperty(SIZE).GetElement(0))
    checks.within(name + ": error of the radii", float(abs(found - [1.55, 1.2, 1.2, 1.7, 1.2, 1.8]).max()), 0.0, 1e-6)


def streak(name, display, view, checks):
    """Motion blur has something to show."""
    checks.equal(name + ": motion", session.statistics(display).get("missingInput", ""), "")


ROWS = (
    # Arrays that are made of others
    Row("columns of whole numbers and fractions", lambda: session.poly_data(
        grid(4, 4, 1), shapex=numpy.ones(16, int), shapey=numpy.full(16, 0.5), shapez=numpy.full(16, 0.25)),
        {"ScaleMode": "Vector Components", "SelectScaleArray": "shapex, shapey, shapez"}, glyphs=16),
    Row("columns whose names have commas", lambda: session.poly_data(
        grid(4, 4, 1), **{"u, m/s": numpy.ones(16), "v, m/s": numpy.ones(16), "w, m/s": numpy.zeros(16)}),
        {"GlyphType": "Arrow", "SelectOrientationVectors": "u, m/s, v, m/s, w, m/s"}, glyphs=16),
    # Sizes
    Row("units", lambda: session.poly_data(box(), **{"Diameter, mm": RANDOM.uniform(20.0, 80.0, 100)}), SIZED,
        {"SelectScaleArray": "Diameter, mm"}, (1e-4, 0.2 / 79.0)),
    Row("atoms", pdb, SIZED, {"SelectScaleArray": "radius", "SelectOrientationVectors": "None"}, (1.15, 1.16), 100),
    Row("atoms, components", pdb, {"GlyphType": "Sphere", "ScaleMode": "Vector Components"},
        {"SelectScaleArray": "radius"}, (2.0, 2.0), 100),
    Row("atoms of a molecule", molecule, SIZED, {"SelectScaleArray": "Van der Waals radii of Atomic Numbers"}, (2.0, 2.0), 6, shown=elements),
    Row("drops beside a mesh", openfoam, {**SIZED, "SelectScaleArray": "d"}, factor=(1.0, 1.0), glyphs=37, says=["Block 'internalMesh'", "242 points", "'d'", "BlockSelectors"]),
    Row("drops", lambda: openfoam().GetBlock(1), SIZED, {"SelectScaleArray": "d"}, (1.0, 1.0), 37),
    Row("fluid particles", lambda: session.poly_data(0.1 * grid(6, 6, 6), velocity=RANDOM.normal(size=(216, 3)), pressure=numpy.ones(216),
                                                     particle_spacing=numpy.full(216, 0.1)),
        SIZED, {"SelectScaleArray": "particle_spacing"}, (1.0, 1.0), 216),
    Row("smoothing lengths", lambda: session.poly_data(0.1 * grid(6, 6, 6), density=numpy.ones(216), smoothing_length=numpy.full(216, 0.12)),
        SIZED, {"SelectScaleArray": "smoothing_length"}, (0.4, 0.84), 216),
    Row("colors and flags", lambda: attributes(session.poly_data(
        box(), b=numpy.ones(100), FA=RANDOM.uniform(size=100), _rgba=numpy.ones((100, 4), numpy.uint8),
        mask=(RANDOM.uniform(size=100) > 0.5).astype(numpy.int8), vtkGhostType=numpy.zeros(100, numpy.uint8)), Scalars="_rgba"),
        SIZED, {"SelectScaleArray": "FA"}),
    Row("halos of dark matter", lambda: session.poly_data(100.0 * box(), mvir=10.0**RANDOM.uniform(10.0, 15.0, 100), rvir=RANDOM.uniform(50.0, 900.0, 100),
                                                         vel=300.0 * RANDOM.normal(size=(100, 3))),
        SIZED, {"SelectScaleArray": "rvir"}, (1e-4, 0.2 * 100.0 / 800.0)),
    # Directions
    Row("vectors of two components", lambda: session.poly_data(grid(8, 8, 1), VELOCITY=RANDOM.normal(size=(64, 2))),
        {**ARROWS, "MotionBlur": 1}, {"SelectOrientationVectors": "VELOCITY", "SelectScaleArray": "VELOCITY", "VelocityArray": "VELOCITY"},
        glyphs=64, shown=streak),
    Row("stream lines", lambda: attributes(session.poly_data(
        box(), U=RANDOM.normal(size=(100, 3)), Vorticity=RANDOM.normal(size=(100, 3)), Normals=RANDOM.normal(size=(100, 3))), Vectors="Normals"),
        ARROWS, {"SelectOrientationVectors": "U", "SelectScaleArray": "U"}, glyphs=100),
    Row("no direction", lambda: session.poly_data(box(), pressure=numpy.ones(100)), {"GlyphType": "Arrow"},
        {"SelectOrientationVectors": "None"}, glyphs=100, says=["SelectOrientationVectors", "direction"]),
    Row("positions beside vectors", lambda: session.poly_data(box(), xyz=box(), vectors_xyz=RANDOM.normal(size=(100, 3))), ARROWS,
        {"SelectOrientationVectors": "vectors_xyz", "SelectScaleArray": "vectors_xyz"}),
    Row("modes of vibration", lambda: session.poly_data(
        grid(4, 4, 4), Mode_1_imag=1e-3 * (grid(4, 4, 4) + 1.0), Mode_1_real=grid(4, 4, 4)[:, ::-1] - 1.0, Mode_0_error=grid(4, 4, 4) + 2.0),
        ARROWS, {"SelectOrientationVectors": "Mode_1_real", "SelectScaleArray": "Mode_1_real"}),
    Row("averages of OpenFOAM", lambda: session.poly_data(
        box(), UMean=RANDOM.normal(size=(100, 3)), UPrime2Mean=RANDOM.normal(size=(100, 6)), **{"grad(p)": RANDOM.normal(size=(100, 3))},
        wallShearStress=RANDOM.normal(size=(100, 3))), ARROWS, {"SelectOrientationVectors": "UMean", "GlyphTensorArray": "UPrime2Mean"}),
    Row("principal stresses", lambda: session.poly_data(box(), eigenvalues=RANDOM.normal(size=(100, 3)), eigenvector_1=unit(100, 3)), ARROWS,
        {"SelectOrientationVectors": "eigenvector_1"}),
    Row("a complex field", lambda: session.poly_data(box(), **{"electric field im": RANDOM.normal(size=(100, 3)), "electric field re": RANDOM.normal(size=(100, 3))}),
        ARROWS, {"SelectOrientationVectors": "electric field re"}),
    Row("columns at cells", lambda: at_cells(Ex=RANDOM.normal(size=100), Ey=RANDOM.normal(size=100), Ez=RANDOM.normal(size=100), rho=RANDOM.normal(size=100)),
        ARROWS, {"GlyphLocation": 1, "SelectOrientationVectors": "Ex, Ey, Ez"}, glyphs=100),
    Row("sizes at cells", lambda: at_cells(radius=RANDOM.uniform(0.01, 0.02, 100)), SIZED, {"GlyphLocation": 1, "SelectScaleArray": "radius"}, (2.0, 2.0)),
    Row("orientations of fibers in a composite", lambda: session.poly_data(box(), fiber_orientation=tensors("xx yy zz xy yz xz".split(), 100)[1]),
        {"GlyphShape": "Tensor Ellipsoid"}, {"GlyphTensorArray": "fiber_orientation"}, glyphs=100),
    Row("orientation tensors", lambda: session.poly_data(box(), **{"Fiber orientation tensor": tensors("xx yy zz xy yz xz".split(), 100)[0]}),
        {"GlyphShape": "Tensor Ellipsoid"}, {"GlyphTensorArray": "Fiber orientation tensor"}, glyphs=100),
    # Bodies are turned by what turns them
    Row("bodies with quaternions", lambda: session.poly_data(
        grid(4, 4, 4), v=RANDOM.normal(size=(64, 3)), quat=RANDOM.normal(size=(64, 4)), shape=numpy.ones((64, 3))), {"GlyphShape": "Capsule"},
        {"SelectOrientationVectors": "quat"}, glyphs=64),
    Row("bodies with matrices", lambda: attributes(session.poly_data(
        grid(4, 4, 4), v=RANDOM.normal(size=(64, 3)), TENSOR=numpy.tile(numpy.eye(3).reshape(-1), (64, 1))), Vectors="v"),
        {"GlyphShape": "Superquadric"}, {"SelectOrientationVectors": "TENSOR"}, glyphs=64),
    Row("arrows of bodies", lambda: session.poly_data(
        grid(4, 4, 4), v=RANDOM.normal(size=(64, 3)), quat=RANDOM.normal(size=(64, 4))), ARROWS, {"SelectOrientationVectors": "v"}),
    # Messages
    Row("blocks without the array", part_and_node_sets, ARROWS, {"SelectScaleArray": "displacement"}, (1.0, 200.0), 16, says=["'set0'", "40 points", "'displacement'", "BlockSelectors"]),
    Row("two reasons", lambda: with_nan({}), ARROWS, glyphs=98, says=["2 of 100", "velocity"]),
    Row("a drop of no size that a code adds to empty steps", lambda: session.poly_data(
        numpy.concatenate([box(), [[0.5, 0.5, 0.5]]]), d=numpy.append(RANDOM.uniform(0.02, 0.05, 100), 0.0)), SIZED, {"SelectScaleArray": "d"}, (1.0, 1.0), 100),
    Row("a step whose vectors are all zero", lambda: session.poly_data(box(), velocity=numpy.zeros((100, 3))), ARROWS, glyphs=0,
        says=["100 of 100", "velocity"]),
    # Names say nothing
    Row("letters", lambda: session.poly_data(box(), a=RANDOM.uniform(size=100), b=RANDOM.normal(size=(100, 3)), c=numpy.arange(100)), ARROWS,
        {"SelectScaleArray": "b", "SelectOrientationVectors": "b"}),
    Row("letters of sizes", lambda: session.poly_data(grid(5, 5, 4), a=numpy.arange(100.0), b=RANDOM.uniform(0.8, 1.0, 100)), SIZED,
        {"SelectScaleArray": "b"}),
)


def main(words):
    """All rows, or those whose names have one of the words."""
    session.load()
    checks = Checks()
    view = session.view(120, 90)
    for row in ROWS:
        if not words or any(word in row.name for word in words):
            row.check(view, checks)
    for part in (orders, tables, idle, tubes, periodic, ramp, shuffled):
        if not words or part.__name__ in words:
            part(view, checks)
    checks.report()


if __name__ == "__main__":
    main(sys.argv[1:])
