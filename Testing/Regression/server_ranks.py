"""Runs inside ParaView's window: with a server of two ranks an image is refined, drawn larger than the window, glyphs are
selected, and moving glyphs of another time step are drawn, all as without a server.

Usage: RTGLYPHS_SERVER="MPIEXEC -n 2 PVSERVER" paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=server_ranks.py
Prints SERVER RANKS TEST PASSED as its last line.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402

import client_server  # noqa: E402
import session  # noqa: E402
from checks import Checks  # noqa: E402
from window import Window, run, say  # noqa: E402

SAMPLES = 6
#: seconds within which an image must be finished; it takes a few
LIMIT = 120.0
STEPS = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
information.Set(executive.TIME_STEPS(), [0.0, 1.0], 2)
information.Set(executive.TIME_RANGE(), [0.0, 1.0], 2)
"""
#: Script of a source of which each rank has half of a grid of points; they move from step to step.
POINTS = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = information.Get(executive.UPDATE_TIME_STEP()) if information.Has(executive.UPDATE_TIME_STEP()) else 0.0
random = numpy.random.default_rng(3)
places = (numpy.arange(20) - 9.5) / 10.0
points = numpy.stack(numpy.meshgrid(places, places, [0.0], indexing="ij"), axis=-1).reshape(-1, 3)
points[:, 2] = random.uniform(-0.04, 0.04, 400)
arrays = {"flow": random.normal(size=points.shape) * 0.3, "number": numpy.arange(400.0)}
points += time * arrays["flow"]
mine = slice(400 * rank // ranks, 400 * (rank + 1) // ranks)
"""


def select_left_half(view, source):
    """Selects points as a rectangle over the picture's left half does; how many."""
    pv.SelectSurfacePoints(Rectangle=[0, 0, view.ViewSize[0] // 2 - 2, view.ViewSize[1] - 1], View=view)
    selection = pv.servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    ids = []
    for part in selection.Input if selection else []:
        ids += list(part.IDs)
    return len(ids) // 2  # pairs of a rank and an id


def pictures(checks, window, where):
    """Everything once: (pictures by their names, number of selected points)."""
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [400, 300]
    view.RemoteRenderThreshold = 0.0
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 1  # the window's default; in that picture glyphs must stay as they are
    view.UseColorPaletteForBackground = 0
    view.Background = [channel / 255.0 for channel in session.BACKGROUND]
    source = session.points_of_ranks(POINTS, STEPS)
    shown = session.glyphs(source, view, "Sphere", samples=SAMPLES, Orient=0, ScaleFactor=0.09, ShadingMode="Ambient Occlusion",
                           Denoising=0, ParallelLight="Replicated", VelocityArray="flow")
    pv.ColorBy(shown, ("POINTS", "number"))
    session.cool_to_warm("number")
    shown.SetScalarBarVisibility(view, False)
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    before = session.statistics(shown)["AccumulatedSamples"]
    done = window.wait(lambda: session.statistics(shown)["AccumulatedSamples"] >= SAMPLES, LIMIT)
    say("%s: refined from %d samples to %d" % (where, before, session.statistics(shown)["AccumulatedSamples"]))
    checks.true("%s: the image is not finished after %g s" % (where, LIMIT), done)
    made = {"larger": session.capture(view, "server-ranks-larger-" + where, ImageResolution=[700, 525])}
    count = select_left_half(view, source)
    pv.Render(view)
    made["selected"] = session.capture(view, "server-ranks-selected-" + where, ImageResolution=[400, 300])
    pv.ClearSelection(source)
    shown.MotionBlur = 1
    pv.GetAnimationScene().AnimationTime = 1.0
    pv.Render(view)
    made["moving"] = session.capture(view, "server-ranks-moving-" + where, ImageResolution=[400, 300])
    return made, count


def main():
    """Without a server, then with one."""
    checks, window = Checks(), Window()
    wanted, count = pictures(checks, window, "alone")
    process, port = client_server.start_server(os.environ["RTGLYPHS_SERVER"].split(), "server-ranks.log")
    try:
        pv.Connect("127.0.0.1", port)
        pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
        found, found_count = pictures(checks, window, "server")
    finally:
        client_server.stop(process)
        with open(session.output("server-ranks.log")) as log:
            say(log.read())
    for name, picture in found.items():
        checks.picture("server ranks " + name, picture, wanted[name])
    checks.equal("selected points", count, 200)
    checks.equal("selected points, with a server", found_count, 200)
    return checks.failures


pv._DisableFirstRenderCameraReset()
run("SERVER RANKS", main)
