"""Cuts through ray-traced glyphs beside ParaView's filters on tessellated ones: Clip leaves them open, Clip Closed Surface closes them. A plane that is
dragged has nothing gathered or built; bounds stay. Caps are picked.

Usage: pvpython section.py
"""
import paraview.simple as pv

import comparison
import session
from checks import Checks
from same_as_3d_glyphs import scene, tessellate

ORIGIN, NORMAL = [0.1, -0.05, 0.0], [0.4, 0.2, 1.0]
BOX = {"Position": [-0.6, -0.7, 0.1], "Rotation": [20.0, -30.0, 10.0], "Length": [1.2, 1.1, 1.4]}
GLYPH = {"OrientationArray": ["POINTS", "vector"], "ScaleArray": ["POINTS", "vector"], "ScaleFactor": 0.45, "GlyphMode": "All Points"}
COLORS = {"ColorArrayName": [None, ""], "DiffuseColor": [0.9, 0.6, 0.3], "AmbientColor": [0.9, 0.6, 0.3]}
#: what is built where a cut changes
BUILDS = ("gathers", "boundsBuilds", "instanceBuilds", "colorBuilds", "structureBuilds", "topLevelBuilds", "instanceUploads")


def plane(function):
    """Gives one of ParaView's planes that of the cut."""
    function.Origin, function.Normal = ORIGIN, NORMAL


def clipped(glyphs, shape, invert, closed):
    """ParaView's filter on tessellated glyphs."""
    if closed:
        made = pv.ClipClosedSurface(Input=glyphs, ClippingPlane="Plane", GenerateOutline=0)
        plane(made.ClippingPlane)
        if invert:  # InsideOut does nothing in ParaView 6.1
            made.ClippingPlane.Normal = [-component for component in NORMAL]
        return made
    made = pv.Clip(Input=glyphs, ClipType=shape, Invert=int(invert))
    if shape == "Plane":
        plane(made.ClipType)
    else:
        for name, value in BOX.items():
            setattr(made.ClipType, name, value)
    return made


def picture(view, name):
    """What is seen from in front of the cut."""
    session.look(view, (1.8, 1.2, 3.6))
    return session.capture(view, name)


def pictures(checks, shape, cases):
    """One shape, cut in each way."""
    points = scene()
    for cut, invert, closed in cases:
        name = "section-%s-%s-%s-%s" % (shape, cut, "inverted" if invert else "not", "closed" if closed else "open")
        theirs = session.view()
        glyphs = pv.Glyph(Input=points, GlyphType=shape, **GLYPH)
        tessellate(glyphs.GlyphType, shape)
        shown = pv.Show(clipped(glyphs, cut, invert, closed), theirs)
        session.assign(shown, "Representation", "Surface")
        for property_, value in COLORS.items():
            setattr(shown, property_, value)
        their_picture = picture(theirs, name + "-theirs")
        ours = session.view()
        shown = session.glyphs(points, ours, shape, samples=1, Orient=1, OrientationMode="Direction", SelectOrientationVectors="vector", Scaling=1,
                               ScaleMode="Magnitude", SelectScaleArray="vector", ScaleFactor=0.45, Section=cut, SectionInvert=int(invert),
                               SectionCaps="Caps" if closed else "Open", SectionOrigin=ORIGIN, SectionNormal=NORMAL,
                               **{"Section" + property_: value for property_, value in BOX.items()}, **COLORS)
        our_picture = picture(ours, name)
        checks.failures += comparison.against_paraview(our_picture, their_picture, name, silhouette=0.0003, color=0.6)
        pv.Delete(theirs)
        pv.Delete(ours)


def dragged(checks):
    """Nothing is built anew, and the camera is reset to the whole."""
    view = session.view(64, 64)
    shown = session.glyphs(scene(), view, ScaleFactor=0.3)
    found = []
    for step, cut in enumerate(("None", "Plane", "Plane", "Box", "None")):
        shown.Section, shown.SectionOrigin = cut, [0.1 * step, 0.0, 0.0]
        pv.Render(view)
        pv.ResetCamera(view)
        found.append([session.statistics(shown)[name] for name in BUILDS] + list(view.CameraPosition))
    checks.equal("what is built, and bounds, while a plane is dragged", found[1:], found[:1] * 4)


def translucent(checks):
    """In pictures without a background, a cap of half opacity counts as the glyph's shell does: before the far one there are both, or it is open."""
    view = session.view(64, 64)
    shown = session.glyphs(session.source(session.poly_data([[0.0, 0.0, 0.0]])), view, Opacity=0.5, Section="Plane", SectionNormal=[0.0, 0.0, 1.0])
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.0)
    for faces, alpha in (("Caps", 0.75), ("Open", 0.5), ("Whole Glyphs", 0.75)):
        shown.SectionCaps = faces
        found = session.capture(view, "section-alpha", TransparentBackground=1)[..., 3]
        checks.within("alpha in the middle, " + faces, found[32, 32] / 255.0, alpha - 0.005, alpha + 0.005)
        checks.equal("alpha aside, " + faces, found[2, 2], 0)


def picked_and_refused(checks):
    """A cap is picked as its glyph is, and a cut that is none has one message."""
    view = session.view(64, 64)
    points = session.source(session.poly_data([[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]))
    shown = session.glyphs(points, view, ScaleFactor=0.9, Section="Plane", SectionOrigin=[0.0, 0.0, 0.1], SectionNormal=[0.0, 0.0, 1.0])
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.0)
    pv.Render(view)
    for number, x in enumerate((-0.5, 0.5)):
        found = session.picked(view, "POINT", session.pixel_of(view, (x, 0.1, 0.1)))
        checks.equal("what is picked on a cap", [entry[-1] for entry in found], [number])
    whole = comparison.covered(session.capture(view, "section-whole")).mean()
    shown.SectionNormal = [0.0, 0.0, 0.0]
    checks.one_message("a plane without a normal", session.messages(lambda: pv.Render(view)), "SectionNormal", "0 0 0", "give it a length")
    checks.no_message("the same again", session.messages(lambda: pv.Render(view)))
    checks.within("covered where nothing is cut", comparison.covered(session.capture(view, "section-none")).mean() / whole, 1.0, 1.1)
    shown.SectionNormal, shown.SectionThickness = [0.0, 0.0, 1.0], -1.0
    checks.one_message("a slab thinner than nothing", session.messages(lambda: pv.Render(view)), "SectionThickness", "-1", "0 for one side")


def main():
    """Shapes, then what is built."""
    session.load()
    checks = Checks()
    pictures(checks, "Sphere", [("Plane", True, True), ("Plane", False, True), ("Plane", True, False), ("Box", True, False), ("Box", False, False)])
    pictures(checks, "Arrow", [("Plane", True, True), ("Box", False, False)])
    pictures(checks, "Cone", [("Plane", True, True)])
    dragged(checks)
    translucent(checks)
    picked_and_refused(checks)
    checks.report()


if __name__ == "__main__":
    main()
