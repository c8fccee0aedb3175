"""Ray-traced glyphs against ParaView's 3D Glyphs at high tessellation: one shape, every projection, colouring and light.

Usage: pvpython same_as_3d_glyphs.py SHAPE
SHAPE is Sphere, Box, ..., or MeshSphere, MeshBox, ...: the glyphs are then meshes of ParaView's source of that name.
"""
import sys

import numpy
import paraview.simple as pv

import comparison
import session

#: the tessellation of ParaView's source of the same name
RESOLUTION = {
    "Sphere": {"ThetaResolution": 128, "PhiResolution": 128},
    "Box": {},
    "Cylinder": {"Resolution": 128},
    "Cone": {"Resolution": 128},
    "Arrow": {"TipResolution": 128, "ShaftResolution": 128},
}


#: no light at all: surfaces then have their plain colour
LIGHTS = ("lightkit", "headlight", "spot", "none")


def scene(count=24):
    """Random points with vectors of different lengths and a scalar."""
    generator = numpy.random.default_rng(7)
    points = generator.uniform(-1.0, 1.0, (count, 3))
    vectors = generator.normal(size=(count, 3))
    return session.source(session.poly_data(points, vector=vectors, scalar=points[:, 0] + points[:, 1]))


def theirs(points, in_view, shape):
    """The scene as ParaView's 3D Glyphs."""
    shown = pv.Show(points, in_view)
    shown.SetRepresentationType("3D Glyphs")
    shown.GlyphType = shape.replace("Mesh", "")
    for name, value in RESOLUTION.get(shape, {}).items():
        setattr(shown.GlyphType, name, value)
    shown.Orient = 1
    shown.OrientationMode = "Direction"
    shown.SelectOrientationVectors = "vector"
    shown.Scaling = 1
    shown.ScaleMode = "Magnitude"
    shown.SelectScaleArray = "vector"
    shown.ScaleFactor = 0.3
    return shown


def ours(points, in_view, shape):
    """The scene as ray-traced glyphs, arrows with the outline of ParaView's arrow source."""
    is_mesh = shape.startswith("Mesh")
    shown = session.glyphs(points, in_view, "Mesh" if is_mesh else shape,
                           GlyphOrient=1, GlyphOrientationArray="vector", GlyphOrientationMode="Direction",
                           GlyphScaling=1, GlyphScaleArray="vector", GlyphScaleMode="Magnitude",
                           GlyphScaleFactor=0.3)
    if is_mesh:
        shown.GlyphMesh = shape.replace("Mesh", "")
    if shape == "Arrow":
        shown.ArrowHeads = "Scaled"
        shown.ArrowTipRounding = 0.0
    return shown


def illuminate(view, light):
    """Exactly one kind of light; returns what to remove afterwards."""
    view.UseLight = 1 if light == "lightkit" else 0
    properties = {
        "headlight": {"Coords": "Headlight", "Type": "Directional"},
        "spot": {"Coords": "Scene", "Type": "Positional", "Position": [3.0, 3.0, 4.0], "FocalPoint": [0.0, 0.0, 0.0],
                 "ConeAngle": 25.0, "DiffuseColor": [1.0, 0.9, 0.7]},
    }.get(light)
    if properties is None:
        return None
    lamp = pv.AddLight(view=view)
    for name, value in properties.items():
        setattr(lamp, name, value)
    return lamp


def main(shape):
    """All combinations for one shape."""
    session.load()
    view = session.view()
    points = scene()
    failures = []
    for colouring in ("solid", "table"):
        pictures = {}
        for who, show in (("ours", ours), ("paraview", theirs)):
            shown = show(points, view, shape)
            shown.Specular = 0.4
            shown.SpecularPower = 20.0
            if colouring == "solid":
                session.solid(shown, (0.8, 0.5, 0.2))
                # 3D Glyphs mix the specular colour into the solid one (vtkProperty::GetColor), surfaces do not.
                shown.SpecularColor = [0.8, 0.5, 0.2]
            else:
                pv.ColorBy(shown, ("POINTS", "scalar"))
                shown.SetScalarBarVisibility(view, False)
            for projection, scale in (("perspective", None), ("parallel", 1.4)):
                session.look(view, (2.0, 1.5, 5.0), parallel_scale=scale)
                for light in LIGHTS:
                    lamp = illuminate(view, light)
                    case = "%s-%s-%s-%s" % (shape, colouring, projection, light)
                    pv.Render(view)
                    pictures[who, case] = session.capture(view, case + "-" + who)
                    if lamp:
                        pv.RemoveLight(lamp)
            pv.Hide(points, view)
            pv.Delete(shown)
        for who, case in pictures:
            if who == "ours":
                failures += comparison.against_paraview(pictures[who, case], pictures["paraview", case], case)
    session.finish(failures)


if __name__ == "__main__":
    main(sys.argv[1])
