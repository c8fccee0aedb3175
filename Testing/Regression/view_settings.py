"""Shading, light, samples, exposure and denoising are one value a view: set on one of its ray-traced displays, they are
set on all of them, also on those added later; other views keep theirs.

Usage: pvpython view_settings.py
"""
import paraview.simple as pv

import session
from checks import Checks, cloud

SURFACE = "Ray Traced Surface"
#: what is set, no default among it
SETTINGS = {
    "ShadingMode": "Path Tracing", "AmbientOcclusionRadius": 0.5, "Illumination": "Uniform", "Shadows": 1, "ShadowSoftness": 5.0, "GroundShadow": "Below", "OutlineWidth": 1.5, "OutlineColor": [0.1, 0.2, 0.3],
    "DepthCue": 0.4, "ToneMapping": "Filmic", "Exposure": 0.5,
    "Denoising": "Never", "SamplesPerPixel": 3}


def values(shown):
    """The settings as a display has them."""
    found = {}
    for name in SETTINGS:
        value = shown.GetPropertyValue(name)
        # Numbers are stored in text files.
        found[name] = [round(item, 6) for item in value] if name == "OutlineColor" else value
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


def picture_follows(checks, view, shown):
    """The setting that was made last counts, whichever of the displays it was made on."""
    pictures = []
    session.replace_data(shown[0].Input, cloud(60).GetClientSideObject().GetOutputDataObject(0))
    shown[0].ScaleFactor = 0.3
    shown[0].ShadingMode, shown[0].SamplesPerPixel = "Ambient Occlusion", 2
    for order in (1, -1):
        pv.Render(view)
        first, second = shown[::order]
        first.Exposure = 1.0
        second.Exposure = -2.0
        pictures.append(session.capture(view, "view-settings-order-%d" % order))
        first.Exposure = 0.0
    checks.covered("exposure", pictures[0], 0.1)
    checks.picture("exposure set on either display last", pictures[0], pictures[1])


def there_and_back(checks):
    """Path tracing set on one display, and the old shading on each in turn, also on one that is hidden and one that was made
    meanwhile: the picture is the one of before. Returns the view and two of its displays, which are all that it has then."""
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 5.0))
    shown = [show(cloud(40), view, session.REPRESENTATION), show(pv.Sphere(Radius=0.5), view, SURFACE), show(cloud(20, 5), view, session.REPRESENTATION)]
    shown[0].SamplesPerPixel = 1
    shown[2].Visibility = 0
    before = session.capture(view, "view-settings-before")
    for rendered in (False, True):
        shown[rendered].ShadingMode = "Path Tracing"
        path_traced = session.capture(view, "view-settings-paths")
        checks.true("path tracing changes nothing", (path_traced != before).mean() > 0.05)
        shown.append(show(cloud(10, 6), view, session.REPRESENTATION))
        shown[-1].Visibility = 0
        for display in shown[::1 if rendered else -1]:
            display.ShadingMode = "Local"
            if rendered:
                pv.Render(view)
        check_all(checks, "back again", shown, {"ShadingMode": "Local"})
        checks.picture("back again, rendered %d" % rendered, session.capture(view, "view-settings-after"), before, pixels=0.0, mean=0.0)
    for display in shown[2:]:
        pv.Delete(display)
    return view, shown[:2]


def quality(checks, view, shown):
    """A quality is the values that it stands for, on all displays, until one of them is changed; a state keeps it."""

    def found():
        return [[str(display.GetPropertyValue(name)).strip("'") for name in
                 ("RenderingQuality", "ShadingMode", "SamplesPerPixel", "Denoising", "Shadows", "GroundShadow", "OutlineWidth")] for display in shown]

    meant = {"Fast": ["Fast", "Local", "4", "While Refining", "0", "None", "0.0"], "Publication": ["Publication", "Ambient Occlusion", "256", "While Refining", "1", "Below", "1.0"],
             "Path Tracing": ["Path Tracing", "Path Tracing", "64", "While Refining", "1", "Below", "1.0"],  # as it was
             "Balanced": ["Balanced", "Ambient Occlusion", "32", "While Refining", "0", "None", "0.0"]}
    for number, (name, values_of_it) in enumerate(meant.items()):
        shown[number % 2].RenderingQuality = name
        checks.equal("quality " + name, found(), [values_of_it] * 2)
    pv.SaveState(session.output("quality.pvsm"))
    shown[0].Exposure = 0.5
    checks.equal("quality after a change of another property", found(), [meant["Balanced"]] * 2)
    shown[1].SamplesPerPixel = 31
    checks.equal("quality after a change", found(), [["Custom", "Ambient Occlusion", "31", "While Refining", "0", "None", "0.0"]] * 2)
    shown[0].RenderingQuality = "Balanced"
    checks.equal("quality set again", found(), [meant["Balanced"]] * 2)
    pv.Delete(view)
    for source in list(pv.GetSources().values()):
        pv.Delete(source)
    pv.LoadState(session.output("quality.pvsm"))
    view = pv.GetActiveView()
    shown = displays(view)
    checks.equal("quality of a state", found(), [meant["Balanced"]] * 2)
    outliving = shown[0].SMProxy
    pv.Render(view)
    pv.Delete(view)
    del view
    outliving.UpdatePropertyInformation()  # its statistics are the view's
    for source in list(pv.GetSources().values()):
        pv.Delete(source)


def main():
    """All parts."""
    session.load()
    checks = Checks()
    pv.Delete(one_for_all(checks))
    view, shown = there_and_back(checks)
    picture_follows(checks, view, shown)
    quality(checks, view, shown)
    checks.report()


if __name__ == "__main__":
    main()
