"""RenderStatistics has the present state without UpdatePropertyInformation().

Usage: pvpython statistics_alive.py
"""
import json

import paraview.simple as pv

import session
from checks import Checks, cloud


def main():
    """Reads the properties as a script does, after each render."""
    session.load()
    checks = Checks()
    view = session.view(80, 60)
    shown = session.glyphs(cloud(50), view, Orient=0, ScaleFactor=0.3, samples=2)
    session.look(view, (0.0, 0.0, 5.0))
    dispatches = 0
    for count in range(1, 4):
        session.look(view, (0.0, 0.0, 5.0 + count))
        pv.Render(view)
        text = shown.RenderStatistics
        print(text)
        found = json.loads(str(text).strip("'") or "{}")
        checks.true("render %d: there is no DeviceName" % count, bool(found.get("DeviceName")))
        checks.equal("render %d: AccumulatedSamples" % count, found.get("AccumulatedSamples"), 2)
        checks.equal("render %d: glyphs in RenderStatistics" % count, found.get("glyphs"), 50)
        checks.true("render %d: dispatches stay at %s" % (count, dispatches), found.get("dispatches", 0) > dispatches)
        dispatches = found.get("dispatches", 0)
    # As another program reads it: by the server manager's property.
    session.look(view, (0.0, 0.0, 4.0))
    pv.Render(view)
    found = json.loads(shown.SMProxy.GetProperty("RenderStatistics").GetElement(0) or "{}")
    checks.true("read from the server manager: dispatches stay at %s" % dispatches, found.get("dispatches", 0) > dispatches)
    checks.report()


if __name__ == "__main__":
    main()
