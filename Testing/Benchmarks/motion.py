#!/usr/bin/python3
"""Plots and tabulates what MotionBenchmark error wrote: error over time, per scheme and path length.

Usage: motion.py RESULTS.csv PLOT.png
Prints a Markdown table at 16 samples a pixel. The reference's own error is taken off; times are processor seconds of an
image of 1200 x 1200, with the building of structures.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read(path):
    """{radii: {scheme: [(samples, build seconds, trace seconds, mse, blurred mse)]}}"""
    results = {}
    with open(path, encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    own = {row["radii"]: float(row["reference_mse"]) for row in rows}  # the last row of a path knows it
    for row in rows:
        error = max(float(row["mse"]) - own[row["radii"]], 1e-12)
        results.setdefault(row["radii"], {}).setdefault(row["scheme"], []).append(
            (int(row["samples"]), float(row["build_cpu_seconds"]), float(row["trace_cpu_seconds"]), error,
             float(row["blurred_mse"])))
    return results


def main():
    """Reads, tabulates, plots."""
    results = read(sys.argv[1])
    figure, axes = plt.subplots(1, len(results), figsize=(4.6 * len(results), 4.4), squeeze=False, sharey=True)
    print("| path (radii) | scheme | build s | trace s | error (1e-4) | after a blur (1e-4) |")
    print("|---|---|---|---|---|---|")
    for axis, (radii, schemes) in zip(axes[0], results.items()):
        for name, rows in schemes.items():
            axis.loglog([r[1] + r[2] for r in rows], [r[3] for r in rows], "o-", label=name, markersize=3)
            for row in rows:
                if row[0] == 16:
                    print("| %s | %s | %.2f | %.1f | %.2f | %.3f |" % (
                        radii, name, row[1], row[2], 1e4 * row[3], 1e4 * row[4]))
        axis.set_xlabel("processor seconds")
        axis.set_title("path of %s radii" % radii)
        axis.grid(True, which="both", alpha=0.3)
    axes[0][0].set_ylabel("mean squared error")
    axes[0][0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=100)


if __name__ == "__main__":
    main()
