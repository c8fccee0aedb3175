#!/usr/bin/python3
"""What LightBenchmark error wrote for several scenes, plotted and as the table of tables.py: error over time, per sampler.

Usage: light.py PLOT.png NAME=RESULTS.csv ...
Gain: mean squared error of independent samples over that of the sampler at the same time, that of independent samples being interpolated on logarithms and extrapolated as 1 / time; above 1 the sampler is better.
"""
import math
import sys

from frames import read_table

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


def table(scenes):
    """Markdown of (name, path) of scenes."""
    lines = ["| scene | light | sampler | " + " | ".join("%d" % n for n in TABLED) + " |", "|---|---|---|" + "---|" * len(TABLED)]
    for name, path in scenes:
        for shading, samplers in read(path).items():
            random = samplers["random"]
            for sampler, rows in samplers.items():
                found = {r["samples"]: r for r in rows}
                cells = ["" if n not in found else "%.2g" % found[n]["error"] if sampler == "random" else
                         "%.2f" % (at_time(random, found[n]["seconds"]) / found[n]["error"]) for n in TABLED]
                lines.append("| %s | %s | %s | %s |" % (name, shading, sampler + (": error" if sampler == "random" else ": gain"), " | ".join(cells)))
                if sampler == KEPT[shading]:
                    cells = ["%.2g" % found[n]["denoised"] if n in found else "" for n in TABLED]
                    lines.append("| %s | %s | %s | %s |" % (name, shading, sampler + ", denoised: error", " | ".join(cells)))
    return "\n".join(lines)


def plot(scenes, path_of_plot):
    """Error over time."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, len(scenes), figsize=(4.6 * len(scenes), 7.6), squeeze=False)
    for column, (name, path) in enumerate(scenes):
        for axis, (shading, samplers) in zip(axes[:, column], read(path).items()):
            axis.set_prop_cycle(color=plt.get_cmap("tab20").colors)
            for sampler, rows in samplers.items():
                axis.loglog([r["seconds"] for r in rows], [r["error"] for r in rows], "o-", label=sampler, markersize=3,
                            linewidth=2.5 if sampler == KEPT[shading] else 1.2)
                if sampler == KEPT[shading]:
                    axis.loglog([r["denoised_seconds"] for r in rows], [r["denoised"] for r in rows], "s--", color="0.5",
                                label=sampler + ", denoised", markersize=3)
            axis.set_xlabel("processor seconds")
            axis.set_ylabel("mean squared error")
            axis.set_title("%s, %s" % (name, shading))
            axis.grid(True, which="both", alpha=0.3)
            axis.legend(fontsize=6.5, loc="lower left", framealpha=0.5)
    figure.tight_layout()
    figure.savefig(path_of_plot, dpi=90)


if __name__ == "__main__":
    plot([argument.split("=", 1) for argument in sys.argv[2:]], sys.argv[1])
