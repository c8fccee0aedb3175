"""Coordinates of maps: events less than a meter apart at a northing of nearly 1e7 m.

Usage: RTGLYPHS_PLUGIN=FILE pvpython utm_coordinates.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# Cracks heard in a mine, UTM of the southern hemisphere, meters.
random = numpy.random.default_rng(5)
positions = numpy.array([356412.0, 9876543.0, -1210.0]) + 0.7 * numpy.stack(
    numpy.meshgrid(numpy.arange(6), numpy.arange(6), numpy.arange(3)), axis=-1).reshape(-1, 3) + random.uniform(-0.1, 0.1, (108, 3))
radii = random.uniform(0.1, 0.25, 108)
numpy.savetxt("events.csv", numpy.column_stack([positions, radii]), fmt="%.4f", delimiter=",", comments="",
              header="easting,northing,elevation,source radius")

# --- recipe
table = CSVReader(FileName=["events.csv"])
events = TableToPoints(Input=table, XColumn="easting", YColumn="northing", ZColumn="elevation")
view = GetActiveViewOrCreate("RenderView")
shown = Show(events, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Sphere"
shown.ScaleMode = "Magnitude"  # by the radius, which is found by its name
# --- end

ResetCamera(view)
SaveScreenshot("utm_coordinates.png", view)
