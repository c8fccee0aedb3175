"""A growing image: screenshots in between, glyphs out of sight, two passes, other numbers of samples.

Usage: pvpython image_state.py
"""
import paraview.simple as pv

import accumulation
import session
from checks import Checks, cloud, information, pending, refine, stepwise

SIZE = (120, 90)
PIXELS = SIZE[0] * SIZE[1]


def balls(mode, samples, step=-1, **properties):
    """(view, representation): balls whose image grows from render to render."""
    view = session.view(*SIZE)
    shown = session.glyphs(cloud(), view, Orient=0, ScaleFactor=0.35, ShadingMode=mode, samples=samples, **properties)
    stepwise(shown, step)
    session.solid(shown, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 6.0))
    return view, shown


def rays(shown):
    """Primary rays that the view has traced so far."""
    return session.statistics(shown)["primaryRays"]


def screenshots(checks):
    """A screenshot has all samples whatever the window shows, and the window's image grows on."""
    # Together more than one step of the window.
    for mode, samples in (("Ambient Occlusion", 64), ("Path Tracing", 32)):
        view, shown = balls(mode, samples)
        expected = session.capture(view, "image-state-fresh")
        checks.covered(mode + ", fresh view", expected, 0.3)
        for step, size in ((-1, SIZE), (2, SIZE), (-1, (90, 60)), (2, (90, 60))):
            what = "%s, %d samples a render, screenshot of %dx%d" % ((mode, step) + size)
            stepwise(shown, step)
            session.look(view, (0.0, 0.0, 7.0))
            pv.Render(view)
            session.look(view, (0.0, 0.0, 6.0))
            pv.Render(view)
            checks.true(what + ": nothing was pending after one render", pending(shown))
            found = []
            said = session.messages(lambda: found.append(
                session.capture(view, "image-state-growing", ImageResolution=list(size))))
            checks.no_message(what, said)
            if size == SIZE:
                checks.picture(what, found[0], expected)
            checks.covered(what, found[0], 0.3)
            pv.Render(view)
            checks.no_message(what + ", afterwards", session.messages(lambda: refine(view, shown)))
            checks.true(what + ": the window's image stays unfinished", not pending(shown))
            checks.picture(what + ", finished in the window", accumulation.shown_by(view), expected)
        pv.Delete(view)


def after_many_tiles(checks):
    """A screenshot of many tiles leaves the window's image the samples that it has."""
    view, shown = balls("Ambient Occlusion", 64, 2)
    session.look(view, (0.0, 0.0, 6.0))
    while information(shown, "AccumulatedSamples") < 8:
        pv.Render(view)
    session.capture(view, "image-state-tiles", ImageResolution=[4 * side for side in SIZE])
    pv.Render(view)
    checks.within("samples after a screenshot of many tiles", information(shown, "AccumulatedSamples"), 10, 64)
    pv.Delete(view)


def out_of_sight(checks):
    """Glyphs behind the camera end the refinement; turned back they are refined again."""
    view, shown = balls("Ambient Occlusion", 8, 2)
    expected = session.capture(view, "image-state-in-sight")
    session.look(view, (0.0, 0.0, 7.0))
    pv.Render(view)
    session.look(view, (0.0, 0.0, 6.0), (0.0, 0.0, 12.0))
    pv.Render(view)
    checks.true("glyphs behind the camera: the image stays unfinished", refine(view, shown))
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    checks.true("glyphs in sight again: nothing is pending", pending(shown))
    checks.true("glyphs in sight again: the image stays unfinished", refine(view, shown))
    checks.picture("glyphs in sight again", accumulation.shown_by(view), expected)
    pv.Delete(view)


def two_passes(checks):
    """Opaque and translucent glyphs have an image each; the refinement ends with the slower one."""
    samples = 36
    view, shown = balls("Path Tracing", samples)
    other = session.glyphs(cloud(20, 5), view, Orient=0, ScaleFactor=0.1, samples=samples,
                           ShadingMode="Path Tracing", Opacity=0.5)
    session.solid(other, (0.2, 0.5, 0.9))
    pv.Render(view)

    def look():
        least = information(shown, "AccumulatedSamples")
        checks.true("two passes: %d samples are reported, but %d are those of both images" % (least, rays(shown) // PIXELS),
                    2 * least <= rays(shown) // PIXELS)

    checks.true("two passes: the image stays unfinished", refine(view, shown, look=look))
    # A preview of every eighth pixel of each, and one of every second, come before the first sample.
    previews = 15 * 12 / PIXELS + 60 * 45 / PIXELS
    checks.within("two passes, finished: samples of both images", rays(shown) / PIXELS, 2 * samples, 2 * (samples + previews))
    before = rays(shown)
    pv.Render(view)
    checks.equal("two passes, one more render: rays", rays(shown) - before, 0)
    pv.Delete(view)


def other_samples(checks):
    """Another number of samples adds a step or nothing, never all of them at once."""
    for mode in ("Local", "Ambient Occlusion"):
        view, shown = balls(mode, 32, 2)
        pv.Render(view)
        refine(view, shown)
        before = rays(shown)
        shown.SamplesPerPixel = 64
        pv.Render(view)
        checks.true("%s, 32 samples raised to 64: nothing is pending" % mode, pending(shown))
        checks.within("%s, 32 samples raised to 64: samples of the next render" % mode, (rays(shown) - before) / PIXELS, 1, 2)
        for _ in range(34):
            if information(shown, "AccumulatedSamples") < 34:
                pv.Render(view)
        before = rays(shown)
        shown.SamplesPerPixel = 30
        pv.Render(view)
        checks.equal("%s, lowered to 30 at 34: samples of the next render" % mode, (rays(shown) - before) / PIXELS, 0)
        checks.true("%s, lowered to 30 at 34: the image is pending" % mode, not pending(shown))
        pv.Delete(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    screenshots(checks)
    after_many_tiles(checks)
    out_of_sight(checks)
    two_passes(checks)
    other_samples(checks)
    checks.report()


if __name__ == "__main__":
    main()
