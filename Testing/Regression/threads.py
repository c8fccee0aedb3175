"""Glyphs, colors and bounds are the same for any number of threads.

Usage: pvpython threads.py PVPYTHON

Runs itself once for each kind of threads that VTK's SMP tools offer, with data of several chunks
(vtkRayTracedParallel.h), and compares what came out.
"""
import hashlib
import os
import subprocess
import sys

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

import session
from checks import Checks

POINTS = 60000
#: VTK's environment: one thread, ours where VTK has none, more threads than cores
KINDS = {"one": {"VTK_SMP_BACKEND_IN_USE": "Sequential"}, "default": {},
         "seven": {"VTK_SMP_BACKEND_IN_USE": "STDThread", "VTK_SMP_MAX_THREADS": "7"}}
LENGTHS = {"GlyphScaling": 1, "GlyphScaleArray": "length"}
TURNED = {"GlyphOrient": 1, "GlyphOrientationArray": "vector"}
#: name -> properties; sources are chosen by the first word
CASES = {
    "cloud lengths": {"GlyphShape": "Box", **LENGTHS, **TURNED},
    "cloud arrows": {"GlyphShape": "Arrow", "GlyphScaling": 1, "GlyphScaleArray": "vector", **TURNED},
    "cloud mask": {"GlyphMask": 1, "MaximumNumberOfGlyphs": 20011},
    "cloud tensors": {"GlyphShape": "Tensor Superquadric", "GlyphTensorArray": "tensor", "GlyphTensorColoring": "Trace"},
    "cloud numbers": {"GlyphShape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor",
                      "GlyphTensorColoring": "Fractional Anisotropy"},
    "cloud motion": {"MotionBlur": 1, "VelocityArray": "vector", "ShutterTime": 0.02},
    "blocks lengths": LENGTHS,
    "ghosts lengths": LENGTHS,
}


def cloud():
    """Points with a few whose values make no glyph."""
    random = numpy.random.default_rng(1)
    length = random.uniform(0.5, 2.0, POINTS)
    length[::1000] = numpy.nan
    return session.poly_data(random.uniform(-1.0, 1.0, (POINTS, 3)).astype(numpy.float32), length=length,
                             vector=random.normal(size=(POINTS, 3)).astype(numpy.float32),
                             tensor=random.normal(size=(POINTS, 9)))


def grid():
    """Points and cells of which many are ghosts."""
    random = numpy.random.default_rng(2)
    data = vtkImageData()
    data.SetDimensions(41, 41, 41)
    data.SetOrigin(-1.0, -1.0, -1.0)
    data.SetSpacing(0.05, 0.05, 0.05)
    session.add_arrays(data, length=random.uniform(0.5, 2.0, data.GetNumberOfPoints()).astype(numpy.float32))
    for attributes, tuples in ((data.GetPointData(), data.GetNumberOfPoints()), (data.GetCellData(), data.GetNumberOfCells())):
        ghosts = numpy_to_vtk((random.random(tuples) < 0.6).astype(numpy.uint8), deep=True)
        ghosts.SetName("vtkGhostType")
        attributes.AddArray(ghosts)
    return data


def blocks():
    """Blocks of which each lacks arrays of the other."""
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, cloud())
    data.SetBlock(2, grid())
    return data


def show_all():
    """Prints a line for each case."""
    session.load()
    sources = {"cloud": session.source(cloud()), "blocks": session.source(blocks()), "ghosts": session.source(grid())}
    for name, properties in CASES.items():
        view = session.view(160, 120)
        shown = session.glyphs(sources[name.split()[0]], view, samples=1, **{"GlyphOrient": 0, "GlyphScaleFactor": 0.02, **properties})
        pv.ColorBy(shown, ("POINTS", "length"))
        session.look(view, (0.0, 0.0, 5.0))
        picture = session.capture(view, "threads-" + name.replace(" ", "-"))
        counters = session.statistics(shown)
        bounds = view.SMProxy.GetRenderer().ComputeVisiblePropBounds()
        print("CASE", name, hashlib.sha1(picture.tobytes()).hexdigest(), counters["glyphs"], counters["skippedGlyphs"], *bounds,
              flush=True)
        pv.Delete(view)
    session.finish()


def main():
    """One process for each kind of threads."""
    checks = Checks()
    lines = {}
    for kind, environment in KINDS.items():
        run = subprocess.run([sys.argv[1], os.path.abspath(__file__)], env={**os.environ, **environment},
                             stdout=subprocess.PIPE, text=True, check=False)
        lines[kind] = [line for line in run.stdout.splitlines() if line.startswith("CASE")]
        checks.equal(kind + ": number of cases", len(lines[kind]), len(CASES))
    for kind in KINDS:
        for first, other in zip(lines["one"], lines[kind]):
            checks.equal("threads: " + kind, other, first)
    checks.true("glyphs", all(int(line.split()[4]) > 10000 for line in lines["one"]))
    checks.report()


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main()
    else:
        show_all()
