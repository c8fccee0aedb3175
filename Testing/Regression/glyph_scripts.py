"""Scripts written for 3D Glyphs need their representation's name changed and nothing else: twelve of them draw the same with both, and a display
that goes back and forth between the two keeps what was chosen. Sources have many facets, the camera is the same.

Usage: pvpython glyph_scripts.py
"""
import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

THEIRS, OURS = "3D Glyphs", session.REPRESENTATION
#: fraction of the pixels that one of two pictures covers alone, and levels of 255 in the mean
SILHOUETTE, COLOR = 0.001, 1.5
SIDE = 240
RANDOM = numpy.random.default_rng(11)
COUNT = 40


def data():
    """Points with what people have: a wind, a direction, a size, three lengths, angles, a quaternion and a kind."""
    quaternions = RANDOM.normal(size=(COUNT, 4))
    return session.poly_data(RANDOM.uniform(-1.0, 1.0, (COUNT, 3)), wind=RANDOM.normal(size=(COUNT, 3)),
                             size=RANDOM.uniform(0.05, 0.25, COUNT), lengths=RANDOM.uniform(0.1, 0.4, (COUNT, 3)),
                             angles=RANDOM.uniform(-180.0, 180.0, (COUNT, 3)), kind=RANDOM.integers(0, 3, COUNT).astype(float),
                             quaternion=quaternions / numpy.linalg.norm(quaternions, axis=1)[:, None])


def arrows(d):
    d.Orient = 1
    d.SelectOrientationVectors = "wind"
    d.Scaling = 1
    d.ScaleFactor = 0.5
    d.GlyphType.TipResolution = d.GlyphType.ShaftResolution = 128


def arrows_by_magnitude(d):
    d.GlyphType = "Arrow"
    d.Orient = 1
    d.OrientationMode = "Direction"
    d.SelectOrientationVectors = "wind"
    d.Scaling = 1
    d.ScaleMode = "Magnitude"
    d.SelectScaleArray = "wind"
    d.ScaleFactor = 0.3
    d.GlyphType.TipResolution = d.GlyphType.ShaftResolution = 128


def thick_arrows(d):
    d.GlyphType = "Arrow"
    d.GlyphType.TipResolution, d.GlyphType.ShaftResolution = 128, 128
    d.GlyphType.TipRadius, d.GlyphType.TipLength, d.GlyphType.ShaftRadius = 0.3, 0.6, 0.12
    d.Orient, d.SelectOrientationVectors = 1, "wind"
    d.Scaling, d.ScaleFactor = 1, 0.5


def spheres_by_size(d):
    d.GlyphType = "Sphere"
    d.GlyphType.ThetaResolution = d.GlyphType.PhiResolution = 128
    d.Scaling = 1
    d.ScaleMode = "Magnitude"
    d.SelectScaleArray = "size"
    d.ScaleFactor = 1.5
    pv.ColorBy(d, ("POINTS", "size"))


def colored_spheres(d):
    d.GlyphType = "Sphere"
    d.GlyphType.Radius = 0.2
    d.GlyphType.ThetaResolution = d.GlyphType.PhiResolution = 128
    d.Orient, d.Scaling = 0, 1
    d.ScaleFactor = 0.8
    pv.ColorBy(d, ("POINTS", "wind", "Magnitude"))


def unscaled(d):
    d.GlyphType = "Sphere"
    d.GlyphType.Radius = 0.1
    d.GlyphType.ThetaResolution = d.GlyphType.PhiResolution = 128
    d.Scaling = 0
    d.ScaleFactor = 7.0
    d.DiffuseColor = d.AmbientColor = [0.8, 0.4, 0.2]


def cones(d):
    d.GlyphType = "Cone"
    d.GlyphType.Resolution = 128
    d.Orient, d.SelectOrientationVectors = 1, "wind"
    d.Scaling, d.ScaleFactor = 1, 0.3
    d.Opacity = 1.0


def slender_cones(d):
    d.GlyphType = "Cone"
    d.GlyphType.Height, d.GlyphType.Radius, d.GlyphType.Resolution = 2.0, 0.25, 128
    d.Orient, d.SelectOrientationVectors = 1, "wind"
    d.Scaling, d.ScaleMode, d.SelectScaleArray, d.ScaleFactor = 1, "Magnitude", "size", 2.0


def boxes_by_components(d):
    d.GlyphType = "Box"
    d.GlyphType.XLength = 1.5
    d.Orient, d.OrientationMode, d.SelectOrientationVectors = 1, "Rotation", "angles"
    d.Scaling, d.ScaleMode, d.SelectScaleArray, d.ScaleFactor = 1, "Vector Components", "lengths", 1.0


def cylinders_by_quaternions(d):
    d.GlyphType = "Cylinder"
    d.GlyphType.Resolution, d.GlyphType.Height, d.GlyphType.Radius = 128, 1.5, 0.2
    d.Orient, d.OrientationMode, d.SelectOrientationVectors = 1, "Quaternion", "quaternion"
    d.Scaling, d.ScaleFactor = 1, 0.4


def off_center(d):
    d.GlyphType = "Cone"
    d.GlyphType.Center = [0.5, 0.0, 0.0]
    d.GlyphType.Direction = [0.0, 1.0, 0.0]
    d.GlyphType.Resolution = 32
    d.Orient = 0
    d.Scaling = 1
    d.ScaleFactor = 0.3


def table(d):
    forms = [pv.Cone(Resolution=64), pv.Box(XLength=0.5), pv.Sphere(ThetaResolution=64, PhiResolution=64)]
    d.GlyphType = pv.GroupDatasets(Input=forms)
    d.UseGlyphTable = 1
    d.UseCompositeGlyphTable = 1
    d.GlyphTableIndexArray = "kind"
    d.Orient, d.SelectOrientationVectors = 1, "wind"
    d.Scaling, d.ScaleMode, d.SelectScaleArray, d.ScaleFactor = 1, "Magnitude", "size", 1.5


SCRIPTS = (arrows, arrows_by_magnitude, thick_arrows, spheres_by_size, colored_spheres, unscaled, cones, slender_cones, boxes_by_components,
           cylinders_by_quaternions, off_center, table)
#: what the scripts choose, and the sources' own
SHARED = ("Orient", "OrientationMode", "SelectOrientationVectors", "Scaling", "ScaleMode", "SelectScaleArray", "ScaleFactor", "UseGlyphTable",
          "UseCompositeGlyphTable", "GlyphTableIndexArray")


def chosen(shown):
    """Values of what the representations share."""
    glyph = shown.GlyphType
    return {**{name: session.value_of(shown, name) for name in SHARED},
            "GlyphType": (glyph.GetXMLName(), {name: str(glyph.GetPropertyValue(name)) for name in glyph.ListProperties() if name != "Input"})}


def picture(shown, view, name):
    """What a display shows, seen from one place."""
    if shown.ColorArrayName[1]:
        shown.SetScalarBarVisibility(view, False)
    pv.Render(view)  # the camera's near plane cuts 3D Glyphs off until they are drawn again
    return session.capture(view, name)


def compare(checks, what, found, wanted):
    """Silhouettes and colors."""
    apart = comparison.covered(found) != comparison.covered(wanted)
    levels = numpy.abs(found[..., :3].astype(float) - wanted[..., :3]).mean()
    print("%s: silhouettes %.4f %%, colors %.2f levels apart" % (what, 100.0 * apart.mean(), levels), flush=True)
    checks.covered(what, wanted, 0.005)
    checks.within(what + ": fraction of the silhouettes", float(apart.mean()), 0.0, SILHOUETTE)
    checks.within(what + ": levels of color", float(levels), 0.0, COLOR)


def script(checks, view, source, statements):
    """One script, with both representations in displays of their own, and back and forth in one."""
    pictures = []
    for representation in (THEIRS, OURS):
        shown = pv.Show(source, view)
        shown.SetRepresentationType(representation)
        if representation == OURS:
            shown.SamplesPerPixel = 1
        statements(shown)
        pictures.append(picture(shown, view, "script-%s-%s" % (statements.__name__, representation.split()[0])))
        if representation == THEIRS:
            pv.Delete(shown)
    compare(checks, statements.__name__, pictures[1], pictures[0])
    wanted = chosen(shown)
    for turn in range(10):
        shown.SetRepresentationType((THEIRS, OURS)[turn % 2])
        if turn > 7:
            compare(checks, "%s, switched %d times" % (statements.__name__, turn + 1),
                    picture(shown, view, "script-%s-switched-%d" % (statements.__name__, turn)), pictures[0])
        else:
            pv.Render(view)
        checks.equal("%s, switched %d times" % (statements.__name__, turn + 1), chosen(shown), wanted)
    pv.Delete(shown)


def main():
    """All scripts."""
    session.load()
    checks = Checks()
    view = session.view(SIDE, SIDE)
    session.look(view, (2.0, 1.5, 5.0))
    source = session.source(data())
    for statements in SCRIPTS:
        script(checks, view, source, statements)
    checks.report()


if __name__ == "__main__":
    main()
