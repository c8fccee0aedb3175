#!/usr/bin/env python3
"""Writes orientation distribution functions of two bundles of fibers that cross, as spherical harmonics.

    odf.py FILE.vtk [SIDE]

SIDE x SIDE x SIDE / 4 voxels (default 16: 1,024; 36: 11,664) of size 1. One bundle follows an arc, the other one runs straight through it;
both fade out toward their edges into isotropic surroundings. In each voxel the diffusing molecules are a mixture of Gaussians, one for
each bundle with the tensor D of eigenvalues 1.7, 0.2 and 0.2 and one with 0.7 three times (1e-3 mm^2/s), as in the multi-tensor model. The
distribution of directions n of one Gaussian is (4 pi)^-1 |D|^(-1/2) (n^T D^-1 n)^(-3/2) (I. Aganj et al., "Reconstruction of the orientation
distribution function in single- and multiple-shell q-ball imaging within constant solid angle", Magnetic Resonance in Medicine 64(2), 2010),
whose integral over the sphere is 1. The sum is projected on real harmonics of even bands up to 8 by Gauss and trapezoid quadrature.

Arrays: odf (45 components, the basis MRtrix3 of the property GlyphHarmonicsBasis), fractions (of the arc, of the straight bundle).
"""
import math
import sys

import numpy

LMAX = 8
ALONG, ACROSS = 1.7, 0.2  # eigenvalues of the tensors


def harmonics(directions):
    """The basis at unit vectors, one row each: sqrt(2) K sin |m| phi, K, sqrt(2) K cos m phi, with the phase (-1)^m in K."""
    z = directions[:, 2]
    rho = numpy.sqrt(numpy.maximum(1.0 - z * z, 0.0))
    phi = numpy.arctan2(directions[:, 1], directions[:, 0])
    columns = []
    for l in range(0, LMAX + 1, 2):
        for m in range(-l, l + 1):
            order = abs(m)
            below, value = numpy.zeros_like(z), numpy.prod([-(2.0 * i - 1.0) for i in range(1, order + 1)]) * rho ** order
            for n in range(order + 1, l + 1):
                below, value = value, ((2 * n - 1) * z * value - (n + order - 1) * below) / (n - order)
            norm = math.sqrt((2 * l + 1) / (4.0 * math.pi) * math.factorial(l - order) / math.factorial(l + order))
            wave = math.sqrt(2.0) * (numpy.sin(order * phi) if m < 0 else numpy.cos(order * phi)) if m else 1.0
            columns.append(norm * value * wave)
    return numpy.stack(columns, axis=1)


def quadrature(rings=24):
    """Directions and weights that integrate harmonics of twice as many bands exactly."""
    z, weights = numpy.polynomial.legendre.leggauss(rings)
    phi = numpy.arange(2 * rings) * math.pi / rings
    rho = numpy.sqrt(1.0 - z * z)
    directions = numpy.stack([numpy.outer(rho, numpy.cos(phi)), numpy.outer(rho, numpy.sin(phi)),
                              numpy.outer(z, numpy.ones_like(phi))], axis=-1).reshape(-1, 3)
    return directions, numpy.repeat(weights, 2 * rings) * math.pi / rings


def bundle_distribution(axes, directions):
    """Of Gaussians along the axes, one row each, in all directions."""
    cosine = axes @ directions.T
    form = cosine ** 2 / ALONG + (1.0 - cosine ** 2) / ACROSS
    return form ** -1.5 / (4.0 * math.pi * math.sqrt(ALONG * ACROSS * ACROSS))


def field(side):
    """Centers of voxels, (coefficients, fractions)."""
    layers = max(1, side // 4)
    z, y, x = numpy.meshgrid(numpy.arange(layers), numpy.arange(side), numpy.arange(side), indexing="ij")
    points = numpy.stack([x, y, z], axis=-1).reshape(-1, 3).astype(float)
    at = points / max(1, side - 1)
    # The arc is a part of a ring about the corner (0, 0), the straight bundle runs along the diagonal and rises a little.
    radius = numpy.hypot(at[:, 0], at[:, 1])
    arc = numpy.stack([-at[:, 1], at[:, 0], numpy.zeros(len(at))], axis=1) / numpy.maximum(radius, 1e-9)[:, None]
    straight = numpy.tile(numpy.array([1.0, 1.0, 0.3]) / math.sqrt(2.09), (len(at), 1))
    fractions = numpy.stack([0.9 * numpy.exp(-((radius - 0.75) / 0.16) ** 4),
                             0.9 * numpy.exp(-((at[:, 0] - at[:, 1]) / 0.22) ** 4)], axis=1)
    fractions /= numpy.maximum(fractions.sum(axis=1) / 0.95, 1.0)[:, None]
    directions, weights = quadrature()
    basis = harmonics(directions)
    project = basis * weights[:, None]
    odf = numpy.zeros((len(points), basis.shape[1]))
    odf[:, 0] = (1.0 - fractions.sum(axis=1)) / math.sqrt(4.0 * math.pi)  # the free part: 1 / (4 pi) everywhere
    for part in range(0, len(points), 2000):
        rows = slice(part, part + 2000)
        for fraction, axes in zip(fractions.T, (arc, straight)):
            odf[rows] += fraction[rows, None] * (bundle_distribution(axes[rows], directions) @ project)
    return points, odf, fractions


def write(path, points, odf, fractions):
    """Legacy binary VTK: a vertex for each voxel."""
    count = len(points)
    with open(path, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\ncrossing bundles of fibres\nBINARY\nDATASET POLYDATA\n")
        file.write(b"POINTS %d float\n" % count + points.astype(">f4").tobytes())
        cells = numpy.stack([numpy.ones(count), numpy.arange(count)], axis=1)
        file.write(b"\nVERTICES %d %d\n" % (count, 2 * count) + cells.astype(">i4").tobytes())
        file.write(b"\nPOINT_DATA %d\nFIELD arrays 2\n" % count)
        for name, values in ((b"odf", odf), (b"fractions", fractions)):
            file.write(b"%s %d %d float\n" % (name, values.shape[1], count) + values.astype(">f4").tobytes() + b"\n")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    write(sys.argv[1], *field(int(sys.argv[2]) if len(sys.argv) == 3 else 16))


if __name__ == "__main__":
    main()
