#!/usr/bin/env python3
"""Contacts of touching spheres as lines between their centers, with the normal force of each.

Usage: contacts.py SPHERES.vtk CONTACTS.vtk [STIFFNESS]

SPHERES.vtk: legacy VTK points with the array `diameter`, such as impact/impact_02.vtk. CONTACTS.vtk: a line between the
centers of each two spheres that overlap, with the cell array `force`: STIFFNESS times the overlap, which is what the elastic
part of Hooke contacts pushes with. Default 60000, that of impact.in.
"""
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader, vtkPolyDataWriter


def overlapping(centers, radii):
    """Pairs of spheres that overlap, and by how much: sorted along x, each with those that may reach it."""
    order = numpy.argsort(centers[:, 0], kind="stable")
    x, reach = centers[order, 0], 2.0 * radii.max()
    pairs, overlaps = [], []
    for place, end in enumerate(numpy.searchsorted(x, x + reach)):
        one, others = order[place], order[place + 1:end]
        overlap = radii[one] + radii[others] - numpy.linalg.norm(centers[others] - centers[one], axis=1)
        pairs.extend((one, other) for other in others[overlap > 0.0])
        overlaps.extend(overlap[overlap > 0.0])
    return numpy.array(pairs, dtype=numpy.int64).reshape(-1, 2), numpy.array(overlaps)


def main():
    """Reads spheres, writes contacts."""
    source, target = sys.argv[1:3]
    stiffness = float(sys.argv[3]) if len(sys.argv) > 3 else 60000.0
    reader = vtkGenericDataObjectReader()
    reader.SetFileName(source)
    reader.ReadAllScalarsOn()
    reader.ReadAllVectorsOn()
    reader.Update()
    spheres = reader.GetOutput()
    centers = vtk_to_numpy(spheres.GetPoints().GetData()).astype(float)
    radii = 0.5 * vtk_to_numpy(spheres.GetPointData().GetArray("diameter")).astype(float)
    pairs, overlaps = overlapping(centers, radii)

    points, cells, contacts = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(centers, dtype=numpy.float32), deep=True))
    for pair in pairs:
        cells.InsertNextCell(2, pair.tolist())
    contacts.SetPoints(points)
    contacts.SetLines(cells)
    force = numpy_to_vtk((stiffness * overlaps).astype(numpy.float32), deep=True)
    force.SetName("force")
    contacts.GetCellData().SetScalars(force)
    writer = vtkPolyDataWriter()
    writer.SetFileName(target)
    writer.SetFileTypeToBinary()
    writer.SetInputData(contacts)
    writer.Write()
    print("%d contacts of %d spheres, forces from %g to %g" % (len(pairs), len(radii), *(stiffness * overlaps[[overlaps.argmin(), overlaps.argmax()]])))


if __name__ == "__main__":
    main()
