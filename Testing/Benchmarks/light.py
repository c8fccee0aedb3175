"""What LightBenchmark error wrote for several scenes: error over time, per sampler.

Gain: mean squared error of independent samples over that of the sampler at the same time, that of independent samples being interpolated on logarithms and extrapolated as 1 / time; above 1 the sampler is better.
"""
import math

from frames import read_cells, read_table, spread, turns_of

TABLED = (1, 4, 16, 64, 256, 1024)
KEPT = {"occlusion": "sobol x8", "path": "sobol x4"}  # what the plugin does by default


def read(path):
    """{shading: {sampler: [row]}} with numbers; the denoised error's time has the denoiser's in it."""
    results = {}
    for row in read_table(path):
        results.setdefault(row["shading"], {}).setdefault(row["sampler"], []).append({
            "samples": int(row["samples"]), "seconds": float(row["cpu_seconds"]), "error": max(float(row["mse"]), 1e-12),
            "denoised": max(float(row["denoised_mse"]), 1e-12),
            "denoised_seconds": float(row["cpu_seconds"]) + float(row["denoise_seconds"])})
    return results


def at_time(rows, seconds):
    """Error of a sampler at that time."""
    points = [(math.log(r["seconds"]), math.log(r["error"])) for r in rows]
    x = math.log(seconds)
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return math.exp(y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    x0, y0 = points[0] if x < points[0][0] else points[-1]
    return math.exp(y0 - (x - x0))


def over_random(path):
    """{(shading, sampler): (lower, median, upper)} of a sample's time over that of an independent one of the same turn."""
    cells = {(row["shading"], row["sampler"]): turns_of(row["cpu_seconds"]) for row in read_cells(path) if row["samples"] == "1"}
    return {(shading, sampler): spread([[own / other for own, other in zip(*turns)] for turns in zip(processes, cells[shading, "random"])])
            for (shading, sampler), processes in cells.items()}


def table(scenes):
    """Markdown of (name, path) of scenes."""
    lines = ["| scene | light | sampler | time of a sample, ratio to random | " + " | ".join("%d" % n for n in TABLED) + " |", "|---|---|---|---|" + "---|" * len(TABLED)]
    for name, path in scenes:
        times = over_random(path)
        for shading, samplers in read(path).items():
            random = samplers["random"]
            for sampler, rows in samplers.items():
                found = {r["samples"]: r for r in rows}
                cells = ["" if n not in found else "%.2g" % found[n]["error"] if sampler == "random" else
                         "%.2f" % (at_time(random, found[n]["seconds"]) / found[n]["error"]) for n in TABLED]
                lower, median, upper = times[shading, sampler]
                time = "1.00" if sampler == "random" else "%.2f (%.2f, %.2f)" % (median, lower, upper)
                lines.append("| %s | %s | %s | %s | %s |" % (name, shading, sampler + (": error" if sampler == "random" else ": gain"), time, " | ".join(cells)))
                if sampler == KEPT[shading]:
                    cells = ["%.2g" % found[n]["denoised"] if n in found else "" for n in TABLED]
                    lines.append("| %s | %s | %s |  | %s |" % (name, shading, sampler + ", denoised: error", " | ".join(cells)))
    return "\n".join(lines)
