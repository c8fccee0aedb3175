"""While programs are compiled the last picture stays, in front of and behind what ParaView draws, until there is a preview: at once, or
when its program is there; before the first one there are points. Not in files. Programs of other light are compiled ahead, and the camera is turned meanwhile.

Usage: MESA_SHADER_CACHE_DIR=FOLDER pvpython compiling.py
FOLDER is emptied.
"""
import os
import shutil
import time

import numpy
import paraview.simple as pv

import accumulation
import session
from checks import Checks, cloud, information, refine, stepwise

#: seconds within which programs must be there
LIMIT = 150.0


def while_compiling(view, shown):
    """Pictures of the renders that waited for a program, until there is a sample: some have time for a preview only."""
    pictures, end = [], time.monotonic() + LIMIT
    while time.monotonic() < end:
        pv.Render(view)
        if information(shown, "RefinementStep") == "Compiling Shaders":
            pictures.append(accumulation.shown_by(view))
            time.sleep(0.02)
        elif information(shown, "AccumulatedSamples") > 0:
            break
    return pictures


def finished(checks, view, shown, what):
    """The finished picture."""
    checks.true("%s: the image is not finished" % what, refine(view, shown))
    return accumulation.shown_by(view)


def stays(checks, view, shown, what, before, light=False):
    """The picture from before is there until there is another one, which differs; returns that when it is finished.

    light: nothing else has changed, and there are no previews.
    """
    pictures = while_compiling(view, shown)
    print("%s: %d renders while programs were compiled" % (what, len(pictures)))
    checks.true("%s: no program was compiled" % what, bool(pictures))
    for picture in pictures[:1] + (pictures[-1:] if light else []):
        checks.picture("%s: while programs are compiled" % what, picture, before)
    after = finished(checks, view, shown, what)
    checks.true("%s: the picture stays for good" % what, bool((after != before).any()))
    return after


def ahead(checks, view, shown):
    """The other modes have their programs when they are chosen, and nothing waits while these are compiled."""
    shown.ShadingMode, shown.GroundShadow = "Local", "Below"
    session.assign_shape(shown, "Cone")
    pv.Render(view)
    finished(checks, view, shown, "before programs are compiled ahead")
    checks.true("no program is compiled ahead", information(shown, "programsAhead") > 0)
    begin, longest = time.monotonic(), 0.0
    while information(shown, "programsAhead") > 0 and time.monotonic() < begin + LIMIT:
        start = time.monotonic()
        view.CameraPosition = [2.0 + 0.1 * (start - begin), 0.0, 6.0]
        view.SMProxy.InteractiveRender()
        longest = max(longest, time.monotonic() - start)
    took = time.monotonic() - begin
    print("programs were compiled ahead in %.2f s, the longest render meanwhile took %.3f s" % (took, longest))
    checks.true("a render took %.2f s of %.2f s in which programs were compiled" % (longest, took), longest < 0.1 * took)
    finished(checks, view, shown, "programs are compiled ahead")
    for mode in ("Ambient Occlusion", "Path Tracing"):
        shown.ShadingMode = mode
        checks.true("%s: a program is compiled" % mode, not while_compiling(view, shown))
        finished(checks, view, shown, mode)


def first(checks):
    """Of a view's first picture there are points while its program is compiled, in the glyphs' colors."""
    for shape, mapped in (("Cylinder", False), ("Capsule", True)):
        view = session.view(200, 150)
        shown = stepwise(session.glyphs(cloud(), view, shape, samples=2, Orient=0, ScaleFactor=0.3))
        session.solid(shown, (0.9, 0.6, 0.3))
        if mapped:
            pv.ColorBy(shown, ("POINTS", "scalar")) # which is x
            pv.GetColorTransferFunction("scalar").RGBPoints = [-1.0, 0.0, 0.4, 1.0, 0.0, 0.0, 0.4, 1.0, 0.0, 1.0, 0.2, 0.0, 1.0, 1.0, 0.2, 0.0]
        session.look(view, (0.0, 0.0, 6.0))
        pictures = while_compiling(view, shown)
        checks.true("first picture of %s: no program was compiled" % shape, bool(pictures))
        for seen in pictures[:1] + pictures[-1:]:
            checks.covered("first picture of %s: while programs are compiled" % shape, seen, 0.02, 0.15)
            for half, color in ((seen[:, :90], (0, 102, 255)), (seen[:, 110:], (255, 51, 0))):
                found = (abs(half - (color if mapped else (230, 153, 77))).max(axis=-1) <= 2).mean()
                checks.within("first picture of %s: fraction of points of that color" % shape, found, 0.02, 0.15)
        finished(checks, view, shown, "first picture of %s" % shape)


def main():
    """Other light, opacity, a second display that widens the clipping range, another camera, and a file."""
    shutil.rmtree(os.environ["MESA_SHADER_CACHE_DIR"], ignore_errors=True)
    session.load()
    checks = Checks()
    view = session.view(200, 150)
    wall = pv.Show(pv.Plane(Origin=[-1.0, -1.0, 0.0], Point1=[0.0, -1.0, 0.0], Point2=[-1.0, 1.0, 0.0]), view)
    wall.Representation = "Surface"
    session.solid(wall, (0.2, 0.3, 0.9))
    shown = session.glyphs(cloud(), view, "Superquadric", samples=2, Orient=0, ScaleFactor=0.3) # of scripts nothing is expected
    session.solid(shown, (0.9, 0.6, 0.3))
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    picture = finished(checks, view, shown, "first picture")
    checks.covered("first picture", picture, 0.2)

    stepwise(shown)
    shown.ShadingMode, shown.Denoising = "Ambient Occlusion", "Never"
    picture = stays(checks, view, shown, "other light", picture, light=True)
    shown.Opacity = 0.5
    picture = stays(checks, view, shown, "opacity", picture)
    shown.Opacity = 1.0
    pv.Render(view)
    picture = finished(checks, view, shown, "opaque again")

    # It lies beside what the camera sees, far behind the wall.
    far = session.source(session.poly_data(numpy.array([[500.0, 0.0, -200.0]])))
    other = session.glyphs(far, view, "Cone", Orient=0, ScaleFactor=1.0)
    stepwise(other)
    session.look(view, (0.0, 0.0, 6.0))
    pictures = while_compiling(view, shown)
    checks.true("a second display: no program was compiled", bool(pictures))
    for seen in pictures[:1]:
        checks.picture("a second display: while programs are compiled", seen, picture, pixels=0.001)
    pv.Hide(far, view)
    finished(checks, view, shown, "a second display")

    wall.Visibility = 0
    shown.ShadingMode, shown.Denoising = "Path Tracing", "While Refining"
    session.look(view, (2.0, 0.0, 6.0))
    pictures = while_compiling(view, shown)
    checks.true("another camera: no program was compiled", bool(pictures))
    for seen in pictures[:1] + pictures[-1:]:
        checks.covered("another camera: while programs are compiled", seen, 0.2)
    checks.covered("another camera", finished(checks, view, shown, "another camera"), 0.2)

    session.assign_shape(shown, "Box")
    window, said, saved = view.SMProxy.GetRenderWindow(), [], []
    observer = window.AddObserver("AbortCheckEvent", lambda *_: window.SetAbortRender(1))
    said.append(session.messages(lambda: saved.append(session.capture(view, "compiling-aborted"))))
    window.RemoveObserver(observer)
    checks.one_message("a screenshot that is stopped", said[0], "stopped", "0 of 2")
    checks.covered("a screenshot that is stopped while programs are compiled", saved[0], 0.0, 0.0)
    pv.Render(view)
    checks.covered("after the screenshot", finished(checks, view, shown, "after the screenshot"), 0.2)
    ahead(checks, view, shown)
    first(checks)
    checks.report()


if __name__ == "__main__":
    main()
