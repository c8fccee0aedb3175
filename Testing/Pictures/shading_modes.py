"""Local shading beside ambient occlusion beside path tracing: the simulation's grains and molecules, arrows in a vessel.

As in Figures 1 to 3 and 6 of Zellmann, Aumueller, Marshak and Wald, EGPGV 2020, with data of our own and nothing but ShadingMode set.
Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython shading_modes.py DATA-FOLDER OUTPUT-FOLDER [SAMPLES [WIDTH HEIGHT [NAME...]]]
NAME: spheres, ellipsoids, vessel; all
"""
import os
import sys

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import simulation

MODES = ("Local", "Ambient Occlusion", "Path Tracing")


def vessel(impact, view):
    """The grains' velocities as arrows in an open vessel, a ray-traced surface."""
    simulation.arrows(impact, view)
    box = pv.Box(XLength=30.0, YLength=30.0, ZLength=14.0, Center=[14.3, 14.0, 6.5])
    walls = pv.Clip(Input=box, ClipType="Plane")
    walls.ClipType.Origin, walls.ClipType.Normal = [14.3, 2.0, 6.5], [0.0, 1.0, 0.0]
    walls.Invert = 0
    open_above = pv.Clip(Input=walls, ClipType="Plane")
    open_above.ClipType.Origin, open_above.ClipType.Normal = [14.3, 14.0, 13.0], [0.0, 0.0, -1.0]
    open_above.Invert = 0
    shown = pv.Show(open_above, view)
    shown.SetRepresentationType("Ray Traced Surface")
    shown.Interpolation = "Flat"
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = shown.AmbientColor = [0.85, 0.83, 0.8]
    simulation.look(view, (10.0, -26.0, 24.0), (14.3, 14.0, 5.5), (0.0, 0.0, 1.0))


def pixels_of(path):
    """A PNG file as rows from the bottom, columns, channels."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3]


def write(path, pixels):
    """Writes rows from the bottom as PNG."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    array = numpy_to_vtk(numpy.ascontiguousarray(pixels).reshape(-1, 3), deep=True, array_type=VTK_UNSIGNED_CHAR)
    image.GetPointData().SetScalars(array)
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def main():
    """Makes one picture of each scene, the modes from left to right."""
    data, folder = simulation.begin()
    impact, nematic = simulation.simulations(data)
    samples = int(sys.argv[3]) if len(sys.argv) > 3 else 64
    size = [int(value) for value in sys.argv[4:6]] or [460, 400]
    for name, source, draw, time in (("spheres", impact, simulation.spheres, 0.8),
                                     ("ellipsoids", nematic, simulation.ellipsoids, nematic.TimestepValues[-1]),
                                     ("vessel", impact, vessel, 0.8)):
        if name not in (sys.argv[6:] or name):
            continue
        view = simulation.new_view(size)
        view.ViewTime = time
        pv.UpdatePipeline(time, source)
        draw(source, view)
        for bar in [shown for shown in view.Representations if "ScalarBar" in shown.GetXMLName()]:
            bar.Visibility = 0
        row = []
        for mode in MODES:
            for shown in view.Representations:
                if hasattr(shown, "ShadingMode"):
                    shown.ShadingMode, shown.SamplesPerPixel = mode, samples
            path = os.path.join(folder, "%s-%s.png" % (name, mode.split()[0].lower()))
            pv.SaveScreenshot(path, view, ImageResolution=size)
            row.append(pixels_of(path))
            os.remove(path)
        path = os.path.join(folder, "light-%s.png" % name)
        write(path, numpy.concatenate(row, axis=1))
        print("wrote", path)
        sys.stdout.flush()
        pv.Delete(view)
    pv.Disconnect()


if __name__ == "__main__":
    main()
