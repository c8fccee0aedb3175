"""Pictures of motion: arrows beside spheres that leave streaks, and an animation.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython motion.py DATASET OUTPUT-FOLDER [WIDTH HEIGHT [SAMPLES]] [--animation [FRAMES]]

DATASET: a folder by Data/injection.py, or can-vtu.hdf of VTK's test data (arrays VEL and ACCL). Of the injection there are pictures of
the whole chamber and of a part of it from near by. The looks are arrows; spheres that
move by their velocities only, which leaves even streaks; with the data's accelerations; and braked: with accelerations opposite to the
velocities that would stop each sphere by the time the shutter closes, for streaks that thicken where the sphere goes. Of the can also: its
surface, moved by both.

--animation writes a frame of each of the first FRAMES time steps (default: all) into OUTPUT-FOLDER/frames instead, and an
animated picture of them, OUTPUT-FOLDER/injection.webp, with img2webp (Debian's package webp) when that is installed.
"""
import os
import shutil
import subprocess
import sys

import paraview.simple as pv

import simulation

LOOKS = ("arrows", "velocity", "acceleration", "braked")
#: Camera, focal point, up.
WHOLE = ((1.75, 4.9, -0.8), (1.75, 0.0, 0.05), (0.0, 0.0, -1.0))
NEAR = ((1.75, 2.3, -0.3), (1.75, 0.0, 0.0), (0.0, 0.0, -1.0))
#: Speed from blue over green to red, none of them as pale as the wall.
COLORS = (0.0, 0.08, 0.30, 0.68, 0.3, 0.05, 0.55, 0.60, 0.6, 0.95, 0.70, 0.10, 1.0, 0.80, 0.10, 0.08)


def chamber(folder, view):
    """(source, arrays, sphere diameter, shutter time, arrow factor, color limits) of the injection."""
    wall = pv.Show(pv.OpenDataFile(os.path.join(folder, "chamber.vtk")), view)
    wall.SetRepresentationType("Ray Traced Surface")
    wall.ColorArrayName, wall.DiffuseColor, wall.AmbientColor = [None, ""], [0.92, 0.93, 0.95], [0.92, 0.93, 0.95]
    wall.Ambient, wall.Diffuse = 0.4, 0.6
    series = pv.OpenDataFile(os.path.join(folder, "injection.vtk.series"))
    view.ViewTime = series.TimestepValues[-1]
    pv.UpdatePipeline(view.ViewTime, series)
    simulation.look(view, *WHOLE)
    return series, ("velocity", "acceleration"), 0.024, 0.07, 0.03, (0.0, 5.0)


def can(path, view):
    """The same of the crushed can, which folds within a millisecond: its points lose much of their speed in half of one."""
    # Where parts hit each other a few points have accelerations a hundred times the others', which hold for much less time.
    source = pv.Calculator(Input=pv.OpenDataFile(path), ResultArrayName="ACCL limited", Function="ACCL*min(1,1.2e7/mag(ACCL))")
    source.UpdatePipeline()
    simulation.look(view, (-12.0, -5.0, 10.0), (-3.5, 0.4, -16.0), (0.0, 1.0, 0.0))
    return source, ("VEL", "ACCL limited"), 0.25, 5e-4, 4e-4, (2000.0, 5000.0)


def show_can(look, path, view):
    """One of the looks of the can: what moves, on its surface at rest; or its surface itself."""
    source, arrays, *how = can(path, view)
    wall = pv.Show(source, view)
    wall.SetRepresentationType("Ray Traced Surface")
    if look == "surface":
        wall.MotionBlur, wall.VelocityArray, wall.AccelerationArray = 1, arrays[0], arrays[1]
        wall.ShutterTime, wall.ShutterOpening = 0.5 * how[1], "Forward"
        color_by_speed(wall, arrays[0], how[3])
        return wall
    wall.ColorArrayName, wall.DiffuseColor, wall.AmbientColor = [None, ""], [0.92, 0.93, 0.95], [0.92, 0.93, 0.95]
    # A second representation of the same source needs a source of its own.
    shown = show(look, pv.Calculator(Input=source, ResultArrayName="unused", Function="1"), arrays, *how, view)
    shown.GlyphMode, shown.MaximumNumberOfGlyphs = "Random", 1500
    return shown


def show(look, source, arrays, diameter, shutter, factor, limits, view):
    """One of the looks."""
    velocity, acceleration = arrays
    if look == "braked":
        # Twice the time, so that a sphere goes as far as without brakes.
        shutter, acceleration = 2.0 * shutter, "braking"
        source = pv.Calculator(Input=source, ResultArrayName=acceleration, Function="%s*%.9g" % (velocity, -1.0 / shutter))
    if look == "arrows":
        shown = simulation.show(source, view, "Arrow", ArrowHeads="Fixed", Orient=1, SelectOrientationVectors=velocity,
                                SelectScaleArray=velocity, ScaleMode="Magnitude", ScaleFactor=factor,
                                **{"GlyphType.ShaftRadius": 0.06, "GlyphType.TipRadius": 0.16})
    else:
        shown = simulation.show(source, view, "Sphere", Orient=0, ScaleFactor=diameter, MotionBlur=1,
                                VelocityArray=velocity, ShutterTime=shutter, ShutterOpening="Forward",
                                AccelerationArray="None" if look == "velocity" else acceleration)
    color_by_speed(shown, velocity, limits)
    return shown


def color_by_speed(shown, velocity, limits):
    """Colors by the magnitude of the velocity."""
    pv.ColorBy(shown, ("POINTS", velocity, "Magnitude"), True)
    table = pv.GetColorTransferFunction(velocity, shown, separate=True)
    table.RGBPoints, table.ColorSpace = list(COLORS), "RGB"
    table.RescaleTransferFunction(*limits)


def pictures(data, folder, size, samples):
    """All looks from near by; of the whole injection arrows and blur."""
    if os.path.isfile(data):
        for look in LOOKS[:3] + ("surface",):
            view = simulation.new_view(size)
            show_can(look, data, view).SamplesPerPixel = samples
            simulation.write(view, folder, "can-%s" % look, size)
            pv.Delete(view)
        return
    for look in LOOKS:
        view = simulation.new_view(size)
        shown = show(look, *chamber(data, view), view)
        shown.SamplesPerPixel = samples
        if look in ("arrows", "acceleration"):
            simulation.write(view, folder, "injection-%s" % look, size)
        simulation.look(view, *NEAR)
        simulation.write(view, folder, "injection-%s-near" % look, [5 * pixels // 6 for pixels in size])
        pv.Delete(view)


def animation(data, folder, size, samples, frames):
    """Frames of blurred spheres, and an animated picture of them."""
    view = simulation.new_view(size)
    series, *how = chamber(data, view)
    how[2] = series.TimestepValues[1] - series.TimestepValues[0]  # the shutter is open from frame to frame
    shown = show("acceleration", series, *how, view)
    shown.SamplesPerPixel = samples
    shown.ShadingMode, shown.AmbientOcclusionRadius, shown.Denoising = "Ambient Occlusion", 0.5, "Always"
    frame_folder = os.path.join(folder, "frames")
    os.makedirs(frame_folder, exist_ok=True)
    written = []
    for number, time in enumerate(series.TimestepValues[:frames]):
        view.ViewTime = time
        written.append(simulation.write(view, frame_folder, "injection-%03d" % number, size))
    tool = shutil.which("img2webp")
    if not tool:
        print("img2webp is not installed (Debian's package webp), so there are only the frames")
        return
    picture = os.path.join(folder, "injection.webp")
    subprocess.run([tool, "-loop", "0", "-mixed", "-d", "60", "-lossy", "-q", "60", "-m", "6"] + written + ["-o", picture],
                   check=True)
    print("wrote %s, %d kB" % (picture, os.path.getsize(picture) // 1000))


def main():
    """Makes the pictures, or the animation."""
    moving = "--animation" in sys.argv
    frames = None
    if moving:
        at = sys.argv.index("--animation")
        rest = sys.argv[at + 1:]
        frames = int(rest[0]) if rest else None
        del sys.argv[at:]
    data, folder = simulation.begin()
    numbers = [int(value) for value in sys.argv[3:6]]
    size = numbers[:2] or ([640, 300] if moving else [720, 336])
    samples = numbers[2] if len(numbers) > 2 else (16 if moving else 48)
    if moving:
        animation(data, folder, size, samples, frames)
    else:
        pictures(data, folder, size, samples)
    pv.Disconnect()


if __name__ == "__main__":
    main()
