"""Millions of particles with ambient occlusion and motion blur, where Point Gaussian has neither.

Usage: RTGLYPHS_PLUGIN=FILE pvpython many_particles.py
RTGLYPHS_PARTICLES: number of particles (default 4000); with it the script prints seconds and memory.
"""
import os
import resource
import time

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# A swirling jet; binary legacy VTK is big-endian.
count = int(os.environ.get("RTGLYPHS_PARTICLES", 4000))
random = numpy.random.default_rng(7)
height, angle = random.uniform(0.0, 3.0, count), random.uniform(0.0, 2.0 * numpy.pi, count)
distance = (0.15 + 0.3 * height) * numpy.sqrt(random.uniform(0.0, 1.0, count))
positions = numpy.column_stack([distance * numpy.cos(angle), distance * numpy.sin(angle), height])
velocities = numpy.column_stack([-positions[:, 1], positions[:, 0], numpy.zeros(count)]) * 4.0 / (0.5 + height)[:, None]
velocities[:, 2] = 2.0 / (0.5 + height)
radii = 0.35 * count**(-1.0 / 3.0) * random.uniform(0.5, 1.0, count)
with open("particles.vtk", "wb") as file:
    file.write(b"# vtk DataFile Version 3.0\nparticles\nBINARY\nDATASET POLYDATA\nPOINTS %d float\n" % count)
    positions.astype(">f4").tofile(file)
    file.write(b"\nPOINT_DATA %d\nFIELD FieldData 2\nradius 1 %d float\n" % (count, count))
    radii.astype(">f4").tofile(file)
    file.write(b"\nvelocity 3 %d float\n" % count)
    velocities.astype(">f4").tofile(file)
start = time.time()

# --- recipe
particles = OpenDataFile("particles.vtk")
view = GetActiveViewOrCreate("RenderView")
shown = Show(particles, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Sphere"
shown.ScaleMode = "Magnitude"  # by the radius, which is found by its name
shown.ShadingMode = "Ambient Occlusion"
shown.MotionBlur, shown.VelocityArray = 1, "velocity"
ColorBy(shown, ("POINTS", "velocity", "Magnitude"))
# --- end

shown.RescaleTransferFunctionToDataRange()
ResetCamera(view)
SaveScreenshot("many_particles.png", view)
if "RTGLYPHS_PARTICLES" in os.environ:
    print("%d particles, first finished picture after %.1f s, peak memory %.2f GB"
          % (count, time.time() - start, 1024e-9 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss))
