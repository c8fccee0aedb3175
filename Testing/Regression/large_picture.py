"""A picture much larger than the window is made of tiles: it shows the same as a small one, and takes little memory besides itself.

Usage: pvpython large_picture.py SIDE
"""
import sys

import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

BLOCKS = 64
#: bytes beyond the picture
LIMIT = 2 * 10**9


def coverage(picture):
    """Fraction of covered pixels of each block."""
    side = picture.shape[0] // BLOCKS
    return comparison.covered(picture).reshape(BLOCKS, side, BLOCKS, side).mean(axis=(1, 3))


def main(side):
    """A ball of spheres, small and large."""
    session.load()
    checks = Checks()
    view = session.view(512, 512)
    random = numpy.random.default_rng(1)
    points = session.source(session.poly_data(random.uniform(-1.0, 1.0, (20000, 3)), diameter=random.uniform(0.02, 0.05, 20000)))
    shown = session.glyphs(points, view, "Sphere", ScaleMode="Magnitude", SelectScaleArray="diameter", ScaleFactor=1.0)
    session.look(view, (2.0, 3.0, 4.0), parallel_scale=1.5)
    small = coverage(session.capture(view, "large-picture-small"))
    shown.SamplesPerPixel = 1
    pv.Render(view)
    before = session.memory("VmRSS")
    path = session.output("large-picture.png")
    pv.SaveScreenshot(path, view, ImageResolution=[side, side], CompressionLevel="1")
    more = session.memory("VmHWM") - before
    print("%d x %d: %.2f GB besides what the process held, %.2f of it the picture" % (side, side, more / 1e9, 3e-9 * side * side))
    checks.true("memory beyond the picture", more - 3 * side * side < LIMIT)
    picture = session.read_image(path)
    checks.equal("size", picture.shape[:2], (side, side))
    apart = numpy.abs(coverage(picture) - small)
    print("coverage of blocks differs by %.3f at most, %.5f in the mean" % (apart.max(), apart.mean()))
    checks.within("coverage of a block", apart.max(), 0.0, 0.1)
    checks.within("coverage, mean difference", apart.mean(), 0.0, 0.01)
    checks.report()


if __name__ == "__main__":
    main(int(sys.argv[1]))
