"""Motion blur of surfaces and of mesh glyphs in ParaView: streaks where the arrays say, in every shading mode; bad input.

Usage: pvpython motion_mesh.py
"""
import numpy
import paraview.simple as pv

import bad_input
import session

HALF = 0.3  # width of the plate, from its middle
TIMES = (numpy.arange(500) + 0.5) / 500.0 - 0.5
CORNERS = numpy.array([[-HALF, -0.2, 0.0], [HALF, -0.2, 0.0], [HALF, 0.2, 0.0], [-HALF, 0.2, 0.0]])
ALONG = numpy.array([[0.6, 0.0, 0.0]] * 4)


def plate(**arrays):
    """Two triangles."""
    return session.with_cells(session.poly_data(CORNERS, **arrays), "Polys", ((0, 1, 2), (0, 2, 3)))


class Streaks:
    """Something white that shines, seen in parallel projection, 100 pixels a unit."""

    def __init__(self, failures):
        self.failures = failures
        self.view = session.view(400, 100)
        session.look(self.view, (0.0, 0.0, 5.0), parallel_scale=0.5)
        self.shown = None

    def show(self, source, kind, **properties):
        """Shows it instead of what was there."""
        if self.shown:
            self.shown.Visibility = 0
        self.shown = pv.Show(source, self.view)
        self.shown.SetRepresentationType(kind)
        session.solid(self.shown, (1.0, 1.0, 1.0))
        self.shown.Ambient, self.shown.Diffuse, self.shown.SamplesPerPixel = 1.0, 0.0, 64
        self.set(**properties)

    def set(self, **properties):
        """Sets properties."""
        for name, value in properties.items():
            setattr(self.shown, name, value)

    def expect(self, condition, what):
        """Takes note of what does not hold."""
        if not condition:
            self.failures.append(what)

    def streak(self, name, left, right, **properties):
        """The middle row must be covered for the fraction of the times at which it lies between left and right of any."""
        self.set(**properties)
        image = session.capture(self.view, "motion-mesh-" + name.replace(" ", "-"))
        # The background's green is 0.
        found = image[50, :, 1].astype(float) / 255.0
        column = (numpy.arange(400) + 0.5 - 200.0) / 100.0
        fine = (column[:, None] + (numpy.arange(8) - 3.5) / 800.0)[:, :, None]
        expected = 0.0
        for a, b in zip(left, right):
            expected = expected + ((fine > a) & (fine < b)).mean(axis=(1, 2))
        worst = numpy.abs(found - expected).max()
        print("%s: coverage differs by at most %.3f" % (name, worst))
        # Four of 64 samples: 64 strata of time, up to four times at which an edge crosses the pixel.
        self.expect(worst < 0.0625, "%s: coverage differs by %.3f" % (name, worst))
        return image


def surface(streaks):
    """A plate that goes, slows, grows and turns back; every shading mode; another step; bad input."""
    slowing = numpy.array([[-2.0, 0.0, 0.0]] * 4)
    data = plate(velocity=ALONG, slowing=slowing, growing=numpy.array([[1.0, 0.0, 0.0]]) * CORNERS, nothing=0.0 * ALONG,
                 vx=ALONG[:, 0], vy=ALONG[:, 1], vz=ALONG[:, 2])
    source = session.source(data)
    streaks.show(source, "Ray Traced Surface", VelocityArray="velocity", ShutterTime=1.0)
    rest = numpy.zeros(1)
    still = streaks.streak("surface off", [rest - HALF], [rest + HALF])
    streaks.streak("surface centered", [0.6 * TIMES - HALF], [0.6 * TIMES + HALF], MotionBlur=1)
    streaks.streak("surface of three arrays", [0.6 * TIMES - HALF], [0.6 * TIMES + HALF], VelocityArray="vx, vy, vz")
    streaks.streak("surface half the time", [0.3 * TIMES - HALF], [0.3 * TIMES + HALF], ShutterTime=0.5)
    streaks.set(ShutterTime=1.0)
    later = TIMES + 0.5
    way = 0.6 * later - later ** 2
    streaks.streak("surface there and back", [way - HALF], [way + HALF], ShutterOpening="Forward", AccelerationArray="slowing")
    grown = HALF * (1.0 + TIMES)
    streaks.streak("surface that grows", [-grown], [grown], ShutterOpening="Centered", AccelerationArray="None",
                   VelocityArray="growing")
    nothing = streaks.streak("surface at rest", [rest - HALF], [rest + HALF], VelocityArray="nothing")
    streaks.expect((nothing == still).all(), "zero velocities do not give the surface at rest")
    # Shapes of the blur do not depend on the light; times of these are drawn pixel by pixel.
    for mode in ("Ambient Occlusion", "Path Tracing"):
        streaks.streak("surface " + mode, [0.6 * TIMES - HALF], [0.6 * TIMES + HALF], VelocityArray="velocity", ShadingMode=mode,
                       SamplesPerPixel=256)
    streaks.set(ShadingMode="Local", SamplesPerPixel=64)

    before = session.statistics(streaks.shown)
    pv.Render(streaks.view)
    streaks.set(DiffuseColor=[1.0, 1.0, 0.9])
    pv.Render(streaks.view)
    after = session.statistics(streaks.shown)
    for key in ("instanceUploads", "structureBuilds"):
        streaks.expect(after[key] == before[key], "another color: %s went from %s to %s" % (key, before[key], after[key]))
    streaks.set(DiffuseColor=[1.0, 1.0, 1.0])

    broken = ALONG.copy()
    broken[1, 0] = numpy.nan

    def case(name, words, share, velocity=ALONG, **properties):
        streaks.set(MotionBlur=0)
        pv.Render(streaks.view)
        session.replace_data(source, plate(velocity=velocity, scalar=numpy.ones(4)))
        streaks.set(**{"VelocityArray": "velocity", "ShutterTime": 1.0, "MotionBlur": 1, **properties})
        text = session.messages(lambda: [pv.Render(streaks.view), pv.Render(streaks.view)])
        print("%s: %s" % (name, text.strip() or "no message"))
        for word in words:
            streaks.expect(word in text, "%s: the message does not speak of '%s': %s" % (name, word, text.strip()))
        streaks.expect(text.count("Warning:") == (1 if words else 0), "%s: not one message: %s" % (name, text.strip()))
        # In square units; blur moves it and takes nothing away.
        covered = session.capture(streaks.view, "motion-mesh-bad")[:, :, 1].sum() / 255.0 / 1e4
        streaks.expect(share is None or abs(covered - share * 0.8 * HALF) < 0.01, "%s covers %.3f" % (name, covered))

    case("surface, good", (), 1.0)
    case("surface, missing array", ("'nonesuch'", "VelocityArray"), 1.0, VelocityArray="nonesuch")
    case("surface, NaN velocity", ("1 of 2 triangles", "motion"), 0.5, broken)
    case("surface, negative shutter", ("ShutterTime is -1", "positive"), 1.0, ShutterTime=-1.0)
    case("surface, through the scene", (), None, 1e6 * ALONG)
    case("surface, good again", (), 1.0)
    streaks.streak("surface good again", [0.6 * TIMES - HALF], [0.6 * TIMES + HALF])


def mesh_glyphs(streaks):
    """Boxes made of triangles at three points, and what picking says of one."""
    data = session.poly_data(bad_input.LINE, velocity=ALONG[:3], turning=numpy.array([[0.0, 0.0, 40.0 * numpy.pi]] * 3))
    points = session.source(data)
    streaks.show(points, session.REPRESENTATION, GlyphType=session.triangles(pv.Box()), ScaleFactor=0.2, Orient=0,
                 ScaleMode="No Data Scaling Off", VelocityArray="velocity", MotionBlur=1, ShutterTime=1.0)
    centers = (-1.0, 0.0, 1.0)
    streaks.streak("mesh glyphs", [x + 0.6 * TIMES - 0.1 for x in centers], [x + 0.6 * TIMES + 0.1 for x in centers])
    text = session.messages(lambda: pv.Render(streaks.view))
    streaks.expect(not text.strip(), "mesh glyphs: " + text.strip())
    # A fast turn covers a disc round each glyph's middle: half a diagonal at the most, half a side all the time.
    image = session.capture(streaks.view, "motion-mesh-turning") if not streaks.set(
        VelocityArray="None", AngularVelocityArray="turning") else None
    green = image[50, 180:221, 1].astype(float) / 255.0
    streaks.expect(green[12:29].min() == 1.0, "a turning box does not cover its inside all the time")
    streaks.expect(0.0 < green[8] < 1.0 and 0.0 < green[32] < 1.0, "a turning box is not blurred at its corners")
    streaks.expect(green[:5].max() == 0.0, "a turning box is seen where it never is")


def main():
    """Runs both."""
    session.load()
    streaks = Streaks([])
    surface(streaks)
    mesh_glyphs(streaks)
    session.finish(streaks.failures)


if __name__ == "__main__":
    main()
