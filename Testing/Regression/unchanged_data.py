"""Properties that change nothing of the data build nothing: neither on the device nor on the host.

Usage: pvpython unchanged_data.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

COUNTERS = ("structureBuilds", "topLevelBuilds", "instanceUploads", "instanceBuilds")
POINTS = 2000


def changes(shown):
    """What has nothing to do with instances, each a name and a function."""
    def set_to(name, value):
        return "%s %s" % (name, value), lambda: setattr(shown, name, value)

    def again():
        shown.Opacity = 0.99999
        shown.Opacity = 1.0

    return [set_to("Pickable", 0), set_to("Pickable", 1), ("Opacity 1 again", again), set_to("Specular", 0.4),
            set_to("SpecularPower", 20.0), set_to("Ambient", 0.1), set_to("Exposure", 0.5), set_to("SamplesPerPixel", 2),
            set_to("OutlineWidth", 2.0), set_to("Illumination", "Uniform")]


def main():
    """Meshes, a table of meshes, and a shape that needs no mesh."""
    session.load()
    checks = Checks()
    points = session.source(session.poly_data(numpy.random.default_rng(1).uniform(-1.0, 1.0, (POINTS, 3))))
    table = pv.GroupDatasets(Input=[pv.Cone(Resolution=6), pv.Box()])
    for shape in ("Mesh", "Mesh table", "Box"):
        view = session.view(80, 60)
        shown = session.glyphs(points, view, shape.split()[0], Orient=0, ScaleFactor=0.05)
        if shape == "Mesh":
            shown.GlyphType = session.triangles(pv.Cone())
        elif shape == "Mesh table":
            shown.GlyphType, shown.UseGlyphTable, shown.UseCompositeGlyphTable = table, 1, 1
        session.look(view, (0.0, 0.0, 5.0))
        pv.Render(view)
        for name, change in changes(shown):
            before = session.statistics(shown)
            change()
            pv.Render(view)
            after = session.statistics(shown)
            for counter in COUNTERS:
                if counter in after:
                    checks.equal("%s, %s: %s" % (shape, name, counter), after[counter], before[counter])
        counted = session.statistics(shown)
        for counter in COUNTERS:
            checks.true("%s: RenderStatistics has no counter %s" % (shape, counter), counter in counted)
        shown.ScaleFactor = 0.02
        pv.Render(view)
        moved = session.statistics(shown)
        checks.true(shape + ", another size: instanceBuilds stays", moved.get("instanceBuilds", 0) > counted.get("instanceBuilds", 0))
        pv.Delete(view)
    checks.report()


if __name__ == "__main__":
    main()
