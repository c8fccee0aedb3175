"""Tensor fields and vectors: a flow, uncertainty, magnitudes over many powers of ten.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython tensors.py DATA-FOLDER OUTPUT-FOLDER [WIDTH HEIGHT]
With RTGLYPHS_SHARED_DATA, a folder, also pictures of tensors.vtk and dt-helix.nhdr in it (../Kernels/TensorTest.cxx names their sources).
"""
import os

import numpy
import paraview.simple as pv
from vtkmodules.numpy_interface import dataset_adapter

import cover
import session
from cover import figure
from simulation import EMBER, RAINBOW, begin, save, source


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


def flow(*_):
    """Velocity gradients of the flow (sin z + cos y, sin x + cos z, sin y + cos x) of Arnold, Beltrami and Childress, in one layer.

    Its vorticity is its velocity, so that the arrows, half the vorticity, point along the flow."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(0, 2 * numpy.pi, 15)[:-1], numpy.linspace(0, 2 * numpy.pi, 13)[:-1]))
    z, o = numpy.zeros_like(x), numpy.zeros_like(x)
    gradient = numpy.array([o, -numpy.sin(y), numpy.cos(z), numpy.cos(x), o, -numpy.sin(z), -numpy.sin(x), numpy.cos(y), o]).T
    figure(source(numpy.array([x, y, z]).T, gradient=gradient), "Signed Tensor Superquadric", GlyphTensorArray="gradient", GlyphTensorColoring="Sign",
           GlyphTensorAxis=1, ScaleFactor=0.5, GroundShadow="None", camera=((2.95, -2.4, 8.4), (2.95, 2.4, 0.0)), up=(0.0, 1.0, 0.0), angle=32.0)


def point_load(data, _):
    """Stress in a half space under a point load, cut through it: glyphs in front are left out as a whole."""
    shown = figure(pv.OpenDataFile(os.path.join(data, "point_load", "point_load.vtk")), "Normal Stress", GlyphTensorColoring="Sign", GlyphScaleFunction="Logarithm",
           GroundShadow="None", Section="Plane", SectionCaps="Whole Glyphs", SectionOrigin=[0.0, -0.01, 0.0], SectionNormal=[0.0, 1.0, 0.0],
           camera=((0.6, -4.2, 0.6), (0.0, 0.0, -0.98)), angle=27.5)
    shown.ScaleFactor *= 0.85


def split_vectors(*_):
    """The field of two magnetic dipoles, one a tenth of the other, in the plane of both; colored by the power of ten."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(-3.0, 3.0, 13), numpy.linspace(-1.75, 1.75, 8)))
    points, field = numpy.stack([x, y, 0.0 * x], axis=1), 0.0
    for place, moment in (((-1.27, 0.21, 0.0), (0.0, 1.0, 0.0)), ((1.76, -0.31, 0.0), (0.06, 0.08, 0.0))):
        r, m = points - place, numpy.array(moment)
        d = numpy.linalg.norm(r, axis=1)[:, None]
        field = field + 3.0 * r * (r @ m)[:, None] / d ** 5 - m / d ** 3
    power = numpy.floor(numpy.log10(numpy.linalg.norm(field, axis=1)))
    figure(source(points, field=field, power=power), "Split Vector", SelectOrientationVectors="field", ScaleFactor=0.5, GlyphLegend="Upper Right", GroundShadow="Across Z",
           bar=("power", (-3.0, 1.0), "power of ten", RAINBOW, (0.6, 0.03)), camera=((0.0, -3.9, 7.0), (0.0, -0.3, 0.0)), up=(0.0, 1.0, 0.0), angle=35.0,
           **{"GlyphType": "Arrow", "GlyphType.ShaftRadius": 0.05, "GlyphType.TipRadius": 0.12})


def uncertain_vectors(*_, shape="Uncertain Vector"):
    """The mean of a vortex whose middle is uncertain by a Gaussian, and the covariances of 500 samples of it."""
    x, y = (a.ravel() for a in numpy.meshgrid(numpy.linspace(-3.0, 3.0, 10), numpy.linspace(-1.95, 1.95, 7)))
    points = numpy.stack([x, y, 0.0 * x], axis=1)
    middles = numpy.random.default_rng(1).normal(scale=(0.3, 0.15, 0.3), size=(500, 3))
    r = points[None] - middles[:, None]
    flows = numpy.stack([-r[..., 1], r[..., 0], 0.3 * r[..., 2]], axis=-1) / (0.5 + (r ** 2).sum(axis=-1, keepdims=True))
    mean = flows.mean(axis=0)
    covariance = numpy.einsum("spi,spj->pij", flows - mean, flows - mean).reshape(-1, 9) / (len(flows) - 1)
    figure(source(points, mean=mean, covariance=covariance, speed=numpy.linalg.norm(mean, axis=1)), shape, SelectOrientationVectors="mean", GlyphTensorArray="covariance",
           ScaleFactor=0.8, GlyphConfidence=0.9, bar=("speed", (0.0, 0.7), "speed", RAINBOW, (0.6, 0.03)), camera=((0.0, -4.2, 7.3), (0.0, -0.22, 0.0)), up=(0.0, 1.0, 0.0), angle=32.0)


def confidence_ellipsoids(*_):
    """Atoms of a benzene molecule that turns and shakes in a crystal: half of the time each is in its ellipsoid, nine tenths of it in the shell."""
    angles = numpy.radians(60.0 * numpy.arange(6))
    ring = numpy.stack([numpy.cos(angles), numpy.sin(angles), 0.0 * angles], axis=1)
    points, radii = numpy.concatenate([1.39 * ring, 2.48 * ring]), numpy.repeat([1.39, 2.48], 6)
    around, out = numpy.tile(numpy.stack([-ring[:, 1], ring[:, 0], 0.0 * angles], axis=1), (2, 1)), numpy.array([0.0, 0.0, 1.0])
    covariance = 0.02 * numpy.eye(3) + 0.011 * (radii ** 2)[:, None, None] * numpy.einsum("pi,pj->pij", around, around) + 0.02 * numpy.outer(out, out)
    # ellipsoids of 90 % are sqrt(6.25 / 2.37) times as large as those of 50 %
    atoms = source(points, covariance=covariance.reshape(-1, 9), most=6.251 / 2.366 * covariance.reshape(-1, 9), rgb=numpy.uint8(6 * [[110, 125, 140]] + 6 * [[235, 160, 60]]))
    shown = figure(atoms, "Confidence Ellipsoid", GlyphTensorArray="covariance", GlyphShellArray="most", GlyphConfidence=0.5, ScaleFactor=1.0, GroundShadow="Across Z")
    pv.ColorBy(shown, ("POINTS", "rgb"))
    shown.MapScalars = 0
    bonds = session.with_cells(session.poly_data(points), "Lines", [(i, (i + 1) % 6) for i in range(6)] + [(i, i + 6) for i in range(6)])
    figure(session.source(bonds), "Tubes", view=pv.GetActiveView(), TubeRadius=0.07, DiffuseColor=[0.75] * 3, camera=((2.1, -7.0, 8.3), (0.0, -0.15, 0.0)), angle=28.0, up=(0.0, 1.0, 0.0))


def covariance_tubes(*_):
    """Where 400 particles that start together may be in the flow with uncertain strength: 90 % of them are inside the tube's ellipsoids."""
    lines, steps = [], 130
    for start in ((0.0, -2.6, 0.6), (-0.6, -1.2, 0.1), (-1.2, 0.3, -0.4), (1.3, 1.1, 0.9)):
        a, b, c = numpy.random.default_rng(3).normal((1.0, 0.8, 0.6), 0.035, (400, 3)).T
        speed = lambda p: numpy.stack([a * numpy.sin(p[:, 2]) + c * numpy.cos(p[:, 1]), b * numpy.sin(p[:, 0]) + a * numpy.cos(p[:, 2]), c * numpy.sin(p[:, 1]) + b * numpy.cos(p[:, 0])], axis=1)
        paths = [numpy.tile(start, (400, 1))]
        for _ in range(steps):
            paths.append(paths[-1] + 0.04 * speed(paths[-1] + 0.02 * speed(paths[-1])))
        lines.append(numpy.array(paths))
    paths = numpy.concatenate(lines)
    apart = paths - paths.mean(axis=1, keepdims=True)
    covariance = numpy.einsum("tpi,tpj->tij", apart, apart) / 399.0 + 4e-4 * numpy.eye(3)
    data = session.poly_data(paths.mean(axis=1), covariance=covariance.reshape(-1, 9), deviation=numpy.sqrt(numpy.linalg.eigvalsh(covariance)[:, -1]))
    session.with_cells(data, "Lines", [range(i, i + steps + 1) for i in range(0, len(paths), steps + 1)])
    figure(session.source(data), "Tubes", TubeRadiusArray="covariance", TubeRadius=2.5, bar=("deviation", (0.0, 0.4), "largest standard deviation", EMBER, (0.63, 0.03)),
           camera=((5.0, -10.0, 6.0), (0.9, 0.8, 0.9)), angle=24.0)


def third_party(path):
    """The eight tensors of tensors.vtk, by sign, or the helix of dt-helix.nhdr."""
    if path.endswith("tensors.vtk"):
        points, arrays = arrays_of(pv.OpenDataFile(path))
        figure(source(points, t=arrays["tensors1"].reshape(-1, 9)), "Signed Tensor Superquadric", GlyphTensorArray="t", GlyphTensorColoring="Sign", ScaleFactor=0.25,
               camera=((2.4, -3.0, 1.9), (0.62, 0.5, 0.4)))
        return
    raw = numpy.fromfile(os.path.splitext(path)[0] + ".raw", dtype=">f4").reshape(40, 39, 38, 7).astype(float)
    axes = [numpy.linspace(-2.0, 2.0, n) for n in (38, 39, 40)]
    z, y, x = (a.ravel() for a in numpy.meshgrid(axes[2], axes[1], axes[0], indexing="ij"))
    tensors = raw[..., 1:].reshape(-1, 6)  # xx xy xz yy yz zz
    diagonal_first = tensors[:, [0, 3, 5, 1, 4, 2]]
    mean = diagonal_first[:, :3].mean(axis=1, keepdims=True)
    apart = numpy.hstack([diagonal_first[:, :3] - mean, diagonal_first[:, 3:]])
    anisotropy = numpy.sqrt(1.5) * norms(apart) / numpy.maximum(norms(diagonal_first), 1e-30)
    inside = (raw[..., 0].ravel() > 0.5) & (anisotropy > 0.6)
    figure(source(numpy.array([x, y, z]).T[inside], d=diagonal_first[inside]), "Tensor Superquadric", GlyphTensorArray="d", GlyphTensorLayout="xx yy zz xy yz xz",
           GlyphDirectionColoring="Axes", ScaleFactor=5.2 / 39 / numpy.quantile(norms(diagonal_first[inside]), 0.9), camera=((5.6, -7.3, 4.4), (0.0, 0.0, -0.12)), angle=29.0)


def main():
    """Makes the pictures."""
    data, folder = begin()
    wanted = os.environ.get("RTGLYPHS_PICTURES", "").split()  # names, or none for all
    pictures = {"flow": flow, "point_load": point_load, "split_vectors": split_vectors, "uncertain_vectors": uncertain_vectors,
                "uncertain_directions": lambda *given: uncertain_vectors(*given, shape="Uncertain Direction"), "confidence_ellipsoids": confidence_ellipsoids,
                "covariance_tubes": covariance_tubes}
    shared = os.environ.get("RTGLYPHS_SHARED_DATA", "")
    for name, file in (("tensors-vtk", "tensors.vtk"), ("dt-helix", "dt-helix.nhdr")):
        path = os.path.join(shared, file)
        if shared and os.path.exists(path):
            pictures[name] = lambda _, __, path=path: third_party(path)
    for name in wanted or pictures:
        pictures[name](data, folder)
        save(pv.GetActiveView(), folder, name, cover.SIZE)
    pv.Disconnect()


if __name__ == "__main__":
    main()
