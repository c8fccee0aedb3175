"""Many time steps of glyphs and of a surface, both blurred and both new in every step: nothing must be left over from any.

Usage: pvpython many_steps.py [STEPS]
"""
import sys

import numpy
import paraview.simple as pv

import session

POINTS = 400
SIDE = 10  # of the surface, in points


def sheet(generator):
    """A surface of 2 (SIDE - 1)^2 triangles, bent anew."""
    x, y = [axis.ravel() for axis in numpy.meshgrid(numpy.linspace(-1.0, 1.0, SIDE), numpy.linspace(-1.0, 1.0, SIDE))]
    points = numpy.stack([x, y, -1.0 + 0.1 * generator.uniform(size=x.size)], axis=1)
    data = session.poly_data(points, v=generator.uniform(-0.2, 0.2, points.shape))
    return session.with_cells(data, "Polys", [(at, at + 1, at + SIDE + 1, at + SIDE) for row in range(SIDE - 1)
                                              for at in range(row * SIDE, row * SIDE + SIDE - 1)])


def main():
    """Plays, and looks at the memory now and then."""
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    session.load()
    view = session.view(20, 16)
    generator = numpy.random.default_rng(5)

    def cloud(count):
        return session.poly_data(generator.uniform(-1.0, 1.0, (count, 3)), v=generator.uniform(-1.0, 1.0, (count, 3)),
                                 value=generator.uniform(size=count))

    points, surface = session.source(cloud(POINTS)), session.source(sheet(generator))
    shown = session.glyphs(points, view, Orient=0, ScaleFactor=0.05)
    pv.ColorBy(shown, ("POINTS", "value"))
    wall = pv.Show(surface, view)
    wall.SetRepresentationType("Ray Traced Surface")
    wall.SamplesPerPixel = 1
    for moves in (shown, wall):
        moves.MotionBlur, moves.VelocityArray, moves.ShutterTime = 1, "v", 0.1
    session.look(view, (0.0, 0.0, 6.0))
    settled, memory, heap, device = steps // 4, [], [], []
    for step in range(steps + 1):
        if step % settled == 0:
            memory.append(session.memory("VmRSS"))
            heap.append(session.allocated())
            device.append(session.statistics(shown).get("deviceBytes", 0))
        # Their number is another one each time, now and then it is none.
        session.replace_data(points, cloud(0 if step % 50 == 7 else POINTS - 5 * (step % 20)))
        session.replace_data(surface, sheet(generator))
        pv.Render(view)
    print("resident MB after each %d steps: %s" % (settled, ["%.1f" % (size / 2.0 ** 20) for size in memory]))
    print("heap MB in use: %s" % ["%.2f" % (size / 2.0 ** 20) for size in heap])
    print("device MB: %s" % ["%.2f" % (size / 2.0 ** 20) for size in device])
    statistics = session.statistics(shown)
    print("%d builds, %d uploads, %d pipelines" % (statistics["structureBuilds"], statistics["instanceUploads"],
                                                   statistics["pipelineBuilds"]))
    failures = []
    # The positions alone of the points that were shown since then, in float: half of that would be a leak of less than any
    # array of the glyphs in each step.
    allowed = 0.5 * (steps - settled) * 12 * POINTS
    for name, sizes in (("resident memory", memory), ("heap in use", heap)):
        grown = sizes[-1] - sizes[1]
        if grown > allowed:
            failures.append("%s grew by %.2f MB in %d steps; %.2f are allowed" % (
                name, grown / 2.0 ** 20, steps - settled, allowed / 2.0 ** 20))
    if device[-1] > 1.1 * device[1]:
        failures.append("the device's memory grew from %d to %d bytes" % (device[1], device[-1]))
    if statistics["instanceUploads"] < 1.9 * steps:
        failures.append("%d uploads in %d steps of two sets: the steps were not shown" % (statistics["instanceUploads"], steps))
    session.finish(failures)


if __name__ == "__main__":
    main()
