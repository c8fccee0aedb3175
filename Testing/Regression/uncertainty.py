"""Confidence ellipsoids hold the stated fraction of a Gaussian's samples and have numpy's silhouettes; those of uncertain vectors are the same
round the arrows' tips, in motion, too; what is no covariance has no ellipsoid, and a message.

Usage: pvpython uncertainty.py
"""
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


def shares(checks, view, stage):
    """Of samples of each Gaussian the stated fraction lies in the exported ellipsoid."""
    for share in RADII:
        shown_ellipsoids(stage, GlyphConfidence=share)
        path = session.output("uncertainty.usda")
        checks.no_message("export", export.export(path, view))
        part = export.from_usda(path)[0][0][0]
        for number, covariance in enumerate(COVARIANCES):
            samples = RANDOM.multivariate_normal(POINTS[number], covariance, 100000)
            w, x, y, z = part.quaternions[number]
            turn = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
            inside = (numpy.square((samples - part.positions[number]) @ turn / (0.5 * part.scales[number])).sum(axis=1) <= 1.0).mean()
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
    for lit, properties in {"local": {}, "moving": dict(MotionBlur=1, VelocityArray="velocity", ShutterTime=1.0, SamplesPerPixel=64)}.items():
        pictures = []
        for visible in ([shown], [arrows, ellipsoids]):
            for each in (shown, arrows, ellipsoids):
                each.Visibility = each in visible
                for key, value in properties.items():
                    setattr(each, key, value)
            pictures.append(session.capture(view, "uncertainty-%s-%d" % (lit, len(pictures))))
        checks.picture("uncertain vectors, arrows and ellipsoids, " + lit, *pictures, pixels=0.0 if lit == "local" else 0.02, mean=0.3)
    for stage in stages[1:]:
        stage.close()
    shown.Visibility, shown.MotionBlur, shown.SamplesPerPixel = 1, 0, 1
    pv.Render(view)
    box = numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
    reach = factor * RADII[0.9] * numpy.sqrt(numpy.diagonal(COVARIANCES, axis1=1, axis2=2))
    lower, upper = (POINTS + factor * VECTORS - reach).min(axis=0), (POINTS + factor * VECTORS + reach).max(axis=0)
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
    stage.close()
    tips(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
