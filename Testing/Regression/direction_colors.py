"""Directions as colors: what each direction has, who wins against arrays, and the key in the view's corner.

Usage: pvpython direction_colors.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

SIZE = (300, 240)
#: a material that shines by itself
FLAT = {"Ambient": 1.0, "Diffuse": 0.0, "ShadingMode": "Local"}
LIGHTS = {"local": {}, "occlusion": {"ShadingMode": "Ambient Occlusion"}, "paths": {"ShadingMode": "Path Tracing"},
          "motion": {"MotionBlur": 1, "VelocityArray": "v", "ShutterTime": 0.2}}
#: at right angles, with z as their diagonal; the first lies over x
CUBE = numpy.array([[numpy.sqrt(2 / 3) * numpy.cos(a), numpy.sqrt(2 / 3) * numpy.sin(a), numpy.sqrt(1 / 3)] for a in numpy.radians((0, 120, 240))])


def unit(vectors):
    """Vectors of length 1."""
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def levels(directions, kind):
    """The colors of unit vectors, as Representation/README.md has them."""
    gray = 0.16 * numpy.minimum(directions[..., 2:], 0.0) ** 2
    return 255.0 * (abs(directions) if kind == "Axes" else (1.0 + numpy.sin(numpy.pi / 2 * directions @ CUBE.T)) / 2 + gray)


def seen(checks, stage, directions, kind):
    """The colors of balls with these directions."""
    columns = 60
    numbers = numpy.arange(len(directions))
    places = numpy.stack([numbers % columns, numbers // columns, 0 * numbers], axis=1).astype(float)
    stage.show(session.poly_data(places, v=directions), Orient=1, SelectOrientationVectors="v", ScaleFactor=1.0, GlyphDirectionColoring=kind,
               GlyphDirectionKey="None", **FLAT)
    session.look(stage.view, (29.5, 23.5, 100.0), (29.5, 23.5, 0.0), parallel_scale=24.0)
    pixels = session.capture(stage.view, "direction-colors-%s" % kind.lower())[::-1, :, :3].astype(float)
    checks.true("%d directions do not fit" % len(directions), len(directions) <= 48 * columns)
    return pixels[(5 * places[:, 1] + 2).astype(int), (5 * places[:, 0] + 2).astype(int)]


def sphere(checks, stage):
    """Colors are the formula's, change by at most five levels in a degree, and those of opposite directions differ, or are the same."""
    random = numpy.random.default_rng(5)
    corners = numpy.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z], float)
    base = unit(numpy.concatenate([corners, CUBE, -CUBE, random.normal(size=(400, 3))]))
    step = numpy.radians(2.0)
    aside = unit(numpy.cross(base, random.normal(size=base.shape)))
    near = [numpy.cos(step) * base + numpy.sin(step) * (numpy.cos(a) * aside + numpy.sin(a) * numpy.cross(base, aside)) for a in (0.0, 1.3, 2.6, 3.9)]
    for kind in ("Axes", "Sphere"):
        found = seen(checks, stage, numpy.concatenate([base, -base, *near]), kind).reshape(6, len(base), 3)
        checks.within(kind + ": levels from the formula", float(abs(found[0] - levels(base, kind)).max()), 0.0, 0.51)
        apart = abs(found[1] - found[0]).max(axis=1)
        low, high = (0.0, 0.0) if kind == "Axes" else (150.0, 255.0)
        for least_or_most in (apart.min(), apart.max()):
            checks.within(kind + ": levels between opposite directions", float(least_or_most), low, high)
        # Both are rounded.
        checks.within(kind + ": levels in two degrees", float(abs(found[2:] - found[0]).max()), 5.0, 2 * 5.0 + 1.0)


def arrows(checks, stage):
    """In each light, while they move, and turned by the display, arrows look as with an array of the same colors."""
    random = numpy.random.default_rng(6)
    places, v = random.uniform(-1.0, 1.0, (60, 3)), random.normal(size=(60, 3))
    tilt = numpy.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
    for kind in ("Axes", "Sphere"):
        for what, properties in {**LIGHTS, "turned": {"Orientation": [90.0, 0.0, 0.0]}, "against": {"ScaleFactor": -0.6}}.items():
            world = unit(v @ tilt.T if what == "turned" else -v if what == "against" else v)
            data = session.poly_data(places, v=v, rgb=numpy.rint(levels(world, kind)).astype(numpy.uint8))
            shown = stage.show(data, "Arrow", **{"Orient": 1, "SelectOrientationVectors": "v", "ScaleFactor": 0.6, "SamplesPerPixel": 2, "Denoising": "Never",
                                                 "GlyphDirectionKey": "None", **properties})
            session.look(stage.view, (1.0, 2.0, 6.0))
            shown.MapScalars, pictures = 0, []
            pv.ColorBy(shown, ("POINTS", "rgb"))
            shown.MapScalars = 0
            checks.equal("an array chosen: directions", shown.GlyphDirectionColoring, "None")
            pictures.append(session.capture(stage.view, "direction-colors-array"))
            shown.GlyphDirectionColoring = kind
            checks.true("directions chosen: there is an array", not shown.ColorArrayName.GetArrayName())
            pictures.append(session.capture(stage.view, "direction-colors-arrows-%s-%s" % (kind.lower(), what)))
            checks.picture("arrows by %s, %s" % (kind, what), pictures[1], pictures[0], pixels=0.0, mean=0.0)


def key_of(view, corner, kind, side):
    """(rows, columns, colors) of pixels well inside the key's discs, in a picture with rows from the top."""
    radius, margin = 0.06 * min(side), 0.02 * min(side)
    camera = view.GetActiveCamera()
    toward = -numpy.array(camera.GetDirectionOfProjection())
    up = unit(numpy.array(camera.GetViewUp()) - numpy.dot(camera.GetViewUp(), toward) * toward)
    rows, columns, colors = [], [], []
    for back in range(2 if kind == "Sphere" else 1):
        width = 2.0 * radius + (2.2 * radius if kind == "Sphere" else 0.0)
        # VTK places drawings at whole pixels.
        middle = numpy.rint([(margin if "Left" in corner else side[0] - margin - width) + radius, side[1] - margin - radius]) + (2.2 * radius * back, 0.0)
        y, x = numpy.mgrid[0:side[1], 0:side[0]]
        across, along = (x + 0.5 - middle[0]) / radius, (side[1] - y - 0.5 - middle[1]) / radius
        inside = across ** 2 + along ** 2 < 0.9 ** 2
        depth = numpy.sqrt(1.0 - across[inside] ** 2 - along[inside] ** 2) * (-1.0 if back else 1.0)
        directions = across[inside, None] * numpy.cross(up, toward) + along[inside, None] * up + depth[:, None] * toward
        rows, columns, colors = rows + [y[inside]], columns + [x[inside]], colors + [levels(directions, kind)]
    return numpy.concatenate(rows), numpy.concatenate(columns), numpy.concatenate(colors)


def key(checks, stage):
    """In the corner that is asked for, turned as the view is, in large pictures, too, and nowhere else."""
    shown = stage.show(session.poly_data(numpy.zeros((1, 3)), v=numpy.array([[0.2, 0.3, -0.4]])), "Arrow", Orient=1, SelectOrientationVectors="v",
                       ScaleFactor=0.2)
    plain = session.capture(stage.view, "direction-key-none")
    for kind, corner, factor, eye in (("Sphere", "Upper Right", 1, (3.0, -2.0, 1.0)), ("Axes", "Upper Left", 1, (1.0, 5.0, -2.0)), ("Sphere", "Upper Left", 3, (-1.0, 0.5, 2.0))):
        session.look(stage.view, eye, up=(0.0, 0.0, 1.0))
        shown.GlyphDirectionColoring, shown.GlyphDirectionKey = kind, corner
        side = [factor * pixels for pixels in SIZE]
        what = "key of %s, %s, %d times as large" % (kind, corner, factor)
        pixels = session.capture(stage.view, "direction-key-%s-%d" % (kind.lower(), factor), **({"ImageResolution": side} if factor > 1 else {}))
        rows, columns, wanted = key_of(stage.view, corner, kind, side)
        checks.within(what + ": pixels", len(rows), 500, 10 ** 6)
        checks.within(what + ": levels from the formula", float(abs(pixels[rows, columns, :3] - wanted).max()), 0.0, 12.0)
        checks.within(what + ": in the mean", float(abs(pixels[rows, columns, :3] - wanted).mean()), 0.0, 1.0)
    for name, value in (("GlyphDirectionKey", "None"), ("GlyphDirectionColoring", "None"), ("Visibility", 0)):
        session.look(stage.view, (0.0, 0.0, 6.0))
        shown.GlyphDirectionColoring, shown.GlyphDirectionKey, shown.Visibility = "Sphere", "Upper Right", 1
        checks.true("%s: no key before" % name, (session.capture(stage.view, "direction-key-on")[:40, -90:] != plain[0, 0]).any())
        setattr(shown, name, value)
        checks.true("%s is %s: a key" % (name, value), (session.capture(stage.view, "direction-key-off")[:40, -90:] == plain[0, 0]).all())
    shown.Visibility = 1


def without(checks, stage):
    """Glyphs without a direction are white, which is said once where none has one; tensors have no sign."""
    places = numpy.array([[-1.0, 0, 0], [1.0, 0, 0]])
    data = session.poly_data(places, v=numpy.array([[0.0, 0, 0], [0, 1.0, 0]]), t=numpy.stack([numpy.diag([1.0, 1.0, -4.0])] * 2).reshape(2, 9))
    shown = stage.show(data, Orient=1, SelectOrientationVectors="v", ScaleFactor=1.0, GlyphDirectionKey="None", GlyphDirectionColoring="Sphere", **FLAT)
    session.look(stage.view, (0.0, 0.0, 6.0), parallel_scale=1.6)
    at = [session.pixel_of(stage.view, place) for place in places]
    found = [session.capture(stage.view, "direction-colors-zero")[::-1][y, x, :3].tolist() for x, y in at]
    checks.equal("colors of a zero vector and one along y", found, [[255] * 3, numpy.rint(levels(numpy.array([0, 1.0, 0]), "Sphere")).astype(int).tolist()])
    shown.Orient = 0
    checks.one_message("no directions", session.messages(lambda: pv.Render(stage.view)), "GlyphDirectionColoring", "Orient")
    shown.ScaleFactor = 0.9
    checks.no_message("no directions, again", session.messages(lambda: pv.Render(stage.view)))
    shown.GlyphShape, shown.GlyphTensorArray, shown.GlyphTensorColoring = "Tensor Ellipsoid", "t", "Sign"
    found = [session.capture(stage.view, "direction-colors-tensor")[::-1][y, x, :3].tolist() for x, y in at]
    checks.equal("colors of tensors along -z", found, [[0, 0, 255]] * 2)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    stage = session.Stage(session.view(*SIZE))
    for part in (sphere, arrows, key, without):
        part(checks, stage)
    checks.report()


if __name__ == "__main__":
    main()
