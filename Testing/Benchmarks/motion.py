"""What MotionBenchmark error wrote: error over time, per scheme and path length.

The reference's own error is taken off; times are processor seconds of an image of 1200 x 1200, with the building of structures.
"""
from frames import LOWER, UPPER, read_table

KEPT = "strata of times with places: slices"  # what the plugin does


def read(path):
    """{radii: {scheme: [(samples, build seconds, trace seconds, mse, blurred mse)]}}; seconds are (median, lower, upper)."""
    results = {}
    rows = read_table(path)
    own = {row["radii"]: float(row["reference_mse"]) for row in rows}  # the last row of a path knows it
    for row in rows:
        error = max(float(row["mse"]) - own[row["radii"]], 1e-12)
        build, trace = (tuple(float(row.get(column + of) or row[column]) for of in ("", LOWER, UPPER)) for column in ("build_cpu_seconds", "trace_cpu_seconds"))
        results.setdefault(row["radii"], {}).setdefault(row["scheme"], []).append((int(row["samples"]), build, trace, error, float(row["blurred_mse"])))
    return results


def table(path):
    """Markdown, at 16 samples a pixel."""
    lines = ["| path in radii | scheme | build: s | trace: s | error (1e-4) | after a blur (1e-4) |", "|---|---|---|---|---|---|"]
    lines += ["| %s | %s | %.2f (%.2f, %.2f) | %.1f (%.1f, %.1f) | %.2f | %.3f |" % (
        radii, name + (" (kept)" if name == KEPT else ""), *row[1], *row[2], 1e4 * row[3], 1e4 * row[4])
              for radii, schemes in read(path).items() for name, rows in schemes.items() for row in rows if row[0] == 16]
    return "\n".join(lines)
