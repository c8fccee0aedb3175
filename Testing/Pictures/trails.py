"""Grains that a ball has thrown up, and where they were in the steps before.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython trails.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT]
"""
import os
import sys

import paraview.simple as pv

import cover
import simulation

data, folder = simulation.begin()
series = cover.at(pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series")), 1.5)
shown = cover.raytracedglyphs.Figure(series, "Sphere", colors="velocity", Orient=0, ScaleMode="Magnitude", SelectScaleArray="diameter", ScaleFactor=1.0,
                                     TrailSteps=4, PointIdArray="id", GroundShadow="Below")
view = pv.GetActiveView()
cover.bar(view, "velocity", (0.0, 8.0), "speed", "Plasma")
cover.place(view, (9.0, -36.0, 24.0), (14.3, 14.0, 6.5))
cover.finish(shown, 16)
simulation.save(view, folder, "trails", [int(value) for value in sys.argv[3:5]] or [1200, 900])
pv.Disconnect()
