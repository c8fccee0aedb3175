"""Small files in the formats and conventions of codes, opened and shown as ray-traced glyphs with nothing set but a shape: which arrays are
chosen and why, how large the glyphs are, how many, and what colors them. All pictures are in one sheet, corpus.png.

Usage: pvpython corpus.py [WORD OF A ROW'S NAME...]
"""
import os
import sys

import numpy
import paraview.simple as pv
from paraview import smtrace

import comparison
import scale_guess
import session
from cases import grid, molecule, unit
from checks import Checks, stepwise

RANDOM = numpy.random.default_rng(5)
WIDTH, HEIGHT, COLUMNS = 240, 180, 5
#: fraction of the picture that glyphs cover
LEAST, MOST = 0.02, 0.75


def text(values, form="%.6g"):
    """Tuples, one a line."""
    return "\n".join(" ".join(form % number for number in numpy.atleast_1d(row)) for row in values) + "\n"


def write(name, content):
    """A file of the corpus."""
    path = session.output(os.path.join("corpus", name))
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        file.write(content)
    return path


def legacy(name, points, **arrays):
    """A legacy VTK file of vertices, as LAMMPS, LIGGGHTS and DualSPHysics write them: each array a field."""
    count = len(points)
    content = "# vtk DataFile Version 3.0\nGenerated\nASCII\nDATASET POLYDATA\nPOINTS %d float\n%sVERTICES %d %d\n" % (
        count, text(points), count, 2 * count) + "".join("1 %d\n" % i for i in range(count))
    content += "POINT_DATA %d\nFIELD FieldData %d\n" % (count, len(arrays))
    for array, values in arrays.items():
        values = numpy.asarray(values)
        kind = "int" if values.dtype.kind == "i" else "double"
        content += "%s %d %d %s\n%s" % (array, values.reshape(count, -1).shape[1], count, kind, text(values))
    return write(name, content)


def data_array(name, values, components=()):
    """One array of a VTK XML file; components: names of these."""
    values = numpy.asarray(values)
    kind = {"i": "Int32", "u": "UInt8"}.get(values.dtype.kind, "Float64")
    names = "".join(' ComponentName%d="%s"' % entry for entry in enumerate(components))
    return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii"%s>\n%s</DataArray>\n' % (
        kind, name, values.reshape(len(values), -1).shape[1], names, text(values))


def vtp(name, points, attributes="", **arrays):
    """A VTK XML file of vertices, as MFIX, Yade and SPH codes write them."""
    count = len(points)
    return write(name, '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
                 '<Piece NumberOfPoints="%d" NumberOfVerts="%d"><Points>%s</Points><Verts>%s%s</Verts><PointData%s>%s</PointData></Piece>'
                 '</PolyData></VTKFile>' % (
                     count, count, data_array("Points", points), data_array("connectivity", numpy.arange(count)),
                     data_array("offsets", 1 + numpy.arange(count)), attributes, "".join(data_array(*entry) for entry in arrays.items())))


def hexahedra(sides):
    """Corners of the cells of grid(*sides)."""
    number = numpy.arange(numpy.prod(sides)).reshape(sides)
    low, high = slice(None, -1), slice(1, None)
    corners = ((low, low, low), (high, low, low), (high, high, low), (low, high, low),
               (low, low, high), (high, low, high), (high, high, high), (low, high, high))
    return numpy.stack([number[corner].reshape(-1) for corner in corners], axis=1)


def vtu(name, sides, spacing, points=None, cells=None):
    """A VTK XML file of hexahedra, as meshio, ccx2paraview, deal.II and SU2 write them; points, cells: name -> values or (values, names of components)."""
    places, corners = grid(*sides) * spacing, hexahedra(sides)

    def arrays(of):
        return "".join(data_array(array, *(values if isinstance(values, tuple) else (values, ))) for array, values in (of or {}).items())
    return write(name, '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>'
                 '<Piece NumberOfPoints="%d" NumberOfCells="%d"><Points>%s</Points><Cells>%s%s%s</Cells><PointData>%s</PointData><CellData>%s</CellData></Piece>'
                 '</UnstructuredGrid></VTKFile>' % (
                     len(places), len(corners), data_array("Points", places), data_array("connectivity", corners.reshape(-1)),
                     data_array("offsets", 8 * (1 + numpy.arange(len(corners)))),
                     data_array("types", numpy.full(len(corners), 12, numpy.uint8)), arrays(points), arrays(cells)))


def vti(name, sides, **arrays):
    """A VTK XML image."""
    extent = "0 %d 0 %d 0 %d" % tuple(side - 1 for side in sides)
    return write(name, '<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="%s" Origin="0 0 0" Spacing="2 2 2">'
                 '<Piece Extent="%s"><PointData>%s</PointData></Piece></ImageData></VTKFile>'
                 % (extent, extent, "".join(data_array(*entry) for entry in arrays.items())))


def table(name, **columns):
    """A CSV file as points."""
    reader = pv.CSVReader(FileName=[write(name, ",".join(columns) + "\n" + "\n".join(
        ",".join("%g" % value for value in row) for row in zip(*columns.values())) + "\n")])
    points = pv.TableToPoints(Input=reader)
    points.XColumn, points.YColumn, points.ZColumn = list(columns)[:3]
    return points


def swirl(points, scale=1.0):
    """Vectors round the middle of the points."""
    apart = points - points.mean(axis=0)
    return scale * numpy.stack([-apart[:, 1], apart[:, 0], 0.3 * apart[:, 2] + 0.1 * abs(apart).max()], axis=1)


def columns(prefix, values, *suffixes):
    """Columns of a table by their names."""
    return {prefix + suffix: values[:, i] for i, suffix in enumerate(suffixes)}


def stresses(points):
    """Tensors of both signs, xx yy zz xy yz xz."""
    x, y, z = (points - points.mean(axis=0)).T
    return numpy.stack([3.0 * x, 2.0 * y, x - y, 0.5 * z, 0.2 * x, 0.3 * y], axis=1) * 1e6 + [1e5, 0, 0, 0, 0, 0]


def diffusion(count):
    """Positive tensors, xx yy zz xy yz xz."""
    turns = [numpy.linalg.qr(RANDOM.normal(size=(3, 3)))[0] for _ in range(count)]
    return numpy.array([((turn * [1.7e-3, 4e-4, 2e-4]) @ turn.T)[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]] for turn in turns])


def traceless(count):
    """Tensors without a trace, xx xy xz yy yz, as codes for nematics write them."""
    return diffusion(count)[:, [0, 3, 5, 1, 4]] - 7.7e-4 * numpy.array([1, 0, 0, 1, 0])


def particles(count=300, side=0.1):
    """Places in a box."""
    return RANDOM.uniform(0.0, side, (count, 3))


def openfoam():
    """A block mesh of 6 x 6 x 6 cells with U and p, as text; of ParaView's reader the cells and points have them."""
    sides, step = (7, 7, 7), 0.01
    number = numpy.arange(343).reshape(sides)
    cell = numpy.arange(216).reshape(6, 6, 6)
    faces, owner, neighbor = [], [], []
    for axis in range(3):  # inner faces first, as OpenFOAM has them
        for i, j, k in numpy.ndindex(6, 6, 6):
            other = [i, j, k]
            other[axis] += 1
            if other[axis] < 6:
                faces.append(face(number, other, axis))
                owner.append(cell[i, j, k])
                neighbor.append(cell[tuple(other)])
    inner = len(faces)
    for axis in range(3):
        for end in (0, 6):
            for a, b in numpy.ndindex(6, 6):
                at = [a, b]
                at.insert(axis, end)
                inside = list(at)
                inside[axis] = 0 if end == 0 else 5
                corners = face(number, at, axis)
                faces.append(corners[::-1] if end == 0 else corners)
                owner.append(cell[tuple(inside)])
    order = sorted(range(inner), key=lambda i: (owner[i], neighbor[i])) + list(range(inner, len(faces)))
    head = "FoamFile\n{\n version 2.0;\n format ascii;\n class %s;\n object %s;\n}\n"
    mesh = "openfoam/constant/polyMesh/"
    write(mesh + "points", head % ("vectorField", "points") + "343\n(\n" + "".join("(%g %g %g)\n" % tuple(x) for x in grid(*sides) * step) + ")\n")
    write(mesh + "faces", head % ("faceList", "faces") + "%d\n(\n" % len(faces) + "".join("4(%d %d %d %d)\n" % tuple(faces[i]) for i in order) + ")\n")
    write(mesh + "owner", head % ("labelList", "owner") + "%d\n(\n" % len(faces) + "".join("%d\n" % owner[i] for i in order) + ")\n")
    write(mesh + "neighbour", head % ("labelList", "neighbour") + "%d\n(\n" % inner + "".join("%d\n" % neighbor[i] for i in order[:inner]) + ")\n")
    write(mesh + "boundary", head % ("polyBoundaryMesh", "boundary") + "1\n(\nwalls\n{\n type wall;\n nFaces %d;\n startFace %d;\n}\n)\n"
          % (len(faces) - inner, inner))
    speed = swirl(grid(6, 6, 6))
    boundary = "boundaryField\n{\n walls\n {\n  type zeroGradient;\n }\n}\n"
    write("openfoam/0.5/U", head % ("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\ninternalField nonuniform List<vector>\n216\n(\n"
          + "".join("(%g %g %g)\n" % tuple(u) for u in speed) + ")\n;\n" + boundary)
    write("openfoam/0.5/p", head % ("volScalarField", "p") + "dimensions [0 2 -2 0 0 0 0];\ninternalField nonuniform List<scalar>\n216\n(\n"
          + text(speed[:, 0]) + ")\n;\n" + boundary)
    write("openfoam/system/controlDict", head % ("dictionary", "controlDict") + "startTime 0;\nendTime 1;\ndeltaT 0.5;\nwriteInterval 1;\n")
    reader = pv.OpenFOAMReader(FileName=write("openfoam/case.foam", ""))
    reader.MeshRegions = ["internalMesh"]
    reader.UpdatePipeline(0.5)
    return reader


def face(number, at, axis):
    """Corners of the face of a cell at its lower end along an axis, seen from below."""
    one, two = [numpy.eye(3, dtype=int)[(axis + k) % 3] for k in (1, 2)]
    at = numpy.array(at)
    return [number[tuple(corner)] for corner in (at, at + one, at + one + two, at + two)]


def ensight():
    """EnSight Gold as of Ansys and Abaqus exporters: displacements and stresses on nodes."""
    sides = (6, 4, 3)
    places, corners = 10.0 * grid(*sides), hexahedra(sides) + 1

    def variable(values):
        return "variable\npart\n1\ncoordinates\n" + "".join("%12.5e\n" % value for value in values.T.reshape(-1))
    write("ensight.geo", "title\ntitle\nnode id off\nelement id off\npart\n1\nsolid\ncoordinates\n%10d\n" % len(places)
          + "".join("%12.5e\n" % value for value in places.T.reshape(-1))
          + "hexa8\n%10d\n" % len(corners) + "".join("".join("%10d" % corner for corner in row) + "\n" for row in corners))
    write("ensight.u", variable(1e-3 * swirl(places)))
    write("ensight.s", variable(stresses(places)))
    return pv.EnSightReader(CaseFileName=write("ensight.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: ensight.geo\nVARIABLE\n"
                                               "vector per node: Displacement ensight.u\ntensor symm per node: Stress ensight.s\n"))


def pdb():
    """Atoms of a PDB file."""
    return write("protein.pdb", "".join(
        "ATOM  %5d  %-3s ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n" % (i + 1, name, i // 4 + 1, *place, name[0])
        for i, (name, place) in enumerate(zip(["N", "CA", "C", "O"] * 10, 1.5 * grid(5, 4, 2)))) + "END\n")


class Row:
    """A file, what is set, and what must come out: arrays by properties, what colors, how many glyphs, words of the reasons."""

    def __init__(self, name, data, arrays=None, color=None, glyphs=None, why=(), **properties):
        self.name, self.data, self.properties = name, data, properties
        self.arrays, self.color, self.glyphs, self.why = arrays or {}, color, glyphs, why

    def check(self, view, checks):
        """Shows the file; returns the picture."""
        data = self.data()
        source = pv.OpenDataFile(data) if isinstance(data, str) else data
        shown = stepwise(pv.Show(source, view))  # as in the window
        shown.SetRepresentationType("Ray Traced Glyphs")
        shown.SamplesPerPixel = 2
        for name, value in self.properties.items():
            session.assign(shown, name, value)
        said = session.messages(lambda: (view.ResetCamera(True) if hasattr(view, "ResetCamera") else pv.ResetCamera(view), pv.Render(view)))
        checks.no_message(self.name, said)
        for name, wanted in self.arrays.items():
            checks.equal("%s: %s" % (self.name, name), shown.SMProxy.GetProperty(name).GetElement(0), wanted)
        counted = session.statistics(shown)
        own = [str(value).strip("'") for value in (shown.GlyphDirectionColoring, shown.GlyphTensorColoring)]
        coloring = next((value for value in own if value != "None"), "None")
        found = shown.ColorArrayName.GetArrayName() if coloring == "None" else coloring
        checks.equal(self.name + ": color", found, self.color)
        checks.equal(self.name + ": MapScalars", shown.MapScalars, int(self.color not in ("rgb_colors", "Colour")))
        checks.equal(self.name + ": colors by a logarithm", int(coloring == "None" and pv.GetColorTransferFunction(found).UseLogScale), int(found == "masses"))
        checks.true("%s: the section Coloring has %s" % (self.name, shown.ColorArrayName.GetArrayName()),
                    coloring == "None" or not shown.ColorArrayName.GetArrayName())
        if self.glyphs is not None:
            checks.equal(self.name + ": glyphs", counted["glyphs"], self.glyphs)
        reasons = "; ".join(counted["choices"])
        for word in self.why:
            checks.true("%s: no '%s' in: %s" % (self.name, word, reasons), word in reasons)
        pixels = session.capture(view, "corpus-picture")
        covered = float(comparison.covered(pixels).mean())
        checks.within(self.name + ": covered fraction", covered, LEAST, MOST)
        print("%-34s %4.1f %%  factor %-9.4g %5d glyphs. %s" % (self.name, 100 * covered, shown.ScaleFactor, counted["glyphs"], reasons), flush=True)
        pv.Delete(shown)
        pv.Delete(source)
        pv.UpdateScalarBars(view)
        pixels = pixels[..., :3].copy()
        pixels[~comparison.covered(pixels)] = (82, 87, 110)
        return pixels


def v_of(count):
    """Velocities."""
    return RANDOM.normal(size=(count, 3)) * RANDOM.uniform(0.2, 1.0, (count, 1))


DIRECTION, SIZE, TENSOR = "SelectOrientationVectors", "SelectScaleArray", "GlyphTensorArray"
PLACES = particles()
NUMBERS = numpy.arange(300)
SIDES = (6, 5, 4)
NODES = grid(*SIDES)

ROWS = (
    Row("LAMMPS, dump vtk", lambda: legacy("lammps.vtk", PLACES, id=NUMBERS, type=NUMBERS % 2 + 1, v=v_of(300), radius=numpy.full(300, 0.003)),
        {DIRECTION: "v"}, "v", 300, ("Direction by v: its name", "Color by v")),
    Row("LAMMPS, grains", lambda: legacy("granular.vtk", PLACES, id=NUMBERS, type=NUMBERS % 2 + 1, radius=RANDOM.uniform(0.002, 0.005, 300)),
        {SIZE: "radius"}, "radius", 300, ("Size by radius: its name", )),
    Row("LAMMPS, ellipsoids in CSV", lambda: table(
        "ellipsoids.csv", **columns("", PLACES, "x", "y", "z"), id=NUMBERS, **columns("c_q", unit(300, 4), "[1]", "[2]", "[3]", "[4]"),
        **columns("c_shape", RANDOM.uniform(0.004, 0.009, (300, 3)), "[1]", "[2]", "[3]"), **columns("v", v_of(300), "x", "y", "z")),
        {DIRECTION: "c_q[1], c_q[2], c_q[3], c_q[4]", SIZE: "c_shape[1], c_shape[2], c_shape[3]"}, "Axes", 300, ("Size by c_shape", "Color by direction"), GlyphShape="Superquadric"),
    Row("LIGGGHTS, superquadrics", lambda: legacy(
        "liggghts.vtk", PLACES, id=NUMBERS, v=v_of(300), **columns("shape", RANDOM.uniform(0.002, 0.005, (300, 3)), "x", "y", "z"),
        **columns("blockiness", RANDOM.uniform(2.0, 8.0, (300, 2)), "1", "2"), **columns("quat", unit(300, 4), "1", "2", "3", "4")),
        {DIRECTION: "quat1, quat2, quat3, quat4", SIZE: "shapex, shapey, shapez", "GlyphExponentArray": "blockiness1, blockiness2"},
        "v", 300, ("Size by shapex, shapey, shapez: its name", ), GlyphShape="Nested Superquadric"),
    Row("Yade", lambda: vtp("yade.vtp", PLACES, radii=RANDOM.uniform(0.002, 0.004, 300), id=NUMBERS, mask=numpy.ones(300, int), clumpId=NUMBERS,
                            linVelVec=v_of(300), angVelVec=10.0 * v_of(300)),
        {DIRECTION: "linVelVec"}, "linVelVec", 300, ("Direction by linVelVec: its name", )),
    Row("MFIX", lambda: vtp("mfix.vtp", PLACES, Diameter=RANDOM.uniform(0.004, 0.008, 300), Density=numpy.full(300, 2500.0), Particle_ID=NUMBERS,
                            Velocity=v_of(300)), {DIRECTION: "Velocity", SIZE: "Diameter"}, "Diameter", 300, GlyphType="Sphere", ScaleMode="Magnitude"),
    Row("OpenFOAM", openfoam, {DIRECTION: "U"}, "p", None, ("Direction by U", "Color by p: the array that ParaView chose")),
    Row("foamToVTK, cloud", lambda: vtp("cloud.vtp", PLACES, U=v_of(300), d=RANDOM.uniform(1e-3, 4e-3, 300), origId=NUMBERS, rho=numpy.full(300, 1000.0)),
        {DIRECTION: "U"}, "U", 300),
    Row("SU2", lambda: vtu("su2.vtu", SIDES, 0.1, {"Density": numpy.ones(120), "Momentum": 1.2 * swirl(NODES), "Pressure": NODES[:, 0],
                                                   "Velocity": swirl(NODES)}), {DIRECTION: "Velocity"}, "Velocity", 120),
    Row("CalculiX, ccx2paraview", lambda: vtu("calculix.vtu", SIDES, 1.0, {
        "U": 1e-3 * swirl(NODES), "S": (stresses(NODES), ("xx", "yy", "zz", "xy", "yz", "zx")), "ERROR": NODES[:, 0]}),
        {TENSOR: "S"}, "Sign", 120, ("Shape by S: the names of its components", ), GlyphShape="Signed Tensor Superquadric"),
    Row("Code_Aster, MED", lambda: vtu("aster.vtu", SIDES, 1.0, {
        "RESU____DEPL": (1e-3 * swirl(NODES), ("DX", "DY", "DZ")),
        "RESU____SIEF_NOEU": (stresses(NODES)[:, [0, 1, 2, 3, 5, 4]], ("SIXX", "SIYY", "SIZZ", "SIXY", "SIXZ", "SIYZ"))}),
        {TENSOR: "RESU____SIEF_NOEU", DIRECTION: "None"}, "Sign", 120, ("the names of its components", "90 % of the tensors have a negative eigenvalue, drawn as a positive one"), GlyphShape="Tensor Ellipsoid"),
    Row("Gmsh, by meshio", lambda: vtu("gmsh.vtu", SIDES, 1.0, {"velocity": swirl(NODES)}, {"gmsh:physical": numpy.ones(60, int)}),
        {DIRECTION: "velocity"}, "velocity", 120),
    Row("deal.II", lambda: vtu("dealii.vtu", SIDES, 1.0, {"displacement": 1e-4 * swirl(NODES), "pressure": NODES[:, 1]},
                               {"subdomain": numpy.zeros(60)}), {DIRECTION: "displacement"}, "displacement", 120),
    Row("FEniCS", lambda: vtu("fenics.vtu", SIDES, 1.0, {"Function_17": swirl(NODES)}), {DIRECTION: "Function_17"}, "Function_17", 120,
        ("its number of components", )),
    Row("finite volumes, cells", lambda: vtu("cells.vtu", SIDES, 1.0, {}, {"velocity": swirl(NODES)[:60], "pressure": NODES[:60, 0]}),
        {DIRECTION: "velocity"}, "velocity", 60),
    Row("Ansys, EnSight", ensight, {DIRECTION: "Displacement"}, "Displacement", 72),
    Row("openPMD, CSV", lambda: table("openpmd.csv", **columns("position_", PLACES, "x", "y", "z"), **columns("momentum_", v_of(300), "x", "y", "z"),
                                      weighting=numpy.full(300, 1e5), id=NUMBERS),
        {DIRECTION: "momentum_x, momentum_y, momentum_z"}, "Axes", 300, ("Direction by momentum_x", "Color by direction")),
    Row("wind, CSV", lambda: table("wind.csv", x=NODES[:, 0], y=NODES[:, 1], z=0.0 * NODES[:, 2], u10=swirl(NODES)[:, 0], v10=swirl(NODES)[:, 1],
                                   t2m=280.0 + NODES[:, 0]), {DIRECTION: "u10, v10"}, "Axes", 120),
    Row("a jet in noise", lambda: vti("jet.vti", (12, 10, 1), id=numpy.arange(120), velocity=unit(120, 3) * numpy.where(numpy.arange(120) % 30 == 7, 100.0, 1.0)[:, None]),
        {DIRECTION: "velocity"}, "velocity", 120, ("About 3 % of the glyphs would be too large", ), ScaleMode="Magnitude"),
    Row("DualSPHysics", lambda: legacy("sph.vtk", 0.01 * grid(8, 6, 5), Idp=numpy.arange(240), Vel=v_of(240), Rhop=numpy.full(240, 1000.0)),
        {DIRECTION: "Vel"}, "Vel", 240),
    Row("MRtrix, ODF", lambda: vti("odf.vti", (5, 4, 1), odf=RANDOM.normal(size=(20, 15)) * 0.05 + numpy.eye(15)[0] * 0.28),
        {"GlyphHarmonicsArray": "odf"}, "Axes", 20, ("Shape by odf", ), GlyphShape="Spherical Harmonics"),
    Row("diffusion tensors, VTK", lambda: vti("dti.vti", (6, 5, 2), DTI=diffusion(60)[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]], b0=numpy.ones(60)),
        {TENSOR: "DTI"}, "Fractional Anisotropy", 60, ("Shape by DTI: its name", ), GlyphShape="Tensor Superquadric"),
    Row("diffusion tensors with noise", lambda: vti("noisy.vti", (6, 5, 2), DTI=diffusion(60)[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]]
                                                    - numpy.where(numpy.arange(60) % 20 == 0, 5e-4, 0.0)[:, None] * numpy.eye(3).reshape(-1)),
        {TENSOR: "DTI"}, "Fractional Anisotropy", 60, ("5 % of the tensors have a negative eigenvalue, drawn as a positive one; their fractional "
                                                       "anisotropy may pass 1", ), GlyphShape="Tensor Superquadric"),
    Row("stresses alone", lambda: vtu("stress.vtu", SIDES, 1.0, {"stress": stresses(NODES), "mises": NODES[:, 0]}),
        {TENSOR: "stress", "GlyphShape": 8}, "Sign", 120, ("Shape by stress: its name", "Components of stress by GlyphTensorLayout: xx yy zz xy yz xz")),
    Row("diffusion tensors alone", lambda: vti("alone.vti", (6, 5, 2), D=diffusion(60)[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]], b0=numpy.ones(60)),
        {TENSOR: "D", "GlyphShape": 6}, "Fractional Anisotropy", 60, ("Shape by D: its number of components", )),
    Row("ODF alone", lambda: vti("fod.vti", (5, 4, 1), fod=RANDOM.normal(size=(20, 45)) * 0.02 + numpy.eye(45)[0] * 0.28),
        {"GlyphHarmonicsArray": "fod", "GlyphShape": 12}, "Axes", 20, ("Shape by fod", )),
    Row("grains with stresses", lambda: legacy("stressed.vtk", PLACES, radius=RANDOM.uniform(0.002, 0.005, 300), stress=RANDOM.normal(size=(300, 6))),
        {SIZE: "radius", "GlyphShape": 0}, "radius", 300),
    Row("a histogram", lambda: table("bins.csv", x=NODES[:, 0], y=NODES[:, 1], z=NODES[:, 2], **columns("bin", RANDOM.uniform(size=(120, 9)), *"123456789")),
        {"GlyphShape": 0}, "", 120),
    Row("wind by angles", lambda: table("stations.csv", x=NODES[:, 0], y=NODES[:, 1], z=0.0 * NODES[:, 2], wind_direction=RANDOM.uniform(0.0, 360.0, 120),
                                        wind_speed=RANDOM.uniform(1.0, 20.0, 120)),
        {DIRECTION: "None"}, "wind_speed", 120, ("Not used as directions: wind_direction (angles", )),
    Row("OOMMF, directions of magnetization", lambda: vti("spins.vti", (8, 8, 1), m=unit(64, 3)), {DIRECTION: "m"}, "Axes", 64, ("Direction by m", "Color by direction")),
    Row("PDB", pdb, {SIZE: "radius"}, "rgb_colors", 40, ("Size by radius", )),
    Row("N-body, masses", lambda: legacy("nbody.vtk", PLACES, masses=10.0**RANDOM.uniform(4.0, 12.0, 300)), {SIZE: "None"}, "masses", 300),
    Row("laser scan", lambda: vtp("scan.vtp", PLACES, Intensity=RANDOM.integers(0, 65535, 300), Colour=RANDOM.integers(0, 255, (300, 3)).astype(numpy.uint8)),
        {}, "Colour", 300, ("Color by Colour: what the glyphs show", )),
    Row("XYZ, Molecule To Lines", molecule, {SIZE: "Van der Waals radii of Atomic Numbers"}, "Atomic Numbers", 6,
        ("Size by Van der Waals radii of Atomic Numbers", "Color by Atomic Numbers: what the glyphs show")),
    Row("ODF of 15 alone", lambda: vti("fod15.vti", (5, 4, 1), wmfod=RANDOM.normal(size=(20, 15)) * 0.02 + numpy.eye(15)[0] * 0.28),
        {"GlyphHarmonicsArray": "wmfod", "GlyphShape": 12}, "Axes", 20, ("Shape by wmfod: its name", )),
    Row("fifteen numbers", lambda: vti("fifteen.vti", (5, 4, 1), a=RANDOM.normal(size=(20, 15))), {"GlyphShape": 0}, "a", 20,
        ("GlyphShape can show a as Fourth-Order Tensor or Spherical Harmonics", )),
    Row("nematic", lambda: vti("nematic.vti", (6, 5, 2), Q=traceless(60)), {TENSOR: "Q", "GlyphShape": 8}, "Sign", 60, ("Shape by Q: its name", )),
    Row("five numbers", lambda: vti("five.vti", (6, 5, 2), a=traceless(60)), {"GlyphShape": 0}, "", 60, ("GlyphShape can show a as tensors", )),
    Row("a swirl in cylindrical coordinates", lambda: table("swirl.csv", x=NODES[:, 0], y=NODES[:, 1], z=NODES[:, 2],
                                                               **columns("V_", RANDOM.normal(size=(120, 3)), "r", "theta", "z")),
        {DIRECTION: "None"}, "V_r", 120, ("Not used as directions: V_theta (angles", )),
)


def load(view, checks):
    """Colors of a load that is zero at first, when nothing shows it, and of one that then grows: the first range that there is counts."""
    source = pv.Calculator(Input=scale_guess.series((0.0, 6, 0.0), (1.0, 6, 2.0), (2.0, 6, 4.0)), Function="s*coords", ResultArrayName="load")
    view.ViewTime = 0.0
    shown = stepwise(pv.Show(source, view))
    shown.SetRepresentationType("Ray Traced Glyphs")
    for time, largest in ((0.0, None), (1.0, 2.0), (2.0, 2.0), (0.0, 2.0)):
        view.ViewTime = time
        session.messages(lambda: pv.Render(view))
        checks.equal("color of a load at time %g" % time, shown.ColorArrayName.GetArrayName(), "load" if largest else "")
        if largest:
            checks.within("largest color of a load at time %g" % time, pv.GetColorTransferFunction("load").RGBPoints[-4], 0.99 * largest * 2.5 * 3.0**0.5, 1.01 * largest * 2.5 * 3.0**0.5)
    view.ViewTime = 0.0
    pv.Delete(shown)


def decades(view, checks):
    """Displays of one array share its table, which a logarithm spreads once."""
    path, tables = legacy("masses.vtk", PLACES, masses=10.0**numpy.linspace(4.0, 12.0, 300)), []
    for _ in range(2):
        stepwise(pv.Show(pv.OpenDataFile(path), view)).SetRepresentationType("Ray Traced Glyphs")
        pv.Render(view)
        tables.append(list(pv.GetColorTransferFunction("masses").RGBPoints))
    checks.true("colors of a second display: %s, not %s" % (tables[1][::4], tables[0][::4]), numpy.allclose(tables[1], tables[0]))


def main(words):
    """All rows, or those whose names have one of the words."""
    session.load()
    checks = Checks()
    view = session.view(WIDTH, HEIGHT)
    rows = [row for row in ROWS if not words or any(word in row.name for word in words)]
    pictures = []
    for row in rows:
        smtrace.start_trace()
        pictures.append(row.check(view, checks))
        trace = smtrace.stop_trace()
        own = {"Sign": "GlyphTensorColoring", "Fractional Anisotropy": "GlyphTensorColoring", "Axes": "GlyphDirectionColoring"}.get(row.color)
        wanted = "%s = '%s'" % (own, row.color) if own else "'%s'))" % row.color
        checks.true("%s: the trace has no %s" % (row.name, wanted), not row.color or row.color in ("a", "p", "rgb_colors", "Atomic Numbers") or wanted in trace)
        checks.true("%s: the trace has no GlyphShape" % row.name, not row.arrays.get("GlyphShape") or "GlyphShape = '" in trace)
    sheet = numpy.full((-(-len(pictures) // COLUMNS) * HEIGHT, COLUMNS * WIDTH, 3), 128, numpy.uint8)
    for i, pixels in enumerate(pictures):
        row, column = divmod(i, COLUMNS)
        sheet[row * HEIGHT:(row + 1) * HEIGHT, column * WIDTH:(column + 1) * WIDTH] = pixels
    comparison.write_image(session.output("corpus.png"), sheet)
    if not words or "load" in words:
        load(view, checks)
    if not words or "masses" in words:
        decades(view, checks)
    checks.report()


if __name__ == "__main__":
    main(sys.argv[1:])
