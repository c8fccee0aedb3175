"""Each scene in each kind of light with nothing but ShadingMode set, on white and on ParaView's own background: one contact sheet,
and what can be measured of it.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython light_sheet.py DATA-FOLDER OUTPUT-FOLDER [SIDE [SAMPLES]]
DATA-FOLDER: the clone's Data. Printed for each picture: mean level of what is covered, fraction of it darker than 0.1 and as bright as
white, and of Ambient Occlusion and Path Tracing the mean over that of Local.
"""
import os
import subprocess
import sys

import numpy
import paraview.simple as pv

import shading_modes
import simulation

MODES = ("Local", "Ambient Occlusion", "Path Tracing")


def ball(data, folder, view):
    """A gray ball."""
    shown = pv.Show(pv.PointSource(NumberOfPoints=1), view)
    shown.SetRepresentationType(simulation.REPRESENTATION)
    shown.ScaleFactor = 1.0
    shown.DiffuseColor = shown.AmbientColor = [0.75] * 3
    simulation.look(view, (0.0, 0.0, 2.6), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def crowd(data, folder, view):
    """280,000 spheres without a color, at random."""
    path = os.path.join(folder, "spheres.vtk")
    if not os.path.exists(path):
        subprocess.run(["/usr/bin/python3", os.path.join(data, "spheres_280k.py"), path], check=True)
    shown = simulation.show(pv.OpenDataFile(path), view, "Sphere", SelectScaleArray="radius", ScaleMode="Magnitude",
                            ScaleFactor=2.0)
    shown.ColorArrayName = [None, ""]
    simulation.look(view, (50.0, 50.0, 286.6), (50.0, 50.0, 50.0), (0.0, 1.0, 0.0))


def grains(data, folder, view):
    """The bed of grains that a ball hits, without a color."""
    impact = pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series"))
    view.ViewTime = 0.4
    pv.UpdatePipeline(0.4, impact)
    shown = simulation.show(impact, view, "Sphere", SelectScaleArray="diameter", ScaleMode="Magnitude", ScaleFactor=1.0)
    shown.ColorArrayName = [None, ""]
    simulation.look(view, (9.0, -36.0, 27.0), (14.3, 14.0, 4.0), (0.0, 0.0, 1.0))


def colored_grains(data, folder, view):
    """The same by speed."""
    impact = pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series"))
    view.ViewTime = 0.8
    pv.UpdatePipeline(0.8, impact)
    simulation.spheres(impact, view)


def vessel(data, folder, view):
    """Arrows of velocity in an open vessel."""
    impact = pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series"))
    view.ViewTime = 0.8
    pv.UpdatePipeline(0.8, impact)
    shading_modes.vessel(impact, view)


def tensors(data, folder, view):
    """Diffusion tensors of a bundle of fibers by principal direction."""
    path = os.path.join(folder, "helix.vtk")
    if not os.path.exists(path):
        subprocess.run(["/usr/bin/python3", os.path.join(data, "helix.py"), path], check=True)
    source = pv.OpenDataFile(path)
    shown = simulation.show(source, view, "Tensor Superquadric")
    shown.GlyphDirectionColoring = "Axes"
    view.ResetCamera()
    camera = view.GetActiveCamera()
    camera.Elevation(-40.0)
    camera.Zoom(1.4)


def packing(data, folder, view):
    """Superquadrics that do not touch."""
    path = os.path.join(folder, "packing.vtk")
    if not os.path.exists(path):
        subprocess.run(["/usr/bin/python3", os.path.join(data, "packing.py"), path], check=True)
    shown = simulation.show(pv.OpenDataFile(path), view, "Superquadric", Orient=1, SelectOrientationVectors="quaternion",
                            OrientationMode="Quaternion", SelectScaleArray="lengths", ScaleMode="Vector Components",
                            ScaleFactor=1.0, GlyphExponentArray="exponents")
    shown.ColorArrayName = [None, ""]
    simulation.look(view, (1.8, 1.6, 2.6), (0.5, 0.5, 0.5), (0.0, 1.0, 0.0))


SCENES = (ball, crowd, grains, colored_grains, vessel, tensors, packing)


def luminance(pixels):
    """Linear, of display levels in [0, 1]."""
    light = numpy.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)
    return light @ numpy.array([0.2126, 0.7152, 0.0722])


def main():
    """Makes the sheet: scenes from top to bottom, kinds of light from left to right, on white and then on ParaView's background."""
    data, folder = simulation.begin()
    side = int(sys.argv[3]) if len(sys.argv) > 3 else 360
    samples = int(sys.argv[4]) if len(sys.argv) > 4 else 32
    names = sys.argv[5:] or [scene.__name__ for scene in SCENES]
    rows = []
    for scene in SCENES:
        if scene.__name__ not in names:
            continue
        row = []
        for own_background in (0, 1):
            view = simulation.new_view([side, side])
            view.UseColorPaletteForBackground = own_background
            empty = os.path.join(folder, "empty.png")
            pv.SaveScreenshot(empty, view, ImageResolution=[side, side])
            behind = shading_modes.pixels_of(empty).astype(float)
            scene(data, folder, view)
            pv.HideUnusedScalarBars(view)
            for bar in [shown for shown in view.Representations if "ScalarBar" in shown.GetXMLName()]:
                bar.Visibility = 0
            local = None
            for mode in MODES:
                for shown in view.Representations:
                    if hasattr(shown, "ShadingMode"):
                        shown.ShadingMode, shown.SamplesPerPixel = mode, samples
                path = os.path.join(folder, "one.png")
                pv.SaveScreenshot(path, view, ImageResolution=[side, side])
                pixels = shading_modes.pixels_of(path)
                row.append(pixels)
                if mode == "Local":
                    covered = (numpy.abs(pixels - behind) > 2.0).any(axis=-1)
                levels = pixels[covered] / 255.0
                mean = levels.mean()
                local = mean if mode == "Local" else local
                light = luminance(levels)
                print("%-14s %-6s %-17s mean %.3f (of Local %.2f)  below 0.1: %.2f %%  burnt out: %.2f %%  luminance 2 %% to 98 %%: %.3f to %.3f"
                      % (scene.__name__, "own" if own_background else "white", mode, mean, mean / local,
                         100.0 * (levels.max(axis=-1) < 0.1).mean(), 100.0 * (levels.min(axis=-1) >= 1.0).mean(),
                         numpy.quantile(light, 0.02), numpy.quantile(light, 0.98)))
                sys.stdout.flush()
            pv.Delete(view)
        rows.append(numpy.concatenate(row, axis=1))
    for name in ("empty.png", "one.png"):
        os.remove(os.path.join(folder, name))
    path = os.path.join(folder, "light-sheet.png")
    shading_modes.write(path, numpy.concatenate(rows[::-1], axis=0))
    print("wrote", path)
    pv.Disconnect()


if __name__ == "__main__":
    main()
