"""Colors of surfaces and blocks: what ParaView's own surface shows of the same data.

Usage: pvpython surface_colors.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource

import comparison
import session
from checks import Checks

SURFACE = "Ray Traced Surface"


def coarse_sphere():
    """A sphere of few triangles with a scalar that differs much from corner to corner."""
    sphere = vtkSphereSource()
    sphere.SetRadius(1.0)
    sphere.SetThetaResolution(8)
    sphere.SetPhiResolution(8)
    sphere.Update()
    data = sphere.GetOutput()
    heights = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    session.add_arrays(data, height=heights[:, 2] + 0.5 * heights[:, 0])
    return session.source(data)


def interpolation(checks):
    """Scalars are interpolated before they are mapped, or their colors are, as the property says; by default the scalars."""
    view = session.view(240, 180)
    sphere = coarse_sphere()
    shown = pv.Show(sphere, view)
    shown.SamplesPerPixel = 1
    pv.ColorBy(shown, ("POINTS", "height"))
    shown.SetScalarBarVisibility(view, False)
    pv.GetColorTransferFunction("height").ApplyPreset("Rainbow Uniform", True)
    session.look(view, (2.0, 1.5, 4.0))
    pictures = {}
    for case in ("default", 1, 0, "1, without light", "0, without light"):
        if case != "default":
            shown.InterpolateScalarsBeforeMapping = int(str(case)[0])
            shown.Ambient, shown.Diffuse = (1.0, 0.0) if "without" in str(case) else (0.0, 1.0)
        for kind in ("Surface", SURFACE):
            shown.SetRepresentationType(kind)
            pv.Render(view)
            name = "surface-colors-%s-%s" % (kind.split()[0].lower(), str(case).replace(", ", "-").replace(" ", "-"))
            pictures[kind, case] = session.capture(view, name)
        ours, theirs = pictures[SURFACE, case], pictures["Surface", case]
        both = comparison.covered(ours) & comparison.covered(theirs)
        apart = numpy.abs(ours.astype(int) - theirs.astype(int)).max(axis=2)[both]
        share = float((apart > comparison.LEVELS).mean())
        what = "InterpolateScalarsBeforeMapping %s: %.2f%% of the covered pixels differ, at most by %d" % (case, 100 * share, apart.max())
        print(what)
        checks.true(what, share <= 0.01)
    checks.true("InterpolateScalarsBeforeMapping changes nothing in ParaView's own surface",
                comparison.difference(pictures["Surface", 1], pictures["Surface", 0])[0] > 0.01)
    pv.Delete(view)


def block_colors(checks):
    """vtkBlockColors gives each block the color that ParaView's own surface gives it, on surfaces and on glyphs."""
    blocks, points = vtkMultiBlockDataSet(), numpy.array([[-1.2, 0.0, 0.0], [-0.4, 0.0, 0.0], [0.4, 0.0, 0.0], [1.2, 0.0, 0.0]])
    for i, point in enumerate(points):
        block = session.poly_data(point[None] + [[0, 0, 0], [0.3, 0, 0], [0.3, 0.3, 0], [0, 0.3, 0]])
        cells = vtkCellArray()
        cells.InsertNextCell(4, [0, 1, 2, 3])
        block.SetPolys(cells)
        blocks.SetBlock(i, block)
    source = session.source(blocks)
    view = session.view(240, 90)
    shown = pv.Show(source, view)
    shown.SamplesPerPixel = 1
    shown.GlyphOrient, shown.GlyphScaleFactor = 0, 0.1
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=0.75)
    colors = {}
    for kind in ("Surface", SURFACE, session.REPRESENTATION):
        shown.SetRepresentationType(kind)
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        pv.ColorBy(shown, ("FIELD", "vtkBlockColors"))  # ParaView itself says here that it knows no range
        shown.SetScalarBarVisibility(view, False)
        checks.no_message("vtkBlockColors, " + kind, session.messages(lambda: pv.Render(view)))
        pixels = session.capture(view, "surface-colors-blocks-" + kind.lower().replace(" ", "-"))
        # Just inside of each square's lower left corner, where the first point's glyph is, too.
        colors[kind] = [tuple(int(c) for c in pixels[45 - 2, round(120 + x * 60) + 2, :3]) for x in points[:, 0]]
        print("vtkBlockColors, %s: %s" % (kind, colors[kind]))
    checks.equal("colors of the blocks on ParaView's surface", len(set(colors["Surface"]) - {session.BACKGROUND}), 4)
    for kind in (SURFACE, session.REPRESENTATION):
        checks.true("vtkBlockColors, %s: %s, not %s" % (kind, colors[kind], colors["Surface"]),
                    numpy.abs(numpy.array(colors[kind]) - colors["Surface"]).max() <= 2)
    pv.Delete(view)


def main():
    """Both parts."""
    session.load()
    checks = Checks()
    interpolation(checks)
    block_colors(checks)
    checks.report()


if __name__ == "__main__":
    main()
