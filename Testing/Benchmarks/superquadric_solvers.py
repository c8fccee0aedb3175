#!/usr/bin/python3
"""Plots speed against error of the superquadric solvers.

Usage: superquadric_solvers.py FILE.csv FILE.png

FILE.csv is written by SuperquadricSolvers. One panel for convex and one for mixed and concave glyphs; every point is a solver in
one arithmetic on all rays, random and hard: nanoseconds a ray against the 99.9th percentile of the error of t. Solvers with
false hits or misses are drawn hollow, with their share of the rays.
"""
import sys

import matplotlib

from frames import read_table

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


#: One for each solver.
COLOURS = pyplot.get_cmap("tab20").colors[::2] + pyplot.get_cmap("tab20").colors[1::2]


def main(source, target):
    """Draws the figure of source's rows."""
    rows = [row for row in read_table(source) if row["case"] == "all"]
    solvers = list(dict.fromkeys(row["solver"] for row in rows))
    figure, axes = pyplot.subplots(1, 2, figsize=(13, 5.5), sharey=True, layout="constrained")
    for axis, family in zip(axes, ("convex", "concave")):
        for row in rows:
            if row["family"] != family:
                continue
            wrong = float(row["false_hits_per_million"]) + float(row["misses_per_million"])
            colour = COLOURS[solvers.index(row["solver"])]
            x = float(row["ns_per_ray"])
            # Errors below an ulp of t are shown at the plot's lower edge.
            y = max(float(row["t_p999_sizes"]), 1e-18)
            axis.plot(x, y, marker="o" if row["arithmetic"] == "float" else "s", markersize=9, color=colour,
                      fillstyle="none" if wrong else "full")
            if wrong:
                # Points of both arithmetics lie near each other: one has its label above, one below.
                axis.annotate("%.2g %%" % (1e-4 * wrong), (x, y), xytext=(0, 8 if row["arithmetic"] == "float" else -15),
                              textcoords="offset points", fontsize=7, ha="center")
        axis.set(xscale="log", yscale="log", xlabel="nanoseconds a ray", title=family)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("error of t beyond an ulp, 99.9th percentile, glyph sizes\n(circle: float, square: double, hollow: share of wrong hits)")
    for index, solver in enumerate(solvers):
        axes[1].plot([], [], "o", color=COLOURS[index], label=solver)
    axes[1].legend(loc="lower left", fontsize=7)
    figure.savefig(target, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
