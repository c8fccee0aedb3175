"""Confidence ellipsoids hold the stated fraction of a Gaussian's samples and have numpy's silhouettes; those of uncertain vectors are the same
round the arrows' tips, in motion, too; what is no covariance has no ellipsoid, and a message. The cones of uncertain directions hold the
stated fraction of the directions, and of the lengths between their bases. Shells are the glyphs of their own array.

Usage: pvpython uncertainty.py
"""
import math

import numpy
import paraview.simple as pv

import comparison
import export
import session
from checks import Checks
from split_vectors import WITHOUT_EFFECT

RANDOM = numpy.random.default_rng(5)
SIDE, SCALE = 400, 3.0
POINTS = numpy.array([[-1.4, -1.3, 0.0], [1.3, -1.2, 0.5], [-1.2, 1.4, -0.4], [1.4, 1.3, 0.0]])
#: standard deviations along the axes
DEVIATIONS = numpy.array([[0.4, 0.25, 0.1], [0.3, 0.3, 0.3], [0.5, 0.05, 0.005], [0.1, 0.35, 0.35]])
TURNS = [numpy.linalg.qr(RANDOM.normal(size=(3, 3)))[0] for _ in POINTS]
COVARIANCES = numpy.array([(turn * row ** 2) @ turn.T for turn, row in zip(TURNS, DEVIATIONS)])
VECTORS = numpy.array([[0.9, 0.5, 0.3], [-0.6, 0.6, 0.2], [0.0, 0.0, 0.0], [-0.5, -0.8, 0.4]])
VELOCITIES = numpy.array([[0.3, 0.0, 0.1], [0.0, 0.4, 0.0], [-0.2, 0.2, 0.0], [0.0, 0.0, 0.0]])
#: of these the direction is certain enough for a cone, but for the last
MEANS = numpy.array([[0.8, 0.5, 1.3], [-0.9, 0.9, 0.2], [0.3, -1.2, 0.4], [0.2, 0.1, -0.2]])
#: roots of the quantiles of the chi-square distribution with three degrees of freedom, from its tables
RADII = {0.9: 6.25139 ** 0.5, 0.95: 7.81473 ** 0.5, 0.99: 11.34487 ** 0.5}


def six(covariances):
    """xx yy zz xy yz xz."""
    return covariances[:, (0, 1, 2, 0, 1, 0), (0, 1, 2, 1, 2, 2)]


def data(**arrays):
    """The points with their arrays."""
    return session.poly_data(POINTS, **{"radius": numpy.full(len(POINTS), 0.01), "covariance": six(COVARIANCES), "v": VECTORS, "velocity": VELOCITIES, **arrays})


def shown_ellipsoids(stage, of=None, **properties):
    """Confidence ellipsoids, of their true size."""
    shown = stage.show(of or data(), "Confidence Ellipsoid", **{"GlyphTensorArray": "covariance", "ScaleFactor": 1.0, **properties})
    session.solid(shown, (0.9, 0.7, 0.3))
    return shown


def turned(quaternions):
    """Matrices of rotation."""
    w, x, y, z = numpy.asarray(quaternions).T
    return numpy.moveaxis(numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                                       [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]), 2, 0)


def same_pictures(checks, view, what, shown, others, moves=True):
    """A display looks as other ones together, at rest and in motion."""
    for lit, properties in {"local": {}, **({"moving": dict(MotionBlur=1, VelocityArray="velocity", ShutterTime=1.0, SamplesPerPixel=64)} if moves else {})}.items():
        pictures = []
        for visible in ([shown], others):
            for each in [shown] + others:
                each.Visibility = each in visible
                for key, value in properties.items():
                    setattr(each, key, value)
            pictures.append(session.capture(view, "uncertainty-%s-%s-%d" % (what.replace(" ", "-"), lit, len(pictures))))
        checks.picture("%s, %s" % (what, lit), *pictures, pixels=0.0 if lit == "local" else 0.02, mean=0.3)
    for each in [shown] + others:
        each.Visibility, each.MotionBlur, each.SamplesPerPixel = each is shown, 0, 1
    pv.Render(view)


def reach(view):
    """Lower and upper corner of all that is visible."""
    return numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2).T


def export_of(checks, view):
    """A file of the view's glyphs."""
    path = session.output("uncertainty.usda")
    checks.no_message("export", export.export(path, view))
    return path


def shares(checks, view, stage):
    """Of samples of each Gaussian the stated fraction lies in the exported ellipsoid."""
    for share in RADII:
        shown_ellipsoids(stage, GlyphConfidence=share)
        part = export.from_usda(export_of(checks, view))[0][0][0]
        for number, covariance in enumerate(COVARIANCES):
            samples = RANDOM.multivariate_normal(POINTS[number], covariance, 1000000)
            inside = (numpy.square((samples - part.positions[number]) @ turned(part.quaternions)[number] / (0.5 * part.scales[number])).sum(axis=1) <= 1.0).mean()
            checks.within("fraction of samples of Gaussian %d in the ellipsoid of %g" % (number, share), inside, share - 0.002, share + 0.002)


def silhouettes(checks, view, stage):
    """Every pixel is numpy's."""
    for share, radius in RADII.items():
        shown_ellipsoids(stage, GlyphConfidence=share)
        found = comparison.covered(session.capture(view, "uncertainty-%g" % share))
        x, y = numpy.meshgrid(*[2 * SCALE * ((numpy.arange(SIDE) + 0.5) / SIDE - 0.5)] * 2)
        wanted = numpy.zeros((SIDE, SIDE), dtype=bool)
        for point, covariance in zip(POINTS, COVARIANCES):
            inverse = numpy.linalg.inv(radius ** 2 * covariance[:2, :2])
            at = numpy.stack([x - point[0], -y - point[1]], axis=-1)
            wanted |= numpy.einsum("...i,ij,...j", at, inverse, at) <= 1.0
        checks.equal("wrong pixels of the silhouettes of %g" % share, int((found != wanted).sum()), 0)


def tips(checks, view):
    """Uncertain vectors are arrows with translucent ellipsoids round their tips, of a vector of zero round its point."""
    factor = 0.8
    stages = [session.Stage(view) for _ in range(3)]
    given = data(nine=COVARIANCES.reshape(-1, 9))
    shown = stages[0].show(given, "Uncertain Vector", SelectOrientationVectors="v", GlyphTensorArray="nine", ScaleFactor=factor, GlyphConfidence=0.9,
                            **WITHOUT_EFFECT)
    arrows = stages[1].show(given, "Arrow", Orient=1, SelectOrientationVectors="v", ScaleMode="Magnitude", SelectScaleArray="v", ScaleFactor=factor)
    ends = session.poly_data(POINTS + factor * VECTORS, covariance=six(COVARIANCES), velocity=VELOCITIES)
    ellipsoids = shown_ellipsoids(stages[2], ends, ScaleFactor=factor, GlyphConfidence=0.9, Opacity=0.4)
    for each in (shown, arrows):
        session.solid(each, (0.9, 0.7, 0.3))
    same_pictures(checks, view, "uncertain vectors", shown, [arrows, ellipsoids])
    for stage in stages[1:]:
        stage.close()
    box = reach(view).T
    half = factor * RADII[0.9] * numpy.sqrt(numpy.diagonal(COVARIANCES, axis1=1, axis2=2))
    lower, upper = (POINTS + factor * VECTORS - half).min(axis=0), (POINTS + factor * VECTORS + half).max(axis=0)
    checks.true("bounds %s of ellipsoids from %s to %s" % (box.tolist(), lower, upper), bool((box[:, 0] <= lower + 1e-5).all() and (box[:, 1] >= upper - 1e-5).all()))
    for number, place in enumerate(POINTS + factor * VECTORS):
        found = [point for _, _, point in session.picked(view, "POINT", session.pixel_of(view, place))]
        checks.equal("picked at the tip %d" % number, found, [number])
    counted = session.statistics(shown)
    checks.equal("arrows, and vectors of zero", (counted["glyphs"], counted["skippedGlyphs"]), (3, 1))
    for array, words in (("None", ("GlyphTensorArray",)), ("lost", ("'lost'", "GlyphTensorArray"))):
        said = session.messages(lambda array=array: setattr(shown, "GlyphTensorArray", array) or pv.Render(view))
        checks.one_message("covariances of %s" % array, said, *words)
    shown.GlyphTensorArray = "nine"
    for array, words in (("nine", ("'nine'", "SelectOrientationVectors", "9 components", "2 or 3")), ("gone", ("'gone'", "SelectOrientationVectors"))):
        said = session.messages(lambda array=array: setattr(shown, "SelectOrientationVectors", array) or pv.Render(view))
        checks.one_message("vectors of %s" % array, said, *words)
        checks.covered("nothing of vectors of %s" % array, session.capture(view, "uncertainty-none"), 0.0, 0.0)
    stages[0].close()


def no_covariances(checks, view, stage):
    """Flat ones are shown; NaN and negative eigenvalues have one message each, zero none."""
    wrong = COVARIANCES.copy()
    wrong[0], wrong[1, 0, 1], wrong[2], wrong[3] = numpy.diag([1.0, 0.5, -0.1]), numpy.nan, 0.0, numpy.diag([0.2, 0.1, -1e-9])
    said = session.messages(lambda: shown_ellipsoids(stage, data(covariance=six(wrong))) and pv.Render(view))
    for words in ("1 of 4 points have no glyph: their tensor, from the point array 'covariance', is no covariance", "1 of 4 points have no glyph: their tensor, from the point array 'covariance', is not finite"):
        checks.true("%s: %s" % (words, said), words in said)
    counted = session.statistics(stage.settings.shown)
    checks.equal("ellipsoids and points without", (counted["glyphs"], counted["skippedGlyphs"]), (1, 3))
    # Of places, ellipsoids have their true size.
    shown = shown_ellipsoids(stage, ScaleFactorFromData=1)
    pv.Render(view)
    checks.equal("ScaleFactor from the data", shown.ScaleFactor, 1.0)


def cone_of(mean, covariance, share):
    """(form, axis, least, largest length): v lies in the cone where v^T form v >= 0. From where a ball's cone of tangents holds the share of
    directions once the covariance is a unit matrix, by sums over slices across the axis."""
    inverse = numpy.linalg.inv(covariance)
    distance = math.sqrt(mean @ inverse @ mean)
    heights, step = numpy.linspace(0.0, distance + 9.0, 200001, retstep=True)
    weights = numpy.exp(-0.5 * (heights - distance) ** 2) * step / math.sqrt(2.0 * math.pi)
    low, high = 0.0, 1.0
    for _ in range(50):
        sine = 0.5 * (low + high)
        inside = (weights * (1.0 - numpy.exp(-0.5 * heights ** 2 * sine ** 2 / (1.0 - sine ** 2)))).sum()
        low, high = (sine, high) if inside < share else (low, sine)
    across = inverse @ mean
    form = numpy.outer(across, across) - (1.0 - low ** 2) * distance ** 2 * inverse
    axis = numpy.linalg.eigh(form)[1][:, 2]
    axis = axis * numpy.sign(axis @ mean)
    spread = {0.9: 1.644854, 0.95: 1.959964, 0.99: 2.575829}[share] * math.sqrt(axis @ covariance @ axis)
    return form, axis, axis @ mean - spread, axis @ mean + spread


def shown_directions(stage, **properties):
    """Arrows and cones."""
    shown = stage.show(data(mean=MEANS), "Uncertain Direction", **{"SelectOrientationVectors": "mean", "GlyphTensorArray": "covariance", "ScaleFactor": 1.0, "GlyphType": "Arrow",
                                                                         "GlyphType.ShaftRadius": 0.0, "GlyphType.TipRadius": 0.0, **WITHOUT_EFFECT, **properties})
    session.solid(shown, (0.9, 0.7, 0.3))
    return shown


def cone_mask(place, form, axis, most):
    """Pixels whose line along z meets the cone: between apex and base the quadratic form is somewhere positive, at an end or at its vertex."""
    x, y = numpy.meshgrid(*[2 * SCALE * ((numpy.arange(SIDE) + 0.5) / SIDE - 0.5)] * 2)
    flat = numpy.stack([x - place[0], -y - place[1], 0.0 * x], axis=-1)
    ends = [(height - flat @ axis) / axis[2] for height in (0.0, most)]
    inside = numpy.zeros((SIDE, SIDE), dtype=bool)
    for z in (*ends, numpy.clip(-(flat @ form)[..., 2] / form[2, 2], *numpy.sort(ends, axis=0))):
        v = flat + z[..., None] * (0.0, 0.0, 1.0)
        inside |= numpy.einsum("...i,ij,...j", v, form, v) >= 0.0
    return inside


def directions(checks, view, stage):
    """The cones hold the stated fractions of samples and have numpy's silhouettes; a direction that may be any has none, and a message."""
    for share in RADII:
        said = session.messages(lambda share=share: shown_directions(stage, GlyphConfidence=share) and pv.Render(view))
        checks.one_message("a direction that may be any", said, "1 of 4 points have no glyph", "direction", "GlyphConfidence %g" % share, "Uncertain Vector")
        found = comparison.covered(session.capture(view, "directions-%g" % share))
        part = export.from_usda(export_of(checks, view))[0][-1][0]
        turns = turned(part.quaternions)
        apexes = part.positions + 0.5 * part.scales[:, :1] * turns[:, :, 0]
        wanted = numpy.zeros((SIDE, SIDE), dtype=bool)
        for number in range(3):
            form, axis, least, most = cone_of(MEANS[number], COVARIANCES[number], share)
            samples = RANDOM.multivariate_normal(MEANS[number], COVARIANCES[number], 1000000)
            own = numpy.abs(apexes - POINTS[number]).max(axis=1) < 1e-5
            lengths = [length for length in (most, least) if length > 0.0]
            checks.true("lengths %s of cones %d, not %s" % (part.scales[own, 0], number, lengths), own.sum() == len(lengths) and numpy.allclose(part.scales[own, 0], lengths, rtol=1e-4))
            for turn, size in zip(turns[own], part.scales[own]):
                local = samples @ turn / (-size)
                inside = (local[:, 0] > 0.0) & (2.0 * numpy.hypot(local[:, 1], local[:, 2]) <= local[:, 0])
                checks.within("fraction of directions %d in the cone of %g" % (number, share), inside.mean(), share - 0.002, share + 0.002)
                along = -samples @ turn[:, 0]
                checks.within("fraction of lengths %d between the bases of %g" % (number, share), ((along >= least) & (along <= most)).mean(), share - 0.002, share + 0.002)
            wanted |= cone_mask(POINTS[number], form, axis, most)
        checks.equal("wrong pixels of the cones of %g" % share, int((found != wanted).sum()), 0)


def cones(checks, view):
    """Uncertain directions are arrows with two translucent cones each."""
    stages = [session.Stage(view) for _ in range(3)]
    shown = shown_directions(stages[0], ScaleFactor=0.8, GlyphConfidence=0.9, **{"GlyphType.ShaftRadius": 0.03, "GlyphType.TipRadius": 0.1})
    pv.Render(view)
    part = export.from_usda(export_of(checks, view))[0][-1][0]
    arrows = stages[1].show(data(mean=MEANS), "Arrow", Orient=1, SelectOrientationVectors="mean", ScaleMode="Magnitude", SelectScaleArray="mean", ScaleFactor=0.8)
    turns = turned(part.quaternions)
    points = numpy.argmin(numpy.linalg.norm((part.positions + 0.5 * part.scales[:, :1] * turns[:, :, 0])[:, None] - POINTS, axis=2), axis=1)
    copies = session.poly_data(part.positions, turn=turns.reshape(-1, 9), lengths=part.scales, velocity=VELOCITIES[points])
    others = [arrows, stages[2].show(copies, "Cone", Orient=1, SelectOrientationVectors="turn", ScaleMode="Vector Components", SelectScaleArray="lengths", ScaleFactor=1.0, Opacity=0.4)]
    for each in others:
        session.solid(each, (0.9, 0.7, 0.3))
    same_pictures(checks, view, "uncertain directions", shown, others)
    wanted = []
    for number in range(3):
        form, axis, _, most = cone_of(0.8 * MEANS[number], 0.64 * COVARIANCES[number], 0.9)
        values, vectors = numpy.linalg.eigh(form)
        base = most * numpy.sqrt(values[2] / -values[:2]) * vectors[:, :2]
        across = numpy.sqrt((base ** 2).sum(axis=1))
        wanted += [POINTS[number] + most * axis - across, POINTS[number] + most * axis + across, POINTS[number]]
        found = [point for _, _, point in session.picked(view, "POINT", session.pixel_of(view, POINTS[number] + 0.99 * most * axis))]
        checks.equal("picked at the base %d" % number, found, [number])
    found = reach(view)
    low, high = numpy.min(wanted, axis=0), numpy.max(wanted, axis=0)
    # Those of the arrows, which reach less far along z, are looser.
    checks.true("bounds %s of cones from %s to %s" % (found.tolist(), low, high), bool((found[0] <= low + 1e-4).all() and (found[1] >= high - 1e-4).all() and found[1][2] <= high[2] + 1e-4))
    for stage in stages:
        stage.close()


def shells(checks, view):
    """Shells are the glyphs of their array with 0.4 of the opacity, whatever the shape; their messages name them."""
    stages = [session.Stage(view) for _ in range(3)]
    sizes, tensors = numpy.array([0.5, 0.8, 0.6, 0.4]), 0.6 * COVARIANCES.reshape(-1, 9)
    given = data(inner=sizes, outer=1.5 * sizes, some=numpy.array([1.0, numpy.nan, 0.0, 1.0]), six=six(COVARIANCES), nine=tensors, wrong=six(COVARIANCES) * [[1.0], [numpy.nan], [1.0], [1.0]])
    balls = {"ScaleMode": "Magnitude", "ScaleFactor": 1.0}
    kinds = {"shells of balls": ("Sphere", "SelectScaleArray", "inner", "outer", balls), "shells of tensors": ("Tensor Ellipsoid", "GlyphTensorArray", "nine", "six", {"ScaleFactor": 6.0})}
    for what, (shape, role, inner, outer, properties) in kinds.items():
        shown = stages[0].show(given, shape, **{**properties, role: inner, "GlyphShellArray": outer})
        others = [stage.show(given, shape, **{**properties, role: array, "GlyphShellArray": "None", "Opacity": opacity}) for stage, array, opacity in ((stages[1], inner, 1.0), (stages[2], outer, 0.4))]
        for each in [shown] + others:
            session.solid(each, (0.9, 0.7, 0.3))
        same_pictures(checks, view, what, shown, others, moves=shape == "Sphere")
        checks.equal("displays in the file of " + what, len(export.from_usda(export_of(checks, view))[0]), 2)
    found, half = reach(view), 3.0 * numpy.array([numpy.linalg.eigvalsh(each)[-1] for each in COVARIANCES])[:, None]
    checks.true("bounds %s of shells" % found.tolist(), numpy.allclose(found, [(POINTS - half).min(axis=0), (POINTS + half).max(axis=0)], atol=1e-4))
    shown = stages[0].show(given, "Sphere", **balls, SelectScaleArray="inner", GlyphShellArray="outer")
    pv.Render(view)
    found = [point for _, _, point in session.picked(view, "POINT", session.pixel_of(view, POINTS[1] + (0.5, 0.0, 0.0)))]
    checks.equal("picked at a shell", found, [1])
    for array, words in (("some", ("1 of 4 points have no glyph", "'some'", "GlyphShellArray")), ("lost", ("'lost'", "GlyphShellArray"))):
        checks.one_message("shells of %s" % array, session.messages(lambda array=array: setattr(shown, "GlyphShellArray", array) or pv.Render(view)), *words)
    shown = stages[0].show(given, "Tensor Ellipsoid", GlyphTensorArray="six", GlyphShellArray="None", ScaleFactor=6.0)
    pv.Render(view)
    checks.one_message("shells of NaN", session.messages(lambda: setattr(shown, "GlyphShellArray", "wrong") or pv.Render(view)), "1 of 4 points have no glyph", "'wrong'", "not finite")
    for stage in stages:
        stage.close()


def main():
    """All parts."""
    session.load()
    checks = Checks()
    view = session.view(SIDE, SIDE)
    session.look(view, (0.0, 0.0, 10.0), parallel_scale=SCALE)
    stage = session.Stage(view)
    shares(checks, view, stage)
    silhouettes(checks, view, stage)
    no_covariances(checks, view, stage)
    directions(checks, view, stage)
    stage.close()
    tips(checks, view)
    cones(checks, view)
    shells(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
