"""Superquadrics by their exponents, and the stress under a point load as signed tensor glyphs beside lines of ParaView's own.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython shapes.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT]
"""
import os
import sys

import numpy
import paraview.simple as pv
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from simulation import begin, look, new_view, save, show

#: The exponents of the table: of x and y from left to right, of z from bottom to top.
EXPONENTS = (0.4, 0.7, 1.0, 2.0, 4.0, 20.0)


def source(points, **arrays):
    """Points with arrays as a pipeline source."""
    data = vtkPolyData()
    at = vtkPoints()
    at.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(at)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    producer = pv.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def superquadrics(view):
    """A table of superquadrics: exponents of the cross-section grow to the right, along the axis upwards."""
    grid = [(i, j) for j in range(len(EXPONENTS)) for i in range(len(EXPONENTS))]
    points = [(1.15 * i, 0.0, 1.15 * j) for i, j in grid]
    exponents = [(EXPONENTS[i], EXPONENTS[i], EXPONENTS[j]) for i, j in grid]
    shown = show(source(points, exponents=exponents), view, "Superquadric", GlyphExponentArray="exponents",
                 Orient=0, ScaleFactor=1.0)
    shown.AmbientColor = shown.DiffuseColor = [0.85, 0.65, 0.3]
    middle = 1.15 * (len(EXPONENTS) - 1) / 2
    look(view, (middle + 4.0, -13.0, middle + 5.5), (middle, 0.0, middle), (0.0, 0.0, 1.0))
    view.CameraViewAngle = 30.0


def point_load(view, data):
    """Stresses fall with the square of the distance: the glyphs' sizes are logarithms, log10(1 + |s| / s0)."""
    reader = pv.OpenDataFile(os.path.join(data, "point_load", "point_load.vtk"))
    reader.UpdatePipeline()
    adapter = dataset_adapter.WrapDataObject(pv.servermanager.Fetch(reader))
    stress = numpy.array(adapter.PointData["stress"])
    norm = numpy.sqrt((stress[:, :3] ** 2).sum(axis=1) + 2.0 * (stress[:, 3:] ** 2).sum(axis=1))
    least = numpy.quantile(norm, 0.02)
    log_size = numpy.log10(1.0 + norm / least) / norm
    points = source(vtk_to_numpy(adapter.VTKObject.GetPoints().GetData()), stress=stress, log_size=log_size)
    spacing = 0.2 * numpy.ptp(numpy.array(points.GetDataInformation().GetBounds()).reshape(3, 2), axis=1).max() / 2.0
    largest = (log_size * norm).max()
    shown = show(points, view, "Signed Tensor Superquadric", GlyphTensorArray="stress", GlyphTensorColoring="Trace",
                 SelectScaleArray="log_size", ScaleMode="Magnitude",
                 ScaleFactor=3.0 * spacing / largest)
    table = pv.GetColorTransferFunction("trace")
    table.ApplyPreset("Cool to Warm", True)
    limit = float(numpy.quantile(numpy.abs(stress[:, :3].sum(axis=1)), 0.9))
    table.RescaleTransferFunction(-limit, limit)
    shown.LookupTable = table
    bounds = points.GetDataInformation().GetBounds()
    centre = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2]
    extent = max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
    look(view, (centre[0] + 0.9 * extent, centre[1] - 1.9 * extent, centre[2] + 0.9 * extent), centre, (0.0, 0.0, 1.0))


def main():
    """Makes the pictures."""
    data, folder = begin()
    size = [int(value) for value in sys.argv[3:5]] or [1200, 900]
    for name, draw in (("superquadrics", superquadrics), ("point_load", lambda view: point_load(view, data))):
        view = new_view(size)
        draw(view)
        save(view, folder, name, size)
    pv.Disconnect()


if __name__ == "__main__":
    main()
