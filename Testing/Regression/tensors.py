"""Tensor glyphs: the same picture as the sizes and rotations they stand for, in every layout; bad tensors; turned ones.

Usage: pvpython tensors.py
"""
import numpy

import paraview.simple as pv

import comparison
import session

#: Three ellipsoids: lengths along their axes and quaternions (w, x, y, z).
LENGTHS = numpy.array([[1.0, 0.6, 0.3], [0.8, 0.8, 0.2], [0.9, 0.1, 0.4]])
QUATERNIONS = numpy.array([[1.0, 0, 0, 0], [0.8, 0.36, 0.48, 0.0], [0.5, -0.5, 0.5, 0.5]])
POINTS = numpy.array([[-1.0, 0, 0], [0, 0, 0], [1.0, 0, 0]])


def matrix(quaternion):
    w, x, y, z = quaternion
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def tensors(signs=(1, 1, 1)):
    return numpy.array([matrix(q) @ numpy.diag(l * signs) @ matrix(q).T for q, l in zip(QUATERNIONS, LENGTHS)])


def picture(view, name, data, **properties):
    points = session.source(data)
    shown = session.glyphs(points, view, **{"GlyphScaleFactor": 0.9, **properties})
    image = session.capture(view, "tensors-" + name.replace(" ", "-"))
    pv.Delete(shown)
    pv.Delete(points)
    return image


def colours(failures, view):
    """The colour in the middle of a ball or a needle, lit by nothing."""
    data = session.poly_data(POINTS, t=numpy.array([numpy.eye(3), numpy.diag([1.0, 0.2, 0.2]), -numpy.eye(3)]).reshape(3, 9))
    points = session.source(data)
    shown = session.glyphs(points, view, GlyphScaleFactor=0.5, GlyphShape="Tensor Ellipsoid", GlyphTensorArray="t")
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    shown.AmbientColor = [1.0, 1.0, 1.0]
    middle = lambda image, x: image[75, int(round(149.5 + x * 75.0 / 1.608)), :3].astype(int)
    wanted = {"Trace": [(242, 242, 242), None, (59, 77, 191)], "Fractional Anisotropy": [(242, 242, 242), None, (242, 242, 242)],
              "Principal Direction": [None, (255, 0, 0), None]}
    # Of the trace the largest magnitude is 3: 3 is the end of the map in red, -3 that in blue.
    wanted["Trace"][0] = (179, 5, 38)
    for colouring, expected in wanted.items():
        shown.GlyphTensorColoring = colouring
        image = session.capture(view, "tensors-colour-" + colouring.replace(" ", "-"))
        for x, colour in zip((-1, 0, 1), expected):
            seen = middle(image, x)
            print("%s at %d: %s" % (colouring, x, seen))
            if colour is not None and numpy.abs(seen - numpy.array(colour)).max() > 3:
                failures.append("%s at %d is %s instead of %s" % (colouring, x, seen, colour))
    table = pv.GetColorTransferFunction("anisotropy of the test")
    table.RGBPoints = [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    table.ColorSpace = "RGB"
    shown.GlyphTensorColoring = "Fractional Anisotropy"
    shown.LookupTable = table
    image = session.capture(view, "tensors-colour-table")
    # Eigenvalues 1, 0.2, 0.2: sqrt(3/2) sqrt(0.8^2 2/3) / sqrt(1.08) = 0.770.
    if max(numpy.abs(middle(image, -1) - numpy.array([0, 255, 0])).max(),
           numpy.abs(middle(image, 0) - numpy.array([0, 59, 196])).max()) > 3:
        failures.append("the colour map of the user gives %s, %s" % (middle(image, -1), middle(image, 0)))
    pv.Delete(shown)
    pv.Delete(points)


def main():
    failures = []
    view = session.view(300, 150)
    session.look(view, (0.0, 0.0, 6.0))

    def same(name, left, right, share=0.002):
        wrong = numpy.mean(numpy.any(numpy.abs(left.astype(int) - right.astype(int)) > 8, axis=2))
        print("%s: %.4f %% of the pixels differ, %.2f %% are covered" %
              (name, 100 * wrong, 100 * numpy.mean(comparison.covered(left))))
        if wrong > share or not comparison.covered(left).any():
            failures.append("%s: %.3f %% of the pixels differ" % (name, 100 * wrong))

    # Ellipsoids from lengths and quaternions are the reference.
    ellipsoids = picture(view, "reference", session.poly_data(POINTS, size=LENGTHS, turn=QUATERNIONS),
                         GlyphShape="Sphere", GlyphScaling=1, GlyphScaleArray="size", GlyphScaleMode="Components",
                         GlyphOrient=1, GlyphOrientationArray="turn", GlyphOrientationMode="Quaternion")
    t = tensors()
    six = lambda *order: numpy.array([[m[i, j] for i, j in order] for m in t])
    xx, yy, zz, xy, yz, xz = (0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)
    layouts = {"VTK": six(xx, yy, zz, xy, yz, xz), "Row": six(xx, xy, xz, yy, yz, zz),
               "LAMMPS": six(xx, yy, zz, xy, xz, yz), "Matrix": t.reshape(3, 9)}
    twisted = t + numpy.array([[0, 3, -2], [-3, 0, 1], [2, -1, 0]])
    layouts["Matrix "] = twisted.reshape(3, 9)
    for layout, values in layouts.items():
        image = picture(view, "layout " + layout, session.poly_data(POINTS, t=values), GlyphShape="Tensor Ellipsoid",
                        GlyphTensorArray="t", GlyphTensorLayout=layout.strip())
        same("layout " + layout, ellipsoids, image)

    # Signs change no ellipsoid; with sharpness 0 positive superquadrics are ellipsoids, of either kind.
    negative = session.poly_data(POINTS, t=tensors((1, -1, -1)).reshape(3, 9))
    same("negative eigenvalues", ellipsoids,
         picture(view, "negative", negative, GlyphShape="Tensor Ellipsoid", GlyphTensorArray="t"))
    positive = session.poly_data(POINTS, t=t.reshape(3, 9))
    for shape in ("Tensor Superquadric", "Signed Tensor Superquadric"):
        points = session.source(positive)
        shown = session.glyphs(points, view, GlyphScaleFactor=0.9, GlyphShape=shape, GlyphTensorArray="t",
                               GlyphTensorSharpness=0.0)
        same(shape + " of sharpness 0", ellipsoids, session.capture(view, "tensors-" + shape.replace(" ", "-")))
        shown.GlyphTensorSharpness = 3.0
        sharp = session.capture(view, "tensors-" + shape.replace(" ", "-") + "-sharp")
        pv.Delete(shown)
        pv.Delete(points)
        if numpy.mean(numpy.any(sharp != ellipsoids, axis=2)) < 0.01:
            failures.append(shape + ": sharpness makes no difference")

    # Numbers as colours: through a map of the user's, and the one of our own; of the principal direction.
    colours(failures, view)

    # Bad tensors: counted and told once; wrong lengths of tuples: one message, no glyph.
    bad = t.reshape(3, 9).copy()
    bad[0] = 0.0
    bad[2, 4] = numpy.nan
    expected = [("zero and not finite", bad, "t", "Matrix", "2 of 3 points"),
                ("four components", numpy.ones((3, 4)), "t", "VTK", "4 components where 6 or 9 are needed"),
                ("six as matrix", layouts["VTK"], "t", "Matrix", "6 components where 9 are needed"),
                ("no array", bad, "None", "VTK", "Choose a point array")]
    for name, values, array, layout, words in expected:
        points = session.source(session.poly_data(POINTS, t=values))
        shown = session.glyphs(points, view, GlyphShape="Tensor Ellipsoid", GlyphTensorArray=array,
                               GlyphTensorLayout=layout)
        text = session.messages(lambda: (pv.Render(view), pv.Render(view)))
        if text.count(words) != 1:
            failures.append("%s: '%s' is said %d times: %s" % (name, words, text.count(words), text))
        pv.Delete(shown)
        pv.Delete(points)
    session.finish(failures)


if __name__ == "__main__":
    session.load()
    main()
