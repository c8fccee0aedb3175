"""ArrowReferenceMagnitude: heads of arrows have the proportions of the unit arrow on the arrow of that magnitude.

Usage: pvpython arrow_reference.py
"""
import numpy
import paraview.simple as pv

import comparison
import session

#: pixels a world unit, and the arrows' lengths in world units
PIXELS, LENGTHS = 40.0, (0.5, 1.0, 1.5, 2.0)
#: of arrows beside the view; with them the 95 % quantile is 1, the mean about half of it
OTHERS = (0.2,) * 60 + (1.0,) * 36


def thickness(view, name, lengths):
    """(width in pixels of each arrow's head, picture); arrows lie one above the other and point to the right."""
    pv.Render(view)
    pixels = session.capture(view, name)
    mask = comparison.covered(pixels)
    middle = mask.shape[0] / 2.0
    widths = []
    for i in range(len(lengths)):
        y = middle - PIXELS * (i - (len(lengths) - 1) / 2.0)
        rows = mask[int(y - PIXELS / 2):int(y + PIXELS / 2)]
        widths.append(int(rows.sum(axis=0).max()))
    return widths, pixels


def main():
    """The same arrows from arrays of very different magnitude, and heads fixed to one magnitude."""
    session.load()
    lengths = numpy.array(LENGTHS)
    everywhere = numpy.array(LENGTHS + OTHERS)
    high = 1.0
    view = session.view(200, 200)
    session.look(view, (1.0, 0.0, 10.0), (1.0, 0.0, 0.0), parallel_scale=100.0 / PIXELS)
    points = numpy.array([[0.0, i - (len(lengths) - 1) / 2.0, 0.0] for i in range(len(lengths))] + [[0.0, 100.0, 0.0]] * len(OTHERS))
    failures, pictures = [], []

    for unit in (1.0, 18.0, 0.01):
        vectors = numpy.zeros((len(everywhere), 3))
        vectors[:, 0] = everywhere * unit
        data = session.source(session.poly_data(points, vectors=vectors))
        shown = session.glyphs(data, view, "Arrow", ArrowHeads="Fixed", SelectOrientationVectors="vectors", ScaleMode="Magnitude", SelectScaleArray="vectors",
                               ScaleFactor=1.0 / unit, **{"GlyphType.TipRadius": 0.25})
        session.solid(shown, (0.3, 0.6, 0.9))

        def expect(what, reference):
            # a head is 2 x 0.25 of the reference wide, and shrinks with an arrow that is shorter than a head
            unit_length = reference / unit
            wanted = [PIXELS * 0.5 * min(unit_length, length / 0.35) for length in lengths]
            found, pixels = thickness(view, "arrow-reference-%g-%s" % (unit, what), lengths)
            print("unit %g, %s: heads %s pixels wide, %s expected" % (unit, what, found, numpy.round(wanted, 1)))
            if max(abs(f - w) for f, w in zip(found, wanted)) > 1.5:
                failures.append("unit %g, %s: heads are %s pixels wide, not %s" % (unit, what, found, wanted))
            return pixels

        pictures.append(expect("high", high * unit))
        shown.ArrowReferenceMagnitude = 0.8 * unit
        expect("fixed", 0.8 * unit)
        shown.ArrowReferenceMagnitude = 0.0
        if (expect("high again", high * unit) != pictures[-1]).any():
            failures.append("unit %g: the automatic reference does not come back" % unit)
        shown.ScaleMode = "No Data Scaling Off"
        shown.ScaleFactor = 1.0
        found, _ = thickness(view, "arrow-reference-%g-off" % unit, lengths)
        if max(abs(f - PIXELS * 0.5) for f in found) > 1.5:
            failures.append("unit %g, without scaling: heads are %s pixels wide, not %g" % (unit, found, PIXELS * 0.5))
        pv.Delete(shown)
        pv.Delete(data)
    for unit, picture in zip((18.0, 0.01), pictures[1:]):
        share, _, _ = comparison.difference(picture, pictures[0])
        if share > 0.001:
            failures.append("unit %g: %.2f%% of the pixels differ from unit 1" % (unit, 100 * share))
    session.finish(failures)


if __name__ == "__main__":
    main()
