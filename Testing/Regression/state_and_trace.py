"""State file and Python trace: what a fresh process makes of them is what was saved.

Usage: pvpython state_and_trace.py save|state|trace DATA-FOLDER
save writes picture, state file and trace; the other two, each in a process of its own, load one of them and compare.
"""
import json
import os
import sys

import paraview.simple as pv
from paraview import smtrace

import comparison
import session

#: what the saved scene sets: neither a default value nor one that ParaView derives from the data
PROPERTIES = {
    "GlyphShape": "Arrow", "GlyphScaleFactor": 0.35, "GlyphScaling": 1, "GlyphScaleArray": "velocity",
    "GlyphScaleMode": "Magnitude", "GlyphOrient": 1, "GlyphOrientationArray": "velocity", "GlyphOrientationMode": "Direction",
    "ArrowHeads": "Fixed", "ArrowReferenceMagnitude": 2.5, "ArrowShaftRadius": 0.05, "ArrowTipRadius": 0.15,
    "ArrowTipLength": 0.4, "ArrowTipRounding": 0.7, "GlyphMask": 1, "MaximumNumberOfGlyphs": 900, "GlyphSeed": 3,
    "SamplesPerPixel": 2, "SamplesPerRender": 1, "InteractiveReduction": 3, "ReplicateGlyphs": 1, "Specular": 0.4}
STATE, TRACE, VALUES = "state.pvsm", "trace.py", "state-values.json"


def values(shown):
    """The properties as they are now, as json knows them."""
    return json.loads(json.dumps({name: shown.GetPropertyValue(name) for name in PROPERTIES}, default=str))


class traced:
    """Changes of an object's properties within, for the trace; ParaView's window marks them so for its panels."""

    def __init__(self, proxy):
        self.item = smtrace._create_trace_item_internal("PropertiesModified", [proxy])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.item.finalize()


def scene(folder):
    """Arrows of the simulation's last step but two."""
    view = session.view(300, 200)
    reader = pv.OpenDataFile(folder + "/impact/impact.vtk.series")
    shown = pv.Show(reader, view)
    shown.SetRepresentationType(session.REPRESENTATION)
    with traced(shown):
        for name, value in PROPERTIES.items():
            setattr(shown, name, value)
    pv.ColorBy(shown, ("POINTS", "velocity"))
    shown.SetScalarBarVisibility(view, False)
    animation = pv.GetAnimationScene()
    with traced(animation):
        animation.AnimationTime = reader.TimestepValues[5]
    session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 4.0), (0.0, 0.0, 1.0))
    pv.Render(view)
    return view, shown


def save(folder):
    """The scene, made under trace."""
    smtrace.start_trace()
    view, shown = scene(folder)
    trace = smtrace.stop_trace()
    with open(session.output(TRACE), "w") as file:
        file.write(trace)
    pv.SaveState(session.output(STATE))
    with open(session.output(VALUES), "w") as file:
        json.dump(values(shown), file)
    pixels = session.capture(view, "state-saved")
    covered = float(comparison.covered(pixels).mean())
    failures = [] if covered > 0.02 else ["only %.2f%% of the picture is covered" % (100 * covered)]
    failures += ["%s is %s, not %s" % (name, found, PROPERTIES[name])
                 for name, found in values(shown).items() if str(found).strip("'") != str(PROPERTIES[name])]
    return failures


def compare(what):
    """The active view and its representation against what was saved."""
    view = pv.GetActiveViewOrCreate("RenderView")
    found = [shown for shown in view.Representations if getattr(shown, "Representation", "") == session.REPRESENTATION]
    if len(found) != 1:
        return ["%s: %d representations of the type" % (what, len(found))]
    # ParaView keeps neither FXAA in a state nor, outside its own window, size and background in a trace.
    view.UseFXAA = 0
    view.ViewSize = [300, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [channel / 255.0 for channel in session.BACKGROUND]
    pv.Render(view)
    with open(session.output(VALUES)) as file:
        saved = json.load(file)
    now = values(found[0])
    failures = ["%s: %s is %s, was %s" % (what, name, now[name], saved[name]) for name in saved if now[name] != saved[name]]
    pixels = session.capture(view, "state-from-" + what)
    share, mean, _ = comparison.difference(pixels, session.read_image(session.output("state-saved.png")))
    print("%s: %.3f%% of the pixels differ, mean %.4f" % (what, 100 * share, mean))
    if mean > 0.0:
        failures.append("%s: the picture is another one" % what)
    return failures


def load_state():
    """The state file in this process."""
    pv.LoadState(session.output(STATE))
    return compare("state")


def run_trace():
    """The trace in this process."""
    with open(session.output(TRACE)) as file:
        source = file.read()
    exec(compile(source, TRACE, "exec"), {"__name__": "__main__"})
    return compare("trace")


def main(step, folder):
    """One step."""
    session.load()
    steps = {"save": lambda: save(folder), "state": load_state, "trace": run_trace}
    session.finish(steps[step]())


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
