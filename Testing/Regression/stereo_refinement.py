"""Stereo: the images of both eyes grow until both are finished, and show what 3D Glyphs show in the same mode.

Usage: pvpython stereo_refinement.py
"""
import paraview.simple as pv

import accumulation
import comparison
import session
from checks import Checks, cloud, information, pending, refine, stepwise
from same_as_3d_glyphs import ours, scene, theirs

SAMPLES = 8
EYE = (2.0, 1.5, 5.0)


def stereo_view(mode):
    """A render view in a stereo mode."""
    view = session.view(240, 180)
    if mode == "Red-Blue":
        view.Background = [0.0, 0.0, 0.0]  # the eyes' pictures go to different channels: gray on black is seen by both
    view.StereoRender = 1
    view.StereoType = mode
    session.look(view, EYE)
    return view


def picture(view, mode, who):
    """What the window shows when each render traces all samples. ParaView moves the eyes a little after its first render."""
    pv.Render(view)
    pv.Render(view)
    pixels = accumulation.shown_by(view)
    comparison.write_image(session.output("stereo-%s-%s.png" % (mode.lower(), who)), pixels)
    return pixels


def pictures(mode, points):
    """What the window shows of 3D Glyphs, and of ours with one sample and with all at once."""
    view = stereo_view(mode)
    shown = theirs(points, view, "Sphere")
    session.solid(shown, (0.9, 0.9, 0.9))
    expected = picture(view, mode, "paraview")
    pv.Delete(shown)
    shown = ours(points, view, "Sphere")
    session.solid(shown, (0.9, 0.9, 0.9))
    shown.SamplesPerPixel = SAMPLES
    whole = picture(view, mode, "at-once")
    shown.SamplesPerPixel = 1
    view.CameraPosition = [2.0, 1.5, 6.0]  # an image that has more samples is kept until the camera moves
    pv.Render(view)
    view.CameraPosition = list(EYE)
    one = picture(view, mode, "ours")
    pv.Delete(view)
    return expected, one, whole


def grown(checks, mode, points):
    """What the window shows when the image has grown step by step."""
    view = stereo_view(mode)
    shown = ours(points, view, "Sphere")
    session.solid(shown, (0.9, 0.9, 0.9))
    stepwise(shown, 2).SamplesPerPixel = SAMPLES
    pv.Render(view)
    checks.true(mode + ": nothing is pending after the first render", pending(shown))
    checks.true(mode + ": the image stays unfinished", refine(view, shown))
    checks.equal(mode + ": samples reported", information(shown, "AccumulatedSamples"), SAMPLES)
    before = session.statistics(shown)["primaryRays"]
    pv.Render(view)
    checks.equal(mode + ": rays traced by one more render", session.statistics(shown)["primaryRays"] - before, 0)
    pixels = accumulation.shown_by(view)
    comparison.write_image(session.output("stereo-%s-grown.png" % mode.lower()), pixels)
    pv.Delete(view)
    return pixels


def kept(checks):
    """A screenshot of another size, of both eyes and passes, leaves the window's images as far as they are."""
    view = stereo_view("SplitViewportHorizontal")
    shown = session.glyphs(cloud(200), view, Orient=0, ScaleFactor=0.3, samples=64)
    other = session.glyphs(cloud(20, 5), view, Orient=0, ScaleFactor=0.2, samples=64, Opacity=0.5)
    session.solid(other, (0.2, 0.5, 0.9))
    stepwise(shown, 2)
    session.look(view, EYE)
    for _ in range(3):
        pv.Render(view)
    before = information(shown, "AccumulatedSamples")
    session.capture(view, "stereo-captured", ImageResolution=[120, 90])
    pv.Render(view)
    checks.equal("samples of one render after a screenshot", information(shown, "AccumulatedSamples") - before, 2)
    pv.Delete(view)


def main():
    """A mode in which one eye's picture lies beside the other's, and one that mixes them."""
    session.load()
    checks = Checks()
    points = scene()
    kept(checks)
    for mode in ("SplitViewportHorizontal", "Red-Blue"):
        expected, one, whole = pictures(mode, points)
        halves = (one[:, :120], one[:, 120:]) if mode != "Red-Blue" else (one[..., :1], one[..., 2:])
        checks.true(mode + ": both eyes see the same", comparison.difference(*halves)[0] > 0.005)
        if mode == "Red-Blue":
            checks.picture(mode + ", one sample, against ParaView", one, expected)
        else:
            checks.failures += comparison.against_paraview(one, expected, "stereo-" + mode.lower())
        checks.picture(mode + ", grown", grown(checks, mode, points), whole)
    checks.report()


if __name__ == "__main__":
    main()
