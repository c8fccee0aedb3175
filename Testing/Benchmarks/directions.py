"""Spherical functions and tubes in large numbers: seconds to the first picture, seconds a frame, memory, beside the meshes that others draw.

Usage: pvpython directions.py FOLDER [--kinds "KIND;..."] [--size PIXELS] [--frames N]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

101,250 distribution functions of order 8 (Data/odf.py, side 75), drawn as spherical harmonics and as one mesh with 362 vertices and 720
triangles for each, the vertices moved along their directions: what programs for diffusion data draw. A million pieces of tubes on 1,000
curves, drawn as tubes and by ParaView's Tube filter with 12 sides. Each kind has a process of its own. First picture: from data in memory
until it is rendered with one ray a pixel, programs compiled in it; for meshes, the data are the meshes, and making them is timed separately.
A frame: the camera turns by a degree. Occlusion: one sample a pixel, as many directions as by default. Memory: the largest
that the process held since the data were made, without what it held before that. Written to FOLDER: directions.csv, a picture of each.
"""
import argparse
import json
import os
import sys
import time

import numpy

from frames import begin, figures_of, memory, source, turning, work, write_table

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Data"))
sys.dont_write_bytecode = True
import odf  # noqa: E402

SIDE = 75
CURVES, PIECES = 1000, 1000
KINDS = ("spherical harmonics", "spherical harmonics, occlusion", "meshes of 362 vertices", "tubes", "tubes, occlusion", "Tube filter, 12 sides")


def poly_data(points, cells=None, lines=False, **arrays):
    """vtkPolyData of these points; cells: lines or polygons of one length, as rows."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    made, coordinates = vtkPolyData(), vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=numpy.float32), deep=True))
    made.SetPoints(coordinates)
    if cells is not None:
        array = vtkCellArray()
        offsets = numpy.arange(len(cells) + 1, dtype=numpy.int64) * cells.shape[1]
        array.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(cells.reshape(-1).astype(numpy.int64), deep=True))
        (made.SetLines if lines else made.SetPolys)(array)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32), deep=True)
        array.SetName(name)
        (made.GetPointData().SetNormals if name == "Normals" else made.GetPointData().AddArray)(array)
    return made


def geodesic(frequency=6):
    """Directions and triangles of an icosahedron with each side cut into so many: 10 frequency^2 + 2 vertices."""
    golden = (1.0 + 5.0 ** 0.5) / 2.0
    corners = numpy.array([[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0], [0, -1, golden], [0, 1, golden],
                           [0, -1, -golden], [0, 1, -golden], [golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1]])
    sides = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    numbers, found, triangles = {}, [], []

    def number(point):
        key = tuple(numpy.round(point, 6) + 0.0)
        if key not in numbers:
            numbers[key] = len(found)
            found.append(point / numpy.linalg.norm(point))
        return numbers[key]

    for side in sides:
        a, b, c = corners[list(side)]
        grid = {(i, j): number(a + (b - a) * i / frequency + (c - a) * j / frequency)
                for i in range(frequency + 1) for j in range(frequency + 1 - i)}
        for i in range(frequency):
            for j in range(frequency - i):
                triangles.append((grid[i, j], grid[i + 1, j], grid[i, j + 1]))
                if i + j < frequency - 1:
                    triangles.append((grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]))
    return numpy.array(found), numpy.array(triangles)


def scale_of(coefficients):
    """Half the distance of two voxels over the largest radius there is."""
    directions, _ = geodesic()
    return 0.5 / float(numpy.abs(coefficients @ odf.harmonics(directions).T).max())


def meshes(points, coefficients, scale, frequency=6):
    """One mesh a voxel, with smooth normals; scale: the world's length of a radius of 1."""
    directions, triangles = geodesic(frequency)
    radius = numpy.abs(coefficients.astype(numpy.float32) @ odf.harmonics(directions).T.astype(numpy.float32)) * numpy.float32(scale)
    at = radius[:, :, None] * directions[None].astype(numpy.float32)
    normals = numpy.zeros_like(at)
    corners = [at[:, triangles[:, i]] for i in range(3)]
    faces = numpy.cross(corners[1] - corners[0], corners[2] - corners[0])
    del corners
    for i in range(3):
        for row, vertex in enumerate(triangles[:, i]):
            normals[:, vertex] += faces[:, row]
    del faces
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=2, keepdims=True), 1e-20)
    at += points[:, None].astype(numpy.float32)
    cells = (triangles[None] + len(directions) * numpy.arange(len(points))[:, None, None]).reshape(-1, 3)
    return poly_data(at.reshape(-1, 3), cells, Normals=normals.reshape(-1, 3))


def curves():
    """Lines that wind through a cube."""
    random = numpy.random.default_rng(2)
    t = numpy.linspace(0.0, 1.0, PIECES + 1)[None, :, None]
    phases, rates = random.uniform(0.0, 2.0 * numpy.pi, (CURVES, 1, 3)), random.uniform(2.0, 9.0, (CURVES, 1, 3))
    middle = random.uniform(0.15, 0.85, (CURVES, 1, 3))
    points = middle + 0.15 * numpy.sin(phases + rates * t)
    return poly_data(points.reshape(-1, 3), numpy.arange(CURVES * (PIECES + 1)).reshape(CURVES, -1), lines=True,
                     value=numpy.tile(t[0, :, 0], CURVES))


def show(pv, producer, view, kind, factor):
    """A display of this kind, not yet rendered."""
    shown = pv.Show(producer, view)
    if kind.startswith("spherical"):
        shown.SetRepresentationType("Ray Traced Glyphs")
        shown.GlyphShape, shown.GlyphHarmonicsArray, shown.ScaleFactor = "Spherical Harmonics", "odf", factor
        shown.Orient = 0
    elif kind.startswith("tubes"):
        shown.SetRepresentationType("Ray Traced Tubes")
        shown.TubeRadius = factor
    else:
        shown.SetRepresentationType("Surface")
    shown.ColorArrayName = [None, ""]
    if not kind.startswith(("meshes", "Tube")):
        shown.SamplesPerPixel, shown.Denoising = 1, "Never"
        shown.ShadingMode = "Ambient Occlusion" if kind.endswith("occlusion") else "Local"
    return shown


def measure(kind, size, frames, folder):
    """The figures of this process."""
    import paraview.simple as pv

    view = begin(size)
    pv.Render(view)
    radius, making = 0.002, 0.0
    if kind.startswith(("spherical", "meshes")):
        points, coefficients, _ = odf.field(SIDE)
        factor = 2.0 * scale_of(coefficients)
        middle, reach = points.mean(axis=0), 1.1 * SIDE
    else:
        factor, middle, reach = radius, numpy.full(3, 0.5), 1.1
    before = memory("VmRSS")
    if kind.startswith("meshes"):
        start = time.monotonic()
        data = meshes(points, coefficients, 0.5 * factor)
        making = time.monotonic() - start
    elif kind.startswith("spherical"):
        data = poly_data(points, odf=coefficients)
    else:
        data = curves()
    with open("/proc/self/clear_refs", "w", encoding="ascii") as peak:
        peak.write("5")  # VmHWM begins anew
    view.CameraPosition, view.CameraFocalPoint = list(middle + numpy.array([0.3, -0.6, 1.5]) * reach), list(middle)
    start = time.monotonic()
    producer = source(data)
    if kind.startswith("Tube"):
        producer = pv.Tube(Input=producer, Radius=radius, NumberofSides=12, VaryRadius="Off", Capping=1)
        producer.UpdatePipeline()
    shown = show(pv, producer, view, kind, factor)
    pv.Render(view)
    first = time.monotonic() - start
    figures = {"first": first, "making": making, **turning(lambda: pv.Render(view), frames), "bytes": memory("VmHWM") - before}
    if not kind.startswith(("meshes", "Tube")):
        figures.update(work(shown))
    pv.SaveScreenshot(os.path.join(folder, "directions-%s.png" % kind.replace(",", "").replace(" ", "-")), view)
    print(json.dumps(figures), flush=True)
    os._exit(0)


def main():
    """Either the figures of one process (--measure) or the table of all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--kinds", help="separated by ;", default=";".join(KINDS))
    parser.add_argument("--size", type=int, default=1200)
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--limit", type=float, default=900.0)
    parser.add_argument("--measure", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        measure(options.measure, options.size, options.frames, options.folder)
    os.makedirs(options.folder, exist_ok=True)
    rows = []
    for kind in options.kinds.split(";"):
        rows.append({"kind": kind, **figures_of(kind, [os.path.abspath(__file__), options.folder, "--size", str(options.size), "--frames", str(options.frames),
                                                       "--measure", kind], options.limit)})
    write_table(os.path.join(options.folder, "directions.csv"), rows)


if __name__ == "__main__":
    main()
