"""OpenFOAM, an arrow in each cell: the velocities U as the solver has them, at the cells' centers.

Usage: RTGLYPHS_PLUGIN=FILE pvpython openfoam_cells.py
"""
import os

import numpy
from paraview.simple import *

LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())

# A case of 8 x 8 x 2 cells, a vortex between walls.
N, DEPTH = 8, 2


def foam(path, kind, text):
    """Writes a file of OpenFOAM."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as file:
        file.write("FoamFile { version 2.0; format ascii; class %s; object %s; }\n%s\n" % (kind, os.path.basename(path), text))


def point(i, j, k):
    """The number of a corner."""
    return i + (N + 1) * (j + (N + 1) * k)


faces = []  # (owner, neighbour or N^2 DEPTH for walls, corners)
for k in range(DEPTH):
    for j in range(N):
        for i in range(N):
            cell, walls = i + N * (j + N * k), N * N * DEPTH
            x = [(i + 1, j, k), (i + 1, j + 1, k), (i + 1, j + 1, k + 1), (i + 1, j, k + 1)]
            y = [(i, j + 1, k), (i, j + 1, k + 1), (i + 1, j + 1, k + 1), (i + 1, j + 1, k)]
            z = [(i, j, k + 1), (i + 1, j, k + 1), (i + 1, j + 1, k + 1), (i, j + 1, k + 1)]
            for at, end, step, high in ((i, N, 1, x), (j, N, N, y), (k, DEPTH, N * N, z)):
                axis = [1, N, N * N].index(step)
                faces.append((cell, cell + step if at + 1 < end else walls, high))
                if at == 0:
                    faces.append((cell, walls, [tuple(c - (a == axis) for a, c in enumerate(p)) for p in high][::-1]))
inner = sorted(face for face in faces if face[1] < N * N * DEPTH)
outer = [face for face in faces if face[1] == N * N * DEPTH]
corners = [(i / N, j / N, k / N) for k in range(DEPTH + 1) for j in range(N + 1) for i in range(N + 1)]
centers = numpy.array([((i + 0.5) / N, (j + 0.5) / N, (k + 0.5) / N) for k in range(DEPTH) for j in range(N) for i in range(N)])
u = numpy.stack([numpy.sin(numpy.pi * centers[:, 0]) * numpy.cos(numpy.pi * centers[:, 1]),
                 -numpy.cos(numpy.pi * centers[:, 0]) * numpy.sin(numpy.pi * centers[:, 1]), 0.0 * centers[:, 2]], axis=1)


def listed(rows):
    """A list of OpenFOAM."""
    return "%d (\n%s\n)" % (len(rows), "\n".join(rows))


mesh = "vortex/constant/polyMesh/"
foam(mesh + "points", "vectorField", listed(["(%g %g %g)" % corner for corner in corners]))
foam(mesh + "faces", "faceList", listed(["4(%d %d %d %d)" % tuple(point(*p) for p in face[2]) for face in inner + outer]))
foam(mesh + "owner", "labelList", listed([str(face[0]) for face in inner + outer]))
foam(mesh + "neighbour", "labelList", listed([str(face[1]) for face in inner]))
foam(mesh + "boundary", "polyBoundaryMesh", "1 ( walls { type wall; nFaces %d; startFace %d; } )" % (len(outer), len(inner)))
foam("vortex/system/controlDict", "dictionary", "startTime 1; endTime 1; deltaT 1; writeInterval 1; writeControl timeStep;")
foam("vortex/1/U", "volVectorField", "dimensions [0 1 -1 0 0 0 0];\ninternalField nonuniform List<vector>\n" +
     listed(["(%g %g %g)" % tuple(row) for row in u]) + ";\nboundaryField { walls { type noSlip; } }")
open("vortex/vortex.foam", "w").close()

# --- recipe
case = OpenDataFile("vortex/vortex.foam")
GetAnimationScene().GoToLast()
view = GetActiveViewOrCreate("RenderView")
shown = Show(case, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType, shown.GlyphLocation = "Arrow", "Cells"
shown.ScaleMode = "Magnitude"  # by U, along U
ColorBy(shown, ("CELLS", "U", "Magnitude"))
# --- end

shown.RescaleTransferFunctionToDataRange()
ResetCamera(view)
SaveScreenshot("openfoam_cells.png", view)
