"""The legend of sizes: its glyph is as large as the glyph of its number at the center of rotation.

Usage: pvpython glyph_legend.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

SIDE = 600


def longest_run(mask):
    """Pixels of the longest row of neighbors."""
    padded = numpy.zeros((mask.shape[0], mask.shape[1] + 2), dtype=int)
    padded[:, 1:-1] = mask
    steps = numpy.diff(padded, axis=1)
    starts, ends = numpy.nonzero(steps == 1), numpy.nonzero(steps == -1)
    return int((ends[1] - starts[1]).max()) if len(starts[1]) else 0


def widths(view, name, **options):
    """Of the legend's glyph, which is white, and of the red one in the scene, in pixels."""
    image = session.capture(view, "glyph-legend-" + name, **options).astype(int)
    red, green, blue = image[..., 0], image[..., 1], image[..., 2]
    legend = green > 128
    glyph = (red > 200) & (green < 100) & (blue < 100)
    return longest_run(legend), longest_run(glyph), legend


def scene():
    """(view, representation) of one glyph of magnitude 2, away from the origin."""
    view = session.view(SIDE, SIDE)
    data = session.poly_data(numpy.array([[5.0, 1.0, 0.0]]), s=numpy.array([2.0]), v=numpy.array([[2.0, 0.0, 0.0]]))
    shown = session.glyphs(session.source(data), view, "Sphere", ScaleMode="Magnitude", SelectScaleArray="s", ScaleFactor=0.25,
                           SelectOrientationVectors="v", ArrowHeads="Fixed", ArrowReferenceMagnitude=1.0, GlyphLegend="Lower Left")
    session.solid(shown, (1.0, 0.0, 0.0))
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (5.2, 1.1, 6.0), (5.2, 1.1, -3.0), (0.0, 1.0, 0.0)
    view.CenterOfRotation = (5.0, 1.0, 0.0)
    return view, shown


def size(checks, view, shown):
    """The legend's glyph and that of its number at the center of rotation."""
    settings = session.Settings(shown)
    for shape in ("Sphere", "Arrow", "Box", "Cylinder", "Cone", "Capsule", "Superquadric"):
        settings.set({**session.shaped(shape), "GlyphLegendValue": 2.0, "GlyphExponents": (4.0, 3.0, 2.0)})
        for parallel in (0, 1):
            view.CameraParallelProjection, view.CameraParallelScale = parallel, 1.1
            legend, glyph, _ = widths(view, "%s-%d" % (shape.lower(), parallel))
            # In perspective the front of a thick body looks larger than its middle.
            front = 0 if parallel else 6
            checks.within("%s, %s: width of the glyph" % (shape, "parallel" if parallel else "perspective"), glyph,
                          max(40, legend - 1), legend + 1 + front)
    settings.set({})


def split(checks, view, shown):
    """Digit and power of the legend's split vector are those of the glyph in the scene, within a pixel."""
    source = session.source(session.poly_data(numpy.array([[5.0, 1.0, 0.0]]), v=numpy.array([[2300.0, 0.0, 0.0]])))
    shown.Visibility = 0
    single = session.glyphs(source, view, "Split Vector", SelectOrientationVectors="v", ScaleFactor=1.0, GlyphType="Arrow", GlyphLegend="Lower Left",
                            Ambient=1.0, Diffuse=0.0)
    session.solid(single, (1.0, 0.0, 0.0))
    view.CameraParallelProjection, view.CameraParallelScale = 1, 1.1
    for single.GlyphLegendValue in (2300.0, 0.0):
        image = session.capture(view, "glyph-legend-split-%g" % single.GlyphLegendValue).astype(int)
        found = []
        for mask in ((image[..., 0] > 200) & (image[..., 1:3].max(axis=2) < 100), image[..., 1] > 200):
            runs = [longest_run(row[None]) for row in mask]
            # Through the middle both, beside it the power alone.
            thick = [run for run in runs if 0.25 * max(runs) < run < 0.9 * max(runs)]
            found.append(numpy.array([max(runs), max(thick), len([run for run in runs if run >= max(thick) - 1])]))
        print("of split vectors: length, power, width", found)
        # Chosen is 1000, a digit of 1 in place of 2.3: with 2 it were longer than a fifth of the view.
        wanted = found[0] - numpy.array([0.13 * SIDE / 2.2, 0, 0]) * (single.GlyphLegendValue == 0.0)
        checks.within("split vector of %g: difference of the legend's length, power and width" % single.GlyphLegendValue, numpy.abs(found[1] - wanted).max(), 0, 1.0)
    pv.Delete(single)
    pv.Delete(source)
    shown.Visibility = 1


def larger_pictures(checks, view, shown):
    """It grows as the scene's glyphs do, where the picture is put together from tiles, too, and stays in its corner."""
    view.CameraParallelScale, shown.GlyphLegendValue = 1.1, 2.0
    for corner, factor, parallel in (("Lower Left", 1.5, 1), ("Upper Right", 2, 0), ("Upper Right", 3, 1)):
        shown.GlyphLegend, view.CameraParallelProjection = corner, parallel
        side = int(factor * SIDE)
        legend, glyph, mask = widths(view, "large", ImageResolution=[side, side])
        what = "picture %g times the window, %s: " % (factor, corner)
        front = 0 if parallel else 6 * factor
        checks.within(what + "width of the glyph", glyph, max(40 * factor, legend - 2), legend + 2 + front)
        checks.equal(what + "the glyph and one line of words, apart", int((numpy.diff(mask.any(axis=1).astype(int)) == 1).sum()), 2)
        rows, columns = numpy.nonzero(mask)
        for name, places in (("rows", rows), ("columns", columns)):
            checks.within(what + "distance of its %s from the edge" % name, side / 2 - abs(places - side / 2).max(), 5, 30 * factor)
    shown.GlyphLegend, shown.GlyphLegendValue = "Lower Left", 0.0


def choice(checks, view, shown):
    """Numbers that fit whatever the zoom, but none above the data's largest, 2: a glyph of 0.5 in a view 34 high."""
    view.CameraParallelProjection = 1
    for scale, least, most in ((0.3, SIDE / 5 / 2.6, SIDE / 5 + 1), (1.0, SIDE / 5 / 2.6, SIDE / 5 + 1), (17.0, 0.5 / 34 * SIDE - 2, 0.5 / 34 * SIDE + 2)):
        view.CameraParallelScale = scale
        legend = widths(view, "zoom")[2]
        checks.within("pixels at parallel scale %g" % scale, longest_run(legend[:legend.nonzero()[0].max() - 16]), least, most)
    view.CameraParallelScale, shown.GlyphLegendValue = 1.0, 1.0


def corners(checks, view, shown):
    """Where it stands."""
    for corner in ("Lower Left", "Lower Right", "Upper Left", "Upper Right"):
        shown.GlyphLegend = corner
        rows, columns = numpy.nonzero(widths(view, "corner")[2])
        checks.equal("%s: on the right" % corner, columns.mean() > SIDE / 2, "Right" in corner)
        checks.equal("%s: at the upper edge" % corner, rows.mean() < SIDE / 2, "Upper" in corner)
        checks.within("%s: distance from the edge" % corner, SIDE / 2 - abs(rows - SIDE / 2).max(), 5, 30)
    view.OrientationAxesVisibility = 1
    for corner, lowest in (("Lower Left", 0.2 * SIDE), ("Lower Right", 5)):
        pictures = []
        for shown.GlyphLegend in ("None", corner):
            pictures.append(session.capture(view, "glyph-legend-axes").astype(int))
        rows = numpy.nonzero(abs(pictures[1] - pictures[0]).max(axis=2) > 60)[0]
        checks.within("%s with orientation axes: distance from the lower edge" % corner, SIDE - 1 - rows.max(), lowest, lowest + 60)
    view.OrientationAxesVisibility = 0
    view.BackgroundColorMode, view.Background, view.Background2 = "Gradient", [0.0] * 3, [1.0] * 3
    for corner in ("Lower Left", "Upper Left"):
        pictures = []
        for shown.GlyphLegend in ("None", corner):
            pictures.append(session.capture(view, "glyph-legend-gradient").astype(int))
        checks.within("%s before a gradient: contrast" % corner, abs(pictures[1] - pictures[0]).max(), 128, 255)
    view.BackgroundColorMode, view.Background = "Single Color", [channel / 255.0 for channel in session.BACKGROUND]


def room(checks, view, shown):
    """What stands in one corner covers nothing of the rest: sizes, directions, a color bar, orientation axes; in large pictures, too."""
    bar = pv.GetScalarBar(pv.GetColorTransferFunction("s"), view)
    bar.Title, shown.GlyphDirectionColoring = "number", "Sphere"
    for corner, place, factor in (("Lower Left", "Lower Left Corner", 1), ("Upper Right", "Upper Right Corner", 1), ("Lower Right", "Lower Right Corner", 2),
                                  ("Upper Left", "Any Location", 1), ("Lower Left", "Lower Center", 1)):
        bar.WindowLocation = place
        if place == "Any Location":
            bar.Position = (0.03, 0.5)
        switches = [(shown, "GlyphLegend", "None", corner), (shown, "GlyphDirectionKey", "None", corner), (bar, "Visibility", 0, 1), (view, "OrientationAxesVisibility", 0, 1)]

        def picture(*on):
            for switch in switches:
                setattr(switch[0], switch[1], switch[3] if switch in on else switch[2])
            return session.capture(view, "glyph-legend-room-%d" % len(on), ImageResolution=[factor * SIDE] * 2).astype(int)
        plain = picture()
        changed = [int((picture(*on) != plain).any(axis=2).sum()) for on in [switches] + [[one] for one in switches]]
        checks.true("%s: not all shown: pixels %s" % (place, changed), min(changed) > 200)
        checks.within("%s, %d times the window: pixels together over those of each alone" % (place, factor), changed[0] / sum(changed[1:]), 0.995, 1.005)
    picture()
    shown.GlyphDirectionColoring, shown.GlyphLegend = "None", "Lower Left"


def absence(checks, view, shown):
    """Nothing of it stays where it is not wanted."""
    for switch in ("GlyphLegend", "Visibility"):
        checks.true("%s on: no legend" % switch, widths(view, "shown")[0] > 0)
        setattr(shown, switch, 0)
        checks.equal("%s off: pixels of the legend" % switch, widths(view, "hidden")[0], 0)
        setattr(shown, switch, 1)
    pv.Delete(shown)
    checks.equal("display deleted: pixels of the legend", widths(view, "deleted")[0], 0)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    view, shown = scene()
    size(checks, view, shown)
    split(checks, view, shown)
    larger_pictures(checks, view, shown)
    choice(checks, view, shown)
    corners(checks, view, shown)
    room(checks, view, shown)
    absence(checks, view, shown)
    checks.report()


if __name__ == "__main__":
    main()
