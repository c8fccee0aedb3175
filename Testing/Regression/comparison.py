"""Comparing pictures: against a stored baseline within a stated noise, and glyphs against ParaView's own.

A picture passes against its baseline when at most PIXELS of its pixels differ by more than LEVELS in some channel, and the
mean absolute difference over all pixels and channels is at most MEAN (levels are of 255). Rasterised edges of other
geometry, another Mesa and float rounding flip single pixels; a wrong shape, color or depth changes areas.
"""
import os
import shutil

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

import session

PIXELS = 0.005
LEVELS = 16
MEAN = 0.5


def write_image(path, pixels):
    """Writes an array (rows from the top) as PNG."""
    pixels = numpy.ascontiguousarray(numpy.clip(pixels, 0, 255).astype(numpy.uint8)[::-1])
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]), deep=True))
    session.write_png(path, image)


def difference(left, right):
    """(fraction of pixels that differ by more than LEVELS, mean absolute difference, absolute differences)."""
    apart = numpy.abs(left.astype(int) - right.astype(int))
    return float((apart.max(axis=2) > LEVELS).mean()), float(apart.mean()), apart


def against_baseline(pixels, name):
    """List of failures (empty: passed) of a captured picture against Testing/Baseline/name.png.

    On failure the picture, the baseline and their difference (times 4) lie together in the output folder.
    RTGLYPHS_UPDATE_BASELINE=1 stores the picture as the new baseline instead.
    """
    baseline = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Baseline", name + ".png")
    if os.environ.get("RTGLYPHS_UPDATE_BASELINE"):
        shutil.copyfile(session.output(name + ".png"), baseline)
        return []
    if not os.path.exists(baseline):
        return ["%s: no baseline; look at %s and store it with RTGLYPHS_UPDATE_BASELINE=1" % (name, session.output(name + ".png"))]
    expected = session.read_image(baseline)
    if expected.shape != pixels.shape:
        return ["%s: size %s, baseline %s" % (name, pixels.shape, expected.shape)]
    share, mean, apart = difference(pixels, expected)
    print("%s: %.3f%% of the pixels differ by more than %d, mean %.3f" % (name, 100 * share, LEVELS, mean))
    if share <= PIXELS and mean <= MEAN:
        return []
    write_image(session.output(name + "-difference.png"), 4 * apart)
    shutil.copyfile(baseline, session.output(name + "-baseline.png"))
    return ["%s: %.3f%% of the pixels differ by more than %d (allowed %.3f%%), mean %.3f (allowed %.3f)"
            % (name, 100 * share, LEVELS, 100 * PIXELS, mean, MEAN)]


def covered(pixels):
    """Mask of the pixels that are not background."""
    return (pixels[..., :3] != numpy.array(session.BACKGROUND)).any(axis=2)


def against_paraview(ours, theirs, name, silhouette=0.005, color=2.0):
    """List of failures of ray-traced glyphs against ParaView's 3D Glyphs of the same scene.

    silhouette: allowed fraction of the pixels covered in one picture only. color: allowed mean absolute difference, in
    levels of 255, over the pixels covered in both. Keeps the difference (times 8) beside both pictures.
    """
    mask, their_mask = covered(ours), covered(theirs)
    outline = float((mask != their_mask).mean())
    apart = numpy.abs(ours[..., :3].astype(int) - theirs[..., :3].astype(int))
    both = mask & their_mask
    mean = float(apart[both].mean()) if both.any() else 255.0
    write_image(session.output(name + "-difference.png"), 8 * apart)
    print("%s: silhouettes differ on %.3f%% of the pixels, color by %.3f levels over %d pixels"
          % (name, 100 * outline, mean, both.sum()))
    failures = []
    if outline > silhouette:
        failures.append("%s: silhouettes differ on %.3f%% of the pixels (allowed %.3f%%)" % (name, 100 * outline, 100 * silhouette))
    if mean > color:
        failures.append("%s: colors differ by %.3f levels (allowed %.3f)" % (name, mean, color))
    if both.mean() < 0.02:
        failures.append("%s: only %.2f%% of the picture is covered" % (name, 100 * both.mean()))
    return failures
