"""The pictures at the head of the README, and of demo.sh: the main job from simulation data to figures for print.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython cover.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT [NAME...]]      (default: 1200 900 and the first four)
What DATA-FOLDER lacks is made in the output folder by the scripts there.
"""
import os
import subprocess
import sys

import paraview.simple as pv

import simulation

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin"))
import raytracedglyphs  # noqa: E402

#: Speed from blue over green to red, none of them pale
SPEED = (0.0, 0.08, 0.30, 0.68, 0.3, 0.05, 0.55, 0.60, 0.6, 0.95, 0.70, 0.10, 1.0, 0.80, 0.10, 0.08)


def made(script, folder, *arguments):
    """Runs a script of the data folder with the output folder, or a file in it, as its first argument."""
    subprocess.run(["/usr/bin/python3", os.path.join(sys.argv[1], script), folder, *arguments], check=True)


def at(source, time):
    """The source at a time, of which all views show the same."""
    pv.GetAnimationScene().AnimationTime = time
    pv.UpdatePipeline(time, source)
    return source


def place(view, position, focus, up=(0.0, 0.0, 1.0), angle=30.0):
    """Sets the camera."""
    simulation.look(view, position, focus, up)
    view.CameraViewAngle = angle


def bar(view, array, limits, title, preset=None, where=(0.63, 0.86)):
    """Range, title and place of a scalar bar."""
    display = raytracedglyphs.Displays(view)[-1]
    table = pv.GetColorTransferFunction(array)
    simulation.scalar_bar(table, display, view, limits, preset or "Viridis", title, where)
    return table


def finish(display, samples):
    """Few samples, whose noise is smoothed."""
    display.SamplesPerPixel, display.Denoising = samples, "Always"


def vessel(data, folder):
    """Arrows of particles that are blown into a chamber, path traced."""
    made("injection.py", os.path.join(folder, "injection"), "36", "5000")
    wall = raytracedglyphs.Figure(pv.OpenDataFile(os.path.join(folder, "injection", "chamber.vtk")), "Surface", colors="", quality="Path Tracing",
                                  DiffuseColor=[0.80, 0.82, 0.85])
    view = pv.GetActiveView()
    series = pv.OpenDataFile(os.path.join(folder, "injection", "injection.vtk.series"))
    raytracedglyphs.Figure(at(series, series.TimestepValues[-1]), "Arrow", view=view, colors="velocity", quality="Path Tracing", Orient=1, Scaling=1,
                           SelectOrientationVectors="velocity", ScaleMode="Magnitude", SelectScaleArray="velocity", ScaleFactor=0.045, ArrowHeads="Fixed",
                           ArrowReferenceMagnitude=2.2, **{"GlyphType.ShaftRadius": 0.06, "GlyphType.TipRadius": 0.16, "GlyphType.TipLength": 0.45})
    bar(view, "velocity", (0.0, 5.0), "speed").RGBPoints = [value * (5.0 if i % 4 == 0 else 1.0) for i, value in enumerate(SPEED)]
    place(view, (1.75, 5.6, -1.6), (1.75, 0.0, 0.05), (0.0, 0.0, -1.0), 27.0)
    finish(wall, 16)


def grains(data, position, focus, samples, **properties):
    """Grains that a ball has hit, by speed, on a ground that catches their shadows."""
    source = at(pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series")), 0.8)
    shown = raytracedglyphs.Figure(source, "Sphere", colors="velocity", Orient=0, ScaleMode="Magnitude", SelectScaleArray="diameter", ScaleFactor=1.0,
                                   GroundShadow="Below", **properties)
    view = pv.GetActiveView()
    bar(view, "velocity", (0.0, 8.0), "speed", "Plasma")
    place(view, position, focus)
    finish(shown, samples)


def impact(data, _):
    """The grains at one moment."""
    grains(data, (9.0, -36.0, 27.0), (14.3, 14.0, 3.2), 16)


def motion(data, _):
    """The grains while the shutter is open: streaks show how fast and where to."""
    grains(data, (9.0, -30.0, 17.0), (14.3, 14.0, 5.0), 32, MotionBlur=1, VelocityArray="velocity", ShutterTime=0.25)


def fibers(data, folder):
    """Diffusion tensors of a bundle of fibers along a helix, by principal direction, with occlusion and shadows."""
    file = os.path.join(folder, "helix.vtk")
    made("helix.py", file)
    inside = pv.Threshold(Input=pv.OpenDataFile(file), Scalars=["POINTS", "bundle"], LowerThreshold=0.5, UpperThreshold=1.0)
    shown = raytracedglyphs.Figure(inside, "Tensor Superquadric", colors="", GlyphTensorArray="diffusion", GlyphTensorLayout="xx yy zz xy yz xz",
                                   GlyphDirectionColoring="Axes", GroundShadow="Below")
    shown.ScaleFactor = 1.8 * shown.ScaleFactor
    place(pv.GetActiveView(), (2.6, -3.0, 1.9), (0.0, 0.0, -0.05))
    finish(shown, 16)


def chains(data, folder):
    """Chains of forces between the grains that a ball has just hit."""
    file = os.path.join(folder, "contacts.vtk")
    subprocess.run(["/usr/bin/python3", os.path.join(data, "contacts.py"), os.path.join(data, "impact", "impact_02.vtk"), file], check=True)
    thick = pv.Calculator(Input=pv.LegacyVTKReader(FileNames=[file]), AttributeType="Cell Data", ResultArrayName="root", Function="sqrt(force)")
    shown = raytracedglyphs.Figure(thick, "Tubes", colors="force", TubeRadiusArray="root", TubeRadius=0.006, quality="Path Tracing")
    view = pv.GetActiveView()
    bar(view, "force", (0.0, 990.0), "force between two grains", "Plasma")
    place(view, (10.0, -12.0, 17.0), (12.9, 12.0, 5.5), angle=21.0)
    finish(shown, 16)


def packing(data, folder):
    """Superquadrics that do not touch, cut open by a plane: the cut faces are exact, too."""
    file = os.path.join(folder, "packing.vtk")
    made("packing.py", file)
    shown = raytracedglyphs.Figure(pv.OpenDataFile(file), "Superquadric", colors="", GlyphExponentArray="exponents", SelectScaleArray="lengths",
                                   ScaleMode="Vector Components", ScaleFactor=1.0, Orient=1, SelectOrientationVectors="quaternion", OrientationMode="Quaternion",
                                   DiffuseColor=[0.35, 0.55, 0.80], Section="Plane", SectionOrigin=[0.5, 0.42, 0.5], SectionNormal=[0.25, -1.0, 0.35],
                                   SectionCaps="Colored Caps", SectionCapColor=[0.95, 0.62, 0.25], OutlineWidth=1.0, GroundShadow="Below")
    place(pv.GetActiveView(), (2.0, -1.7, 1.75), (0.5, 0.52, 0.44))
    finish(shown, 16)


def crossing(_, folder):
    """Orientation distribution functions of two bundles of fibers that cross, by direction."""
    file = os.path.join(folder, "odf.vtk")
    made("odf.py", file, "20")
    shown = raytracedglyphs.Figure(pv.OpenDataFile(file), "Spherical Harmonics", colors="", GlyphHarmonicsArray="odf", GlyphHarmonicsBasis="MRtrix3")
    view = pv.GetActiveView()
    focus = list(view.CameraFocalPoint)
    place(view, [f + d for f, d in zip(focus, (5.0, -20.0, 22.0))], focus, angle=28.0)
    finish(shown, 16)


#: the first four are those of the README and of demo.sh
PICTURES = {"packing": packing, "chains": chains, "impact": impact, "motion": motion, "fibers": fibers, "vessel": vessel, "crossing": crossing}


def main():
    """Makes the pictures, the one that shows the most first."""
    data, folder = simulation.begin()
    size = [int(value) for value in sys.argv[3:5]] or [1200, 900]
    for name in sys.argv[5:] or list(PICTURES)[:4]:
        PICTURES[name](data, folder)
        view = pv.GetActiveView()
        view.ViewSize = size
        pv.Render(view)
        simulation.save(view, folder, "cover-" + name, size)
    pv.Disconnect()


if __name__ == "__main__":
    main()
