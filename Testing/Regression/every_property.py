"""Every property of ray-traced glyphs, surfaces and tubes does what its documentation says, and goes back when it is set back.

The properties are those of the plugin's XML: a new one without a row in ROWS fails, and so does a row whose property is gone.

Usage: pvpython every_property.py [REPRESENTATION] [PROPERTY...]
"""
import os
import sys

import numpy
import paraview.simple as pv

import comparison
import glyph_legend
import session
from checks import Checks, information, stepwise
from property_claims import (GLYPHS, LEFT, LEVEL, SCENES, SIDE, SURFACE, TUBES, UNLIT, WHITE, Bench, Change, area, as_3d_glyphs, as_before, as_surface, as_with, both,
                             colors, data_of, developed, filmic, glyphs, light, light_of_ball, moments, moved, needing, noise, pixels_of, reads,
                             schlick, spread, to_light)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Documents"))
import property_reference  # noqa: E402

DISC = numpy.pi / 4.0
RED, GREEN, BLUE, BLACK = [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0] * 3
#: of a dark and of the usual gray
DARK, GRAY = float(to_light(0.2)), float(to_light(0.8))


class Row:
    """A property, the value that it is set to, what that does, and what else is set meanwhile."""

    def __init__(self, name, value, claim, scene="ball", kinds=None, back=True, **properties):
        self.name, self.value, self.claim, self.scene, self.kinds, self.back, self.properties = name, value, claim, scene, kinds, back, properties
        self.text = "" if value is LEFT else getattr(value, "__name__", str(value))


def table(name, *colors_at):
    """A function that makes a lookup table of that name: values and colors."""
    def make(_):
        made = pv.GetColorTransferFunction(name)
        made.ColorSpace, made.RGBPoints = "RGB", [float(number) for value, color in colors_at for number in [value] + color]
        return made
    return make


RED_TO_BLUE, ALL_GREEN = table("red to blue", (0.5, RED), (1.0, BLUE)), table("all green", (0.0, GREEN), (10.0, GREEN))


def forms(_):
    """A table of glyphs: a box of side 1, and one of half of it."""
    return pv.GroupDatasets(Input=[pv.Box(), pv.Box(XLength=0.5, YLength=0.5, ZLength=0.5)])


# Claims about single properties.
def picked(change):
    """What is clicked on."""
    found = []
    for pickable in (1, 0):
        change.look("pick", Pickable=pickable)
        found.append(len(session.picked(change.bench.view, "POINT" if change.kind == GLYPHS else "CELL", (SIDE // 2, SIDE // 2))))
    change.checks.equal(change.name + ": number of things under the pixel", found, [1, 0])


def softer(change):
    """Shadows are as dark in the mean, but have no sharp edges."""
    change.changed()
    mask = comparison.covered(255.0 * change.before)
    change.ratio("mean level", change.after[mask].mean() / change.before[mask].mean(), 0.9, 1.1)
    # Differences between neighbors within glyphs
    edges = [numpy.abs(numpy.diff(picture, axis=0))[mask[1:] & mask[:-1]].mean() for picture in (change.before, change.after)]
    change.ratio("mean difference of neighbors", edges[1] / edges[0], 0.3, 0.97)


def caught(low, high, tilt=False):
    """The background is darker, but no lighter anywhere, in at least such a fraction of the picture; glyphs stay."""
    def claim(change):
        if tilt:
            session.look(change.bench.view, (0.0, 5.0, 10.0), parallel_scale=SCENES[change.row.scene][2])
            change.before, change.after = [
                session.pixels_of(capture(change, value))[..., :3].astype(float) / 255.0 for value in ("None", change.row.value)]
        mask = comparison.covered(255.0 * change.before)
        inside = numpy.logical_and.reduce([numpy.roll(mask, (x, y), (0, 1)) for x in range(-2, 3) for y in range(-2, 3)])
        change.within("change of what glyphs cover", numpy.abs(change.after - change.before)[inside].max(), 0.0, 0.0)
        lost = (change.before - change.after).max(axis=2)
        change.within("light that the background gains", max(0.0, float(-(change.before - change.after).min())), 0.0, 1.5 / 255.0)
        change.ratio("fraction of the picture that is darker", (lost > 0.02).mean(), low, high)
    return claim


def capture(change, value):
    """The picture from where the camera is, with another value of the property."""
    change.shown.SetPropertyWithName(change.name.split()[0], value)
    return change.bench.view.SMProxy.CaptureWindow(1)


def outlined(color, width):
    """Pixels of the color lie along the ball's edge, as many as a line of that width has."""
    def claim(change):
        change.changed()
        near = [numpy.clip(1.0 - numpy.abs(picture - color).max(axis=2), 0.0, 1.0) for picture in (change.before, change.after)]
        around = numpy.pi * SCENES[change.row.scene][1] * SIDE / (2.0 * SCENES[change.row.scene][2])
        found = (near[1] - near[0])[(near[1] > 0.9)].size
        change.ratio("pixels of the line over those of its length", found / around, width - 1.5, width + 0.5)
    return claim


def faded(change):
    """All of the ball is nearer the background, what is farther more so."""
    change.changed()
    center, rim = SIDE // 2, int(SIDE / 2 - 0.46 * SIDE / (2.0 * SCENES[change.row.scene][2]))
    magenta = numpy.array([1.0, 0.0, 1.0])
    left = [numpy.abs(change.after[center, at] - magenta).max() / numpy.abs(change.before[center, at] - magenta).max() for at in (center, rim)]
    change.ratio("what is left in front", left[0], 0.8, 1.0)
    change.ratio("what is left at the rim over that", left[1] / left[0], 0.6, 0.97)


def others(change):
    """The colors that are seen are not those of before."""
    seen = [set(map(tuple, numpy.unique(picture.reshape(-1, 3), axis=0).tolist())) for picture in (change.before, change.after)]
    change.ratio("fraction of the glyphs that were seen before", len(seen[0] & seen[1]) / len(seen[0]), 0.0, 0.7)
    change.checks.equal(change.name + ": glyphs", change.counted_after["glyphs"], change.counted_before["glyphs"])
    grows(change)


def legend(wanted, right=False, upper=False):
    """Width of the legend's white glyph in world units, and where it stands."""
    @needing(GlyphLegend="Lower Left", DiffuseColor=RED)
    def claim(change):
        mask = (change.after[..., 1] > 0.5)[::-1]
        change.within("width of the legend's glyph", glyph_legend.longest_run(mask) * 2.0 * SCENES[change.row.scene][2] / SIDE, wanted, 0.03)
        rows, columns = numpy.nonzero(mask)
        change.checks.equal(change.name + ": (right, upper)", (columns.mean() > SIDE / 2, rows.mean() > SIDE / 2), (right, upper))
    return claim


def rendered(change, times, step=0, **properties):
    """Renders a fresh image so often, and gives the information that a script reads."""
    change.base = {**change.base, **properties}
    shown = stepwise(change.bench.show(change.row.scene, change.kind, change.base), step)
    session.look(change.bench.view, (0.0, 0.0, numpy.random.default_rng().uniform(10.0, 20.0)), parallel_scale=1.0)
    for _ in range(times):
        pv.Render(change.bench.view)
    return {name: information(shown, name) for name in ("AccumulatedSamples", "RefinementProgress", "RefinementStep")}


def grows(change):
    """Samples, progress and step after one of four renders, and after all."""
    found = [list(rendered(change, times, 2, SamplesPerPixel=8).values()) for times in (1, 4)]
    change.checks.equal(change.name + ": after one render and after four", found, [[2, 0.25, "Ray Tracing"], [8, 1.0, ""]])


def stopped(change):
    """The image has the samples of the renders before."""
    rendered(change, 2, 2, SamplesPerPixel=8)
    change.shown.SMProxy.InvokeCommand("StopRefinement")
    pv.Render(change.bench.view)
    found = [information(change.shown, name) for name in ("AccumulatedSamples", "RefinementProgress")]
    change.checks.equal(change.name + ": samples and progress", found, [4, 1.0])


def steps(change):
    """One render adds so many samples, not all of very many, or all."""
    for step, wanted, finished in ((2, 4, False), (-1, 20000, False), (0, 2, True)):
        found = rendered(change, 1, step, SamplesPerPixel=wanted)
        change.checks.equal("%s %d: the image is finished" % (change.name, step), found["RefinementProgress"] >= 1.0, finished)


def written(change):
    """The file, once."""
    path = session.output("every-property-%s.vti" % change.kind.split()[-1].lower())
    for asked in (True, False):
        if os.path.exists(path):
            os.remove(path)
        if asked:
            change.shown.SMProxy.GetProperty("FeatureImageFile").SetElement(0, path)
            change.shown.SMProxy.UpdateVTKObjects()
        change.look("written", Exposure=1.0 if asked else 0.5)
        change.checks.equal("%s: asked for: %s, there is a file" % (change.name, asked), os.path.exists(path), asked)


def statistics_say(change):
    """A device, one glyph, and how the image grows."""
    counted = change.counted()
    change.checks.true(change.name + ": no device", bool(counted["DeviceName"]))
    change.checks.equal(change.name + ": glyphs", counted["glyphs"], 1 if change.kind == GLYPHS else change.counted_before["glyphs"])
    grows(change)


def keyless(change):
    """The key goes, which was in the upper right corner."""
    change.changed()
    found = [(picture[:SIDE // 5, -SIDE // 5:].std(axis=(0, 1)) > 0.05).any() for picture in (change.before, change.after)]
    change.checks.equal(change.name + ": a key in the corner before and after", found, [True, False])


def streaks(change):
    """The ball has a streak as long as the way since the step before, and had none."""
    source = change.bench.display(change.row.scene, change.kind).Input
    found = []
    for properties in (change.start, change.base):
        for time in (0.0, 1.0):
            session.replace_data(source, data_of(change.row.scene, change.kind, time))
            picture = change.look_at("step", change.kind, properties)
        found.append(moments(change, picture)[2][0])
    change.within("variance more than at rest", found[1] - found[0], 0.25 / 12.0, 0.001)
    session.replace_data(source, data_of(change.row.scene, change.kind))


#: the same light from everywhere, of which closed forms speak
UNIFORM = {"Illumination": "Uniform", "ToneMapping": "None"}
PATHS = {"ShadingMode": "Path Tracing", **UNIFORM}
OCCLUSION = {"ShadingMode": "Ambient Occlusion", **UNIFORM}
#: local shading of a material that shines by itself: the color and nothing else
FLAT = {"ShadingMode": "Local", "Ambient": 1.0, "Diffuse": 0.0, "AmbientColor": [0.8] * 3}
MIRROR = {**PATHS, "Roughness": 0.0, "DiffuseColor": [0.2] * 3}
COATED = {**PATHS, "DiffuseColor": BLACK, "CoatStrength": 1.0}
#: of ParaView's light kit one light casts them
SHADOWS = {"Shadows": 1, "ShadingMode": "Local", "SamplesPerPixel": 64}
SHINY = {"Specular": 0.5, "SpecularPower": 20.0}
ARROW = {"GlyphType": "Arrow", "scene": "arrow"}
TENSOR = {"GlyphShape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor"}
HARMONICS = {"GlyphShape": "Spherical Harmonics", "GlyphHarmonicsArray": "round"}
BLUR = {"MotionBlur": 1, "VelocityArray": "velocity", "ShutterTime": 1.0, "scene": "small"}
STEPS = {**WHITE, **BLUR, "VelocityArray": "None", "ShutterOpening": "Backward"}
TURNED = {"scene": "two", "GlyphType": "Box", "Orient": 1, "OrientationMode": "Rotation", "SelectOrientationVectors": "angles"}
PLANE, BOX = {"Section": "Plane"}, {"Section": "Box", "SectionPosition": [-0.25] * 3}
#: area of the segment of the disc beyond half of its radius
SEGMENT = (2.0 * numpy.pi - 1.5 * numpy.sqrt(3.0)) / 24.0
MASKED = {"scene": "crowd", "GlyphMode": "Random", "MaximumNumberOfGlyphs": 20}
#: fixed heads of an arrow that is half as long as the one of reference
TWICE = as_with(**{"ArrowHeads": "Fixed", "ArrowReferenceMagnitude": 0.5, "GlyphType.TipLength": 0.7, "GlyphType.TipRadius": 0.2, "GlyphType.ShaftRadius": 0.06})
FIRST, SECOND = "/Root/Block0", "/Root/Block1"

ROWS = [
    # Shape and size; areas are those of the profiles.
    Row("GlyphShape", "Capsule", area(DISC / 4.0 + 0.25), scene="small"),
    Row("GlyphLocation", "Cells", both(glyphs(1), area(DISC / 4.0)), scene="quad"),
    Row("GlyphType", "Box", area(1.0)),
    Row("UseCompositeGlyphTable", 1, area(1.0, 0.25), scene="two", GlyphType=forms, UseGlyphTable=1, GlyphTableIndexArray="index"),
    Row("UseGlyphTable", 1, area(1.0, 0.25), scene="two", GlyphType=forms, UseCompositeGlyphTable=1, GlyphTableIndexArray="index"),
    Row("GlyphTableIndexArray", "other index", area(0.25, 1.0), scene="two", GlyphType=forms, UseGlyphTable=1, UseCompositeGlyphTable=1,
        **{"GlyphTableIndexArray": "index"}),
    Row("ScaleFactor", 0.5, area(DISC / 4.0)),
    # A fifth of the longest side, which is 1.2.
    Row("ScaleFactorFromData", 1, reads("ScaleFactor", 0.24), scene="two", back=False),
    Row("DataSummary", LEFT, reads("DataSummary", [0.24, 0.0, 0.0], part=slice(0, 3)), kinds=[GLYPHS], scene="two", ScaleFactorFromData=1),
    Row("DataSummary", LEFT, reads("DataSummary", [0.0, 1.0, 1.0, 0.0], part=slice(7, 11)), kinds=[GLYPHS], GlyphType=forms),
    Row("Scaling", 0, area(DISC), ScaleFactor=0.5),
    Row("ScaleMode", "Magnitude", area(DISC / 4.0, DISC), scene="two", SelectScaleArray="size"),
    Row("SelectScaleArray", "quarter", area(DISC / 16.0, DISC / 16.0), scene="two", ScaleMode="Magnitude", **{"SelectScaleArray": "size"}),
    Row("ScaleMode", "Vector Components", area(DISC / 2.0), SelectScaleArray="lengths"),
    Row("ScaleMode", "Vector Components", as_3d_glyphs(Scaling=1, ScaleMode="Vector Components", SelectScaleArray="lengths"), SelectScaleArray="lengths"),
    Row("GlyphScaleFunction", "Square Root", area(DISC / 4.0), ScaleMode="Magnitude", SelectScaleArray="quarter"),
    Row("GlyphSizeRange", [0.0, 0.5], area(DISC / 4.0)),
    Row("GlyphRadiusArray", "quarter", area(0.5), GlyphType="Box"),
    Row("GlyphAnchor", "Tip", moved(-0.25, 0.0), scene="small", GlyphType="Box"),
    Row("Orient", 0, as_3d_glyphs(), **TURNED),
    Row("SelectOrientationVectors", "lengths", as_3d_glyphs(Orient=1, OrientationMode="Direction", SelectOrientationVectors="lengths"),
        **{**TURNED, "OrientationMode": "Direction"}),
    Row("SelectOrientationVectors", "quaternion", as_3d_glyphs(Orient=1, OrientationMode="Quaternion", SelectOrientationVectors="quaternion"),
        **{**TURNED, "OrientationMode": "Quaternion", "SelectOrientationVectors": "axes"}),
    Row("OrientationMode", "Rotation", as_3d_glyphs(Orient=1, OrientationMode="Rotation", SelectOrientationVectors="angles"),
        **{**TURNED, "OrientationMode": "Direction"}),
    Row("GlyphExponents", [1.0] * 3, area(0.5), GlyphShape="Superquadric", GlyphExponentArray="None"),
    Row("GlyphExponentArray", "exponents", area(0.5), GlyphShape="Superquadric", **{"GlyphExponentArray": "None"}),
    Row("GlyphOpacityArray", "half", as_with(Opacity=0.5, GlyphOpacityArray="None")),
    # The head of an arrow twice as long
    Row("ArrowHeads", "Fixed", TWICE, ScaleMode="Magnitude", SelectScaleArray="size", ArrowReferenceMagnitude=1.0, **ARROW),
    Row("ArrowHeads", "Scaled", area((0.65 * 0.06 + 0.035) / 4.0), ScaleMode="Magnitude", SelectScaleArray="size", ArrowReferenceMagnitude=1.0, **ARROW,
        **{"ArrowHeads": "Fixed"}),
    Row("ArrowReferenceMagnitude", 1.0, TWICE, ScaleMode="Magnitude", SelectScaleArray="size", ArrowHeads="Fixed", **ARROW),
    Row("GlyphMode", "Random", glyphs(20), **{**MASKED, "GlyphMode": "All Points"}),
    Row("MaximumNumberOfGlyphs", 37, glyphs(37), **MASKED),
    Row("GlyphMode", "Every Nth", glyphs(6), **MASKED),
    Row("GlyphMode", "Even in Space", glyphs(20), **{**MASKED, "GlyphMode": "Every Nth"}),
    Row("GlyphStride", 4, glyphs(15), **{**MASKED, "GlyphMode": "Every Nth"}),
    # Around a ball of a quarter of the size one of half of it, whose two sides have 0.4 of the opacity
    Row("GlyphShellArray", "half", area(DISC * (1.0 / 16.0 + (1.0 - 0.6 ** 2) * 3.0 / 16.0)), ScaleMode="Magnitude", SelectScaleArray="quarter"),
    # The legend
    Row("GlyphLegend", "Lower Left", pixels_of([1.0] * 3, 30, 1000), DiffuseColor=RED, AmbientColor=RED, ScaleMode="Magnitude", SelectScaleArray="size"),
    Row("GlyphLegendValue", 0.4, legend(0.4), ScaleMode="Magnitude", SelectScaleArray="size"),
    # Tensors
    Row("GlyphTensorArray", "disc", area(DISC / 4.0), **TENSOR),
    Row("GlyphTensorLayout", "xx xy xz yy yz zz", as_with(GlyphTensorArray="rows"), **{**TENSOR, "GlyphTensorArray": "six"}),
    Row("GlyphTensorSharpness", 0.0, as_with(GlyphShape="Tensor Ellipsoid"), **{**TENSOR, "GlyphShape": "Tensor Superquadric"}),
    # Half-axes of a fifth of the standard deviations times the root of the quantile, which is 2.366 for a half
    Row("GlyphConfidence", 0.5, area(numpy.pi * 0.04 * 2.366 * numpy.sqrt(0.5)), GlyphShape="Confidence Ellipsoid", GlyphTensorArray="tensor", ScaleFactor=0.2),
    Row("GlyphTensorColoring", "Eigenvalues", colors([1.0, 0.5, 0.5]), **TENSOR),
    Row("GlyphTensorColoring", "Middle Eigenvalue", reads("DataSummary", [0.5, 0.5], part=slice(4, 6)), **TENSOR),
    Row("GlyphTensorColoring", "Radius", reads("DataSummary", [0.0, 1.0], part=slice(4, 6)), **HARMONICS),
    Row("GlyphTensorLookupTable", ALL_GREEN, colors(GREEN), GlyphTensorColoring="Trace", **TENSOR),
    Row("ColorFromData", 1, as_with(GlyphTensorColoring="Fractional Anisotropy"), **TENSOR),
    Row("DataSummary", LEFT, reads("DataSummary", [2.0, 2.0, 0.0], part=slice(4, 7)), kinds=[GLYPHS], GlyphTensorColoring="Trace", **TENSOR),
    Row("GlyphTensorLookupTable", ALL_GREEN, colors(GREEN), GlyphTensorColoring="Sign", **TENSOR),
    Row("GlyphHarmonicsArray", "flat", area(DISC / 4.0), **HARMONICS),
    Row("GlyphHarmonicsBasis", "DIPY Legacy", as_with(GlyphHarmonicsArray="lying", GlyphHarmonicsBasis="MRtrix3"), **{**HARMONICS, "GlyphHarmonicsArray": "standing"}),
    Row("GlyphScaleFunction", "All the Same", area(DISC), **{**HARMONICS, "GlyphHarmonicsArray": "flat"}),
    Row("GlyphTensorAxis", 1, pixels_of([0.95, 0.8, 0.2], 20, 200), **{**TENSOR, "GlyphTensorArray": "turning"}),
    # Tubes
    Row("TubeRadius", 0.25, area(DISC / 4.0)),
    Row("TubeRadiusArray", "half", area(DISC / 4.0)),
    # A disc's variances are a half: of half-axes of a half
    Row("TubeRadiusArray", "disc", area(DISC / 2.0)),
    Row("TubeEnds", "Flat", area(0.5), scene="coarse"),
    # Directions: tubes, and what TURNED turns
    Row("GlyphDirectionColoring", "Axes", colors(GREEN), kinds=[TUBES], GlyphDirectionKey="None"),
    Row("GlyphDirectionColoring", "Axes", colors(RED), kinds=[GLYPHS], GlyphDirectionKey="None", **TENSOR),
    Row("GlyphDirectionKey", "None", keyless, kinds=[TUBES], GlyphDirectionColoring="Sphere"),
    Row("GlyphDirectionKey", "None", keyless, kinds=[GLYPHS], GlyphDirectionColoring="Axes", **TENSOR),
    # Motion: what moves evenly by d has a variance of d^2 / 12 more.
    Row("MotionBlur", 1, spread(0.25 / 12.0, 0.0), **{**BLUR, "MotionBlur": 0}),
    Row("VelocityArray", "upward", spread(-0.25 / 12.0, 0.25 / 12.0), **BLUR),
    Row("ShutterTime", 0.5, spread(-0.1875 / 12.0, 0.0), **BLUR),
    # Three widths of 0.5 at a speed of 0.5; of a surface a twentieth of its side, between the outer percentiles of its points
    Row("DataSummary", LEFT, reads("DataSummary", [3.0], part=slice(3, 4)), kinds=[GLYPHS, TUBES], **{**BLUR, "ShutterTime": 0.0}),
    Row("DataSummary", LEFT, reads("DataSummary", [0.048], part=slice(3, 4)), kinds=[SURFACE], **{**BLUR, "ShutterTime": 0.0}),
    Row("ShutterOpening", "Forward", moved(0.25, 0.0), **BLUR),
    # The mean of a t t / 2 over the shutter's time
    Row("AccelerationArray", "push", moved(0.8 / 6.0, 0.0), ShutterOpening="Forward", **BLUR),
    # A box of 1 by 1/2 turns by up to 45 degrees to either side, over which the mean of cos^2 is 1/2 + 1/pi.
    Row("AngularVelocityArray", "spin", spread((1.0 / numpy.pi - 0.5) / 16.0, (0.5 - 1.0 / numpy.pi) / 16.0), GlyphType="Box", SelectScaleArray="lengths", ScaleMode="Vector Components", MotionBlur=1, ShutterTime=1.0, VelocityArray="None"),
    Row("MotionBlurMask", "index", spread(-0.25 / 12.0, 0.0), **BLUR),
    Row("MotionBlurMask", "other index", as_with(MotionBlurMask="None"), **{**BLUR, "MotionBlurMask": "index"}),
    Row("VelocityArray", "From Previous Step", streaks, PointIdArray="point", **STEPS),
    Row("PointIdArray", "point", streaks, **{**STEPS, "VelocityArray": "From Previous Step", "PointIdArray": "changing"}),
    # Cuts: areas of half a disc, of a segment, of squares; where their middles are
    # A ball of diameter 0.5 and its images at either side, one of them outside of the picture
    Row("PeriodicBoundary", 1, area(3.0 * DISC / 4.0), scene="small", PeriodicImages=[1, 1, 0], PeriodicVectors=[2.0, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 1.0]),
    Row("PeriodicBoundary", 1, light(0.3, 0.95), scene="crowd", PeriodicVectors=[1.6, 0.0, 0.0, 0.0, 1.6, 0.0, 0.0, 0.0, 1.6],
        AmbientOcclusionRadius=0.5, **OCCLUSION),
    Row("PeriodicImages", [0, 1, 0], area(3.0 * DISC / 4.0), scene="small", PeriodicBoundary=1, PeriodicVectors=[2.0, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 1.0]),
    Row("PeriodicVectors", [2.0, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 1.0], area(3.0 * DISC / 4.0), scene="small", PeriodicBoundary=1, PeriodicImages=[0, 1, 0],
        **{"PeriodicVectors": [9.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 9.0]}),
    Row("Section", "Plane", area(DISC / 2.0)),
    Row("Section", "Box", area(0.25), SectionPosition=[-0.25] * 3, SectionLength=[0.5] * 3),
    Row("SectionInvert", 0, area(SEGMENT), **{**PLANE, "SectionOrigin": [0.25, 0.0, 0.0]}),
    Row("SectionInvert", 0, area(DISC - 0.25), **BOX, SectionLength=[0.5, 0.5, 0.0]),
    Row("SectionOrigin", [0.25, 0.0, 0.0], area(DISC - SEGMENT), **PLANE),
    Row("SectionNormal", [0.0, 2.0, 0.0], moved(2.0 / (3.0 * numpy.pi), -2.0 / (3.0 * numpy.pi)), **PLANE),
    Row("SectionThickness", 0.5, area(DISC - 2.0 * SEGMENT), **PLANE),
    Row("SectionPosition", [0.0, 0.05, -0.1], moved(0.1, 0.15), **{**BOX, "SectionPosition": [-0.1] * 3}, SectionLength=[0.2] * 3),
    Row("SectionRotation", [0.0, 0.0, 45.0], moved(-0.1, 0.1 * (numpy.sqrt(2.0) - 1.0)), **{**BOX, "SectionPosition": [-0.1] * 3}, SectionLength=[0.2] * 3),
    Row("SectionLength", [0.25, 0.5, 0.5], area(0.125), **BOX, **{"SectionLength": [0.5] * 3}),
    Row("SectionCaps", "Whole Glyphs", area(DISC), kinds=[GLYPHS, TUBES], **{**PLANE, "SectionOrigin": [0.25, 0.0, 0.0]}),
    Row("SectionCaps", "Colored Caps", colors(GREEN), SectionCapColor=GREEN, **{**PLANE, "SectionNormal": [0.0, 0.0, 1.0]}),
    Row("SectionCaps", "Open", light(0.0, 0.9), **{**OCCLUSION, **PLANE, "SectionNormal": [0.0, 0.0, 1.0]}),
    Row("SectionCapColor", GREEN, colors(GREEN), SectionCaps="Colored Caps", **{**PLANE, "SectionNormal": [0.0, 0.0, 1.0]}),
    # Color and light as on ParaView's own surfaces
    Row("Visibility", 0, area(0.0)),
    Row("ColorArrayName", ["POINTS", "size"], colors(RED, BLUE), scene="two", LookupTable=RED_TO_BLUE),
    Row("LookupTable", ALL_GREEN, colors(GREEN, GREEN), scene="two", ColorArrayName=["POINTS", "size"], **{"LookupTable": RED_TO_BLUE}),
    Row("MapScalars", 0, colors(GREEN), ColorArrayName=["POINTS", "green"], LookupTable=RED_TO_BLUE),
    Row("InterpolateScalarsBeforeMapping", 0, as_surface, kinds=[SURFACE], scene="coarse", ColorArrayName=["POINTS", "height"],
        LookupTable=table("heights", (-0.5, RED), (-0.1, GREEN), (0.1, BLUE), (0.5, RED))),
    Row("InterpolateScalarsBeforeMapping", 0, colors(RED), kinds=[TUBES], scene="coarse", ColorArrayName=["POINTS", "height"],
        LookupTable=table("heights", (-0.5, RED), (-0.1, GREEN), (0.1, BLUE), (0.5, RED))),
    Row("InterpolateScalarsBeforeMapping", 0, as_before, kinds=[GLYPHS]),
    Row("Opacity", 0.5, colors([1.0, 0.75, 1.0]), AmbientColor=[1.0] * 3, DiffuseColor=[1.0] * 3),
    Row("AmbientColor", GREEN, colors(GREEN)),
    Row("DiffuseColor", [0.0, 0.5, 0.9], as_surface),
    Row("SpecularColor", RED, as_surface, **SHINY),
    Row("Ambient", 0.5, as_surface, Diffuse=0.4),
    Row("Diffuse", 0.5, as_surface),
    Row("Specular", 0.5, as_surface, SpecularPower=20.0),
    Row("SpecularPower", 20.0, as_surface, **{**SHINY, "SpecularPower": 100.0}),
    Row("Interpolation", "Flat", as_surface, kinds=[SURFACE], scene="coarse"),
    Row("NonlinearSubdivisionLevel", 3, as_surface, kinds=[SURFACE], scene="curved"),
    # Place
    Row("Position", [0.2, 0.1, 0.0], moved(0.2, 0.1)),
    Row("Translation", [0.2, 0.1, 0.0], moved(0.2, 0.1)),
    Row("Scale", [1.2, 0.6, 1.0], area(0.72 * DISC), kinds=[GLYPHS, SURFACE]),
    Row("Scale", [0.8] * 3, area(0.64 * DISC), kinds=[TUBES]),
    Row("Orientation", [0.0, 0.0, 90.0], moved(0.4, -0.4), scene="small"),
    Row("Orientation", [20.0, 50.0, 40.0], as_3d_glyphs(), kinds=[GLYPHS], scene="two"),
    Row("Origin", [-0.2, 0.1, 0.0], moved(-0.1, 0.3), scene="small", Orientation=[0.0, 0.0, 90.0]),
    Row("UserTransform", [1.0, 0.0, 0.0, 0.1, 0.0, 1.0, 0.0, 0.2, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0], moved(0.1, 0.2)),
    Row("Pickable", 0, picked),
    Row("BlockSelectors", [FIRST], area(DISC, 0.0), scene="blocks"),
    Row("BlockColors", [SECOND, "0", "1", "0"], colors([0.8] * 3, GREEN), scene="blocks"),
    Row("BlockOpacities", [SECOND, "0.5"], colors([0.8] * 3, [0.25 + 0.75 * 0.8, 0.75 * 0.8, 0.25 + 0.75 * 0.8]), scene="blocks"),
    # Light from all around
    Row("RenderingQuality", "Fast", reads("SamplesPerPixel", 4), back=False),
    Row("ShadingMode", "Path Tracing", light_of_ball(lambda cosine: [GRAY] * 3), kinds=[GLYPHS, SURFACE, TUBES], **{"ShadingMode": "Local"}),
    Row("ShadingMode", "Ambient Occlusion", as_with(**FLAT), **UNIFORM),
    Row("AmbientOcclusionRadius", 1e-3, as_with(**FLAT), scene="crowd", **OCCLUSION),
    Row("Metallic", 1.0, light_of_ball(lambda cosine: [schlick(DARK, cosine)] * 3), **MIRROR),
    Row("Roughness", 0.9, light(0.3, 0.9), **{**MIRROR, "Metallic": 1.0}),
    Row("CoatStrength", 0.5, light_of_ball(lambda cosine: [0.5 * schlick(1.0 / 9.0, cosine)] * 3), **{**COATED, "CoatStrength": 0.0}),
    Row("CoatIOR", 3.0, light_of_ball(lambda cosine: [schlick(0.25, cosine)] * 3), **COATED),
    Row("CoatIOR", 1.0, light_of_ball(lambda cosine: [0.0] * 3), **COATED),
    Row("CoatRoughness", 0.9, light(0.3, 0.9), **COATED),
    Row("CoatColor", RED, light_of_ball(lambda cosine: [GRAY, 0.0, 0.0]), **{**COATED, "CoatIOR": 1.0, "DiffuseColor": [0.8] * 3}),
    Row("Illumination", "Uniform", light_of_ball(lambda cosine: [GRAY] * 3), **{"Illumination": "Studio"}),
    Row("Illumination", "Lights of the View", as_with(ShadingMode="Local"), **{**OCCLUSION, "Illumination": "Studio", "ToneMapping": "None"}),
    Row("Shadows", 1, light(0.6, 0.97), scene="crowd"),
    Row("Shadows", 1, light(0.6, 0.99), scene="crowd", **{**OCCLUSION, "Illumination": "Studio"}),
    Row("ShadowSoftness", 45.0, softer, scene="crowd", **{**SHADOWS, "ShadowSoftness": 0.0}),
    Row("GroundShadow", "Across Z", caught(0.01, 0.3), **SHADOWS),
    Row("GroundShadow", "Below", caught(0.05, 0.5, tilt=True), **OCCLUSION),
    Row("GroundShadow", "Across Z", caught(0.05, 0.6), **PATHS),
    Row("ToneMapping", "Filmic", developed(filmic)),
    Row("ToneMapping", "Filmic", light_of_ball(lambda cosine: [filmic(GRAY)] * 3)),
    Row("Exposure", -1.0, developed(lambda light: 0.5 * light)),
    Row("Exposure", -1.0, light_of_ball(lambda cosine: [0.5 * GRAY] * 3)),
    Row("OutlineWidth", 3.0, outlined(BLACK, 3.0), **UNLIT),
    Row("OutlineColor", GREEN, outlined(GREEN, 3.0), OutlineWidth=3.0, **{**UNLIT, "DiffuseColor": RED, "AmbientColor": RED}),
    Row("DepthCue", 0.5, faded, **UNLIT),
    # The image
    Row("SamplesPerPixel", 3, reads("AccumulatedSamples", 3)),
    Row("Denoising", "Always", noise(0.0, 0.6, Denoising="Never", SamplesPerPixel=64), scene="crowd", **{**PATHS, "SamplesPerPixel": 1}),
    Row("FeatureImageFile", LEFT, written),
    Row("StopRefinement", LEFT, stopped),
    Row("SamplesPerRender", LEFT, steps),
    # The rest is for several ranks (parallel.py).
    Row("ParallelLight", "Neighbors", as_before),
    # Information
    Row("RenderStatistics", LEFT, statistics_say),
]
#: names of one property: only one of them exists in each ParaView
EITHER = {"Position": "Translation", "Translation": "Position"}


#: which displays have under another name, or which need time steps, and what tests them
ELSEWHERE = {"Color": "SelectionColor in selection_seen.py", "TrailSteps": "trails.py", "TrailFading": "trails.py"}


def exposed():
    """Property -> (representations that have it, its XML element)."""
    contents = property_reference.contents()
    return {name: ({GLYPHS, SURFACE, TUBES} & contents.get(entry.get("name"), {GLYPHS, SURFACE, TUBES}), entry)
            for _, entries in property_reference.sections() for name, entry in entries if name not in ELSEWHERE}


def inherited():
    """Those with a row of ParaView's own surface's properties, which all representations have."""
    surface = pv.servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("internal_representations", "SurfaceRepresentationBase")
    return {row.name: {GLYPHS, SURFACE, TUBES} for row in ROWS
            if surface.GetProperty(row.name) or surface.GetProperty(EITHER.get(row.name, row.name))}


def completeness(checks):
    """Each property of the plugin has a row for each of its representations, each row a property. What holds for a view is the same for all of its displays,
    which ViewSettings tests: one representation is enough."""
    image = property_reference.properties()[-1]
    known = {name: {GLYPHS} if name in image else kinds for name, (kinds, _) in exposed().items()}
    for name, kinds in known.items():
        for kind in sorted(kinds):
            checks.true("%s of %s has no row in every_property.py" % (name, kind),
                        any(row.name == name and kind in (row.kinds or kinds) for row in ROWS))
    known = {**inherited(), **known}
    for name in sorted({row.name for row in ROWS}):
        checks.true("every_property.py has a row of %s, which the XML does not have" % name, name in known)
    return known


def main(names):
    """All rows, or those of a representation, or of some properties."""
    kinds = [name for name in names if name in (GLYPHS, SURFACE, TUBES)] or [GLYPHS, SURFACE, TUBES]
    names = [name for name in names if name not in kinds]
    session.load()
    checks = Checks()
    bench = Bench(checks)
    known = completeness(checks)
    for row in ROWS:
        if names and row.name not in names:
            continue
        for kind in [kind for kind in kinds if kind in (row.kinds or known.get(row.name, ()))]:
            if bench.display(row.scene, kind).SMProxy.GetProperty(row.name) is None:
                checks.true("%s has no property %s" % (kind, row.name), row.name in EITHER)
                continue
            failures = len(checks.failures)
            change = Change(bench, row, kind)
            row.claim(change)
            if row.back and row.value is not LEFT:
                change.goes_back()
            if len(checks.failures) > failures:
                change.keep_pictures()
    checks.report()


if __name__ == "__main__":
    main(sys.argv[1:])
