"""Every field of the settings and every array, changed one at a time: exactly the work that it must cause is done.

Usage: pvpython work_of_changes.py SOURCE

SOURCE is the folder with Kernels and Representation. Fields are read out of the headers: a new one is changed as the row of
its property in every_property.py says, and must build the glyphs anew, unless it has an entry in FIELDS. So are the arrays
of GlyphArrays::All(), of which each has an entry.
"""
import json
import os
import re
import sys

import numpy
import paraview.simple as pv

import session
from checks import Checks
from every_property import ROWS

#: what some change may move; of all else of RenderStatistics nothing that counts may
KINDS = {
    "nothing": set(),
    # another image of the same scene
    "image": {"dispatches", "primaryRays"},
    # the same of glyphs that are drawn among the translucent ones from now on
    "pass": {"dispatches", "primaryRays", "topLevelBuilds"},
    # the image at hand, displayed otherwise
    "display": set(),
    "colors": {"colorBuilds", "colorUploads", "dispatches", "primaryRays"},
    # glyphs that have no colors of their own until then: other programs show them
    "first colors": {"colorBuilds", "colorUploads", "dispatches", "primaryRays", "topLevelBuilds"},
    # glyphs that may lie elsewhere or be of another size
    "glyphs": {"boundsBuilds", "instanceBuilds", "colorBuilds", "instanceUploads", "colorUploads", "structureBuilds", "topLevelBuilds",
               "sorts", "dispatches", "primaryRays"},
}
#: of these at least one moves, where the kind has them
MUST = {"image": {"dispatches"}, "pass": {"dispatches"}, "colors": {"colorBuilds", "colorUploads"},
        "first colors": {"colorBuilds", "colorUploads"}, "glyphs": {"instanceBuilds", "instanceUploads"}}
#: bytes and seconds are no counts; programs are compiled when they are first needed
UNCOUNTED = re.compile("Seconds$|^deviceBytes$|^pipelineBuilds$|^programsAhead$|^DeviceName$|^AccumulatedSamples$|^Refinement|^pulls$|^choices$|lyphs$")

ARROW = {"GlyphType": "Arrow", "ScaleMode": "Magnitude", "SelectScaleArray": "length", "ArrowHeads": "Fixed"}
TENSOR = {"GlyphShape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor"}
#: whose programs take long to compile
SUPERQUADRIC = {"GlyphShape": "Tensor Superquadric", "GlyphTensorArray": "tensor"}
FORMS = {"GlyphShape": "Normal Stress", "GlyphTensorArray": "tensor"}
BALLS = {"GlyphShape": "Spherical Harmonics", "GlyphHarmonicsArray": "six"}
SIGNS = {**TENSOR, "GlyphTensorColoring": "Sign"}
MOTION = {"MotionBlur": 1, "VelocityArray": "velocity", "AngularVelocityArray": "spin", "GlyphType": "Box"}
EXPONENTS = {"GlyphShape": "Superquadric"}
MASK = {"GlyphMode": "Random", "MaximumNumberOfGlyphs": 100}
NTH = {"GlyphMode": "Every Nth"}
TABLE = {"UseGlyphTable": 1, "UseCompositeGlyphTable": 1, "GlyphTableIndexArray": "index"}
OCCLUSION = {"ShadingMode": "Ambient Occlusion"}
PATHS = {"ShadingMode": "Path Tracing"}
PLANE = {"Section": "Plane"}
BOXED = {"PeriodicBoundary": 1, "PeriodicVectors": [3.0, 0, 0, 0, 3.0, 0, 0, 0, 3.0], "PeriodicImages": [1, 0, 0]}

#: field -> (properties to start from, property, its new value, kind) or a list of such, or why there is nothing to test
FIELDS = {
    "GlyphSettings": {
        "Shape": [({}, "GlyphShape", "Capsule", "glyphs"), ({}, "GlyphType", "Box", "new data")],
        "UnitSize": ({"GlyphType": "Cylinder"}, "GlyphType.Height", 2.0, "new data"),
        "Scaling": [({"SelectScaleArray": "length"}, "ScaleMode", "Magnitude", "glyphs"), ({}, "Scaling", 0, "glyphs")],
        "ScaleArray": [({"ScaleMode": "Magnitude", "SelectScaleArray": "length"}, "SelectScaleArray", "other", "glyphs"),
                       ({"SelectScaleArray": "length"}, "SelectScaleArray", "other", "nothing")],
        "ScaleMode": [({"ScaleMode": "Magnitude", "SelectScaleArray": "lengths"}, "ScaleMode", "Vector Components", "glyphs"),
                      ({"Scaling": 0}, "ScaleMode", "Vector Components", "nothing")],
        "ScaleFactor": ({}, "ScaleFactor", 0.2, "glyphs"),
        "Sizing": "GlyphSizing",
        "Orient": ({"GlyphType": "Box", "SelectOrientationVectors": "velocity"}, "Orient", 1, "glyphs"),
        "OrientationArray": [({"GlyphType": "Box", "Orient": 1, "SelectOrientationVectors": "velocity"},
                              "SelectOrientationVectors", "spin", "glyphs"),
                             ({"GlyphType": "Box"}, "SelectOrientationVectors", "spin", "nothing")],
        "OrientationMode": [({"GlyphType": "Box", "Orient": 1, "SelectOrientationVectors": "velocity"},
                             "OrientationMode", "Rotation", "glyphs"),
                            ({}, "OrientationMode", "Rotation", "nothing")],
        "Arrow": "GlyphSettings::ArrowForm",
        "ArrowReference": [(ARROW, "ArrowReferenceMagnitude", 3.0, "glyphs"), ({}, "ArrowReferenceMagnitude", 3.0, "nothing")],
        "ScalePercentile": (ARROW, "SelectScaleArray", "other", "glyphs"),
        "Mesh": ({"GlyphType": lambda: session.triangles(pv.Box())}, "GlyphType", lambda: session.triangles(pv.Cone()), "new data"),
        "TableSize": ({**TABLE, "UseCompositeGlyphTable": 0}, "UseCompositeGlyphTable", 1, "new data"),
        "TableEntry": "each form of a table has its own; see TableSize",
        "TableIndexArray": [(TABLE, "GlyphTableIndexArray", "other index", "glyphs"),
                            ({}, "GlyphTableIndexArray", "index", "nothing")],
        "Tensors": "GlyphTensors::Settings",
        "Forms": "GlyphForms::Settings",
        "Exponents": [(EXPONENTS, "GlyphExponents", [1.0, 2.0, 2.0], "glyphs"), ({}, "GlyphExponents", [1.0, 2.0, 2.0], "nothing")],
        "ExponentArray": [(EXPONENTS, "GlyphExponentArray", "length", "glyphs"), ({}, "GlyphExponentArray", "length", "nothing")],
        "OpacityArray": ({"GlyphOpacityArray": "length"}, "GlyphOpacityArray", "other", "glyphs"),
        "DirectionColoring": [({"Orient": 1, "SelectOrientationVectors": "velocity"}, "GlyphDirectionColoring", "Sphere", "first colors"),
                              ({"GlyphDirectionColoring": "Axes", **TENSOR}, "GlyphDirectionColoring", "Sphere", "nothing"),
                              (FORMS, "GlyphDirectionColoring", "Axes", "glyphs")],
        "Motion": "GlyphMotion::Settings",
        "TrailSteps": "needs time steps; see trails.py",
        "TrailJoined": "needs time steps; see trails.py",
        "Shell": "of shells beside glyphs, whose settings are the glyphs' own",
        "Frame": [(ARROW, "GlyphShape", "Split Vector", "glyphs"), ({**ARROW, "GlyphShape": "Split Vector"}, "SelectScaleArray", "other", "nothing"),
                  (TENSOR, "GlyphShape", "Principal Axes", "glyphs"), (TENSOR, "GlyphShape", "Confidence Ellipsoid", "glyphs")],
        "Opacity": "of layers around glyphs",
        "TrailFading": "needs time steps; see trails.py",
        "Mask": "GlyphMask",
        "RadiusArray": [({}, "GlyphRadiusArray", "length", "glyphs"), (TENSOR, "GlyphRadiusArray", "length", "nothing")],
        "Anchor": [(ARROW, "GlyphAnchor", "Tip", "glyphs"), (TENSOR, "GlyphAnchor", "Tip", "nothing")],
    },
    "GlyphMask": {
        "On": ({"MaximumNumberOfGlyphs": 100}, "GlyphMode", "Random", "glyphs"),
        "Mode": [(MASK, "GlyphMode", "Even in Space", "glyphs"), (MASK, "GlyphMode", "Every Nth", "glyphs")],
        "MaximumNumberOfGlyphs": [(MASK, "MaximumNumberOfGlyphs", 90, "glyphs"), ({}, "MaximumNumberOfGlyphs", 90, "nothing"),
                                  (NTH, "MaximumNumberOfGlyphs", 90, "nothing")],
        "Stride": [(NTH, "GlyphStride", 7, "glyphs"), (MASK, "GlyphStride", 7, "nothing")],
        "PointsOfAllRanks": "counted from the data; see parallel.py",
    },
    "ArrowForm": {
        "shaftRadius": [(ARROW, "GlyphType.ShaftRadius", 0.06, "new data")],
        "tipRadius": [(ARROW, "GlyphType.TipRadius", 0.2, "new data")],
        "tipLength": [(ARROW, "GlyphType.TipLength", 0.5, "new data")],
        "tipRounding": "of fixed heads; see fixedHeads",
        "fixedHeads": [(ARROW, "ArrowHeads", "Scaled", "glyphs"), ({}, "ArrowHeads", "Scaled", "nothing")],
        "unitLength": "computed from the scales; see ScalePercentile",
    },
    "GlyphSizing": {
        "Function": ({"ScaleMode": "Magnitude", "SelectScaleArray": "length"}, "GlyphScaleFunction", "Square Root", "glyphs"),
        "Least": ({}, "GlyphSizeRange", [0.15, 0.0], "glyphs"),
        "Most": ({}, "GlyphSizeRange", [0.0, 0.05], "glyphs"),
    },
    "GlyphTensors::Settings": {
        "On": (TENSOR, "GlyphShape", "None", "glyphs"),
        "Kind": (SUPERQUADRIC, "GlyphShape", "Signed Tensor Superquadric", "glyphs"),
        "Array": [(TENSOR, "GlyphTensorArray", "other tensor", "glyphs"), ({}, "GlyphTensorArray", "tensor", "nothing")],
        "Layout": [({**TENSOR, "GlyphTensorArray": "six"}, "GlyphTensorLayout", "xx xy xz yy yz zz", "glyphs"), ({}, "GlyphTensorLayout", "xx xy xz yy yz zz", "nothing")],
        "Sharpness": [(SUPERQUADRIC, "GlyphTensorSharpness", 1.0, "glyphs"), (TENSOR, "GlyphTensorSharpness", 1.0, "nothing")],
        "Coloring": [({**TENSOR, "GlyphTensorColoring": "Trace"}, "GlyphTensorColoring", "Fractional Anisotropy", "colors"), ({}, "GlyphTensorColoring", "Trace", "nothing"),
                     ({**TENSOR, "GlyphTensorColoring": "Trace"}, "GlyphTensorColoring", "Eigenvalues", "colors"),
                     (TENSOR, "GlyphTensorColoring", "Sign", "glyphs")],
        "PositiveColor": [(SIGNS, "GlyphTensorLookupTable", lambda: session.signs((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "image"),
                          (TENSOR, "GlyphTensorLookupTable", lambda: session.signs((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "nothing")],
        "NegativeColor": (SIGNS, "GlyphTensorLookupTable", lambda: session.signs((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)), "image"),
        "Axes": "of arrows beside the glyphs, whose settings are the glyphs' own",
        "Covariances": "of confidence ellipsoids; see Frame",
        "Confidence": [({**TENSOR, "GlyphShape": "Confidence Ellipsoid"}, "GlyphConfidence", 0.5, "glyphs"), (TENSOR, "GlyphConfidence", 0.5, "nothing")],
    },
    "GlyphForms::Settings": {
        "On": (FORMS, "GlyphShape", "None", "glyphs"),
        "Kind": ({**FORMS, "GlyphTensorArray": "six", "GlyphHarmonicsArray": "six"}, "GlyphShape", "Spherical Harmonics", "glyphs"),
        "Array": [(FORMS, "GlyphTensorArray", "other tensor", "glyphs"), ({}, "GlyphHarmonicsArray", "six", "nothing")],
        "Layout": [({**FORMS, "GlyphTensorArray": "six"}, "GlyphTensorLayout", "xx xy xz yy yz zz", "glyphs"), (BALLS, "GlyphTensorLayout", "xx xy xz yy yz zz", "nothing")],
        "Basis": [(BALLS, "GlyphHarmonicsBasis", "DIPY", "glyphs"), (FORMS, "GlyphHarmonicsBasis", "DIPY", "nothing")],
        "Coloring": [(FORMS, "GlyphTensorColoring", "Sign", "glyphs"), (FORMS, "GlyphTensorColoring", "Radius", "first colors"), (FORMS, "GlyphTensorColoring", "Trace", "nothing")],
    },
    "GlyphMotion::Settings": {
        "On": ({**MOTION, "MotionBlur": 0}, "MotionBlur", 1, "glyphs"),
        "Velocity": [(MOTION, "VelocityArray", "spin", "glyphs"), ({}, "VelocityArray", "velocity", "nothing")],
        "Acceleration": [(MOTION, "AccelerationArray", "spin", "glyphs"), ({}, "AccelerationArray", "spin", "nothing")],
        "AngularVelocity": [(MOTION, "AngularVelocityArray", "None", "glyphs"), ({}, "AngularVelocityArray", "spin", "nothing")],
        "Mask": [(MOTION, "MotionBlurMask", "index", "glyphs"), ({}, "MotionBlurMask", "index", "nothing")],
        "ShutterTime": [(MOTION, "ShutterTime", 0.5, "glyphs"), ({}, "ShutterTime", 0.5, "nothing")],
        "Opening": [(MOTION, "ShutterOpening", "Forward", "glyphs"), ({}, "ShutterOpening", "Forward", "nothing")],
    },
    "RayTracedImageSettings": {
        "ShadingMode": ({}, "ShadingMode", "Ambient Occlusion", "image"),
        "AmbientOcclusionRadius": [(OCCLUSION, "AmbientOcclusionRadius", 0.1, "image"), ({}, "AmbientOcclusionRadius", 0.1, "nothing")],
        "Illumination": [(PATHS, "Illumination", "Uniform", "image"), (OCCLUSION, "Illumination", "Uniform", "image"),
                         ({}, "Illumination", "Uniform", "nothing")],
        "Shadows": [({}, "Shadows", 1, "image"), (PATHS, "Shadows", 1, "nothing")],
        "ShadowSoftness": [({"Shadows": 1}, "ShadowSoftness", 5.0, "image"), ({}, "ShadowSoftness", 5.0, "nothing")],
        "GroundShadow": [(OCCLUSION, "GroundShadow", "Below", "image"), ({}, "GroundShadow", "Below", "image")],  # programs compiled ahead have it
        "OutlineWidth": ({}, "OutlineWidth", 2.0, "display"),
        "OutlineColor": ({"OutlineWidth": 2.0}, "OutlineColor", [1.0, 0.0, 0.0], "display"),
        "DepthCue": ({}, "DepthCue", 0.5, "display"),
        "ToneMapping": (PATHS, "ToneMapping", "Filmic", "image"),
        "Exposure": (PATHS, "Exposure", 1.0, "image"),
        "Denoising": ({**PATHS, "Denoising": "Always"}, "Denoising", "Never", "display"),
        "SamplesPerPixel": [({}, "SamplesPerPixel", 3, "image"), (PATHS, "SamplesPerPixel", 3, "image")],
        "SamplesPerRender": "internal; see every_property.py",
        "ParallelLight": ({}, "ParallelLight", "Neighbors", "nothing"),
    },
    "Material": {
        "color": ({}, "DiffuseColor", [1.0, 0.0, 0.0], "image"),
        "ambientColor": (PATHS, "AmbientColor", [1.0, 0.0, 0.0], "image"),
        "specularColor": (PATHS, "SpecularColor", [1.0, 0.0, 0.0], "image"),
        "positiveColor": "GlyphTensors::Settings has it",
        "negativeColor": "GlyphTensors::Settings has it",
        "ambient": ({}, "Ambient", 0.3, "image"),
        "diffuse": ({}, "Diffuse", 0.3, "image"),
        "specular": ({}, "Specular", 0.3, "image"),
        "specularPower": ({"Specular": 0.3}, "SpecularPower", 10.0, "image"),
        "opacity": ({}, "Opacity", 0.5, "pass"),
        "lighting": "no property of a representation's",
        "metallic": (PATHS, "Metallic", 0.5, "image"),
        "roughness": (PATHS, "Roughness", 0.9, "image"),
        "coatStrength": (PATHS, "CoatStrength", 0.5, "image"),
        "coatRoughness": ({**PATHS, "CoatStrength": 0.5}, "CoatRoughness", 0.5, "image"),
        "coatIor": ({**PATHS, "CoatStrength": 0.5}, "CoatIOR", 1.5, "image"),
        "coatColor": ({**PATHS, "CoatStrength": 0.5}, "CoatColor", [1.0, 0.0, 0.0], "image"),
        "section": "RayTracedSection",
    },
    "RayTracedPeriodic": {
        "Boundary": (BOXED, "PeriodicBoundary", 0, "pass"),
        "Vectors": [(BOXED, "PeriodicVectors", [2.0, 0, 0, 0, 2.0, 0, 0, 0, 2.0], "pass"), ({}, "PeriodicVectors", [2.0] * 9, "nothing")],
        "Images": [(BOXED, "PeriodicImages", [0, 1, 0], "pass"), ({}, "PeriodicImages", [0, 1, 0], "nothing")],
    },
    "RayTracedSection": {
        "Kind": ({}, "Section", "Plane", "image"),
        "Face": [(PLANE, "SectionCaps", "Open", "image"), ({}, "SectionCaps", "Open", "nothing")],
        "Invert": [(PLANE, "SectionInvert", 0, "image"), ({}, "SectionInvert", 0, "nothing")],
        "Thickness": [(PLANE, "SectionThickness", 0.5, "image"), ({}, "SectionThickness", 0.5, "nothing")],
        "Origin": [(PLANE, "SectionOrigin", [0.1, 0.0, 0.0], "image"), ({}, "SectionOrigin", [0.1, 0.0, 0.0], "nothing")],
        "Normal": [(PLANE, "SectionNormal", [0.0, 1.0, 0.0], "image"), (PLANE, "SectionNormal", [2.0, 0.0, 0.0], "nothing")],
        "Position": [({"Section": "Box"}, "SectionPosition", [0.1, 0.0, 0.0], "image"), (PLANE, "SectionPosition", [0.1, 0.0, 0.0], "nothing")],
        "Rotation": ({"Section": "Box"}, "SectionRotation", [0.0, 10.0, 0.0], "image"),
        "Length": ({"Section": "Box"}, "SectionLength", [0.5, 0.5, 0.5], "image"),
        "CapColor": [({**PLANE, "SectionCaps": "Colored Caps"}, "SectionCapColor", [1.0, 0.0, 0.0], "image"),
                     (PLANE, "SectionCapColor", [1.0, 0.0, 0.0], "nothing")],
    },
}
#: what GlyphArrays::All() returns, in its order -> (properties, array that the data have anew; None: positions)
ARRAYS = {
    "GetPoints": ({}, None),
    "CompositeIndex": "no array of the user's: it is new where the blocks are",
    "Scale": ({"ScaleMode": "Magnitude", "SelectScaleArray": "length"}, "length"),
    "Orientation": ({"GlyphType": "Box", "Orient": 1, "SelectOrientationVectors": "velocity"}, "velocity"),
    "Exponents": ({**EXPONENTS, "GlyphExponentArray": "length"}, "length"),
    "Opacity": ({"GlyphOpacityArray": "length"}, "length"),
    "Radius": ({"GlyphRadiusArray": "length"}, "length"),
    "TableIndex": (TABLE, "index"),
    "Tensors": (TENSOR, "tensor"),
    "Forms": (BALLS, "six"),
    "motion[0]": (MOTION, "velocity"),
    "motion[1]": ({**MOTION, "AccelerationArray": "spin", "AngularVelocityArray": "None"}, "spin"),
    "motion[2]": (MOTION, "spin"),
    "motion[3]": ({**MOTION, "MotionBlurMask": "index"}, "index"),
    "Trail": "comes with time steps; see trails.py",
}
#: struct -> header
HEADERS = {
    "GlyphSettings": "Representation/Glyphs/GlyphSettings.h",
    "GlyphMask": "Representation/Glyphs/GlyphMask.h",
    "GlyphSizing": "Representation/Glyphs/GlyphSizing.h", "ArrowForm": "Kernels/Glyphs.h", "Material": "Kernels/Glyphs.h",
    "GlyphTensors::Settings": "Representation/Glyphs/GlyphTensors.h",
    "GlyphForms::Settings": "Representation/Glyphs/GlyphForms.h",
    "GlyphMotion::Settings": "Representation/Glyphs/GlyphMotion.h",
    "RayTracedImageSettings": "Representation/Scene/RayTracedImageSettings.h",
    "RayTracedPeriodic": "Representation/Representations/RayTracedPeriodic.h",
    "RayTracedSection": "Representation/Representations/RayTracedSection.h",
}
POINTS = 400


def fields_of(path, struct):
    """Names of the fields of a struct in a header, and of its base there."""
    with open(path) as header:
        text = re.sub(r"//[^\n]*|/\*.*?\*/", "", header.read(), flags=re.S)
    head = re.search(r"\bstruct\s+%s(?:\s*:\s*(\w+))?\s*\{" % struct.split("::")[-1], text)
    start, depth, body = head.end(), 1, ""
    for letter in text[start:]:
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if depth == 0:
            break
        body += letter if depth == 1 else " "
        body += ";" if letter == "}" and depth == 1 and "(" in body.split(";")[-1] else ""  # the end of a function
    names = fields_of(path, head.group(1)) if head.group(1) else []
    for statement in body.split(";"):
        statement = statement.strip().rstrip("} ")
        if "(" in statement.split("=")[0] or re.match(r"(enum|static|bool operator|struct)\b", statement):
            continue
        found = re.match(r"[\w:<>,&\s]+?[\s>](\w+)\s*(\[\d+\])?\s*(=|$)", " ".join(statement.split("{")[0].split()) if statement else "")
        if found:
            names.append(found.group(1))
    return names


def data(changed=None):
    """Points with arrays; one of them, or None's positions, may differ."""
    random = numpy.random.default_rng(1)
    arrays = {"": random.uniform(-1.0, 1.0, (POINTS, 3)), "length": random.uniform(0.5, 2.0, POINTS),
              "other": random.uniform(0.3, 1.0, POINTS), "lengths": random.uniform(0.5, 2.0, (POINTS, 3)),
              "velocity": random.normal(size=(POINTS, 3)), "spin": random.normal(size=(POINTS, 3)),
              "tensor": random.normal(size=(POINTS, 9)), "other tensor": random.normal(size=(POINTS, 9)),
              "six": random.normal(size=(POINTS, 6)), "index": random.integers(0, 2, POINTS).astype(numpy.int32),
              "other index": random.integers(0, 2, POINTS).astype(numpy.int32), "color": random.uniform(0.0, 1.0, POINTS)}
    if changed is not None:
        arrays[changed] = numpy.roll(arrays[changed], 1, axis=0)
    return session.poly_data(arrays.pop(""), **arrays)


class Bench:
    """One view, one source, and the counters."""

    def __init__(self, checks):
        self.checks = checks
        self.source = session.source(data())
        self.table = pv.GroupDatasets(Input=[pv.Cone(Resolution=5), pv.Box()])
        self.view = session.view(32, 24)
        self.shown = session.glyphs(self.source, self.view)
        self.shown.ColorArrayName = [None, ""]
        self.settings = session.Settings(self.shown)
        session.look(self.view, (0.0, 0.0, 5.0))

    def show(self, properties):
        """The display of the glyphs with these properties, and otherwise those of a fresh one; rendered."""
        if properties.get("GlyphTableIndexArray"):
            properties = {**properties, "GlyphType": self.table}
        self.settings.set({"Orient": 0, "ScaleFactor": 0.1, "GlyphType": "Sphere", "Scaling": 1, "ScaleMode": "No Data Scaling Off", "SamplesPerPixel": 2, "Denoising": "Never",
                           "ShadingMode": "Local", **properties})
        pv.Render(self.view)
        pv.Render(self.view)
        return self.shown

    def expect(self, what, properties, change, kind):
        """Makes the change, of properties or by a function, and compares what has moved with what the kind says."""
        shown = self.show(properties)
        before = session.statistics(shown)
        if callable(change):
            change()
        else:
            self.settings.add(change)
        pv.Render(self.view)
        alive = json.loads(shown.SMProxy.GetProperty("RenderStatistics").GetElement(0))
        after = session.statistics(shown)
        for name in ("dispatches", "AccumulatedSamples", "glyphs"):
            self.checks.equal("%s: %s until RenderStatistics is updated" % (what, name), alive[name], after[name])
        moved = {name for name in after if not UNCOUNTED.search(name) and after[name] != before[name]}
        surplus = moved - KINDS[kind]
        missing = MUST.get(kind, set()) - moved
        print("%s (%s): %s" % (what, kind, ", ".join(sorted(moved)) or "nothing"))
        self.checks.true("%s: also %s" % (what, ", ".join(sorted(surplus))), not surplus)
        self.checks.true("%s: not %s" % (what, ", ".join(sorted(missing))), not missing)
        if kind in SAME_SHADERS:
            self.checks.equal(what + ": pipelineBuilds", after["pipelineBuilds"], before["pipelineBuilds"])


def main():
    """All fields, then all arrays."""
    session.load()
    checks = Checks()
    for struct, header in HEADERS.items():
        found = fields_of(os.path.join(sys.argv[1], header), struct)
        checks.equal("fields that %s does not have" % struct, sorted(set(FIELDS[struct]) - set(found)), [])
        for field in set(found) - set(FIELDS[struct]):
            FIELDS[struct][field] = [(row.properties, row.name, row.value, "glyphs") for row in ROWS if row.name in (field, "Glyph" + field)]
            checks.true("%s::%s has neither an entry in FIELDS nor a row of its property in every_property.py" % (struct, field), FIELDS[struct][field])
    with open(os.path.join(sys.argv[1], "Representation/Glyphs/GlyphTuples.cxx")) as code:
        code = code.read()
    # The rows of its table, and the list that All() begins with.
    rows = len(re.findall(r"\{ &Settings::\w+", code))
    listed = re.search(r"GlyphArrays::All\(.*?all = \{(.*?)\};", code, flags=re.S).group(1)
    found = re.sub(r"\([^()]*(\([^()]*\)[^()]*)*\)", "", listed).split(",")
    checks.equal("arrays of GlyphArrays::All()", len(found) + rows, len(ARRAYS))

    bench = Bench(checks)
    for struct, fields in FIELDS.items():
        for field, entries in fields.items():
            if isinstance(entries, str):
                continue
            for properties, name, value, kind in entries if isinstance(entries, list) else [entries]:
                what = "%s::%s, %s = %s of %s" % (struct, field, name, value, properties.get("GlyphShape", properties.get("GlyphType", properties.get("ShadingMode", "Sphere"))))
                bench.expect(what, properties, {name: value}, kind)
    for name, entry in ARRAYS.items():
        if isinstance(entry, str):
            continue
        properties, changed = entry

        def give(changed=changed):
            # Only the one array is new: the others are those of the data at hand.
            old = bench.source.GetClientSideObject().GetOutputDataObject(0)
            new = old.NewInstance()
            new.ShallowCopy(old)
            other = data(changed or "")
            if changed:
                new.GetPointData().AddArray(other.GetPointData().GetArray(changed))
            else:
                new.SetPoints(other.GetPoints())
            session.replace_data(bench.source, new)

        bench.expect("array " + name, properties, give, "new data")
        # An array that no property names is no reason to build anything.
        session.replace_data(bench.source, data())

    def give_unused():
        old = bench.source.GetClientSideObject().GetOutputDataObject(0)
        new = old.NewInstance()
        new.ShallowCopy(old)
        new.GetPointData().AddArray(data("other").GetPointData().GetArray("other"))
        session.replace_data(bench.source, new)

    bench.expect("nothing", {}, {}, "nothing")
    bench.expect("camera", {}, lambda: session.look(bench.view, (1.0, 0.5, 5.0)), "camera")
    bench.expect("positions of balls", {}, lambda: session.replace_data(bench.source, data("")), "new balls")
    session.replace_data(bench.source, data())
    # Meshes, a table of them and a shape without a mesh stay whatever else changes.
    for properties in ({"GlyphType": lambda: session.triangles(pv.Cone(Resolution=6))}, TABLE, {"GlyphType": "Box"}):
        for name, value, kind in (("Pickable", 0, "nothing"), ("Specular", 0.4, "image"), ("Exposure", 0.5, "image"), ("SamplesPerPixel", 3, "image")):
            bench.expect("%s of %s" % (name, properties.get("GlyphType", "a table")), properties, {name: value}, kind)

    KINDS["gather"] = {"gathers"}
    bench.expect("array that is not shown", {}, give_unused, "gather")
    bench.expect("the same data again", {}, lambda: session.replace_data(bench.source, data()),
                 "again")
    pv.ColorBy(bench.shown, ("POINTS", "color"))
    bench.expect("color map", {}, lambda: bench.shown.LookupTable.ApplyPreset("Black-Body Radiation", True), "colors")
    checks.report()


#: another view of the same scene, and other points of it, which no other shaders show
KINDS["camera"], MUST["camera"] = KINDS["image"], MUST["image"]
KINDS["new balls"], MUST["new balls"] = KINDS["glyphs"] | {"gathers"}, MUST["glyphs"] | {"gathers", "structureBuilds"}
SAME_SHADERS = ("nothing", "display", "camera", "colors", "new balls")
#: points, or the mesh of glyphs, from the pipeline
KINDS["new data"] = KINDS["glyphs"] | {"gathers"}
MUST["new data"] = MUST["glyphs"] | {"gathers"}
#: the same numbers in other arrays: built again, and found to be the same
KINDS["again"] = {"gathers", "boundsBuilds", "instanceBuilds", "colorBuilds"}

if __name__ == "__main__":
    main()
