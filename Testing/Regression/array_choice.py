"""Defaults of the properties that name arrays are chosen by what the arrays are; spheres that a radius or diameter scales have
exactly that size.

Usage: RTGLYPHS_DATA=FOLDER pvpython array_choice.py
"""
import os

import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks

PROPERTIES = ("GlyphScaleArray", "GlyphOrientationArray", "GlyphTensorArray", "VelocityArray")
COUNT = 20
#: arrays as name:components, an active one with its attribute behind it -> the defaults of PROPERTIES
CASES = (
    ("", "None None None None"),
    ("id:1 type:1", "None None None None"),
    ("id:1 pressure:1", "pressure None None None"),
    ("a:1 b:1=Scalars", "b None None None"),
    ("b:1=Scalars radius:1", "radius None None None"),
    ("c_diameter:1 mass:1", "c_diameter None None None"),
    ("ParticleRadius:1", "ParticleRadius None None None"),
    ("radiation:1=Scalars radius:3", "radiation None None None"),
    ("a:3 velocity:3", "velocity velocity None velocity"),
    ("a:3=Vectors velocity:3", "a a None velocity"),
    ("force:3 displacement:3 angular_velocity:3 coords:3 omega:3", "displacement displacement None None"),
    ("omega:3 coords:3", "omega omega None None"),
    ("positions:3 EulerAngles:3 rgb:3 lengths:3", "None None None None"),
    ("positions:3 c_q:4 c_shape:3", "None c_q None None"),
    ("positions:3 quaternion:4 c_shape:3 thing:3", "thing quaternion None None"),
    ("positions:3 thing:3", "thing thing None None"),
    ("a:3 b:3 c:3 d:3 e:3 f:3 g:3 h:3 Normals:3 j:3", "f f None None"),
    ("V:3 Pres:1", "V V None V"),
    ("orientations:9 stress:6", "None None stress None"),
    ("rotation:9", "None None None None"),
    ("a:9 strain:9 b:9", "None None strain None"),
    ("a:9 strain:9 b:9=Tensors", "None None b None"),
    ("rotation:9 thing:6", "None None thing None"),
)


def data(arrays):
    """Points with random arrays."""
    random = numpy.random.default_rng(3)
    made = session.poly_data(random.uniform(size=(COUNT, 3)))
    for array in arrays.split():
        name, components = array.split("=")[0].split(":")
        components = int(components)
        session.add_arrays(made, **{name: random.uniform(size=(COUNT, components) if components > 1 else COUNT)})
        if "=" in array:
            getattr(made.GetPointData(), "SetActive" + array.split("=")[1])(name)
    return made


def choices(checks):
    """Each of the cases."""
    view = session.view(40, 30)
    for arrays, wanted in CASES:
        source = session.source(data(arrays))
        shown = session.glyphs(source, view)
        found = " ".join(str(shown.GetPropertyValue(name)).strip("'") or "None" for name in PROPERTIES)
        checks.equal("%s of [%s]" % (", ".join(PROPERTIES), arrays), found, wanted)
        pv.Delete(shown)
    colors = session.poly_data(numpy.zeros((3, 3)), light=numpy.zeros((3, 3), numpy.uint8))
    shown = session.glyphs(session.source(colors), view)
    checks.equal("GlyphOrientationArray of bytes", str(shown.GetPropertyValue("GlyphOrientationArray")).strip("'"), "None")
    pv.Delete(view)


def cells(checks):
    """With GlyphLocation the arrays are chosen among those of the cells, unless somebody has chosen one that is there."""
    view = session.view(40, 30)
    source = pv.Calculator(Input=pv.PointDatatoCellData(Input=pv.Wavelet(WholeExtent=[0, 3] * 3), PassPointData=1),
                           AttributeType="Cell Data", Function="RTData*iHat", ResultArrayName="force")
    for name, explicit, wanted in (("chosen by nobody", None, "force"), ("chosen", "None", "None"), ("chosen, wrong", "nonesuch", "nonesuch")):
        shown = session.glyphs(source, view)
        checks.equal("GlyphOrientationArray of points, " + name, shown.SMProxy.GetProperty("GlyphOrientationArray").GetElement(0), "None")
        shown.GlyphLocation = "Cells"
        if explicit:
            shown.GlyphOrientationArray = explicit
        shown.GlyphScaling = 1
        session.messages(lambda: pv.Render(view))
        checks.equal("GlyphOrientationArray of cells, " + name, shown.SMProxy.GetProperty("GlyphOrientationArray").GetElement(0), wanted)
        checks.equal("GlyphScaleArray of cells, " + name, shown.SMProxy.GetProperty("GlyphScaleArray").GetElement(0), "RTData")
        shown.GlyphLocation = "Points"
        session.messages(lambda: pv.Render(view))
        checks.equal("GlyphOrientationArray of points again, " + name,
                     shown.SMProxy.GetProperty("GlyphOrientationArray").GetElement(0), explicit or "None")
        pv.Delete(shown)
    pv.Delete(view)


def files(checks):
    """A legacy file without active vectors: arrows follow its velocity."""
    view = session.view(40, 30)
    shown = session.glyphs(pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact_04.vtk"), view)
    found = [str(shown.GetPropertyValue(name)).strip("'") for name in PROPERTIES]
    checks.equal("arrays of impact_04.vtk", found, ["diameter", "velocity", "stress", "velocity"])
    scale = shown.SMProxy.GetProperty("GlyphScaleArray")
    for name, value, wanted in (("GlyphShape", "Arrow", "velocity"), ("GlyphShape", "Box", "diameter"), ("GlyphScaling", 1, "diameter"),
                                ("GlyphShape", "Arrow", "diameter"), ("GlyphScaling", 0, "diameter"), ("GlyphShape", "Cone", "diameter"),
                                ("GlyphScaleArray", "acceleration", "acceleration"), ("GlyphShape", "Arrow", "acceleration")):
        setattr(shown, name, value)
        checks.equal("GlyphScaleArray of impact_04.vtk after %s = %s" % (name, value), scale.GetElement(0), wanted)
    pv.Delete(view)


def exact_sizes(checks):
    """Spheres of radius 1 and 2, far apart: the covered pixels are those of their disks."""
    width, height, scale = 300, 200, 5.0
    points = numpy.array([[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]])
    radii = numpy.array([1.0, 2.0])
    for name, values, factor in (("radius", radii, 2.0), ("my_diameter", 2.0 * radii, 1.0), ("Radius", radii, 2.0)):
        view = session.view(width, height)
        shown = session.glyphs(session.source(session.poly_data(points, **{name: values})), view)
        shown.GlyphScaling = 1
        session.look(view, (0.0, 0.0, 30.0), parallel_scale=scale)
        pixels = session.capture(view, "array-choice-" + name)
        checks.equal("factor with the array " + name, shown.GlyphScaleFactor, factor)
        pixel = 2.0 * scale / height
        wanted = numpy.pi * (radii**2).sum() / pixel**2
        checks.within("pixels of spheres with the array " + name, float(comparison.covered(pixels).sum()), 0.98 * wanted, 1.02 * wanted)
        shown.GlyphScaleFunction = "Square Root"
        pv.Render(view)
        checks.true("the square roots of %s count as exact" % name, shown.GlyphScaleFactor not in (1.0, 2.0))
        pv.Delete(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    choices(checks)
    files(checks)
    cells(checks)
    exact_sizes(checks)
    checks.report()


if __name__ == "__main__":
    main()
