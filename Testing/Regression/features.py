"""What an image shows besides colors, as a file for scripts: depth, normal, albedo, ids, sample count.

Usage: pvpython features.py
"""
import os

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import session

WIDTH, HEIGHT, SAMPLES = 121, 91, 4
#: world units per pixel: parallel projection, 9.1 units high
STEP = 0.1
COLORS = ((200, 40, 40), (40, 200, 40), (40, 40, 200))
#: centers and diameter of the balls; the last lies behind the second
CENTERS = numpy.array([[-3.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -2.0]])
DIAMETER = 2.0
DISTANCE = 10.0  # of the camera from z = 0


def read(path):
    """Point arrays of an image file by name, as rows of pixels."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    arrays = {}
    for i in range(image.GetPointData().GetNumberOfArrays()):
        array = image.GetPointData().GetArray(i)
        values = vtk_to_numpy(array)
        arrays[array.GetName()] = values.reshape((height, width) + values.shape[1:])
    return arrays


def check(failures, what, seen, expected, tolerance=0.0):
    seen, expected = numpy.asarray(seen, dtype=float), numpy.asarray(expected, dtype=float)
    if not seen.shape == expected.shape or not (numpy.abs(seen - expected) <= tolerance).all():
        failures.append("%s: %s instead of %s" % (what, seen, expected))


def main():
    session.load()
    import raytracedglyphs  # comes with the plugin
    failures = []
    view = session.view(WIDTH, HEIGHT)
    balls = session.source(session.poly_data(CENTERS, rgb=numpy.array(COLORS, dtype=numpy.uint8)))
    shown = session.glyphs(balls, view, "Sphere", Orient=0, ScaleFactor=DIAMETER, SamplesPerPixel=SAMPLES)
    pv.ColorBy(shown, ("POINTS", "rgb"))
    shown.MapScalars = 0
    wall = pv.Plane(Origin=[2, -1, 0], Point1=[4, -1, 0], Point2=[2, 1, 0], XResolution=2, YResolution=1)
    surface = pv.Show(wall, view)
    surface.SetRepresentationType("Ray Traced Surface")
    surface.SamplesPerPixel = SAMPLES
    session.solid(surface, (1.0, 1.0, 0.0))
    session.look(view, (0.0, 0.0, DISTANCE), parallel_scale=0.5 * HEIGHT * STEP)

    path = session.output("features.vti")
    if os.path.exists(path):
        os.remove(path)
    session.capture(view, "features-off")
    if os.path.exists(path):
        failures.append("a file was written without being asked for")
    raytracedglyphs.SaveFeatureImage(path, view)
    if not os.path.exists(path):
        failures.append("no file was written")
        session.finish(failures)
    seen = read(path)
    row = (HEIGHT - 1) // 2

    def column(x):
        return (WIDTH - 1) // 2 + int(round(x / STEP))

    left, middle, right, nothing = ((row, column(x)) for x in (-3.0, 0.0, 3.3, 5.5))
    check(failures, "albedo of the left ball", seen["Albedo"][left], numpy.array(COLORS[0]) / 255.0, 0.003)
    check(failures, "albedo of the middle ball", seen["Albedo"][middle], numpy.array(COLORS[1]) / 255.0, 0.003)
    check(failures, "albedo of the wall", seen["Albedo"][right], (1, 1, 0), 0.003)
    # In front of the centers; four samples spread over a pixel lie a little lower.
    for name, at, z in (("left", left, 1.0), ("middle", middle, 2.0), ("wall", right, 0.0)):
        check(failures, "view depth, " + name, seen["ViewDepth"][at], DISTANCE - z, 0.01)
        check(failures, "normal, " + name, seen["Normal"][at], (0, 0, 1), 0.05)
    check(failures, "ids", [seen["OriginalId"][at] for at in (left, middle, right, nothing)], (0, 1, 1, -1))
    check(failures, "representations", [seen["Representation"][at] for at in (left, middle, right, nothing)],
          (0, 0, 1, -1))
    check(failures, "samples", seen["SampleCount"], numpy.full((HEIGHT, WIDTH), SAMPLES))
    check(failures, "nothing's window depth", seen["WindowDepth"][nothing], 1.0)
    check(failures, "nothing's normal", seen["Normal"][nothing], (0, 0, 0))
    # The normal half-way to the left ball's side.
    aside = (row, column(-2.5))
    check(failures, "normal aside", seen["Normal"][aside], (0.5, 0, 0.75 ** 0.5), 0.06)
    covered = seen["Color"][..., 3].sum() / 255.0 * STEP * STEP
    check(failures, "covered area", covered, 2 * numpy.pi + 4.0, 0.2)

    # Through light from all around and a translucent ball in a pass of its own, and after the camera has moved.
    shown.ShadingMode = "Ambient Occlusion"
    surface.Opacity = 0.5
    session.look(view, (0.0, 0.0, DISTANCE + 1.0), parallel_scale=0.5 * HEIGHT * STEP)
    os.remove(path)
    session.capture(view, "features-occlusion")
    if os.path.exists(path):
        failures.append("a file was written a second time")
    raytracedglyphs.SaveFeatureImage(path, view)
    seen = read(path)
    check(failures, "view depth after moving", seen["ViewDepth"][middle], DISTANCE - 1.0, 0.01)
    check(failures, "translucent wall", seen["Representation"][right], 1)
    check(failures, "its opacity", seen["Color"][right][3], 128, 2)

    # Glyphs of cells have the cells' ids.
    surface.SetRepresentationType(session.REPRESENTATION)
    surface.GlyphLocation, surface.Opacity, surface.Orient, surface.ScaleFactor = "Cells", 1.0, 0, 0.5
    raytracedglyphs.SaveFeatureImage(path, view)
    seen = read(path)
    check(failures, "ids of cells", [seen["OriginalId"][row, column(x)] for x in (2.5, 3.5)], (0, 1))

    unwritable = os.path.join(session.output("no such folder"), "features.vti")
    text = session.messages(lambda: raytracedglyphs.SaveFeatureImage(unwritable, view))
    for word in ("no such folder", "feature image", "folder that exists"):
        if word not in text:
            failures.append("the message does not speak of '%s': %s" % (word, text.strip()))
    session.finish(failures)


main()
