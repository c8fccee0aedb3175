"""ScaleFactorFromData: what the data suggest is ScaleFactor from the first render on, is chosen anew when it
should be, and a user's ScaleFactor takes precedence.

Usage: RTGLYPHS_DATA=FOLDER pvpython scale_guess.py
       mpiexec -n RANKS pvbatch scale_guess.py ranks
       pvpython scale_guess.py server PVSERVER [MPIEXEC ARGUMENT...]
The last two compare with what one rank without a server finds, which is written below.
"""
import os
import re
import sys

import numpy
import paraview.simple as pv
from paraview import smstate

import client_server
import comparison
import session
from checks import Checks

#: side of the grids, and their spacing
SIDE, SPACING = 8, 0.5
#: what the series below suggest: spheres on the grid, and on the grid scaled by 2
PLAIN, SCALED = 0.45, 0.22

#: Points of a grid, of which each rank has every RANKS-th; time -> (side of the grid, array s).
GRID = """
import numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkParallelCore import vtkMultiProcessController
steps = %r
info = self.GetOutputInformation(0)
wanted = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) if info.Has(
    vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) else 0.0
time, side, s = [step for step in steps if step[0] <= wanted][-1]
controller = vtkMultiProcessController.GetGlobalController()
line = %r * numpy.arange(side)
at = numpy.array([(x, y, z) for x in line for y in line for z in line]).reshape(-1, 3)
at = at[controller.GetLocalProcessId()::controller.GetNumberOfProcesses()]
points = vtkPoints()
points.SetData(numpy_to_vtk(at, deep=True))
output = self.GetOutputDataObject(0)
output.SetPoints(points)
array = numpy_to_vtk(numpy.full(len(at), s, dtype=float), deep=True)
array.SetName("s")
output.GetPointData().AddArray(array)
"""

TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
info = self.GetOutputInformation(0)
info.Remove(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
info.Remove(vtkStreamingDemandDrivenPipeline.TIME_RANGE())
for time in %r:
    info.Append(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), time)
for time in (%r, %r):
    info.Append(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), time)
"""


def series(*steps):
    """A source of such steps."""
    times = [float(step[0]) for step in steps]
    return pv.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=GRID % (steps, SPACING),
                                 ScriptRequestInformation=TIMES % (times, times[0], times[-1]))


def grid(spacing=SPACING, side=SIDE):
    """Points of a grid."""
    line = spacing * numpy.arange(side)
    return numpy.array([(x, y, z) for x in line for y in line for z in line])


def data(spacing=SPACING):
    """The grid with arrays: s is 2, t is 0.01, v has length 4, tensor has the eigenvalues 5, 1, 1."""
    points = grid(spacing)
    count = len(points)
    return session.poly_data(points, s=numpy.full(count, 2.0), t=numpy.full(count, 0.01), v=numpy.tile([0.0, 4.0, 0.0], (count, 1)),
                             tensor=numpy.tile([1.0, 0, 0, 0, -5.0, 0, 0, 0, 1.0], (count, 1)))


def display(source, view, shape="Sphere", **properties):
    """Shows the source and renders."""
    shown = session.glyphs(source, view, shape, **properties)
    pv.ResetCamera(view)
    pv.Render(view)
    return shown


def factor(shown, view=None):
    """The present factor, after a render."""
    if view:
        pv.Render(view)
    return round(shown.ScaleFactor, 12)


def first_picture(checks):
    """The first render already has the size; ResetCamera, too, knows of it."""
    view = session.view(200, 150)
    shown = session.glyphs(session.source(data()), view)
    pv.ResetCamera(view)
    pixels = session.capture(view, "scale-guess-first")
    counted = session.statistics(shown)
    checks.equal("builds of the first picture", (counted["instanceBuilds"], counted["boundsBuilds"]), (1, 1))
    checks.equal("factor", factor(shown), PLAIN)
    pv.ResetCamera(view)
    checks.true("the second picture is another one", (session.capture(view, "scale-guess-second") == pixels).all())
    shown.ScaleFactor = PLAIN / 2
    shown.ScaleFactor = PLAIN
    checks.true("set by hand, the picture is another one", (session.capture(view, "scale-guess-third") == pixels).all())
    pv.Delete(view)


def changes(checks):
    """Another array, shape, mode, function and other data choose anew; a script's number stays."""
    view = session.view(80, 60)
    source = session.source(data())
    shown = display(source, view)
    for name, value, wanted in (
            ("SelectScaleArray", "s", 0.45), ("ScaleMode", "Magnitude", SCALED), ("SelectScaleArray", "t", 45.0), ("SelectScaleArray", "v", 0.11),
            ("GlyphScaleFunction", "Square Root", SCALED), ("GlyphScaleFunction", "All the Same", 0.45), ("GlyphScaleFunction", "Linear", 0.11),
            ("ScaleMode", "No Data Scaling Off", 0.45), ("GlyphShape", "Capsule", SCALED), ("GlyphTensorArray", "tensor", SCALED),
            ("GlyphShape", "Tensor Ellipsoid", 0.09), ("GlyphShape", "None", 0.45), ("GlyphType", "Arrow", 0.7), ("GlyphType", "Sphere", 0.45),
            ("GlyphSizeRange", [0.1, 0.3], 0.45), ("Opacity", 0.5, 0.45), ("GlyphMode", "Random", 0.45), ("GlyphMode", "All Points", 0.45)):
        setattr(shown, name, value)
        found = factor(shown, view)
        checks.equal("factor after %s = %s" % (name, value), found, wanted)
    session.replace_data(source, data(3 * SPACING))
    checks.equal("factor of other data", factor(shown, view), 1.3)

    shown.ScaleFactor = 0.33
    checks.equal("ScaleFactorFromData after a factor was set", int(shown.ScaleFactorFromData), 0)
    shown.ScaleMode, shown.SelectScaleArray = "Magnitude", "t"
    session.replace_data(source, data())
    checks.equal("factor of a script, with another array and other data", factor(shown, view), 0.33)
    shown.ScaleFactorFromData = 1
    checks.equal("factor from the data again", factor(shown, view), 45.0)
    shown.ScaleFactor = 0.1
    pv.Render(view)
    # what the panel's button does, and takes over
    shown.SMProxy.GetProperty("ScaleFactor").ResetToDomainDefaults()
    shown.SMProxy.UpdateVTKObjects()
    checks.equal("ScaleFactorFromData after a reset", int(shown.ScaleFactorFromData), 1)
    checks.equal("factor after a reset", factor(shown, view), 45.0)
    pv.Delete(view)

    view = session.view(80, 60)
    shown = session.glyphs(session.source(data()), view, ScaleFactor=1.0)
    checks.equal("factor that was set before the first render", (factor(shown, view), int(shown.ScaleFactorFromData)), (1.0, 0))
    pv.Delete(view)


def steps(checks):
    """Glyphs do not pulse over the steps of an animation; the first step with glyphs counts, while they do not grow too far."""
    view = session.view(80, 60)
    shown = session.glyphs(series((0.0, 0, 0.0), (1.0, SIDE, 0.0), (2.0, SIDE, 2.0), (3.0, SIDE, 4.0), (4.0, SIDE // 2, 1.0)), view,
                           ScaleMode="Magnitude", SelectScaleArray="s", Orient=0)
    said = session.messages(lambda: pv.Render(view))
    checks.no_message("an empty first step", said)
    for time, wanted in ((0.0, 0.0), (1.0, 0.0), (2.0, SCALED), (3.0, SCALED), (4.0, SCALED), (0.0, SCALED), (3.0, SCALED)):
        view.ViewTime = time
        found = factor(shown, view) if wanted else shown.SMProxy.GetProperty("DataSummary").GetElement(0)
        checks.equal("factor at time %g" % time, found, wanted)
    shown.SMProxy.GetProperty("ScaleFactor").ResetToDomainDefaults()
    shown.SMProxy.UpdateVTKObjects()
    checks.equal("factor after a reset at time 3", factor(shown, view), SCALED / 2)
    pv.Delete(view)


def growing(checks):
    """Glyphs that time lets grow too far become smaller: seldom, and never larger again, so that an animation does not pulse."""
    view = session.view(80, 60)
    times = [float(time) for time in range(12)]
    shown = session.glyphs(series(*((time, SIDE, 0.01 * time) for time in times)), view, ScaleMode="Magnitude", SelectScaleArray="s", Orient=0)
    factors = []
    for time in times[1:]:
        view.ViewTime = time
        factors.append(factor(shown, view))
        checks.within("size of the ramp's glyphs at time %g" % time, factors[-1] * 0.01 * time, 0.9 * PLAIN, 2.5 * PLAIN)
    print("factors of the ramp:", factors)
    checks.true("the ramp's factors grow: %s" % factors, factors == sorted(factors, reverse=True))
    checks.within("number of the ramp's factors", len(numpy.unique(factors)), 2, 3)
    for time in times:
        view.ViewTime = time
        checks.equal("factor of the ramp at time %g, seen again" % time, factor(shown, view), factors[-1])
    pv.Delete(view)

    # A spray, a single particle first: glyphs grow with the space that the points fill, but not back and forth.
    for what, steps, wanted in (("a spray", ((0.0, SIDE, 1e-3), (1.0, SIDE, 2e-3), (2.0, SIDE, 1.0), (3.0, SIDE, 2.0)), (1, 1, 1e3, 1e3)),
                                ("a first particle", ((0.0, 1, 1.0), (1.0, SIDE, 1e3)), (1.0 / 0.45, 1e3))):
        view = session.view(80, 60)
        shown = session.glyphs(pv.Calculator(Input=series(*steps), CoordinateResults=1, Function="coords*s"), view, Orient=0)
        pv.Render(view)
        for (time, _, _), first in zip(steps, wanted):
            view.ViewTime = time
            checks.within("factor of %s at time %g" % (what, time), factor(shown, view), 0.9 * PLAIN * first * steps[0][2], 1.1 * PLAIN * first * steps[0][2])
        last = factor(shown)
        for time, _, _ in steps:
            view.ViewTime = time
            checks.equal("factor of %s at time %g, seen again" % (what, time), factor(shown, view), last)
        pv.Delete(view)

    # The first steps of an impact, in which grains creep.
    view = session.view(80, 60)
    source = pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact.vtk.series")
    shown = session.glyphs(source, view, "Arrow", ScaleMode="Magnitude")
    for time, low, high in ((0.3, 200.0, 400.0), (0.4, 0.15, 0.3), (0.6, 0.15, 0.3)):
        view.ViewTime = time
        checks.within("factor of the impact at time %g" % time, factor(shown, view), low, high)
    hit = factor(shown)
    for time in source.TimestepValues:
        view.ViewTime = time
        checks.equal("factor of the impact at time %g, after the hit" % time, factor(shown, view), hit)
    longest = hit * numpy.linalg.norm(session.array_of(source, "velocity"), axis=1).max()
    side = numpy.ptp(numpy.reshape(source.GetDataInformation().GetBounds(), (3, 2)), axis=1).max()
    checks.within("the longest arrow of the impact, of the longest side", longest / side, 0.0, 0.4)
    pv.Delete(view)


def odd_data(checks):
    """One point, coincident ones, blocks, a wild value, sizes of machine range: always a positive number."""
    view = session.view(80, 60)
    random = numpy.random.default_rng(5)
    cube = random.uniform(0.0, 1.0, (400, 3))
    for what, points, low, high in (
            ("one point", [[3.0, 4.0, 5.0]], 1.0, 1.0), ("coincident points", [[3.0, 4.0, 5.0]] * 3, 1.0, 1.0),
            ("two of three coincide", [[0.0, 0.0, 0.0]] * 2 + [[1.0, 0.0, 0.0]], 0.2, 0.2),
            ("every point twice", numpy.repeat(grid(), 2, axis=0), PLAIN, PLAIN), ("a cube", cube, 0.05, 0.09),
            ("a huge cube", 1e30 * cube, 0.05e30, 0.09e30), ("a tiny cube", 1e-30 * cube, 0.05e-30, 0.09e-30),
            ("points beyond the range", 1e308 * (cube - 0.5), 0.0, numpy.inf),
            ("points that are not finite", numpy.concatenate([cube, [[numpy.nan] * 3, [numpy.inf] * 3]]), 0.05, 0.09)):
        shown = session.glyphs(session.source(session.poly_data(numpy.array(points, dtype=float))), view, Orient=0)
        session.messages(lambda: pv.Render(view))
        checks.within("factor of " + what, shown.ScaleFactor, low, high)
        pv.Delete(shown)
    sizes = []
    for growth in numpy.arange(1.11, 1.15, 0.005):  # of the cells: even meshes become graded ones
        mesh = growth**numpy.array([(x, y, 0.0) for x in range(20) for y in range(20)])
        shown = display(session.source(session.poly_data(mesh)), view, Orient=0)
        sizes.append(factor(shown) / numpy.ptp(mesh))
        pv.Delete(shown)
    checks.within("largest change of the size between meshes that are nearly alike", max(numpy.maximum(sizes[1:], sizes[:-1]) / numpy.minimum(sizes[1:], sizes[:-1])).item(), 1.0, 1.3)
    whole = grid()
    blocks = pv.GroupDatasets(Input=[session.source(session.poly_data(whole[:200])), session.source(session.poly_data(whole[200:]))])
    shown = display(blocks, view)
    checks.equal("factor of blocks", factor(shown), PLAIN)
    pv.Delete(shown)
    wild = numpy.ones(400)
    wild[7] = 1e12
    shown = display(session.source(session.poly_data(cube, wild=wild)), view, ScaleMode="Magnitude", SelectScaleArray="wild", Orient=0)
    checks.within("factor with a wild value", factor(shown), 0.05, 0.09)
    shown.ScaleFactor = 1e-13
    pv.Render(view)
    pv.Delete(view)


def states(checks):
    """State files and Python states keep who has chosen the factor; afterwards the session is empty."""
    view = session.view(80, 60)
    shown = display(pv.Wavelet(WholeExtent=[-4, 4] * 3), view, Orient=0)
    checks.equal("factor of the Wavelet", factor(shown), 0.9)
    checks.true("the Python state does not say that the factor is the data's", re.search(r"ScaleFactorFromData *= *1", smstate.get_state()))
    pv.SaveState(session.output("scale-guess-data.pvsm"))
    shown.ScaleFactor = 0.125
    pv.Render(view)
    checks.true("a factor of a script is not in the Python state", re.search(r"ScaleFactor *= *0.125", smstate.get_state()))
    checks.true("the Python state says that a script's factor is the data's", "ScaleFactorFromData" not in smstate.get_state())
    pv.SaveState(session.output("scale-guess-script.pvsm"))
    for name, from_data, wanted in (("data", 1, 0.9), ("script", 0, 0.125)):
        pv.ResetSession()
        pv.LoadState(session.output("scale-guess-%s.pvsm" % name))
        view = pv.GetActiveViewOrCreate("RenderView")
        pv.Render(view)
        found = [entry for entry in view.Representations if getattr(entry, "Representation", "") == session.REPRESENTATION]
        checks.equal("displays of the state of " + name, len(found), 1)
        checks.equal("ScaleFactorFromData of the state of " + name, int(found[0].ScaleFactorFromData), from_data)
        checks.equal("factor of the state of " + name, factor(found[0]), wanted)
    pv.ResetSession()


def shutter_time(shown):
    """The ShutterTime that the data suggest."""
    return shown.SMProxy.GetProperty("DataSummary").GetElement(3)


def compare(checks, what):
    """What the test's data suggest, wherever they are."""
    view = session.view(80, 60)
    moving = pv.Calculator(Input=series((0.0, SIDE, 2.0)), Function="s*iHat", ResultArrayName="velocity")
    shown = session.glyphs(moving, view, Orient=0)
    checks.equal(what + ": factor", factor(shown, view), PLAIN)
    shown.MotionBlur = 1
    pv.Render(view)
    time = shutter_time(shown)
    checks.within(what + ": streaks, in glyph sizes", time * 2.0 / PLAIN, 2.9, 3.0)
    chosen = session.capture(view, "scale-guess-streaks")
    shown.ShutterTime = time
    checks.true(what + ": the picture of the chosen ShutterTime", (session.capture(view, "scale-guess-same-streaks") == chosen).all())
    shown.ShutterTime = 0.0
    shown.MotionBlur = 0
    shown.ScaleMode, shown.SelectScaleArray = "Magnitude", "s"
    checks.equal(what + ": factor with scaling", factor(shown, view), SCALED)
    session.look(view, (1.75, 1.75, 12.0), (1.75, 1.75, 1.75))
    guessed = session.capture(view, "scale-guess-" + what.replace(" ", "-"))
    shown.ScaleFactor = 0.1
    shown.ScaleFactor = SCALED
    pv.Render(view)
    share, _, _ = comparison.difference(guessed, session.capture(view, "scale-guess-by-hand-" + what.replace(" ", "-")))
    checks.equal(what + ": fraction of the pixels that differ from the same factor set by hand", share, 0.0)
    pv.Delete(view)


def on_server(checks, server):
    """With a server that renders, and with one that has the data only."""
    process, port = client_server.start_server(server, "scale-guess-server%d.log" % len(server))
    try:
        pv.Connect("127.0.0.1", port)
        session.load()
        pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
        for where, threshold in (("server renders", client_server.REMOTE), ("client renders", client_server.CLIENT)):
            compare_at(checks, where, threshold)
    finally:
        client_server.stop(process)


def compare_at(checks, where, threshold):
    """The comparison with a threshold of remote rendering."""
    make = session.view

    def view(*arguments):
        made = make(*arguments)
        made.RemoteRenderThreshold = threshold
        return made

    session.view = view
    try:
        compare(checks, where)
    finally:
        session.view = make


def main(arguments):
    """The parts that the arguments name."""
    session.load()
    checks = Checks()
    if arguments[:1] == ["server"]:
        on_server(checks, arguments[2:] + [arguments[1]])
    elif arguments == ["ranks"]:
        compare(checks, "ranks")
    else:
        states(checks)
        first_picture(checks)
        changes(checks)
        steps(checks)
        growing(checks)
        odd_data(checks)
        compare(checks, "one rank")
    if not arguments:
        checks.report()
    for failure in checks.failures:
        print("FAILED:", failure)
    print("SCALE GUESS TEST " + ("FAILED" if checks.failures else "PASSED"))
    if arguments[:1] == ["server"]:
        sys.stdout.flush()
        os._exit(1 if checks.failures else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
