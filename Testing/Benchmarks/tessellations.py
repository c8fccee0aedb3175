"""Error and time of ParaView's 3D Glyphs with tessellated superquadrics beside ray-traced ones, on one scene.

Usage: pvpython tessellations.py FOLDER [--harmonics] [--count N] [--size PIXELS] [--frames N] [--exponent E]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

2,000 turned superquadrics of exponent 5 on every axis, sides 0.5 to 1, in a cube. ParaView's Superquadric source with analytic normals
in 6x12, 12x24, 24x48 and 96x192 facets (phi x theta) is what its 3D Glyphs copy; the source itself makes 8x16 of 6x12. Errors are against the ray-traced picture with the
same camera and lights, one ray a pixel: the fraction of pixels that only one of both covers, of those that the exact one covers; and
where both cover, the mean and the 99th percentile of the largest channel's difference in levels of 255. Times are of frames
that are taken in turns over all, with the camera turning by a degree. Written to FOLDER: tessellations.csv and one picture for each.

--harmonics: instead of superquadrics as many distribution functions of order 8, each of two fibers that cross, as spherical harmonics; beside
them surfaces of one mesh each, the vertices of a geodesic sphere of 42, 162, 362 and 2,562 vertices moved along their directions.
"""
import argparse
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Regression"))

import numpy
import paraview.simple as pv

import comparison
import directions
import odf
import session
from frames import columns, seconds_of, write_table

FACETS = ((6, 12), (12, 24), (24, 48), (96, 192))
#: pieces that an icosahedron's edges are cut into
FREQUENCIES = (2, 4, 6, 16)


def scene(count):
    """Superquadrics at random places, turned at random."""
    generator = numpy.random.default_rng(5)
    turns = generator.normal(size=(count, 4))
    return session.source(session.poly_data(generator.uniform(-1.0, 1.0, (count, 3)), size=generator.uniform(0.5, 1.0, (count, 3)),
                                            turn=turns / numpy.linalg.norm(turns, axis=1)[:, None]))


def ours(points, view, factor, exponent):
    """The scene as ray-traced glyphs."""
    return session.glyphs(points, view, "Superquadric", GlyphExponents=[exponent] * 3, ScaleFactor=factor, SelectScaleArray="size", ScaleMode="Vector Components", Orient=1, SelectOrientationVectors="turn",
                          OrientationMode="Quaternion")


def theirs(points, view, factor, exponent, facets):
    """The scene as 3D Glyphs of a tessellated source."""
    source = pv.Superquadric(ThetaRoundness=2.0 / exponent, PhiRoundness=2.0 / exponent, Size=0.5, Scale=[1.0, 1.0, 1.0],
                             PhiResolution=facets[0], ThetaResolution=facets[1], Toroidal=0)
    shown = pv.Show(points, view)
    shown.SetRepresentationType("3D Glyphs")
    connection = pv.servermanager.ProxyManager().NewProxy("internal_filters", "PipelineConnection")
    connection.GetProperty("Input").SetInputConnection(0, source.SMProxy, 0)
    connection.UpdateVTKObjects()
    shown.SMProxy.GetProperty("GlyphType").SetProxy(0, connection)
    shown.SMProxy.UpdateVTKObjects()
    shown.Orient, shown.OrientationMode, shown.SelectOrientationVectors = 1, "Quaternion", "turn"
    shown.Scaling, shown.ScaleMode, shown.SelectScaleArray = 1, "Vector Components", "size"
    shown.ScaleFactor = factor
    return shown, source


def crossings(count):
    """(places, coefficients of order 8) of distribution functions of two fibers each."""
    generator = numpy.random.default_rng(5)
    axes = generator.normal(size=(2, count, 3))
    axes /= numpy.linalg.norm(axes, axis=2, keepdims=True)
    ways, weights = odf.quadrature()
    project = odf.harmonics(ways) * weights[:, None]
    return generator.uniform(-1.0, 1.0, (count, 3)), sum(odf.bundle_distribution(fibers, ways) @ project for fibers in axes)


def alone(drawn, which):
    """Hides all but one."""
    for name, shown in drawn.items():
        shown.Visibility = int(name == which)


def measure(view, drawn, frames):
    """{name: columns of wall and processor seconds a frame}, taken in turns over all: the machine's speed changes."""
    camera, found = pv.GetActiveCamera(), {name: [] for name in drawn}
    for _ in range(frames):
        for name, seconds in found.items():
            alone(drawn, name)
            pv.Render(view)  # what was hidden is made ready
            camera.Azimuth(1.0)
            seconds.append(seconds_of(lambda: pv.Render(view)))
            camera.Azimuth(-1.0)
        camera.Azimuth(1.0)
    return {name: columns(seconds, "wall s", "CPU s") for name, seconds in found.items()}


def errors(image, exact):
    """Columns of what a picture has other than the exact one."""
    mask, exact_mask = comparison.covered(image), comparison.covered(exact)
    apart = numpy.abs(image - exact).max(axis=2)[mask & exact_mask]
    return {"silhouette %": round(100.0 * (mask != exact_mask).sum() / exact_mask.sum(), 4),
            "color mean": round(float(apart.mean()), 3), "color 99 %": float(numpy.percentile(apart, 99))}


def main():
    """Ours first, then the tessellations from coarse to fine."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--harmonics", action="store_true")
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--size", type=int, default=800)
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--exponent", type=float, default=5.0)
    options = parser.parse_args()
    os.environ["RTGLYPHS_OUTPUT"] = options.folder
    session.HANGS = 1800
    session.load()
    view = session.view(options.size, options.size)
    session.look(view, (0.6, 0.9, 4.6))
    factor = 1.1 / options.count ** (1.0 / 3.0)
    drawn = {}
    if options.harmonics:
        places, coefficients = crossings(options.count)
        scale = 0.5 * factor / float(numpy.abs(coefficients @ odf.harmonics(directions.geodesic()[0]).T).max())
        drawn["ray-traced"] = session.glyphs(session.source(session.poly_data(places, odf=coefficients)), view, "Spherical Harmonics",
                                             GlyphHarmonicsArray="odf", Orient=0, ScaleFactor=2.0 * scale)
        for frequency in FREQUENCIES:
            data = directions.meshes(places, coefficients, scale, frequency)
            drawn["meshes of %d vertices" % (10 * frequency ** 2 + 2)] = session.show(session.source(data), view, "Surface")
    else:
        drawn["ray-traced"] = ours(scene(options.count), view, factor, options.exponent)
        for facets in FACETS:
            shown, source = theirs(scene(options.count), view, factor, options.exponent, facets)
            inside = source.GetClientSideObject()
            made = (inside.GetPhiResolution(), inside.GetThetaResolution())
            drawn["3D Glyphs %dx%d" % facets + ("" if made == facets else " (made %dx%d)" % made)] = shown
    images = {}
    for name, shown in drawn.items():
        session.solid(shown, (0.85, 0.6, 0.3))
        alone(drawn, name)
        images[name] = session.capture(view, name.replace(" ", "-"))[:, :, :3].astype(int)
    times = measure(view, drawn, options.frames)
    rows = [{"what": name, **times[name], **(errors(image, images["ray-traced"]) if name != "ray-traced" else {})} for name, image in images.items()]
    write_table(os.path.join(options.folder, "tessellations.csv"), rows)
    print(*rows, sep="\n")
    session.finish()


if __name__ == "__main__":
    main()
