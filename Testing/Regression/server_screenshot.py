"""Screenshots of another size have all samples although a server renders and the window's image grows step by step.

Usage: pvpython server_screenshot.py PVSERVER
"""
import os
import sys

import paraview.simple as pv

import client_server
import session
from checks import Checks, pending, refine, stepwise

SAMPLES = 32
#: mean difference of two pictures of so many samples: a screenshot of another size is made of tiles, whose noise is their own
NOISE = 1.0
WINDOW, PICTURE = (120, 90), (160, 120)


def scene(points, size):
    """(view, representation): balls whose light is noisy with few samples."""
    view = session.view(*size)
    view.RemoteRenderThreshold = client_server.REMOTE
    shown = session.glyphs(points, view, Orient=0, ScaleFactor=0.4,
                           ShadingMode="Ambient Occlusion", samples=SAMPLES)
    session.solid(shown, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 6.0))
    return view, shown


def check(checks):
    """A picture of a fresh view, and one taken while the window's image grows."""
    points = pv.PointSource(NumberOfPoints=200, Radius=1.5)
    view, _ = scene(points, PICTURE)
    expected = session.capture(view, "server-screenshot-fresh")
    checks.covered("fresh view", expected, 0.2)
    pv.Delete(view)
    view, shown = scene(points, WINDOW)
    stepwise(shown)
    for name in ("growing", "finished"):
        pv.Render(view)
        if name == "finished":
            refine(view, shown)
        checks.equal("image is pending, " + name, pending(shown), name == "growing")
        before = session.statistics(shown)["primaryRays"]
        found = session.capture(view, "server-screenshot-" + name, ImageResolution=list(PICTURE))
        rays = session.statistics(shown)["primaryRays"] - before
        wanted = PICTURE[0] * PICTURE[1] * SAMPLES
        print("%s: %d rays, %d are those of all samples" % (name, rays, wanted))
        # The second one shows the same as the first, whose image may be kept.
        checks.true("%s: the screenshot took %d rays, not %d" % (name, rays, wanted), rays >= wanted or name == "finished")
        checks.picture("screenshot of a view whose image is " + name, found, expected, mean=NOISE)
    pv.Delete(view)


def main(server):
    """On a server of this test's own."""
    pv._DisableFirstRenderCameraReset()
    process, port = client_server.start_server([server])
    checks = Checks()
    try:
        pv.Connect("127.0.0.1", port)
        session.load()
        pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
        check(checks)
    finally:
        client_server.stop(process)
    for failure in checks.failures:
        print("FAILED:", failure)
    print("%d failures" % len(checks.failures))
    sys.stdout.flush()
    os._exit(1 if checks.failures else 0)


if __name__ == "__main__":
    main(sys.argv[1])
