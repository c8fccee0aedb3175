"""Runs inside ParaView's window: an image is refined while the window rests, stops when finished, and waits while the
camera is turned.

Usage: [RTGLYPHS_PVSERVER=PVSERVER] paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=refinement.py
With PVSERVER the images come from such a server. Prints REFINEMENT TEST PASSED as its last line.
"""
import json
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import numpy  # noqa: E402
import paraview.simple as pv  # noqa: E402
from vtkmodules.vtkCommonCore import VTK_INT  # noqa: E402

import client_server  # noqa: E402
import session  # noqa: E402
from window import Window, run, say  # noqa: E402

SAMPLES = 12
SERVER = os.environ.get("RTGLYPHS_PVSERVER")
#: seconds within which the image must be finished; it takes a few
LIMIT = 120.0


def told(shown):
    """The client's information since the last render."""
    return json.loads(shown.SMProxy.GetProperty("RenderStatistics").GetElement(0))


def state(shown):
    """(samples of the image, images traced so far)."""
    statistics = session.statistics(shown)
    return statistics["AccumulatedSamples"], statistics["dispatches"]


def scene():
    """(view, representation): a cloud of spheres with ambient occlusion."""
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    if SERVER:
        source = pv.PointSource(NumberOfPoints=10000, Radius=1.5)
        view.RemoteRenderThreshold = 0.0
    else:
        points = numpy.random.default_rng(1).uniform(-1.0, 1.0, (10000, 3))
        source = session.source(session.poly_data(points))
    shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.05)
    session.solid(shown, (0.9, 0.9, 0.9))
    shown.ShadingMode = "Ambient Occlusion"
    shown.SamplesPerPixel = SAMPLES
    session.look(view, (0.0, 0.0, 6.0))
    return view, shown


def main():
    """Ambient occlusion at rest, then after a turn of the camera, then while it is turned."""
    failures = []
    window = Window()
    view, shown = scene()
    seen = []

    def finished():
        samples = told(shown)["AccumulatedSamples"]
        if not seen or seen[-1] != samples:
            seen.append(samples)
        return samples >= SAMPLES

    pv.Render(view)
    seen.append(state(shown)[0])
    if seen[0] >= SAMPLES:
        failures.append("the first image has all %d samples at once" % seen[0])
    renders = []

    def rendered(_view, _event, interactive):
        renders.append(interactive)

    rendered.CallDataType = VTK_INT
    view.SMProxy.AddObserver("EndEvent", rendered)
    pulls = told(shown)["pulls"]
    start = time.time()
    if not window.wait(finished, LIMIT):
        failures.append("after %g s the image has %s samples, not %d" % (LIMIT, seen[-1], SAMPLES))
    say("refined at rest: %s samples in %.2f s" % (seen, time.time() - start))

    # One round trip a step, for the plugin's own information, the progress bar and the toolbar.
    pulls = told(shown)["pulls"] - pulls
    steps = renders.count(0)
    say("%d pulls of information for %d steps" % (pulls, steps))
    if steps < 2 or pulls != steps:
        failures.append("%d pulls of information for %d steps" % (pulls, steps))

    # Nothing goes on when all is done.
    before, cpu = state(shown), time.process_time()
    window.wait(lambda: False, 2.0)
    idle = (time.process_time() - cpu) / 2.0
    say("at rest: %.1f %% of one core" % (100.0 * idle))
    if state(shown) != before:
        failures.append("a finished image was traced again: %s, then %s" % (before, state(shown)))

    # While the camera is turned there are coarse images and no steps between them.
    window.mouse("Viewport", "press", (100, 100))
    window.wait(lambda: False, 0.1)
    before = state(shown)
    start = time.time()
    session.look(view, (1.0, 0.0, 6.0))
    view.SMProxy.InteractiveRender()
    answer = time.time() - start
    turning = state(shown)
    window.wait(lambda: False, 1.0)
    if state(shown) != turning:
        failures.append("the image was refined while the camera was turned")
    # A coarse image has no sample of every pixel; before the first one a coarser one measures what rays cost.
    if turning[1] > before[1] + 2 or turning[1] == before[1] or turning[0] != 0:
        failures.append("a turn of the camera took %s to %s samples and images" % (before, turning))
    window.mouse("Viewport", "release", (100, 100))
    window.events()
    start = time.time()
    view.SMProxy.StillRender()
    sample = time.time() - start
    say("first picture of a turn after %.3f s, a sample at rest %.3f s" % (answer, sample))
    seen.clear()
    if not window.wait(finished, LIMIT):
        failures.append("after a turn the image has %s samples, not %d" % (seen[-1], SAMPLES))
    say("refined after a turn: %s" % seen)

    # ParaView sets the camera anew for each render, and normalizes its view-up vector, which for this one never ends.
    session.look(view, (-2.1, 4.3, 1.7), (0.0, 0.0, 0.0), (0.6671648240249001, 0.5184328916512436, 0.5349003967449961))
    view.SMProxy.StillRender()
    seen.clear()
    if not window.wait(finished, 30.0):
        failures.append("with a camera that rounding changes the image has %s samples, not %d" % (seen[-1], SAMPLES))
    return failures if SERVER else failures + detail(window, view, shown)


def detail(window, view, shown):
    """With ParaView's level of detail few glyphs stand for many while the mouse turns the camera, and no longer."""
    for name, value in (("LODThreshold", 0.0), ("LODResolution", 0.03)):
        view.SMProxy.GetProperty(name).SetElement(0, value)
    view.SMProxy.UpdateVTKObjects()

    def few():
        return shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(1) is not None

    turned = window.drag("Viewport", (100, 100), (150, 120), release=False) and window.wait(few, 30.0)
    window.mouse("Viewport", "release", (150, 120))
    return ["few glyphs: %s while the camera is turned, not afterwards" % turned] if not turned or not window.wait(lambda: not few(), 30.0) else []


def on_server():
    """The same with images that come from a server, which does not have the plugin at first."""
    process, port = client_server.start_server([SERVER], "refinement-server.log")
    window = Window()

    def settle(work):
        work()
        window.wait(lambda: False, 0.5)

    try:
        settle(lambda: None)  # what ParaView's window and the plugin say when they start
        said = [session.messages(lambda: settle(work)) for work in (
            pv.Connect, lambda: pv.Connect("127.0.0.1", port), lambda: pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv)))]
        say("this computer, a server without the plugin, with it: %s" % said)
        counts = [text.count("has not loaded the plugin RayTracedGlyphs") for text in said]
        failures = [] if counts == [0, 1, 0] and not said[0] + said[2] else ["messages of servers: %s" % said]
        return failures + main()
    finally:
        client_server.stop(process)
        with open(session.output("refinement-server.log")) as log:
            say(log.read())


pv._DisableFirstRenderCameraReset()
run("REFINEMENT", on_server if SERVER else main)
