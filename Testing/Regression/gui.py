"""Runs inside ParaView's window: open data, apply, choose the representation and shapes, compare with the baseline.

Usage: RTGLYPHS_DATA=DIR paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=gui.py
Prints GUI TEST PASSED as its last line; the pictures are compared by this very process.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402

import comparison  # noqa: E402
import session  # noqa: E402
from window import Window, run  # noqa: E402

SHAPES = ("Sphere", "Box", "Cylinder", "Capsule", "Cone", "Arrow")
#: labels of the rows that all shapes have while nothing is ticked, and of those that shapes have before or after them
ROWS = ["Glyph Shape", "Glyph Location"]
TENSOR = ["Glyph Tensor Array", "Glyph Tensor Layout", "Glyph Tensor Coloring"]
EXPONENTS = ["Glyph Exponents", "Glyph Exponent Array"]
OF_SHAPES = {
    "Glyph Type": (["Glyph Type"], []),
    "Superquadric": ([], EXPONENTS), "Nested Superquadric": ([], EXPONENTS),
    "Tensor Ellipsoid": ([], TENSOR), "Tensor Superquadric": ([], TENSOR), "Signed Tensor Superquadric": ([], TENSOR), "Principal Axes": ([], TENSOR),
    "Spherical Harmonics": ([], ["Glyph Tensor Coloring", "Glyph Harmonics Array", "Glyph Harmonics Basis", "Glyph Harmonics Scaling"]),
    "Normal Stress": ([], TENSOR + ["Glyph Harmonics Scaling"]),
    "Fourth-Order Tensor": ([], ["Glyph Tensor Array", "Glyph Tensor Coloring", "Glyph Harmonics Scaling"])}

#: what is set by a script to be copied, saved and restored by the panel's buttons; no default among it
SET = {"GlyphShape": "Capsule", "MotionBlur": 1, "ScaleMode": "Magnitude", "GlyphScaleFunction": "Square Root", "GlyphTensorThickness": 0.125, "ShutterOpening": "Forward"}


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
    for shape in SHAPES:
        session.assign_shape(shown, shape)
        shown.ScaleFactor = 0.9
        pv.Render(view)
        pixels = session.capture(view, "gui-" + shape, ImageResolution=[300, 200])
        failures += comparison.against_baseline(pixels, "gui-" + shape)
    window = Window()
    pv.GetLayout().PreviewMode = [0, 0]  # the picture fills the window
    failures += reset(window, view, reader, shown)
    pv.GetLayout().PreviewMode = [300, 200]
    failures += panel(window, view, reader, shown)
    failures += buttons(window, view, reader, shown)
    return failures


def rows_of_glyphs(labels):
    """Labels of the rows that speak of shapes."""
    return [row for row in labels if row.startswith(("Glyph", "Arrow")) and row != "Glyph Parameters"]


def panel(window, view, reader, shown):
    """For each shape the panel shows the rows that concern it, and no others; sections stand in the order of use."""
    failures = []
    window.resize("pqClientMainWindow", 1500, 1100)
    pv.SetActiveSource(reader)
    shown.Visibility = 0 # the panel shows it all the same, and no program is compiled for each shape
    sections = ["Representation", "Coloring", "Glyph Parameters", "Scale Factor", "Ray Traced Glyphs", "Glyph Shape", "Motion", "Ray Traced Image", "Rendering Quality"]
    found = []

    def rows():
        found[:] = window.labels("propertiesPanel")
        return rows_of_glyphs(found)
    for shape in shown.GetProperty("GlyphShape").Available:
        shown.GlyphShape = shape
        pv.Render(view)
        wanted = OF_SHAPES.get(shape, ([], []))[0] + ROWS + OF_SHAPES.get(shape, ([], []))[1]
        if not window.wait(lambda wanted=wanted: rows() == wanted, 10):
            failures.append("the panel shows for %s %s, not %s" % (shape, rows(), wanted))
        window.picture("propertiesPanel", session.output("gui-panel-%s.png" % shape.replace(" ", "-")))
    if [row for row in found if row in sections] != sections:
        failures.append("the panel's sections are %s" % found)
    shown.Visibility = 1
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
    if not window.wait(lambda: rows_of_glyphs(window.labels("propertiesPanel")) == ["Glyph Type"] + ROWS, 20):
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
    # The panel is filled when the window has time.
    clicked = window.wait(lambda: window.click("ScaleFactor/Reset"), 20)
    done = clicked and window.wait(lambda: shown.ScaleFactor == suggested, 20)
    print("factor %s, after the click %s" % (suggested, shown.ScaleFactor))
    return [] if done and shown.ScaleFactorFromData else [
        "the button %s; ScaleFactor is %s, not %s" % ("was clicked" if clicked else "is not there", shown.ScaleFactor, suggested)]


run("GUI", main)
