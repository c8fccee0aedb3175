#!/usr/bin/python3
"""Plots and tabulates what LightBenchmark error wrote: error over samples and over time, per sampler.

Usage: light.py RESULTS.csv PLOT.png
Prints a Markdown table: mean squared error of independent samples over that of each sampler, at equal time
(interpolated on logarithms) and at equal samples; above 1 the sampler is better. The reference's own error is taken off.
"""
import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read(path):
    """{shading: {sampler: [(samples, seconds, mse, blurred mse)]}}"""
    results = {}
    with open(path, encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    own = {row["shading"]: float(row["reference_mse"]) for row in rows}  # the last row of a shading knows it
    for row in rows:
        error = max(float(row["mse"]) - own[row["shading"]], 1e-12)
        results.setdefault(row["shading"], {}).setdefault(row["sampler"], []).append(
            (int(row["samples"]), float(row["cpu_seconds"]), error, float(row["blurred_mse"])))
    return results


def at_time(rows, seconds, column):
    """Error of a sampler at that time, interpolated on logarithms, extrapolated as 1 / time."""
    points = [(math.log(r[1]), math.log(r[column])) for r in rows]
    x = math.log(seconds)
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return math.exp(y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    x0, y0 = points[0] if x < points[0][0] else points[-1]
    return math.exp(y0 - (x - x0))


def main():
    """Reads, tabulates, plots."""
    results = read(sys.argv[1])
    figure, axes = plt.subplots(1, len(results), figsize=(5.5 * len(results), 4.2), squeeze=False)
    print("| light | sampler | samples | gain at equal samples | gain at equal time | after a blur, equal time |")
    print("|---|---|---|---|---|---|")
    for axis, (shading, samplers) in zip(axes[0], results.items()):
        random = samplers["random"]
        for name, rows in samplers.items():
            axis.loglog([r[1] for r in rows], [r[2] for r in rows], "o-", label=name, markersize=3)
            for base, row in zip(random, rows):
                if name != "random" and row[0] in (4, 16, 64, 256, 1024):
                    print("| %s | %s | %d | %.2f | %.2f | %.2f |" % (
                        shading, name, row[0], base[2] / row[2], at_time(random, row[1], 2) / row[2],
                        at_time(random, row[1], 3) / row[3]))
        axis.set_xlabel("processor seconds")
        axis.set_ylabel("mean squared error")
        axis.set_title(shading)
        axis.grid(True, which="both", alpha=0.3)
        axis.legend()
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
