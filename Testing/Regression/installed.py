"""The plugin as users install it: only what they need is there, ParaView finds it by its name in another folder, too, it draws, without
Vulkan's loader it says so, a script that exits without disconnecting ends, and it can be removed.

Usage: pvpython installed.py CMAKE BUILD PVPYTHON     installs into a folder of its own, moves it, draws, uninstalls
       pvpython installed.py PREFIX [connected]       draws with the plugin that lies below PREFIX; exits at once
"""
import os
import shutil
import subprocess
import sys
import tempfile

import numpy
import paraview.simple as pv
from paraview.modules.vtkRemotingCore import vtkPVPluginTracker

import session
from checks import Checks

FILES = ["Data/RECIPES.md", "LICENSE", "Plugin/CHANGES.md", "Plugin/LIMITS.md", "README.md", "RayTracedGlyphs.so", "Representation/FEATURES.md",
         "Representation/PROPERTIES.md", "Representation/README.md", "raytracedglyphs.xml"]


def draw(prefix, connected=""):
    """A sphere, by the plugin that ParaView finds by its name."""
    checks = Checks()
    pv._DisableFirstRenderCameraReset()
    pv.LoadDistributedPlugin("RayTracedGlyphs", remote=False, ns=vars(pv))
    tracker = vtkPVPluginTracker.GetInstance()
    plugins = {tracker.GetPluginName(i): tracker.GetPluginFileName(i) for i in range(tracker.GetNumberOfPlugins())}
    path = os.path.realpath(plugins["RayTracedGlyphs"])
    checks.true("%s is not the installed one below %s" % (path, prefix), path.startswith(os.path.realpath(prefix) + os.sep))
    checks.true("a second entry for the same plugin: %s" % plugins, "raytracedglyphs" not in plugins)
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 5.0))
    shown = session.glyphs(session.source(session.poly_data(numpy.zeros((1, 3)))), view, Orient=0)
    session.solid(shown, (0.9, 0.8, 0.3))
    checks.covered("one sphere", session.capture(view, "installed"), 0.02, 0.2)
    if connected:
        sys.exit()
    checks.report()


def without_loader(folder):
    """An environment in which Vulkan's loader cannot be opened: what has its names is no library."""
    for name in ("libvulkan.so", "libvulkan.so.1"):
        with open(os.path.join(folder, name), "w"):
            pass
    return {"LD_LIBRARY_PATH": folder}


def main(cmake, build, pvpython):
    """Draws in a process of its own for each variable that names plugins to ParaView."""
    failures = []
    manifest = os.path.join(build, "install_manifest_plugin.txt")
    kept = manifest + ".kept"  # what the user has installed from this folder can still be removed afterwards
    if os.path.exists(manifest):
        shutil.move(manifest, kept)

    def run(what, environment, *script):
        result = subprocess.run([pvpython, *script], env=dict(os.environ, **environment), check=False)
        if result.returncode:
            failures.append("%s: the process ends with %d" % (what, result.returncode))

    with tempfile.TemporaryDirectory() as folder:
        prefix, moved = os.path.join(folder, "here"), os.path.join(folder, "elsewhere")
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True)
        os.rename(prefix, moved)
        paths = {}
        for inside, _, names in os.walk(moved):
            kind = os.path.basename(inside)
            paths.update({os.path.join(kind, name) if kind in ("Data", "Plugin", "Representation") else name: os.path.join(inside, name) for name in names})
        if sorted(paths) != FILES:
            failures.append("installed are %s, not %s" % (sorted(paths), FILES))
        plugin = paths["RayTracedGlyphs.so"]
        for variable, value in (("PV_PLUGIN_PATH", os.path.dirname(plugin)), ("PV_PLUGIN_CONFIG_FILE", paths["raytracedglyphs.xml"])):
            run("%s=%s" % (variable, value), {variable: value}, __file__, moved)
        try:  # how it ends is ParaView's
            subprocess.run([pvpython, __file__, moved, "connected"], env=dict(os.environ, PV_PLUGIN_PATH=os.path.dirname(plugin)), stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, timeout=200, check=False)
        except subprocess.TimeoutExpired:
            failures.append("a script that exits without disconnecting does not end")
        run("without Vulkan's loader", dict(without_loader(folder), RTGLYPHS_PLUGIN=plugin), os.path.join(os.path.dirname(__file__), "bad_input.py"),
            "no-device", "Vulkan's loader was not found", "libvulkan1")
        os.rename(moved, prefix)
        subprocess.run([cmake, "--build", build, "--target", "uninstall"], check=False)
        left = os.listdir(prefix)
        if left:
            failures.append("not uninstalled: %s" % left)
    if os.path.exists(kept):
        shutil.move(kept, manifest)
    session.finish(failures)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        draw(*sys.argv[1:])
    main(*sys.argv[1:])
