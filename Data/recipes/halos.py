"""Halos of an N-body simulation whose masses span six decades: the catalogue of a halo finder.

Usage: RTGLYPHS_PLUGIN=FILE pvpython halos.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# Masses in solar masses, by a power law of the kind that halos follow; positions and velocities in Mpc/h and km/s.
random = numpy.random.default_rng(6)
mass = 1e9 * random.uniform(1e-6, 1.0, 2000)**(-1.0 / 0.9)
mass = numpy.minimum(mass, 1e15)
positions = random.uniform(0.0, 100.0, (2000, 3))
numpy.savetxt("halos.list", numpy.column_stack([numpy.arange(2000), mass, positions, random.normal(0.0, 300.0, (2000, 3))]),
              fmt="%.6g", comments="", header="#id mvir x y z vx vy vz")

# --- recipe
table = CSVReader(FileName=["halos.list"], FieldDelimiterCharacters=" ")
if table.GetProperty("CommentCharacters"):  # ParaView 6 leaves out lines that begin with #
    table.CommentCharacters = ""
halos = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z")
view = GetActiveViewOrCreate("RenderView")
shown = Show(halos, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Sphere"
shown.ScaleMode, shown.SelectScaleArray = "Magnitude", "mvir"
shown.GlyphScaleFunction = "Cube Root"  # volumes are proportional to masses
ColorBy(shown, ("POINTS", "mvir"))
GetColorTransferFunction("mvir").MapControlPointsToLogSpace()
GetColorTransferFunction("mvir").UseLogScale = 1
# --- end

ResetCamera(view)
SaveScreenshot("halos.png", view)
