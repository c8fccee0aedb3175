"""Scripts may watch an image grow: with SamplesPerRender each render adds samples, until there are SamplesPerPixel.

Usage: pvpython accumulation.py
"""
import time

import numpy
import paraview.simple as pv
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import comparison
import session

STEP, FINISHED = 2, 32


def shown_by(view):
    """What the window shows, without rendering: a screenshot would have all samples."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.SMProxy.GetRenderWindow())
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    return session.pixels_of(grab.GetOutput())[..., :3].astype(int)


def grow(mode):
    """Failures of one shading mode."""
    import raytracedglyphs  # comes with the plugin
    failures = []
    view = session.view(160, 120, background=(255, 255, 255))
    points = session.source(session.poly_data(numpy.random.default_rng(3).uniform(-1.0, 1.0, (300, 3))))
    shown = session.glyphs(points, view, Orient=0, ScaleFactor=0.35, ShadingMode=mode, samples=FINISHED)
    raytracedglyphs.SetSamplesPerRender(STEP, view)
    shown.Denoising = "Never"
    session.solid(shown, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 6.0))
    pictures, counts, traced = [], [], []
    for _ in range(FINISHED // STEP + 2):
        pv.Render(view)
        pictures.append(shown_by(view))
        counts.append(raytracedglyphs.Statistics(view)["AccumulatedSamples"])
        traced.append(raytracedglyphs.Statistics(view)["primaryRays"])
    comparison.write_image(session.output("accumulation-%s-first.png" % mode.split()[0].lower()), pictures[0])
    comparison.write_image(session.output("accumulation-%s-last.png" % mode.split()[0].lower()), pictures[-1])
    if counts != [min(STEP * (i + 1), FINISHED) for i in range(len(counts))]:
        failures.append("%s: samples after each render: %s" % (mode, counts))
    # Render number k has 2 k samples of the 32 that the last one has: of independent ones the squared difference is (32 - 2 k) / 2 k over 32.
    errors = [float(numpy.square(picture - pictures[-1]).mean()) for picture in pictures]
    print(mode, "squared differences from the finished picture:", [round(error, 2) for error in errors])
    for earlier, later in ((0, 3), (3, 7), (7, 11), (11, 15)):
        if not errors[later] < 0.7 * errors[earlier]:
            failures.append("%s: from render %d to %d the error goes from %.2f to %.2f" % (mode, earlier, later, errors[earlier], errors[later]))
    if not errors[0] > 1.0:
        failures.append("%s: the first render differs from the last by %.2f only" % (mode, errors[0]))
    # Then nothing is traced any more, and the picture stays; it is the one that a screenshot makes at once.
    if errors[-3:] != [0.0, 0.0, 0.0] or len(set(traced[-3:])) != 1:
        failures.append("%s: the finished picture changes: %s, rays %s" % (mode, errors[-3:], traced[-3:]))
    raytracedglyphs.SetSamplesPerRender(0, view)
    session.look(view, (0.0, 0.0, 6.5))
    pv.Render(view)
    session.look(view, (0.0, 0.0, 6.0))
    whole = session.capture(view, "accumulation-whole")[..., :3].astype(int)
    if (whole != pictures[-1]).any():
        failures.append("%s: all samples at once make another picture, %g apart" % (mode, numpy.abs(whole - pictures[-1]).max()))
    pv.Delete(view)
    return failures


def left():
    """The time that is left follows the present speed: each of the first samples takes half a second, which tells nothing of those to come."""
    import raytracedglyphs
    view = session.view(160, 120)
    points = session.source(session.poly_data(numpy.zeros((1, 3))))
    session.glyphs(points, view, Orient=0, ScaleFactor=1.0, ShadingMode="Local", samples=1000)
    raytracedglyphs.SetSamplesPerRender(1, view)
    session.look(view, (0.0, 0.0, 6.0))
    times = []
    for i in range(50):
        time.sleep(0.5 if i < 4 else 0.05)
        pv.Render(view)
        times.append(time.time())
    wanted = (times[-1] - times[-11]) / 10.0 * (1000 - len(times))
    found = raytracedglyphs.Statistics(view).get("RefinementSecondsLeft", -1.0)
    print("seconds left: %.1f, at the speed of the last ten samples %.1f, of all %.1f" % (found, wanted, (times[-1] - times[0]) / 49.0 * (1000 - len(times))))
    pv.Delete(view)
    return [] if 0.7 * wanted <= found <= 1.3 * wanted else ["%.1f seconds are left instead of %.1f" % (found, wanted)]


def main():
    """Both modes that have noise, and the time that is left."""
    session.load()
    session.finish(grow("Ambient Occlusion") + grow("Path Tracing") + left())


if __name__ == "__main__":
    main()
