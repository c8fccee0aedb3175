"""Exporters of scenes leave ray-traced glyphs out and say so, once each; what else is shown is in the file.

Usage: pvpython exporters.py
"""
import importlib.util
import os
import shutil
import traceback

import paraview.simple as pv

import session
from checks import Checks, cloud

SUFFIXES = ["x3d", "vrml", "gltf"]
# A part of this exporter is a Python module that a ParaView built without its web modules does not have, as Debian's 6.1.
if importlib.util.find_spec("paraview.web"):
    SUFFIXES.append("vtkjs")


def export(view, suffix, name):
    """(bytes of the file, what ParaView has said, what Python has raised)."""
    path = session.output("exported-%s.%s" % (name, suffix))
    if os.path.isdir(path):
        shutil.rmtree(path)  # what is left of a .vtkjs that has failed
    elif os.path.exists(path):
        os.remove(path)
    raised = []

    def save():
        try:
            pv.ExportView(path, view)
        except Exception:
            raised.append(traceback.format_exc().strip().splitlines()[-1])

    said = " ".join(session.messages(save).split())
    return os.path.getsize(path) if os.path.isfile(path) else 0, said, raised


def main():
    """An ordinary surface alone, with glyphs that are hidden, and with glyphs."""
    session.load()
    checks = Checks()
    view = session.view(80, 60)
    pv.Show(pv.Sphere(), view)
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    alone = {suffix: export(view, suffix, "alone") for suffix in SUFFIXES}
    shown = session.glyphs(cloud(50), view, Orient=0, ScaleFactor=0.3)
    for case in ("hidden", "shown"):
        shown.Visibility = int(case == "shown")
        pv.Render(view)
        for suffix in SUFFIXES:
            size, said, raised = export(view, suffix, case)
            what = "%s, glyphs %s" % (suffix, case)
            print("%s: %d bytes, alone %d; %s %s" % (what, size, alone[suffix][0], raised, said))
            checks.equal(what + ": raised", raised, [])
            checks.true("%s: %d bytes, the ordinary surface alone takes %d" % (what, size, alone[suffix][0]),
                        size >= 0.9 * alone[suffix][0] > 0)
            if case == "hidden":
                checks.equal(what + ": said", said, alone[suffix][1])
            else:
                checks.one_message(what, said, "ray-traced", "left out")
    checks.report()


if __name__ == "__main__":
    main()
