"""Seconds to the first picture, seconds a frame, and the largest memory of a process that shows many spheres or arrows.

Usage: pvpython scale.py FOLDER [--counts N,N...] [--size PIXELS] [--frames N]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

Random points in a cube, each with a radius and a value that colors it, both float: 20 bytes a point; arrows have a vector besides. Each count and
representation has a process of its own. First picture: from data in memory until it is rendered, with one ray a pixel, programs compiled
before in that process by a scene of few points. Of that, information: ParaView's search for the ranges of all arrays, which it does for data of
any representation before that has them. A frame: the camera turns by a degree. Turning: the same while a window asks for
speed. Memory: the largest that the process ever held (VmHWM), and that before the data are shown. Written to FOLDER: scale.csv.
Kind reduced: the spheres that ParaView's level of detail shows, in the first picture, too; of them also how many there are and how far sums over the
values and areas that they stand for are from those over all points, as fractions.
A representation that does not end within --limit seconds, or that dies, has no numbers.
"""
import argparse
import json
import os
import time

import numpy

from frames import begin, cpu_seconds, figures_of, memory, source, turning, work, write_table

KINDS = ("spheres", "arrows", "signed tensors", "Point Gaussian", "3D Glyphs")
REDUCED = "reduced"
#: those that are measured of each number of points
PLAN = {"spheres": 10**9, REDUCED: 10**9, "arrows": 10**7, "signed tensors": 10**6, "Point Gaussian": 10**9, "3D Glyphs": 10**6}


def points_of(count, kind):
    """Random points with what the kind of glyph needs; made in parts, so that they need no memory besides."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    random = numpy.random.default_rng(1)
    size = count ** (-1.0 / 3.0)
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(random.random((count, 3), dtype=numpy.float32)))
    data.SetPoints(points)
    arrays = {"diameter": (1, 0.2 * size, 0.6 * size), "value": (1, 0.0, 1.0)}
    if kind == "arrows":
        arrays["flow"] = (3, -1.5 * size, 3.0 * size)
    if kind == "signed tensors":
        arrays["tensor"] = (6, -0.7 * size, 1.4 * size)
    for name, (components, least, range_) in arrays.items():
        values = random.random((count, components), dtype=numpy.float32)
        values *= range_
        values += least
        array = numpy_to_vtk(values)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def show(pv, producer, view, kind):
    """A display of this kind, not yet rendered."""
    shown = pv.Show(producer, view)
    shown.SetScalarColoring("value", pv.servermanager.GetAssociationFromString("POINTS"))
    table = pv.GetColorTransferFunction("value")
    table.RescaleTransferFunction(0.0, 1.0)
    if kind == "Point Gaussian":
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset = "Sphere"
        shown.ScaleByArray, shown.SetScaleArray = 1, ["POINTS", "diameter"]
        shown.UseScaleFunction = 0
        shown.GaussianRadius = 0.5
    elif kind == "3D Glyphs":
        shown.SetRepresentationType("3D Glyphs")
        shown.GlyphType = "Sphere"
        shown.Scaling, shown.ScaleMode, shown.SelectScaleArray, shown.ScaleFactor = 1, "Magnitude", "diameter", 1.0
    else:
        shown.SetRepresentationType("Ray Traced Glyphs")
        shown.SamplesPerPixel = 1
        shown.ScaleFactor = 1.0
        if kind in ("spheres", REDUCED):
            shown.GlyphType, shown.Orient = "Sphere", 0
            shown.ScaleMode, shown.SelectScaleArray = "Magnitude", "diameter"
        elif kind == "arrows":
            shown.GlyphType, shown.Orient, shown.SelectOrientationVectors = "Arrow", 1, "flow"
            shown.ScaleMode, shown.SelectScaleArray = "Magnitude", "flow"
        else:
            shown.GlyphShape, shown.GlyphTensorArray = "Signed Tensor Superquadric", "tensor"
    return shown


def reduction(data, shown):
    """Number of glyphs that stand for all, and errors of sums."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    left = shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(1).NewIterator().GetCurrentDataObject().GetPointData()
    numbers, value = (vtk_to_numpy(left.GetArray(name)).astype(float) for name in ("vtkRayTraced_Reduced", "value"))
    values, diameters = (vtk_to_numpy(data.GetPointData().GetArray(name)) for name in ("value", "diameter"))
    return {"reduced": len(value), "error of values": abs((numbers[:, 0] * value).sum() / values.sum(dtype=float) - 1.0),
            "error of areas": abs(numbers[:, 1].sum() / (diameters.astype(float) ** 2).sum() - 1.0)}


def measure(count, kind, size, frames):
    """The figures of this process."""
    import paraview.simple as pv

    view = begin(size)
    view.CameraPosition, view.CameraFocalPoint = [0.5, 0.5, 3.2], [0.5, 0.5, 0.5]
    warming = show(pv, source(points_of(100, kind)), view, kind)
    pv.Render(view)
    view.SMProxy.InteractiveRender()
    pv.Delete(warming)
    data = points_of(count, kind)
    before = memory("VmRSS")
    start, start_cpu = time.monotonic(), cpu_seconds()
    producer = source(data)
    information, information_cpu = time.monotonic() - start, cpu_seconds() - start_cpu
    shown = show(pv, producer, view, kind)
    if kind == REDUCED:
        view.SMProxy.InteractiveRender()
    else:
        pv.Render(view)
    first, first_cpu = time.monotonic() - start, cpu_seconds() - start_cpu
    found = reduction(data, shown) if kind == REDUCED else {}
    # The window asks so of its renders while a button is down.
    view.SMProxy.InteractiveRender()
    figures = {"first": first, "information": information, "first cpu": first_cpu, "information cpu": information_cpu, **found,
               **turning(view.SMProxy.InteractiveRender, frames, "turning", "turning cpu"), **turning(lambda: pv.Render(view), frames), "before bytes": before, "peak bytes": memory("VmHWM"), "end bytes": memory("VmRSS")}
    if kind not in ("Point Gaussian", "3D Glyphs"):
        figures.update(work(shown))
    print(json.dumps(figures), flush=True)
    os._exit(0)


def main():
    """Either the figures of one process (--measure) or the table of all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--counts", default="1000,10000,100000,1000000,10000000,100000000")
    parser.add_argument("--kinds", default=",".join(KINDS), help="also: " + REDUCED)
    parser.add_argument("--size", type=int, default=1200)
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--limit", type=float, default=900.0)
    parser.add_argument("--measure", help=argparse.SUPPRESS)
    options = parser.parse_args()
    counts = [int(count) for count in options.counts.split(",")]
    if options.measure:
        measure(counts[0], options.measure, options.size, options.frames)
    os.makedirs(options.folder, exist_ok=True)
    rows = []
    for kind in options.kinds.split(","):
        for count in counts:
            if count > PLAN[kind]:
                continue
            rows.append({"kind": kind, "count": count, **figures_of(
                "%d %s" % (count, kind), [os.path.abspath(__file__), options.folder, "--counts", str(count), "--size", str(options.size), "--frames",
                                          str(options.frames), "--measure", kind], options.limit)})
    write_table(os.path.join(options.folder, "scale.csv"), rows)


if __name__ == "__main__":
    main()
