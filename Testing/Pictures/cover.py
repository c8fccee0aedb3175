"""The pictures at the head of the README, which demo.sh draws, and others of the gallery: from data to figures for print.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython cover.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT [NAME...]]      (default: 1600 1000 and the first four)
What DATA-FOLDER lacks is made in the output folder by the scripts there.
"""
import math
import os
import subprocess
import sys

import numpy
import paraview.simple as pv

import simulation
from simulation import EMBER, RAINBOW

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin"))
import raytracedglyphs  # noqa: E402

SIZE = [int(value) for value in sys.argv[3:5]] or [1600, 1000]
#: Arnold, Beltrami and Childress: a flow along which the vorticity is the velocity
FLOW = "iHat*(sin(0.4*coordsZ)+0.7*cos(0.4*coordsY))+jHat*(0.8*sin(0.4*coordsX)+cos(0.4*coordsZ))+kHat*(0.7*sin(0.4*coordsY)+0.8*cos(0.4*coordsX))"


def made(script, path, *numbers, source=()):
    """The file or folder that a script of the data folder makes."""
    subprocess.run(["/usr/bin/python3", os.path.join(sys.argv[1], script), *source, path, *numbers], check=True)
    return path


def at(time, *path):
    """A series, and all views, at a time; -1: the last."""
    source = pv.OpenDataFile(os.path.join(*path))
    pv.GetAnimationScene().AnimationTime = source.TimestepValues[-1] if time < 0 else time
    return source


def figure(source, kind, samples=16, camera=None, up=(0.0, 0.0, 1.0), angle=30.0, lens=0.0, bar=None, **properties):
    """raytracedglyphs.Figure() with few samples, whose noise is smoothed. camera: position, focal point. lens: its diameter; it is focused on the
    focal point. bar: array, least and largest value, title, colors, place."""
    shown = raytracedglyphs.Figure(source, kind, size=SIZE, colors=bar[0] if bar else "", SamplesPerPixel=samples, Denoising="Always", **properties)
    view = pv.GetActiveView()
    if bar:
        array, limits, title, colors, place = bar
        simulation.scalar_bar(pv.GetColorTransferFunction(array), shown, view, limits, colors, title, place)
    if camera:
        simulation.look(view, *camera, up)
        view.CameraViewAngle, view.CameraFocalDisk = angle, lens
        view.CameraFocalDistance = math.dist(*camera)
    return shown


def vessel(data, folder):
    """Arrows of particles that are blown into a chamber, path traced."""
    folder = made("injection.py", os.path.join(folder, "injection"), "36", "5000")
    series = at(-1, folder, "injection.vtk.series")
    figure(pv.OpenDataFile(os.path.join(folder, "chamber.vtk")), "Surface", quality="Path Tracing", DiffuseColor=[0.86, 0.87, 0.89], Exposure=0.4,
           Section="Plane", SectionOrigin=[0.0, 0.0, -0.5], SectionNormal=[0.0, 0.0, -1.0])  # lets light in from above
    figure(series, "Arrow", samples=12, view=pv.GetActiveView(), quality="Path Tracing", bar=("velocity", (0.0, 5.0), "speed", RAINBOW, (0.62, 0.02)), Orient=1, Scaling=1,
           SelectOrientationVectors="velocity", ScaleMode="Magnitude", SelectScaleArray="velocity", ScaleFactor=0.045, ArrowHeads="Fixed", ArrowReferenceMagnitude=2.2,
           camera=((1.2, 5.6, -3.4), (1.62, 0.0, 0.11)), up=(0.0, 0.0, -1.0), angle=21.5,
           **{"GlyphType.ShaftRadius": 0.06, "GlyphType.TipRadius": 0.16, "GlyphType.TipLength": 0.45})


def grains(data, time, camera, sharp="", **properties):
    """Grains that a ball has hit, by speed, on a ground that catches their shadows. sharp: a condition; grains for which it holds are not blurred."""
    shown = at(time, data, "impact", "impact.vtk.series")
    if sharp:
        shown = pv.Calculator(Input=shown, ResultArrayName="context", Function="if(%s,0,1)" % sharp)
        properties["MotionBlurMask"] = "context"
    figure(shown, "Sphere", camera=camera, bar=("velocity", (0.0, 8.0), "speed", EMBER, (0.63, 0.86)), Orient=0,
           ScaleMode="Magnitude", SelectScaleArray="diameter", ScaleFactor=1.0, GroundShadow="Below", **properties)


def impact(data, _):
    """The grains at one moment."""
    grains(data, 0.8, ((9.0, -36.0, 25.0), (14.3, 14.0, 3.2)), angle=26.0)


def motion(data, _, **properties):
    """The grains while the shutter is open: streaks show how fast and where to."""
    grains(data, 0.8, ((9.0, -34.0, 15.0), (14.6, 14.0, 5.3)), samples=32, angle=28.8, MotionBlur=1, VelocityArray="velocity", ShutterTime=0.25, **properties)


def context(data, folder):
    """Most grains blurred, so that where they go is seen; those of interest sharp."""
    motion(data, folder, sharp="id-9*floor(id/9)<1")


def trails(data, _):
    """Grains that the ball has thrown up, and where they were in the steps before."""
    grains(data, 1.2, ((9.0, -38.0, 14.0), (14.3, 14.0, 7.6)), angle=32.0, TrailSteps=4, PointIdArray="id")


def periodic(data, _):
    """Molecules of a liquid crystal, in color, and one image of their periodic box on either side, along two edges."""
    figure(at(-1, data, "nematic", "nematic.vtk.series"), "Sphere", Orient=1, SelectOrientationVectors="quaternion", OrientationMode="Quaternion", SelectScaleArray="shape",
           ScaleMode="Vector Components", ScaleFactor=1.0, GlyphDirectionColoring="Axes", PeriodicBoundary=1, PeriodicImages=[1, 1, 0],
           camera=((60.0, -48.0, 60.0), (12.6, 11.6, 10.5)), angle=28.0)


def wrapped(*_):
    """Balls that fly through the sides of a periodic box while the shutter is open: streaks are whole on both sides of each border."""
    random = numpy.random.default_rng(8)
    places, way = random.uniform(-0.5, 0.5, (60, 3)) * (1.6, 1.0, 0.3), numpy.array([0.5, 0.22, 0.0])
    balls = simulation.source(places, velocity=way + random.normal(scale=0.1, size=(60, 3)), y=places[:, 1], size=numpy.full(60, 0.07))
    figure(balls, "Sphere", samples=48, bar=("y", (-0.5, 0.5), "y", RAINBOW, (0.63, 0.02)), Orient=0, ScaleMode="Magnitude", SelectScaleArray="size", ScaleFactor=1.0, GroundShadow="None", PeriodicBoundary=1,
           PeriodicVectors=[1.6, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.3], PeriodicImages=[1, 1, 0], MotionBlur=1, VelocityArray="velocity", ShutterTime=0.25, ShutterOpening="Forward",
           camera=((0.0, 0.0, 4.5), (0.0, 0.0, 0.0)), up=(0.0, 1.0, 0.0), angle=26.0)
    box = pv.Show(pv.Box(XLength=1.6, YLength=1.0, ZLength=0.3), pv.GetActiveView(), Representation="Outline")
    box.AmbientColor, box.LineWidth = [0.3] * 3, 2.0


def fibers(_, folder):
    """Diffusion tensors of a bundle of fibers along a helix, by principal direction, with occlusion and shadows."""
    inside = pv.Threshold(Input=pv.OpenDataFile(made("helix.py", os.path.join(folder, "helix.vtk"), "40")),
                          Scalars=["POINTS", "bundle"], LowerThreshold=0.5, UpperThreshold=1.0)
    figure(inside, "Tensor Superquadric", samples=14, GlyphTensorArray="diffusion", GlyphTensorLayout="xx yy zz xy yz xz", GlyphDirectionColoring="Axes", ScaleFactor=0.055,
           GroundShadow="Below", camera=((1.9, -3.6, -0.9), (-0.02, 0.0, 0.03)), up=(1.0, 0.0, 0.0), angle=26.5)


def chains(data, folder):
    """Chains of forces between the grains that a ball has just hit, through a lens that is focused on it."""
    file = made("contacts.py", os.path.join(folder, "contacts.vtk"), source=[os.path.join(data, "impact", "impact_02.vtk")])
    strong = pv.Threshold(Input=pv.OpenDataFile(file), Scalars=["CELLS", "force"], LowerThreshold=40.0, UpperThreshold=1e9)
    thick = pv.Calculator(Input=strong, AttributeType="Cell Data", ResultArrayName="root", Function="sqrt(force)")
    figure(thick, "Tubes", samples=32, bar=("force", (0.0, 990.0), "force between two grains", EMBER, (0.63, 0.86)), TubeRadiusArray="root", TubeRadius=0.008,
           GroundShadow="Below", camera=((8.6, -15.2, 13.0), (14.2, 13.5, 2.2)), angle=25.0, lens=1.0)


def stress(data, _):
    """Stress of the grains that bear most of the ball: how large by size and color, of which kind by shape."""
    hit = pv.OpenDataFile(os.path.join(data, "impact", "impact_02.vtk"))
    pressure = pv.Calculator(Input=hit, ResultArrayName="pressure", Function="-(stress_XX+stress_YY+stress_ZZ)/3")
    loaded = pv.Threshold(Input=pressure, Scalars=["POINTS", "pressure"], LowerThreshold=25.0, UpperThreshold=3000.0)
    figure(loaded, "Signed Tensor Superquadric", GlyphTensorArray="stress", GlyphTensorLayout="xx yy zz xy xz yz", GlyphScaleFunction="Cube Root", ScaleFactor=0.16,
           bar=("pressure", (0.0, 350.0), "pressure", EMBER, (0.63, 0.86)), GroundShadow="Below", camera=((8.6, -20.2, 18.0), (14.2, 13.5, 1.0)), angle=25.0)


def packing(_, folder):
    """Superquadrics that do not touch, cut open by a plane: the cut faces are exact, too. Lines are drawn around what is large enough for them."""
    figure(pv.OpenDataFile(made("packing.py", os.path.join(folder, "packing.vtk"))), "Superquadric", GlyphExponentArray="exponents", SelectScaleArray="lengths",
           ScaleMode="Vector Components", ScaleFactor=1.0, Orient=1, SelectOrientationVectors="quaternion", OrientationMode="Quaternion",
           DiffuseColor=[0.42, 0.60, 0.78], Section="Plane", SectionOrigin=[0.5, 0.42, 0.5], SectionNormal=[0.25, -1.0, 0.35],
           SectionCaps="Colored Caps", SectionCapColor=[1.0, 0.72, 0.30], OutlineWidth=1.5, OutlineColor=[0.15, 0.2, 0.28],
           camera=((1.1, -1.3, 1.25), (0.5, 0.46, 0.51)), angle=35.0)


def superquadrics(*_):
    """Exponents from 0.4 to 20."""
    values, count = [0.4, 0.7, 1.0, 2.0, 4.0, 20.0], range(6)
    data = simulation.source(numpy.array([(1.12 * i, 0.0, 1.12 * j) for j in count for i in count]), exponents=numpy.array([(values[i], values[j]) for j in count for i in count]))
    figure(data, "Superquadric", GlyphExponentArray="exponents", ScaleFactor=1.0, Orient=0, Scaling=0, GroundShadow="Below", DiffuseColor=[0.86, 0.60, 0.25],
           camera=((0.2, -10.5, 5.0), (2.8, 0.0, 2.7)), angle=38.0)


def crossing(_, folder):
    """Orientation distribution functions of two bundles of fibers that cross, by direction."""
    voxels = pv.OpenDataFile(made("odf.py", os.path.join(folder, "odf.vtk"), "20"))
    share = pv.Calculator(Input=voxels, ResultArrayName="share", Function="fractions_X+fractions_Y")
    figure(pv.Threshold(Input=share, Scalars=["POINTS", "share"], LowerThreshold=0.3, UpperThreshold=1.0), "Spherical Harmonics",
           GlyphHarmonicsArray="odf", GlyphHarmonicsBasis="MRtrix3", GlyphScaleFunction="All the Same", ScaleFactor=1.15,
           GlyphDirectionColoring="Axes", GroundShadow="Across Z", camera=((20.0, -14.0, 20.0), (9.6, 9.3, 1.5)), angle=30.0)


def streamlines(*_):
    """A flow through a cube as tubes."""
    flow = pv.Calculator(Input=pv.Wavelet(WholeExtent=[-12, 12, -12, 12, -12, 12]), ResultArrayName="flow", Function=FLOW)
    lines = pv.StreamTracer(Input=flow, Vectors=["POINTS", "flow"], SeedType="Point Cloud", MaximumStreamlineLength=24.0)
    lines.SeedType.Center, lines.SeedType.Radius, lines.SeedType.NumberOfPoints = [0.0] * 3, 11.0, 120
    figure(lines, "Tubes", bar=("flow", (0.0, 2.4), "speed", RAINBOW, (0.63, 0.02)), TubeRadius=0.22, camera=((34.0, -42.0, 28.0), (0.0, 0.0, -0.5)), angle=30.0)


def detail(*_):
    """Arrows of a flow, and the few with which ParaView's level of detail replaces them while the camera is turned."""
    source, view = pv.Calculator(Input=pv.Wavelet(WholeExtent=[-15, 15, -13, 13, 0, 3]), ResultArrayName="flow", Function=FLOW), None
    for place in (0.0, 34.0):
        shown = figure(source, "Arrow", view=view, bar=("flow", (0.0, 2.4), "speed", RAINBOW, (0.63, 0.04)), Orient=1, Scaling=1, SelectOrientationVectors="flow",
                       ScaleMode="Magnitude", SelectScaleArray="flow", ScaleFactor=0.7, GroundShadow="None", Position=[place, 0.0, 0.0],
                       camera=((17.0, -29.0, 40.0), (17.0, -1.6, 0.0)), angle=45.0)
        view = pv.GetActiveView()
        view.LODThreshold, view.LODResolution = 0.0, 0.055
        pv.Render()
        view.SMProxy.InteractiveRender()
        source = simulation.session.source(shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(1))


#: the first four are those of the README and of demo.sh
PICTURES = {draw.__name__: draw for draw in (chains, fibers, vessel, motion, stress, packing, superquadrics, impact, context, trails, crossing, periodic, wrapped, streamlines, detail)}



def main():
    """Makes the pictures, the one that shows the most first."""
    data, folder = simulation.begin()
    for name in sys.argv[5:] or list(PICTURES)[:4]:
        PICTURES[name](data, folder)
        simulation.save(pv.GetActiveView(), folder, "cover-" + name, SIZE)
    pv.Disconnect()


if __name__ == "__main__":
    main()
