"""Measures light and colors of the gallery's pictures and of the recipes'; fails where one is out of bounds.

Usage: pvpython measure.py [FILE...]

A pixel of a glyph is its color times the light on it, and tone mapping changes all channels by one factor. So the color is that one of a picture's
table which, made as bright as the pixel, is nearest, and the light is what it was multiplied by. Only areas of nearly one color are measured: edges,
words, gray surfaces and the background with its shadows are not.

contrast: light on the brightest fiftieth over that on the darkest, linear. dark: fraction of pixels below a tenth of their color's level. burnt out:
fraction with a channel at 254 or more that their color does not have so bright. hue: how far fully lit pixels (within a tenth of their color's level) are from
their color, in levels of 255; 95 of 100 are nearer. Where glyphs are translucent or blurred, or their colors stand for directions, which have all hues,
light is the pixels' luminance, and there is no hue.
"""
import glob
import os
import sys

import numpy
from vtkmodules.vtkIOImage import vtkImageReader2Factory

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Regression"))
import session  # noqa: E402
from checks import Checks  # noqa: E402
from property_claims import to_level, to_light  # noqa: E402

import simulation  # noqa: E402

#: Least contrast, and the most that the others may be
CONTRAST, DARK, BURNT, HUE = 3.0, 0.005, 0.001, 12.0
#: pixels that are looked at in each picture
LOOKED_AT = 100000
#: with fewer in areas of one color, those at edges count, too: glyphs are a few pixels wide
FEW = 2000
#: of what is not gray: difference of channels over the largest
SATURATION = 0.25
#: ParaView's Cool to Warm, to the blue and the red end
COOL_TO_WARM = (0.0, 0.231, 0.298, 0.753, 0.125, 0.384, 0.510, 0.918, 0.25, 0.552, 0.690, 0.996, 0.375, 0.722, 0.816, 0.976, 0.5, 0.865, 0.865, 0.865,
                0.625, 0.961, 0.769, 0.678, 0.75, 0.957, 0.604, 0.482, 0.875, 0.871, 0.376, 0.302, 1.0, 0.706, 0.016, 0.150)
#: of negative and of positive values
SIGNS = (0.0, 0.263, 0.576, 0.765, 0.5, 0.263, 0.576, 0.765, 0.5, 0.839, 0.376, 0.302, 1.0, 0.839, 0.376, 0.302)
#: table -> pictures of opaque glyphs at rest
TABLES = {
    simulation.EMBER: "cover-chains cover-stress cover-impact cover-trails covariance_tubes light-spheres",
    simulation.RAINBOW: "cover-vessel cover-streamlines cover-detail split_vectors injection-arrows injection-arrows-near can-arrows can-surface",
    COOL_TO_WARM: "light-vessel halos lammps_spheres lammps_superellipsoids liggghts_superquadrics openfoam_cells",
    SIGNS: "point_load flow tensors-vtk calculix_stress lammps_stress",
    (0.0, 0.86, 0.60, 0.25, 1.0, 0.86, 0.60, 0.25): "cover-superquadrics",
}
#: not of glyphs alone, or all gray
OTHERS = ("panel", "lammps_ellipsoids", "utm_coordinates")


def colors_of(name):
    """The colors that a picture's table has, or None."""
    for table, names in TABLES.items():
        if name in names.split():
            nodes, at = numpy.reshape(table, (-1, 4)), numpy.linspace(0.0, 1.0, 101)
            return numpy.stack([numpy.interp(at, nodes[:, 0], nodes[:, 1 + i]) for i in range(3)], axis=1)
    return None


def pixels_of(path):
    """Levels from 0 to 1 of some pixels of a picture, and which of them lie in areas of one color."""
    reader = vtkImageReader2Factory.CreateImageReader2(path)
    reader.SetFileName(path)
    reader.Update()
    levels = session.pixels_of(reader.GetOutput())[..., :3].astype(int)
    random = numpy.random.default_rng(1)
    rows, columns = (random.integers(2, size - 2, LOOKED_AT) for size in levels.shape[:2])
    there = levels[rows, columns]
    rows, columns = (at[there.max(1) - there.min(1) > SATURATION * there.max(1)] for at in (rows, columns))
    near = numpy.stack([levels[rows + i, columns + j] for i in range(-2, 3) for j in range(-2, 3)]).reshape(5, 5, -1, 3)
    colored = near.max(3) - near.min(3) > SATURATION * near.max(3)
    around = near[1:4, 1:4].reshape(9, -1, 3)
    flat = colored.all((0, 1)) & ((around.max(0) - around.min(0)).max(1) <= 16)
    taken = flat if flat.sum() > FEW else colored[1:4, 1:4].all((0, 1))
    return near[2, 2][taken] / 255.0, flat[taken]


def measured(path):
    """(number of pixels, contrast, dark, burnt out, hue) of a picture."""
    colors, (pixels, flat) = colors_of(os.path.splitext(os.path.basename(path))[0]), pixels_of(path)
    light = to_light(pixels)
    if colors is None:
        luminance = light @ numpy.array([0.2126, 0.7152, 0.0722])
        dark, bright = numpy.quantile(luminance, [0.02, 0.98])
        return len(pixels), bright / dark, (pixels.max(1) < 0.1).mean(), (pixels.min(1) >= 254.0 / 255.0).mean(), numpy.nan
    linear = to_light(colors)
    factors = light.max(1)[:, None] / linear.max(1)
    apart = numpy.stack([numpy.abs(to_level(light / factor[:, None]) - color).max(1) for factor, color in zip(factors.T, colors)])
    own = apart.argmin(0)
    factor, apart, color = factors[numpy.arange(len(own)), own], apart.min(0), colors[own]
    level = pixels.max(1) / color.max(1)
    full = flat & (numpy.abs(level - 1.0) <= 0.1)
    dark, bright = numpy.quantile(factor, [0.02, 0.98])
    return (len(pixels), bright / dark, (level < 0.1).mean(), ((pixels >= 254.0 / 255.0) & (color < 0.97)).any(1).mean(),
            255.0 * numpy.quantile(apart[full], 0.95) if full.sum() >= 20 else numpy.nan)


def main():
    """Measures all pictures, or those that are named."""
    checks = Checks()
    for path in sys.argv[1:] or sorted(sum((glob.glob(os.path.join(HERE, pattern)) for pattern in ("*.png", "*.jpg", "recipes/*.png")), [])):
        name = os.path.splitext(os.path.basename(path))[0]
        if name in OTHERS:
            continue
        count, contrast, dark, burnt, hue = measured(path)
        print("%-28s %5d pixels: contrast %4.1f, dark %.4f, burnt out %.4f, hue %.1f" % (name, count, contrast, dark, burnt, hue))
        checks.true("%s: contrast is %.1f" % (name, contrast), contrast >= CONTRAST)
        for what, value, most in (("dark", dark, DARK), ("burnt out", burnt, BURNT), ("hue", hue, HUE)):
            checks.true("%s: %s is %.4g" % (name, what, value), not value > most)
    checks.report()


if __name__ == "__main__":
    main()
