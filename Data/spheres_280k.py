#!/usr/bin/python3
"""Writes the speed scene: 280,000 spheres at random in a box, as in Table 1 of the paper on ray-traced glyphs.

Usage: spheres_280k.py FILE [COUNT]

FILE is legacy binary .vtk: points with the arrays radius (one value for all), velocity and id. The same numbers
come out on every machine (PCG64, fixed seed). At the default count and the camera below, at 1200x1200, 73% of the
pixels show a sphere; another COUNT keeps that fraction by keeping count * radius^2.
"""
import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from lammps_to_vtk import write_vtk  # noqa: E402

COUNT = 280000
SIDE = 100.0
#: Solves mean over the pixels of 1 - exp(-density * pi * radius^2 * path in the box) = 0.73.
RADIUS = 0.17769
#: Spheres that nearly touch, as in a packing of particles: 0.4 times the mean distance of neighbors.
PACKED_RADIUS = 0.4 * SIDE / COUNT ** (1.0 / 3.0)
#: The box's near face just fills a square view of ParaView's view angle of 30 degrees.
CAMERA = {
    "CameraPosition": [0.5 * SIDE, 0.5 * SIDE, SIDE + 186.6025],
    "CameraFocalPoint": [0.5 * SIDE] * 3,
    "CameraViewUp": [0.0, 1.0, 0.0],
    "CameraViewAngle": 30.0,
}


def radius(count=COUNT):
    """Radius that covers 73% of the pixels."""
    return RADIUS * (COUNT / count) ** 0.5


def spheres(count=COUNT):
    """Centers in the box [0, SIDE]^3 and velocities of length near 1, single precision."""
    generator = numpy.random.Generator(numpy.random.PCG64(20190923))
    centers = generator.random((count, 3)) * SIDE
    velocities = generator.normal(size=(count, 3)) / 3.0**0.5
    return centers.astype(numpy.float32), velocities.astype(numpy.float32)


def write(path, count=COUNT):
    """Writes the scene to path."""
    centers, velocities = spheres(count)
    arrays = {
        "id": numpy.arange(count, dtype=numpy.int32)[:, None],
        "radius": numpy.full((count, 1), radius(count), dtype=numpy.float32),
        "velocity": velocities,
    }
    write_vtk(path, "%d random spheres" % count, centers, arrays)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    write(sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else COUNT)
