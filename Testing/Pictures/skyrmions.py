"""A lattice of magnetic skyrmions. Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython skyrmions.py OUTPUT.png [WIDTH HEIGHT]"""
import os
import sys

import numpy
import paraview.simple as pv

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Regression"))
import session  # noqa: E402

session.load()
import raytracedglyphs  # noqa: E402

x, y = (grid.ravel() for grid in numpy.mgrid[-25:26, -19:20])
places = numpy.stack([x + 0.5 * (y % 2), 0.75 ** 0.5 * y, 0.0 * x], axis=1)
waves = [numpy.array([numpy.cos(a), numpy.sin(a), 0.0]) for a in numpy.radians((0, 120, 240))]  # S. Muehlbauer et al., Science 323, 915 (2009)
spins = sum(numpy.cos(places @ q * 0.38)[:, None] * [0, 0, 1] + numpy.sin(places @ q * 0.38)[:, None] * numpy.cross([0, 0, 1], q) for q in waves)
spins /= numpy.linalg.norm(spins, axis=1, keepdims=True)
raytracedglyphs.Figure(
    session.source(session.poly_data(places, spins=spins)), "Arrow", colors="", GroundShadow="None", SamplesPerPixel=32, GlyphDirectionColoring="Sphere", GlyphAnchor="Center",
    ScaleFactor=1.5, SelectOrientationVectors="spins", **{"GlyphType.ShaftRadius": 0.07, "GlyphType.TipRadius": 0.2})
view = pv.GetActiveView()
view.CameraPosition, view.CameraFocalPoint, view.CameraViewAngle = [0, -34, 44], [0, -0.5, 0], 39.5
pv.SaveScreenshot(sys.argv[1], view, ImageResolution=[int(size) for size in sys.argv[2:4]] or [1600, 1200])
