"""Measured radii with their standard deviations: a translucent glyph of the upper bound round the one of the lower bound.

Usage: RTGLYPHS_PLUGIN=FILE pvpython uncertain_radii.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# Bubbles that were found in images from several sides: the farther from the cameras, the less certain, in millimeters.
random = numpy.random.default_rng(7)
positions = 2.0 * numpy.stack(numpy.meshgrid(numpy.arange(6), numpy.arange(4), numpy.arange(2)), axis=-1).reshape(-1, 3)
positions = positions + random.uniform(-0.2, 0.2, positions.shape)
means = random.uniform(0.35, 0.6, len(positions))
deviations = 0.01 + 0.012 * positions[:, 0]
numpy.savetxt("bubbles.csv", numpy.column_stack([positions, means, deviations]), fmt="%.6f", delimiter=",", comments="",
              header="x,y,z,mean,deviation")

# --- recipe
table = CSVReader(FileName=["bubbles.csv"])
bubbles = TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z")
lower = Calculator(Input=bubbles, ResultArrayName="radius", Function="mean-2*deviation")
upper = Calculator(Input=lower, ResultArrayName="upper", Function="mean+2*deviation")
view = GetActiveViewOrCreate("RenderView")
shown = Show(upper, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Sphere"
shown.ScaleMode = "Magnitude"  # by the radius, which is found by its name
shown.GlyphShellArray = "upper"
ColorBy(shown, ("POINTS", "deviation"))
# --- end

ResetCamera(view)
SaveScreenshot("uncertain_radii.png", view)
