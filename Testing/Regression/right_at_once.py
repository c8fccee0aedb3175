"""Choosing 'Ray Traced Glyphs' gives a useful picture of any data with nothing set but the shape and the switch of scaling: the
glyphs cover a sensible fraction of the view, none is larger than a fifth of it, and nothing is said.

The pictures lie together in right-at-once.png, in the order of what is printed.

Usage: RTGLYPHS_DATA=FOLDER [RTGLYPHS_SHARED_DATA=FOLDER] pvpython right_at_once.py
RTGLYPHS_SHARED_DATA is a folder with tensors.vtk of VTK and example data of ParaView; without it these are left out.
"""
import math
import os
import re

import numpy
import paraview.simple as pv

import comparison
import scale_guess
import session
from checks import Checks

WIDTH, HEIGHT = 240, 180
COLUMNS = 8
#: fractions of the view that all glyphs together must cover, and of its shorter side that the largest may have
LEAST, MOST, LARGEST = 0.01, 0.6, 0.2
#: data that cover little, because they are in few places or along a line, or more -> fraction that they must cover
SHARES = {"graded mesh": 0.1, "clusters": 0.008, "stretched grid": 0.004, "tensors": 0.003}
#: what has one glyph, which fills the view that is reset to it
SINGLE = ("one point", "coincident points")
RANDOM = numpy.random.default_rng(7)
SCALED = {"ScaleMode": "Magnitude"}
ARROWS = {"GlyphType": "Arrow", "ScaleMode": "Magnitude"}


def grid(*sides):
    """Points of a regular grid."""
    return numpy.stack(numpy.meshgrid(*[numpy.arange(float(side)) for side in sides], indexing="ij"), axis=-1).reshape(-1, 3)


def symmetric(values):
    """Tensors of 9 components with these eigenvalues, turned at random."""
    turns = [numpy.linalg.qr(RANDOM.normal(size=(3, 3)))[0] for _ in values]
    return numpy.array([(turn * row) @ turn.T for turn, row in zip(turns, values)]).reshape(-1, 9)


def generated():
    """name -> (points, arrays, properties)."""
    cube = RANDOM.uniform(0.0, 1.0, (3000, 3))
    clusters = numpy.concatenate([RANDOM.normal(center, 0.01, (500, 3)) for center in RANDOM.uniform(0.0, 1.0, (8, 3))])
    stress = RANDOM.normal(0.0, 100.0, (1000, 3))
    stress[::250] *= 7e4
    decades = {"mass": 10.0**RANDOM.uniform(0.0, 6.0, 3000)}
    centers = 2.2 * grid(9, 9, 9) + RANDOM.uniform(-0.05, 0.05, (729, 3))
    return {
        "regular grid": (grid(10, 10, 10), {}, {}),
        "plane grid": (grid(30, 30, 1), {}, {}),
        "graded mesh": (1.3 ** grid(20, 20, 1) - 1.0, {}, {}),
        "stretched grid": (grid(12, 12, 12) * (0.02, 1.0, 0.1), {}, {}),
        "random points": (cube, {}, {}),
        "boxes": (cube, {}, {"GlyphType": "Box"}),
        "capsules": (cube, {}, {"GlyphShape": "Capsule"}),
        "cones": (grid(5, 5, 5), {}, {"GlyphType": "Cone", "Orient": 0}),
        "meshes": (grid(5, 5, 5), {}, {"GlyphType": lambda: session.triangles(pv.Sphere())}),
        "clusters": (clusters, {}, {}),
        "100,000 points": (RANDOM.uniform(-1.0, 1.0, (100000, 3)), {}, {}),
        "two points": (numpy.array([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0]]), {}, {}),
        "one point": (numpy.array([[3.0, 4.0, 5.0]]), {}, {}),
        "coincident points": (numpy.array([[3.0, 4.0, 5.0]] * 2), {}, {}),
        "packed radii": (centers, {"radius": RANDOM.uniform(0.7, 1.0, 729)}, SCALED),
        "tiny radii": (RANDOM.uniform(0.0, 0.24, (4000, 3)), {"radius": RANDOM.uniform(3e-5, 6e-5, 4000)}, SCALED),
        "displacements": (cube, {"disp": 1e-7 * (cube[:, [1, 2, 0]] - 0.5)}, ARROWS),
        "masses over six decades": (cube, decades, SCALED),
        "logarithm": (cube, decades, {**SCALED, "GlyphScaleFunction": "Logarithm"}),
        "a wild value": (cube, {"s": numpy.where(numpy.arange(3000) == 77, 1e9, RANDOM.uniform(0.5, 1.0, 3000))}, SCALED),
        "diffusion tensors": (grid(9, 9, 9), {"d": symmetric(1e-3 * RANDOM.uniform(0.2, 1.0, (729, 3)))},
                              {"GlyphShape": "Tensor Superquadric"}),
        "stress with outliers": (RANDOM.uniform(0.0, 10.0, (1000, 3)), {"stress": symmetric(stress)},
                                 {"GlyphShape": "Tensor Ellipsoid"}),
    }


def files():
    """name -> (path, properties) of data on disk that are there."""
    data, shared = os.environ["RTGLYPHS_DATA"], os.environ.get("RTGLYPHS_SHARED_DATA", "")
    listed = {
        "impact": (data + "/impact/impact_04.vtk", {}),
        "impact, diameters": (data + "/impact/impact_04.vtk", SCALED),
        "impact, velocities": (data + "/impact/impact_04.vtk", ARROWS),
        "impact, stress": (data + "/impact/impact_04.vtk", {"GlyphShape": "Signed Tensor Superquadric"}),
        "nematic": (data + "/nematic/nematic_04.vtk", {}),
        "point load": (data + "/point_load/point_load.vtk", {"GlyphShape": "Signed Tensor Superquadric"}),
        "tensors": (shared + "/tensors.vtk", {"GlyphShape": "Tensor Ellipsoid"}),
        "blow": (shared + "/blow.vtk", {}),
        "carotid": (shared + "/carotid.vtk", {}),
        "disk_out_ref": (shared + "/disk_out_ref.ex2", {}),
        "disk_out_ref, velocities": (shared + "/disk_out_ref.ex2", ARROWS),
        "can": (shared + "/can-vtu.hdf", {}),
    }
    return {name: entry for name, entry in listed.items() if os.path.exists(entry[0])}


def magnitude(source, shown, shape):
    """The largest magnitude that multiplies ScaleFactor, found in another way than the plugin does it."""
    largest = 1.0
    if "Tensor" in shape:
        tensors = session.array_of(source, shown.SMProxy.GetProperty("GlyphTensorArray").GetElement(0))
        if tensors.shape[1] == 6:
            tensors = tensors[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]]
        tensors = tensors.reshape(-1, 3, 3)
        largest = float(numpy.abs(numpy.linalg.eigvalsh(0.5 * (tensors + tensors.transpose(0, 2, 1)))).max())
    elif str(shown.ScaleMode).strip("'") != "No Data Scaling Off":
        values = session.array_of(source, shown.SMProxy.GetProperty("SelectScaleArray").GetElement(0))
        largest = float(numpy.linalg.norm(values.reshape(len(values), -1), axis=1).max())
        largest = math.log10(1.0 + largest) if str(shown.GlyphScaleFunction).strip("'") == "Logarithm" else largest
    return largest


def largest_glyph(source, shown, shape, view):
    """The size of the largest glyph as a fraction of the view's shorter side in the distance of the focal point."""
    size = shown.ScaleFactor * magnitude(source, shown, shape)
    limit = shown.SMProxy.GetProperty("DataSummary").GetElement(1)
    size = limit if 0.0 < limit < size else size  # a ProgrammableSource has given this module another min()
    size *= 2.0 if shape == "Capsule" else 1.0
    camera = view.GetActiveCamera()
    return size / (2.0 * camera.GetDistance() * math.tan(math.radians(0.5 * camera.GetViewAngle())))


def picture(what, source, properties, view, checks):
    """The picture of a source, checked."""
    shape = properties.get("GlyphShape", "Sphere")
    shown = session.glyphs(source, view, samples=4, **{"shape": shape, **properties})
    shown.ColorArrayName = [None, ""]
    view.ViewTime = 0.0  # one case changes it
    if what == "empty first step":
        pv.Render(view)
        view.ViewTime = 1.0
    said = session.messages(lambda: (pv.ResetCamera(view), pv.Render(view)))
    pixels = session.capture(view, "right-at-once-" + re.sub(r"\W+", "-", what))
    covered = float(comparison.covered(pixels).mean())
    largest = largest_glyph(source, shown, shape, view)
    print("%-26s factor %-10.4g covers %4.1f %%, largest glyph %4.1f %% of the view"
          % (what, shown.ScaleFactor, 100 * covered, 100 * largest), flush=True)
    checks.within(what + ": covered fraction of the view", round(covered, 4), SHARES.get(what, LEAST), MOST)
    checks.true("%s: the largest glyph is %.0f %% of the view" % (what, 100 * largest), largest <= LARGEST or what in SINGLE)
    checks.no_message(what, said)
    pv.Delete(shown)
    return pixels[..., :3]


def main():
    """All data sets."""
    session.load()
    checks = Checks()
    sources = [(name, session.source(session.poly_data(points, **arrays)), properties)
               for name, (points, arrays, properties) in generated().items()]
    sources += [("empty first step", scale_guess.series((0.0, 0, 0.0), (1.0, 6, 2.0)), {})]
    sources += [(name, pv.OpenDataFile(path), properties) for name, (path, properties) in files().items()]
    view = session.view(WIDTH, HEIGHT)
    pictures = [picture(*entry, view, checks) for entry in sources]
    rows = -(-len(pictures) // COLUMNS)
    sheet = numpy.full((rows * HEIGHT, COLUMNS * WIDTH, 3), 128, numpy.uint8)
    for i, pixels in enumerate(pictures):
        row, column = divmod(i, COLUMNS)
        sheet[row * HEIGHT:(row + 1) * HEIGHT, column * WIDTH:(column + 1) * WIDTH] = pixels
    comparison.write_image(session.output("right-at-once.png"), sheet)
    checks.true("only %d data sets" % len(pictures), len(pictures) >= 12)
    checks.report()


if __name__ == "__main__":
    main()
