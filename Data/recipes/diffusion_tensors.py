"""Diffusion tensors of magnetic resonance imaging, in mm^2/s, as NRRD: the order xx xy xz yy yz zz.

Usage: RTGLYPHS_PLUGIN=FILE pvpython diffusion_tensors.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# A slice of 2 mm voxels: a bundle of fibers that bends, in tissue that is alike in all directions, and fluid.
N = 12
i, j = numpy.meshgrid(numpy.arange(N), numpy.arange(N), indexing="ij")
radius, angle = numpy.hypot(i + 1.0, j + 1.0), numpy.arctan2(j + 1.0, i + 1.0)
fiber = numpy.stack([-numpy.sin(angle), numpy.cos(angle), 0.0 * angle], axis=-1)
share = numpy.exp(-((radius - 9.0) / 2.5)**2)[..., None, None]
tensors = (0.8 - 0.5 * share) * numpy.eye(3) + 1.4 * share * fiber[..., :, None] * fiber[..., None, :]
tensors = 1e-3 * tensors  # mm^2/s
six = numpy.stack([tensors[..., a, b] for a, b in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))], axis=-1)
with open("diffusion.nrrd", "wb") as file:
    file.write(("NRRD0004\ntype: float\ndimension: 4\nsizes: 6 %d %d 1\nkinds: 3D-symmetric-matrix space space space\n"
                "space: right-anterior-superior\nspace directions: none (2,0,0) (0,2,0) (0,0,2)\nspace origin: (0,0,0)\n"
                "endian: little\nencoding: raw\n\n" % (N, N)).encode())
    file.write(six.transpose(1, 0, 2).astype("<f4").tobytes())

# --- recipe
volume = OpenDataFile("diffusion.nrrd")
view = GetActiveViewOrCreate("RenderView")
shown = Show(volume, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphShape = "Tensor Superquadric"
shown.GlyphTensorLayout = "xx xy xz yy yz zz"
shown.GlyphDirectionColoring = "Axes"
# --- end

ResetCamera(view)
SaveScreenshot("diffusion_tensors.png", view)
