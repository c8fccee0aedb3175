"""After a failed image or failed data the next change that may help draws again: another size, shading or number of
samples, or less to show. Colors and ids are right then.

Usage: RTGLYPHS_FAULT=FILE VK_INSTANCE_LAYERS=...:VK_LAYER_RTGLYPHS_fault pvpython failed_image.py
"""
import os

import numpy
import paraview.simple as pv

import accumulation
import session
from checks import Checks

FAULT = os.environ["RTGLYPHS_FAULT"]
#: pieces of memory share few allocations, and each piece is a buffer
MAKE = "vkCreateBuffer"
#: more calls than one render makes
CALLS = 30
SMALL, LARGE = [160, 120], [240, 180]


def fail(order=None):
    """Makes a Vulkan call fail from now on (see FaultLayer.cxx); None: no more."""
    if order:
        with open(FAULT, "w", encoding="utf-8") as file:
            file.write(order)
    elif os.path.exists(FAULT):
        os.remove(FAULT)


def balls(view, seed, **properties):
    """Colored spheres."""
    points = numpy.random.default_rng(seed).uniform(-1.0, 1.0, (200, 3))
    source = session.source(session.poly_data(points, scalar=numpy.random.default_rng(seed + 1).uniform(0.0, 1.0, 200)))
    shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.25, **properties)
    pv.ColorBy(shown, ("POINTS", "scalar"))
    shown.SetScalarBarVisibility(view, False)
    return source, shown, points


def picture(view):
    """What the view shows after a render."""
    pv.Render(view)
    return accumulation.shown_by(view)


def occluded(size):
    """(view, representation): spheres with ambient occlusion."""
    view = session.view(*size)
    _, shown, _ = balls(view, 1, ShadingMode="Ambient Occlusion", samples=4)
    session.look(view, (0.0, 0.0, 5.0))
    return view, shown


def remedies(checks):
    """A large picture fails for want of memory; what a user would then try helps, although the data stay the same."""
    def smaller(view, _):
        view.ViewSize = [120, 90]

    def local(_, shown):
        shown.ShadingMode = "Local"

    def fewer(_, shown):
        shown.SamplesPerPixel = 2

    for what, remedy in (("another size", smaller), ("another shading", local), ("fewer samples", fewer)):
        view, shown = occluded(LARGE)
        remedy(view, shown)
        expected = picture(view)
        checks.covered(what + ", without failure", expected, 0.1)
        pv.Delete(view)
        view, shown = occluded(SMALL)
        pv.Render(view)
        fail(MAKE + " 1 always")
        view.ViewSize = LARGE
        checks.one_message("larger picture", session.messages(lambda: pv.Render(view)), "memory")
        fail()
        remedy(view, shown)
        found = []
        checks.no_message(what + ", afterwards", session.messages(lambda: found.append(picture(view))))
        checks.picture("after a failed image, " + what, found[0], expected)
        pv.Delete(view)


def freed_memory(checks):
    """Data that did not fit, new or shown again, are shown when others are hidden, with their own colors and ids."""
    view = session.view(*SMALL)
    session.look(view, (0.0, 0.0, 5.0))
    source, shown, points = balls(view, 3)
    expected = picture(view)
    nearest = numpy.argsort(-points[:, 2])[:8]

    def ids():
        return [session.picked(view, "POINT", session.pixel_of(view, points[i])) for i in nearest]

    expected_ids = ids()
    checks.true("no ids are selected in the first place", sum(len(found) for found in expected_ids) >= 6)
    pv.Delete(shown)
    _, other, _ = balls(view, 9)
    shown, reached = None, 0
    for order in [MAKE + " 1 always"] + ["%s %d" % (MAKE, n) for n in range(1, CALLS)]:
        other.Visibility = 1
        pv.Render(view)
        fail(order)
        if shown:
            shown.Visibility = 1
        else:
            shown = session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.25)
            pv.ColorBy(shown, ("POINTS", "scalar"))
            shown.SetScalarBarVisibility(view, False)
        said = session.messages(lambda: pv.Render(view))
        if not said:
            break
        reached += 1
        fail()
        checks.one_message(order, said, "memory")
        other.Visibility = 0
        found = []
        checks.no_message(order + ", other data hidden", session.messages(lambda: found.append(picture(view))))
        checks.picture(order + ", other data hidden", found[0], expected, pixels=0.0, mean=0.0)
        checks.equal(order + ", other data hidden: glyphs with another id",
                     sum(a != b for a, b in zip(ids(), expected_ids)), 0)
        shown.Visibility = 0
    fail()
    checks.true("only %d calls have failed" % reached, reached >= 3)
    pv.Delete(view)


def main():
    """Both parts."""
    fail()
    session.load()
    checks = Checks()
    remedies(checks)
    freed_memory(checks)
    fail()
    checks.report()


if __name__ == "__main__":
    main()
