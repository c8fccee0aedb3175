#!/usr/bin/python3
"""The plots of the documents that show results of benchmarks, from the CSV files in results/, where they are written to.

Usage: plots.py
"""
import os
import sys

import matplotlib

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import light  # noqa: E402
from frames import read_table  # noqa: E402
from tables import path_of  # noqa: E402

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def scale():
    """Time over the number of glyphs, each kind a line."""
    rows = read_table(path_of("scale"))
    figure, axes = pyplot.subplots(1, 2, figsize=(9.2, 4.2), sharex=True)
    for axis, what, title in ((axes[0], "first", "first picture"), (axes[1], "frame", "a frame while the camera turns")):
        for kind in dict.fromkeys(row["kind"] for row in rows):
            found = [(int(row["count"]), float(row[what])) for row in rows if row["kind"] == kind and row[what]]
            axis.loglog(*zip(*found), marker="o", markersize=3, label=kind)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("glyphs")
        axis.set_ylabel("seconds")
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    return figure


def lights():
    """Error of light over time, per scene, light and sampler."""
    scenes = ("spheres", "vessel", "tensors")
    figure, axes = pyplot.subplots(2, len(scenes), figsize=(4.6 * len(scenes), 7.6), squeeze=False)
    for column, name in enumerate(scenes):
        for axis, (shading, samplers) in zip(axes[:, column], light.read(path_of("light-" + name)).items()):
            axis.set_prop_cycle(color=pyplot.get_cmap("tab20").colors)
            for sampler, rows in samplers.items():
                kept = sampler == light.KEPT[shading]
                axis.loglog([r["seconds"] for r in rows], [r["error"] for r in rows], "o-", label=sampler, markersize=3, linewidth=2.5 if kept else 1.2)
                if kept:
                    axis.loglog([r["denoised_seconds"] for r in rows], [r["denoised"] for r in rows], "s--", color="0.5",
                                label=sampler + ", denoised", markersize=3)
            axis.set_xlabel("processor seconds")
            axis.set_ylabel("mean squared error")
            axis.set_title("%s, %s" % (name, shading))
            axis.grid(True, which="both", alpha=0.3)
            axis.legend(fontsize=6.5, loc="lower left", framealpha=0.5)
    figure.tight_layout()
    return figure


def superquadric_solvers():
    """Time over error, one panel for convex and one for mixed and concave glyphs. Every point is a solver in one arithmetic on all rays, random
    and hard: nanoseconds a ray against the 99.9th percentile of the error of t. Those with false hits or misses are hollow, with their fraction of the rays.
    """
    rows = [row for row in read_table(path_of("superquadric-solvers")) if row["case"] == "all"]
    solvers = list(dict.fromkeys(row["solver"] for row in rows))
    colors = pyplot.get_cmap("tab20").colors[::2] + pyplot.get_cmap("tab20").colors[1::2]
    figure, axes = pyplot.subplots(1, 2, figsize=(13, 5.5), sharey=True, layout="constrained")
    for axis, family in zip(axes, ("convex", "concave")):
        for row in rows:
            if row["family"] != family:
                continue
            wrong = float(row["false_hits_per_million"]) + float(row["misses_per_million"])
            x = float(row["ns_per_ray"])
            # Errors below an ulp of t are shown at the plot's lower edge.
            y = max(float(row["t_p999_sizes"]), 1e-18)
            axis.plot(x, y, marker="o" if row["arithmetic"] == "float" else "s", markersize=9, color=colors[solvers.index(row["solver"])],
                      fillstyle="none" if wrong else "full")
            if wrong:
                # Points of both arithmetics lie near each other: one has its label below, one above.
                axis.annotate("%.2g %%" % (1e-4 * wrong), (x, y), xytext=(0, -15 if row["arithmetic"] == "float" else 8),
                              textcoords="offset points", fontsize=7, ha="center")
        axis.set(xscale="log", yscale="log", xlabel="nanoseconds a ray", title=family)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("error of t beyond an ulp, 99.9th percentile, glyph sizes\n(circle: float, square: double, hollow: fraction of wrong hits)")
    for color, solver in zip(colors, solvers):
        axes[1].plot([], [], "o", color=color, label=solver)
    axes[1].legend(loc="lower left", fontsize=7)
    return figure


#: name -> (function that draws it, dots per inch)
PLOTS = {
    "scale": (scale, 90), "light": (lights, 90), "superquadric-solvers": (superquadric_solvers, 110),
}

if __name__ == "__main__":
    for plot, (draw, dots) in PLOTS.items():
        draw().savefig(path_of(plot)[:-len("csv")] + "png", dpi=dots)
