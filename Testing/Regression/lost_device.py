"""A lost Vulkan device: one message, and the next render shows the glyphs again on a new device. The process ends
while programs are compiled.

Usage: RTGLYPHS_FAULT=FILE VK_INSTANCE_LAYERS=...:VK_LAYER_RTGLYPHS_fault pvpython lost_device.py
The layer loses the device at the next submission when FILE is there, at each while it says "always".
"""
import os

import numpy
import paraview.simple as pv

import comparison
import session
from checks import information, stepwise

FAULT = os.environ["RTGLYPHS_FAULT"]


def lose(how):
    """From now on, once or always; None: no more."""
    if how:
        with open(FAULT, "w") as file:
            file.write(how)
    elif os.path.exists(FAULT):
        os.remove(FAULT)


def main():
    """Loses the device while the camera moves and while data arrive, in one of two views; then again and again."""
    lose(None)
    session.load()
    points = numpy.random.default_rng(1).uniform(-1.0, 1.0, (300, 3))
    data = session.source(session.poly_data(points, scalar=points[:, 0]))
    views = [session.view(200, 150), session.view(200, 150)]
    for view in views:
        shown = session.glyphs(data, view, "Box", Orient=0, ScaleFactor=0.2)
        pv.ColorBy(shown, ("POINTS", "scalar"))
        shown.SetScalarBarVisibility(view, False)
        session.look(view, (0.0, 0.0, 5.0))
        pv.Render(view)
    view, other = views
    shown_here = pv.GetRepresentation(data, view)
    failures = []

    def moved(x):
        session.look(view, (x, 0.0, 5.0))
        pv.Render(view)

    def expect(what, said, times):
        print("%s: %d messages" % (what, said.count("was lost")))
        if said.count("was lost") != times:
            failures.append("%s: %d messages of a lost device, %d expected: %s" % (what, said.count("was lost"), times, said))

    def expect_picture(what, of_view, wanted):
        if (session.capture(of_view, "lost-" + what.replace(" ", "-")) != wanted).any():
            failures.append("%s: the picture is another one" % what)

    moved(2.0)
    expected = session.capture(view, "lost-expected")
    expected_other = session.capture(other, "lost-expected-other")
    if comparison.covered(expected).mean() < 0.1:
        failures.append("no glyphs in the first place")

    moved(1.0)
    lose("once")
    expect("tracing", session.messages(lambda: moved(2.0)), 1)
    if os.path.exists(FAULT):
        failures.append("the device was not lost")
    expect("next render", session.messages(lambda: pv.Render(view)), 0)
    expect_picture("after tracing", view, expected)
    expect("other view", session.messages(lambda: pv.Render(other)), 0)
    expect_picture("other view", other, expected_other)

    lose("once")
    more = session.poly_data(points * 1.01, scalar=points[:, 0])
    expect("new data", session.messages(lambda: (session.replace_data(data, more), pv.Render(view))), 1)
    session.replace_data(data, session.poly_data(points, scalar=points[:, 0]))
    expect("data of before", session.messages(lambda: pv.Render(view)), 0)
    expect_picture("after new data", view, expected)

    # A second device is tried and lost, no third one until there is something else to show. Where both are lost in the
    # same call they say the same, which is said once.
    lose("always")
    expect("again and again", session.messages(lambda: [moved(x) for x in (0.5, 0.6, 0.7, 0.8)]), 1)
    lose(None)
    shown_here.ScaleFactor = 0.3
    pv.Render(view)
    shown_here.ScaleFactor = 0.2
    expect("whole again", session.messages(lambda: moved(2.0)), 0)
    expect_picture("whole again", view, expected)

    # The process ends while programs are compiled, and no device outlives it, as the layer sees.
    stepwise(shown_here)
    pv.Render(view)
    if information(shown_here, "programsAhead") == 0:
        failures.append("no program is compiled at the end")
    session.finish(failures)


if __name__ == "__main__":
    main()
