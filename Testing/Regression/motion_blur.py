"""Motion blur in ParaView: streaks where the arrays say, bad input, and what is sent again when.

Usage: pvpython motion_blur.py
"""
import numpy
import paraview.simple as pv

import bad_input
import comparison
import scale_guess
import session
from checks import Checks

#: Script of a filter.
IDS = """
import numpy
output.PointData.append(numpy.arange(output.GetNumberOfPoints()), "id")
"""
VELOCITY = numpy.array([[0.6, 0.0, 0.0]] * 3)


def opacity(image, row):
    """How far the white glyphs cover a row of pixels, 0 to 1: the background's green is 0."""
    return image[row, :, 1].astype(float) / 255.0


class Blur:
    """Three white, self-lit spheres of radius 0.1 on a line, seen in parallel projection, 100 pixels a unit."""

    def __init__(self):
        self.failures = []
        self.view = session.view(400, 100)
        session.look(self.view, (0.0, 0.0, 5.0), parallel_scale=0.5)
        spin = numpy.array([[0.0, 0.0, 1.0]] * 3)
        self.data = session.poly_data(bad_input.LINE, velocity=VELOCITY, turning=0.0 * VELOCITY + spin,
                                      slowing=numpy.array([[-2.0, 0.0, 0.0]] * 3), nothing=0.0 * VELOCITY)
        self.data.GetPointData().SetActiveVectors("velocity")
        self.points = session.source(self.data)
        self.shown = session.glyphs(self.points, self.view, samples=64, Orient=0, ScaleFactor=0.2)
        session.solid(self.shown, (1.0, 1.0, 1.0))
        self.shown.Ambient, self.shown.Diffuse = 1.0, 0.0

    def picture(self, name, **properties):
        """Sets properties and takes the picture."""
        for key, value in properties.items():
            setattr(self.shown, key, value)
        return session.capture(self.view, "motion-" + name)

    def expect(self, condition, what):
        """Takes note of what does not hold."""
        if not condition:
            self.failures.append(what)

    def streak(self, name, image, positions):
        """The middle row around x = 0 must be covered for the fraction of the displacements, given over time, that it is."""
        found = opacity(image, 50)[150:250]
        # Means over the pixels of this row, the first below the axis.
        half = numpy.sqrt(0.1 ** 2 - ((numpy.arange(4) + 0.5) / 400.0) ** 2)
        column = (numpy.arange(150, 250) + 0.5 - 200.0) / 100.0
        fine = column[:, None] + (numpy.arange(8) - 3.5) / 800.0
        expected = 0.0
        for center in (-1.0, 0.0, 1.0):
            away = numpy.abs(fine[:, :, None, None] - center - positions[:, None])
            expected = expected + (away < half).mean(axis=(1, 2, 3))
        worst = numpy.abs(found - expected).max()
        print("%s: coverage differs by at most %.3f" % (name, worst))
        # Four of 64 samples: 64 strata of time, up to four times at which an edge crosses the pixel.
        self.expect(worst < 0.0625, "%s: coverage differs by %.3f" % (name, worst))


def looks(blur):
    """Without blur, straight, with acceleration, and the shutter's openings."""
    expect = blur.expect
    expect(blur.shown.AccelerationArray == "None" or blur.shown.AccelerationArray[-1] in ("None", ""),
           "AccelerationArray is %s, not None by default" % blur.shown.AccelerationArray)
    still = blur.picture("off", VelocityArray="velocity", ShutterTime=1.0)
    blur.streak("off", still, numpy.zeros(1))
    times = (numpy.arange(500) + 0.5) / 500.0 - 0.5
    blur.streak("centered", blur.picture("centered", MotionBlur=1), 0.6 * times)
    blur.streak("half the time", blur.picture("half", ShutterTime=0.5), 0.3 * times)
    blur.streak("forward", blur.picture("forward", ShutterOpening="Forward"), 0.3 * (times + 0.5))
    blur.streak("backward", blur.picture("backward", ShutterOpening="Backward"), 0.3 * (times - 0.5))
    way = 0.6 * times - times ** 2
    blur.streak("accelerated", blur.picture(
        "accelerated", ShutterOpening="Centered", ShutterTime=1.0, AccelerationArray="slowing"), way)
    nothing = blur.picture("at rest", VelocityArray="nothing", AccelerationArray="None")
    expect((nothing == still).all(), "zero velocities do not give the picture at rest")


def bad(blur):
    """Each bad input: one message, and the glyphs that can be shown are."""
    nothing = 0.0 * VELOCITY
    broken, endless = 0.1 * VELOCITY, nothing.copy()
    broken[1, 2] = numpy.nan
    endless[1, 0] = 1e38
    good = session.poly_data(bad_input.LINE, v=0.1 * VELOCITY, scalar=numpy.ones(3))

    def case(name, data, glyphs, words, **properties):
        blur.shown.MotionBlur = 0
        pv.Render(blur.view)
        session.replace_data(blur.points, data)
        for key, value in {"VelocityArray": "v", "AccelerationArray": "None", "ShutterTime": 1.0, "MotionBlur": 1,
                           **properties}.items():
            setattr(blur.shown, key, value)
        text = session.messages(lambda: [pv.Render(blur.view), pv.Render(blur.view)])
        print("%s: %s" % (name, text.strip() or "no message"))
        for word in words:
            blur.expect(word in text, "%s: the message does not speak of '%s': %s" % (name, word, text.strip()))
        blur.expect(text.count("Warning:") == (1 if words else 0), "%s: not one message: %s" % (name, text.strip()))
        found = session.statistics(blur.shown)["glyphs"]
        blur.expect(found == glyphs, "%s: %d glyphs instead of %d" % (name, found, glyphs))

    case("good", good, 3, ())
    case("missing array", good, 3, ("'nonesuch'", "VelocityArray", "or None"), VelocityArray="nonesuch")
    case("scalar velocity", good, 3, ("'scalar'", "1 components"), VelocityArray="scalar")
    case("no velocity", good, 3, ("MotionBlur", "VelocityArray", "switch MotionBlur off"), VelocityArray="None")
    case("negative shutter", good, 3, ("ShutterTime is -1", "positive"), ShutterTime=-1.0)
    case("NaN velocity", session.poly_data(bad_input.LINE, v=broken), 2, ("1 of 3", "velocity"))
    case("endless way", session.poly_data(bad_input.LINE, v=endless), 2, ("1 of 3", "velocity"), ShutterTime=1e3)
    case("through the scene", session.poly_data(bad_input.LINE, v=1e6 * VELOCITY), 3, ())
    case("good again", good, 3, ())
    blur.expect(comparison.covered(session.capture(blur.view, "motion-good-again"))[50, 200], "no glyph is seen any more")


def series(failures):
    """Steps of a series with ever other numbers of points: one upload a step, the same memory whenever the same step comes."""
    view = session.view(100, 100)
    points = session.source(session.poly_data(numpy.zeros((0, 3)), v=numpy.zeros((0, 3))))
    shown = session.glyphs(points, view, Orient=0, ScaleFactor=0.1, MotionBlur=1, VelocityArray="v",
                           AccelerationArray="None", ShutterTime=0.2)
    session.look(view, (0.0, 0.0, 6.0))
    size = []
    for step in range(40):
        count, generator = (300, 300, 500, 0, 1)[step % 5], numpy.random.default_rng(step % 5)
        before = session.statistics(shown)
        session.replace_data(points, session.poly_data(
            generator.uniform(-1.0, 1.0, (count, 3)), v=generator.uniform(-1.0, 1.0, (count, 3))))
        text = session.messages(lambda: pv.Render(view))
        if text.strip():
            failures.append("step %d: %s" % (step, text.strip()))
        after = session.statistics(shown)
        uploads = after.get("instanceUploads", 0) - before.get("instanceUploads", 0)
        if uploads != (1 if count else 0):
            failures.append("step %d of %d points: %d uploads" % (step, count, uploads))
        if after["pipelineBuilds"] != before.get("pipelineBuilds", 0) and step > 0:
            failures.append("step %d built a pipeline" % step)
        size.append(after["deviceBytes"])
    print("bytes on the device:", size[5:10])
    if size[10:] != size[5:-5]:
        failures.append("the device's memory of equal steps: %s bytes" % size)
    before = session.statistics(shown)
    shown.ShutterTime = 0.3
    pv.Render(view)
    after = session.statistics(shown)
    for key in ("colorUploads", "pipelineBuilds"):
        if after[key] != before[key]:
            failures.append("another ShutterTime: %s went from %s to %s" % (key, before[key], after[key]))


def shutter(shown, view):
    """The shutter time after a render without a word, and whether the data have chosen it."""
    said = session.messages(lambda: pv.Render(view))
    return (shown.ShutterTime or scale_guess.shutter_time(shown), shown.ShutterTime == 0.0) if not said.strip() else said


def from_data(checks):
    """Ticking MotionBlur is enough in any unit of time: the 95 % quantile of the speeds makes a streak of three glyph sizes."""
    view = session.view(160, 120)
    grid = scale_guess.grid()
    speeds = numpy.linspace(0.0, 1.0, len(grid))
    for unit in (1e-7, 1.0, 4e4):
        data = session.poly_data(grid, velocity=unit * speeds[:, None] * [1.0, 0.0, 0.0], spin=numpy.tile([0.0, 0.0, unit], (len(grid), 1)))
        source = session.source(data)
        shown = session.glyphs(source, view, samples=8, Orient=0)
        pv.ResetCamera(view)
        still = comparison.covered(session.capture(view, "motion-data-still")).mean()
        shown.MotionBlur = 1
        time, of_data = shutter(shown, view)
        checks.equal("speeds of %g: whether the data have chosen ShutterTime" % unit, of_data, True)
        checks.within("speeds of %g: streaks, in glyph sizes" % unit, time * 0.95 * unit / shown.ScaleFactor, 2.7, 3.1)
        checks.true("speeds of %g: Statistics does not name the ShutterTime" % unit,
                    any(sentence.startswith("ShutterTime ") for sentence in session.statistics(shown)["choices"]))
        blurred = session.capture(view, "motion-data-%g" % unit)
        checks.within("speeds of %g: covered, of what is covered at rest" % unit, comparison.covered(blurred).mean() / still, 1.02, 2.0)
        shown.ShutterTime = 2.0 * time
        shown.ShutterTime = time
        checks.equal("speeds of %g: ShutterTime of a script" % unit, shutter(shown, view), (time, False))
        checks.true("speeds of %g: the same ShutterTime gives another picture" % unit, (session.capture(view, "motion-data-set") == blurred).all())
        shown.ScaleFactor = shown.ScaleFactor / 3.0
        checks.equal("speeds of %g: ShutterTime of a script, and other sizes" % unit, shutter(shown, view), (time, False))
        shown.SMProxy.GetProperty("ShutterTime").ResetToDomainDefaults()
        shown.SMProxy.UpdateVTKObjects()
        found, of_data = shutter(shown, view)
        checks.equal("speeds of %g: whether the data have chosen ShutterTime after a reset" % unit, of_data, True)
        checks.within("speeds of %g: ShutterTime of smaller glyphs, of that of the others" % unit, found / time, 0.31, 0.35)
        shown.VelocityArray, shown.AngularVelocityArray = "None", "spin"
        checks.within("speeds of %g: turn in radians" % unit, shutter(shown, view)[0] * unit, 0.9, 1.1)
        shown.AngularVelocityArray, shown.AccelerationArray = "None", "velocity"
        for opening, half in (("Centered", 0.5), ("Forward", 1.0), ("Backward", 1.0)):
            shown.ShutterOpening = opening
            way = 0.5 * 0.95 * unit * (half * shutter(shown, view)[0]) ** 2
            checks.within("accelerations of %g, %s: streaks, in glyph sizes" % (unit, opening), way / shown.ScaleFactor, 2.7, 3.1)
        pv.Delete(shown)
    shown = session.glyphs(source, view, samples=1, MotionBlur=1, Orient=0, ShutterTime=1.0)
    checks.equal("ShutterTime that was set before the first render", shutter(shown, view), (1.0, False))
    pv.Delete(shown)

    # One that is far faster than all others leaves the picture where it is.
    fast = speeds[:, None] * [1.0, 0.0, 0.0]
    fast[5] = [0.0, 1e6, 0.0]
    shown = session.glyphs(session.source(session.poly_data(grid, velocity=fast)), view, MotionBlur=1, Orient=0)
    checks.within("way of a fast one, of the longest side", shutter(shown, view)[0] * 1e6 / 3.5, 0.4, 0.51)
    pv.Delete(view)


def of_others(checks):
    """The same of surfaces, in fractions of their size, and of tubes, in fractions of theirs; over time, and between two steps."""
    view = session.view(160, 120)
    moved = pv.Calculator(Input=pv.Plane(XResolution=9, YResolution=9), Function="500*iHat", ResultArrayName="velocity")
    lines = pv.Calculator(Input=pv.Line(Resolution=9), Function="500*iHat", ResultArrayName="velocity")
    surface = session.show(moved, view, "Ray Traced Surface", samples=1, MotionBlur=1)
    tubes = session.show(lines, view, "Ray Traced Tubes", MotionBlur=1, TubeRadius=0.02)
    checks.within("streaks of a surface, of its side", shutter(surface, view)[0] * 500.0, 0.045, 0.0501)
    checks.within("streaks of tubes, of their width", shutter(tubes, view)[0] * 500.0 / 0.04, 2.7, 3.01)
    tubes.TubeRadius = 0.01
    checks.within("streaks of thinner tubes", shutter(tubes, view)[0] * 500.0 / 0.02, 2.7, 3.01)
    tubes.Representation = "Surface"
    tubes.Representation = "Ray Traced Surface"
    tubes.Representation = "Ray Traced Tubes"
    checks.within("streaks of tubes that were something else", shutter(tubes, view)[0] * 500.0 / 0.02, 2.7, 3.01)
    surface.VelocityArray = "None"
    checks.one_message("a surface without velocity", session.messages(lambda: pv.Render(view)), "MotionBlur", "VelocityArray")
    pv.Delete(view)

    view = session.view(80, 60)
    times = [0.0, 1.0, 2.0, 3.0, 5.0]
    source = scale_guess.series(*((time, 4, 0.2 * time) for time in times))
    ids = pv.ProgrammableFilter(Input=source, CopyArrays=1, Script=IDS)
    moving = pv.Calculator(Input=ids, Function="s*iHat", ResultArrayName="velocity")
    shown = session.glyphs(moving, view, MotionBlur=1, Orient=0, VelocityArray="velocity")
    found = []
    for time in times:
        view.ViewTime = time
        session.messages(lambda: pv.Render(view))
        found.append(scale_guess.shutter_time(shown))
    checks.equal("ShutterTime of growing speeds", found[1:3] + found[3:], [found[1], found[1], found[3], found[3]])
    checks.within("streaks of the last step, in glyph sizes", found[-1] / shown.ScaleFactor, 2.7, 3.0 * 2.5)
    shown.VelocityArray, shown.PointIdArray = "From Previous Step", "id"
    for time, wanted in ((0.0, None), (1.0, 1.0), (3.0, 2.0)):
        view.ViewTime = time
        session.messages(lambda: pv.Render(view))
        if wanted:
            checks.equal("ShutterTime between two steps", scale_guess.shutter_time(shown), wanted)
    pv.Delete(view)


def main():
    """Runs all."""
    session.load()
    blur = Blur()
    looks(blur)
    bad(blur)
    series(blur.failures)
    checks = Checks()
    from_data(checks)
    of_others(checks)
    blur.failures.extend(checks.failures)
    session.finish(blur.failures)


if __name__ == "__main__":
    main()
