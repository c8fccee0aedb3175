"""Glyphs, colors and bounds are the same for any number of threads.

Usage: pvpython threads.py

Makes the glyphs of data of several chunks (RayTracedParallel.h) once for each kind of threads, and compares what came out.
"""
import hashlib
import os

import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

import session
from checks import Checks

POINTS = 60000
#: the environment variable by which users choose VTK's threads
CHOICE = "VTK_SMP_BACKEND_IN_USE"
#: VTK's backend, and what the environment says: one thread, ours where VTK has none, and VTK's
KINDS = {"one": ("Sequential", "Sequential"), "default": ("Sequential", None), "several": ("STDThread", "STDThread")}
LENGTHS = {"ScaleMode": "Magnitude", "SelectScaleArray": "length"}
TURNED = {"Orient": 1, "SelectOrientationVectors": "vector"}
#: name -> properties; sources are chosen by the first word
CASES = {
    "cloud lengths": {"GlyphType": "Box", **LENGTHS, **TURNED},
    "cloud arrows": {"GlyphType": "Arrow", "ScaleMode": "Magnitude", "SelectScaleArray": "vector", **TURNED},
    "cloud mask": {"GlyphMode": "Random", "MaximumNumberOfGlyphs": 20011},
    "cloud tensors": {"GlyphShape": "Tensor Superquadric", "GlyphTensorArray": "tensor", "GlyphTensorColoring": "Trace"},
    "cloud numbers": {"GlyphShape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor",
                      "GlyphTensorColoring": "Fractional Anisotropy"},
    "cloud eigenvalues": {"GlyphShape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor", "GlyphTensorColoring": "Eigenvalues"},
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
        session.add_arrays(data, attributes, vtkGhostType=(random.random(tuples) < 0.6).astype(numpy.uint8))
    return data


def blocks():
    """Blocks of which each lacks arrays of the other."""
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, cloud())
    data.SetBlock(2, grid())
    return data


def set_threads(backend, environment):
    """VTK's threads for what comes, with the environment that RayTracedParallel looks at."""
    vtkSMPTools.SetBackend(backend)
    if environment:
        os.environ[CHOICE] = environment
    else:
        os.environ.pop(CHOICE, None)


def shown_by(checks, stage, data, name, properties):
    """(checksum of the picture, numbers, bounds) of glyphs that are made for it."""
    built = session.statistics(stage.settings.shown).get("instanceBuilds", 0) if stage.settings else 0  # none before the first picture
    copy = data.NewInstance()
    copy.DeepCopy(data)
    shown = stage.show(copy, "Sphere", **{"Orient": 0, "ScaleFactor": 0.02, **properties})
    pv.ColorBy(shown, ("POINTS", "length"))
    picture = session.capture(stage.view, "threads-" + name.replace(" ", "-"))
    checks.covered(name, picture, 0.01)
    counters = session.statistics(shown)
    checks.true(name + ": no glyphs were made", counters["instanceBuilds"] > built)
    bounds = stage.view.SMProxy.GetRenderer().ComputeVisiblePropBounds()
    stage.hide()
    return hashlib.sha1(picture.tobytes()).hexdigest(), counters["glyphs"], counters["skippedGlyphs"], bounds


def main():
    """Each case once for each kind of threads, in one view, so that programs are compiled once."""
    session.load()
    checks = Checks()
    view = session.view(160, 120)
    session.look(view, (0.0, 0.0, 5.0))
    subjects = {"cloud": cloud(), "blocks": blocks(), "ghosts": grid()}
    stages = {name: session.Stage(view) for name in subjects}
    for name, properties in CASES.items():
        found = {}
        for kind, threads in KINDS.items():
            set_threads(*threads)
            subject = name.split()[0]
            found[kind] = shown_by(checks, stages[subject], subjects[subject], name, properties)
            checks.equal("%s with threads: %s" % (name, kind), found[kind], found["one"])
        print(name, found["one"], flush=True)
        checks.within(name + ": glyphs", found["one"][1], 10001, 3 * POINTS)
        if "GlyphMode" in properties:
            checks.equal(name + ": glyphs", found["one"][1], properties["MaximumNumberOfGlyphs"])
    checks.report()


if __name__ == "__main__":
    main()
