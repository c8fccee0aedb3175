#!/usr/bin/python3
"""What MotionBenchmark error wrote, plotted and as the table of tables.py: error over time, per scheme and path length.

Usage: motion.py RESULTS.csv PLOT.png
The reference's own error is taken off; times are processor seconds of an image of 1200 x 1200, with the building of structures.
"""
import sys

from frames import read_table

KEPT = "strata of times with places: slices"  # what the plugin does


def read(path):
    """{radii: {scheme: [(samples, build seconds, trace seconds, mse, blurred mse, quartiles of trace seconds)]}}"""
    results = {}
    rows = read_table(path)
    own = {row["radii"]: float(row["reference_mse"]) for row in rows}  # the last row of a path knows it
    for row in rows:
        error = max(float(row["mse"]) - own[row["radii"]], 1e-12)
        seconds = [float(row[column]) for column in ("build_cpu_seconds", "trace_cpu_seconds", "trace_cpu_seconds lower quartile",
                                                     "trace_cpu_seconds upper quartile")]
        results.setdefault(row["radii"], {}).setdefault(row["scheme"], []).append(
            (int(row["samples"]), seconds[0], seconds[1], error, float(row["blurred_mse"]), seconds[2:]))
    return results


def table(path):
    """Markdown, at 16 samples a pixel."""
    lines = ["| path (radii) | scheme | build s | trace s | error (1e-4) | after a blur (1e-4) |", "|---|---|---|---|---|---|"]
    lines += ["| %s | %s | %.2f | %.1f (%.1f, %.1f) | %.2f | %.3f |" % (
        radii, name + (" (kept)" if name == KEPT else ""), row[1], row[2], *row[5], 1e4 * row[3], 1e4 * row[4])
              for radii, schemes in read(path).items() for name, rows in schemes.items() for row in rows if row[0] == 16]
    return "\n".join(lines)


def plot(path, path_of_plot):
    """Error over time."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    results = read(path)
    figure, axes = plt.subplots(1, len(results), figsize=(4.6 * len(results), 4.4), squeeze=False, sharey=True)
    for axis, (radii, schemes) in zip(axes[0], results.items()):
        for name, rows in schemes.items():
            axis.loglog([r[1] + r[2] for r in rows], [r[3] for r in rows], "o-", label=name, markersize=3)
        axis.set_xlabel("processor seconds")
        axis.set_title("path of %s radii" % radii)
        axis.grid(True, which="both", alpha=0.3)
    axes[0][0].set_ylabel("mean squared error")
    axes[0][0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path_of_plot, dpi=100)


if __name__ == "__main__":
    plot(sys.argv[1], sys.argv[2])
