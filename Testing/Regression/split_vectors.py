"""Split vectors: digits and powers of ten are read back from the picture for ten decades; they are the cylinders that they stand for, in
every light and in motion; and a click on either finds the vector's point.

Usage: pvpython split_vectors.py
"""
import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

#: pixels of a unit glyph, ten times of one digit or power, and of the radii of both cylinders
UNIT, THIN, THICK = 300, 4, 8
#: pixels of a glyph's place: from five powers behind its point to five and a digit of 10 before it
BEFORE, ACROSS, HIGH = UNIT // 2 + 10, 2 * UNIT + 20, 20
COLUMNS = 2
POINTS = numpy.array([[-0.9, -0.2, 0.0], [0.0, 0.3, 0.2], [0.8, -0.3, 0.1]])
VECTORS = numpy.array([[0.5, 0.7, -0.3], [-1.0, 0.4, 0.2], [0.3, -0.2, 0.9]])
#: properties that do not apply
WITHOUT_EFFECT = {"Orient": 0, "OrientationMode": "Rotation", "GlyphScaleFunction": "Logarithm", "GlyphSizeRange": [0.0, 0.05], "GlyphAnchor": "Tip",
                  "GlyphRadiusArray": "radius"}
VECTORS *= (numpy.array([0.0023, 47000.0, 1.0]) / numpy.linalg.norm(VECTORS, axis=1))[:, None]


def split(magnitude):
    """(digit, power) as a decimal text has them."""
    digit, power = ("%.6e" % magnitude).split("e")
    return float(digit), int(power)


def read(mask):
    """(digit, power) of the glyph in its place, by the pixels that it covers."""
    middle = HIGH // 2
    thick, whole = (numpy.nonzero(mask[middle + row])[0] - BEFORE for row in ((THIN + THICK) // 2, 0))
    if not len(whole):
        return None
    forward = len(thick) > 0 and thick[-1] > 0
    ends = [0, 0] if not len(thick) else [thick[0], thick[-1] + 1]
    # Both lie next to the point, and the digit before all of the power.
    if (len(thick) and ends[0 if forward else 1] != 0) or whole[0] != min(ends[0], 0):
        return None
    return round(10.0 * (whole[-1] + 1 - ends[1]) / UNIT, 1), round(10.0 * (ends[1] - ends[0]) / UNIT * (1 if forward else -1), 1)


def shown_split(stage, vectors, points, **properties):
    """The display."""
    shown = stage.show(session.poly_data(points, v=vectors, radius=numpy.full(len(points), 0.01), **properties.pop("arrays", {})), "Split Vector", SelectOrientationVectors="v",
                       **{"ScaleFactor": 1.0, "GlyphType": "Arrow", **properties})
    session.solid(shown, (0.9, 0.6, 0.2))
    return shown


def reading(checks):
    """The program reads what the data have."""
    magnitudes = numpy.array([digit * 10.0 ** power for power in range(-5, 6) for digit in (1.0, 2.3, 9.9)] + [1000.0, 999.9999, 0.0])
    rows = -(-len(magnitudes) // COLUMNS)
    view = session.view(COLUMNS * ACROSS, rows * HIGH)
    stage = session.Stage(view)
    places = numpy.array([[i % COLUMNS * ACROSS + BEFORE, (i // COLUMNS + 0.5) * HIGH, 0.0] for i in range(len(magnitudes))]) / UNIT
    width, height = COLUMNS * ACROSS / UNIT, rows * HIGH / UNIT
    session.look(view, (width / 2, height / 2, 10.0), (width / 2, height / 2, 0.0), parallel_scale=height / 2)
    form = {"GlyphType.ShaftRadius": THIN / UNIT, "GlyphType.TipRadius": THICK / UNIT}
    # Single precision rounds powers of ten, and the last number to 1000 - 1.2e-4.
    for kind in (numpy.float64, numpy.float32):
        vectors = (magnitudes[:, None] * (1.0, 0.0, 0.0)).astype(kind)
        said = session.messages(lambda: shown_split(stage, vectors, places, **form) and pv.Render(view))
        checks.no_message("split vectors", said)
        mask = comparison.covered(session.capture(view, "split-vectors-%s" % kind.__name__))[::-1]
        for i, magnitude in enumerate(magnitudes):
            row, column = i // COLUMNS * HIGH, i % COLUMNS * ACROSS
            found = read(mask[row:row + HIGH, column:column + ACROSS])
            digit, power = split(magnitude)
            checks.equal("%r in %s: digit and power" % (magnitude, kind.__name__), found, (round(digit, 1), power) if magnitude else None)
    stage.close()
    # What is no number has no glyph, and one message.
    bad = vectors.copy()
    bad[3, 1] = numpy.nan
    said = session.messages(lambda: shown_split(stage, bad, places, **form) and pv.Render(view))
    checks.one_message("a vector of NaN", said, "1 of 36 points have no glyph", "'v'", "not finite")
    # The thick cylinders of the power 0 are not there: three digits.
    counted = session.statistics(stage.settings.shown)
    checks.equal("cylinders and points without", (counted["glyphs"], counted["skippedGlyphs"]), (2 * 34 - 3, 2))
    stage.close()


def cylinders_of(factor):
    """(points, lengths, quaternions, numbers, ends) of the cylinders that stand for VECTORS; radii are those of ParaView's arrow."""
    made = []
    for number, (point, vector) in enumerate(zip(POINTS, VECTORS)):
        magnitude = numpy.linalg.norm(vector)
        digit, power = split(magnitude)
        along = vector / magnitude
        quaternion = numpy.array([1.0 + along[1], along[2], 0.0, -along[0]])  # from y
        for begin, end, radius in ((max(power, 0), max(power, 0) + digit, 0.03), (min(power, 0), max(power, 0), 0.1)):
            if end > begin:
                made.append((point + 0.05 * factor * (begin + end) * along, factor * numpy.array([2.0 * radius, 0.1 * (end - begin), 2.0 * radius]),
                             quaternion / numpy.linalg.norm(quaternion), number, point + 0.1 * factor * numpy.outer((begin, end), along)))
    return [numpy.array(values) for values in zip(*made)]


def as_cylinders(checks, view):
    """The same picture as the cylinders', and the point under a click on each."""
    session.look(view, (0.3, 0.6, 3.6))
    factor, velocity = 0.5, numpy.array([[0.3, 0.0, 0.1], [0.0, 0.4, 0.0], [-0.2, 0.2, 0.0]])
    points, lengths, quaternions, numbers, ends = cylinders_of(factor)
    stages = session.Stage(view), session.Stage(view)
    shown = shown_split(stages[0], VECTORS, POINTS, arrays={"velocity": velocity}, ScaleFactor=factor, **WITHOUT_EFFECT)
    single = stages[1].show(session.poly_data(points, lengths=lengths, turn=quaternions, velocity=velocity[numbers]), "Cylinder", Orient=1, ScaleFactor=1.0,
                            SelectOrientationVectors="turn", ScaleMode="Vector Components", SelectScaleArray="lengths")
    session.solid(single, (0.9, 0.6, 0.2))
    for lit, properties in {"local": {}, "occlusion": dict(ShadingMode="Ambient Occlusion", SamplesPerPixel=32),
                            "paths": dict(ShadingMode="Path Tracing", SamplesPerPixel=64),
                            "moving": dict(ShadingMode="Local", MotionBlur=1, VelocityArray="velocity", ShutterTime=1.0, SamplesPerPixel=64)}.items():
        pictures = []
        for each, hidden in ((shown, single), (single, shown)):
            each.Visibility, hidden.Visibility = 1, 0
            for key, value in properties.items():
                setattr(each, key, value)
            pictures.append(session.capture(view, "split-vectors-%s-%d" % (lit, len(pictures))))
        # Light and motion by chance: of glyphs in another order other samples.
        checks.picture("split vectors and cylinders, " + lit, *pictures, pixels=0.002 if lit == "local" else 0.02, mean=0.3)
    stages[1].close()
    shown.Visibility, shown.MotionBlur, shown.SamplesPerPixel = 1, 0, 1
    pv.Render(view)
    box = numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
    lower, upper = ends.min(axis=(0, 1)), ends.max(axis=(0, 1))
    checks.true("bounds %s of split vectors from %s to %s" % (box.tolist(), lower, upper),
                bool((box[:, 0] <= lower).all() and (box[:, 1] >= upper).all() and (box[:, 1] - box[:, 0] <= upper - lower + 1.2).all()))
    for place, number in zip(points, numbers):
        found = [point for _, _, point in session.picked(view, "POINT", session.pixel_of(view, place))]
        checks.equal("picked of the cylinder at %s" % place, found, [number])
    stages[0].close()


def needs(checks, view):
    """Without vectors there is no glyph, and a message says what to choose."""
    stage = session.Stage(view)
    data = session.poly_data(POINTS, v=VECTORS, four=numpy.ones((3, 4)))
    for array, words in (("four", ("'four'", "SelectOrientationVectors", "4 components", "2 or 3")), ("lost", ("'lost'", "SelectOrientationVectors", "2 or 3"))):
        said = session.messages(lambda array=array: stage.show(data, "Split Vector", SelectOrientationVectors=array, ScaleFactor=1.0) and pv.Render(view))
        checks.one_message("vectors of %s" % array, said, *words)
    shown = stage.show(data, "Split Vector", SelectOrientationVectors="None", ScaleFactor=1.0)
    pv.Render(view)
    checks.true("missing input without vectors: %s" % session.statistics(shown)["missingInput"], "SelectOrientationVectors" in session.statistics(shown)["missingInput"])
    checks.covered("nothing without vectors", session.capture(view, "split-vectors-none"), 0.0, 0.0)
    stage.close()


def main():
    """All parts."""
    session.load()
    checks = Checks()
    reading(checks)
    view = session.view(300, 200)
    as_cylinders(checks, view)
    needs(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
