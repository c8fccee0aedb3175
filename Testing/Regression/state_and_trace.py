"""State file and Python trace: what a fresh process makes of them is what was saved, with each property of every_property.py.

Usage: pvpython state_and_trace.py save|state|trace
save writes picture, state file and trace; the other two, each in a process of its own, load one of them and compare.
"""
import json
import re
import sys

import numpy
import paraview.simple as pv
from paraview import smtrace
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

import comparison
import every_property
import property_reference
import session
from property_claims import GLYPHS, LEFT, SURFACE, TUBES, data_of
from session import value_of

STATE, TRACE, VALUES = "state.pvsm", "trace.py", "state-values.json"
#: what scripts and the window ask for at the moment, which nothing keeps; and what other values of other properties end,
#: whose own tests are view_settings.py and gui.py
MOMENTARY = {"FeatureImageFile", "StopRefinement", "SamplesPerRender", "RenderingQuality", "ColorFromData"}
#: who sets ScaleFactor has chosen it; of what is hidden there is no picture
OTHERS = {"ScaleFactorFromData": 0, "Visibility": 1}
#: what showing a display as ray-traced glyphs switches on
SWITCHED_ON = {"Orient", "Scaling", "ScaleFactorFromData"}
#: what pictures are taken with
PICTURED = {"ShadingMode": "Local", "GlyphLegend": "None"}


def wanted(kind):
    """Values of all properties of a representation, neither a default nor one that ParaView derives from the data."""
    found = {}
    for name, (kinds, entry) in every_property.exposed().items():
        rows = [row for row in every_property.ROWS if row.name == name and kind in (row.kinds or kinds) and row.value is not LEFT]
        if kind in kinds and entry.get("information_only") != "1" and name not in MOMENTARY:
            found[name] = OTHERS.get(name, rows[0].value)
    return found


def is_default(name, value):
    """Whether a property has the value without being set."""
    if name in SWITCHED_ON:
        return value == 1
    default = property_reference.default(every_property.exposed()[name][1])
    try:
        return [float(number) for number in default.split()] == numpy.atleast_1d(value).astype(float).tolist()
    except (TypeError, ValueError):
        return default == str(value)


def as_text(value):
    """A property's value for a file: numbers to the digits that text files keep, proxies by what they are."""
    if isinstance(value, pv.servermanager.Proxy):
        proxies = pv.servermanager.ProxyManager().SMProxyManager
        return value.GetXMLName() + " " + str(proxies.GetProxyName("lookup_tables", value.SMProxy))
    if isinstance(value, list):
        return [as_text(item) for item in value] if len(value) != 1 else as_text(value[0])
    return float("%.6g" % value) if isinstance(value, float) else str(value).strip("'")


def values(shown, kind):
    """The properties as they are now."""
    return {name: as_text(value_of(shown, name)) for name in wanted(kind) if shown.SMProxy.GetProperty(name)}


class traced:
    """Changes of an object's properties within, for the trace; ParaView's window marks them so for its panels."""

    def __init__(self, proxy):
        self.item = smtrace._create_trace_item_internal("PropertiesModified", [proxy])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.item.finalize()


def file_of(kind):
    """A file with the blocks of a scene; points are cells, too, with the same arrays."""
    data = data_of("blocks", kind)
    for number in range(data.GetNumberOfBlocks() if kind == GLYPHS else 0):
        block = data.GetBlock(number)
        session.with_cells(block, "Verts", [[point] for point in range(block.GetNumberOfPoints())])
        block.GetCellData().ShallowCopy(block.GetPointData())
    writer = vtkXMLMultiBlockDataWriter()
    writer.SetDataModeToAscii()
    writer.SetFileName(session.output("state-%s.vtm" % kind.split()[-1].lower()))
    writer.SetInputData(data)
    writer.Write()
    return writer.GetFileName()


def scene():
    """Glyphs, a surface and tubes with all of their properties set."""
    view = session.view(300, 200)
    session.look(view, (0.0, 0.0, 10.0), parallel_scale=1.25)
    displays = {}
    for kind in (GLYPHS, SURFACE, TUBES):
        shown = pv.Show(pv.OpenDataFile(file_of(kind)), view)
        shown.SetRepresentationType(kind)
        with traced(shown):
            for name, value in wanted(kind).items():
                if shown.SMProxy.GetProperty(name):
                    setattr(shown, name, value(None) if callable(value) else value)
        displays[kind] = shown
    hidden = pv.Show(pv.Cone(), view)
    hidden.SetRepresentationType(SURFACE)
    with traced(hidden):
        hidden.Visibility = 0
    return view, displays


def picture(view, shown, name):
    """The view's picture, without the noise of paths, which depends on the order of the displays, and words, which may move by a pixel."""
    for setting, value in PICTURED.items():
        setattr(shown, setting, value)
    return session.capture(view, "state-" + name)


def save():
    """The scene, made under trace."""
    smtrace.start_trace()
    view, displays = scene()
    with open(session.output(TRACE), "w") as file:
        file.write(smtrace.stop_trace())
    pv.SaveState(session.output(STATE))
    saved = {kind: values(shown, kind) for kind, shown in displays.items()}
    with open(session.output(VALUES), "w") as file:
        json.dump(saved, file)
    pixels = picture(view, displays[GLYPHS], "saved")
    covered = float(comparison.covered(pixels).mean())
    failures = [] if covered > 0.02 else ["only %.2f%% of the picture is covered" % (100 * covered)]
    for kind, found in saved.items():
        for name, value in found.items():
            given = wanted(kind)[name]
            if not callable(given) and name != "GlyphType" and value != as_text(given):
                failures.append("%s of %s is %s, not %s" % (name, kind, value, as_text(given)))
            if name != "Visibility" and is_default(name, given):
                failures.append("%s: %s is the default, which is no proof; every_property.py must begin with another value" % (name, given))
    return failures


def compare(what):
    """The active view and its representations against what was saved."""
    view = pv.GetActiveViewOrCreate("RenderView")
    with open(session.output(VALUES)) as file:
        saved = json.load(file)
    failures, displays = [], {}
    hidden = [shown for shown in view.Representations if getattr(shown, "Visibility", 1) == 0 and getattr(shown, "Representation", "") == SURFACE]
    if len(hidden) != 1:
        failures.append("%s: %d hidden displays" % (what, len(hidden)))
    for kind, properties in saved.items():
        found = [shown for shown in view.Representations if getattr(shown, "Representation", "") == kind and shown.Visibility]
        if len(found) != 1:
            return failures + ["%s: %d representations of the type %s" % (what, len(found), kind)]
        displays[kind] = found[0]
    # ParaView keeps neither FXAA in a state nor, outside its own window, size and background in a trace.
    view.UseFXAA = 0
    view.ViewSize = [300, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [channel / 255.0 for channel in session.BACKGROUND]
    loaded = {kind: values(shown, kind) for kind, shown in displays.items()}
    pixels = picture(view, displays[GLYPHS], "from-" + what)
    for kind, properties in saved.items():
        now = {**values(displays[kind], kind), **{name: loaded[kind][name] for name in PICTURED if name in properties}}
        failures += ["%s: %s of %s is %s, was %s" % (what, name, kind, now[name], value) for name, value in properties.items() if now[name] != value]
    share, mean, _ = comparison.difference(pixels, session.read_image(session.output("state-saved.png")))
    print("%s: %.3f%% of the pixels differ, mean %.4f" % (what, 100 * share, mean))
    # Translucent layers are blended in eight bits, in the order of the displays.
    if share > 0.0 or mean > 0.01:
        failures.append("%s: the picture is another one" % what)
    return failures


def load_state():
    """The state file in this process."""
    pv.LoadState(session.output(STATE))
    return compare("state")


def run_trace():
    """The trace in this process."""
    with open(session.output(TRACE)) as file:
        # ParaView 5.13 and 6.1 write such properties of color maps, which their own Python classes do not have.
        source = re.sub(r"\n *(\w+\.)?Using(2DTransferFunction|SeparateOpacityArray) ?= ?\d,?", "", file.read())
    exec(compile(source, TRACE, "exec"), {"__name__": "__main__"})
    return compare("trace")


def main(step):
    """One step."""
    session.load()
    session.finish({"save": save, "state": load_state, "trace": run_trace}[step]())


if __name__ == "__main__":
    main(sys.argv[1])
