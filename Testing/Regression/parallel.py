"""Glyphs on several ranks: the picture is that of one rank, also in the light that glyphs and surfaces of different ranks take from each
other, and no point of a structured data set has two glyphs.

Usage: mpiexec -n RANKS pvbatch parallel.py DATA-FOLDER
On one rank the pictures are stored; on several they are compared with the stored ones.
"""
import ctypes
import json
import sys

import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import accumulation
import comparison
import session
import step_velocity

SIDE = 11
#: fraction of the pixels that may differ, of two ranks, where smooth edges of different ranks' glyphs cross, or lie before another rank's rasterized surface
CROSSING, RASTERIZED = 0.001, 0.002
#: the same where glyphs of different ranks cut each other everywhere
CUTTING = 0.01


def look_at_cube(view):
    """A slanted look at the wavelet."""
    session.look(view, (11.0, 8.0, 24.0))


def structured(view):
    """Spheres at the points of an image, whose pieces share the points between them, and a cut through them."""
    half = SIDE // 2
    wavelet = pv.Wavelet(WholeExtent=[-half, half] * 3)
    shown = session.glyphs(wavelet, view, "Sphere", Orient=0, ScaleFactor=0.9, Section="Plane", SectionOrigin=[0.0, 0.0, 2.2], SectionNormal=[0.2, 0.1, 1.0])
    pv.ColorBy(shown, ("POINTS", "RTData"))
    shown.SetScalarBarVisibility(view, False)
    look_at_cube(view)
    return shown


def vectors(view):
    """Arrows on the same image, scaled, turned and colored by a vector array, with the key; some are much longer than others."""
    half = SIDE // 2
    wavelet = pv.Wavelet(WholeExtent=[-half, half] * 3)
    calculator = pv.Calculator(Input=wavelet, ResultArrayName="flow", Function="coordsY*iHat-coordsX*jHat+coordsZ*kHat")
    shown = session.glyphs(calculator, view, "Arrow", ArrowHeads="Fixed", SelectOrientationVectors="flow", ScaleMode="Magnitude", SelectScaleArray="flow",
                           ScaleFactor=0.35, **{"GlyphType.TipRadius": 0.25, "GlyphType.ShaftRadius": 0.1})
    shown.GlyphDirectionColoring = "Sphere"
    look_at_cube(view)
    return shown


def tensors(view):
    """Tensors on the same image, of which one rank has those with the largest eigenvalues, which color all."""
    half = SIDE // 2
    wavelet = pv.Wavelet(WholeExtent=[-half, half] * 3)
    stress = pv.Calculator(Input=wavelet, ResultArrayName="stress", Function="(16+coordsX+coordsY+coordsZ)*iHat+(8+coordsY)*jHat-(5+coordsX)*kHat")
    shear = pv.Calculator(Input=stress, ResultArrayName="shear", Function="coordsZ*iHat-coordsY*jHat+coordsX*kHat")
    shown = session.glyphs(shear, view, "Tensor Ellipsoid", GlyphTensorArray="stress, shear", ScaleFactor=0.05,
                           GlyphTensorColoring="Eigenvalues")
    look_at_cube(view)
    return shown


def see_through(view):
    """The same, of the opacities that a table gives their largest eigenvalues."""
    shown = tensors(view)
    table = pv.GetColorTransferFunction("see through")
    table.RGBPoints, table.EnableOpacityMapping = [0.0, 1.0, 0.3, 0.0, 30.0, 0.0, 0.3, 1.0], 1
    table.ScalarOpacityFunction = pv.GetOpacityTransferFunction("see through")
    table.ScalarOpacityFunction.Points = [0.0, 0.3, 0.5, 0.0, 30.0, 0.6, 0.5, 0.0]
    shown.GlyphTensorColoring, shown.GlyphTensorLookupTable = "Major Eigenvalue", table
    return shown


def unstructured(view, folder):
    """The particles of the simulation, spread over the ranks, and an opaque surface of their own in between."""
    spread = session.spread(folder + "/impact/impact_04.vtk")
    shown = session.glyphs(spread, view, "Sphere", Orient=0, SelectScaleArray="diameter",
                           ScaleMode="Magnitude", ScaleFactor=1.0)
    session.solid(shown, (0.9, 0.7, 0.3))
    ball = pv.Sphere(Center=[14.0, 14.0, 4.0], Radius=8.0, ThetaResolution=64, PhiResolution=64)
    surface = pv.Show(ball, view)
    surface.SetRepresentationType("Surface")
    session.solid(surface, (0.2, 0.5, 0.3))
    session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 4.0), (0.0, 0.0, 1.0))
    return shown


#: Points on screws about the x axis, of which each rank has some whatever their places
SCREWS = """
import numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
time, number = self.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()), numpy.arange(90)
angle = 0.3 * time + number
points = numpy.stack([0.2 * number - 9.0 + 0.3 * time, 4.0 * numpy.cos(angle), 4.0 * numpy.sin(angle)], axis=1)
arrays, mine = {"number": number}, slice(90 * rank // ranks, 90 * (rank + 1) // ranks)
self.GetOutput().GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
"""


def trails(view):
    """Balls that come from earlier steps."""
    times = [float(time) for time in range(8)]
    shown = session.glyphs(session.points_of_ranks(SCREWS, step_velocity.INFORMATION % (times, times[0], times[-1])), view, "Sphere", Orient=0,
                           ScaleFactor=0.8, TrailSteps=5, PointIdArray="number")
    pv.ColorBy(shown, ("POINTS", "number"))
    shown.SetScalarBarVisibility(view, False)
    view.ViewTime = 6.0
    look_at_cube(view)
    return shown


def cluster(view):
    """A valley of spheres, whose slopes are different ranks', with a slit across, and a surface through them."""
    half = SIDE // 2
    wavelet = pv.Wavelet(WholeExtent=[-half, half] * 3)
    contour = pv.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[200.0])
    kept = pv.Calculator(Input=wavelet, ResultArrayName="kept", Function="if(coordsY<1.5*abs(coordsZ)-3,1,0)")
    shown = session.glyphs(kept, view, "Sphere", Orient=0, ScaleMode="Magnitude", SelectScaleArray="kept", ScaleFactor=0.9, samples=1,
                           Section="Plane", SectionInvert=0, SectionThickness=0.4, SectionOrigin=[0.2, 0.0, 0.0])
    session.solid(shown, (0.9, 0.9, 0.9))
    surface = pv.Show(contour, view)
    surface.SetRepresentationType("Ray Traced Surface")
    session.solid(surface, (0.9, 0.6, 0.3))
    shown.ShadingMode = "Ambient Occlusion"
    session.look(view, (20.0, 16.0, 6.0))
    return shown


def statistic(shown, name):
    """A number of RenderStatistics, which is the sum over all ranks."""
    return json.loads(shown.GetPropertyValue("RenderStatistics"))[name]


def together(view, ranks, failures):
    """Counts and limits hold for all ranks together."""
    half = SIDE // 2
    # The other one asks for ghosts, which mark the points beyond those that two pieces share.
    plain, ghosts = (pv.Wavelet(WholeExtent=[-half, half] * 3) for _ in range(2))
    for source in (plain, pv.Gradient(Input=ghosts, ScalarArray=["POINTS", "RTData"])):
        shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.4, samples=1)
        # Translucent ones are distributed anew: those of the lattice's middle lie where it is cut.
        for mask, wanted, opacity in ((0, SIDE**3, 1.0), (0, SIDE**3, 0.5), (1, 300, 1.0)):
            shown.GlyphMode = "Random" if mask else "All Points"
            shown.Opacity = opacity
            shown.MaximumNumberOfGlyphs = wanted
            pv.Render(view)
            glyphs = statistic(shown, "glyphs")
            if not wanted - (ranks if mask else 1) < glyphs <= wanted:
                failures.append("%s: %d glyphs on %d ranks, %d wanted" % (source.SMProxy.GetXMLName(), glyphs, ranks, wanted))
        pv.Delete(shown)


def light(view, ranks, failures):
    """ParallelLight: bounded and unbounded occlusion, paths, shadows of lights."""
    shown = cluster(view)
    arrived = {}
    # Rays start from places that differ in their last bits, or, with copies of everything, in none.
    for mode, radius, parallel, allowed in (("Ambient Occlusion", 4.0, "Neighbors", 0.0005), ("Ambient Occlusion", 4.0, "Replicated", 0.0),
                                            ("Ambient Occlusion", 0.0, "Neighbors", 0.0005), ("Path Tracing", 0.0, "Neighbors", 0.001),
                                            ("Path Tracing", 0.0, "Replicated", 0.0), ("Shadows", 0.0, "Neighbors", 0.001),
                                            ("Shadows", 0.0, "Replicated", 0.0), ("Ambient Occlusion", 4.0, "Local", None)):
        shown.ShadingMode = {"Shadows": "Local"}.get(mode, mode)
        shown.Shadows = int(mode == "Shadows")
        shown.AmbientOcclusionRadius = radius
        shown.ParallelLight = parallel
        picture = "parallel-%s-%g" % (mode.lower().replace(" ", "-"), radius)
        if ranks == 1:
            pv.Render(view)
            session.capture(view, picture)
            continue
        pixels = session.capture(view, "%s-%d-ranks-%s" % (picture, ranks, parallel.lower()))
        share, mean, _ = comparison.difference(pixels, session.read_image(session.output(picture + ".png")))
        near = statistic(shown, "neighborGlyphs")
        print("%s, radius %g, %s: %.3f%% of the pixels differ, mean %.4f, %d glyphs of other ranks"
              % (mode, radius, parallel, 100 * share, mean, near))
        if allowed is None:
            if share < 0.01 or mean < 0.3:
                failures.append("without the other ranks' glyphs the light is the same, so nothing was tested")
        elif share > allowed or mean > 0.05:
            failures.append("%s, radius %g, %s: the light differs from that of one rank" % (mode, radius, parallel))
        if (near > 0) != (parallel == "Neighbors"):
            failures.append("%s, %s: %d glyphs came from other ranks" % (mode, parallel, near))
        if parallel == "Neighbors" and mode == "Ambient Occlusion":
            arrived[radius] = near
    if ranks > 1 and not arrived[4.0] < 0.9 * arrived[0.0]:
        failures.append("as many glyphs came from other ranks for a radius (%d) as for none (%d)" % (arrived[4.0], arrived[0.0]))


#: properties of displays of session.blocks_of_ranks(), and what colors them
BLOCK_STATES = {
    "plain": ({}, None),
    "hidden": ({"BlockSelectors": ["/Root/block0", "/Root/block2", "/Root/block3"]}, None),
    "looks": ({"BlockColors": ["/Root/block1", "0", "1", "0"], "BlockOpacities": ["/Root/block3", "0.4"]}, None),
    "height": ({}, ("POINTS", "height")),
    "bytes": ({"MapScalars": 0}, ("POINTS", "rgb")),
    "field data": ({}, ("FIELD", "material")),
    "sizes": ({"ScaleMode": "Magnitude", "SelectScaleArray": "height"}, None),
}


def block_pictures(name):
    """Blocks and arrays that only one rank has, as surfaces and, below, as glyphs: yields (name, view) in every state, opaque and not."""
    view = session.view(240, 120)
    blocks = session.blocks_of_ranks()
    lowered = pv.Transform(Input=blocks)
    lowered.Transform.Translate = [0.0, -1.0, 0.0]
    kinds = [session.show(blocks, view, "Ray Traced Surface", 1), session.glyphs(lowered, view, "Box", 1, Orient=0, ScaleFactor=0.4)]
    session.look(view, (2.0, 0.0, 5.0), (2.0, 0.0, 0.0), parallel_scale=1.1)
    for state, (properties, array) in BLOCK_STATES.items():
        for shown in kinds:
            shown.BlockSelectors, shown.BlockColors, shown.BlockOpacities, shown.MapScalars, shown.ScaleMode = ["/"], [], [], 1, "No Data Scaling Off"
            session.solid(shown, (0.8, 0.8, 0.8))
            shown.Ambient, shown.Diffuse = 1.0, 0.0
            for key, value in properties.items():
                setattr(shown, key, value)
            if array:
                table = pv.GetColorTransferFunction(array[1])
                table.RGBPoints = [0.0, 0.0, 0.0, 1.0, 4.0, 1.0, 0.0, 0.0]
                table.AutomaticRescaleRangeMode = "Never"
                shown.ColorArrayName, shown.LookupTable = list(array), table
        for opacity in (1.0, 0.5):
            for shown in kinds:
                shown.Opacity = opacity
            pv.Render(view)
            yield "%s-blocks-%s-%g" % (name, state.replace(" ", "-"), opacity), view
    pv.Delete(view)


def blocks(_, ranks, failures):
    """Blocks keep their visibility, colors and arrays, whichever rank has them."""
    for picture, view in block_pictures("parallel"):
        pixels = session.capture(view, picture + ("" if ranks == 1 else "-%d-ranks" % ranks))
        if ranks == 1:
            continue
        share, mean, _ = comparison.difference(pixels, session.read_image(session.output(picture + ".png")))
        print("%s: %.3f%% of the pixels differ, mean %.4f" % (picture, 100 * share, mean))
        if share > 0.0:
            failures.append("%s differs from one rank" % picture)


def words(view, ranks, failures):
    """A name that no rank has is one message of all; blocks that lack an array that another rank has are named."""
    path = session.output("parallel-words")
    script = """
from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
window = vtkFileOutputWindow()
window.SetFileName("%s-%%d-of-%%d" %% (rank, ranks))
window.FlushOn()
open(window.GetFileName(), "w").close()
vtkOutputWindow.SetInstance(window)
""" % path
    before = vtkOutputWindow.GetInstance()
    shown = session.glyphs(session.blocks_of_ranks(script), view, "Box", 1, Orient=0, ScaleMode="Magnitude", ScaleFactor=0.4)
    said = []
    for array in ("misspelled", "height"):
        shown.SelectScaleArray = array
        pv.Render(view)
        said.append([open("%s-%d-of-%d" % (path, rank, ranks), encoding="utf-8").read() for rank in range(ranks)])
    vtkOutputWindow.SetInstance(before)
    misspelled, height = "".join(said[0]), "".join(after[len(text):] for text, after in zip(*said))
    named = [height.count("'block%d'" % i) for i in range(4)]
    print("messages: %s%s" % (misspelled, height))
    if misspelled.count("Warning") != 1 or "There is no point array 'misspelled'" not in misspelled:
        failures.append("a misspelled array: %d messages" % misspelled.count("Warning"))
    if height.count("no array 'height'") != height.count("Warning") or named != [1, 0, 1, 1]:
        failures.append("an array of one block: messages do not name the others")
    pv.Delete(shown)


#: Small balls in a cube, of which the last rank has a few, too few to be joined
CLOUD = """
import numpy
points = numpy.random.default_rng(3).uniform(-1.0, 1.0, (20000, 3))
arrays, ends = {"number": numpy.arange(20000)}, [0] + [19990 * (part + 1) // (ranks - 1) for part in range(ranks - 1)] + [20000]
mine = slice(ends[rank], ends[rank + 1])
"""


def turning(view, ranks, failures):
    """While the camera is turned few glyphs stand for many, on each rank for its own; at rest all are there again."""
    for name, value in (("LODThreshold", 0.0), ("LODResolution", 0.03)):
        view.SMProxy.GetProperty(name).SetElement(0, value)
    view.SMProxy.UpdateVTKObjects()
    shown = session.glyphs(session.points_of_ranks(CLOUD), view, "Sphere", 1, Orient=0, ScaleMode="No Data Scaling Off", ScaleFactor=0.02)
    session.look(view, (1.2, 0.9, 4.6))
    for light in ("Local", "Replicated"):
        shown.ParallelLight = light
        pv.Render(view)
        still = session.capture(view, "parallel-still-%d-ranks" % ranks)
        view.SMProxy.InteractiveRender()
        turned = accumulation.shown_by(view)
        few = shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(1) # of the first rank
        comparison.write_image(session.output("parallel-turned-%d-ranks.png" % ranks), turned)
        pv.Render(view)
        again = int((session.capture(view, "parallel-again-%d-ranks" % ranks) != still).any(-1).sum())
        covered, apart = (comparison.covered(picture)[50:150, 100:200] for picture in (turned, still))
        ratio, left = covered.mean() / apart.mean(), few.GetNumberOfPoints() if few else 0
        print("%d ranks, %s: %d points are turned, what they cover %.3f; %d pixels differ at rest" % (ranks, light, left, ratio, again))
        if not 100 < left < 1000 or not 0.8 < ratio < 1.3 or again: # a moving picture is coarser
            failures.append("turning, %s: %d points are turned, what they cover %.3f; %d pixels differ at rest" % (light, left, ratio, again))
        if statistic(shown, "glyphs") != 20000 * (ranks if light == "Replicated" else 1):
            failures.append("after turning, %s: %d glyphs of 20000" % (light, statistic(shown, "glyphs")))
    pv.Delete(shown)


def number_of_points(shown):
    """Points that carry glyphs, over all ranks."""
    return shown.GetRepresentedDataInformation().GetNumberOfPoints()


def exchanged(view):
    """Numbers that this rank has reduced with others for a frame of which nothing but the camera is new (SleepingRanks.cxx)."""
    counter = ctypes.c_long.in_dll(ctypes.CDLL(None), "rtglyphs_reduced_values")
    view.GetActiveCamera().Azimuth(10.0)
    before = counter.value
    pv.Render(view)
    view.GetActiveCamera().Azimuth(-10.0)
    return counter.value - before


def main(folder):
    """Every scene, with one ray through each pixel and with smooth edges."""
    pv._DisableFirstRenderCameraReset()
    session.load()
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    failures = []
    scenes = (("structured", structured, SIDE**3, CROSSING), ("vectors", vectors, SIDE**3, CROSSING), ("tensors", tensors, SIDE**3, CUTTING),
              ("see-through", see_through, SIDE**3, CUTTING),
              ("trails", trails, 90, CROSSING), ("unstructured", lambda view: unstructured(view, folder), None, RASTERIZED))
    for name, scene, points, edges in scenes:
        view = session.view(300, 200)
        shown = scene(view)
        # Translucent glyphs that lie where the data are cut are in front of or behind a whole rank's.
        for samples, replicate, allowed in ((1, 0, edges if scene is see_through else 0.0), (16, 0, edges * ranks / 2), (16, 1, 0.0)):
            shown.SamplesPerPixel = samples
            shown.ParallelLight = "Replicated" if replicate else "Local"
            pv.Render(view)
            picture = "parallel-%s-%d" % (name, samples)
            name_here = picture + ("" if ranks == 1 else "-%d-ranks%s" % (ranks, "-replicated" if replicate else ""))
            pixels = session.capture(view, name_here)
            if ranks == 1:
                continue
            share, mean, apart = comparison.difference(pixels, session.read_image(session.output(picture + ".png")))
            print("%s: %.3f%% of the pixels differ by more than %d, mean %.4f"
                  % (name_here, 100 * share, comparison.LEVELS, mean))
            if share > allowed:
                comparison.write_image(session.output(name_here + "-difference.png"), 4 * apart)
                failures.append(name_here + " differs from one rank")
        frame = exchanged(view) if ranks > 1 else 0
        print("%s: %d numbers reduced for a frame" % (name, frame))
        if frame > 500:
            failures.append("%s: ranks reduce %d numbers for a frame in which only the camera is new" % (name, frame))
        if points and number_of_points(shown) != points:
            failures.append("%s: %d glyphs, %d points" % (name, number_of_points(shown), points))
        pv.Delete(view)
    for check in (light, together, blocks, words, turning):
        view = session.view(300, 200)
        check(view, ranks, failures)
        pv.Delete(view)
    # The script ends by itself: leaving early, MPI would call it a failure.
    for failure in failures:
        print("FAILED:", failure)
    print("PARALLEL TEST " + ("FAILED" if failures else "PASSED"))


if __name__ == "__main__":
    main(sys.argv[1])
