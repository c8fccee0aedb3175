#!/usr/bin/python3
"""What the plugin costs where nothing of it is shown: starts of pvpython and of ParaView's window, Show() of a Surface, states of 50 displays.

Usage: loaded.py PLUGIN [ROUNDS]     needs a DISPLAY; takes ROUNDS (5) turns with and without the plugin, one after the other
PLUGIN is the library RayTracedGlyphs.so. Prints medians in seconds of processor time, and the medians of the turns' ratios. Whatever else is in
PV_PLUGIN_PATH is left out.
"""
import json
import os
import resource
import statistics
import subprocess
import sys
import time

#: displays that are shown, and that a state has
SHOWN, DISPLAYS = 20, 50


def inside():
    """Runs in pvpython; prints {figure: seconds}."""
    import paraview.simple as pv
    pv._DisableFirstRenderCameraReset()
    view = pv.CreateView("RenderView")
    view.ViewSize = [64, 64]
    pv.Show(pv.Sphere(), view)
    pv.Render(view)
    found = {}

    def measure(name, work, count=1):
        start = time.process_time()
        result = work()
        found[name] = (time.process_time() - start) / count
        return result

    spheres = [pv.Sphere(Center=[i, 0, 0]) for i in range(DISPLAYS)]
    for sphere in spheres:
        sphere.UpdatePipeline()
    measure("Show() of a Surface", lambda: [pv.Show(sphere, view) for sphere in spheres[:SHOWN]], SHOWN)
    for sphere in spheres[SHOWN:]:
        pv.Show(sphere, view)
    measure("first picture of %d displays" % DISPLAYS, lambda: pv.Render(view))
    state = os.path.join(os.environ["RTGLYPHS_LOADED"], "loaded.pvsm")
    measure("save a state of %d displays" % DISPLAYS, lambda: pv.SaveState(state))
    pv.ResetSession()
    measure("load a state of %d displays" % DISPLAYS, lambda: pv.LoadState(state))
    os.remove(state)
    print(json.dumps(found), flush=True)
    os._exit(0)


def children():
    """Processor time of all processes that were waited for."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def turn(environment):
    """{figure: seconds} of all figures."""
    found = {}
    leave = os.path.join(environment["RTGLYPHS_LOADED"], "leave.py")
    with open(leave, "w", encoding="utf-8") as script:
        script.write("import os, paraview.simple\nparaview.simple.GetActiveViewOrCreate('RenderView')\nos._exit(0)\n")
    for name, command in (("start of pvpython", ["pvpython", leave]), ("start of ParaView's window", ["paraview", "--dr", "--script=" + leave])):
        start = children()
        subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        found[name] = children() - start
    os.remove(leave)
    run = subprocess.run(["pvpython", os.path.abspath(__file__)], env=environment, check=True, capture_output=True, text=True)
    return {**found, **json.loads(run.stdout.strip().splitlines()[-1])}


def main(plugin, rounds=5):
    """Turns without and with the plugin."""
    folder = os.path.dirname(os.path.abspath(plugin))
    if not os.path.exists(plugin):
        raise SystemExit("loaded.py: there is no %s" % plugin)
    plain = {name: value for name, value in os.environ.items() if not name.startswith("PV_PLUGIN")}
    plain["RTGLYPHS_LOADED"] = os.environ.get("TMPDIR", "/tmp")
    loaded = dict(plain, PV_PLUGIN_PATH=folder)
    turns = [(turn(plain), turn(loaded)) for _ in range(int(rounds))]
    print("| | without (s) | with (s) | ratio |\n|---|---|---|---|")
    for name in turns[0][0]:
        before, after = ([pair[which][name] for pair in turns] for which in (0, 1))
        ratios = [with_it / without for without, with_it in zip(before, after)]
        print("| %s | %.3f | %.3f | %.2f |" % (name, statistics.median(before), statistics.median(after), statistics.median(ratios)))


if __name__ == "__main__":
    if "RTGLYPHS_LOADED" in os.environ:
        inside()
    main(*sys.argv[1:])
