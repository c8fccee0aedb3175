"""Shading, light, samples, exposure and denoising are one value a view: set on one of its ray-traced displays, they are
set on all of them, also on those added later; other views keep theirs; states and traces bring them back.

Usage: pvpython view_settings.py
"""
import paraview.simple as pv
from paraview import smtrace

import session
from checks import Checks, cloud
from state_and_trace import traced

SURFACE = "Ray Traced Surface"
#: what is set, no default among it
SETTINGS = {
    "ShadingMode": "Path Tracing", "AmbientOcclusionRadius": 0.5, "AmbientOcclusionRays": 4, "PathsPerSample": 2,
    "MaximumBounces": 3, "LightIntensity": 0.7, "EnvironmentColor": [0.9, 0.8, 0.7], "ToneMapping": "Filmic", "Exposure": 0.5,
    "Denoising": "Never", "SamplesPerPixel": 3, "SamplesPerRender": 2, "InteractiveReduction": 4}
STATE = "view-settings.pvsm"


def values(shown):
    """The settings as a display has them."""
    found = {}
    for name in SETTINGS:
        value = shown.GetPropertyValue(name)
        # Numbers are stored in text files.
        found[name] = [round(item, 6) for item in value] if name == "EnvironmentColor" else value
    return found


def show(source, view, kind):
    """A ray-traced display with nothing set."""
    shown = pv.Show(source, view)
    shown.SetRepresentationType(kind)
    session.solid(shown, (0.9, 0.8, 0.7))
    return shown


def displays(view):
    """The ray-traced displays of a view."""
    return [shown for shown in view.Representations if getattr(shown, "Representation", "") in (session.REPRESENTATION, SURFACE)]


def check_all(checks, what, shown, wanted=None):
    """All of these displays have the wanted settings."""
    for number, display in enumerate(shown):
        found = values(display)
        for name, value in (wanted or SETTINGS).items():
            checks.true("%s: %s of display %d is %s, not %s" % (what, name, number, found[name], value),
                        str(found[name]).strip("'") == str(value))


def one_for_all(checks):
    """Each setting, from glyphs to a surface and back; a hidden display and one that is an ordinary surface take part."""
    view, other = session.view(80, 60), session.view(80, 60)
    points, ball = cloud(60), pv.Sphere(Radius=0.5)
    shown = [show(points, view, session.REPRESENTATION), show(ball, view, SURFACE)]
    plain = pv.Show(cloud(10, 4), view)
    hidden = show(cloud(20, 5), view, session.REPRESENTATION)
    hidden.Visibility = 0
    elsewhere = show(points, other, session.REPRESENTATION)
    pv.Render(view)
    pv.Render(other)
    default = values(elsewhere)
    for number, (name, value) in enumerate(SETTINGS.items()):
        setattr(shown[number % 2], name, value)
        for display, who in zip(shown + [hidden], ("glyphs", "surface", "hidden glyphs")):
            found = values(display)[name]
            checks.true("%s set on the %s: the %s have %s, not %s" % (name, ("glyphs", "surface")[number % 2], who, found, value),
                        str(found).strip("'") == str(value))
    checks.equal("settings of the other view", values(elsewhere), default)
    added = show(pv.Cone(), view, SURFACE)
    plain.SetRepresentationType(session.REPRESENTATION)
    pv.Render(view)
    check_all(checks, "displays added later", [added, plain])
    pv.Delete(other)
    return view


def picture_follows(checks):
    """The setting that was made last counts, whichever of the displays it was made on."""
    pictures = []
    for order in (1, -1):
        view = session.view(80, 60)
        shown = [show(cloud(60), view, session.REPRESENTATION), show(pv.Sphere(Radius=0.5), view, SURFACE)]
        shown[0].GlyphScaleFactor = 0.3
        shown[0].ShadingMode, shown[0].SamplesPerPixel = "Ambient Occlusion", 2
        pv.Render(view)
        first, second = shown[::order]
        first.Exposure = 1.0
        second.Exposure = -2.0
        session.look(view, (0.0, 0.0, 5.0))
        pictures.append(session.capture(view, "view-settings-order-%d" % order))
        pv.Delete(view)
    checks.covered("exposure", pictures[0], 0.1)
    checks.picture("exposure set on either display last", pictures[0], pictures[1])


def came_back(checks, what, view):
    """All displays of the view that a state or a trace has made have the settings."""
    found = displays(view)
    checks.equal(what + ": number of ray-traced displays", len(found), 2)
    check_all(checks, what, found)


def round_trips(checks):
    """A state file and a trace make displays with the same settings."""
    smtrace.start_trace()
    view = pv.CreateView("RenderView")
    view.ViewSize = [80, 60]
    shown = []
    for source, kind in ((pv.Wavelet(WholeExtent=[-2, 2] * 3), session.REPRESENTATION), (pv.Sphere(), SURFACE)):
        shown.append(pv.Show(source, view))
        shown[-1].SetRepresentationType(kind)
    # The window's panel shows one display, on which all of them are set.
    with traced(shown[0]):
        for name, value in SETTINGS.items():
            setattr(shown[0], name, value)
    pv.Render(view)
    trace = smtrace.stop_trace()
    with open(session.output("view-settings-trace.py"), "w", encoding="utf-8") as file:
        file.write(trace)
    pv.SaveState(session.output(STATE))
    for what, again in (("state", lambda: pv.LoadState(session.output(STATE))),
                        ("trace", lambda: exec(compile(trace, "trace", "exec"), {"__name__": "__main__"}))):
        pv.Delete(view)
        for source in list(pv.GetSources().values()):
            pv.Delete(source)
        again()
        view = pv.GetActiveViewOrCreate("RenderView")
        came_back(checks, what, view)
        pv.Render(view)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    pv.Delete(one_for_all(checks))
    picture_follows(checks)
    round_trips(checks)
    checks.report()


if __name__ == "__main__":
    main()
