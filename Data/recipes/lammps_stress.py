"""LAMMPS, stress of each atom: a table with the six components of compute stress/atom.

Usage: RTGLYPHS_PLUGIN=FILE pvpython lammps_stress.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# Data with the columns as LAMMPS names and orders them: compute s all stress/atom NULL;
# dump 1 all custom 1000 crystal.dump id type x y z c_s[1] c_s[2] c_s[3] c_s[4] c_s[5] c_s[6], lines after the eighth.
# A crystal around a pore: pressure across it, tension around it, shear.
positions = 3.6 * numpy.stack(numpy.meshgrid(*3 * [numpy.arange(-3.0, 4.0)]), axis=-1).reshape(-1, 3)
positions = positions[(numpy.linalg.norm(positions, axis=1) > 5.0) & (abs(positions[:, 2]) < 4.0)]
r = numpy.linalg.norm(positions, axis=1)[:, None, None]
n = positions[:, :, None] / r
across = n * n.transpose(0, 2, 1)
stress = 1e5 * (5.0 / r)**3 * (0.5 * (numpy.eye(3) - across) - across)
xx, yy, zz, xy, xz, yz = (0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)
columns = numpy.stack([stress[:, i, j] for i, j in (xx, yy, zz, xy, xz, yz)], axis=1)
numpy.savetxt("crystal.csv", numpy.hstack([positions, columns]), fmt="%.8g", comments="",
              header="x y z " + " ".join("c_s[%d]" % i for i in range(1, 7)))

# --- recipe
table = CSVReader(FileName=["crystal.csv"], FieldDelimiterCharacters=" ")
atoms = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z")
view = GetActiveViewOrCreate("RenderView")
shown = Show(atoms, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphShape = "Signed Tensor Superquadric"
shown.GlyphTensorArray = "c_s[1], c_s[2], c_s[3], c_s[4], c_s[5], c_s[6]"
shown.GlyphTensorLayout = "xx yy zz xy xz yz"
shown.GlyphScaleFunction = "Square Root"  # small ones are visible, too
shown.GlyphTensorColoring = "Sign"  # red is tension, blue pressure
# --- end

ResetCamera(view)
SaveScreenshot("lammps_stress.png", view)
