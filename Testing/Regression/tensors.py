"""Tensor glyphs: the same picture as the sizes and rotations they stand for, in every layout; bad tensors;
colors. With the argument parts: colors by the sign of x^T D x, and axes of antisymmetric parts; with crosses: principal axes.

Usage: pvpython tensors.py [parts|crosses]
"""
import sys

import numpy

import paraview.simple as pv

import comparison
import session

#: Three ellipsoids: lengths along their axes and quaternions (w, x, y, z).
LENGTHS = numpy.array([[1.0, 0.6, 0.3], [0.8, 0.8, 0.2], [0.9, 0.1, 0.4]])
QUATERNIONS = numpy.array([[1.0, 0, 0, 0], [0.8, 0.36, 0.48, 0.0], [0.5, -0.5, 0.5, 0.5]])
#: of the thinnest axis, of the longest
DEFAULT_THICKNESS = 0.02
POINTS = numpy.array([[-1.0, 0, 0], [0, 0, 0], [1.0, 0, 0]])


def matrix(quaternion):
    w, x, y, z = quaternion
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def tensors(signs=(1, 1, 1)):
    return numpy.array([matrix(q) @ numpy.diag(l * signs) @ matrix(q).T for q, l in zip(QUATERNIONS, LENGTHS)])


def picture(stage, name, data, shape, **properties):
    stage.show(data, shape, ScaleFactor=0.9, **properties)
    return session.capture(stage.view, "tensors-" + name.replace(" ", "-"))


def colors(failures, view):
    """The color in the middle of a ball or a needle, lit by nothing."""
    data = session.poly_data(POINTS, t=numpy.array([numpy.eye(3), numpy.diag([1.0, 0.2, 0.2]), -numpy.eye(3)]).reshape(3, 9))
    points = session.source(data)
    shown = session.glyphs(points, view, ScaleFactor=0.5, GlyphShape="Tensor Ellipsoid", GlyphTensorArray="t")
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    shown.AmbientColor = [1.0, 1.0, 1.0]
    middle = lambda image, x: image[75, int(round(149.5 + x * 75.0 / 1.608)), :3].astype(int)
    wanted = {"Trace": [None, None, (59, 77, 191)], "Fractional Anisotropy": [(59, 76, 192), None, (59, 76, 192)],
              "Axes": [None, (255, 0, 0), None]}
    # Both have tables of their own, from blue to red over the data's range: -3 to 3, and 0 to 0.77.
    wanted["Trace"][0] = (180, 4, 38)
    wanted["Fractional Anisotropy"][1] = (180, 4, 38)
    for coloring, expected in wanted.items():
        setattr(shown, "GlyphDirectionColoring" if coloring == "Axes" else "GlyphTensorColoring", coloring)
        pv.Render(view)
        if coloring != "Axes":
            session.cool_to_warm("t " + coloring)
        for bar in view.Representations:  # it would stand before the glyphs
            if bar.GetProperty("ComponentTitle") is not None:
                bar.Visibility = 0
        image = session.capture(view, "tensors-color-" + coloring.replace(" ", "-"))
        for x, color in zip((-1, 0, 1), expected):
            seen = middle(image, x)
            print("%s at %d: %s" % (coloring, x, seen))
            if color is not None and numpy.abs(seen - numpy.array(color)).max() > 3:
                failures.append("%s at %d is %s instead of %s" % (coloring, x, seen, color))
    table = pv.GetColorTransferFunction("anisotropy of the test")
    table.RGBPoints = [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    table.ColorSpace = "RGB"
    shown.GlyphTensorColoring, shown.GlyphDirectionColoring = "Fractional Anisotropy", "None"
    shown.GlyphTensorLookupTable = table
    image = session.capture(view, "tensors-color-table")
    # Eigenvalues 1, 0.2, 0.2: sqrt(3/2) sqrt(0.8^2 2/3) / sqrt(1.08) = 0.770.
    if max(numpy.abs(middle(image, -1) - numpy.array([0, 255, 0])).max(),
           numpy.abs(middle(image, 0) - numpy.array([0, 59, 196])).max()) > 3:
        failures.append("the color map of the user gives %s, %s" % (middle(image, -1), middle(image, 0)))
    pv.Delete(shown)
    pv.Delete(points)


def frame_of(view, direction, up, scale, size):
    """Looks at the origin against `direction` in parallel projection: the world positions of all pixels, in the plane through it."""
    direction = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, direction)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(direction, right)
    session.look(view, 5.0 * direction, up=up, parallel_scale=scale)
    width, height = size
    x = (numpy.arange(width) + 0.5 - width / 2.0) * 2.0 * scale / height
    y = (height / 2.0 - numpy.arange(height) - 0.5) * 2.0 * scale / height
    return x[None, :, None] * right + y[:, None, None] * up, direction


def inner(mask):
    """Pixels of a mask whose eight neighbours belong to it, too."""
    padded = numpy.pad(mask, 1)
    height, width = mask.shape
    return numpy.all([padded[i:i + height, j:j + width] for i in range(3) for j in range(3)], axis=0)


def signs(failures, view, size):
    """Colors by the sign of x^T D x. Of ellipsoids the point that a pixel shows is computed; of superquadrics seen along their
    third eigenvector those pixels count whose sign is the same at all depths within the glyph."""
    warm, cool = (0.9, 0.5, 0.1), (0.1, 0.2, 0.8)
    turn = matrix(numpy.array([0.8, 0.36, 0.48, 0.0]))
    axial = numpy.array([[0.0, 0.4, -0.2], [-0.4, 0.0, 0.3], [0.2, -0.3, 0.0]])  # must not count
    aslant = numpy.array([0.3, -0.5, 0.8])
    cases = (("Tensor Ellipsoid", (1.0, -1.0, 0.5), aslant), ("Tensor Ellipsoid", (1.0, -1.0, 0.5), turn[:, 0]),
             ("Tensor Ellipsoid", (0.9, -0.4, -0.7), aslant), ("Tensor Ellipsoid", (-0.3, -0.6, -0.8), aslant),
             ("Tensor Superquadric", (1.0, -1.0, 0.5), turn[:, 2]), ("Signed Tensor Superquadric", (1.0, -0.8, 0.0), turn[:, 2]),
             ("Signed Tensor Superquadric", (1.0, -1.0, 0.5), turn[:, 2]))
    stage, table = session.Stage(view), session.signs(warm, cool)
    for number, (shape, values, direction) in enumerate(cases):
        values = numpy.array(values)
        d = turn @ numpy.diag(values) @ turn.T
        half = 0.5 * numpy.maximum(numpy.abs(values), DEFAULT_THICKNESS)
        stage.show(session.poly_data(numpy.zeros((1, 3)), t=(d + axial).reshape(1, 9), along=2.0 * direction[None]), shape,
                   ScaleFactor=1.0, GlyphTensorArray="t", GlyphTensorColoring="Sign", GlyphTensorLookupTable=table,
                   Ambient=1.0, Diffuse=0.0)
        at, along = frame_of(view, direction, numpy.array([0.1, 1.0, 0.0]), 0.6, size)
        image = session.capture(view, "tensors-sign-%d" % number)[:, :, :3].astype(int)
        hit = comparison.covered(image)
        form = lambda x: numpy.einsum("...i,ij,...j", x, d, x)
        if shape == "Tensor Ellipsoid":
            # |p + s q| = 1 in units of the half-lengths; the camera looks along -q from s = infinity.
            p, q = at @ turn / half, along @ turn / half
            a, b, c = q @ q, p @ q, (p * p).sum(axis=-1) - 1.0
            there = b * b - a * c >= 0.0
            value = form(at + ((-b + numpy.sqrt(numpy.maximum(b * b - a * c, 0.0))) / a)[..., None] * along)
            if (there != hit).mean() > 0.003:
                failures.append("sign of %s: the glyph is not where it should be" % values)
            positive, negative, least = inner(there & (value > 0)), inner(there & (value < 0)), 0.7
        else:
            value = numpy.array([form(at + s * along) for s in numpy.linspace(-1.0, 1.0, 65) * half[2]])
            positive, negative, least = inner(hit & (value > 0).all(axis=0)), inner(hit & (value < 0).all(axis=0)), 0.3
        wrong = sum(int((numpy.abs(image[mask] - numpy.round(255 * numpy.array(color))).max(axis=1, initial=0) > 1).sum())
                    for mask, color in ((positive, warm), (negative, cool)))
        judged = positive.sum() + negative.sum()
        words = "%s, sign of %s: %d positive, %d negative of %d covered pixels, %d wrong" % (
            shape, values, positive.sum(), negative.sum(), hit.sum(), wrong)
        print(words)
        if wrong or judged < least * hit.sum() or hit.sum() < 1000 or not negative.any():
            failures.append(words)
        if number == 0:
            signs_in_motion_and_light(failures, stage, (positive, negative), (warm, cool))
    stage.close()


def signs_in_motion_and_light(failures, stage, masks, sign_colors):
    """Going along the line of sight, a glyph in parallel projection looks as it does at rest; path-traced, both colors lie where they lay."""
    stage.settings.add(dict(MotionBlur=1, VelocityArray="along", ShutterTime=1.0, SamplesPerPixel=8))
    image = session.capture(stage.view, "tensors-sign-moving")[:, :, :3].astype(int)
    wrong = sum(int((numpy.abs(image[mask] - numpy.round(255 * numpy.array(color))).max(axis=1, initial=0) > 1).sum())
                for mask, color in zip(masks, sign_colors))
    stage.settings.add(dict(MotionBlur=0, ShadingMode="Path Tracing", SamplesPerPixel=16))
    light = session.capture(stage.view, "tensors-sign-path")[:, :, :3].astype(int)
    reddish = light[:, :, 0] > light[:, :, 2]
    lost = int((~reddish[masks[0]]).sum() + reddish[masks[1]].sum())
    print("signs moving: %d wrong, path-traced: %d wrong" % (wrong, lost))
    if wrong or lost:
        failures.append("signs of the moving glyph are wrong on %d pixels, of the path-traced one on %d" % (wrong, lost))


def thin(failures, view, same):
    """Stress in one direction is a rod, of two equal ones and zero a plate, a fiftieth of their length thick; other glyphs have
    the lengths of their eigenvalues; what is drawn lies in the display's bounds."""
    up = numpy.array([0.0, 1.0, 0.0])
    stage = session.Stage(view)
    tensor = lambda values: session.poly_data(numpy.zeros((1, 3)), t=values.reshape(1, 9))
    common = dict(GlyphTensorArray="t", ScaleFactor=1.0)
    for shape in ("Tensor Ellipsoid", "Tensor Superquadric", "Signed Tensor Superquadric"):
        for values in ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.7, 0.0, 0.7), (1.0, -1e-5, -1e-5)):
            length = max(numpy.abs(values))
            thickness = DEFAULT_THICKNESS * length
            stage.show(tensor(numpy.diag(values)), shape, **common)
            frame_of(view, numpy.array([0.0, 0.0, 1.0]), up, 1.5 * thickness, (300, 150))
            pixel = 2.0 * 1.5 * thickness / 150
            rows = comparison.covered(session.capture(view, "tensors-thin"))[:, 150].sum()
            words = "%s of %s: %.4f thick, wanted %.4f" % (shape, values, rows * pixel, thickness)
            print(words)
            if abs(rows * pixel - thickness) > 2 * pixel:
                failures.append(words)
        turn = matrix(QUATERNIONS[1])
        rod = stage.show(tensor(numpy.outer(turn[:, 0], turn[:, 0])), shape, **common)
        pv.Render(view)
        found = numpy.array(rod.SMProxy.GetClientSideObject().GetActiveRepresentation().GetActor().GetBounds()).reshape(3, 2)
        reach = 0.5 * numpy.abs(turn[:, 0])
        if (numpy.abs(found).T < 0.999 * reach).any() or (numpy.abs(found) > 1.6).any():
            failures.append("%s: a rod that reaches %s has the bounds %s" % (shape, reach, found))
    stage.close()


def axes(failures, view, same):
    """The antisymmetric part's arrow is the arrow of an array with its axis; symmetric and six-component tensors have none."""
    session.look(view, (0.5, 1.0, 6.0))
    symmetric = tensors((1, -1, 1))
    w = numpy.array([[0.3, 0.9, 0.2], [0.0, 0.0, 0.0], [-0.8, 0.4, 0.6]])
    a = symmetric + numpy.array([[[0, -z, y], [z, 0, -x], [-y, x, 0]] for x, y, z in w])
    levi_civita = numpy.zeros((3, 3, 3))
    levi_civita[[0, 1, 2], [1, 2, 0], [2, 0, 1]], levi_civita[[0, 1, 2], [2, 0, 1], [1, 2, 0]] = 1.0, -1.0
    axis = -0.5 * numpy.einsum("ijk,njk->ni", levi_civita, a)
    factors = numpy.array([0.8, 1.0, 1.3])
    data = dict(t=a.reshape(3, 9), axis=axis, factor=factors, both=axis * factors[:, None])
    yellow = [0.95, 0.8, 0.2]
    stage, arrows = session.Stage(view), session.Stage(view)
    for scaled in (0, 1):
        shown = stage.show(session.poly_data(POINTS, **data), "Tensor Ellipsoid", GlyphTensorArray="t",
                           ScaleMode="Magnitude" if scaled else "No Data Scaling Off", SelectScaleArray="factor", ScaleFactor=1.1)
        session.solid(shown, (0.7, 0.7, 0.7))
        without = session.capture(view, "tensors-axis-off-%d" % scaled)
        shown.GlyphTensorAxis = 1
        with_axes = session.capture(view, "tensors-axis-%d" % scaled)
        shown.GlyphTensorAxis = 0
        same("axis switched off again", without, session.capture(view, "tensors-axis-off-again"), 0.0)
        # The second tensor is symmetric.
        array = "both" if scaled else "axis"
        other = arrows.show(session.poly_data(POINTS[[0, 2]], axis=axis[[0, 2]], both=data["both"][[0, 2]]), "Arrow",
                            ScaleFactor=1.1, SelectScaleArray=array, ScaleMode="Magnitude", Orient=1,
                            SelectOrientationVectors=array, ArrowHeads="Scaled", **{"GlyphType.ShaftRadius": 0.015, "GlyphType.TipRadius": 0.05,
                            "GlyphType.TipLength": 0.15})
        session.solid(other, yellow)
        same("axes as arrows, scaled %d" % scaled, with_axes, session.capture(view, "tensors-axis-arrows-%d" % scaled))
        changed = numpy.mean(numpy.any(without != with_axes, axis=2))
        if changed < 0.003:
            failures.append("the axes change %.3f %% of the pixels only" % (100 * changed))
        arrows.hide()
    arrows.close()

    bad = a.reshape(3, 9).copy()
    bad[0, 0], bad[2, 3] = numpy.nan, numpy.inf
    six = symmetric[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]
    for name, values, words in (("symmetric", symmetric.reshape(3, 9), ""), ("six components", six, ""),
                                ("not finite", bad, "2 of 3 points")):
        pictures = []
        def both():
            for on in (0, 1):
                stage.show(session.poly_data(POINTS, t=values), "Tensor Ellipsoid", GlyphTensorArray="t", ScaleFactor=1.0, GlyphTensorAxis=on)
                pictures.append(session.capture(view, "tensors-axis-none"))
        text = session.messages(both)
        same("no axes: " + name, pictures[0], pictures[1], 0.0)
        if text.count("have no glyph") != (1 if words else 0) or words not in text:
            failures.append("axes, %s: %s" % (name, text))
    stage.close()


def arrows_of(points, whole, factor, function=lambda value: value):
    """(points, vectors) of the arrows that a cross is: of each eigenvalue two, from the center or to it."""
    where, along = [], []
    for center, tensor in zip(points, whole):
        values, vectors = numpy.linalg.eigh(tensor)
        values = values * function(numpy.abs(values).max()) / numpy.abs(values).max()
        for value, vector in zip(values, vectors.T):
            for side in (-1.0, 1.0):
                if abs(value) > 1e-9:
                    where.append(center + (side * 0.5 * factor * abs(value) * vector if value < 0.0 else 0.0))
                    along.append(0.5 * side * value * vector)
    return numpy.array(where), numpy.array(along)


def crosses(failures, view, same):
    """Principal axes are the arrows that they stand for, in every light and in motion; picking finds the tensor's point."""
    session.look(view, (0.3, 0.6, 3.4))
    whole = tensors((1, -1, 1))
    turn = matrix(QUATERNIONS[2])
    whole[1] = turn @ numpy.diag([-0.9, 0.0, 0.0]) @ turn.T  # only one pair
    color = [0.9, 0.6, 0.2]
    velocity = numpy.array([[0.3, 0.0, 0.1], [0.0, 0.4, 0.0], [-0.2, 0.2, 0.0]])
    light = {"local": {}, "occlusion": dict(ShadingMode="Ambient Occlusion", SamplesPerPixel=32),
             "paths": dict(ShadingMode="Path Tracing", SamplesPerPixel=64),
             "moving": dict(MotionBlur=1, VelocityArray="velocity", ShutterTime=1.0, SamplesPerPixel=64)}
    stages = session.Stage(view), session.Stage(view)
    for name, function, scripted in (("Linear", lambda value: value, {}), ("Square Root", numpy.sqrt, {"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.08})):
        where, along = arrows_of(POINTS, whole, 1.1, function)
        nearest = numpy.argmin(numpy.linalg.norm(where[:, None] - POINTS[None], axis=2), axis=1)
        shown = stages[0].show(session.poly_data(POINTS, t=whole.reshape(3, 9), velocity=velocity), "Principal Axes", GlyphTensorArray="t",
                               ScaleFactor=1.1, GlyphScaleFunction=name, **scripted)
        arrows = stages[1].show(session.poly_data(where, along=along, velocity=velocity[nearest]), "Arrow", ScaleFactor=1.1, ScaleMode="Magnitude",
                                SelectScaleArray="along", Orient=1, SelectOrientationVectors="along", ArrowHeads="Scaled", **scripted)
        for each in (shown, arrows):
            session.solid(each, color)
        for lit, properties in (light if name == "Linear" else {"local": {}}).items():
            pictures = []
            for each, hidden in ((shown, arrows), (arrows, shown)):
                each.Visibility, hidden.Visibility = 1, 0
                for key, value in properties.items():
                    setattr(each, key, value)
                pictures.append(session.capture(view, "tensors-cross-%s-%s-%d" % (name.lower().replace(" ", "-"), lit, len(pictures))))
            # Light and motion by chance: of glyphs in another order other samples.
            same("crosses, %s, %s" % (name, lit), *pictures, 0.002 if lit == "local" else 0.02)
            apart = numpy.abs(pictures[0].astype(int) - pictures[1].astype(int)).mean()
            if apart > 0.3:
                failures.append("crosses, %s, %s: pictures are %.3f levels apart" % (name, lit, apart))
            shown.ShadingMode, shown.SamplesPerPixel, shown.MotionBlur, arrows.MotionBlur = "Local", 1, 0, 0
        shown.Visibility, arrows.Visibility = 1, 0
        pv.Render(view)
        box = numpy.array(view.SMProxy.GetRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
        ends = numpy.concatenate([where, where + 1.1 * along])
        if not ((box[:, 0] <= ends.min(axis=0)).all() and (box[:, 1] >= ends.max(axis=0)).all() and (box[:, 1] - box[:, 0] <= numpy.ptp(ends, axis=0) + 1.2).all()):
            failures.append("bounds of crosses: %s round %s to %s" % (box.tolist(), ends.min(axis=0), ends.max(axis=0)))
        counted = session.statistics(shown)
        if (counted["glyphs"], counted["skippedGlyphs"]) != (14, 0):
            failures.append("crosses: %s" % counted)
        for center, tip in zip(POINTS, range(3)):
            values, vectors = numpy.linalg.eigh(whole[tip])
            largest = numpy.argmax(numpy.abs(values))
            at = session.pixel_of(view, center + 0.25 * 1.1 * function(abs(values[largest])) * vectors[:, largest])
            found = [number for _, kind, number in session.picked(view, "POINT", at)]
            if found != [tip]:
                failures.append("picked of cross %d: %s" % (tip, found))
    stages[1].close()
    # Red is tension, blue is compression, all over an arrow.
    signs_of = numpy.array([numpy.diag([0.9, -0.9, 0.0])])
    stages[0].show(session.poly_data(numpy.zeros((1, 3)), t=signs_of.reshape(1, 9)), "Principal Axes", GlyphTensorArray="t", ScaleFactor=1.0,
                   GlyphTensorColoring="Sign", GlyphTensorLookupTable=session.signs((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
                   **{"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.06, "GlyphType.TipRadius": 0.15}, Ambient=1.0, Diffuse=0.0)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=0.6)
    image = session.capture(view, "tensors-cross-sign")
    for place, wanted in (((0.2, 0.0), (255, 0, 0)), ((-0.4, 0.0), (255, 0, 0)), ((0.0, 0.4), (0, 0, 255)), ((0.0, -0.2), (0, 0, 255))):
        x, y = session.pixel_of(view, (*place, 0.0))
        seen = tuple(image[image.shape[0] - 1 - y, x, :3])
        if seen != wanted:
            failures.append("sign of the cross at %s: %s, not %s" % (place, seen, wanted))
    # The head of what is pressed is wide near the center, of what is pulled near its end.
    red, blue = (image[..., :3] == (255, 0, 0)).all(axis=2), (image[..., :3] == (0, 0, 255)).all(axis=2)
    wide = [int(red[:, session.pixel_of(view, (x, 0.0, 0.0))[0]].sum()) for x in (0.15, 0.33)]
    high = [int(blue[image.shape[0] - 1 - session.pixel_of(view, (0.0, y, 0.0))[1]].sum()) for y in (0.13, 0.35)]
    print("widths near the center and far from it: tension %s, compression %s" % (wide, high))
    if not (0 < wide[0] < wide[1] and high[0] > high[1] > 0):
        failures.append("heads of tension %s, of compression %s wide, near the center and far from it" % (wide, high))
    stages[0].close()


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

    if sys.argv[1:] == ["crosses"]:
        crosses(failures, view, same)
        session.finish(failures)
    if sys.argv[1:] == ["parts"]:
        thin(failures, view, same)
        axes(failures, view, same)
        signs(failures, view, (300, 150))
        session.finish(failures)

    # Ellipsoids from lengths and quaternions are the reference.
    stage = session.Stage(view)
    ellipsoids = picture(stage, "reference", session.poly_data(POINTS, size=LENGTHS, turn=QUATERNIONS),
                         "Sphere", SelectScaleArray="size", ScaleMode="Vector Components",
                         Orient=1, SelectOrientationVectors="turn", OrientationMode="Quaternion")
    t = tensors()
    six = lambda *order: numpy.array([[m[i, j] for i, j in order] for m in t])
    xx, yy, zz, xy, yz, xz = (0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)
    layouts = {"xx yy zz xy yz xz": six(xx, yy, zz, xy, yz, xz), "xx xy xz yy yz zz": six(xx, xy, xz, yy, yz, zz),
               "xx yy zz xy xz yz": six(xx, yy, zz, xy, xz, yz), "xx xy yy xz yz zz": six(xx, xy, yy, xz, yz, zz), "Matrix": t.reshape(3, 9)}
    twisted = t + numpy.array([[0, 3, -2], [-3, 0, 1], [2, -1, 0]])
    layouts["Matrix "] = twisted.reshape(3, 9)
    for layout, values in layouts.items():
        image = picture(stage, "layout " + layout, session.poly_data(POINTS, t=values), "Tensor Ellipsoid",
                        GlyphTensorArray="t", GlyphTensorLayout=layout.strip())
        same("layout " + layout, ellipsoids, image)

    # Signs change no ellipsoid; with sharpness 0 positive superquadrics are ellipsoids, of either kind.
    negative = session.poly_data(POINTS, t=tensors((1, -1, -1)).reshape(3, 9))
    same("negative eigenvalues", ellipsoids,
         picture(stage, "negative", negative, "Tensor Ellipsoid", GlyphTensorArray="t"))
    positive = session.poly_data(POINTS, t=t.reshape(3, 9))
    for shape in ("Tensor Superquadric", "Signed Tensor Superquadric"):
        same(shape + " of sharpness 0", ellipsoids, picture(stage, shape, positive, shape, GlyphTensorArray="t", GlyphTensorSharpness=0.0))
        sharp = picture(stage, shape + " sharp", positive, shape, GlyphTensorArray="t", GlyphTensorSharpness=3.0)
        if numpy.mean(numpy.any(sharp != ellipsoids, axis=2)) < 0.01:
            failures.append(shape + ": sharpness makes no difference")
    stage.hide()

    # Numbers as colors: through a map of the user's, and the one of our own; of the principal direction.
    colors(failures, view)

    # Bad tensors: counted, with one message, unless they are zero; wrong lengths of tuples: one message, no glyph.
    bad = t.reshape(3, 9).copy()
    bad[0] = 0.0
    bad[2, 4] = numpy.nan
    expected = [("zero and not finite", bad, "t", "Matrix", "1 of 3 points"),
                ("eight components", numpy.ones((3, 8)), "t", "xx yy zz xy yz xz", "8 components where 6 or 9, 7 with a confidence, 5 without a trace, or 3 or 4 of a plane are needed"),
                ("six as matrix", layouts["xx yy zz xy yz xz"], "t", "Matrix", "6 components where 9, or 4 of a plane, with GlyphTensorLayout Matrix are needed"),
                ("no array", bad, "None", "xx yy zz xy yz xz", "Choose a point array")]
    for name, values, array, layout, words in expected:
        def twice():
            stage.show(session.poly_data(POINTS, t=values), "Tensor Ellipsoid", ScaleFactor=0.9, GlyphTensorArray=array, GlyphTensorLayout=layout)
            pv.Render(view)
            pv.Render(view)
        text = session.messages(twice)
        if text.count(words) != 1:
            failures.append("%s: '%s' is said %d times: %s" % (name, words, text.count(words), text))
    stage.close()
    session.finish(failures)


if __name__ == "__main__":
    session.load()
    main()
