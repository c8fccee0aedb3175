"""Python calls of the RayTracedGlyphs plugin. Load the plugin first: paraview.simple.LoadPlugin(...).

A display is the result of paraview.simple.Show(), here with the representation 'Ray Traced Glyphs', 'Ray Traced Surface' or 'Ray Traced Tubes'.
"""
import json
import os

import paraview.simple as pv

TYPES = ("Ray Traced Glyphs", "Ray Traced Surface", "Ray Traced Tubes")


def Displays(view=None):
    """The visible ray-traced displays of a view (default: the active one)."""
    view = view or pv.GetActiveView()
    return [display for display in view.Representations
            if display.GetProperty("Representation") is not None and display.Representation in TYPES and display.Visibility]


def _AnyDisplay(view):
    displays = Displays(view)
    if not displays:
        raise RuntimeError("The view shows nothing as 'Ray Traced Glyphs', 'Ray Traced Surface' or 'Ray Traced Tubes'; choose one of "
                           "them as the Representation of a display.")
    return displays[0]


def Statistics(view=None):
    """RenderStatistics of a view's image and of its first ray-traced display, as a dictionary."""
    return json.loads(_AnyDisplay(view).SMProxy.GetProperty("RenderStatistics").GetElement(0))


def SetSamplesPerRender(samples, view=None):
    """Each render adds so many samples per pixel until there are SamplesPerPixel, for scripts that watch an image refine.

    0 (default): all at once; -1: as many as take some hundredths of a second, as in ParaView's window.
    """
    display = _AnyDisplay(view).SMProxy
    display.GetProperty("SamplesPerRender").SetElement(0, samples)
    display.UpdateVTKObjects()


def SaveFeatureImage(fileName, view=None):
    """Renders the view with all samples and writes depth, normals, ids and other features of its ray-traced image.

    fileName: path of XML image data (.vti), written by the process that renders; with several ranks each writes a file, with
    -RANK before the extension. The data have one point per pixel, the lower left one first. Point arrays: Color (RGBA),
    WindowDepth, ViewDepth (world units), Normal (unit, world frame), Albedo (color without light), all means over the samples
    that hit and 0 where nothing was hit (WindowDepth: 1); Representation (number of the view's ray-traced display),
    OriginalId (its input's point, or a surface's or tube's cell; -1: nothing was hit) and CompositeIndex (its block), of the pixel's
    center; SampleCount.
    """
    display = _AnyDisplay(view).SMProxy
    asked = display.GetProperty("FeatureImageFile")
    asked.SetElement(0, fileName)
    display.UpdateProperty("FeatureImageFile", True)
    view = view or pv.GetActiveView()
    pv.Render(view)
    while Statistics(view)["RefinementProgress"] < 1.0:
        pv.Render(view)
    asked.SetElement(0, "")


def StopRefinement(view=None):
    """Stops the refinement of the view's image until something changes the image."""
    _AnyDisplay(view).SMProxy.InvokeCommand("StopRefinement")


def ExportGlyphs(fileName, view=None):
    """Writes the glyphs of a view as instances of meshes, for other programs.

    fileName: path of a .usda (Universal Scene Description: a PointInstancer for each display, with velocities where MotionBlur
    is on), .glb or .gltf (glTF 2.0 with EXT_mesh_gpu_instancing; a .gltf has a .bin beside it), written by the client. Colors
    are linear. Displays as 'Ray Traced Surface' are left out, as are superquadrics and tensor glyphs of more than 1000
    different shapes; messages say so.
    """
    if os.path.splitext(fileName)[1].lower() not in (".usda", ".glb", ".gltf"):
        raise ValueError("'%s' ends neither in .usda nor in .glb or .gltf; choose one of these." % fileName)
    _AnyDisplay(view)
    view = view or pv.GetActiveView()
    exporter = view.SMProxy.GetSessionProxyManager().NewProxy("exporters", "RayTracedGlyphsExporter")
    exporter.UnRegister(None)
    exporter.SetView(view.SMProxy)
    exporter.GetProperty("FileName").SetElement(0, fileName)
    exporter.UpdateVTKObjects()
    exporter.Write()


def Figure(source, kind="Sphere", fileName=None, colors=None, view=None, size=(1600, 1200), quality="Publication", logarithmic=False, **properties):
    """Shows a source as a figure for print: on white, filling the picture, with a RenderingQuality and a scalar bar. Returns the display.

    kind: a GlyphType or GlyphShape such as "Arrow" or "Tensor Ellipsoid", or "Surface" or "Tubes". fileName: path of a picture of
    that size, in pixels; None: no picture, so that camera and properties can be changed first. colors: name of the
    point or cell array that colors them; None: the array of a GlyphType's directions or sizes, if any; "": none, blue unless properties say else. view:
    None: a new one; its camera is kept in all others. quality: a RenderingQuality. logarithmic: of the colors. properties: of the
    display, such as OutlineWidth=1; a dot leads to one of a property: **{"GlyphType.TipRadius": 0.2}.
    """
    isNew = view is None
    if isNew:
        view = pv.CreateView("RenderView")
        view.ViewSize, view.OrientationAxesVisibility = list(size), 0
        view.UseColorPaletteForBackground, view.BackgroundColorMode = 0, "Single Color"
        view.Background = [1.0, 1.0, 1.0]
    source.UpdatePipeline(view.ViewTime)
    display = pv.Show(source, view)
    others = {"Surface": "Ray Traced Surface", "Tubes": "Ray Traced Tubes"}
    display.SetRepresentationType(others.get(kind, "Ray Traced Glyphs"))
    if kind not in others:
        isType = kind in display.GetProperty("GlyphType").Available
        setattr(display, "GlyphType" if isType else "GlyphShape", kind)
    if isNew:
        # ParaView renders when a camera is reset.
        _Assign(display, properties)
        display.RenderingQuality, display.SamplesPerPixel = "Fast", 1
        _LookFromAbove(view)
    display.RenderingQuality = quality
    display.AmbientColor = display.DiffuseColor = [0.42, 0.60, 0.78]  # white would be lost on white
    _Assign(display, properties)
    if colors is None and kind not in others and not (isType and display.GlyphDirectionColoring == "None"):
        colors = ""
    _Color(source, display, view, colors, logarithmic)
    if fileName:
        pv.SaveScreenshot(fileName, view, ImageResolution=list(size))
    return display


def _Assign(display, properties):
    """Sets properties of a display, and of those of its properties that are proxies."""
    for name, value in properties.items():
        owner, _, last = name.rpartition(".")
        setattr(getattr(display, owner) if owner else display, last, value)


def _LookFromAbove(view):
    """Looks at all data from the front, above and the right, z upwards."""
    pv.ResetCamera(view)
    view.CameraViewUp, focus = [0.0, 0.0, 1.0], list(view.CameraFocalPoint)
    distance = sum((a - b) ** 2 for a, b in zip(view.CameraPosition, focus)) ** 0.5
    view.CameraPosition = [f + distance * d for f, d in zip(focus, (0.45, -0.75, 0.48))]
    view.SMProxy.ResetCamera(True)  # the corners of the bounds fill nine tenths of the picture
    view.GetActiveCamera().Dolly(1.07)


def _Color(source, display, view, name, logarithmic):
    """Colors a display by an array, with a scalar bar beside the glyphs."""
    arrays = {array.Name: association for association, data in (("CELLS", source.CellData), ("POINTS", source.PointData)) for array in data}
    if name is None:
        asked = [("Orient", "SelectOrientationVectors"), ("Scaling", "SelectScaleArray")]
        chosen = [display.SMProxy.GetProperty(array).GetElement(0) for switch, array in asked if display.GetProperty(switch) and display.GetPropertyValue(switch)]
        name = next((array for array in chosen if array in arrays), "")
    if not name:
        display.ColorArrayName = [None, ""]
        return
    if name not in arrays:
        raise ValueError("There is no point or cell array '%s' to color by; colors=\"\" gives one color." % name)
    pv.ColorBy(display, (arrays[name], name))
    display.RescaleTransferFunctionToDataRange(False, True)
    table = pv.GetColorTransferFunction(name)
    if logarithmic:
        table.MapControlPointsToLogSpace()
        table.UseLogScale = 1
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(table, view)
    bar.Orientation, bar.WindowLocation, bar.AddRangeLabels = "Horizontal", "Lower Right Corner", 0
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize = bar.LabelFontSize = max(8, view.ViewSize[1] // 45)
