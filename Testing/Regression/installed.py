"""The plugin as users install it: only what they need is there, ParaView finds it by its name, it draws, and it can be removed.

Usage: pvpython installed.py CMAKE BUILD PVPYTHON     installs into a folder of its own, draws, uninstalls
       pvpython installed.py PREFIX                   draws with the plugin that lies below PREFIX
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

FILES = ["CHANGES.md", "LICENSE", "LIMITS.md", "README.md", "RayTracedGlyphs.so", "libvtkRayTracedGlyphs.so", "raytracedglyphs.xml"]


def draw(prefix):
    """A sphere, by the plugin that ParaView finds by its name."""
    checks = Checks()
    pv._DisableFirstRenderCameraReset()
    pv.LoadDistributedPlugin("RayTracedGlyphs", remote=False, ns=vars(pv))
    tracker = vtkPVPluginTracker.GetInstance()
    plugins = {tracker.GetPluginName(i): tracker.GetPluginFileName(i) for i in range(tracker.GetNumberOfPlugins())}
    path = os.path.realpath(plugins["RayTracedGlyphs"])
    checks.true("%s is not the installed one below %s" % (path, prefix), path.startswith(os.path.realpath(prefix) + "/lib"))
    checks.true("a second entry for the same plugin: %s" % plugins, "raytracedglyphs" not in plugins)
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 5.0))
    shown = session.glyphs(session.source(session.poly_data(numpy.zeros((1, 3)))), view, Orient=0)
    session.solid(shown, (0.9, 0.8, 0.3))
    checks.covered("one sphere", session.capture(view, "installed"), 0.02, 0.2)
    checks.report()


def main(cmake, build, pvpython):
    """Draws in a process of its own for each variable by which ParaView is told of plugins."""
    failures = []
    manifest = os.path.join(build, "install_manifest_plugin.txt")
    kept = manifest + ".kept"  # what somebody has installed from this folder can still be removed afterwards
    if os.path.exists(manifest):
        shutil.move(manifest, kept)
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True)
        paths = {name: os.path.join(folder, name) for folder, _, names in os.walk(prefix) for name in names}
        if sorted(paths) != FILES:
            failures.append("installed are %s, not %s" % (sorted(paths), FILES))
        for variable, value in (("PV_PLUGIN_PATH", os.path.dirname(paths["RayTracedGlyphs.so"])),
                                ("PV_PLUGIN_CONFIG_FILE", paths["raytracedglyphs.xml"])):
            result = subprocess.run([pvpython, __file__, prefix], env=dict(os.environ, **{variable: value}), check=False)
            if result.returncode:
                failures.append("%s=%s: the process ends with %d" % (variable, value, result.returncode))
        subprocess.run([cmake, "--build", build, "--target", "uninstall"], check=False)
        left = os.listdir(prefix)
        if left:
            failures.append("not uninstalled: %s" % left)
    if os.path.exists(kept):
        shutil.move(kept, manifest)
    session.finish(failures)


if __name__ == "__main__":
    if len(sys.argv) == 2:
        draw(sys.argv[1])
    main(*sys.argv[1:])
