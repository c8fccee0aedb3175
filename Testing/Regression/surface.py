"""Ray-traced surfaces: as ParaView's own Surface shows them, in one scene with glyphs, with what is wrong said once.

Usage: pvpython surface.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.util.numpy_support import vtk_to_numpy

import comparison
import session

SURFACE = "Ray Traced Surface"
COLOR = (0.8, 0.5, 0.2)
FAILURES = []


def check(good, text):
    """Takes note of what is not as it must be."""
    if not good:
        FAILURES.append(text)


def color_at(pixels, x, y):
    """The RGB of one pixel, x and y from the upper left, as a tuple of int."""
    return tuple(int(channel) for channel in pixels[y, x, :3])


def show(source, view, kind, **properties):
    """Shows a source as a surface of this kind with one sample a pixel."""
    shown = pv.Show(source, view)
    shown.SetRepresentationType(kind)
    shown.SamplesPerPixel = 1
    for name, value in named(shown, properties).items():
        setattr(shown, name, value)
    return shown


def named(shown, properties):
    """The same properties, with the names that this ParaView has for them."""
    moved = "Position" if shown.SMProxy.GetProperty("Position") else "Translation"  # since ParaView 5.12
    return {moved if name == "Position" else name: value for name, value in properties.items()}


def sphere_data(radius=1.0, resolution=32, center=(0.0, 0.0, 0.0)):
    """A sphere with smooth normals and arrays of both kinds."""
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(center)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    data = vtkPolyData()
    data.ShallowCopy(source.GetOutput())
    points = vtk_to_numpy(data.GetPoints().GetData())
    session.add_arrays(data, height=points[:, 1].astype(float))
    faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    session.add_arrays(data, data.GetCellData(), stripes=numpy.floor(4.0 * points[faces].mean(axis=1)[:, 0]))
    return data


def color_nothing(shown, _view):
    session.solid(shown, COLOR)


def color_by(association, name):
    """A function that colors a representation with an array through a lookup table that is the same in all ParaViews."""
    def apply(shown, view):
        pv.ColorBy(shown, (association, name))
        session.cool_to_warm(name)
        shown.SetScalarBarVisibility(view, False)
    return apply


def like_paraview(view):
    """Same camera, lights and colors as ParaView's Surface: within the thresholds of the glyphs."""
    sphere = session.source(sphere_data())
    box = pv.Box(XLength=1.6, YLength=1.2, ZLength=1.4)
    wavelet = pv.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    cases = (
        ("sphere-smooth", sphere, {"Interpolation": "Gouraud"}, color_nothing),
        ("box", box, {"Interpolation": "Flat"}, color_nothing),
        ("sphere-points", sphere, {}, color_by("POINTS", "height")),
        ("sphere-cells", sphere, {}, color_by("CELLS", "stripes")),
        ("sphere-moved", sphere, {"Position": [0.3, 0.1, 0.0], "Scale": [1.2, 0.6, 1.0], "Orientation": [20.0, 0.0, 40.0]}, color_nothing),
        ("image", wavelet, {"Scale": [0.3, 0.3, 0.3]}, color_by("POINTS", "RTData")),
    )
    displays = {}
    for name, source, properties, coloring in cases:
        pictures = {}
        if source not in displays:
            displays[source] = session.Settings(show(source, view, SURFACE, Specular=0.4, SpecularPower=20.0))
        shown = displays[source].shown
        displays[source].set(named(shown, properties))
        shown.Visibility = 1
        coloring(shown, view)
        # ParaView computes no normals of an image; of the faces of a box the two must agree all the same.
        session.look(view, (2.0, 1.5, 5.0) if name == "image" else (1.5, 1.2, 4.0))
        for kind in (SURFACE, "Surface"):
            shown.SetRepresentationType(kind)
            pictures[kind] = session.capture(view, "surface-%s-%s" % (name, "ours" if kind == SURFACE else "paraview"))
            if kind == SURFACE:
                statistics = session.statistics(shown)
                check(statistics["primaryRays"] > 0, "%s: no ray has been traced" % name)
        shown.SetRepresentationType(SURFACE)
        shown.Visibility = 0
        FAILURES.extend(comparison.against_paraview(pictures[SURFACE], pictures["Surface"], "surface-" + name))
    for settings in displays.values():
        pv.Delete(settings.shown)


def with_glyphs(view):
    """Glyphs before, behind and inside of a surface: one scene, in which the nearer one is seen, through opacity too."""
    red, blue = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    plane = pv.Plane(Origin=[-2, -1, 0], Point1=[2, -1, 0], Point2=[-2, 1, 0])
    surface = show(plane, view, SURFACE)
    session.solid(surface, blue)
    points = session.source(session.poly_data(numpy.array([[-1.0, 0.0, 0.7], [0.0, 0.0, -0.7], [1.0, 0.0, 0.0]])))
    glyphs = session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=0.8)
    session.solid(glyphs, red)
    for shown in (surface, glyphs):
        shown.Ambient, shown.Diffuse = 1.0, 0.0
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    columns = {x: 200 + 100 * x for x in (-1, 0, 1)}  # 300 pixels are 3 units high
    pixels = session.capture(view, "surface-with-glyphs")
    for x, wanted in ((-1, (255, 0, 0)), (0, (0, 0, 255)), (1, (255, 0, 0))):
        found = color_at(pixels, columns[x], 150)
        check(found == wanted, "at %d there is color %s, not %s" % (x, found, wanted))
    check(comparison.covered(pixels)[150 - 95, 200] and not comparison.covered(pixels)[150 - 105, 200],
          "the plane's edge is not where it belongs")
    counted = session.statistics(glyphs)
    check(counted["glyphs"] == 3, "%s glyphs beside the surface" % counted["glyphs"])

    # A translucent surface: what is behind it shines through, as it does through ParaView's own.
    pictures = {}
    for kind in (SURFACE, "Surface"):
        surface.SetRepresentationType(kind)
        surface.Opacity = 0.5
        pictures[kind] = session.capture(view, "surface-translucent-" + ("ours" if kind == SURFACE else "paraview"))
    FAILURES.extend(comparison.against_paraview(pictures[SURFACE], pictures["Surface"], "surface-translucent"))
    mixed = color_at(pictures[SURFACE], 200, 150)
    check(abs(mixed[0] - 128) < 4 and abs(mixed[2] - 128) < 4, "a red sphere behind blue at opacity 0.5 is %s" % (mixed,))

    pv.Hide(plane, view)
    pixels = session.capture(view, "surface-hidden")
    check(color_at(pixels, 200, 150) == (255, 0, 0), "the hidden surface still hides a sphere")
    pv.Delete(surface)
    pv.Delete(glyphs)


def blocks(view):
    """A block that lacks the array has the color of what no array colors, as on ParaView's own surface; not that of what is no number."""
    data = vtkMultiBlockDataSet()
    for i, x in enumerate((-1.0, 0.0, 1.0)):
        part = sphere_data(0.4, 32, (x, 0.0, 0.0))
        if i == 1:
            part.GetPointData().RemoveArray("height")
        data.SetBlock(i, part)
    shown = show(session.source(data), view, SURFACE)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    pv.ColorBy(shown, ("POINTS", "height"))
    shown.SetScalarBarVisibility(view, False)
    pv.GetColorTransferFunction("height").NanColor = [1.0, 1.0, 0.0]
    shown.AmbientColor = shown.DiffuseColor = [0.0, 1.0, 1.0]
    for interpolated in (1, 0):
        shown.InterpolateScalarsBeforeMapping = interpolated
        found = color_at(session.capture(view, "surface-blocks"), 200, 150)
        check(found == (0, 255, 255), "a block without the array has %s" % (found,))
    pv.Delete(shown)


def only_colors(view):
    """A new color map sends colors and builds nothing; the same data again do nothing at all."""
    sphere = session.source(sphere_data())
    shown = show(sphere, view, SURFACE)
    pv.ColorBy(shown, ("POINTS", "height"))
    shown.SetScalarBarVisibility(view, False)
    session.look(view, (1.5, 1.2, 4.0))
    pv.Render(view)
    first = session.statistics(shown)
    pv.GetColorTransferFunction("height").ApplyPreset("Black-Body Radiation", True)
    pv.Render(view)
    second = session.statistics(shown)
    print("color map:", {key: (first[key], second[key]) for key in first if first[key] != second[key]})
    for key in ("structureBuilds", "instanceUploads"):
        check(first[key] == second[key], "new colors: %s went from %s to %s" % (key, first[key], second[key]))
    check(second["colorUploads"] == first["colorUploads"] + 1, "new colors have not been sent once")
    session.replace_data(sphere, sphere_data())
    pv.Render(view)
    third = session.statistics(shown)
    for key in ("structureBuilds", "instanceUploads", "colorUploads", "primaryRays"):
        check(second[key] == third[key], "same data: %s went from %s to %s" % (key, second[key], third[key]))
    session.replace_data(sphere, sphere_data(0.9))
    pv.Render(view)
    check(session.statistics(shown)["structureBuilds"] == third["structureBuilds"] + 1, "new data: no new structure")
    pv.Delete(shown)


def unused(view):
    """What Surface has and this lacks is named."""
    sphere = pv.Sphere()
    shown = show(sphere, view, SURFACE, BackfaceRepresentation="Cull Frontface")
    session.capture(view, "surface-texture")
    shown.Texture = pv.CreateTexture(session.output("surface-texture.png"))
    for set_, wanted in ((True, 2), (False, 0)):
        if not set_:
            shown.BackfaceRepresentation, shown.Texture = "Follow Frontface", None
        pv.Render(view)
        said = [sentence for sentence in session.statistics(shown)["choices"] if "no effect" in sentence]
        check(len(said) == wanted, "unused properties of Surface: %s" % said)
    pv.Delete(shown)


def picking(view):
    """A pixel names the cell of the data whose triangle is seen there."""
    quads = pv.Plane(XResolution=4, YResolution=3, Origin=[-2, -1.5, 0], Point1=[2, -1.5, 0], Point2=[-2, 1.5, 0])
    shown = show(quads, view, SURFACE)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    pv.Render(view)
    for cell, (x, y) in ((0, (50, 50)), (6, (250, 150)), (11, (398, 298))):
        ids = []
        representations, sources = vtkCollection(), vtkCollection()
        view.SMProxy.SelectSurfaceCells([x, y, x, y], representations, sources, 0)
        for i in range(sources.GetNumberOfItems()):
            selected = pv.servermanager._getPyProxy(sources.GetItemAsObject(i))
            check(selected.FieldType == "CELL", "%s is selected" % selected.FieldType)
            ids += list(selected.IDs)[1::2]
        print("picked at", x, y, ids)
        check(ids == [cell], "at %d, %d cells %s are picked, not %d" % (x, y, ids, cell))
    pv.Delete(shown)


def bad_input(view):
    """One clear message each, and the rest is shown."""
    line = vtkLineSource()
    line.Update()
    broken = sphere_data()
    vtk_to_numpy(broken.GetPoints().GetData())[40] = numpy.nan
    crooked = sphere_data()
    vtk_to_numpy(crooked.GetPointData().GetNormals())[:] = numpy.nan
    cases = (
        ("no polygons", line.GetOutput(), ("no polygons",), None, False),
        ("no points", vtkPolyData(), None, None, False),
        ("NaN position", broken, ("6 of 1920 triangles",), None, True),
        ("NaN normals", crooked, None, None, True),
        ("missing array", sphere_data(), ("nonesuch",), ["POINTS", "nonesuch"], True),
    )
    stage = session.Stage(view, SURFACE)
    for name, data, words, array, visible in cases:
        session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)

        def twice():
            session.solid(stage.show(data, SamplesPerPixel=1), COLOR)
            stage.settings.add({"ColorArrayName": array or [None, ""]})
            pv.Render(view)
            session.look(view, (0.0, 0.0, 5.001), parallel_scale=1.5)
            pv.Render(view)

        text = session.messages(twice)
        print("%s: %s" % (name, text.strip() or "no message"))
        count = text.count("ERR:") + text.count("ERROR:") + text.count("Warning:") + text.count("WARN")
        check(count == (1 if words else 0), "%s: %d messages" % (name, count))
        for word in words or ():
            check(word in text, "%s: the message does not speak of '%s'" % (name, word))
        pixels = session.capture(view, "surface-bad-" + name.replace(" ", "-"))
        check(comparison.covered(pixels)[150, 200] == visible, "%s: the surface is %s" % (name, "missing" if visible else "there"))
        stage.hide()
    stage.close()


def main():
    """All parts."""
    session.load()
    view = session.view()
    like_paraview(view)
    with_glyphs(view)
    blocks(view)
    only_colors(view)
    unused(view)
    picking(view)
    bad_input(view)
    session.finish(FAILURES)


if __name__ == "__main__":
    main()
