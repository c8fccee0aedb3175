#!/usr/bin/env python3
"""Writes a phantom of diffusion tensor imaging: a bundle of fibers along a helix in an isotropic surrounding.

    helix.py FILE.vtk [POINTS]

POINTS (default 24) per side of a cube [-1, 1]^3. The helix has radius R = 0.6 about the z axis and rises by p = 0.9 a turn. At
(rho, phi, z) its tangent is taken to be that of the helix at the same phi, t = (-sin phi, cos phi, p / 2 pi R) / |...|, and the
distance to it that in the plane across: d^2 = (rho - R)^2 + (dz cos psi)^2, where dz is the height above the nearest turn and
tan psi = p / 2 pi R. With the bundle's fraction w = 1 / (1 + exp((d - r) / s)), r = 0.18, s = 0.02, the tensor is

    D = w (l t t^T + q (I - t t^T)) + (1 - w) m I,    l = 1.7, q = 0.2, m = 0.7 (1e-3 mm^2/s)

so that the principal direction follows the helix, tensors are linear inside and balls outside. The numbers are typical of white and gray
matter (Pierpaoli, Jezzard, Basser, Barnett, Di Chiro: Diffusion tensor MR imaging of the human brain, Radiology 201, 1996); a helix
as the phantom is Teem's idea (tend helix), the formulas are our own. Arrays: diffusion (xx yy zz xy yz xz), bundle (w).
"""
import math
import struct
import sys

RADIUS, PITCH, THICKNESS, EDGE = 0.6, 0.9, 0.18, 0.02
ALONG, ACROSS, AROUND = 1.7, 0.2, 0.7


def tensor(x, y, z):
    """(xx yy zz xy yz xz) and the bundle's fraction at a point."""
    rho, phi = math.hypot(x, y), math.atan2(y, x)
    slope = PITCH / (2.0 * math.pi * RADIUS)
    cosine = 1.0 / math.hypot(1.0, slope)
    t = (-math.sin(phi) * cosine, math.cos(phi) * cosine, slope * cosine)
    above = z / PITCH - phi / (2.0 * math.pi)
    height = (above - round(above)) * PITCH
    distance = math.hypot(rho - RADIUS, height * cosine)
    w = 1.0 / (1.0 + math.exp((distance - THICKNESS) / EDGE))
    ball = w * ACROSS + (1.0 - w) * AROUND
    line = w * (ALONG - ACROSS)
    xx, yy, zz = (ball + line * c * c for c in t)
    return (xx, yy, zz, line * t[0] * t[1], line * t[1] * t[2], line * t[0] * t[2]), w


def main(path, count=24):
    step = 2.0 / (count - 1)
    tensors, shares = [], []
    for k in range(count):
        for j in range(count):
            for i in range(count):
                components, share = tensor(i * step - 1.0, j * step - 1.0, k * step - 1.0)
                tensors += components
                shares.append(share)
    with open(path, "wb") as out:
        out.write(b"# vtk DataFile Version 3.0\nfibres along a helix (helix.py)\nBINARY\nDATASET STRUCTURED_POINTS\n")
        out.write(b"DIMENSIONS %d %d %d\nORIGIN -1 -1 -1\nSPACING %r %r %r\n" % (count, count, count, step, step, step))
        out.write(b"POINT_DATA %d\nFIELD FieldData 2\ndiffusion 6 %d float\n" % (count**3, count**3))
        out.write(struct.pack(">%df" % len(tensors), *tensors))
        out.write(b"\nbundle 1 %d float\n" % count**3)
        out.write(struct.pack(">%df" % len(shares), *shares))
        out.write(b"\n")


if __name__ == "__main__":
    main(sys.argv[1], *(int(value) for value in sys.argv[2:3]))
