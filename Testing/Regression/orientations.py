"""Orientations as codes write them give one picture: quaternions, matrices row by row, angles; also
where the array says by its length what it is, and where each component is an array of its own, whatever the types of these.
What is no rotation makes no glyph.

Usage: pvpython orientations.py
"""
import numpy
import paraview.simple as pv

import session
from checks import Checks

#: angles about x, y and z in degrees, applied as y, then x, then z
ANGLES = numpy.array([[20.0, 50.0, -35.0], [0.0, 0.0, 90.0], [-70.0, 10.0, 160.0], [180.0, 0.0, 0.0]])
CENTERS = numpy.array([[-1.5, 0.0, 0.0], [-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [1.5, 0.0, 0.0]])
LENGTHS = numpy.array([[0.9, 0.5, 0.25]] * 4)


def turn(axis, degrees):
    """The matrix of a turn about a coordinate axis."""
    c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    made = numpy.eye(3)
    made[i, i], made[j, j], made[j, i], made[i, j] = c, c, s, -s
    return made


def quaternion(matrix):
    """(w, x, y, z) from the eigenvector of Bar-Itzhack's form, Journal of Guidance, Control, and Dynamics 23(6), 2000."""
    m = matrix
    form = numpy.array([[m[0, 0] + m[1, 1] + m[2, 2], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
                        [m[2, 1] - m[1, 2], m[0, 0] - m[1, 1] - m[2, 2], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
                        [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], m[1, 2] + m[2, 1]],
                        [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1]]])
    return numpy.linalg.eigh(form)[1][:, 3]


def drawn(stage, data, array, mode, **properties):
    """(picture, messages) of boxes."""
    def show():
        shown = stage.show(data, "Box", **{**dict(ScaleFactor=0.9, SelectScaleArray="lengths", ScaleMode="Vector Components",
                                                  Orient=1, SelectOrientationVectors=array, OrientationMode=mode), **properties})
        session.solid(shown, (0.9, 0.8, 0.5))
        pv.Render(stage.view)

    said = session.messages(show)
    return session.capture(stage.view, "orientations-%s-%s" % (array, mode)), said


def columns(checks, stage):
    """Arrays of different types, as CSV readers make columns of whole numbers and of fractions, are joined without loss."""
    whole = numpy.ones(4, dtype=numpy.int32)
    parts = {"a": whole, "b": numpy.full(4, 0.5, numpy.float32), "c": numpy.full(4, 0.25), "zero": 0 * whole}

    def picture(name, shape, **properties):
        made = {joined: numpy.column_stack([parts[part] for part in joined.split(", ")]).astype(float) for joined in properties.values()
                if isinstance(joined, str) and ", " in joined}
        pictures = []
        for data in (session.poly_data(CENTERS, **made), session.poly_data(CENTERS, **parts)):
            shown = stage.show(data, shape, **{"ScaleFactor": 0.9, "Orient": 0, **properties})
            session.solid(shown, (0.9, 0.8, 0.5))
            checks.no_message(name, session.messages(lambda: pv.Render(stage.view)))
            pictures.append(session.capture(stage.view, "orientations-columns-%s-%d" % (name, len(pictures))))
        checks.covered(name, pictures[0], 0.02)
        checks.picture(name + " of columns of different types", pictures[1], pictures[0], pixels=0.0)

    picture("sizes", "Box", ScaleMode="Vector Components", SelectScaleArray="a, b, c")
    picture("exponents", "Superquadric", GlyphExponentArray="a, b, c")
    picture("tensors", "Tensor Ellipsoid", GlyphTensorArray="a, b, c, zero, zero, zero")
    picture("directions", "Arrow", Orient=1, SelectOrientationVectors="zero, b, c")
    picture("quaternions", "Box", Orient=1, SelectOrientationVectors="a, b, c, zero",
            OrientationMode="Quaternion")
    picture("velocities", "Sphere", MotionBlur=1, ShutterTime=1.0, SamplesPerPixel=4, VelocityArray="zero, b, c", AccelerationArray="None")


def plane(checks, stage):
    """Vectors of two components lie in the plane z = 0."""
    flat = numpy.array([[0.5, 0.2], [-0.3, 0.6], [0.1, -0.5], [-0.4, -0.4]])
    filled = numpy.column_stack([flat, numpy.zeros(4)])
    for name, shape, properties in (("direction", "Arrow", {"Orient": 1, "SelectOrientationVectors": "v", "ScaleMode": "Magnitude", "SelectScaleArray": "v"}),
                                    ("velocity", "Sphere", {"MotionBlur": 1, "ShutterTime": 1.0, "SamplesPerPixel": 4, "VelocityArray": "v"}),
                                    ("acceleration", "Sphere", {"MotionBlur": 1, "ShutterTime": 1.0, "SamplesPerPixel": 4, "ShutterOpening": "Forward",
                                                                "VelocityArray": "None", "AccelerationArray": "v"})):
        for kind in (numpy.float32, numpy.float64, numpy.int32):
            pictures = []
            for values in (filled, flat):
                data = session.poly_data(CENTERS, v=(10.0 * values).astype(kind))
                shown = stage.show(data, shape, **{"ScaleFactor": 0.1, "Orient": 0, **properties})
                checks.no_message("%s of %d components" % (name, values.shape[1]), session.messages(lambda: pv.Render(stage.view)))
                pictures.append(session.capture(stage.view, "orientations-plane-%s-%d" % (name, len(pictures))))
            checks.covered(name + " of three components", pictures[0], 0.005)
            checks.picture("%s of two components, %s" % (name, kind.__name__), pictures[1], pictures[0], pixels=0.0)


def main():
    """All against angles."""
    session.load()
    checks = Checks()
    matrices = numpy.array([turn(2, z) @ turn(0, x) @ turn(1, y) for x, y, z in ANGLES])
    # As files have them: rounded, and axes of any length.
    rows = numpy.round(matrices, 5).reshape(4, 9)
    mirrored, flat = rows.copy(), rows.copy()
    mirrored[1, 6:] *= -1.0
    flat[2, 3:6] = flat[2, :3]
    quaternions = numpy.array([quaternion(matrix) for matrix in matrices])
    components = {"c_q[%d]" % (i + 1): quaternions[:, i] for i in range(4)}
    components.update({"shape" + "xyz"[i]: LENGTHS[:, i] for i in range(3)})
    components["c_q[1-3]"] = quaternions[:, :3]  # as LAMMPS' dump vtk writes the first three of four
    data = session.poly_data(
        CENTERS, **components, lengths=LENGTHS, size=numpy.linalg.norm(LENGTHS, axis=1), angles=ANGLES, rows=rows, mirrored=mirrored, flat=flat,
        quaternions=quaternions)
    view = session.view(240, 100)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.0)
    stage = session.Stage(view)
    expected, _ = drawn(stage, data, "angles", "Rotation")
    checks.covered("angles", expected, 0.1)
    for array, mode in (("quaternions", "Quaternion"), ("quaternions", "Direction"), ("quaternions", "Rotation"), ("rows", "Rotation"), ("rows", "Direction"),
                        ("rows", "Quaternion")):
        picture, said = drawn(stage, data, array, mode)
        checks.no_message("%s, %s" % (array, mode), said)
        checks.picture("%s, %s" % (array, mode), picture, expected, pixels=0.002)
    # The components as arrays of their own
    joined = "c_q[1], c_q[2],c_q[3] ,c_q[4]"
    picture, said = drawn(stage, data, joined, "Quaternion", SelectScaleArray="shapex, shapey, shapez")
    checks.no_message("components", said)
    checks.picture("components", picture, expected, pixels=0.002)
    picture, said = drawn(stage, data, "c_q[1-3], c_q[4]", "Quaternion")
    checks.no_message("three components and one", said)
    checks.picture("three components and one", picture, expected, pixels=0.002)
    missing = "c_q[1], c_q[2], c_q[3], c_q[5]"
    checks.one_message(missing, drawn(stage, data, missing, "Quaternion")[1], "no point array", missing)
    for several in ("c_q[1], c_q[2]", "c_q[1], lengths, c_q[3]"):
        checks.one_message(several, drawn(stage, data, several, "Quaternion")[1], several, "are needed")
    for array, mode in (("mirrored", "Direction"), ("flat", "Direction")):
        checks.one_message(array, drawn(stage, data, array, mode)[1], "1 of 4", "orientation", array)
    for array, mode, needed in (("angles", "Quaternion", "4 or 9"), ("size", "Direction", "3, 4 or 9")):
        checks.one_message("%s, %s" % (array, mode), drawn(stage, data, array, mode)[1], array, needed + " are needed")
    # A size of one component has no components to scale by.
    pictures = [drawn(stage, data, "rows", "Direction", SelectScaleArray="size", ScaleMode=mode)[0] for mode in ("Magnitude", "Vector Components")]
    checks.covered("size", pictures[0], 0.1)
    checks.picture("size of one component, Vector Components", pictures[1], pictures[0])
    columns(checks, stage)
    plane(checks, stage)
    checks.report()


if __name__ == "__main__":
    main()
