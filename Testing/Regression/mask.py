"""GlyphMode: how many glyphs each mode leaves, and which.

Usage: pvpython mask.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet

import comparison
import session
from checks import Checks

SIZE = 200


def crowded(count=20000):
    """Points of the unit square, nine tenths of them in its left tenth, in random order."""
    random = numpy.random.default_rng(2)
    points = numpy.zeros((count, 3))
    points[:, :2] = random.uniform(0.0, 1.0, (count, 2))
    points[:9 * count // 10, 0] *= 0.1
    return points[random.permutation(count)]


class Masked:
    """Small spheres, and what a mask leaves of them. stage: whose display they take; nothing is masked at first."""

    def __init__(self, stage, data):
        self.stage = stage
        session.solid(stage.show(data, "Sphere", ScaleFactor=0.02), (0.9, 0.8, 0.5))

    def __call__(self, name, **properties):
        """(covered pixels, number of glyphs)."""
        self.stage.settings.add(properties)
        pv.Render(self.stage.view)
        return (comparison.covered(session.capture(self.stage.view, "mask-" + name)), session.statistics(self.stage.settings.shown)["glyphs"])


def numbers(checks, stage, points):
    """How many are left, and that a smaller number is a part of a larger one."""
    masked = Masked(stage, session.poly_data(points))
    checks.equal("without a mask", masked("all")[1], len(points))
    checks.equal("every 10th", masked("tenth", GlyphMode="Every Nth")[1], len(points) // 10)
    nth, number = masked("nth", GlyphStride=37)
    checks.equal("every 37th", number, -(-len(points) // 37))
    for mode in ("Random", "Even in Space"):
        few, number = masked(mode + "-few", GlyphMode=mode, MaximumNumberOfGlyphs=100)
        checks.equal(mode, number, 100)
        more, number = masked(mode + "-more", MaximumNumberOfGlyphs=301)
        checks.equal(mode, number, 301)
        checks.true(mode + ": 100 glyphs are not among 301", not (few & ~more).any())
        checks.equal(mode + " of fewer than the maximum", masked(mode + "-maximum", MaximumNumberOfGlyphs=len(points) + 1)[1], len(points))
    some = Masked(stage, session.poly_data(points[::37]))
    checks.true("every 37th is not every 37th", (some("37")[0] == nth).all())


def evenness(checks, stage, points):
    """Right of the crowd lie nine tenths of the square and a tenth of the points: even glyphs are there by area, random
    ones by number."""
    masked = Masked(stage, session.poly_data(points))
    right = slice(SIZE // 10 + 3, None)
    for mode, share in (("Random", 0.1), ("Even in Space", 0.9)):
        seen, number = masked("share-" + mode, GlyphMode=mode, MaximumNumberOfGlyphs=256)
        # Spheres of four pixels across cover about twelve; few overlap.
        found = seen[:, right].sum() / 12.0 / number
        print("%s: %d glyphs, %.2f of them right of the crowd, %.2f expected" % (mode, number, found, share))
        checks.within(mode + ": fraction of the glyphs right of the crowd", found, 0.75 * share, 1.3 * share)
    # No part of the square is empty: each of its 8 x 8 parts has some.
    seen = masked("parts", MaximumNumberOfGlyphs=256)[0]
    parts = seen.reshape(8, SIZE // 8, 8, SIZE // 8).any(axis=(1, 3))
    checks.equal("parts of the square with glyphs", int(parts.sum()), 64)


def odd(checks, stage):
    """Points in one place, on a line, and such that are nowhere."""
    place = numpy.full((50, 3), 0.5)
    line = numpy.zeros((1000, 3))
    line[:, 1] = numpy.linspace(0.0, 1.0, 1000)
    broken = numpy.concatenate([line, numpy.full((5, 3), numpy.nan)])
    for name, points, maximum, wanted in (("place", place, 7, 7), ("line", line, 8, 8), ("broken", broken, 2000, 1000)):
        masked = Masked(stage, session.poly_data(points))
        found = []
        session.messages(lambda: found.append(masked(name, GlyphMode="Even in Space", MaximumNumberOfGlyphs=maximum)))
        checks.equal("glyphs of points that are a " + name, found[0][1], wanted)
        if name == "line":
            rows = numpy.flatnonzero(found[0][0].any(axis=1))
            checks.true("eight glyphs of a line leave a gap of %d of %d rows" % (numpy.diff(rows).max(), SIZE), numpy.diff(rows).max() < SIZE // 4)


def blocks(checks, view, points):
    """Every 10th counts in each block by itself, so that hiding one leaves the others' glyphs in place."""
    data = vtkMultiBlockDataSet()
    for i in range(2):
        data.SetBlock(i, session.poly_data(points[55 * i:55 * (i + 1)]))
        data.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), "half%d" % i)
    masked = Masked(session.Stage(view), data)
    both, number = masked("blocks", GlyphMode="Every Nth", GlyphStride=10)
    checks.equal("every 10th of two blocks of 55", number, 12)
    one, number = masked("block", BlockSelectors=["/Root/half1"])
    checks.equal("every 10th of one of them", number, 6)
    checks.true("hiding a block has moved the other's glyphs", not (one & ~both).any())
    # Seven cells in a row.
    row = vtkImageData()
    row.SetDimensions(8, 2, 2)
    masked = Masked(session.Stage(view), row)
    checks.equal("every third of seven cells", masked("cells", GlyphLocation="Cells", GlyphMode="Every Nth", GlyphStride=3)[1], 3)


def main():
    """All parts in one view of the unit square."""
    session.load()
    checks = Checks()
    view = session.view(SIZE, SIZE)
    session.look(view, (0.5, 0.5, 5.0), (0.5, 0.5, 0.0), parallel_scale=0.5)
    points = crowded()
    stage = session.Stage(view)
    numbers(checks, stage, points)
    evenness(checks, stage, points)
    odd(checks, stage)
    stage.close()
    blocks(checks, view, points)
    checks.report()


if __name__ == "__main__":
    main()
