"""Light between representations: contact shadows of glyphs and surfaces in one view, shown, hidden and deleted.

Usage: pvpython light.py [cycles COUNT]
cycles: instead of looking at pictures, shows and deletes everything COUNT times; no memory must stay behind.
"""
import ctypes
import sys

import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks
from property_claims import to_light

SURFACE = "Ray Traced Surface"
SAMPLES = 64
#: cycles of showing and deleting before those that are measured
WARM = 3
#: bytes a cycle may leave behind in the process, beyond what ParaView's Points and Surface leave, which is one million in the
#: first cycles
LEAK = 3 << 20


class Scene:
    """A ball and arrows on a floor, lit from all around: two glyph representations and a surface in one view."""

    def __init__(self, mode, width=200):
        self.view = session.view(width, width * 3 // 4, background=(255, 255, 255))
        self.floor_source = pv.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0])
        self.floor = pv.Show(self.floor_source, self.view)
        self.floor.SetRepresentationType(SURFACE)
        self.floor.SamplesPerPixel = SAMPLES
        self.floor.ShadingMode = mode
        session.solid(self.floor, (0.8, 0.8, 0.8))
        self.ball_source = session.source(session.poly_data(numpy.array([[-0.6, 0.0, 0.5]])))
        self.ball = session.glyphs(self.ball_source, self.view, "Sphere", Orient=0, ScaleFactor=1.0)
        session.solid(self.ball, (0.9, 0.3, 0.2))
        self.arrow_source = session.source(session.poly_data(
            numpy.array([[0.6, -0.5, 0.0], [0.6, 0.0, 0.0], [0.6, 0.5, 0.0]]), up=numpy.array([[0, 0, 1.0]] * 3)))
        self.arrows = session.glyphs(self.arrow_source, self.view, "Arrow", Orient=1, SelectOrientationVectors="up",
                                     ScaleFactor=1.0)
        session.solid(self.arrows, (0.2, 0.4, 0.9))
        session.look(self.view, (0.0, -5.0, 3.5), (0.0, 0.0, 0.3), (0.0, 0.0, 1.0))

    def close(self):
        """Deletes the representations, their sources and the view."""
        for source in (self.floor_source, self.ball_source, self.arrow_source):
            pv.Delete(source)
        pv.Delete(self.view)


def brightness(pixels, column, row):
    """Mean level of a small patch around that fraction of the width and height."""
    x, y = int(column * pixels.shape[1]), int(row * pixels.shape[0])
    return float(pixels[y - 2:y + 3, x - 2:x + 3, :3].mean())


#: on the floor right in front of the ball, in front of the middle arrow, and far from both; fractions of width and height
NEAR_BALL, NEAR_ARROW, FAR = (0.36, 0.655), (0.65, 0.69), (0.80, 0.80)


def shadows(mode, name):
    """What is hidden darkens nothing any more, and what is left keeps its own shadow."""
    failures = []
    scene = Scene(mode)
    seen = {}
    for state in ("all", "no-ball", "no-arrows"):
        scene.ball.Visibility = state != "no-ball"
        scene.arrows.Visibility = state != "no-arrows"
        scene.floor.SamplesPerPixel = SAMPLES if state == "all" else SAMPLES // 4
        pixels = session.capture(scene.view, "light-" + name + ("" if state == "all" else "-" + state))
        seen[state] = [brightness(pixels, *place) for place in (NEAR_BALL, NEAR_ARROW, FAR)]
        print("%s, %s: near the ball %.1f, near the arrow %.1f, far %.1f" % ((name, state) + tuple(seen[state])))
        if state == "all":
            failures += comparison.against_baseline(pixels, "light-" + name)
    everything, no_ball, no_arrows = seen["all"], seen["no-ball"], seen["no-arrows"]
    for what, left, right in (("the ball's shadow ends with the ball", no_ball[0], everything[0]),
                              ("the arrow's shadow ends with the arrow", no_arrows[1], everything[1]),
                              ("the ball's shadow is dark", everything[2], everything[0])):
        if not left > right + 5.0:
            failures.append("%s: %s: %.1f is not clearly brighter than %.1f" % (name, what, left, right))
    if abs(no_arrows[0] - everything[0]) > 4.0:
        failures.append("%s: hiding arrows changed the ball's shadow from %.1f to %.1f" % (name, everything[0], no_arrows[0]))
    scene.close()
    return failures


def denoised():
    """Within surfaces four samples come closer to sixty-four when their noise is smoothed, and finished images are left alone."""
    scene = Scene("Ambient Occlusion", 160)
    pictures = {}
    for name, samples, when in (("truth", SAMPLES, "Never"), ("noisy", 4, "Never"), ("refining", 4, "While Refining"),
                                ("denoised", 4, "Always")):
        for shown in (scene.floor, scene.ball, scene.arrows):
            shown.SamplesPerPixel = samples
            shown.Denoising = when
        pictures[name] = session.capture(scene.view, "light-noise-" + name).astype(float)
    scene.close()
    truth = pictures["truth"].mean(axis=2)
    inside = numpy.maximum(*[numpy.abs(slope) for slope in numpy.gradient(truth)]) < 4.0
    error = {name: float(numpy.square(picture - pictures["truth"])[inside].mean()) for name, picture in pictures.items()}
    print("squared error of 4 samples %.1f, denoised %.1f" % (error["noisy"], error["denoised"]))
    failures = []
    if not error["denoised"] < 0.5 * error["noisy"]:
        failures.append("denoising takes the squared error from %.1f to %.1f only" % (error["noisy"], error["denoised"]))
    if (pictures["refining"] != pictures["noisy"]).any():
        failures.append("a finished picture was denoised without being asked to")
    return failures


def lit_ball(view, name):
    """Levels in [0, 1] of the ball's inner pixels, and the place of the brightest of them (columns, rows from the ball's middle)."""
    pixels = session.capture(view, "light-studio-" + name)[..., :3] / 255.0
    rows, columns = numpy.mgrid[:pixels.shape[0], :pixels.shape[1]] - numpy.array(pixels.shape[:2]).reshape(2, 1, 1) / 2.0 + 0.5
    inside = numpy.hypot(rows, columns) < 0.95 * 0.5 * pixels.shape[0] / 1.2
    levels = pixels[inside]
    brightest = levels.sum(axis=-1) >= numpy.quantile(levels.sum(axis=-1), 0.98)
    return levels, (columns[inside][brightest].mean(), -rows[inside][brightest].mean())


def luminance(levels):
    """Linear luminance of display levels."""
    return to_light(levels) @ numpy.array([0.2126, 0.7152, 0.0722])


def studio():
    """Without any setting light shows form, keeps colors, burns nothing out and is not black among glyphs."""
    checks = Checks()
    view = session.view(120, 120, background=(255, 255, 255))
    points = session.source(session.poly_data(numpy.array([[0.0, 0.0, 0.0]]), value=numpy.array([1.0])))
    ball = session.glyphs(points, view, "Sphere", samples=32, Orient=0, ScaleFactor=1.0)
    table = pv.GetColorTransferFunction("value")
    red = (0.706, 0.016, 0.150)  # the upper end of ParaView's Cool to Warm
    table.RGBPoints = [0.0, *red, 1.0, *red]
    session.look(view, (0.0, 0.0, 4.0), parallel_scale=0.6)
    for mode in ("Ambient Occlusion", "Path Tracing"):
        ball.ShadingMode = mode
        session.solid(ball, (0.75, 0.75, 0.75))
        levels, place = lit_ball(view, mode)
        dark, bright = numpy.quantile(luminance(levels), [0.02, 0.98])
        print("%s: a gray ball's luminance is %.3f to %.3f, brightest at %s" % (mode, dark, bright, place))
        checks.true("%s: lit and shaded side of a gray ball are %.3f and %.3f" % (mode, bright, dark), bright >= 3.0 * dark)
        checks.true("%s: the light comes from above" % mode, place[1] > 10.0)
        if mode == "Path Tracing":
            checks.true("the key light comes from the left", place[0] < -5.0)
            before = session.capture(view, "light-studio-front").astype(float)
            session.look(view, (4.0, 0.0, 0.0), up=(0.0, 0.0, 1.0), parallel_scale=0.6)
            checks.true("the light follows the camera", numpy.abs(session.capture(view, "light-studio-side") - before).max() < 24.0)
            session.look(view, (0.0, 0.0, 4.0), parallel_scale=0.6)
        session.solid(ball, (1.0, 1.0, 1.0))
        levels, _ = lit_ball(view, mode + "-white")
        checks.true("%s: white is burnt out" % mode, levels.max() < 1.0)
        ball.ColorArrayName, ball.LookupTable = ["POINTS", "value"], table
        levels, _ = lit_ball(view, mode + "-red")
        fully = levels[levels.sum(axis=-1).argsort()[-20:]].mean(axis=0)
        checks.true("%s: a fully lit color is %s instead of %s" % (mode, fully, red), numpy.abs(fully - red).max() * 255.0 <= 12.0)
    session.solid(ball, (0.75, 0.75, 0.75))
    # A light that is placed in the scene takes the key light's place.
    lamp = pv.AddLight(view=view)
    lamp.Coords, lamp.Type, lamp.Position, lamp.FocalPoint = "Scene", "Directional", [10.0, -10.0, 2.0], [0.0, 0.0, 0.0]
    _, place = lit_ball(view, "lamp")
    checks.true("a light from the lower right takes the key light's place: brightest at %s" % (place,), place[0] > 5.0)
    pv.Delete(points)
    pv.Delete(view)

    # A crowd of which the glyphs nearly touch
    view = session.view(160, 160, background=(255, 255, 255))
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(12.0)] * 3), axis=-1).reshape(-1, 3)
    points = session.source(session.poly_data(grid + numpy.random.default_rng(3).uniform(-0.2, 0.2, grid.shape)))
    crowd = session.glyphs(points, view, "Sphere", samples=8, Orient=0, ScaleFactor=0.9)
    session.look(view, (24.0, 20.0, 30.0), (5.5, 5.5, 5.5), parallel_scale=5.0)
    means = {}
    for mode in ("Local", "Ambient Occlusion", "Path Tracing"):
        crowd.ShadingMode = mode
        pixels = session.capture(view, "light-studio-crowd-" + mode)[..., :3] / 255.0
        means[mode] = pixels.mean()
        print("%s: a crowd's mean level is %.3f, %.2f %% are darker than a tenth" % (mode, means[mode], 100.0 * (pixels.max(axis=-1) < 0.1).mean()))
        checks.true("%s: a crowd has black pixels" % mode, mode == "Local" or (pixels.max(axis=-1) < 0.1).mean() < 0.05)
    checks.true("ambient occlusion is dark: %s" % means, means["Ambient Occlusion"] >= 0.75 * means["Local"])
    pv.Delete(points)
    pv.Delete(view)
    return checks.failures


def surrounded():
    """The view's environment image lights path-traced glyphs, from the side on which VTK shows it."""
    columns, rows = 64, 32
    pixels = numpy.zeros((rows, columns, 3), numpy.uint8)
    pixels[:, :, 2] = 60                                    # dim blue all around,
    pixels[:, columns * 3 // 8:columns * 5 // 8, 0] = 255   # red along the view's environment right, which is +x
    path = session.output("light-environment-input.png")
    comparison.write_image(path, pixels)
    # The same with more columns than are kept. Few rows: ParaView itself takes minutes to prepare a large one.
    huge = session.output("light-environment-huge.png")
    comparison.write_image(huge, numpy.repeat(numpy.repeat(pixels, 2, axis=0), 80, axis=1))

    view = session.view(160, 120, background=(255, 255, 255))
    points = session.source(session.poly_data(numpy.array([[0.0, 0.0, 0.0]])))
    ball = session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=1.0, ShadingMode="Path Tracing",
                          Illumination="Uniform", SamplesPerPixel=32)
    session.solid(ball, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 4.0), parallel_scale=0.6)
    seen, on_device = {}, {}
    for state in ("without", "with", "huge"):
        if state != "without":
            texture = pv.CreateTexture(path if state == "with" else huge)
            texture.UpdateVTKObjects()  # ParaView 5.13 reads the file only then
            view.BackgroundTexture = texture
            view.BackgroundColorMode = "Skybox"
            view.UseEnvironmentLighting = 1
        shown = session.capture(view, "light-environment-" + state)
        seen[state] = [shown[60, x, :3].astype(float) for x in (45, 80, 115)]  # left, middle, right of the ball
        on_device[state] = session.statistics(ball)["deviceBytes"]
        print("environment image %s: left, middle, right" % state, [list(color) for color in seen[state]], on_device[state], "bytes")
    pv.Delete(points)
    pv.Delete(view)
    failures = []
    left, _, right = seen["with"]
    if not (abs(seen["without"][0] - seen["without"][2]) < 12).all():
        failures.append("without an image the ball's sides differ: %s" % seen["without"])
    if not (right[0] > 150 and left[0] < 60 and right[0] > 2 * right[2]):
        failures.append("the environment image does not light the ball from its right: %s" % seen["with"])
    # 5120 x 64 texels; by halves the columns are 2560, the rows 32. Rays are aimed at other cells: noise of 32 samples.
    if not (numpy.abs(numpy.array(seen["huge"]) - numpy.array(seen["with"])) < 24).all():
        failures.append("a huge image lights the ball otherwise: %s instead of %s" % (seen["huge"], seen["with"]))
    if not 0.9e6 < on_device["huge"] - on_device["without"] < 1.5e6:
        failures.append("a huge image takes %d bytes on the device" % (on_device["huge"] - on_device["without"]))
    return failures


def resident():
    """Bytes of this process in memory, without what the C library's heaps, one or more a thread, keep for later."""
    ctypes.CDLL(None).malloc_trim(0)
    return session.memory("VmRSS")


def cycle(kind):
    """Shows two representations, renders and deletes all; (bytes on the device, of this process)."""
    view = session.view(200, 150)
    points = session.source(session.poly_data(numpy.array([[-0.6, 0.0, 0.5], [0.6, 0.0, 0.5]])))
    plane = pv.Plane()
    on_device = None
    if kind == "ray traced":
        shown = session.glyphs(points, view, "Sphere", Orient=0, ShadingMode="Ambient Occlusion")
        pv.Show(plane, view).SetRepresentationType(SURFACE)
    else:
        pv.Show(points, view).SetRepresentationType("Points")
        pv.Show(plane, view)
    session.look(view, (0.0, -5.0, 3.5))
    pv.Render(view)
    if kind == "ray traced":
        on_device = session.statistics(shown)["deviceBytes"]
    for source in (points, plane):
        pv.Delete(source)
    pv.Delete(view)
    return on_device, resident()


def cycles(count):
    """Showing and deleting everything leaves nothing behind that ParaView's own representations do not."""
    left = {}
    device = set()
    for kind in ("ray traced", "ordinary"):
        # Caches and the heap's fragments grow at first.
        for _ in range(WARM):
            _, start = cycle(kind)
        for _ in range(count):
            on_device, end = cycle(kind)
            device.add(on_device)
        left[kind] = (end - start) / count
    device.discard(None)
    more = left["ray traced"] - left["ordinary"]
    print("%d cycles: %s bytes on the device; a cycle leaves %.0f bytes in the process, ParaView's own %.0f"
          % (count, sorted(device), left["ray traced"], left["ordinary"]))
    failures = []
    if len(device) != 1:
        failures.append("bytes on the device change from cycle to cycle: %s" % device)
    if more > LEAK:
        failures.append("%.0f bytes stay behind a cycle; at most %d may" % (more, LEAK))
    return failures


session.load()
if sys.argv[1:2] == ["cycles"]:
    FAILURES = cycles(int(sys.argv[2]))
else:
    FAILURES = shadows("Ambient Occlusion", "occlusion") + shadows("Path Tracing", "paths") + denoised() + surrounded() + studio()
session.finish(FAILURES)
