"""A trace, a Python state and a state file of ordinary surfaces name none of this plugin's properties: they run without it, and are as
large as without it.

Usage: pvpython plain_trace.py
"""
import re
import xml.etree.ElementTree

import paraview.simple as pv
from paraview import smstate, smtrace

import session
from checks import Checks

#: proxies that this plugin adds to all displays
OURS = (("representations", "RayTracedRepresentation"), ("internal_representations", "RayTracedImage"))


#: proxies, whose sources belong to the display, and a command
WITHOUT_VALUE = {"GlyphTensorLookupTable", "StopRefinement"}


def names_of(group, proxy):
    """Names of a prototype's properties."""
    prototype = pv.servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy(group, proxy)
    if not prototype:
        return set()
    iterator = prototype.NewPropertyIterator()
    iterator.Begin()
    names = set()
    while not iterator.IsAtEnd():
        names.add(iterator.GetKey())
        iterator.Next()
    return names


def assigned(script):
    """Names of the properties that a script sets on displays: one by one, or since ParaView 6 by Set(name=value, ...)."""
    found = set(re.findall(r"^\w*Display\w*\.(\w+)(?:\.\w+)* *=", script, re.MULTILINE))
    for call in re.findall(r"^\w*Display\w*\.Set\((.*?)^\)", script, re.MULTILINE | re.DOTALL):
        found |= set(re.findall(r"^ +(\w+)=", call, re.MULTILINE))
    return found


def main():
    """Displays of several types of data."""
    session.load()
    checks = Checks()
    ours = set().union(*(names_of(*own) for own in OURS)) - names_of("representations", "SurfaceRepresentation") \
        - names_of("representations", "Glyph3DRepresentation") - names_of("representations", "GlyphRepresentation") - {"Input"}
    print("%d properties of this plugin" % len(ours))
    for name in ("GlyphShape", "ScaleFactorFromData", "ShadingMode", "SamplesPerPixel", "MotionBlur", "TubeRadius"):
        checks.true("%s is no property of this plugin" % name, name in ours)
    smtrace.start_trace()
    view = pv.CreateView("RenderView")
    for source in (pv.Sphere(), pv.Wavelet(), pv.HyperTreeGridRandom(), pv.GroupDatasets(Input=[pv.Cone(), pv.Line()])):
        shown = pv.Show(source, view)
        shown.SetRepresentationType("Surface")
        shown.Opacity = 0.9
    pv.Render(view)
    trace = smtrace.stop_trace()
    with open(session.output("plain-trace.py"), "w", encoding="utf-8") as file:
        file.write(trace)
    found = assigned(trace) & ours
    checks.true("the trace shows no display", "Representation" in assigned(trace))
    checks.true("the trace names %s" % sorted(found), not found)
    found = assigned(smstate.get_state()) & ours
    checks.true("the Python state names %s" % sorted(found), not found)
    pv.SaveState(session.output("plain-state.pvsm"))
    found = {entry.get("name") for proxy in xml.etree.ElementTree.parse(session.output("plain-state.pvsm")).getroot().iter("Proxy")
             if proxy.get("group") == "representations" for entry in proxy.iter("Property")} & ours - WITHOUT_VALUE
    checks.true("the state file names %s" % sorted(found), not found)
    # What is shown by the plugin must be named all the same.
    shown.SetRepresentationType(session.REPRESENTATION)
    shown.GlyphType, shown.ScaleFactor = "Cone", 0.3
    pv.Render(view)
    found = assigned(smstate.get_state())
    checks.true("the Python state of ray-traced glyphs lacks their shape or size", {"GlyphType", "ScaleFactor"} <= found)
    checks.report()


if __name__ == "__main__":
    main()
