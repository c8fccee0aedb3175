"""Spherical functions: spherical harmonics of every basis, normal stress and fourth-order tensors have the radius |f(n)|, by pictures
against points of the rays; sizes, rotations, colors, light, motion, selecting, and bad input.

Usage: pvpython harmonics.py
"""
import math

import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks, stepwise

SIDE = 72
#: half the height of the pictures in world units
SCALE = 1.1
WARM, COOL = (0.9, 0.5, 0.1), (0.1, 0.2, 0.8)
#: colors of |f| at both ends of the table
LOW, HIGH = numpy.array([0.1, 0.2, 0.9]), numpy.array([0.9, 0.6, 0.1])
BASES = ("MRtrix3", "DIPY", "DIPY Legacy", "Orthonormal")


def terms(basis, count, n):
    """Each coefficient's number and function in the directions n (..., 3), by the formulas of GlyphHarmonicsBasis."""
    z = n[..., 2]
    most = int(round((math.sqrt(8.0 * count + 1.0) - 3.0) / 2.0))
    power = numpy.ones_like(z, dtype=complex)  # rho^order exp(i order phi)
    for order in range(most + 1):
        # Legendre's function over rho^order
        below, value = numpy.zeros_like(z), numpy.full_like(z, float(numpy.prod([-(2.0 * i - 1.0) for i in range(1, order + 1)])))
        for l in range(order, most + 1):
            if l > order:
                below, value = value, ((2 * l - 1) * z * value - (l + order - 1) * below) / (l - order)
            if l % 2 == 0:
                scale = math.sqrt((2 * l + 1) / (4.0 * math.pi) * math.factorial(l - order) / math.factorial(l + order))
                for m in {order, -order}:
                    sine = m > 0 if basis.startswith("DIPY") else m < 0
                    odd = basis == "Orthonormal" or (basis == "DIPY" and m < 0)
                    sign = (-1.0 if odd and order % 2 else 1.0) * (math.sqrt(2.0) if m else 1.0)
                    yield l * (l + 1) // 2 + m, sign * scale * value * (power.imag if sine else power.real)
        power = power * (n[..., 0] + 1j * n[..., 1])


def harmonics(basis, count, n):
    """All of them: (..., count)."""
    columns = numpy.empty(n.shape[:-1] + (count,))
    for number, column in terms(basis, count, n):
        columns[..., number] = column
    return columns


def expansion(basis, coefficients, n):
    """f with these coefficients in the directions n (..., 3)."""
    return sum(coefficients[number] * column for number, column in terms(basis, len(coefficients), n))


def normal_stress(six, n):
    """n^T s n of xx yy zz xy yz xz."""
    x, y, z = n[..., 0], n[..., 1], n[..., 2]
    return numpy.stack([x * x, y * y, z * z, 2 * x * y, 2 * y * z, 2 * x * z], axis=-1) @ six


def fourth_order(voigt, n):
    """C_ijkl n_i n_j n_k n_l of the upper triangle of Voigt's matrix."""
    x, y, z = n[..., 0], n[..., 1], n[..., 2]
    pairs = numpy.stack([x * x, y * y, z * z, 2 * y * z, 2 * x * z, 2 * x * y], axis=-1)
    matrix = numpy.zeros((6, 6))
    matrix[numpy.triu_indices(6)] = voigt
    matrix = matrix + matrix.T - numpy.diag(numpy.diag(matrix))
    return numpy.einsum("...i,ij,...j", pairs, matrix, pairs)


def look(view, direction):
    """Looks at the origin against `direction`: the world positions of all pixels in the plane through it, and the way to the viewer."""
    direction = numpy.array(direction, dtype=float) / numpy.linalg.norm(direction)
    right = numpy.cross((0.1, 1.0, 0.0), direction)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(direction, right)
    session.look(view, 5.0 * direction, up=up, parallel_scale=SCALE)
    steps = (numpy.arange(SIDE) + 0.5 - SIDE / 2.0) * 2.0 * SCALE / SIDE
    return steps[None, :, None] * right - steps[:, None, None] * up, direction


def largest(function):
    """The largest |f| of many directions."""
    directions = numpy.random.default_rng(1).normal(size=(20000, 3))
    return float(numpy.abs(function(directions / numpy.linalg.norm(directions, axis=1)[:, None])).max())


def seen(function, most, factor, at, direction):
    """Whether each pixel's ray meets the glyph |p| <= factor / 2 |f(p / |p|)|, the first point of it, and f there: by points of the ray.
    most: the largest |f|, to a tenth.
    """
    steps = numpy.linspace(SCALE, -SCALE, 241)
    points = at[:, :, None, :] + steps[:, None] * direction
    distance = numpy.maximum(numpy.linalg.norm(points, axis=-1), 1e-9)
    near = distance < 0.55 * factor * most  # beyond it nothing is inside
    values = numpy.zeros(distance.shape)
    values[near] = function(points[near] / distance[near][:, None])
    inside = distance < 0.5 * factor * numpy.abs(values)
    first = inside.argmax(axis=2)
    take = lambda a: numpy.take_along_axis(a, first.reshape(first.shape + (1,) * (a.ndim - 2)), axis=2)[:, :, 0]
    return inside.any(axis=2), take(points), take(values)


def inner(mask):
    """Pixels of a mask whose eight neighbours belong to it, too."""
    padded = numpy.pad(mask, 1)
    return numpy.all([padded[i:i + mask.shape[0], j:j + mask.shape[1]] for i in range(3) for j in range(3)], axis=0)


def form(checks, stage, what, array, function, factor, both=False, **properties):
    """The glyph of one tuple, in all colorings from several sides or in one from one: each program takes its time to be compiled."""
    view = stage.view
    shown = stage.show(session.poly_data(numpy.zeros((1, 3)), values=array[None]), Ambient=1.0, Diffuse=0.0, ScaleFactor=factor,
                       GlyphDirectionKey="None", GlyphTensorLookupTable=session.signs(WARM, COOL), **properties)
    most = largest(function)
    views = (("Sign", (0.3, -0.5, 0.8)), ("Direction", (-0.9, 0.2, 0.3)), ("Radius", (0.5, 0.4, -0.6)))
    for coloring, direction in views[:3 if both else 1]:
        directions = coloring == "Direction"
        stage.settings.add({"GlyphDirectionColoring": "Axes" if directions else "None", **({} if directions else {"GlyphTensorColoring": coloring})})
        pv.Render(view)
        if coloring == "Radius":
            scalar_bar(checks, view, shown, what, [name for name in (properties.get("GlyphHarmonicsArray"), properties.get("GlyphTensorArray")) if name][0],
                       most)
        at, toward = look(view, direction)
        image = session.capture(view, "harmonics-%s-%s" % (what.replace(" ", "-").replace(",", ""), coloring.split()[0]))[:, :, :3].astype(int)
        there, first, value = seen(function, most, factor, at, toward)
        hit = comparison.covered(image)
        sure = inner(there) | inner(~there)
        # Lobes thinner than a pixel, and points of rays that pass them by, leave some pixels in doubt.
        wrong = int((hit != there)[sure].sum())
        if coloring == "Sign":
            wanted = numpy.where(value[..., None] < 0, COOL, WARM)
            alike = inner(there & (value < 0)) | inner(there & (value > 0))
            levels = 2
        elif coloring == "Radius":
            share = numpy.clip(numpy.abs(value) / most, 0.0, 1.0)[..., None]
            wanted = (1.0 - share) * LOW + share * HIGH
            around = numpy.pad(share[..., 0], 1, mode="edge")
            spread = numpy.ptp([around[i:i + SIDE, j:j + SIDE] for i in range(3) for j in range(3)], axis=0)
            alike = inner(there) & (spread < 0.1)
            levels = 10
        else:
            wanted = numpy.abs(first) / numpy.maximum(numpy.linalg.norm(first, axis=-1), 1e-9)[..., None]
            # Where the surface has no step, one step of the ray is seen.
            deep = numpy.pad(first @ toward, 1, mode="edge")
            spread = numpy.ptp([deep[i:i + SIDE, j:j + SIDE] for i in range(3) for j in range(3)], axis=0)
            alike = inner(there) & (spread < 0.15) & (numpy.linalg.norm(first, axis=-1) > 0.15)
            levels = 20
        apart = numpy.abs(image - numpy.round(255 * wanted)).max(axis=2)
        off = int((apart[alike & hit] > levels).sum())
        words = "%s, %s: %d pixels covered, %d of %d wrong; colors of %d judged, %d wrong" % (
            what, coloring, hit.sum(), wrong, sure.sum(), alike.sum(), off)
        print(words)
        checks.true(words, hit.sum() > 150 and wrong <= 0.002 * sure.size and off <= 0.01 * alike.sum() and alike.sum() > 0.2 * hit.sum())


def scalar_bar(checks, view, shown, what, array, most):
    """Colors by radius go through the table of that name, from 0 to the largest |f|, and have a scalar bar."""
    table = shown.GlyphTensorLookupTable
    checks.true(what + ": the table is not that of the array's radius", table == pv.GetColorTransferFunction(array + " Radius"))
    checks.within(what + ": least number of the table", table.RGBPoints[0], 0.0, 0.0)
    checks.within(what + ": largest number of the table", table.RGBPoints[-4], 0.995 * most, 1.005 * most)
    bars = [bar for bar in view.Representations if hasattr(bar, "ComponentTitle") and bar.Visibility]
    checks.equal(what + ": scalar bars", [bar.LookupTable == table for bar in bars], [True])
    for bar in bars:
        bar.Visibility = 0
    table.ColorSpace = "RGB"
    table.RGBPoints = [0.0, *LOW, most, *HIGH]


def forms(checks, view, random):
    """Bands and bases, and both kinds of tensors."""
    stage = session.Stage(view)
    for basis, count in zip(BASES, (45, 15, 15, 6)):
        array = random.normal(size=count)
        form(checks, stage, "%s, %d" % (basis, count), array, lambda n: expansion(basis, array, n),
             1.9 / numpy.abs(array).sum() * count ** 0.5, both=count == 15, GlyphShape="Spherical Harmonics", GlyphHarmonicsArray="values", GlyphHarmonicsBasis=basis)
    array = random.normal(size=91) * numpy.repeat(1.0 / (1.0 + numpy.arange(7)), 4 * numpy.arange(7) + 1)
    form(checks, stage, "band 12", array, lambda n: expansion("MRtrix3", array, n), 0.7, GlyphShape="Spherical Harmonics", GlyphHarmonicsArray="values")
    array = random.normal(size=6)
    form(checks, stage, "normal stress", array, lambda n: normal_stress(array, n), 1.0, GlyphShape="Normal Stress", GlyphTensorArray="values")
    array = random.normal(size=21)
    form(checks, stage, "fourth order", array, lambda n: fourth_order(array, n), 0.7, both=True, GlyphShape="Fourth-Order Tensor", GlyphTensorArray="values")
    stage.close()


def sizes(checks, view, random):
    """Each: all have one size. Scale arrays multiply, orientation arrays turn: the same pictures as with what they stand for."""
    array = numpy.outer([1.0, 0.2], random.normal(size=15))
    places = numpy.array([[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]])
    turn = numpy.array([0.8, 0.36, 0.48, 0.0])  # w, x, y, z
    w, x, y, z = turn
    matrix = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                          [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                          [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    stress = random.normal(size=(3, 3))
    stress = stress + stress.T
    data = session.poly_data(
        places, values=array, alike=numpy.repeat(array[:1], 2, axis=0), fifth=numpy.array([1.0, 0.2]), turn=numpy.repeat(turn[None], 2, axis=0),
        stress=numpy.repeat(stress.reshape(1, 9), 2, axis=0), turned=numpy.repeat((matrix @ stress @ matrix.T).reshape(1, 9), 2, axis=0))
    look(view, (0.2, 0.3, 1.0))
    pictures, stage = {}, session.Stage(view)
    for name, properties in {
            "each": dict(GlyphHarmonicsArray="values", GlyphScaleFunction="All the Same"),
            "alike": dict(GlyphHarmonicsArray="alike", GlyphScaleFunction="All the Same"),
            "common": dict(GlyphHarmonicsArray="values"),
            "scaled": dict(GlyphHarmonicsArray="alike", ScaleMode="Magnitude", SelectScaleArray="fifth"),
            "turned": dict(GlyphShape="Normal Stress", GlyphTensorArray="stress", Orient=1, SelectOrientationVectors="turn",
                           OrientationMode="Quaternion"),
            "of turned": dict(GlyphShape="Normal Stress", GlyphTensorArray="turned")}.items():
        factor = 0.8 if properties.get("GlyphScaleFunction") else 0.3
        shown = stage.show(data, **{"GlyphShape": "Spherical Harmonics", "ScaleFactor": factor, **properties})
        session.solid(shown, (0.8, 0.8, 0.8))
        pictures[name] = session.capture(view, "harmonics-" + name.replace(" ", "-"))
    checks.picture("harmonics, each of one size", pictures["each"], pictures["alike"])
    checks.picture("harmonics scaled by an array", pictures["scaled"], pictures["common"])
    checks.picture("harmonics turned by an array", pictures["turned"], pictures["of turned"])
    checks.true("each and common look the same", (pictures["each"] != pictures["common"]).any())
    widths = [comparison.covered(pictures["each"])[:, half].any(axis=0).sum() for half in (slice(0, SIDE // 2), slice(SIDE // 2, SIDE))]
    checks.within("width of one glyph of two that have one size", widths[0] / widths[1], 0.9, 1.1)
    stage.close()


def gallery(checks, random):
    """Bands and shapes beside each other, in color, light and motion."""
    view = session.view(300, 100)
    session.look(view, (0.0, 1.5, 6.0), parallel_scale=0.7)
    peaks = numpy.array([[0.3, 0.9, 0.3], [0.9, -0.2, 0.4], [-0.4, 0.2, 0.9]])
    shown, sources = [], []
    for number, count in enumerate((6, 15, 45, 91)):
        # Three narrow lobes, as sharp as the bands allow
        array = harmonics("MRtrix3", count, peaks / numpy.linalg.norm(peaks, axis=1)[:, None]).sum(axis=0)
        sources.append(session.source(session.poly_data(numpy.array([[-1.75 + 0.7 * number, 0.0, 0.0]]), values=array[None],
                                                        velocity=numpy.array([[0.0, 1.0, 0.0]]))))
        shown.append(session.glyphs(sources[-1], view, GlyphShape="Spherical Harmonics", GlyphHarmonicsArray="values", ScaleFactor=0.62,
                                    GlyphScaleFunction="All the Same", GlyphDirectionColoring="Axes", GlyphDirectionKey="None"))
    tensors = {"Normal Stress": numpy.array([1.0, -0.7, 0.3, 0.2, 0.5, -0.1]),
               "Fourth-Order Tensor": numpy.array([3.0, 1.2, 1.2, 0, 0, 0, 3.0, 1.2, 0, 0, 0, 3.0, 0, 0, 0, 2.4, 0, 0, 2.4, 0, 2.4])}
    for number, (shape, array) in enumerate(tensors.items()):
        sources.append(session.source(session.poly_data(numpy.array([[1.05 + 0.7 * number, 0.0, 0.0]]), values=array[None],
                                                        velocity=numpy.array([[0.0, 1.0, 0.0]]))))
        shown.append(session.glyphs(sources[-1], view, shape, GlyphTensorArray="values", ScaleFactor=0.62,
                                    GlyphScaleFunction="All the Same", GlyphTensorColoring="Sign"))
    shown[0].SamplesPerPixel = 8
    image = session.capture(view, "harmonics-gallery")
    for failure in comparison.against_baseline(image, "harmonics-gallery"):
        checks.true(failure, False)
    covered = comparison.covered(image)
    # Selecting: the point under each glyph's middle.
    for number, source in enumerate(sources):
        found = session.picked(view, "POINT", session.pixel_of(view, (-1.75 + 0.7 * number + 0.02, 0.03, 0.0)))
        checks.equal("what lies under glyph %d" % number, [(thing[0] == source.SMProxy, thing[2]) for thing in found], [(True, 0)])
    # Light is the view's; noise of its samples moves edges.
    for name, changed, properties, back, low, high in (
            ("translucent", shown, {"Opacity": 0.5}, {"Opacity": 1.0}, 0.98, 1.03),
            ("moving", shown, {"MotionBlur": 1, "VelocityArray": "velocity", "ShutterTime": 0.3}, {"MotionBlur": 0}, 1.1, 2.0),
            ("occlusion", shown[:1], {"ShadingMode": "Ambient Occlusion"}, {"ShadingMode": "Local"}, 0.98, 1.03),
            ("paths", shown[:1], {"ShadingMode": "Path Tracing"}, {"ShadingMode": "Local"}, 0.98, 1.03)):
        for glyph in changed:
            for key, value in properties.items():
                setattr(glyph, key, value)
        other = session.capture(view, "harmonics-" + name)
        checks.within(name + ": pixels covered beside those at rest", comparison.covered(other).sum() / covered.sum(), low, high)
        checks.true(name + ": nothing has changed", (other != image).any())
        for glyph in changed:
            for key, value in back.items():
                setattr(glyph, key, value)
    checks.picture("harmonics, back again", session.capture(view, "harmonics-again"), image)
    pv.Delete(view)


def bounds(checks, random):
    """ParaView's camera shows all of the glyphs, and not much more."""
    view = session.view(100, 100)
    array = harmonics("MRtrix3", 45, numpy.array([1.0, 0.0, 0.0]))
    points = session.source(session.poly_data(numpy.array([[1.0, 2.0, 3.0], [1.1, 2.0, 3.0]]), values=numpy.repeat(array[None], 2, axis=0)))
    shown = session.glyphs(points, view, GlyphShape="Spherical Harmonics", GlyphHarmonicsArray="values", ScaleFactor=1.0)
    pv.Render(view)
    found = numpy.array(shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetActor().GetBounds()
                        if hasattr(shown.SMProxy.GetClientSideObject(), "GetActiveRepresentation") else [0.0] * 6)
    radius = 0.5 * float(harmonics("MRtrix3", 45, numpy.array([1.0, 0.0, 0.0])) @ array)
    checks.within("lower bound along the lobe", found[0], 1.0 - 1.2 * radius, 1.0 - radius)
    checks.within("upper bound along the lobe", found[1], 1.1 + radius, 1.1 + 1.2 * radius)
    checks.within("upper bound across", found[3], 2.0, 2.0 + 0.6 * radius)
    pv.Delete(view)


def bad_input(checks, view):
    """One message for a wrong number of components; tuples of zeros or without a number are counted, and the rest shows."""
    good = numpy.zeros((4, 6))
    good[:, 0] = 1.0
    good[1], good[2, 3] = 0.0, numpy.nan
    places = numpy.array([[-0.9, 0.0, 0.0], [-0.3, 0.0, 0.0], [0.3, 0.0, 0.0], [0.9, 0.0, 0.0]])
    points = session.source(session.poly_data(places, seven=numpy.ones((4, 7)), eight=numpy.ones((4, 8)), good=good, zeros=numpy.zeros((4, 6)), one=numpy.ones(4)))
    shown = session.glyphs(points, view, GlyphShape="Spherical Harmonics", GlyphHarmonicsArray="seven", ScaleFactor=0.8)
    look(view, (0.0, 0.0, 1.0))
    text = session.messages(lambda: pv.Render(view))
    checks.one_message("seven components", text, "'seven'", "GlyphHarmonicsArray", "7 components", "1, 6, 15, 28, 45, 66 or 91")
    shown.GlyphHarmonicsArray = "good"
    text = session.messages(lambda: pv.Render(view))
    checks.one_message("a tuple without a number", text, "1 of 4 points", "'good'", "not all finite")
    counted = session.statistics(shown)
    checks.equal("glyphs and skipped points", (counted["glyphs"], counted["skippedGlyphs"]), (2, 2))
    checks.covered("two balls", session.capture(view, "harmonics-two"), 0.01, 0.2)
    shown.GlyphHarmonicsArray = "zeros"
    checks.one_message("all zero", session.messages(lambda: pv.Render(view)), "'zeros'", "all zero")
    shown.GlyphHarmonicsArray = "one"
    checks.no_message("one component", session.messages(lambda: pv.Render(view)))
    checks.equal("glyphs of one component", session.statistics(shown)["glyphs"], 4)
    for shape, name, counts in (("Normal Stress", "eight", "6 or 9"), ("Fourth-Order Tensor", "good", "15, 21, 36 or 81")):
        shown.GlyphTensorArray, shown.GlyphShape = name, shape
        text = session.messages(lambda: pv.Render(view))
        checks.one_message(shape, text, "'%s'" % name, "GlyphTensorArray", counts)
    pv.Delete(shown)
    pv.Delete(points)


def missing_input(checks, view):
    """An array that has not been chosen yet: a window shows no message, only RenderStatistics; a script gets a warning."""
    data = session.poly_data(numpy.zeros((1, 3)), some=numpy.ones((1, 15)), six=numpy.ones((1, 6)))
    stage = session.Stage(view)
    for in_window in (1, 0):
        for shape, name, array in (("Spherical Harmonics", "GlyphHarmonicsArray", "some"), ("Normal Stress", "GlyphTensorArray", "six"),
                                   ("Tensor Ellipsoid", "GlyphTensorArray", "six")):
            shown = stage.show(data, ScaleFactor=0.8)
            stepwise(shown, -in_window)
            stage.settings.add({name: "None", "GlyphShape": shape})
            text = session.messages(lambda: (pv.Render(view), pv.Render(view)))
            what = "%s without an array, %s a window" % (shape, "in" if in_window else "not in")
            if in_window:
                checks.no_message(what, text)
            else:
                checks.one_message(what, text, name)
            checks.true(what + ": missingInput in RenderStatistics", name in session.statistics(shown)["missingInput"])
            checks.equal(what + ": glyphs", session.statistics(shown)["glyphs"], 0)
            stage.settings.add({name: array})
            pv.Render(view)
            checks.equal(what + ": what is left to choose with one", session.statistics(shown)["missingInput"], "")
            checks.equal(what + ": glyphs with one", session.statistics(shown)["glyphs"], 1)
    # Without an array nothing is turned.
    for shape, orient in (("Arrow", 0), ("Cone", 0), ("Sphere", 1), ("Arrow", 1), ("Box", 1), ("Capsule", 1)):
        shown = stage.show(data, shape, ScaleFactor=0.8, Orient=orient, SelectOrientationVectors="None")
        said = session.messages(lambda: pv.Render(view))
        if shape == "Arrow" and orient:
            checks.one_message("arrow without a direction", said, "SelectOrientationVectors")
        else:
            checks.no_message(shape + " without a direction", said)
        checks.equal(shape + " without a direction: glyphs", session.statistics(shown)["glyphs"], 1)
    stage.close()


def main():
    session.load()
    checks = Checks()
    random = numpy.random.default_rng(4)
    view = session.view(SIDE, SIDE)
    forms(checks, view, random)
    sizes(checks, view, random)
    bad_input(checks, view)
    missing_input(checks, view)
    gallery(checks, random)
    bounds(checks, random)
    checks.report()


if __name__ == "__main__":
    main()
