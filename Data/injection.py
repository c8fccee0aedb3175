#!/usr/bin/python3
"""Writes a time series of particles that are blown into a chamber: fast at the inlet, slowed down by drag inside.

Usage: injection.py FOLDER [STEPS [PARTICLES [CHAMBER-TRIANGLES]]]

FOLDER/injection_000.vtk, ... and FOLDER/injection.vtk.series: poly data of PARTICLES points (default 12,500), STEPS steps
(default 60) of DT, with the arrays velocity, acceleration (both exact at the step's time), age (since injection) and id; a
particle that leaves at the far end comes in again at the inlet under a new id. FOLDER/chamber.vtk: its wall, of about
CHAMBER-TRIANGLES triangles (default 6,000), cut open toward +y. Binary legacy files; the same on every machine up to
rounding (PCG64, fixed seed). The paper's Figure 5 shows such a scene (Zellmann et al., EGPGV 2020).

The chamber is a tube of radius 1 from x = 0 to LENGTH with an inlet tube of radius INLET in the middle of its front. A
particle of relaxation time TAU feels Stokes drag only: dv/dt = (u(x, t) - v) / TAU. The gas u is
- a turbulent round jet from the inlet: along the axis u0 min(1, 6.2 d / x), with a Gaussian profile of half width 0.1 x, as
  measured in free jets (Pope, Turbulent Flows, 2000, section 5.1), plus a slow uniform flow to the far end;
- turbulence-like eddies: MODES random Fourier modes, each solenoidal and of a frequency of its own, with amplitudes that
  fall with the wave number as k^(-5/6), so that the energy spectrum falls as k^(-5/3) (Kraichnan, Phys. Fluids 13, 1970),
  faded out toward the wall and the inlet.
Classical fourth-order Runge-Kutta with SUBSTEPS steps a time step; particles are reflected at the wall.
"""
import json
import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from lammps_to_vtk import write_vtk  # noqa: E402

LENGTH, INLET, INLET_LENGTH = 4.0, 0.08, 0.5
JET, DRIFT, EDDIES = 9.0, 0.25, 1.5  # speeds
TAU = 0.12
DT, SUBSTEPS = 0.02, 4
MODES = 48


class Flow:
    """The gas."""

    def __init__(self, generator):
        direction = generator.normal(size=(MODES, 3))
        direction /= numpy.linalg.norm(direction, axis=1)[:, None]
        wave_number = numpy.geomspace(1.5, 25.0, MODES)
        self.waves = direction * wave_number[:, None]
        amplitude = numpy.cross(direction, generator.normal(size=(MODES, 3)))
        amplitude *= (wave_number ** (-5.0 / 6.0) / numpy.linalg.norm(amplitude, axis=1))[:, None]
        self.amplitudes = amplitude * EDDIES / numpy.sqrt(0.5 * (amplitude ** 2).sum() / 3.0)
        self.frequencies = 1.5 * wave_number ** (2.0 / 3.0)
        self.phases = generator.uniform(0.0, 2.0 * numpy.pi, MODES)

    def velocity(self, x, t):
        """u at positions x (rows) and time t."""
        radius = numpy.hypot(x[:, 1], x[:, 2])
        along = numpy.maximum(x[:, 0], 0.0)
        core = numpy.minimum(1.0, 6.2 * 2.0 * INLET / numpy.maximum(along, 1e-9))
        width = 0.8 * INLET + 0.1 * along
        u = numpy.zeros_like(x)
        u[:, 0] = JET * core * numpy.exp(-numpy.log(2.0) * (radius / width) ** 2) + DRIFT
        fade = numpy.clip(1.0 - radius ** 4, 0.0, 1.0) * numpy.clip(along / 0.6, 0.0, 1.0)
        angle = x @ self.waves.T + (self.frequencies * t + self.phases)
        u += fade[:, None] * (numpy.cos(angle) @ self.amplitudes)
        return u

    def acceleration(self, x, v, t):
        """dv/dt of particles."""
        return (self.velocity(x, t) - v) / TAU


class Particles:
    """All particles and their way through time."""

    def __init__(self, count):
        self.generator = numpy.random.Generator(numpy.random.PCG64(5))
        self.flow = Flow(self.generator)
        self.x, self.v = numpy.zeros((count, 3)), numpy.zeros((count, 3))
        self.age = numpy.zeros(count)
        self.id = numpy.zeros(count, dtype=numpy.int32)
        self.next_id, self.time = 0, 0.0
        self.inject(numpy.arange(count))
        # Not all at once: each starts inside the inlet's supply, which reaches back over the time to fill the chamber.
        self.wait = self.generator.uniform(0.0, FILL, count)

    def inject(self, which):
        """Puts particles at the inlet's mouth, with a full-tube profile of speeds."""
        n = len(which)
        radius = INLET * 0.95 * numpy.sqrt(self.generator.uniform(size=n))
        angle = self.generator.uniform(0.0, 2.0 * numpy.pi, n)
        self.x[which] = numpy.stack([numpy.full(n, -INLET_LENGTH), radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=1)
        self.v[which] = 0.0
        self.v[which, 0] = 0.8 * JET * (1.0 - (radius / INLET) ** 2 * 0.5)
        self.age[which] = 0.0
        self.id[which] = self.next_id + numpy.arange(n)
        self.next_id += n

    def advance(self, dt):
        """One step of Runge-Kutta for those that are under way."""
        self.wait -= dt
        go = numpy.flatnonzero(self.wait <= 0.0)
        x, v, t, force = self.x[go], self.v[go], self.time, self.flow.acceleration
        a1 = force(x, v, t)
        v2 = v + 0.5 * dt * a1
        a2 = force(x + 0.5 * dt * v, v2, t + 0.5 * dt)
        v3 = v + 0.5 * dt * a2
        a3 = force(x + 0.5 * dt * v2, v3, t + 0.5 * dt)
        v4 = v + dt * a3
        a4 = force(x + dt * v3, v4, t + dt)
        x = x + dt / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4)
        v = v + dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)
        # At the wall: back inside, the outward part of the velocity turned round and halved. The inlet has a wall too.
        limit = numpy.where(x[:, 0] < 0.0, INLET, 1.0) * 0.99
        radius = numpy.hypot(x[:, 1], x[:, 2])
        out = numpy.flatnonzero(radius > limit)
        normal = x[out, 1:] / radius[out, None]
        x[out, 1:] = normal * (2.0 * limit[out] - radius[out])[:, None]
        outward = (v[out, 1:] * normal).sum(axis=1)
        v[out, 1:] -= 1.5 * numpy.maximum(outward, 0.0)[:, None] * normal
        self.x[go], self.v[go] = x, v
        self.age[go] += dt
        self.time += dt
        self.inject(numpy.flatnonzero(self.x[:, 0] > LENGTH))


#: Time in which the chamber fills before the first step.
FILL = 4.0


def chamber(triangles):
    """Points and triangles of the wall: inlet tube, front, tube; an angle of 110 degrees round +y is left open."""
    profile = [(-INLET_LENGTH, INLET), (0.0, INLET), (0.0, 1.0), (LENGTH, 1.0)]
    lengths = [numpy.hypot(b[0] - a[0], b[1] - a[1]) for a, b in zip(profile, profile[1:])]
    around = max(12, int(numpy.sqrt(triangles / 2.0)))
    rows = max(4, triangles // (2 * around))
    opening = numpy.radians(110.0)
    angles = numpy.pi / 2.0 + opening / 2.0 + (2.0 * numpy.pi - opening) * numpy.linspace(0.0, 1.0, around + 1)
    points, faces = [], []
    for (x0, r0), (x1, r1), length in zip(profile, profile[1:], lengths):
        part = max(1, int(round(rows * length / sum(lengths))))
        first = len(points)
        for s in numpy.linspace(0.0, 1.0, part + 1):
            x, r = x0 + s * (x1 - x0), r0 + s * (r1 - r0)
            points.extend((x, r * numpy.sin(a), r * numpy.cos(a)) for a in angles)
        for row in range(part):
            for column in range(around):
                a = first + row * (around + 1) + column
                b = a + around + 1
                faces.append((a, b, b + 1))
                faces.append((a, b + 1, a + 1))
    return numpy.array(points), numpy.array(faces)


def write_chamber(path, triangles):
    """Legacy binary poly data of triangles."""
    points, faces = chamber(triangles)
    with open(path, "wb") as out:
        out.write(("# vtk DataFile Version 3.0\nchamber\nBINARY\nDATASET POLYDATA\nPOINTS %d float\n" % len(points)).encode())
        out.write(points.astype(">f4").tobytes())
        out.write(("\nPOLYGONS %d %d\n" % (len(faces), 4 * len(faces))).encode())
        out.write(numpy.concatenate([numpy.full((len(faces), 1), 3), faces], axis=1).astype(">i4").tobytes())
        out.write(b"\n")
    return len(faces)


def main():
    """Writes the series."""
    folder = sys.argv[1]
    steps, count, triangles = [int(value) for value in sys.argv[2:5]] + [60, 12500, 6000][len(sys.argv[2:5]):]
    os.makedirs(folder, exist_ok=True)
    particles = Particles(count)
    while particles.time < FILL:
        particles.advance(DT / SUBSTEPS)
    files = []
    for step in range(steps):
        acceleration = particles.flow.acceleration(particles.x, particles.v, particles.time)
        name = "injection_%03d.vtk" % step
        write_vtk(os.path.join(folder, name), "injection", particles.x, {
            "velocity": particles.v, "acceleration": acceleration, "age": particles.age[:, None],
            "id": particles.id[:, None]})
        files.append({"name": name, "time": round(step * DT, 9)})
        for _ in range(SUBSTEPS):
            particles.advance(DT / SUBSTEPS)
    with open(os.path.join(folder, "injection.vtk.series"), "w", encoding="ascii") as out:
        json.dump({"file-series-version": "1.0", "files": files}, out, indent=0)
    speed = numpy.linalg.norm(particles.v, axis=1)
    print("%d steps of %d particles, speeds %.2f to %.2f; %d triangles" % (
        steps, count, speed.min(), speed.max(), write_chamber(os.path.join(folder, "chamber.vtk"), triangles)))


if __name__ == "__main__":
    main()
