"""Several ranks: the image is refined on all of them when the first has no glyphs, and fixed arrow heads are alike.

Usage: mpiexec -n RANKS pvbatch ranks_refinement.py
On one rank the pictures are stored; on several they are compared with the stored ones.
"""
import paraview.simple as pv
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import session
from checks import Checks, information, pending, refine, stepwise

SAMPLES = 8
RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
#: Script of a source whose points, random ones with vectors of very different lengths, all lie on the last rank; or half of
#: them on each of two.
POINTS = """
points = numpy.random.default_rng(11).uniform(-1.0, 1.0, (40, 3))
points = points[numpy.argsort(points[:, 0])]
arrays = {"flow": numpy.random.default_rng(12).normal(size=(40, 3)) * numpy.geomspace(0.2, 3.0, 40)[:, None]}
mine = slice(40 * rank // ranks, 40 * (rank + 1) // ranks) if %d else slice(0, 40 if rank == ranks - 1 else 0)
"""


def points_of(spread):
    """The source; spread: over all ranks, else all points on the last one."""
    return session.points_of_ranks(POINTS % int(spread))


def against_one_rank(checks, name, pixels):
    """The picture equals that of one rank."""
    if RANKS > 1:
        checks.picture("%s on %d ranks" % (name, RANKS), pixels, session.read_image(session.output("ranks-%s.png" % name)))


def capture(view, name):
    """A screenshot whose name has the number of ranks."""
    return session.capture(view, "ranks-" + name + ("" if RANKS == 1 else "-%d" % RANKS))


def empty_first_rank(checks):
    """Where the first rank has nothing to show, the others' image grows to its end all the same."""
    view = session.view(160, 120)
    shown = session.glyphs(points_of(False), view, Orient=0, ScaleFactor=0.4, samples=SAMPLES)
    stepwise(shown, 2)
    session.solid(shown, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    checks.true("nothing on the first rank: nothing is pending after the first render", pending(shown))
    checks.true("nothing on the first rank: the image stays unfinished", refine(view, shown))
    checks.equal("nothing on the first rank: samples", information(shown, "AccumulatedSamples"), SAMPLES)
    pixels = capture(view, "spheres")
    checks.covered("spheres", pixels, 0.1)
    against_one_rank(checks, "spheres", pixels)
    pv.Delete(view)


def arrow_heads(checks):
    """Fixed heads have the size that the mean over all ranks gives them, also when Scaling is switched on later."""
    view = session.view(240, 180)
    shown = session.glyphs(points_of(True), view, "Arrow", SelectOrientationVectors="flow", SelectScaleArray="flow",
                           ScaleFactor=0.4, ArrowHeads="Fixed", **{"GlyphType.TipRadius": 0.2, "GlyphType.ShaftRadius": 0.08})
    session.solid(shown, (0.3, 0.6, 0.9))
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    shown.ScaleMode = "Magnitude"
    pv.Render(view)
    pixels = capture(view, "arrows")
    checks.covered("arrows", pixels, 0.05)
    against_one_rank(checks, "arrows", pixels)
    shown.ParallelLight = "Replicated"
    pv.Render(view)
    checks.picture("arrows, replicated, on %d ranks" % RANKS, capture(view, "arrows-replicated"), pixels)
    pv.Delete(view)


def main():
    """Both parts; the script ends by itself: leaving early, MPI would call it a failure."""
    pv._DisableFirstRenderCameraReset()
    session.load()
    checks = Checks()
    empty_first_rank(checks)
    arrow_heads(checks)
    for failure in checks.failures:
        print("FAILED:", failure)
    print("RANKS TEST " + ("FAILED" if checks.failures else "PASSED"))


if __name__ == "__main__":
    main()
