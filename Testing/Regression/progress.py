"""Gathering many points, building their glyphs and sorting them report to ParaView's progress bar; few points do not.

Usage: pvpython progress.py
"""
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

import session
from checks import Checks

TEXTS = ("Gathering points", "Building glyphs")
TIMED = ("Sorting Glyphs",)  # reported once a frame has taken some tenths of a second


def blocks(count):
    """Points of two grids, which have to be computed."""
    data = vtkMultiBlockDataSet()
    for block in range(2):
        grid = vtkImageData()
        grid.SetDimensions(count // 20000, 100, 100)
        grid.SetOrigin(0.5 * block, 0.0, 0.0)
        grid.SetSpacing(10000.0 / count, 0.01, 0.01)
        data.SetBlock(block, grid)
    return data


def main():
    """What the handler of progress hears for many points and for few."""
    session.load()
    checks = Checks()
    handler = pv.servermanager.ActiveConnection.Session.GetProgressHandler()
    handler.SetProgressInterval(0.0)  # or what comes soon after something else is not heard
    told = []
    handler.AddObserver("ProgressEvent", lambda *_: told.append((handler.GetLastProgressText(), handler.GetLastProgress())))
    for count, wanted in ((4000000, True), (20000, False)):
        view = session.view(64, 48)
        session.look(view, (0.5, 0.5, 4.0))
        source = session.source(blocks(count))
        told.clear()
        shown = session.glyphs(source, view, Orient=0, ScaleFactor=0.003)
        pv.Render(view)
        checks.equal("glyphs", session.statistics(shown)["glyphs"], count)
        for text in TEXTS + (TIMED if wanted else ()):
            shares = [share for what, share in told if what and text in what]
            print("%d points, %s: %s" % (count, text, shares))
            checks.equal("%d points: %s is reported" % (count, text), bool(shares), wanted)
            checks.true("%s: %s is no rising fraction of 100" % (text, shares), shares == sorted(shares) and all(0 <= s <= 100 for s in shares))
        pv.Delete(view)
    checks.report()


if __name__ == "__main__":
    main()
