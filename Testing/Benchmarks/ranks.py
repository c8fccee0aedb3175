"""What ranks that share the light send each other and hold, and how long a frame takes them.

Usage: pvpython ranks.py FOLDER [--side POINTS] [--size PIXELS] [--frames N] [--mpiexec "COMMAND"]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

A cube of spheres at the points of a grid, of which each rank has a block, with a hole through it, so that light passes from block to block. Each row is
of a group of ranks of its own, whose ranks trace with one thread each: on N cores at most N of them work at a time. Glyphs and bytes from others: what all
ranks together got once, before the first picture (RenderStatistics). Device: what all ranks hold there. Memory: the largest of a rank's process
(VmHWM). A frame: the camera turns by a degree, all samples anew. Written to FOLDER: ranks.csv.
"""
import argparse
import json
import os
import time

from frames import begin, counters, figures_of, memory, turning, write_table

#: ranks, shading mode, ParallelLight, radius in distances of the points
PLAN = [(ranks, mode, light, radius) for ranks in (1, 2, 4) for mode, light, radius in (
    ("Local", "Local", 0.0), ("Ambient Occlusion", "Neighbors", 2.0), ("Ambient Occlusion", "Neighbors", 8.0), ("Path Tracing", "Replicated", 0.0))]


def largest_process():
    """Peak memory of a rank: all ranks are children of the process that started this one."""
    parent = os.getppid()
    with open("/proc/%d/task/%d/children" % (parent, parent), encoding="ascii") as file:
        return max(memory("VmHWM", child) for child in file.read().split())


def measure(arguments):
    """One row, on all ranks that run this."""
    import paraview.simple as pv

    view = begin(arguments.size)
    half = arguments.side // 2
    grid = pv.Wavelet(WholeExtent=[-half, half] * 3)
    kept = pv.Calculator(Input=grid, ResultArrayName="kept", Function="if(coordsY^2+coordsZ^2<%g,0,1)" % (half / 3.0) ** 2)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    shown = pv.Show(kept, view)
    shown.SetRepresentationType("Ray Traced Glyphs")
    shown.GlyphType, shown.ScaleMode, shown.SelectScaleArray, shown.ScaleFactor = "Sphere", "Magnitude", "kept", 0.7
    pv.ColorBy(shown, None)
    shown.SamplesPerPixel, shown.Denoising = 1, "Never"
    shown.ShadingMode, shown.ParallelLight, shown.AmbientOcclusionRadius = arguments.mode, arguments.light, arguments.radius
    view.CameraPosition, view.CameraFocalPoint = [half * c for c in (3.4, 1.6, 1.2)], [0.0, 0.0, 0.0]
    start = time.monotonic()
    pv.Render(view)
    first = time.monotonic() - start
    told = counters(shown)
    times = turning(lambda: pv.Render(view), arguments.frames)
    print(json.dumps({"glyphs": told["glyphs"], "from others": told["neighborGlyphs"], "bytes from others": told["neighborBytes"],
                      "device bytes": told["deviceBytes"], "memory a rank": largest_process(), "first picture": round(first, 3), **times}))


def main():
    """All rows, each in processes of its own."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--side", type=int, default=101)
    parser.add_argument("--size", type=int, default=800)
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--limit", type=float, default=600.0)
    parser.add_argument("--mpiexec", default="mpiexec --oversubscribe --allow-run-as-root")
    for name, kind in (("mode", str), ("light", str), ("radius", float)):
        parser.add_argument("--" + name, type=kind)
    arguments = parser.parse_args()
    if arguments.mode:
        measure(arguments)
        return
    os.makedirs(arguments.folder, exist_ok=True)
    os.environ["LP_NUM_THREADS"] = "1"
    for name in [name for name in os.environ if name.startswith(("OMPI_", "PMIX_", "ORTE_"))]:
        del os.environ[name]  # a pvpython is a rank of its own, which would not start others
    rows = []
    for ranks, mode, light, radius in PLAN:
        command = arguments.mpiexec.split() + ["-n", str(ranks), "pvbatch", os.path.abspath(__file__)]
        own = ["--mode", mode, "--light", light, "--radius", str(radius)]
        for name in ("side", "size", "frames"):
            own += ["--" + name, str(getattr(arguments, name))]
        figures = figures_of("%d ranks, %s, %s, %g" % (ranks, mode, light, radius), [arguments.folder] + own, arguments.limit, command)
        rows.append({"ranks": ranks, "mode": mode, "light": light, "radius": radius, **figures})
    write_table(os.path.join(arguments.folder, "ranks.csv"), rows)


if __name__ == "__main__":
    main()
