"""The recipes of Data/RECIPES.md, each as its script in Data/recipes runs it: the page says what the scripts do, nothing is
said by ParaView, every particle is shown, and the picture is that of the code's own formulas: points of the surfaces that
these describe lie where something is seen, and nothing is seen elsewhere. Figure() takes the same settings.

Usage: RTGLYPHS_DATA=FOLDER pvpython recipes.py [NAME...]
"""
import os
import re
import runpy
import sys
import types

import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

#: fraction of a surface's points that may lie where nothing is seen, and of the seen pixels that may lie off the surface: both
#: are where a pixel's center, or one point among many, decides
OUTSIDE, UNEXPLAINED = 0.002, 0.005
#: directions in which points of a surface are taken, and of a surface among very many
COUNT, FEW = 6000, 600
RECIPE = re.compile(r"^# --- \w+\n(.*?)^# --- end\n", re.MULTILINE | re.DOTALL)


def directions(count):
    """Unit vectors, evenly spread."""
    number = numpy.arange(count) + 0.5
    z, angle = 1.0 - 2.0 * number / count, numpy.pi * (1.0 + 5.0**0.5) * number
    return numpy.stack([numpy.sqrt(1.0 - z * z) * numpy.cos(angle), numpy.sqrt(1.0 - z * z) * numpy.sin(angle), z], axis=1)


def superellipsoids(centers, halves, matrices, n1, n2):
    """Points of (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1, turned and moved: along a direction the left side grows as the
    distance to the power of n1."""
    points, along = [], directions(COUNT if len(centers) < 1000 else FEW)
    for center, half, matrix, one, two in zip(centers, halves, matrices, n1, n2):
        x, y, z = numpy.abs(along / half).T
        f = (x**two + y**two)**(one / two) + z**one
        points.append(center + (along * (f**(-1.0 / one))[:, None]) @ numpy.transpose(matrix))
    return numpy.concatenate(points)


def spheres(centers, radii):
    """Points of spheres."""
    same = numpy.full(len(centers), 2.0)
    return superellipsoids(centers, numpy.repeat(numpy.ravel(radii)[:, None], 3, axis=1), [numpy.eye(3)] * len(centers), same, same)


def rotation(w, x, y, z):
    """The matrix of a unit quaternion."""
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def axes(tensors, shown, centers, root=False):
    """Points of the lines that a tensor's eigenvectors are, half the eigenvalue to either side, but for their thin ends; with
    the square root of the largest magnitude as that."""
    values, vectors = numpy.linalg.eigh(tensors)
    if root:
        values = values / numpy.sqrt(numpy.abs(values).max(axis=1, keepdims=True))
    steps = 0.5 * shown.ScaleFactor * numpy.linspace(-0.8, 0.8, 81)
    lines = values[:, None, None, :, None] * steps[None, :, None, None, None] * numpy.swapaxes(vectors, 1, 2)[:, None, None]
    return (centers[:, None, None, None, :] + lines).reshape(-1, 3)


def shafts(case):
    """Points of the arrows' axes from cell centers on."""
    shown, step = case["shown"], numpy.linspace(0.0, 0.98, 50)[None, :, None]
    return (case["centers"][:, None] + shown.ScaleFactor * step * case["u"][:, None]).reshape(-1, 3)


def halos(case):
    """Points of balls whose volumes are as the masses."""
    sizes = case["shown"].ScaleFactor * numpy.cbrt(numpy.genfromtxt("halos.list")[:, 1])
    return spheres(numpy.genfromtxt("halos.list")[:, 2:5], 0.5 * sizes)


def stressed(case, six, centers):
    """Points of the axes of tensors whose components stand in the order xx, xy, xz, yy, yz, zz."""
    whole = numpy.asarray(six)[:, [0, 1, 2, 1, 3, 4, 2, 4, 5]].reshape(-1, 3, 3)
    return axes(whole, case["shown"], centers)


#: recipe -> (points of what must be seen, from the script's variables; whether they are all of it; number of glyphs)
WANTED = {
    "lammps_spheres": (lambda c: spheres(c["positions"], 0.5 * c["diameters"]), True, 125),
    "lammps_ellipsoids": (lambda c: superellipsoids(c["positions"], 0.5 * c["shapes"], [rotation(*q) for q in c["quaternions"]],
                                                    [2.0] * 64, [2.0] * 64), True, 64),
    "lammps_superellipsoids": (lambda c: superellipsoids(c["positions"], 0.5 * c["shapes"], [rotation(*q) for q in c["quaternions"]],
                                                         *c["blocks"].T), True, 27),
    "liggghts_superquadrics": (lambda c: superellipsoids(c["positions"], c["shapes"], c["matrices"], *c["blocks"].T), True, 27),
    "openfoam_cells": (shafts, False, 128),
    "lammps_stress": (lambda c: axes(c["stress"], c["shown"], c["positions"], root=True), False, 140),
    "diffusion_tensors": (lambda c: stressed(c, c["six"].reshape(-1, 6), 2.0 * numpy.stack(
        [c["i"].ravel(), c["j"].ravel(), numpy.zeros(144)], axis=1)), False, 144),
    "calculix_stress": (lambda c: stressed(c, c["stress"][:, [0, 3, 5, 1, 4, 2]], c["nodes"]), False, 108),
    "utm_coordinates": (lambda c: spheres(c["positions"], c["radii"]), True, 108),
    "halos": (halos, True, 2000),
    "uncertain_radii": (lambda c: spheres(c["positions"], c["means"] + 2.0 * c["deviations"]), True, 48),
    # Motion blur moves a sphere by some diameters: its middle is seen.
    "many_particles": (lambda c: spheres(c["positions"], 0.1 * c["radii"]), False, 4000),
}


def see_through(case, picture, checks):
    """Glyphs of the lower bounds are seen in those of the upper ones: without them all their pixels are others."""
    shown = case["shown"]
    shown.SelectScaleArray, shown.GlyphShellArray, shown.Opacity = "upper", "None", 0.4
    without = session.capture(case["view"], "recipe-without-lower", ImageResolution=[400, 300]).astype(int)
    columns, rows = pixels_of(spheres(case["positions"], case["means"] - 2.0 * case["deviations"]), case["view"], 400, 300)
    changed = grown(numpy.abs(picture.astype(int) - without).max(axis=2) > 8, 1)
    checks.within("fraction of the lower bounds that is seen", float(changed[rows, columns].mean()), 1.0 - OUTSIDE, 1.0)


def pixels_of(points, view, width, height):
    """Columns and rows, from the top, of the pixels that points are in."""
    camera = view.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
    whole = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = numpy.column_stack([points, numpy.ones(len(points))]) @ whole.T
    x, y = (0.5 + 0.5 * clip[:, :2] / clip[:, 3:]).T
    return numpy.floor(x * width).astype(int), numpy.floor((1.0 - y) * height).astype(int)


def grown(mask, steps):
    """With all pixels that are at most so many steps away."""
    for _ in range(steps):
        wide = mask.copy()
        for axis in (0, 1):
            for step in (1, -1):
                wide |= numpy.roll(mask, step, axis=axis)
        mask = wide
    return mask


def figure(name, part, case, checks):
    """raytracedglyphs.Figure() makes a picture with a recipe's settings, in five lines with those that open the data."""
    import raytracedglyphs  # comes with the plugin
    opening = [line for line in part.split("view = ")[0].splitlines() if line.strip()]
    checks.within(name + ": lines to a figure", len(opening) + 1, 1, 5)
    asked = types.SimpleNamespace()
    exec("\n".join(re.findall(r"^ *((?:shown|each)\..* = .*)", part, re.MULTILINE)), {"shown": asked, "each": asked})
    wanted = vars(asked)
    kind = wanted.pop("GlyphShape", None) or wanted.pop("GlyphType")
    path = session.output("figure-%s.png" % name)
    shown = raytracedglyphs.Figure(case["shown"].Input, kind, path, size=(80, 60), quality="Fast", **wanted)
    checks.equal(name + ": GlyphType of the figure", shown.GlyphType.GetXMLName(), case["shown"].GlyphType.GetXMLName())
    for key in [*wanted, "GlyphShape"]:
        checks.equal("%s: %s of the figure" % (name, key), str(shown.GetPropertyValue(key)), str(case["shown"].GetPropertyValue(key)))
    picture = session.read_image(path)
    checks.true(name + ": the figure is empty", (picture != picture[0, 0]).any())
    pv.Delete(pv.GetActiveView())


def flat(checks):
    """A figure of flat data fills the picture's width, and without colors its glyphs stand out from white."""
    import raytracedglyphs
    x, y = (grid.ravel() for grid in numpy.mgrid[0:12, 0:12])
    path = session.output("figure-flat.png")
    raytracedglyphs.Figure(session.source(session.poly_data(numpy.stack([x, y, 0 * x], axis=1).astype(float))), "Sphere", path, size=(160, 120), quality="Fast")
    picture = session.read_image(path)[..., :3].astype(int)
    columns = (picture.min(axis=2) < 192).any(axis=0)  # gray on white is not below
    checks.within("share of the width that a figure fills", float((160 - columns[::-1].argmax() - columns.argmax()) / 160.0), 0.88, 0.99)
    checks.true("a figure's glyphs are gray", (picture.max(axis=2) - picture.min(axis=2)).max() > 40)
    pv.Delete(pv.GetActiveView())
    tensors = session.source(session.poly_data(numpy.eye(3), tensor=numpy.tile(numpy.eye(3).ravel(), (3, 1))))
    told = session.messages(lambda: raytracedglyphs.Figure(tensors, "Tensor Ellipsoid", quality="Fast", GlyphTensorArray="tensor"))
    checks.no_message("a figure of tensors", told)
    pv.Delete(pv.GetActiveView())


def recipe(name, page, checks):
    """Runs a script and looks at what it shows."""
    path = os.path.join(os.environ["RTGLYPHS_DATA"], "recipes", name + ".py")
    parts = RECIPE.findall(open(path).read())
    checks.true(name + ": the script has no recipe", parts)
    for part in parts:
        checks.true("%s: RECIPES.md does not say what the script does:\n%s" % (name, part),
                    "".join("    " + line if line.strip() else line for line in part.splitlines(True)) in page)
    case = {}
    session.view(400, 300)  # which the script takes
    said = session.messages(lambda: case.update(runpy.run_path(path)))
    checks.no_message(name, said)
    points, complete, count = WANTED[name]
    shown, view = case["shown"], case["view"]
    statistics = session.statistics(shown)
    checks.equal(name + ": glyphs", statistics["glyphs"], count)
    if shown.LookupTable:
        shown.SetScalarBarVisibility(view, False)
    picture = session.capture(view, "recipe-" + name, ImageResolution=[400, 300])
    seen = comparison.covered(picture)
    columns, rows = pixels_of(points(case), view, 400, 300)
    outside = float((~grown(seen, 1)[rows, columns]).mean())
    mask = numpy.zeros_like(seen)
    mask[rows, columns] = True
    unexplained = float((seen & ~grown(mask, 2)).sum() / max(seen.sum(), 1))
    print("%-24s %5d glyphs, %4.1f %% covered, %.4f of the surface outside, %.4f of the picture unexplained"
          % (name, count, 100 * seen.mean(), outside, unexplained), flush=True)
    checks.within(name + ": fraction of the surfaces that is not seen", outside, 0.0, OUTSIDE)
    checks.within(name + ": covered fraction of the picture", float(seen.mean()), 0.02, 0.8)
    if complete:
        checks.within(name + ": fraction of the picture that is no surface", unexplained, 0.0, UNEXPLAINED)
    if "lower" in case:
        see_through(case, picture, checks)
        shown.SelectScaleArray, shown.GlyphShellArray, shown.Opacity = "radius", "upper", 1.0
    figure(name, parts[0], case, checks)
    pv.Delete(view)
    for source in list(pv.GetSources().values()):
        pv.Delete(source)


def main():
    """All, or those that are named."""
    session.load()
    checks = Checks()
    data = os.environ["RTGLYPHS_DATA"]
    page = open(os.path.join(data, "RECIPES.md")).read()
    names = sys.argv[1:] or sorted(WANTED)
    there = sorted(name[:-3] for name in os.listdir(os.path.join(data, "recipes")) if name.endswith(".py"))
    checks.equal("scripts in Data/recipes", there, sorted(WANTED))
    folder = session.output("recipes")
    os.makedirs(folder, exist_ok=True)
    os.environ["RTGLYPHS_OUTPUT"] = os.path.abspath(os.path.dirname(folder))
    os.chdir(folder)
    for name in names:
        recipe(name, page, checks)
    flat(checks)
    checks.report()


if __name__ == "__main__":
    main()
