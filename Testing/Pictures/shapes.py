"""Draws the small pictures of all shapes that the window's help page shows, Plugin/Shapes/*.png.

Usage: RTGLYPHS_PLUGIN=... pvpython shapes.py
"""
import os
import sys

import numpy
import paraview.simple as pv

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Regression"))
import session  # noqa: E402

FOLDER = os.path.join(HERE, "..", "..", "Plugin", "Shapes")
WIDTH, HEIGHT = 112, 84
#: of tensors
ARRAYS = {"Fourth-Order Tensor": "stiffness", "Tensor Ellipsoid": "tensor", "Tensor Superquadric": "tensor", "Uncertain Vector": "covariance",
          "Uncertain Direction": "covariance", "Confidence Ellipsoid": "covariance", "Signed Tensor Superquadric": "spike"}


def stiffness():
    """The 81 components of a cubic crystal's stiffness."""
    d = numpy.eye(3)
    one, two, three = (numpy.einsum(how, d, d) for how in ("ij,kl->ijkl", "ik,jl->ijkl", "il,jk->ijkl"))
    axes = sum(numpy.einsum("i,j,k,l->ijkl", *[d[i]] * 4) for i in range(3))
    return (0.35 * one + 0.3 * (two + three) - 0.75 * axes).reshape(1, 81)


def main():
    """One glyph a picture."""
    session.load()
    view = session.view(WIDTH, HEIGHT, (255, 255, 255))
    harmonics = numpy.array([[0.3, 0.0, 0.0, 0.15, 0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.35, 0.0, 0.0, 0.0, 0.2]])
    tensor = numpy.array([[1.0, 0.55, 0.2, 0.1, 0.0, 0.0]])
    signs = numpy.array([[1.0, -0.6, 0.3, 0.1, 0.0, 0.0]])
    spike = numpy.array([[0.8, -0.55, -0.55, 0.0, 0.0, 0.0]])
    source = session.source(session.poly_data(numpy.zeros((1, 3)), harmonics=harmonics, stiffness=stiffness(), tensor=tensor, signs=signs, spike=spike,
                                              v=numpy.array([[1.0, 0.25, 0.2]]), covariance=numpy.array([[0.03, 0.01, 0.015, 0.005, 0.0, 0.0]]), small=0.004 * numpy.array([[1.0, 0.25, 0.2]])))
    shown = session.glyphs(source, view, SelectOrientationVectors="v", ScaleFactor=1.0, samples=64)
    session.solid(shown, (0.35, 0.55, 0.8))
    names = list(session.SOURCES) + [name for name in shown.GetProperty("GlyphShape").Available if name != "None"]
    for name in names:
        session.assign_shape(shown, name)
        shown.GlyphTensorArray = ARRAYS.get(name, "signs")
        shown.GlyphHarmonicsArray, shown.GlyphScaleFunction = "harmonics", "All the Same"
        shown.GlyphExponents = [3.0, 1.2, 1.2] if name == "Nested Superquadric" else [6.0, 6.0, 1.2]
        shown.GlyphAnchor = "Center"
        shown.SelectOrientationVectors = "small" if name == "Split Vector" else "v"
        middle = numpy.array([0.5, 0.12, 0.1]) if name.startswith("Uncertain") else numpy.zeros(3)
        session.look(view, middle + (1.5, -4.0, 2.2), middle, up=(0.0, 0.0, 1.0), parallel_scale={"Capsule": 1.15, "Box": 0.92, "Cylinder": 0.8, "Uncertain Vector": 0.9}.get(name, 0.72))
        pv.SaveScreenshot(os.path.join(FOLDER, name + ".png"), view, ImageResolution=[WIDTH, HEIGHT], TransparentBackground=1)
    session.finish()


if __name__ == "__main__":
    main()
