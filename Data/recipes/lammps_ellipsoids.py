"""LAMMPS, ellipsoids: a text dump with the three diameters and the quaternion of each particle.

Usage: RTGLYPHS_PLUGIN=FILE pvpython lammps_ellipsoids.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# Data as LAMMPS writes them:
# compute q all property/atom quatw quati quatj quatk
# compute shape all property/atom shapex shapey shapez
# dump 1 all custom 1000 molecules.dump id type x y z c_q[1] c_q[2] c_q[3] c_q[4] c_shape[1] c_shape[2] c_shape[3]
random = numpy.random.default_rng(2)
positions = 1.4 * numpy.stack(numpy.meshgrid(*3 * [numpy.arange(4.0)]), axis=-1).reshape(-1, 3)
quaternions = random.normal(size=(64, 4))
quaternions /= numpy.linalg.norm(quaternions, axis=1)[:, None]
shapes = random.uniform(0.3, 1.4, (64, 3))
with open("molecules.dump", "w") as file:
    file.write("ITEM: TIMESTEP\n1000\nITEM: NUMBER OF ATOMS\n64\nITEM: BOX BOUNDS ff ff ff\n0 6\n0 6\n0 6\n"
               "ITEM: ATOMS id type x y z c_q[1] c_q[2] c_q[3] c_q[4] c_shape[1] c_shape[2] c_shape[3]\n")
    for i in range(64):
        file.write("%d 1 %s\n" % (i + 1, " ".join("%.8g" % number for number in (*positions[i], *quaternions[i], *shapes[i]))))

# --- recipe
open("molecules.csv", "w").write(open("molecules.dump").read().split("ITEM: ATOMS ")[1])
table = CSVReader(FileName=["molecules.csv"], FieldDelimiterCharacters=" ")
molecules = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z")
view = GetActiveViewOrCreate("RenderView")
shown = Show(molecules, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Sphere"
shown.ScaleFactor = 1  # shapes are full lengths
shown.ScaleMode = "Vector Components"
shown.SelectScaleArray = "c_shape[1], c_shape[2], c_shape[3]"
shown.SelectOrientationVectors = "c_q[1], c_q[2], c_q[3], c_q[4]"
# --- end

ResetCamera(view)
SaveScreenshot("lammps_ellipsoids.png", view)
