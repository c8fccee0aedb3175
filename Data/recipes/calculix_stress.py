"""CalculiX, stress at the nodes: the array S of the VTU that ccx2paraview makes of an .frd file.

Usage: RTGLYPHS_PLUGIN=FILE pvpython calculix_stress.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# A quarter of a thick pipe with closed ends under 100 MPa from inside, by Lame's solution: a to b are 50 to 100 mm.
A, B, P = 50.0, 100.0, 100.0
NX, NY, NZ = 6, 9, 2  # nodes across the wall, around, along
r, angle, z = (values.ravel() for values in numpy.meshgrid(
    numpy.linspace(A, B, NX), numpy.linspace(0.0, numpy.pi / 2.0, NY), [0.0, 25.0], indexing="ij"))
r, angle, z = (values.reshape(NX, NY, NZ).transpose(2, 1, 0).ravel() for values in (r, angle, z))
c, s = numpy.cos(angle), numpy.sin(angle)
nodes = numpy.stack([r * c, r * s, z], axis=1)
axial = P * A**2 / (B**2 - A**2)
radial, hoop = axial * (1.0 - B**2 / r**2), axial * (1.0 + B**2 / r**2)
stress = numpy.stack([radial * c * c + hoop * s * s, radial * s * s + hoop * c * c, axial + 0.0 * r,
                      (radial - hoop) * c * s, 0.0 * r, 0.0 * r], axis=1)  # SXX SYY SZZ SXY SYZ SZX
at = lambda i, j, k: i + NX * (j + NY * k)
cells = [[at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)]
         for k in range(NZ - 1) for j in range(NY - 1) for i in range(NX - 1)]
text = lambda values: " ".join("%.9g" % value for value in numpy.ravel(values))
array = lambda name, values, kind="Float64", more="": '<DataArray type="%s" Name="%s" %s format="ascii">%s</DataArray>' % (
    kind, name, more, text(values))
with open("pipe.vtu", "w") as file:
    file.write('<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid><Piece NumberOfPoints="%d" NumberOfCells="%d">'
               % (len(nodes), len(cells)))
    file.write("<Points>" + array("Points", nodes, more='NumberOfComponents="3"') + "</Points><Cells>")
    file.write(array("connectivity", cells, "Int64") + array("offsets", 8 * numpy.arange(1, len(cells) + 1), "Int64") +
               array("types", [12] * len(cells), "UInt8") + "</Cells><PointData>")
    file.write(array("U", 0.0 * nodes, more='NumberOfComponents="3"') + array("S", stress, more='NumberOfComponents="6"'))
    file.write("</PointData></Piece></UnstructuredGrid></VTKFile>")

# --- recipe
pipe = OpenDataFile("pipe.vtu")
view = GetActiveViewOrCreate("RenderView")
shown = Show(pipe, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphShape = "Tensor Ellipsoid"
shown.GlyphTensorArray = "S"
shown.GlyphTensorColoring = "Sign"  # red is tension, blue pressure
# --- end

ResetCamera(view)
SaveScreenshot("calculix_stress.png", view)
