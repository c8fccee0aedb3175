"""Draws the pictures of Data/RECIPES.md, recipes/*.png: each recipe as its script in Data/recipes has it, in the quality Balanced.

Usage: RTGLYPHS_PLUGIN=FILE pvpython recipes.py [NAME...]
"""
import glob
import os
import runpy
import sys
import tempfile

import paraview.simple as pv

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Regression"))
import session  # noqa: E402

WIDTH, HEIGHT = 400, 300
#: recipe -> direction of view and upward direction; others are seen from above at the front
FROM = {"many_particles": ((0.0, -1.0, 0.15), (0.0, 0.0, 1.0)), "diffusion_tensors": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
        "openfoam_cells": ((0.0, -0.5, 1.0), (0.0, 1.0, 0.0)), "calculix_stress": ((-0.6, -0.2, 0.7), (0.0, 0.0, 1.0))}
#: recipe -> view angle in degrees; others have 27
ANGLES = {"calculix_stress": 21.5}


def main():
    """All, or those that are named."""
    session.load()
    scripts = os.path.join(HERE, "..", "..", "Data", "recipes")
    folder = os.path.join(HERE, "recipes")
    os.makedirs(folder, exist_ok=True)
    for name in sys.argv[1:] or sorted(os.path.basename(path)[:-3] for path in glob.glob(os.path.join(scripts, "*.py"))):
        view = session.view(WIDTH, HEIGHT, (255, 255, 255))  # which the script takes
        with tempfile.TemporaryDirectory() as work:
            os.chdir(work)
            case = runpy.run_path(os.path.join(scripts, name + ".py"))
            shown = case["shown"]
            shown.RenderingQuality = "Balanced"
            if shown.LookupTable:
                shown.SetScalarBarVisibility(view, False)
            position, up = FROM.get(name, ((0.45, -0.8, 0.5), (0.0, 0.0, 1.0)))
            view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = (0.0, 0.0, 0.0), position, up
            pv.ResetCamera(view)
            view.CameraViewAngle = ANGLES.get(name, 27.0)
            pv.SaveScreenshot(os.path.join(folder, name + ".png"), view, ImageResolution=[WIDTH, HEIGHT])
        pv.Delete(view)
        for source in list(pv.GetSources().values()):
            pv.Delete(source)
        os.chdir(HERE)
    session.finish()


if __name__ == "__main__":
    main()
