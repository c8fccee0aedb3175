"""Seconds that our code on the host needs for many points: gathering, bounds, instances, colors; and for edits of a panel.

Usage: pvpython large_data.py FOLDER [--count N] [--repeat N]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

In each turn each number of threads has a process of its own: one thread, and what is taken without asking; the table has all turns.
The stages are those of RenderStatistics. An edit is set and the view, of few pixels, rendered; "host" is the time of both without what the kernels say
that sending, sorting, building, tracing and denoising took, so ParaView's own fraction is in it. Each edit is made to and fro twice; the lesser time
counts, because the first one compiles programs. Written to FOLDER: large_data.csv.

Ten million points need some 8 GB of memory.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import time

import numpy

import frames

#: name -> environment of VTK's threads
THREADS = {"one thread": {"VTK_SMP_BACKEND_IN_USE": "Sequential"}, "all cores": {}}
STAGES = ("gatherSeconds", "boundsSeconds", "instanceSeconds", "colorSeconds")
KERNELS = ("sortSeconds", "buildSeconds", "uploadSeconds", "traceSeconds", "denoiseSeconds")
#: property -> two values; none changes the data
EDITS = {
    "Pickable": (0, 1), "Opacity": (0.5, 1.0), "SpecularPower": (20.0, 100.0), "Specular": (0.5, 0.0), "Ambient": (0.2, 0.0),
    "SamplesPerPixel": (2, 1), "ShadingMode": ("Ambient Occlusion", "Local"), "Exposure": (1.0, 0.0),
    "ToneMapping": ("Filmic", "None"), "GlyphTensorSharpness": (2.0, 3.0),
    "ArrowReferenceMagnitude": (2.0, 0.0), "MaximumNumberOfGlyphs": (4000, 5000),
}
#: seconds that an edit may take in our code
WANTED = 0.05


def scene(count):
    """Points with a scalar and a vector; in two blocks, so that gathering copies them."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

    random = numpy.random.default_rng(1)
    blocks = vtkMultiBlockDataSet()
    for block in range(2):
        data, points = vtkPolyData(), vtkPoints()
        points.SetData(numpy_to_vtk(random.random((count // 2, 3), dtype=numpy.float32), deep=True))
        data.SetPoints(points)
        for name, components in (("length", 1), ("vector", 3)):
            array = numpy_to_vtk(random.random((count // 2, components), dtype=numpy.float32), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        blocks.SetBlock(block, data)
    return blocks


def measure(count):
    """The figures of this process."""
    import paraview.simple as pv

    view = frames.begin(56)
    producer = frames.source(scene(count))
    view.CameraPosition, view.CameraFocalPoint = [0.5, 0.5, 4.0], [0.5, 0.5, 0.5]
    shown = pv.Show(producer, view)
    shown.SetRepresentationType("Ray Traced Glyphs")
    shown.GlyphType, shown.ScaleFactor, shown.SamplesPerPixel = "Sphere", 0.3 / count ** (1.0 / 3.0), 1
    shown.Orient, shown.ScaleMode, shown.SelectScaleArray = 0, "Magnitude", "length"
    shown.SetScalarColoring("length", pv.servermanager.GetAssociationFromString("POINTS"))
    pv.Render(view)
    first = frames.counters(shown)
    figures = {stage: first[stage] for stage in STAGES + KERNELS}
    for name, values in EDITS.items():
        least = {}
        for _ in range(2):
            for value in values:
                before = frames.counters(shown)
                start = time.monotonic()
                setattr(shown, name, value)
                pv.Render(view)
                seconds = time.monotonic() - start
                after = frames.counters(shown)
                for counter in ("gathers", "boundsBuilds", "instanceBuilds", "instanceUploads", "structureBuilds"):
                    if after[counter] != before[counter]:
                        print("%s = %s: %s moved" % (name, value, counter), file=sys.stderr)
                host = seconds - sum(after[stage] - before[stage] for stage in KERNELS)
                least[value] = min(least.get(value, host), host)
        figures[name] = max(least.values())
    pv.Disconnect()
    return figures


def main():
    """Either the figures of one process (--measure) or the table of all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=10000000)
    parser.add_argument("--repeat", type=int, default=7)
    parser.add_argument("--measure", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        print(json.dumps(measure(options.count)), flush=True)
        return
    os.makedirs(options.folder, exist_ok=True)
    turns = {name: [] for name in THREADS}
    for turn in range(options.repeat):
        for name, environment in THREADS.items():
            print("measuring %s, turn %d of %d ..." % (name, turn + 1, options.repeat), flush=True)
            command = ["pvpython", os.path.abspath(__file__), options.folder, "--count", str(options.count), "--measure"]
            run = subprocess.run(command, env={**os.environ, **environment}, stdout=subprocess.PIPE, text=True, check=False)
            line = next((line for line in run.stdout.splitlines() if line.startswith("{")), None)
            if line is None:
                sys.exit("large_data.py: '%s' gave no figures:\n%s" % (name, run.stdout))
            turns[name].append(json.loads(line))
    rows = [{"what": what, **{name: [turn[what] for turn in turns[name]] for name in THREADS}} for what in turns["one thread"][0]]
    print("\n%d points, seconds\n%-24s %12s %12s %7s" % (options.count, "", *THREADS, "ratio"))
    for row in rows:
        one, every = (statistics.median(row[name]) for name in THREADS)
        note = "above %g" % WANTED if row["what"] in EDITS and every >= WANTED else ""
        print("%-24s %12.3f %12.3f %7.2f %s" % (row["what"], one, every, one / max(every, 1e-9), note))
    frames.write_table(os.path.join(options.folder, "large_data.csv"), rows)


if __name__ == "__main__":
    main()
