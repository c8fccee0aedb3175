"""Runs inside ParaView's window: the images of a comparative view's parts are refined until all are finished.

Usage: paraview --plugin-search-paths=DIR --plugins=RayTracedGlyphs --script=comparative.py
Prints COMPARATIVE TEST PASSED as its last line.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(os.environ.get("RTGLYPHS_SCRIPT", "."))))

import paraview.simple as pv  # noqa: E402
from vtkmodules.vtkCommonCore import vtkCollection  # noqa: E402

import session  # noqa: E402
from checks import cloud, information, pending  # noqa: E402
from window import Window, run, say  # noqa: E402

#: of each part: the image of one must not end the refinement of the other
SAMPLES = [20, 40]
#: seconds within which the images must be finished; they take a few
LIMIT = 240.0


def parts(view):
    """The ray-traced displays of a comparative view's parts."""
    views = vtkCollection()
    view.SMProxy.GetViews(views)
    found = []
    for i in range(views.GetNumberOfItems()):
        part = pv.servermanager._getPyProxy(views.GetItemAsObject(i))
        found += [shown for shown in part.Representations if getattr(shown, "Representation", "") == session.REPRESENTATION]
    return found


def main():
    """Two parts beside each other."""
    failures = []
    window = Window()
    pv._DisableFirstRenderCameraReset()
    layout = pv.GetLayout()
    layout.PreviewMode = [400, 200]
    view = pv.CreateView("ComparativeRenderView")
    pv.AssignViewToLayout(view, layout, hint=0)
    view.Dimensions = [2, 1]
    shown = session.glyphs(cloud(10000), view, "Sphere", Orient=0, ScaleFactor=0.05)
    shown.ShadingMode, shown.SamplesPerPixel = "Ambient Occlusion", SAMPLES[0]
    pv.ResetCamera(view)
    pv.Render(view)
    for part, samples in zip(parts(view), SAMPLES):
        part.SamplesPerPixel = samples
    pv.Render(view)
    counts = [information(part, "AccumulatedSamples") for part in parts(view)]
    say("samples after the first render: %s" % counts)
    if len(counts) != 2 or max(counts) >= min(SAMPLES):
        failures.append("the parts have %s samples after the first render" % counts)
    if not window.wait(lambda: not any(pending(part) for part in parts(view)), LIMIT):
        failures.append("after %g s the images are pending" % LIMIT)
    counts = [information(part, "AccumulatedSamples") for part in parts(view)]
    say("samples at rest: %s" % counts)
    if counts != SAMPLES:
        failures.append("the parts have %s samples at rest" % counts)
    return failures


run("COMPARATIVE", main)
