"""Ray-traced surfaces: as ParaView's own Surface shows them, in one scene with glyphs, with what is wrong said once.

Usage: pvpython surface.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import comparison
import session

SURFACE = "Ray Traced Surface"
COLOUR = (0.8, 0.5, 0.2)
FAILURES = []


def check(good, text):
    """Takes note of what is not as it must be."""
    if not good:
        FAILURES.append(text)


def colour_at(pixels, x, y):
    """The RGB of one pixel, x and y from the upper left, as a tuple of int."""
    return tuple(int(channel) for channel in pixels[y, x, :3])


def show(source, view, kind, **properties):
    """Shows a source as a surface of this kind with one sample a pixel."""
    shown = pv.Show(source, view)
    shown.SetRepresentationType(kind)
    shown.SamplesPerPixel = 1
    for name, value in properties.items():
        setattr(shown, name, value)
    return shown


def sphere_data(radius=1.0, resolution=32, centre=(0.0, 0.0, 0.0)):
    """A sphere with smooth normals and arrays of both kinds."""
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(centre)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    data = vtkPolyData()
    data.ShallowCopy(source.GetOutput())
    points = vtk_to_numpy(data.GetPoints().GetData())
    session.add_arrays(data, height=points[:, 1].astype(float), rgb=(numpy.abs(points) / radius * 255).clip(0, 255).astype(numpy.uint8))
    faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    stripes = numpy_to_vtk(numpy.floor(4.0 * points[faces].mean(axis=1)[:, 0]), deep=True)
    stripes.SetName("stripes")
    data.GetCellData().AddArray(stripes)
    return data


def colour_nothing(shown, _view):
    session.solid(shown, COLOUR)


def colour_by(association, name):
    """A function that colours a representation with an array through its lookup table."""
    def apply(shown, view):
        pv.ColorBy(shown, (association, name))
        shown.SetScalarBarVisibility(view, False)
    return apply


def colour_direct(shown, view):
    pv.ColorBy(shown, ("POINTS", "rgb"))
    shown.MapScalars = 0
    shown.SetScalarBarVisibility(view, False)


def like_paraview(view):
    """Same camera, lights and colours as ParaView's Surface: within the thresholds of the glyphs."""
    sphere = session.source(sphere_data())
    box = pv.Box(XLength=1.6, YLength=1.2, ZLength=1.4)
    wavelet = pv.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    cases = (
        ("sphere-smooth", sphere, {"Interpolation": "Gouraud"}, colour_nothing),
        ("sphere-flat", sphere, {"Interpolation": "Flat"}, colour_nothing),
        ("box", box, {"Interpolation": "Flat"}, colour_nothing),
        ("sphere-points", sphere, {}, colour_by("POINTS", "height")),
        ("sphere-cells", sphere, {}, colour_by("CELLS", "stripes")),
        ("sphere-direct", sphere, {}, colour_direct),
        ("sphere-moved", sphere, {"Position": [0.3, 0.1, 0.0], "Scale": [1.2, 0.6, 1.0], "Orientation": [20.0, 0.0, 40.0]}, colour_nothing),
        ("image", wavelet, {"Scale": [0.3, 0.3, 0.3]}, colour_by("POINTS", "RTData")),
    )
    for name, source, properties, colouring in cases:
        pictures = {}
        for kind in (SURFACE, "Surface"):
            shown = show(source, view, kind, **properties)
            colouring(shown, view)
            shown.Specular = 0.4
            shown.SpecularPower = 20.0
            if name == "image":
                # ParaView computes no normals; of the faces of a box the two must agree all the same.
                session.look(view, (2.0, 1.5, 5.0))
            else:
                session.look(view, (1.5, 1.2, 4.0))
            pictures[kind] = session.capture(view, "surface-%s-%s" % (name, "ours" if kind == SURFACE else "paraview"))
            if kind == SURFACE:
                statistics = session.statistics(shown)
                check(statistics["primaryRays"] > 0, "%s: no ray has been traced" % name)
            pv.Hide(source, view)
            pv.Delete(shown)
        FAILURES.extend(comparison.against_paraview(pictures[SURFACE], pictures["Surface"], "surface-" + name))


def main():
    """All parts."""
    session.load()
    view = session.view()
    like_paraview(view)
    session.finish(FAILURES)


if __name__ == "__main__":
    main()
