"""Pictures of motion: arrows beside spheres that leave streaks, straight and with acceleration.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython motion.py DATASET OUTPUT-FOLDER [WIDTH HEIGHT]
DATASET: a folder by Data/injection.py, or can-vtu.hdf of VTK's test data (arrays VEL and ACCL).
"""
import os
import sys

import paraview.simple as pv

import simulation


def chamber(folder, view):
    """(source, arrays, sphere diameter, shutter time, arrow factor, colour limits) of the injection."""
    wall = pv.Show(pv.OpenDataFile(os.path.join(folder, "chamber.vtk")), view)
    wall.SetRepresentationType("Ray Traced Surface")
    wall.ColorArrayName, wall.DiffuseColor, wall.AmbientColor = [None, ""], [0.75, 0.78, 0.8], [0.75, 0.78, 0.8]
    series = pv.OpenDataFile(os.path.join(folder, "injection.vtk.series"))
    view.ViewTime = series.TimestepValues[-1]
    pv.UpdatePipeline(view.ViewTime, series)
    simulation.look(view, (1.75, 5.2, 1.5), (1.75, 0.0, -0.04), (0.0, 0.0, 1.0))
    return series, ("velocity", "acceleration"), 0.022, 0.05, 0.03, (0.0, 6.0)


def can(path, view):
    """The same of the crushed can."""
    source = pv.OpenDataFile(path)
    source.UpdatePipeline()
    simulation.look(view, (-15.5, -20.5, -3.0), (-3.4, 1.0, -16.2), (0.0, 0.0, 1.0))
    return source, ("VEL", "ACCL"), 0.1, 1.5e-4, 1.2e-4, (2000.0, 5000.0)


def show(look, source, arrays, diameter, shutter, factor, limits, view):
    """One of the three looks."""
    velocity, acceleration = arrays
    if look == "arrows":
        shown = simulation.show(source, view, "Arrow", GlyphOrient=1, GlyphOrientationArray=velocity,
                                GlyphScaling=1, GlyphScaleArray=velocity, GlyphScaleMode="Magnitude", GlyphScaleFactor=factor)
    else:
        shown = simulation.show(source, view, "Sphere", GlyphOrient=0, GlyphScaleFactor=diameter, MotionBlur=1,
                                VelocityArray=velocity, ShutterTime=shutter, ShutterOpening="Forward",
                                AccelerationArray=acceleration if look == "acceleration" else "None")
    shown.SamplesPerPixel = 64
    pv.ColorBy(shown, ("POINTS", velocity, "Magnitude"), True)
    table = pv.GetColorTransferFunction(velocity, shown, separate=True)
    table.ApplyPreset("Plasma (matplotlib)", True)
    table.RescaleTransferFunction(*limits)


def main():
    """Makes three pictures."""
    data, folder = simulation.begin()
    size = [int(value) for value in sys.argv[3:5]] or [1000, 700]
    name, load = ("can", can) if os.path.isfile(data) else ("injection", chamber)
    for look in ("arrows", "velocity", "acceleration"):
        view = simulation.new_view(size)
        show(look, *load(data, view), view)
        simulation.save(view, folder, "%s-%s" % (name, look), size)
    pv.Disconnect()


if __name__ == "__main__":
    main()
