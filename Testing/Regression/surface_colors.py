"""Colors of surfaces and blocks: what ParaView's own surface shows of the same data.

Usage: pvpython surface_colors.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
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


def color_difference(ours, theirs):
    """(fraction of the pixels that differ, levels by which each does) of those that both pictures cover."""
    both = comparison.covered(ours) & comparison.covered(theirs)
    apart = numpy.abs(ours.astype(int) - theirs.astype(int)).max(axis=2)[both]
    return float((apart > comparison.LEVELS).mean()), apart


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
        share, apart = color_difference(ours, theirs)
        what = "InterpolateScalarsBeforeMapping %s: %.2f%% of the covered pixels differ, at most by %d" % (case, 100 * share, apart.max())
        print(what)
        checks.true(what, share <= 0.01)
    checks.true("InterpolateScalarsBeforeMapping changes nothing in ParaView's own surface",
                comparison.difference(pictures["Surface", 1], pictures["Surface", 0])[0] > 0.01)
    pv.Delete(view)


def ends_of_the_range(checks):
    """Where values leave the table's range within a cell, and where they are no numbers, linear and with logarithms."""
    view = session.view(240, 180)
    sphere = coarse_sphere()
    line = pv.Calculator(Input=pv.Line(Point1=(-1.5, 0, 0), Point2=(1.5, 0, 0), Resolution=1), Function="coordsX", ResultArrayName="height")
    tube = pv.Tube(Input=line, Radius=0.5, NumberofSides=64, Capping=1)
    tube.Scalars = ["POINTS", ""]  # else it turns off what was chosen
    table = pv.GetColorTransferFunction("height")
    table.ApplyPreset("Rainbow Uniform", True)
    table.UseBelowRangeColor, table.BelowRangeColor, table.UseAboveRangeColor, table.AboveRangeColor = 1, (1, 1, 1), 1, (0, 0, 0)
    session.look(view, (2.0, 1.5, 4.0))
    for what, pair in (("surface", ((sphere, "Surface"), (sphere, SURFACE))), ("tube", ((tube, "Surface"), (line, "Ray Traced Tubes")))):
        for case, ends, logarithm in (("narrow", (-0.3, 0.4), 0), ("logarithm", (0.1, 0.6), 1)):
            pictures = []
            for source, kind in pair:
                table.UseLogScale = 0  # ColorBy would take a range that has logarithms
                shown = pv.Show(source, view)
                shown.SetRepresentationType(kind)
                shown.SamplesPerPixel, shown.Ambient, shown.Diffuse = 1, 1.0, 0.0
                shown.TubeRadius, shown.TubeEnds = 0.5, "Flat"
                pv.ColorBy(shown, ("POINTS", "height"))
                shown.SetScalarBarVisibility(view, False)
                table.RescaleTransferFunction(*ends)
                table.UseLogScale = logarithm
                pv.Render(view)
                pictures.append(session.capture(view, "surface-colors-%s-%s-%s" % (what, case, kind.split()[0].lower())))
                pv.Hide(source, view)
            theirs, ours = pictures
            share, _ = color_difference(ours, theirs)
            text = "%s, %s range: %.2f%% of the covered pixels differ" % (what, case, 100 * share)
            print(text)
            checks.true(text, share <= 0.01)
    table.UseLogScale = table.UseBelowRangeColor = table.UseAboveRangeColor = 0
    pv.Delete(view)


def block_colors(checks):
    """vtkBlockColors gives each block the color that ParaView's own surface gives it, on surfaces and on glyphs."""
    blocks, points = vtkMultiBlockDataSet(), numpy.array([[-1.2, 0.0, 0.0], [-0.4, 0.0, 0.0], [0.4, 0.0, 0.0], [1.2, 0.0, 0.0]])
    for i, point in enumerate(points):
        block = session.poly_data(point[None] + [[0, 0, 0], [0.3, 0, 0], [0.3, 0.3, 0], [0, 0.3, 0]])
        blocks.SetBlock(i, session.with_cells(block, "Polys", [range(4)]))
    source = session.source(blocks)
    view = session.view(240, 90)
    shown = pv.Show(source, view)
    shown.SamplesPerPixel = 1
    shown.Orient, shown.ScaleFactor = 0, 0.1
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=0.75)
    colors = {}
    for kind in ("Surface", SURFACE, session.REPRESENTATION):
        shown.SetRepresentationType(kind)
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        pv.ColorBy(shown, ("FIELD", "vtkBlockColors"))  # ParaView itself warns here that it has no range
        shown.SetScalarBarVisibility(view, False)
        checks.no_message("vtkBlockColors, " + kind, session.messages(lambda: pv.Render(view)))
        offered = shown.SMProxy.GetProperty("ColorArrayName").GetDomain("array_list")
        own = [name for name in map(offered.GetString, range(offered.GetNumberOfStrings())) if name.startswith("vtkRayTraced_") or name == "From Previous Step"]
        checks.equal("arrays of the plugin among those to color by, " + kind, own, [])
        for distinct in (4, 2):
            shown.BlockColorsDistinctValues = distinct
            pixels = session.capture(view, "surface-colors-%d-blocks-%s" % (distinct, kind.lower().replace(" ", "-")))
            # Just inside of each square's lower left corner, where the first point's glyph is, too.
            colors[kind, distinct] = [tuple(int(c) for c in pixels[45 - 2, round(120 + x * 60) + 2, :3]) for x in points[:, 0]]
            print("%d of vtkBlockColors, %s: %s" % (distinct, kind, colors[kind, distinct]))
    for (kind, distinct), found in colors.items():
        checks.true("%d of vtkBlockColors, %s: %s, not %s" % (distinct, kind, found, colors["Surface", distinct]),
                    numpy.abs(numpy.array(found) - colors["Surface", distinct]).max() <= 2)
        checks.equal("%d colors of the blocks, %s" % (distinct, kind), len(set(found) - {session.BACKGROUND}), distinct)
    shown.BlockColorsDistinctValues = 0 # is out of range
    pv.Render(view)
    pv.Delete(view)


def partial_arrays(checks):
    """A block that lacks an array of numbers, categories, texts or colors, or field data, has the solid color; numbers that are none have that
    of the table.
    """
    blocks = vtkMultiBlockDataSet()
    for number in range(3):
        block = session.poly_data(numpy.array([[number - 1.2, -0.3, 0.0], [number - 0.8, -0.3, 0.0], [number - 1.0, 0.4, 0.0]]))
        session.with_cells(block, "Polys", [range(3)])
        if number != 1:
            texts = vtkStringArray()
            texts.SetName("text")
            for text in "abc" if number == 0 else "bca":
                texts.InsertNextValue(text)
            block.GetPointData().AddArray(texts)
            session.add_arrays(block, number=numpy.array([0.0, 1.0, 2.0 if number else numpy.nan]), kind=numpy.arange(3) + number,
                               bytes=numpy.full((3, 3), (200, 100, 50 * number), numpy.uint8))
            material = vtkDoubleArray()
            material.SetName("material")
            material.InsertNextValue(0.5 * number)
            block.GetFieldData().AddArray(material)
        blocks.SetBlock(number, block)
    source = session.source(blocks)
    view = session.view(240, 120)
    shown = pv.Show(source, view)
    shown.SamplesPerPixel, shown.Ambient, shown.Diffuse = 1, 1.0, 0.0
    shown.AmbientColor = shown.DiffuseColor = [0.0, 1.0, 0.0]
    shown.GlyphType, shown.ScaleFactor, shown.Orient = "Box", 0.2, 0
    shown.GlyphType, shown.ScaleFactor, shown.Scaling, shown.SelectScaleArray, shown.Orient = "Box", 0.2, 1, "None", 0
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=0.8)
    for array in ("number", "kind", "text", "bytes", "material"):
        pv.ColorBy(shown, ("FIELD" if array == "material" else "POINTS", array))
        shown.MapScalars = 0 if array == "bytes" else 1
        shown.SetScalarBarVisibility(view, False)
        table = pv.GetColorTransferFunction(array)
        table.NanColor = [1.0, 1.0, 0.0]
        if array == "kind":
            table.InterpretValuesAsCategories = table.AnnotationsInitialized = 1
            table.Annotations = [text for value in "01234" for text in (value, value)]
            table.IndexedColors = [1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0.5, 0.5, 0.5]
        elif array == "text":
            table.Annotations, table.IndexedColors = ["a", "a", "b", "b"], [1, 0, 0, 0, 0, 1]
        for pair in (("Surface", SURFACE), ("3D Glyphs", session.REPRESENTATION)):
            pictures = []
            for kind in pair:
                shown.SetRepresentationType(kind)
                checks.no_message("%s of some blocks, %s" % (array, kind), session.messages(lambda: pv.Render(view)))
                pv.Render(view)  # what 3D Glyphs show is cut off before
                pictures.append(session.capture(view, "surface-colors-partial-%s-%s" % (array, kind.lower().replace(" ", "-"))))
            if array == "material" and pair[0] == "3D Glyphs":
                found = [{tuple(color) for color in picture.reshape(-1, picture.shape[-1])} for picture in (surface, pictures[1])]
                checks.equal("%s of some blocks, %s: colors" % (array, pair[1]), found[1], found[0])  # 3D Glyphs ignores field data
                continue
            surface = pictures[0]
            # A triangle with a corner that is no number has its color whole, and ParaView's in part.
            share = comparison.difference(*pictures)[0]
            checks.true("%s of some blocks, %s: %.2f%% of the pixels differ" % (array, pair[1], 100 * share),
                        share <= (0.05 if (array, pair[0]) == ("number", "Surface") else 0.01))
            green = [(picture[..., :3] == (0, 255, 0)).all(axis=2).sum() for picture in pictures]
            checks.true("%s of some blocks, %s: pixels of the solid color: %s" % (array, pair[1], green), abs(green[1] - green[0]) <= 0.1 * green[0] > 0)
    pv.Delete(view)


def normals_as_colors(checks):
    """An array with the name that VTK gives to normals, in one of two blocks, keeps its values, smoothly shaded or not."""
    blocks = vtkMultiBlockDataSet()
    for number in range(2):
        sphere = vtkSphereSource()
        sphere.SetCenter(2.2 * number - 1.1, 0.0, 0.0)
        sphere.GenerateNormalsOff()
        sphere.Update()
        block = sphere.GetOutput()
        if number == 0:
            height = numpy.array([block.GetPoint(i)[1] for i in range(block.GetNumberOfPoints())])
            session.add_arrays(block, Normals=numpy.stack([height, -height, 0.0 * height], axis=1))
        blocks.SetBlock(number, block)
    source = session.source(blocks)
    view = session.view(240, 120)
    shown = pv.Show(source, view)
    shown.SamplesPerPixel, shown.Ambient, shown.Diffuse = 1, 1.0, 0.0
    pv.ColorBy(shown, ("POINTS", "Normals", "X"))
    shown.SetScalarBarVisibility(view, False)
    pv.GetColorTransferFunction("Normals").RescaleTransferFunction(-0.5, 0.5)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=0.8)
    for interpolation in ("Flat", "Gouraud"):
        shown.Interpolation = interpolation
        pictures = []
        for kind in ("Surface", SURFACE):
            shown.SetRepresentationType(kind)
            pv.Render(view)
            pictures.append(session.capture(view, "surface-colors-normals-%s-%s" % (interpolation.lower(), kind.split()[0].lower())))
        share, _ = color_difference(*pictures)
        checks.true("colored by Normals, %s: %.2f%% of the pixels differ" % (interpolation, 100 * share), share <= 0.01)
    pv.Delete(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    interpolation(checks)
    ends_of_the_range(checks)
    block_colors(checks)
    partial_arrays(checks)
    normals_as_colors(checks)
    checks.report()


if __name__ == "__main__":
    main()
