"""Tensor fields and vectors: a flow, uncertainty, magnitudes over many powers of ten.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython tensors.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT]
With RTGLYPHS_SHARED_DATA, a folder, also pictures of tensors.vtk and dt-helix.nhdr in it (../Kernels/TensorTest.cxx names their sources).
"""
import os
import sys

import numpy
import paraview.simple as pv
from vtkmodules.numpy_interface import dataset_adapter

from simulation import begin, look, new_view, preset_name, save, show, source


def arrays_of(reader):
    """Points and point arrays of a reader as numpy."""
    reader.UpdatePipeline()
    adapter = dataset_adapter.WrapDataObject(pv.servermanager.Fetch(reader))
    data = adapter.VTKObject
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return points, {name: numpy.array(adapter.PointData[name]) for name in adapter.PointData.keys()}


def norms(six):
    """Frobenius norms of tensors whose last three components are those off the diagonal."""
    return numpy.sqrt((six[:, :3] ** 2).sum(axis=1) + 2.0 * (six[:, 3:] ** 2).sum(axis=1))


def fibres(view, points, tensors, share, layout, spacing):
    """Tensors of diffusion, where the fraction of fibers is large enough, by their principal direction."""
    inside = share > 0.5
    largest = numpy.quantile(norms(tensors[inside]), 0.9)
    show(source(points[inside], d=tensors[inside]), view, "Tensor Superquadric", GlyphTensorArray="d", GlyphTensorLayout=layout,
         GlyphDirectionColoring="Axes", ScaleFactor=1.3 * spacing / largest)


def flow(view, _, __):
    """Velocity gradients of the flow (sin z + cos y, sin x + cos z, sin y + cos x) of Arnold, Beltrami and Childress, in one layer.

    Its vorticity is its velocity, so that the arrows, half the vorticity, point along the flow."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(0, 2 * numpy.pi, 17)[:-1], numpy.linspace(0, 2 * numpy.pi, 17)[:-1]))
    z, o = numpy.zeros_like(x), numpy.zeros_like(x)
    gradient = numpy.array([o, -numpy.sin(y), numpy.cos(z), numpy.cos(x), o, -numpy.sin(z), -numpy.sin(x), numpy.cos(y), o]).T
    show(source(numpy.array([x, y, z]).T, gradient=gradient), view, "Signed Tensor Superquadric", GlyphTensorArray="gradient",
         GlyphTensorColoring="Sign", GlyphTensorAxis=1, ScaleFactor=0.4)
    look(view, (2.9, -2.6, 12.2), (2.9, 2.75, 0.0), (0.0, 1.0, 0.0))


def colored_by(shown, name, low, high, preset="Viridis"):
    """By an array, on a scale."""
    pv.ColorBy(shown, ("POINTS", name), True)
    table = pv.GetColorTransferFunction(name, shown, separate=True)
    table.ApplyPreset(preset_name(preset), True)
    table.RescaleTransferFunction(low, high)


def split_vectors(view, _, __):
    """The field of two magnetic dipoles, one a tenth of the other, in the plane of both; colored by the power of ten."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(-3.0, 3.0, 13), numpy.linspace(-2.0, 2.0, 9)))
    points, field = numpy.stack([x, y, 0.0 * x], axis=1), 0.0
    for place, moment in (((-1.27, 0.21, 0.0), (0.0, 1.0, 0.0)), ((1.76, -0.31, 0.0), (0.06, 0.08, 0.0))):
        r, m = points - place, numpy.array(moment)
        d = numpy.linalg.norm(r, axis=1)[:, None]
        field = field + 3.0 * r * (r @ m)[:, None] / d ** 5 - m / d ** 3
    power = numpy.floor(numpy.log10(numpy.linalg.norm(field, axis=1)))
    shown = show(source(points, field=field, power=power), view, "Split Vector", SelectOrientationVectors="field", ScaleFactor=0.55, RenderingQuality="Balanced", GlyphLegend="Lower Right",
                 **{"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.035, "GlyphType.TipRadius": 0.09})
    colored_by(shown, "power", power.min() - 1.0, power.max())  # without Viridis' darkest
    look(view, (0.0, -2.6, 8.6), (0.0, -0.12, 0.0), (0.0, 1.0, 0.0))


def uncertain_vectors(view, _, __, shape="Uncertain Vector"):
    """The mean of a vortex whose middle is uncertain by a Gaussian, and the covariances of 500 samples of it."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(-3.0, 3.0, 10), numpy.linspace(-2.1, 2.1, 7)))
    points = numpy.stack([x, y, 0.0 * x], axis=1)
    middles = numpy.random.default_rng(1).normal(scale=(0.3, 0.15, 0.3), size=(500, 3))
    r = points[None] - middles[:, None]
    flows = numpy.stack([-r[..., 1], r[..., 0], 0.3 * r[..., 2]], axis=-1) / (0.5 + (r ** 2).sum(axis=-1, keepdims=True))
    mean = flows.mean(axis=0)
    covariance = numpy.einsum("spi,spj->pij", flows - mean, flows - mean).reshape(-1, 9) / (len(flows) - 1)
    shown = show(source(points, mean=mean, covariance=covariance, speed=numpy.linalg.norm(mean, axis=1)), view, shape, SelectOrientationVectors="mean",
                 GlyphTensorArray="covariance", ScaleFactor=0.8, GlyphConfidence=0.9)
    colored_by(shown, "speed", 0.0, 0.7)
    look(view, (0.0, -4.2, 8.4), (0.0, -0.1, 0.0), (0.0, 1.0, 0.0))


def confidence_ellipsoids(view, _, __):
    """Atoms of a benzene molecule that turns and shakes in a crystal: half of the time each is in its ellipsoid."""
    angles = numpy.radians(60.0 * numpy.arange(6))
    ring = numpy.stack([numpy.cos(angles), numpy.sin(angles), 0.0 * angles], axis=1)
    points, radii = numpy.concatenate([1.39 * ring, 2.48 * ring]), numpy.repeat([1.39, 2.48], 6)
    around, out = numpy.tile(numpy.stack([-ring[:, 1], ring[:, 0], 0.0 * angles], axis=1), (2, 1)), numpy.array([0.0, 0.0, 1.0])
    covariance = 0.02 * numpy.eye(3) + 0.011 * (radii ** 2)[:, None, None] * numpy.einsum("pi,pj->pij", around, around) + 0.02 * numpy.outer(out, out)
    shown = show(source(points, covariance=covariance.reshape(-1, 9), element=numpy.repeat([1.0, 0.0], 6)), view, "Confidence Ellipsoid", GlyphTensorArray="covariance",
                 GlyphConfidence=0.5, ScaleFactor=1.0, ShadingMode="Ambient Occlusion", SamplesPerPixel=64)
    colored_by(shown, "element", -0.5, 1.5)
    look(view, (2.1, -7.0, 8.3), (0.0, -0.1, 0.0), (0.0, 1.0, 0.0))


def third_party(view, path):
    """The eight tensors of tensors.vtk, by sign, or the helix of dt-helix.nhdr."""
    if path.endswith("tensors.vtk"):
        points, arrays = arrays_of(pv.OpenDataFile(path))
        t = arrays["tensors1"].reshape(-1, 9)
        show(source(points, t=t), view, "Signed Tensor Superquadric", GlyphTensorArray="t", GlyphTensorColoring="Sign",
             ScaleFactor=0.25)
        look(view, (2.4, -3.0, 1.9), (0.62, 0.5, 0.4), (0.0, 0.0, 1.0))
        return
    raw = numpy.fromfile(os.path.splitext(path)[0] + ".raw", dtype=">f4").reshape(40, 39, 38, 7).astype(float)
    axes = [numpy.linspace(-2.0, 2.0, n) for n in (38, 39, 40)]
    z, y, x = numpy.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    tensors = raw[..., 1:].reshape(-1, 6)  # xx xy xz yy yz zz
    diagonal_first = tensors[:, [0, 3, 5, 1, 4, 2]]
    mean = diagonal_first[:, :3].mean(axis=1, keepdims=True)
    apart = numpy.hstack([diagonal_first[:, :3] - mean, diagonal_first[:, 3:]])
    anisotropy = numpy.sqrt(1.5) * norms(apart) / numpy.maximum(norms(diagonal_first), 1e-30)
    share = ((raw[..., 0].ravel() > 0.5) & (anisotropy > 0.6)).astype(float)
    fibres(view, numpy.array([x.ravel(), y.ravel(), z.ravel()]).T, diagonal_first, share, "xx yy zz xy yz xz", 4.0 / 39)
    look(view, (5.6, -7.3, 4.4), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))


def main():
    """Makes the pictures."""
    data, folder = begin()
    size = [int(value) for value in sys.argv[3:5]] or [1200, 900]
    wanted = os.environ.get("RTGLYPHS_PICTURES", "").split()  # names, or none for all
    pictures = {"flow": flow, "split_vectors": split_vectors,
                "uncertain_vectors": uncertain_vectors,
                "uncertain_directions": lambda *given: uncertain_vectors(*given, shape="Uncertain Direction"), "confidence_ellipsoids": confidence_ellipsoids}
    shared = os.environ.get("RTGLYPHS_SHARED_DATA", "")
    for name, file in (("tensors-vtk", "tensors.vtk"), ("dt-helix", "dt-helix.nhdr")):
        path = os.path.join(shared, file)
        if shared and os.path.exists(path):
            pictures[name] = lambda view, _, __, path=path: third_party(view, path)
    for name, draw in pictures.items():
        if wanted and name not in wanted:
            continue
        view = new_view(size)
        draw(view, data, folder)
        save(view, folder, name, size)
    pv.Disconnect()


if __name__ == "__main__":
    main()
