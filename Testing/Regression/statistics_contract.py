"""What is redone when: each step redoes only what its input changed, proved by the counters of RenderStatistics.

Usage: pvpython statistics_contract.py
"""
import numpy
import paraview.simple as pv

import session

#: counters that may not move when only the camera moves
BUILDS = ("structureBuilds", "topLevelBuilds", "pipelineBuilds")
UPLOADS = ("instanceUploads", "colorUploads")


def cloud(seed):
    """500 points with a scalar."""
    points = numpy.random.default_rng(seed).uniform(-1.0, 1.0, (500, 3))
    return session.poly_data(points, scalar=points[:, 0])


def main():
    """Renders, changes one thing at a time, compares the counters."""
    session.load()
    view = session.view(200, 150)
    points = session.source(cloud(1))
    shown = session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=0.1)
    pv.ColorBy(shown, ("POINTS", "scalar"))
    table = pv.GetColorTransferFunction("scalar")
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    pv.Render(view)
    failures = []

    def step(what, change, unchanged=(), changed=()):
        before = session.statistics(shown)
        change()
        pv.Render(view)
        after = session.statistics(shown)
        moved = {key: (before[key], after[key]) for key in after if after[key] != before.get(key)}
        print("%s: %s" % (what, moved))
        for key in unchanged:
            if key not in after:
                failures.append("RenderStatistics has no counter " + key)
            elif after[key] != before[key]:
                failures.append("%s: %s went from %s to %s" % (what, key, before[key], after[key]))
        for key in changed:
            if after.get(key, 0) <= before.get(key, 0):
                failures.append("%s: %s stayed at %s" % (what, key, after.get(key)))

    def move_camera():
        session.look(view, (1.0, 0.5, 5.0))

    def change_table():
        table.ApplyPreset("Black-Body Radiation", True)

    def change_data():
        session.replace_data(points, cloud(2))

    def change_size():
        shown.ScaleFactor = 0.12

    step("camera", move_camera, BUILDS + UPLOADS, ("dispatches",))
    step("colour map", change_table, BUILDS + ("instanceUploads",), ("colorUploads",))
    step("same again", lambda: None, BUILDS + UPLOADS + ("dispatches", "primaryRays"))
    step("new data", change_data, ("pipelineBuilds",), ("structureBuilds", "instanceUploads"))
    step("glyph size", change_size, ("pipelineBuilds",), ("structureBuilds",))
    session.finish(failures)


if __name__ == "__main__":
    main()
