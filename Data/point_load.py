#!/usr/bin/env python3
"""Writes the stress in a half space under a point load, a tensor field with eigenvalues of both signs.

    point_load.py FILE.vtk

Boussinesq's solution for an isotropic elastic half space z <= 0 with a downward force P at the origin (K. L. Johnson:
Contact Mechanics, Cambridge 1985, section 3.2), here with P = 1 and Poisson's ratio 0.3, on 11 x 11 x 6 points of a grid
that leaves the singular point out. Tension is positive. Components in VTK's order xx yy zz xy yz xz.
"""
import math
import struct
import sys

POISSON = 0.3


def stress(x, y, z):
    """Stress at depth z > 0 below the surface, z pointing down."""
    r2 = x * x + y * y
    rho = math.sqrt(r2 + z * z)
    k = 1.0 - 2.0 * POISSON
    a = 1.0 / (2.0 * math.pi)
    f = k / r2 if r2 > 0.0 else 0.0
    g = 1.0 - z / rho
    if r2 > 0.0:
        xx = a * (f * (g * (x * x - y * y) / r2 + z * y * y / rho**3) - 3.0 * z * x * x / rho**5)
        yy = a * (f * (g * (y * y - x * x) / r2 + z * x * x / rho**3) - 3.0 * z * y * y / rho**5)
        xy = a * (f * (g * 2.0 * x * y / r2 - x * y * z / rho**3) - 3.0 * x * y * z / rho**5)
    else:
        # On the axis: the limit of the above.
        xx = yy = a * k / (2.0 * z * z)
        xy = 0.0
    zz = -3.0 * a * z**3 / rho**5
    xz = -3.0 * a * x * z * z / rho**5
    yz = -3.0 * a * y * z * z / rho**5
    return xx, yy, zz, xy, yz, xz


def main(path):
    points, tensors = [], []
    for k in range(6):
        for j in range(11):
            for i in range(11):
                x, y, depth = (i - 5) / 2.0, (j - 5) / 2.0, 0.5 + k / 2.0
                xx, yy, zz, xy, yz, xz = stress(x, y, depth)
                points += [x, y, -depth]
                # The file's z points up: components with one z change sign.
                tensors += [xx, yy, zz, xy, -yz, -xz]
    count = len(points) // 3
    with open(path, "wb") as out:
        out.write(b"# vtk DataFile Version 3.0\nstress under a point load (point_load.py)\nBINARY\n")
        out.write(b"DATASET POLYDATA\nPOINTS %d float\n" % count)
        out.write(struct.pack(">%df" % len(points), *points))
        out.write(b"\nPOINT_DATA %d\nFIELD FieldData 1\nstress 6 %d float\n" % (count, count))
        out.write(struct.pack(">%df" % len(tensors), *tensors))
        out.write(b"\n")


if __name__ == "__main__":
    main(sys.argv[1])
