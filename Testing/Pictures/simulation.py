"""Views, colors and scenes of the simulations that the scripts of the gallery share."""
import os
import sys

import paraview.simple as pv
from paraview.modules.vtkRemotingViews import vtkSMTransferFunctionPresets

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Regression"))
import session  # noqa: E402

REPRESENTATION = "Ray Traced Glyphs"
#: From pale gray, which leaves what is slow or weak in the background, over yellow and orange to dark red
EMBER = (0.0, 0.78, 0.79, 0.81, 0.3, 0.95, 0.78, 0.45, 0.6, 0.90, 0.42, 0.10, 1.0, 0.55, 0.04, 0.06)
#: From blue over green to red, none of them pale
RAINBOW = (0.0, 0.08, 0.30, 0.68, 0.3, 0.05, 0.55, 0.60, 0.6, 0.95, 0.70, 0.10, 1.0, 0.80, 0.10, 0.08)


def source(points, **arrays):
    """Points with arrays, by their names."""
    return session.source(session.poly_data(points, **arrays))


def new_view(size):
    """A render view on white."""
    view = pv.CreateView("RenderView")
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    return view


def look(view, position, focal_point, up):
    """Sets the camera."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = list(position), list(focal_point), list(up)


def show(source, view, shape, **properties):
    """Shows a source as ray-traced glyphs."""
    shown = pv.Show(source, view)
    shown.SetRepresentationType(REPRESENTATION)
    setattr(shown, "GlyphType" if shape in ("Sphere", "Box", "Cylinder", "Cone", "Arrow") else "GlyphShape", shape)
    for name, value in properties.items():
        owner, _, last = name.rpartition(".")  # such as GlyphType.TipRadius
        setattr(getattr(shown, owner) if owner else shown, last, value)
    return shown


def preset_name(name):
    """A preset of matplotlib's, under the name that it has in this ParaView: 'Viridis', or before 6 'Viridis (matplotlib)'."""
    old_name = name + " (matplotlib)"
    return old_name if vtkSMTransferFunctionPresets.GetInstance().HasPreset(old_name) else name


def number_format():
    """Format of a scalar bar's numbers, three digits at most: std::format's since ParaView 6.1, printf's before."""
    return "{:.3g}" if pv.GetParaViewVersion() >= (6, 1) else "%.3g"


def color(shown, view, array, component, limits, preset, title, place=(0.6, 0.84)):
    """Colors by an array's component, with a scalar bar whose lower left corner is at place (fractions of the view)."""
    pv.ColorBy(shown, ("POINTS", array, component), True)
    scalar_bar(pv.GetColorTransferFunction(array, shown, separate=True), shown, view, limits, preset, title, place)


def scalar_bar(table, shown, view, limits, preset, title, place):
    """Gives a color table its range and a preset, or colors at 0 to 1, and the view a bar of it whose lower left corner is at place (fractions of
    the view)."""
    if isinstance(preset, str):
        table.ApplyPreset(preset_name(preset), True)
    else:
        table.RGBPoints, table.ColorSpace = preset, "RGB"
    table.RescaleTransferFunction(*limits)
    shown.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.AddRangeLabels, bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 1, 0, number_format(), number_format()
    bar.WindowLocation, bar.Orientation = "Any Location", "Horizontal"
    bar.Position, bar.ScalarBarLength = list(place), 0.34


def spheres(impact, view):
    """The grains as spheres of their diameter, colored by speed."""
    shown = show(impact, view, "Sphere", Orient=0, SelectScaleArray="diameter",
                 ScaleMode="Magnitude", ScaleFactor=1.0)
    color(shown, view, "velocity", "Magnitude", (0.0, 8.0), EMBER, "speed")
    look(view, (9.0, -36.0, 27.0), (14.3, 14.0, 4.0), (0.0, 0.0, 1.0))


def arrows(impact, view):
    """The grains' velocities as arrows, colored by their upward part."""
    shown = show(impact, view, "Arrow", ArrowHeads="Fixed", Orient=1, SelectOrientationVectors="velocity",
                 OrientationMode="Direction", SelectScaleArray="velocity",
                 ScaleMode="Magnitude", ScaleFactor=0.3, ArrowReferenceMagnitude=2.0,
                 **{"GlyphType.ShaftRadius": 0.12, "GlyphType.TipRadius": 0.3, "GlyphType.TipLength": 0.8})
    color(shown, view, "velocity", "Z", (-5.0, 5.0), "Cool to Warm", "upward velocity", (0.6, 0.02))
    look(view, (9.0, -34.0, 22.0), (14.3, 14.0, 5.5), (0.0, 0.0, 1.0))


def ellipsoids(nematic, view):
    """The molecules as ellipsoids of their shape and orientation."""
    shown = show(nematic, view, "Sphere", Orient=1, SelectOrientationVectors="quaternion",
                 OrientationMode="Quaternion", SelectScaleArray="shape",
                 ScaleMode="Vector Components", ScaleFactor=1.0)
    color(shown, view, "velocity", "Magnitude", (0.0, 4.0), "Viridis", "speed")
    look(view, (31.0, 24.0, 49.0), (12.6, 11.6, 12.2), (0.0, 1.0, 0.0))


def begin():
    """Loads the plugin; (data, output folder) of the command line."""
    data, folder = sys.argv[1], sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    pv._DisableFirstRenderCameraReset()
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=vars(pv))
    return data, folder


def simulations(data):
    """The impact and the molecules of the data folder."""
    return (pv.OpenDataFile(os.path.join(data, "impact", "impact.vtk.series")),
            pv.OpenDataFile(os.path.join(data, "nematic", "nematic.vtk.series")))


def write(view, folder, name, size):
    """Writes the view's picture; its path."""
    path = os.path.join(folder, name + ".png")
    pv.SaveScreenshot(path, view, ImageResolution=size)
    print("wrote", path)
    sys.stdout.flush()
    return path


def save(view, folder, name, size):
    """Writes the view's picture and deletes the view."""
    write(view, folder, name, size)
    pv.Delete(view)
