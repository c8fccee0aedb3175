"""Runs inside ParaView's window: open data, apply, choose the representation and shapes, compare with the baseline.

Usage: RTGLYPHS_DATA=DIR paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=gui.py
Prints GUI TEST PASSED as its last line; the pictures are compared by this very process.
"""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import numpy  # noqa: E402
import paraview.simple as pv  # noqa: E402
from paraview import smtrace  # noqa: E402

import comparison  # noqa: E402
import session  # noqa: E402
from window import Window, run, say  # noqa: E402

SHAPES = ("Sphere", "Box", "Cylinder", "Capsule", "Cone", "Arrow")
#: sections of the panel with the plugin's rows, in their order, and labels that the panel gives to rows of 3D Glyphs
SECTIONS = ["Glyph Parameters", "Ray Traced Object", "Motion", "Ray Traced Image (Whole View)"]
RELABELED = ["Size By", "Direction By"]
#: labels of the default rows of shapes; and how many rows there are with the advanced ones
FIRST, LAST = ["Other Shape", "Location", "Masking"], ["Motion Blur", "Quality"]
SIZE, DIRECTION = ["Scale Factor", "Size By"], ["Direction By"]
TENSOR, COLORED, BY_DIRECTION = ["Tensor Array", "Tensor Components"], ["Color Glyphs By"], ["Color By Direction"]
DEFAULT_ROWS = {
    "Sphere": (SIZE + ["Glyph Type"] + FIRST + LAST, 25), "Arrow": (DIRECTION + SIZE + ["Glyph Type"] + FIRST + BY_DIRECTION + LAST, 30),
    **{shape: (DIRECTION + SIZE + ["Glyph Type"] + FIRST + BY_DIRECTION + LAST, 29) for shape in ("Box", "Cylinder", "Cone")}, "Capsule": (DIRECTION + SIZE + FIRST + BY_DIRECTION + LAST, 26),
    "Split Vector": (DIRECTION + SIZE[:1] + FIRST + BY_DIRECTION + LAST, 19),
    **{shape: (DIRECTION + SIZE[:1] + FIRST + TENSOR + ["Confidence"] + BY_DIRECTION + LAST, 22) for shape in ("Uncertain Vector", "Uncertain Direction")},
    "Confidence Ellipsoid": (SIZE + FIRST + TENSOR + ["Confidence"] + COLORED + BY_DIRECTION + LAST, 25),
    "Superquadric": (DIRECTION + SIZE + FIRST + ["Exponents"] + BY_DIRECTION + LAST, 28), "Nested Superquadric": (DIRECTION + SIZE + FIRST + ["Exponents"] + BY_DIRECTION + LAST, 28),
    "Tensor Ellipsoid": (SIZE + FIRST + TENSOR + COLORED + BY_DIRECTION + LAST, 26), "Tensor Superquadric": (SIZE + FIRST + TENSOR + COLORED + BY_DIRECTION + LAST, 27),
    "Signed Tensor Superquadric": (SIZE + FIRST + TENSOR + COLORED + BY_DIRECTION + LAST, 27), "Principal Axes": (SIZE + FIRST + TENSOR + COLORED + BY_DIRECTION + LAST, 25),
    "Spherical Harmonics": (DIRECTION + SIZE + FIRST + ["Harmonics Array", "Harmonics Basis"] + COLORED + BY_DIRECTION + LAST, 28),
    "Normal Stress": (DIRECTION + SIZE + FIRST + TENSOR + COLORED + BY_DIRECTION + LAST, 28), "Fourth-Order Tensor": (DIRECTION + SIZE + FIRST + ["Tensor Array"] + COLORED + BY_DIRECTION + LAST, 27)}
#: beginnings of tool tips
TIPS = {"SelectScaleArray": "Array that scales", "SelectOrientationVectors": "Array that rotates"}
#: no more than so many
MOST_ROWS, MOST_OF_SPHERES = 14, 8

#: what is set by a script to be copied, saved and restored by the panel's buttons; no default among it
SET = {"GlyphShape": "Capsule", "MotionBlur": 1, "ScaleMode": "Magnitude", "GlyphScaleFunction": "Square Root", "GlyphTensorSharpness": 1.5, "ShutterOpening": "Forward"}


def main():
    """Opens the simulation and goes through the shapes."""
    failures = []
    pv._DisableFirstRenderCameraReset()
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.GetLayout().PreviewMode = [300, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [channel / 255.0 for channel in session.BACKGROUND]
    reader = pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact.vtk.series")
    shown = pv.Show(reader, view)
    if session.REPRESENTATION not in list(shown.GetProperty("RepresentationTypesInfo")):
        failures.append("'%s' is not among the representations" % session.REPRESENTATION)
    shown.SetRepresentationType(session.REPRESENTATION)
    shown.SamplesPerPixel, shown.Orient = 2, 0
    session.look(view, (10.0, -22.0, 20.0), (14.0, 13.0, 3.0), (0.0, 0.0, 1.0))
    pv.GetAnimationScene().AnimationTime = 0.8
    shown.ArrowHeads = "Fixed"
    failures += at_once(view, shown)
    for shape in SHAPES:
        session.assign_shape(shown, shape)
        shown.ScaleMode, shown.ScaleFactor = "No Data Scaling Off", 0.9
        pv.Render(view)
        pixels = session.capture(view, "gui-" + shape, ImageResolution=[300, 200])
        failures += comparison.against_baseline(pixels, "gui-" + shape)
    window = Window()
    pv.GetLayout().PreviewMode = [0, 0]  # the picture fills the window
    failures += reset(window, view, reader, shown)
    pv.GetLayout().PreviewMode = [300, 200]
    failures += panel(window, view, reader, shown)
    failures += clicked(window, view, shown)
    failures += parts(window, view, reader, shown)
    failures += sized(window, view, reader, shown)
    failures += buttons(window, view, reader, shown)
    failures += bar_of_tensors(view)
    failures += molecule(window, view)
    for source in pv.GetSources().values():
        pv.Delete(source)
    failures += surfaces(window, view)
    return failures


def molecule(window, view):
    """Atoms are ray traced when the panel's list says so, with radii of their elements, and without ParaView's rows, which have no effect on them."""
    with open(session.output("gui-molecule.xyz"), "w", encoding="ascii") as file:
        file.write("2\n\nO 0 0 0\nH 0.96 0 0\n")
    source = pv.XYZReader(FileName=file.name)
    shown = pv.Show(source, view)
    pv.SetActiveSource(source)
    failures = []
    for representation in ("Ray Traced Glyphs", "Molecule"):
        window.wait(lambda: window.choose("displayRepresentation/comboBox", representation), 5)
        rows = ("Scale Factor", ) if representation == "Ray Traced Glyphs" else ("Preset", )
        if not window.wait(lambda: [label for label in window.labels("propertiesPanel") if label in ("Preset", "Scale Factor")] == list(rows), 5):
            failures.append("the panel of a molecule shows for %s: %s" % (representation, window.labels("propertiesPanel")))
    found = [shown.SMProxy.GetProperty(name).GetElement(0) for name in ("SelectScaleArray", "ScaleFactor")]
    if found != ["Van der Waals radii of Atomic Numbers", 2.0]:
        failures.append("atoms have the sizes %s" % found)
    pv.Delete(source)
    return failures


def at_once(view, shown):
    """A display made anew is colored by what it shows, with a scalar bar, until another color is chosen."""
    pv.Render(view)
    table = pv.GetColorTransferFunction("velocity")
    found = (shown.ColorArrayName.GetArrayName(), bool(pv.GetScalarBar(table, view).Visibility), json.loads(shown.GetPropertyValue("RenderStatistics"))["choices"])
    pv.ColorBy(shown, None)
    pv.HideScalarBarIfNotNeeded(table, view)
    shown.GlyphType = "Sphere"
    pv.Render(view)
    after = (shown.ColorArrayName.GetArrayName(), shown.ColorFromData)
    wanted = ("velocity", True, ["Color by velocity: what the glyphs show"])
    return [] if found == wanted and after == ("", 0) else ["colored at once by %s, not %s; after ColorBy None by %s" % (found, wanted, after)]


def bar_of_tensors(view):
    """The scalar bar of glyphs that a number of their tensors colors stays when other glyphs choose their colors."""
    points = numpy.array([[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]])
    tensors = session.glyphs(session.source(session.poly_data(points, stress=numpy.array([[1.0, 2.0, 3.0, 0.0, 0.0, 0.0]] * 2))), view,
                             "Tensor Ellipsoid", GlyphTensorArray="stress", GlyphTensorColoring="Trace")
    pv.Render(view)
    bar = pv.GetScalarBar(tensors.GlyphTensorLookupTable, view)
    before = bar.Visibility
    vectors = pv.Show(session.source(session.poly_data(points + 1.0, velocity=numpy.array([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]))), view)
    vectors.SetRepresentationType(session.REPRESENTATION)
    pv.Render(view)
    found = before, vectors.ColorArrayName.GetArrayName(), bar.Visibility
    for display in (tensors, vectors):
        pv.Delete(display)
    return [] if found == (1, "velocity", 1) else ["the bar of tensors before and after other glyphs are colored: %s" % (found,)]


def own_rows(window, shown):
    """Labels of the plugin's rows that the panel shows, in its sections."""
    proxy = shown.SMProxy
    groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
    own = {group.GetProperty(i).GetXMLLabel() for group in groups if group.GetXMLLabel() in SECTIONS for i in range(group.GetNumberOfProperties())}
    labels = window.labels("propertiesPanel")
    begin, end = (labels.index(name) if name in labels else len(labels) for name in (SECTIONS[0], "View (Render View)"))
    return [label for label in labels[begin:end] if label in own or label in RELABELED]


def panel(window, view, reader, shown):
    """For each shape the panel shows the rows that have an effect, few by default, none twice or cut off; sections stand in the order of use."""
    failures = []
    window.resize("pqClientMainWindow", 1500, 1100)
    pv.SetActiveSource(reader)
    shown.Visibility = 0  # the panel shows it all the same, and no program is compiled for each shape
    for advanced in (False, True):
        if advanced:
            window.click("SearchBox/AdvancedButton")
        for shape, (wanted, number) in DEFAULT_ROWS.items():
            session.assign_shape(shown, shape)
            pv.Render(view)
            found = []
            done = window.wait(lambda: found.clear() or found.extend(own_rows(window, shown)) or (len(found) == number if advanced else found == wanted), 5)
            say("%-28s %s: %2d rows" % (shape, "advanced" if advanced else "default ", len(found)))
            if not done:
                failures.append("the panel shows for %s %d rows: %s, not %s" % (shape, len(found), found, number if advanced else wanted))
            if not advanced and len(found) > (MOST_OF_SPHERES if shape == "Sphere" else MOST_ROWS):
                failures.append("%s: %d rows by default" % (shape, len(found)))
            cut = []
            window.wait(lambda: cut.clear() or cut.extend(label for label in window.labels("propertiesPanel", cut=True) if label in found) or not cut, 2)
            if cut or len(set(found)) < len(found):
                failures.append("%s: labels that are cut off: %s, or twice among %s" % (shape, cut, found))
            window.picture("DisplayFrame", session.output("gui-panel-%s%s.png" % (shape.replace(" ", "-"), "-advanced" if advanced else "")))
    tips = {name: window.tip(name) for name in TIPS}
    failures += ["tool tip of %s: '%s'" % (name, tips[name]) for name, words in TIPS.items() if words not in tips[name]]
    window.click("SearchBox/AdvancedButton")
    failures += colored(window, view, shown)
    for cut in ("Plane", "None"):
        if not window.wait(lambda: window.choose("Section/ComboBox", cut), 10) or not window.wait(lambda: str(shown.Section).strip("'") == cut, 5):
            failures.append("Cut By %s: %s" % (cut, shown.Section))
    sections = [label for label in window.labels("propertiesPanel") if label in SECTIONS]
    if sections != SECTIONS:
        failures.append("the panel's sections are %s" % sections)
    shown.SetRepresentationType("Ray Traced Tubes")
    tubes = ["Ray Traced Object", "Tube Radius", "Radius By", "Color By Direction", "Motion", "Motion Blur", "Ray Traced Image (Whole View)", "Quality"]
    if not window.wait(lambda: [label for label in window.labels("propertiesPanel") if label in tubes] == tubes, 5):
        failures.append("the panel of tubes shows %s" % window.labels("propertiesPanel"))
    shown.SetRepresentationType("Surface")
    if not window.wait(lambda: not {"Statistics", *SECTIONS[1:]} & set(window.labels("propertiesPanel")), 5):
        failures.append("the panel of an ordinary surface shows %s" % window.labels("propertiesPanel"))
    shown.SetRepresentationType(session.REPRESENTATION)
    shown.Visibility = 1
    return failures


def shows(window, label, seen, what):
    """The panel has this row or section where it is wanted, and not elsewhere."""
    done = window.wait(lambda: (label in window.labels("propertiesPanel")) == seen, 5)
    return [] if done else ["%s: %s is %s" % (what, label, "hidden" if seen else "shown")]


def colored(window, view, shown):
    """ParaView's section Coloring is shown where it says the truth; numbers can be chosen for shapes that show them."""
    failures = []
    for shape, refused, taken in (("Tensor Ellipsoid", "Radius", "Trace"), ("Normal Stress", "Trace", "Radius")):
        shown.GlyphShape, shown.GlyphTensorColoring = shape, "None"
        pv.Render(view)
        refuses = window.wait(lambda: window.visible("GlyphTensorColoring/ComboBox"), 5) and not window.choose("GlyphTensorColoring/ComboBox", refused)
        if not refuses or not window.choose("GlyphTensorColoring/ComboBox", taken) or not window.wait(lambda: str(shown.GlyphTensorColoring).strip("'") == taken, 5):
            failures.append("Color Glyphs By of %s takes %s, or not %s: %s" % (shape, refused, taken, shown.GlyphTensorColoring))
    shown.GlyphShape = "Tensor Superquadric"
    for coloring, seen in (("Trace", False), ("None", True)):
        shown.GlyphTensorColoring = coloring
        pv.Render(view)
        failures += shows(window, "Coloring", seen, "GlyphTensorColoring %s" % coloring)
    return failures


def sized(window, view, reader, shown):
    """Size By sets array and mode, and says None while a mode leaves the array unused; split vectors are those of Direction By; the order of
    components can be chosen where there are several."""
    failures = []
    session.assign_shape(shown, "Sphere")
    shown.ScaleMode = "No Data Scaling Off"
    for choice, wanted in (("diameter", ("Magnitude", "diameter")), ("None", ("No Data Scaling Off", "diameter"))):
        chosen = window.wait(lambda: window.choose("SelectScaleArray/ComboBox", choice), 10)
        if not chosen or not window.wait(lambda: (str(shown.ScaleMode).strip("'"), str(shown.SelectScaleArray).strip("'")) == wanted, 5):
            failures.append("Size By %s: %s, %s" % (choice, shown.ScaleMode, shown.SelectScaleArray))
    shown.Scaling = 0
    if not window.wait(lambda: window.choose("SelectScaleArray/ComboBox", "None"), 10) or window.wait(lambda: shown.Scaling, 1):
        failures.append("Size By None: Scaling is switched on")
    shown.Scaling = 1
    shown.GlyphShape = "Split Vector"
    for choice in ("None", "velocity"):
        chosen = window.wait(lambda: window.choose("SelectOrientationVectors/ComboBox", choice), 10)
        if not chosen or not window.wait(lambda: str(shown.SelectOrientationVectors).strip("'") == choice, 5):
            failures.append("Direction By %s of Split Vector: %s" % (choice, shown.SelectOrientationVectors))
    columns = session.source(session.poly_data(
        numpy.eye(3), six=numpy.ones((3, 6)), nine=numpy.ones((3, 9)), **{name + axis: numpy.ones(3) for name in "fv" for axis in "xyz"}))
    joined = session.glyphs(columns, view, "Arrow")
    pv.SetActiveSource(columns)
    for choice in ("fx, fy, fz", "vx, vy, vz"):
        chosen = window.wait(lambda: window.choose("SelectOrientationVectors/ComboBox", choice), 10)
        if not chosen or not window.wait(lambda: str(joined.SelectOrientationVectors).strip("'") == choice, 5):
            failures.append("Direction By %s of columns: %s" % (choice, joined.SelectOrientationVectors))
    joined.GlyphShape = "Tensor Ellipsoid"
    for array, ordered in (("six", True), ("nine", False)):
        joined.GlyphTensorArray = array
        pv.Render(view)
        failures += shows(window, "Tensor Components", ordered, "GlyphTensorArray %s" % array)
    pv.Delete(joined)
    pv.Delete(columns)
    pv.SetActiveSource(reader)
    return failures


def buttons(window, view, reader, shown):
    """A tick in the panel can be undone and redone; what is set is copied, pasted, and saved as default by the panel's buttons, and
    restored to what a first display has."""
    failures = []

    def values(display):
        return {name: str(display.GetPropertyValue(name)).strip("'") for name in SET}

    def show(source):
        display = pv.Show(source, view)
        display.SetRepresentationType(session.REPRESENTATION)
        pv.Render(view)
        return display

    def activate(source, name):
        """The panel shows this one, and no other one any more."""
        pv.RenameSource(name, source)
        pv.SetActiveSource(None) # ParaView 6 shows the new name of what is active once it is chosen anew
        pv.SetActiveSource(source)
        titles = ("Properties (%s)" % name, "Properties ('%s' / " % name) # of ParaView 5 and 6
        if not window.wait(lambda: any(label.startswith(titles) for label in window.labels("propertiesPanel")), 20):
            failures.append("the panel does not show %s" % name)

    def done(what, action, display, wanted):
        """The action is possible, and the display soon has the values."""
        possible = window.wait(action, 20)
        if not possible or not window.wait(lambda: values(display) == wanted, 20):
            failures.append("%s: %s, not %s" % (what, values(display) if possible else "cannot be pressed", wanted))

    other, later = [pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact_04.vtk") for _ in range(2)]
    pasted = show(other)
    first = values(pasted)
    activate(reader, "series")
    for name in SET:
        setattr(shown, name, pasted.GetProperty(name).GetData())
    pv.Render(view)
    # Rows that leave move the others.
    if not window.wait(lambda: own_rows(window, shown) == DEFAULT_ROWS["Sphere"][0], 20):
        failures.append("the panel shows %s" % window.labels("propertiesPanel"))
    ticked = {**first, "MotionBlur": "1"}
    done("ticked", lambda: window.click("MotionBlur/CheckBox"), shown, ticked)
    done("undone", lambda: window.trigger("actionEditUndo"), shown, first)
    done("redone", lambda: window.trigger("actionEditRedo"), shown, ticked)
    for name, value in SET.items():
        setattr(shown, name, value)
    pv.Render(view)
    wanted = values(shown)
    if any(wanted[name] == first[name] for name in SET):
        failures.append("a display has from the beginning what is set: %s" % first)
    done("copied", lambda: window.click("DisplayButtons/DisplayCopy"), shown, wanted)
    activate(other, "other")
    done("pasted", lambda: window.click("DisplayButtons/DisplayPaste"), pasted, wanted)
    done("saved", lambda: window.click("DisplayButtons/DisplaySaveAsDefaults"), pasted, wanted)
    # Posted clicks come when the window has time.
    fresh = {}
    if not window.wait(lambda: fresh.update(values(show(later))) or fresh == wanted or pv.Delete(pv.GetRepresentation(later, view)), 10):
        failures.append("saved as default: a new display has %s, not %s" % (fresh, wanted))
    activate(later, "later")
    done("restored", lambda: window.click("DisplayButtons/DisplayRestoreDefaults"), pv.Show(later, view), first)
    if shown.GetPropertyValue("SamplesPerRender") != -1:
        failures.append("after the panel's buttons a render in the window takes %s samples" % shown.GetPropertyValue("SamplesPerRender"))
    return failures


def glyph_of(view):
    """A pixel within a glyph; None: there is none."""
    width, height = view.ViewSize
    return next(((x, y) for y in range(height // 2, height, 7) for x in range(width // 2, width, 7) if all(view.SMProxy.Pick(x + i, y + i) for i in (-2, 0, 2))), None)


def surfaces(window, view):
    """Add Surface shows the surface beside the glyphs of what has one; the menu of others goes without the entry."""
    with open(session.output("gui-molecule.xyz"), "w", encoding="ascii") as file:
        file.write("2\n\nO 0 0 0\nH 0.96 0 0\n")
    failures = []
    for name, source, offered in (("a molecule", pv.XYZReader(FileName=file.name), False), ("a hyper tree grid", pv.HyperTreeGridRandom(), False),
                                  ("points", session.source(session.poly_data(numpy.outer(range(3), (1.0, 1.0, 0.0)))), False), ("an image", pv.Wavelet(WholeExtent=[-2, 2] * 3), True),
                                  ("polygons among blocks", pv.GroupDatasets(Input=[pv.Line(), pv.Plane()]), True)):
        shown = session.glyphs(source, view, "Sphere", Orient=0)
        view.ResetCamera()
        pv.Render(view)
        on, found = glyph_of(view), []
        for _ in range(5):  # a click right after a display has gone opens no menu
            if on and window.right_click("Viewport", on) and window.wait(lambda: found.extend(window.menu("Add Surface")) or "Hide" in found, 2):
                break

        def surface():
            found = [pv.GetRepresentation(proxy, view) for (name, _), proxy in pv.GetSources().items() if name.startswith("ExtractSurface")]
            return found and found[0] and found[0].Visibility and str(found[0].Representation).strip("'") == "Ray Traced Surface" and shown.Visibility
        if not {"Hide", "Color By"} <= set(found) or ("Add Surface" in found) != offered or (offered and not window.wait(surface, 20)):
            failures.append("the menu of %s at %s has %s; there are %s" % (name, on, found, [name for name, _ in pv.GetSources()]))
        pv.Delete(shown)
        made = [proxy for (name, _), proxy in pv.GetSources().items() if name.startswith("ExtractSurface")]
        for proxy in [*made, source, *(source.Input if name.startswith("polygons") else ())]:
            pv.Delete(proxy)
    return failures


def clicked(window, view, shown):
    """A click of the right button on a glyph opens ParaView's menu of the display, beside the glyphs the view's."""
    failures = []
    session.assign_shape(shown, "Sphere")
    shown.ScaleFactor = 2.0
    view.ResetCamera()
    pv.Render(view)
    on = glyph_of(view)
    entries = {"Hide", "Representation", "Color By", "Focus Lens Here"}
    for at, wanted in (((2, 2), set()), (on, entries)):
        found = []
        if not at or not window.right_click("Viewport", at) or not window.wait(lambda: found.extend(window.menu()) or found, 20) \
                or entries & set(found) != wanted:
            failures.append("the menu at %s has %s" % (at, found))
    return failures + lens(window, view, on)


def lens(window, view, at):
    """The menu's entries focus on the depth of what was clicked on, as the depth buffer has it, are undone and traced, and end it."""
    renderer, camera = view.SMProxy.GetRenderer(), view.GetActiveCamera()
    pv.Render(view)
    renderer.SetDisplayPoint(at[0] + 0.5, at[1] + 0.5, renderer.GetZ(*at))
    renderer.DisplayToWorld()
    place = renderer.GetWorldPoint()
    depth = sum((place[i] / place[3] - camera.GetPosition()[i]) * camera.GetDirectionOfProjection()[i] for i in range(3))
    smtrace.start_trace()
    failures = []
    for entry, action, wanted in (("Focus Lens Here", "", depth), ("", "actionEditUndo", 0.0), ("", "actionEditRedo", depth), ("Lens Off", "", 0.0)):
        found = []
        for _ in range(5):  # a click right after a display has gone opens no menu
            if entry:
                window.right_click("Viewport", at)
            done = window.wait(lambda: found.extend(window.menu(entry) if entry else [window.trigger(action)]) or any(found), 5)
            if done:
                break
        if not done or not window.wait(lambda: abs(view.CameraFocalDistance - wanted) <= 1e-3 * depth, 10):
            failures.append("%s at %s, of %s: focus at %g, not %g" % (entry or action, at, found, view.CameraFocalDistance, wanted))
        if wanted and abs(view.CameraFocalDisk - 0.05 * depth) > 1e-3 * depth:
            failures.append("%s: a lens of %g" % (entry or action, view.CameraFocalDisk))
    trace = smtrace.stop_trace().replace(" = ", "=")  # ParaView 6 sets several properties in one call
    if not all("CameraFocalDistance=%s" % digits in trace for digits in (("%.3f" % depth)[:-2], "0.0")) or "CameraFocalDisk=" not in trace:
        failures.append("the trace of the lens is %s" % trace)
    return failures


def parts(window, view, reader, shown):
    """A clip and a selection of what is shown as glyphs are shown with the same glyphs, in place of the source."""
    failures = []
    set_before = {"GlyphShape": "Capsule", "ScaleMode": "Magnitude", "SelectScaleArray": "diameter", "ScaleFactor": 0.75, "ScaleFactorFromData": 0, "GlyphMode": "Every Nth"}
    for name, value in set_before.items():
        setattr(shown, name, value)
    shown.GlyphType = "Cone"
    shown.GlyphType.Height = 2.0
    # A part that has a display already, as of a script or a state, keeps it when it changes.
    clip = pv.Clip(Input=reader)
    old = pv.Show(clip, view)
    old.SetRepresentationType("Surface")
    shown.Visibility = 1
    pv.SetActiveSource(clip)
    pv.Render(view)
    before = clip.Invert
    window.wait(lambda: window.click("Invert/CheckBox"), 20)
    window.wait(lambda: window.click("propertiesPanel/Accept") and clip.Invert != before, 20)
    window.wait(lambda: old.Representation != "Surface", 1)
    if clip.Invert == before or old.Representation != "Surface" or not shown.Visibility:
        failures.append("a clip with a display is changed (%s): it is '%s', its source is %s" % (
            clip.Invert != before, old.Representation, "shown" if shown.Visibility else "hidden"))
    pv.Delete(clip)
    pv.SelectIDs(IDs=[0, 1, 0, 2], FieldType="POINT", Source=reader)
    for kind in "Clip", "ExtractSelection":
        shown.Visibility = 1
        pv.SetActiveSource(reader)
        pv.Render(view)
        made = window.wait(lambda: window.trigger(kind), 20) and \
            window.wait(lambda: any(name.startswith(kind) for name, _ in pv.GetSources()), 20)
        found = {}

        def display():
            # A busy window may have heard twice.
            filters = [proxy for (name, _), proxy in pv.GetSources().items() if name.startswith(kind)]
            return next((found for found in (pv.GetRepresentation(made, view) for made in filters) if found), None)

        # The button has no effect until the panel has noticed the filter.
        applied = window.wait(lambda: window.click("propertiesPanel/Accept") and display(), 20)

        def same():
            part = display()
            found.update({name: part.GetPropertyValue(name) for name in ("Representation", *set_before)} if part else {})
            return part and all(str(found[name]).strip("'") == str(value) for name, value in {"Representation": session.REPRESENTATION, **set_before}.items()) \
                and part.GlyphType.Height == 2.0 and part.GlyphType.SMProxy.GetXMLName() == "ConeSource" and not shown.Visibility
        if not applied or not window.wait(same, 20):
            failures.append("%s of glyphs (made: %s, applied: %s) has %s; its source is %s" % (
                kind, bool(made), bool(applied), found, "shown" if shown.Visibility else "hidden"))
        # Apply, before it, has hidden the source of a selection.
        elif not window.wait(lambda: window.trigger("actionEditUndo"), 20) or not window.wait(
                lambda: display().Representation == "Surface" and shown.Visibility == (kind == "Clip"), 20):
            failures.append("%s of glyphs: after one undo %s, its source is %s" % (kind, display().Representation, "shown" if shown.Visibility else "hidden"))
        for proxy in [proxy for (name, _), proxy in pv.GetSources().items() if name.startswith(kind)]:
            pv.Delete(proxy)
    pv.ClearSelection(reader)
    pv.SetActiveSource(reader)
    shown.Visibility, shown.GlyphMode, shown.GlyphShape, shown.GlyphType = 1, "All Points", "None", "Sphere"
    return failures


def reset(window, view, reader, shown):
    """The button Reset beside ScaleFactor goes back to what the data suggest, and the picture follows."""
    pv.SetActiveSource(reader)
    shown.GlyphType = "Sphere"
    shown.ScaleFactorFromData = 1
    pv.Render(view)
    suggested = shown.ScaleFactor
    shown.ScaleFactor = 0.3
    pv.Render(view)
    # What the status bar says of the first factor goes away by itself. The panel is filled when the window has time.
    window.wait(lambda: not window.text("statusbar"), 20)
    clicked = window.wait(lambda: window.click("ScaleFactor/Reset"), 20)
    said = "Scale Factor is now %.3g, chosen from the data" % suggested
    heard = set()
    done = clicked and window.wait(lambda: heard.add(window.text("statusbar")) or (shown.ScaleFactor == suggested and said in heard), 20)
    print("factor %s, after the click %s" % (suggested, shown.ScaleFactor))
    return [] if done and shown.ScaleFactorFromData else [
        "the button %s; ScaleFactor is %s, not %s; said: %s" % ("was clicked" if clicked else "is not there", shown.ScaleFactor, suggested, heard)]


if __name__ == "__main__":
    run("GUI", main)
