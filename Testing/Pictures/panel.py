"""Draws panel.png, the properties panel after the quick start of README.md. Runs inside ParaView's window.

Usage: RTGLYPHS_SCRIPT=panel.py RTGLYPHS_DATA=DATA-FOLDER RTGLYPHS_WINDOW_PROBE=libWindowProbe.so paraview --dr --plugins=RayTracedGlyphs
--plugin-search-paths=FOLDER --script=panel.py
"""
import os
import sys

import paraview.simple as pv

HERE = os.path.dirname(os.path.abspath(os.environ["RTGLYPHS_SCRIPT"]))
sys.path.insert(0, os.path.join(HERE, "..", "Regression"))
from window import Window, run  # noqa: E402


def main():
    """Arrows by velocity."""
    window = Window()
    window.resize("pqClientMainWindow", 1500, 1100)
    view = pv.GetActiveViewOrCreate("RenderView")
    grains = pv.OpenDataFile(os.environ["RTGLYPHS_DATA"] + "/impact/impact.vtk.series")
    pv.GetAnimationScene().AnimationTime = 0.8
    shown = pv.Show(grains, view)
    shown.SetRepresentationType("Ray Traced Glyphs")
    shown.ScaleMode, shown.SelectScaleArray, shown.SamplesPerPixel = "Magnitude", "velocity", 16
    pv.SetActiveSource(grains)
    pv.ResetCamera(view)
    pv.Render(view)
    window.wait(lambda: "glyphs" in " ".join(window.labels("propertiesPanel")), 5)
    window.wait(lambda: False, 20)
    return [] if window.picture("DisplayFrame", os.path.join(HERE, "panel.png")) else ["there is no panel"]


run("PANEL", main)
