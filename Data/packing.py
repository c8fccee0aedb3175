#!/usr/bin/env python3
"""Writes a packing of superquadrics of random sizes, exponents and orientations, none of which touch.

    packing.py FILE.vtk [GLYPHS]

GLYPHS (default 1500) in a cube of side 1, by random sequential addition, large ones first: a place is drawn until the glyph's
bounding ball meets no other's. That ball is exact for exponents of 2.2 and more: with u = |x/A|^r and so on its radius squared is the
maximum of A^2 u^(2/r) + B^2 v^(2/s) + C^2 w^(2/t) over u + v + w = 1, a concave function whose multiplier is found by bisection.
Smaller exponents count as 2.2, which makes the glyph larger. The ratios of the lengths are in [0.5, 1], exponents in [0.4, 20], both
even on a logarithmic scale; seeded, so that the file is always the same. Arrays: exponents, lengths (full), quaternion (w, x, y, z).
"""
import math
import random
import struct
import sys

LARGEST, SMALLEST = 0.075, 0.012  # radii of the bounding balls
LEAST, MOST = 0.4, 20.0           # exponents
ROUNDEST = 2.2                    # smaller ones have no such maximum inside: they count as this one


def bounding_radius(half, exponents):
    """Radius of a ball about the center that holds the superquadric."""
    powers = [2.0 / max(e, ROUNDEST) for e in exponents]

    def shares(multiplier):
        # d/du A^2 u^p = multiplier
        return [(a * a * p / multiplier) ** (1.0 / (1.0 - p)) for a, p in zip(half, powers)]

    low, high = 1e-6, 1e6
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if sum(shares(middle)) > 1.0 else (low, middle)
    # The last factor is for the rounding of all this.
    return (1.0 + 1e-6) * math.sqrt(sum(a * a * min(u, 1.0) ** p for a, p, u in zip(half, powers, shares(low))))


def unit_quaternion(generator):
    """An orientation, all equally likely."""
    q = [generator.gauss(0.0, 1.0) for _ in range(4)]
    length = math.sqrt(sum(c * c for c in q))
    return [c / length for c in q]


def pack(count, seed=1):
    """Lists of (center, radius) and of (exponents, lengths, quaternion)."""
    generator = random.Random(seed)
    radii = sorted((LARGEST * (SMALLEST / LARGEST) ** generator.random() for _ in range(count)), reverse=True)
    cells = {}  # of side 2 LARGEST: what may touch lies in neighboring ones
    side = 2.0 * LARGEST
    placed, forms = [], []
    for radius in radii:
        for _ in range(10000):
            center = [radius + (1.0 - 2.0 * radius) * generator.random() for _ in range(3)]
            at = [int(c / side) for c in center]
            near = (other for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)
                    for other in cells.get((at[0] + i, at[1] + j, at[2] + k), ()))
            if all(math.dist(center, x) > radius + r for x, r in near):
                break
        else:
            raise SystemExit("There is no place for %d glyphs; %d have one. Ask for fewer." % (count, len(placed)))
        cells.setdefault(tuple(at), []).append((center, radius))
        placed.append((center, radius))
        half = [2.0 ** -generator.random() for _ in range(3)]
        exponents = [LEAST * (MOST / LEAST) ** generator.random() for _ in range(3)]
        scale = radius / bounding_radius(half, exponents)
        forms.append((exponents, [2.0 * scale * a for a in half], unit_quaternion(generator)))
    return placed, forms


def main(path, count=1500):
    placed, forms = pack(count)

    def numbers(rows):
        flat = [value for row in rows for value in row]
        return struct.pack(">%df" % len(flat), *flat) + b"\n"

    with open(path, "wb") as out:
        out.write(b"# vtk DataFile Version 3.0\nsuperquadrics that do not touch (packing.py)\nBINARY\nDATASET POLYDATA\n")
        out.write(b"POINTS %d float\n" % count + numbers(center for center, _ in placed))
        out.write(b"POINT_DATA %d\nFIELD FieldData 3\n" % count)
        for i, (name, components) in enumerate(((b"exponents", 3), (b"lengths", 3), (b"quaternion", 4))):
            out.write(b"%s %d %d float\n" % (name, components, count) + numbers(form[i] for form in forms))


if __name__ == "__main__":
    main(sys.argv[1], *(int(value) for value in sys.argv[2:3]))
