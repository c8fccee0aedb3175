"""In situ: in a simulation of two ranks a Catalyst script with the plugin writes the pictures that its extractors write in pvpython.

Usage: pvpython in_situ.py MPIEXEC ARGUMENT...     compares; the simulation is this script in pvbatch, which the arguments start
       pvbatch --sym in_situ.py simulate
"""
import os
import runpy
import shutil
import subprocess
import sys

import comparison
import session

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "catalyst_pipeline.py")
#: fraction of the pixels that may differ where arrows of different ranks cross
CROSSING = 0.002


class Grains:
    """What the script of session.spread() takes for its source."""

    def __init__(self):
        from vtkmodules.vtkCommonDataModel import vtkPolyData
        self.data = vtkPolyData()

    def GetOutput(self):
        """The data of this rank."""
        return self.data


def simulate():
    """Hands each rank's part of the steps to Catalyst."""
    from paraview.catalyst import bridge
    bridge.initialize()
    bridge.add_pipeline(SCRIPT)
    for step in range(8):
        grains = Grains()
        exec(session.SPREAD % (os.environ["RTGLYPHS_DATA"] + "/impact/impact_%02d.vtk" % step), {"self": grains})
        bridge.coprocess(0.2 * step, step, grains.data, name="grains")
    bridge.finalize()


def extracts(name):
    """An empty folder of that name, which the pipeline writes to."""
    folder = session.output(name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.environ["RTGLYPHS_EXTRACTS"] = folder
    return folder


def main(command):
    """The pictures of both ways."""
    from paraview.simple import SaveExtractsUsingCatalystOptions
    failures = []
    here = extracts("extracts")
    SaveExtractsUsingCatalystOptions(runpy.run_path(SCRIPT)["options"])
    there = extracts("in-situ")
    run = subprocess.run(command + ["--sym", os.path.abspath(__file__), "simulate"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(run.stdout)
    if run.returncode:
        failures.append("the simulation ends with %d" % run.returncode)
    names = [sorted(os.listdir(folder)) for folder in (here, there)]
    if names != [["step_4.png", "step_7.png"]] * 2:
        failures.append("extractors write %s, Catalyst %s" % tuple(names))
    else:
        pictures = [[session.read_image(os.path.join(folder, name)) for name in names[0]] for folder in (here, there)]
        for name, extracted, in_situ in zip(names[0], *pictures):
            share, mean, _ = comparison.difference(extracted, in_situ)
            covered = comparison.covered(in_situ).mean()
            print("%s: %.3f%% of the pixels differ, mean %.4f; %.1f%% are covered" % (name, 100 * share, mean, 100 * covered))
            if share > CROSSING or not 0.05 < covered < 0.9:
                failures.append("%s: in situ it is another picture" % name)
        if comparison.difference(*pictures[1])[0] < 0.01:
            failures.append("both steps have one picture")
    session.finish(failures)


if __name__ == "__main__":
    if sys.argv[1:] == ["simulate"]:
        simulate()
    else:
        main(sys.argv[1:])
