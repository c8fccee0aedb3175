"""Plays a time series of arrows in a chamber and says where the time of a step goes and whether memory grows.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython steps.py FOLDER OUTPUT.csv [STEPS [PIXELS [BLUR]]]

FOLDER: written by Data/injection.py with 12,500 particles and 657,000 triangles. STEPS (default 200) go round and round through its
steps, in a view of PIXELS x PIXELS (default 800), one sample a pixel; BLUR: 1 shows blurred spheres instead of arrows.
Seconds of wall time; "other" is what ParaView and OpenGL do.
"""
import csv
import os
import sys
import time

import paraview.simple as pv

from frames import begin, counters, memory

STAGES = ("sortSeconds", "buildSeconds", "uploadSeconds", "traceSeconds")


def main():
    """Plays and measures."""
    folder, output = sys.argv[1], sys.argv[2]
    steps, pixels, blur = [int(value) for value in sys.argv[3:6]] + [200, 800, 0][len(sys.argv[3:6]):]
    view = begin(pixels)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [1.8, 9.0, 2.5], [1.8, 0.0, 0.0], [0.0, 0.0, 1.0]
    wall = pv.OpenDataFile(os.path.join(folder, "chamber.vtk"))
    surface = pv.Show(wall, view)
    surface.SetRepresentationType("Ray Traced Surface")
    # Of what a view shows the largest number counts.
    surface.SamplesPerPixel = 1
    series = pv.OpenDataFile(os.path.join(folder, "injection.vtk.series"))
    shown = pv.Show(series, view)
    shown.SetRepresentationType("Ray Traced Glyphs")
    shown.SamplesPerPixel = 1
    shown.ScaleFactor = 0.03
    if blur:
        shown.MotionBlur, shown.VelocityArray, shown.AccelerationArray = 1, "velocity", "acceleration"
        shown.Orient, shown.ShutterTime = 0, 0.03
    else:
        shown.GlyphType, shown.Orient, shown.SelectOrientationVectors = "Arrow", 1, "velocity"
        shown.SelectScaleArray, shown.ScaleMode = "velocity", "Magnitude"
    times = series.TimestepValues
    view.ViewTime = times[0]
    pv.Render(view)
    rows = []
    for step in range(steps):
        now = times[(step + 1) % len(times)]
        before = counters(shown)
        start = time.perf_counter()
        view.ViewTime = now
        pv.UpdatePipeline(now, series)
        read = time.perf_counter()
        pv.Render(view)
        end = time.perf_counter()
        after = counters(shown)
        row = {"step": step, "pipeline": read - start}
        row.update({stage[:-7]: after[stage] - before[stage] for stage in STAGES})
        row["other"] = end - read - sum(row[stage[:-7]] for stage in STAGES)
        row["total"] = end - start
        row["instance_uploads"] = after["instanceUploads"] - before["instanceUploads"]
        row["structure_builds"] = after["structureBuilds"] - before["structureBuilds"]
        row["resident_mb"], row["device_mb"] = memory("VmRSS") / 2.0 ** 20, after["deviceBytes"] / 2.0 ** 20
        rows.append(row)
        with open(output, "w" if step == 0 else "a", encoding="ascii", newline="") as out:
            writer = csv.DictWriter(out, list(row))
            if step == 0:
                writer.writeheader()
            writer.writerow({key: "%.5g" % value for key, value in row.items()})
    for key in ("resident_mb", "device_mb"):
        print(key + ": " + ", ".join("%.1f after step %d" % (rows[at - 1][key], at) for at in (1, 50, 100, 200, steps) if at <= steps))
    print("uploads a step: %s" % sorted({row["instance_uploads"] for row in rows}))
    pv.Disconnect()


if __name__ == "__main__":
    main()
