"""Time per frame of ray-traced glyphs beside ParaView's own ways of drawing the same 280,000 spheres.

Usage: pvpython speed.py FOLDER [--count N] [--size PIXELS] [--frames N] [--packed] [--only NAME,NAME]
Environment: RTGLYPHS_PLUGIN is the plugin's library.

Each competitor runs in a process of its own: it shows the scene of Data/spheres_280k.py (73% of the pixels covered) in a
view of PIXELS x PIXELS (or, --packed, the same centers with spheres so large that they nearly touch), then turns the camera by one degree a frame and takes the time of each frame on the wall and on all
cores. Written to FOLDER: speed.csv and one picture per competitor. The table gives medians, the CSV file all frames; "first image" is
from new data to finished picture.
"""
import argparse
import json
import os
import statistics
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Data"))
sys.dont_write_bytecode = True
import spheres_280k  # noqa: E402
from frames import counters, figures_of, memory, turning, write_table  # noqa: E402

OURS = "ray-traced glyphs"
#: competitor -> theta and phi resolution of its sphere, or None
COMPETITORS = {OURS: None, "3D Glyphs 6x6": 6, "3D Glyphs 12x12": 12, "3D Glyphs 24x24": 24, "Point Gaussian": None}
STAGES = ("sortSeconds", "buildSeconds", "uploadSeconds", "traceSeconds")


def show(pv, points, view, name, count):
    """The spheres drawn by one competitor, white."""
    shown = pv.Show(points, view)
    radius = spheres_280k.radius(count)
    if name == OURS:
        shown.SetRepresentationType("Ray Traced Glyphs")
        shown.GlyphType = "Sphere"
        shown.Orient = 0
        shown.ScaleFactor = 2.0 * radius
        shown.SamplesPerPixel = 1
    elif name == "Point Gaussian":
        shown.SetRepresentationType("Point Gaussian")
        shown.ShaderPreset = "Sphere"
        shown.GaussianRadius = radius
    else:
        shown.SetRepresentationType("3D Glyphs")
        shown.GlyphType = "Sphere"
        shown.GlyphType.ThetaResolution = shown.GlyphType.PhiResolution = COMPETITORS[name]
        shown.Orient = 0
        # With Scaling off, 3D Glyphs ignore the scale factor too.
        shown.Scaling = 1
        shown.ScaleMode = "No Data Scaling Off"
        shown.ScaleFactor = 2.0 * radius
    return shown


def resident_megabytes():
    """Peak resident memory of this process."""
    return memory("VmHWM") / 2.0 ** 20


def measure(name, scene, count, size, frames, folder):
    """Runs one competitor in this process and returns its figures."""
    import paraview.simple as pv

    pv._DisableFirstRenderCameraReset()
    if name == OURS:
        pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=vars(pv))
    points = pv.OpenDataFile(scene)
    points.UpdatePipeline()
    view = pv.CreateView("RenderView")
    view.ViewSize = [size, size]
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]
    for key, value in spheres_280k.CAMERA.items():
        setattr(view, key, value)
    pv.Render(view)
    before_megabytes = resident_megabytes()

    start = time.monotonic()
    shown = show(pv, points, view, name, count)
    pv.Render(view)
    figures = {"name": name, "first": time.monotonic() - start}
    if name == OURS:
        found = counters(shown)
        figures.update({stage: found.get(stage, "") for stage in STAGES})

    figures.update(turning(lambda: pv.Render(view), frames, "wall", "cpu"))
    figures.update(megabytes=resident_megabytes(), scene_megabytes=resident_megabytes() - before_megabytes)
    pv.SaveScreenshot(os.path.join(folder, name.replace(" ", "-") + ".png"), view)
    pv.Disconnect()
    return figures


def run_all(options):
    """Each competitor in its own pvpython."""
    scene = os.path.join(options.folder, "spheres.vtk")
    spheres_280k.write(scene, options.count)
    rows = []
    for name in options.only.split(",") if options.only else COMPETITORS:
        arguments = [os.path.abspath(__file__), options.folder, "--count", str(options.count), "--size", str(options.size), "--frames", str(options.frames),
                     "--measure", name] + (["--packed"] if options.packed else [])
        figures = figures_of(name, arguments, options.limit)
        if not figures:
            sys.exit("speed.py: %s gave no figures" % name)
        rows.append(figures)
    os.remove(scene)
    return rows


def report(rows, options):
    """Prints the table, writes the CSV."""
    ours = next((row for row in rows if row["name"] == OURS), None)
    print("\n%d spheres, %d x %d pixels, camera moving, medians" % (options.count, options.size, options.size))
    print("%-20s %9s %9s %7s %12s %8s" % ("", "wall s", "CPU s", "ratio", "first image", "peak MB"))
    for row in rows:
        wall, cpu = (statistics.median(row[what]) for what in ("wall", "cpu"))
        row["ratio"] = wall / statistics.median(ours["wall"]) if ours else ""
        print("%-20s %9.3f %9.3f %7s %12.3f %8.0f" % (
            row["name"], wall, cpu, "%.1f" % row["ratio"] if ours else "", row["first"], row["megabytes"]))
    if ours:
        print("first image of ours: " + ", ".join("%s %.3f" % (stage, ours[stage]) for stage in STAGES if ours.get(stage, "") != ""))
    write_table(os.path.join(options.folder, "speed.csv"), rows)


def main():
    """Either one competitor (--measure, for the child processes) or all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=spheres_280k.COUNT)
    parser.add_argument("--size", type=int, default=1200)
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--limit", type=float, default=900.0)
    parser.add_argument("--packed", action="store_true", help="spheres that nearly touch: every pixel is covered")
    parser.add_argument("--only")
    parser.add_argument("--measure", help=argparse.SUPPRESS)
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    if options.packed:
        spheres_280k.RADIUS = spheres_280k.PACKED_RADIUS
    if options.measure:
        scene = os.path.join(options.folder, "spheres.vtk")
        print(json.dumps(measure(options.measure, scene, options.count, options.size, options.frames, options.folder)), flush=True)
        return
    report(run_all(options), options)


if __name__ == "__main__":
    main()
