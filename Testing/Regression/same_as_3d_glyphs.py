"""Ray-traced glyphs against ParaView's 3D Glyphs at high tessellation: every shape, projection, coloring and light.

Usage: pvpython same_as_3d_glyphs.py [SHAPE...]
SHAPE is Sphere, Box, ..., or MeshSphere, MeshBox, ...: the glyphs are then meshes of ParaView's source of that name.
"""
import sys

import numpy
import paraview.simple as pv
import vtkmodules.vtkFiltersSources as sources
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import comparison
import session

#: the tessellation of ParaView's source of the same name; that of meshes is ours, too
RESOLUTION = {
    "Sphere": {"ThetaResolution": 128, "PhiResolution": 128},
    "Box": {},
    "Cylinder": {"Resolution": 128},
    "Cone": {"Resolution": 128},
    "Arrow": {"TipResolution": 128, "ShaftResolution": 128},
    "MeshArrow": {"TipResolution": 6, "ShaftResolution": 7},
    "MeshCylinder": {"Resolution": 6},
}


#: those tested where no shape is named
SHAPES = ("Sphere", "Box", "Cylinder", "Capsule", "Cone", "Arrow", "MeshArrow", "MeshCylinder")
#: fraction of the pixels that one of two pictures covers alone, and levels of 255 in the mean: a fifth of what the smallest ball covers
SILHOUETTE, COLOR = 0.0003, 1.5
COLORINGS = ("solid", "table")
#: by name: the parallel scale
PROJECTIONS = {"perspective": None, "parallel": 1.4}
#: no light at all: surfaces then have their plain color
LIGHTS = ("lightkit", "headlight", "spot", "none")


def scene(count=24):
    """Random points with vectors of different lengths and a scalar."""
    generator = numpy.random.default_rng(7)
    points = generator.uniform(-1.0, 1.0, (count, 3))
    vectors = generator.normal(size=(count, 3))
    return session.source(session.poly_data(points, vector=vectors, scalar=points[:, 0] + points[:, 1]))


def capsule():
    """VTK's capsule, which ParaView offers no source of, turned from the y axis to x."""
    if hasattr(sources, "vtkCapsuleSource"):
        source = sources.vtkCapsuleSource()
        source.SetThetaResolution(64)
        source.SetPhiResolution(64)
    else:  # newer VTK
        source = sources.vtkCylinderSource()
        source.CapsuleCapOn()
        source.SetResolution(128)
    turn = vtkTransform()
    turn.RotateZ(-90.0)
    turned = vtkTransformPolyDataFilter()
    turned.SetTransform(turn)
    turned.SetInputConnection(source.GetOutputPort())
    turned.Update()
    return session.source(turned.GetOutput())


def tessellate(source, shape):
    """Gives ParaView's source of a shape its tessellation."""
    for name, value in RESOLUTION.get(shape, {}).items():
        setattr(source, name, value)


def give_shape(shown, shape):
    """Gives a display of glyphs a shape: of ParaView's source; ray traced, meshes are the triangles of one that is not traced exactly."""
    ray_traced = str(shown.Representation).strip("'") == session.REPRESENTATION
    if shape == "Capsule":
        shown.GlyphType, shown.GlyphShape = capsule(), shape
        return
    shown.GlyphShape = "None"
    name = shape.replace("Mesh", "")
    if ray_traced and shape.startswith("Mesh"):
        source = getattr(pv, name)()
        tessellate(source, shape)
        shown.GlyphType = session.triangles(source)
    else:
        shown.GlyphType = name
        tessellate(shown.GlyphType, shape)


def glyphs(points, in_view, shape, representation):
    """The scene."""
    shown = pv.Show(points, in_view)
    shown.SetRepresentationType(representation)
    give_shape(shown, shape)
    shown.Orient = 1
    shown.OrientationMode = "Direction"
    shown.SelectOrientationVectors = "vector"
    shown.Scaling = 1
    shown.ScaleMode = "Magnitude"
    shown.SelectScaleArray = "vector"
    shown.ScaleFactor = 0.3
    return shown


def theirs(points, in_view, shape):
    """The scene as ParaView's 3D Glyphs."""
    return glyphs(points, in_view, shape, "3D Glyphs")


def ours(points, in_view, shape):
    """The scene as ray-traced glyphs."""
    shown = glyphs(points, in_view, shape, session.REPRESENTATION)
    if len(in_view.Representations) == 1:
        shown.SamplesPerPixel = 1
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


def combinations(shape):
    """Combinations (coloring, projection, light): every pair of two of them occurs.

    Meshes have ParaView's own triangles: two combinations that have nothing in common are enough.
    """
    if shape.startswith("Mesh"):
        return [("solid", "perspective", "lightkit"), ("table", "parallel", "spot")]
    projections = list(PROJECTIONS)
    return [(coloring, projections[(row + column) % 2], light)
            for row, coloring in enumerate(COLORINGS) for column, light in enumerate(LIGHTS)]


def pictures(view, points, shapes, show, who):
    """The pictures of all shapes by one of the two representations, by shape and combination."""
    taken = {}
    shown = show(points, view, shapes[0])
    shown.Specular = 0.4
    shown.SpecularPower = 20.0
    for coloring in reversed(COLORINGS):  # 3D Glyphs remember a solid color's specular one
        if coloring == "solid":
            session.solid(shown, (0.8, 0.5, 0.2))
            # 3D Glyphs mix the specular color into the solid one (vtkProperty::GetColor), surfaces do not.
            shown.SpecularColor = [0.8, 0.5, 0.2]
        else:
            pv.ColorBy(shown, ("POINTS", "scalar"))
            shown.SetScalarBarVisibility(view, False)
        for shape in shapes:
            give_shape(shown, shape)
            pv.Render(view)  # the camera's near plane cuts 3D Glyphs off until they are drawn again
            for combination in combinations(shape):
                if combination[0] == coloring:
                    _, projection, light = combination
                    session.look(view, (2.0, 1.5, 5.0), parallel_scale=PROJECTIONS[projection])
                    lamp = illuminate(view, light)
                    taken[shape, combination] = session.capture(view, "-".join((shape,) + combination + (who,)))
                    if lamp:
                        pv.RemoveLight(lamp)
    pv.Hide(points, view)
    pv.Delete(shown)
    return taken


def main(shapes):
    """Every shape by both representations."""
    session.load()
    view = session.view()
    points = scene()
    failures = []
    expected = pictures(view, points, shapes, theirs, "paraview")
    for (shape, combination), picture in pictures(view, points, shapes, ours, "ours").items():
        failures += comparison.against_paraview(picture, expected[shape, combination], "-".join((shape,) + combination), SILHOUETTE, COLOR)
    session.finish(failures)


if __name__ == "__main__":
    main(sys.argv[1:] or SHAPES)
