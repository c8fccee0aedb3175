"""Exported glyphs are those of the view: what is read back from .usda, .glb and .gltf has the data's places, sizes, turns and
colors, and as ordinary triangles it gives the same picture; what cannot be exported gives one message.

Usage: pvpython export.py [CASE...]
"""
import json
import os
import re
import struct
import sys
import urllib.parse

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import session
import tubes
from checks import Checks

RANDOM = numpy.random.default_rng(11)
#: 27 glyphs that do not touch, at places that are not near the origin
SIDES = numpy.stack(numpy.meshgrid(*3 * [numpy.arange(3.0)], indexing="ij"), axis=-1).reshape(-1, 3)
CENTERS = 1.2 * SIDES + RANDOM.uniform(-0.05, 0.05, (27, 3)) + (50.0, -20.0, 7.0)
LENGTHS = RANDOM.uniform(0.3, 0.8, (27, 3))
QUATERNIONS = RANDOM.normal(size=(27, 4))
QUATERNIONS /= numpy.linalg.norm(QUATERNIONS, axis=1)[:, None]
DIRECTIONS = RANDOM.uniform(-1.0, 1.0, (27, 3))
RGB = RANDOM.integers(60, 256, (27, 3)).astype(numpy.uint8)
EXPONENTS = RANDOM.uniform(1.0, 6.0, (27, 3))
TENSORS = numpy.array([(turn * row) @ turn.T for turn, row in zip(
    [numpy.linalg.qr(RANDOM.normal(size=(3, 3)))[0] for _ in range(27)], RANDOM.uniform(-1.0, 1.0, (27, 3)))]).reshape(-1, 9)
OPACITIES = RANDOM.uniform(0.2, 1.0, 27)
TURNED = {"SelectOrientationVectors": "turn", "OrientationMode": "Quaternion"}
LONG = {"SelectScaleArray": "lengths", "ScaleMode": "Vector Components", "ScaleFactor": 1.0}
COLORED = {"Orient": 1, "SelectOrientationVectors": "None", "ColorArrayName": ["POINTS", "rgb"], "MapScalars": 0}
ALONG = {"SelectOrientationVectors": "direction", "ScaleMode": "Magnitude", "SelectScaleArray": "direction", "ScaleFactor": 0.8}
#: case -> properties of the display
CASES = {
    "spheres": {"ScaleFactor": 0.7},
    "ellipsoids": {**LONG, **TURNED},
    "boxes": {"GlyphType": "Box", **LONG, **TURNED},
    "cylinders": {"GlyphType": "Cylinder", **LONG, **TURNED},
    "cones": {"GlyphType": "Cone", **LONG, **TURNED},
    "capsules": {"GlyphShape": "Capsule", **LONG, **TURNED, "ScaleFactor": 0.6},
    "arrows": {"GlyphType": "Arrow", **ALONG, "ArrowHeads": "Fixed"},
    "sharp arrows": {"GlyphType": "Arrow", **ALONG, "ArrowHeads": "Scaled"},
    "superquadrics": {"GlyphShape": "Superquadric", **LONG, **TURNED, "GlyphExponentArray": "None", "GlyphExponents": [4.0, 1.0, 12.0]},
    "forms": {"GlyphShape": "Superquadric", **LONG, **TURNED, "GlyphExponentArray": "exponents"},
    "tensors": {"GlyphShape": "Signed Tensor Superquadric", "GlyphTensorArray": "tensor", "ScaleFactor": 0.9},
    "split vectors": {"GlyphShape": "Split Vector", "SelectOrientationVectors": "direction", "ScaleFactor": 0.8},
    "meshes": {"GlyphType": lambda: session.triangles(pv.Cone()), **LONG, **TURNED},
}
#: number of copies a glyph where it is not one
COPIES = {"capsules": 3, "arrows": 2, "sharp arrows": 2, "split vectors": 2}
#: number of arrows that are shorter than their fixed heads, 0.35 of what 95 % of them do not exceed, and so have no shaft, and of vectors of the
#: power of ten 0
SPEEDS = numpy.linalg.norm(DIRECTIONS, axis=1)
WITHOUT_SHAFT = {"arrows": int((SPEEDS < 0.35 * numpy.quantile(SPEEDS, 0.95)).sum()), "split vectors": int((SPEEDS >= 1.0).sum())}
#: fraction of the pixels that may differ from the exact shapes, where facets are seen, and the mean of all differences
PIXELS, MEAN = 0.002, 0.3
#: the same where each glyph has a form of its own, with fewer facets
PIXELS_OF_FORMS, MEAN_OF_FORMS = 0.006, 0.7
FORMS = ("forms", "tensors")


class Part:
    """A mesh with its copies."""

    def __init__(self, name, points, normals, triangles, positions, quaternions, scales, colors):
        self.name = name
        self.points, self.triangles = numpy.asarray(points), numpy.asarray(triangles)
        self.normals = numpy.zeros((0, 3)) if normals is None else numpy.asarray(normals)  # none: facets
        self.positions, self.scales, self.colors = numpy.asarray(positions), numpy.asarray(scales), numpy.asarray(colors)
        self.quaternions = numpy.asarray(quaternions)  # w, x, y, z


def from_gltf(path):
    """Parts of the displays of a .gltf or .glb file."""
    data = open(path, "rb").read()
    if path.endswith(".glb"):
        magic, version, length, size, kind = struct.unpack("<4sIII4s", data[:20])
        assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON"), data[:20]
        text, binary = data[20:20 + size], data[28 + size:]
        assert struct.unpack("<I4s", data[20 + size:28 + size]) == (len(binary), b"BIN\0")
    else:
        text = data
        binary = open(os.path.join(os.path.dirname(path), urllib.parse.unquote(json.loads(text)["buffers"][0]["uri"])), "rb").read()
    root = json.loads(text)
    assert root["extensionsUsed"] == root["extensionsRequired"] == ["EXT_mesh_gpu_instancing"]

    def array(number):
        accessor = root["accessors"][number]
        view = root["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        kind = {5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        values = numpy.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)
        assert view["byteLength"] == values.nbytes and view["byteOffset"] % 4 == 0
        if "min" in accessor:
            assert numpy.allclose(accessor["min"], values.min(axis=0)) and numpy.allclose(accessor["max"], values.max(axis=0))
        return values

    displays = []
    for number in root["scenes"][root["scene"]]["nodes"]:
        display, parts = root["nodes"][number], []
        for child in display["children"]:
            node = root["nodes"][child]
            copies = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
            primitive = root["meshes"][node["mesh"]]["primitives"][0]
            positions = array(copies["TRANSLATION"]) + numpy.array(display["translation"])
            normals = array(primitive["attributes"]["NORMAL"]) if "NORMAL" in primitive["attributes"] else None
            factor = root["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorFactor"]
            colors = array(copies["_COLOR_0"]) if "_COLOR_0" in copies else numpy.ones((len(positions), 4))
            parts.append(Part(node["name"], array(primitive["attributes"]["POSITION"]), normals,
                              array(primitive["indices"]).reshape(-1, 3), positions, numpy.roll(array(copies["ROTATION"]), 1, axis=1),
                              array(copies["SCALE"]), colors * factor))
        displays.append(parts)
    return displays


def from_usda(path):
    """(Parts of the displays, vectors of each display's copies by their names) of a .usda file."""
    text = open(path).read()
    assert text.startswith("#usda 1.0\n")

    def numbers(of, name, width, kind=float):
        found = re.search(r"\b%s = \[(.*?)\]" % re.escape(name), of)
        return numpy.array(re.findall(r"-?[\d.]+(?:e[-+]?\d+)?", found.group(1)), kind).reshape(-1, width) if found else None

    displays, vectors = [], []
    for display in re.split(r"\n    def Xform ", text)[1:]:
        instancer, *meshes = display.split("def Mesh ")
        origin = [float(number) for number in re.search(r"xformOp:translate = \((.*?)\)", display).group(1).split(",")]
        which = numbers(instancer, "protoIndices", 1, int).ravel()
        paths = re.findall(r"<(.*?)>", re.search(r"rel prototypes = \[(.*?)\]", instancer).group(1))
        colors = numbers(instancer, "primvars:displayColor", 3)
        opacities = numbers(instancer, "primvars:displayOpacity", 1)
        rgba = numpy.ones((len(which), 4))
        rgba[:, :3] = colors
        rgba[:, 3:] = 1.0 if opacities is None else opacities
        parts = []
        for number, mesh in enumerate(meshes):
            name = re.match(r'"(\w+)"', mesh).group(1)
            assert paths[number].endswith("/Instances/Prototypes/" + name), paths
            assert set(numbers(mesh, "faceVertexCounts", 1, int).ravel()) == {3}
            mine = which == number
            parts.append(Part(name, numbers(mesh, "points", 3), numbers(mesh, "normals", 3),
                              numbers(mesh, "faceVertexIndices", 3, int), numbers(instancer, "positions", 3)[mine] + origin,
                              numbers(instancer, "orientations", 4)[mine], numbers(instancer, "scales", 3)[mine], rgba[mine]))
        displays.append(parts)
        vectors.append({name: numbers(instancer, name, 3) for name in ("velocities", "accelerations", "angularVelocities")})
    return displays, vectors


def shown_color(linear):
    """The color of the screen, in [0, 255], of an amount of light (IEC 61966-2-1)."""
    linear = numpy.asarray(linear)
    return 255.0 * numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 1e-9)**(1.0 / 2.4) - 0.055)


def triangles(parts):
    """All copies as one vtkPolyData with colors."""
    points, normals, polygons, colors, count = [], [], [], [], 0
    for part in parts:
        for position, quaternion, scale, color in zip(part.positions, part.quaternions, part.scales, part.colors):
            w, x, y, z = quaternion
            matrix = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                                  [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                                  [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
            points.append(position + (part.points * scale) @ matrix.T)
            normals.append(part.normals / scale @ matrix.T)
            polygons.append(part.triangles + count)
            colors.append(numpy.repeat(shown_color(color[None, :3]), len(part.points), axis=0))
            count += len(part.points)
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(numpy.concatenate(points), deep=True))
    flat = numpy.concatenate(polygons)
    cells.SetCells(len(flat), numpy_to_vtkIdTypeArray(numpy.insert(flat, 0, 3, axis=1).ravel().astype(numpy.int64), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    rgb = numpy_to_vtk(numpy.round(numpy.concatenate(colors)).astype(numpy.uint8), deep=True)
    rgb.SetName("rgb")
    data.GetPointData().AddArray(rgb)
    across = numpy.concatenate(normals)
    if len(across):
        unit = numpy_to_vtk(across / numpy.linalg.norm(across, axis=1)[:, None], deep=True)
        unit.SetName("Normals")
        data.GetPointData().SetNormals(unit)
    return data


def point_data():
    """The 27 points with their arrays."""
    return session.poly_data(CENTERS, lengths=LENGTHS, turn=QUATERNIONS, direction=DIRECTIONS, rgb=RGB, tensor=TENSORS,
                             exponents=EXPONENTS, opacity=OPACITIES, velocity=2.0 * DIRECTIONS, spin=DIRECTIONS[:, ::-1])


def source():
    """What gives them out."""
    return session.source(point_data())


def shown_in(view, of_source, properties):
    """A display with direct colors, flat light."""
    return session.glyphs(of_source, view, samples=1, **{"shape": "Sphere", **COLORED, **properties})


def export(path, view):
    """What is said."""
    import raytracedglyphs  # comes with the plugin
    return session.messages(lambda: raytracedglyphs.ExportGlyphs(path, view))


class Shown:
    """One display for all kinds of glyphs, and one for the triangles that are read back."""

    def __init__(self, view):
        self.stage, self.surface = session.Stage(view), None
        session.look(view, CENTERS.mean(axis=0) + (5.0, 4.0, 9.0), CENTERS.mean(axis=0))

    def see_glyphs(self, properties):
        """Of these properties."""
        self.stage.show(point_data(), "Sphere", **{**COLORED, **properties})
        if self.surface:
            self.surface.Visibility = 0

    def see_triangles(self, data):
        """Instead of the glyphs."""
        if self.surface:
            session.replace_data(self.surface.Input, data)
        else:
            self.surface = session.show(session.source(data), self.stage.view, "Surface", ColorArrayName=["POINTS", "rgb"], MapScalars=0,
                                        Interpolation="Gouraud")
        self.surface.Visibility = 1
        self.stage.hide()

    def delete(self):
        """All that was made."""
        made = self.surface.Input
        pv.Delete(self.surface)
        pv.Delete(made)
        self.stage.close()


def check_case(name, properties, view, shown, checks):
    """Files, numbers and picture of one kind of glyphs."""
    shown.see_glyphs(properties)
    expected = session.capture(view, "export-%s" % name)
    paths = {suffix: session.output("export %s #%%41.%s" % (name, suffix)) for suffix in ("usda", "glb", "gltf")}
    for suffix, path in paths.items():
        checks.no_message("%s, %s" % (name, suffix), export(path, view))
    usda, gltf, glb = from_usda(paths["usda"])[0], from_gltf(paths["gltf"]), from_gltf(paths["glb"])
    checks.equal(name + ": displays", [len(found) for found in (usda, gltf, glb)], [1, 1, 1])
    count = sum(len(part.positions) for part in usda[0])
    checks.equal(name + ": copies", count, 27 * COPIES.get(name, 1) - WITHOUT_SHAFT.get(name, 0))
    for other in (gltf[0], glb[0]):
        checks.equal(name + ": parts", [part.name for part in other], [part.name for part in usda[0]])
        for one, two in zip(usda[0], other):
            for what in ("points", "normals", "triangles", "positions", "scales", "colors", "quaternions"):
                a, b = getattr(one, what), getattr(two, what)
                checks.true("%s: %s of %s differ between the formats" % (name, what, one.name),
                            a.shape == b.shape and numpy.allclose(a, b, rtol=1e-6, atol=1e-6))
    for part in usda[0]:
        checks.true("%s: a triangle of %s is flat" % (name, part.name),
                    (numpy.linalg.norm(numpy.cross(*(part.points[part.triangles[:, k]] - part.points[part.triangles[:, 0]] for k in (1, 2))),
                                       axis=1) > 0.0).all())
    if name in ("spheres", "ellipsoids", "boxes", "cylinders", "cones", "superquadrics"):
        part = usda[0][0]
        checks.true(name + ": places", numpy.allclose(part.positions, CENTERS, atol=1e-5))
        checks.true(name + ": sizes", numpy.allclose(part.scales, 0.7 if name == "spheres" else LENGTHS, rtol=1e-6))
        signs = numpy.sign((part.quaternions * QUATERNIONS).sum(axis=1))[:, None]
        checks.true(name + ": turns", name == "spheres" or numpy.allclose(signs * part.quaternions, QUATERNIONS, atol=1e-6))
        checks.true(name + ": colors", numpy.allclose(shown_color(part.colors[:, :3]), RGB, atol=0.01))
    shown.see_triangles(triangles(usda[0]))
    checks.picture("export, " + name, session.capture(view, "export-%s-read" % name.replace(" ", "-")), expected,
                   pixels=PIXELS_OF_FORMS if name in FORMS else PIXELS, mean=MEAN_OF_FORMS if name in FORMS else MEAN)


def check_motion(view, checks):
    """Velocities, where glyphs move; of an arrow's head those of its own place."""
    points = source()
    shown = shown_in(view, points, {**CASES["arrows"], "MotionBlur": 1, "VelocityArray": "velocity", "AngularVelocityArray": "spin"})
    path = session.output("export-motion.usda")
    checks.no_message("motion", export(path, view))
    parts, vectors = from_usda(path)
    heads = next(part for part in parts[0] if part.name == "Head")
    velocities = vectors[0]["velocities"]
    found = velocities[-27:]
    wanted = 2.0 * DIRECTIONS + numpy.cross(DIRECTIONS[:, ::-1], heads.positions - CENTERS)
    checks.true("velocities of heads", numpy.allclose(found, wanted, atol=1e-4))
    shafts = next(part for part in parts[0] if part.name == "Shaft")
    at = numpy.linalg.norm(shafts.positions[:, None] - CENTERS, axis=2).argmin(axis=1)
    checks.true("velocities of shafts", numpy.allclose(velocities[:-27], 2.0 * DIRECTIONS[at], atol=1e-5))
    checks.true("angular velocities", numpy.allclose(numpy.radians(vectors[0]["angularVelocities"][-27:]), DIRECTIONS[:, ::-1], atol=1e-5))
    shown.MotionBlur = 0
    export(path, view)
    checks.equal("at rest", [values for values in from_usda(path)[1][0].values() if values is not None], [])
    pv.Delete(shown)
    pv.Delete(points)


def check_tubes(view, checks):
    """Balls and cones between them, with flat ends discs; colors of points as their means."""
    along = numpy.linspace(0.0, 1.0, 41)
    curves = [numpy.stack([3.0 * along, numpy.sin(7.0 * along) + 2.0 * k, numpy.cos(5.0 * along)], axis=1) for k in range(2)]
    widths = numpy.concatenate([0.15 + 0.1 * numpy.sin(9.0 * along), numpy.full(41, 0.2)])
    squares = numpy.outer(widths ** 2, numpy.diag([1.0, 0.5, 0.3]).ravel())
    lines = tubes.line_data(curves, {"rgb": RGB[:2]}, width=widths, squares=squares, height=numpy.repeat([1.0, 3.0], 41))
    path = session.output("export-tubes.usda")
    for name, radii, ends, color in (("round tubes", "width", "Rounded", ["CELLS", "rgb"]), ("flat tubes", "width", "Flat", ["CELLS", "rgb"]),
                                     ("values along tubes", "width", "Rounded", ["POINTS", "height"]), ("covariances", "squares", "Rounded", ["POINTS", "height"])):
        shown = session.show(session.source(lines), view, "Ray Traced Tubes", TubeRadius=1.0, TubeRadiusArray=radii, TubeEnds=ends)
        pv.ColorBy(shown, color)
        shown.MapScalars = int(color[1] == "height")
        session.look(view, (1.5, 1.0, 9.0), (1.5, 1.0, 0.0))
        expected = session.capture(view, "export-" + name.replace(" ", "-"))
        checks.no_message(name, export(path, view))
        pv.Delete(shown)
        surface = session.show(session.source(triangles(from_usda(path)[0][0])), view, "Surface", ColorArrayName=["POINTS", "rgb"],
                               MapScalars=0, Interpolation="Gouraud")
        # Cones of a percent of their ratio, of 48 facets; sweeps of 34
        checks.picture("export, " + name, session.capture(view, "export-read-" + name.replace(" ", "-")), expected, pixels=0.005, mean=0.7)
        pv.Delete(surface)


def check_signs(view, checks):
    """Tensors of one sign, and arrows along principal axes, have one color each, which exports have; nothing is said."""
    tensors = numpy.array([numpy.diag(values) for values in ((1.0, 2.0, 3.0), (-1.0, -2.0, -3.0), (2.0, -1.0, 1.5))]).reshape(-1, 9)
    places = numpy.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0]])
    path = session.output("export-signs.usda")
    for shape, used, wanted in (("Tensor Ellipsoid", 2, (1, 1)), ("Principal Axes", 3, (10, 8))):
        points = session.source(session.poly_data(places[:used], t=tensors[:used]))
        shown = session.glyphs(points, view, shape, GlyphTensorArray="t", ScaleFactor=0.3, GlyphTensorColoring="Sign",
                               GlyphTensorLookupTable=session.signs((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
        checks.no_message("signs of " + shape, export(path, view))
        # Each arrow has a head; shafts are other copies.
        heads = max((part.colors for part in from_usda(path)[0][0]), key=len)[:, :3]
        checks.equal("positive and negative of " + shape, tuple(int((heads == color).all(axis=1).sum()) for color in ((1, 0, 0), (0, 0, 1))), wanted)
        pv.Delete(shown)
        pv.Delete(points)


def check_messages(view, checks):
    """What is left out, and what is wrong."""
    points = source()
    shown = shown_in(view, points, CASES["spheres"])
    shown.Opacity = 0.5
    path = session.output("export-two.usda")
    more = source()
    other = shown_in(view, more, CASES["boxes"])
    checks.no_message("two displays", export(path, view))
    displays = from_usda(path)[0]
    checks.equal("two displays", sorted(parts[0].name for parts in displays), ["Box", "Sphere"])
    checks.equal("opacities of displays", sorted(set(float(parts[0].colors[0, 3]) for parts in displays)), [0.5, 1.0])
    other.GlyphOpacityArray = "opacity"
    export(path, view)
    boxes = next(parts[0] for parts in from_usda(path)[0] if parts[0].name == "Box")
    checks.true("opacities of glyphs", numpy.allclose(boxes.colors[:, 3], OPACITIES, atol=1e-6))
    pv.Delete(other)
    pv.Delete(more)
    checks.one_message("no such folder", export(session.output("no such folder/a.glb"), view), "could not be written")
    shown.GlyphShape, shown.GlyphTensorArray, shown.GlyphTensorColoring = "Tensor Ellipsoid", "tensor", "Sign"
    checks.one_message("signs", export(path, view), "GlyphTensorColoring", "Sign", "some of the glyphs")
    shown.ColorArrayName, shown.GlyphShape = ["POINTS", "rgb"], "Normal Stress"
    checks.one_message("no triangles", export(path, view), "Spherical Harmonics", "left out")
    shown.GlyphShape = "Tensor Ellipsoid"
    ball = pv.Sphere(Radius=9.0)
    surface = pv.Show(ball, view)
    surface.SetRepresentationType("Ray Traced Surface")
    shown.GlyphTensorColoring = "None"
    checks.one_message("surface", export(path, view), "surfaces are left out")
    pv.Delete(shown)
    said = export(session.output("export-none.usda"), view)
    checks.one_message("nothing to export", said, "no file is written")
    pv.Delete(surface)
    many = session.source(session.poly_data(RANDOM.uniform(size=(1001, 3)), e=RANDOM.uniform(1.0, 3.0, (1001, 3))))
    shown = session.glyphs(many, view, "Superquadric", GlyphExponentArray="e", Orient=0)
    said = export(session.output("export-none.usda"), view)
    checks.one_message("too many forms", said, "more than 1000", "GlyphMode", "no file is written")
    for call, words in ((lambda: export("a.obj", view), "usda"), (lambda: (pv.Hide(many, view), export("a.glb", view)), "Representation")):
        try:
            call()
            checks.true("nothing is raised: " + words, False)
        except (ValueError, RuntimeError) as error:
            checks.true("%s: %s" % (words, error), words in str(error))
    # ParaView's own call, and what its dialog offers
    offered = pv.servermanager.vtkSMViewExportHelper().GetSupportedFileTypes(view.SMProxy)
    checks.true("offered: " + offered, "glyphs, USD or glTF (*.usda *.glb)" in offered)
    shown.Visibility, shown.GlyphExponentArray = 1, "None"
    checks.no_message("ExportView", session.messages(lambda: pv.ExportView(session.output("export-view.usda"), view)))
    checks.equal("ExportView", len(from_usda(session.output("export-view.usda"))[0][0][0].positions), 1001)


def main():
    """All, or those that are named."""
    session.load()
    checks = Checks()
    view = session.view(300, 300)
    wanted = sys.argv[1:] or [*CASES, "motion", "tubes", "signs", "messages"]
    cases = [name for name in wanted if name in CASES]
    if cases:
        shown = Shown(view)
        for name in cases:
            check_case(name, CASES[name], view, shown, checks)
        shown.delete()
    for name, check in (("motion", check_motion), ("tubes", check_tubes), ("signs", check_signs), ("messages", check_messages)):
        if name in wanted:
            check(view, checks)
    checks.report()


if __name__ == "__main__":
    main()
