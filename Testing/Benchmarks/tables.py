#!/usr/bin/python3
"""The tables of the documents that show results of benchmarks, from the CSV files in results/.

Usage: tables.py [--check]
Between <!-- table NAME --> and <!-- end of table NAME --> a document has the table of that name. Without --check each is written anew; with
it the program only says which ones differ from their CSV files, and which of those do not say of which commit they are.
"""
import math
import os
import re
import statistics
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.dont_write_bytecode = True
import light  # noqa: E402
from frames import LOWER, UPPER, quartiles, read_table, spread_columns  # noqa: E402

ROOT = os.path.join(HERE, "..", "..")
RESULTS = os.path.join(HERE, "results")
BENCHMARKS, DETAILS, SHAPES = "Testing/Benchmarks/README.md", "Testing/Benchmarks/DETAILS.md", "Kernels/Shapes/README.md"


def path_of(name):
    """The CSV file of that name."""
    return os.path.join(RESULTS, name + ".csv")


def head(path):
    """What the commented lines at the beginning of a CSV file say: {what: text}."""
    with open(path, encoding="utf-8") as file:
        return dict(re.match(r"# ([\w ]+): (.*)", line).groups() for line in file if re.match(r"# [\w ]+: ", line))


def rows(name):
    """The rows of a CSV file as dictionaries, with numbers where the text is one."""
    def number(text):
        try:
            return float(text)
        except ValueError:
            return text

    return [{key: number(text) for key, text in row.items()} for row in read_table(path_of(name))]


def markdown(heads, lines):
    """A table of cells that are text already."""
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [heads] + list(lines)).replace("|\n", "|\n" + "|---" * len(heads) + "|\n", 1)


def digits(value, count):
    """A number to so many digits; nothing for nothing."""
    if value == "":
        return ""
    return "%.*g" % (count, value) if abs(value) < 1.0 else "%.*f" % (max(count - len("%d" % abs(value)), 0), value)


def timing(row, key, count):
    """Seconds to so many digits, with their spread (frames.py) where they are of several turns."""
    both = [row.get(key + which, "") for which in (LOWER, UPPER)]
    if both[0] == "" or both == [row[key], row[key]]:  # what others are compared with is always 1
        return digits(row[key], count)
    return digits(row[key], count) + " (%s, %s)" % tuple(digits(value, count) for value in both)


def speed():
    """Ray-traced glyphs and ParaView's own representations, dilute and packed."""
    dilute, packed = rows("speed-dilute"), {row["name"]: row for row in rows("speed-packed")}

    def cells(row):
        return [timing(row, "wall", 3), timing(row, "cpu", 3), timing(row, "ratio", 3), "%.0f" % row["megabytes"]] if row else [""] * 4
    return markdown(["", "dilute: wall s", "CPU s", "ratio", "peak MB", "packed: wall s", "CPU s", "ratio", "peak MB"],
                    [[row["name"]] + cells(row) + cells(packed.get(row["name"])) for row in dilute])


def shapes():
    """Every shape over spheres."""
    packed = {row["shape"]: row for row in rows("shapes-scene") if row["layout"] == "packed"}

    def cells(row):
        return [timing(row, "wall s", 3), "%.2f" % (1e-6 * row["pixels"] ** 2 / row["wall s"]), timing(row, "CPU over spheres", 3)]
    return markdown(["shape", "dilute: wall s", "Mray/s", "CPU ratio to spheres", "packed: wall s", "Mray/s", "CPU ratio to spheres"],
                    [[row["shape"]] + cells(row) + cells(packed[row["shape"]]) for row in rows("shapes-scene") if row["layout"] == "dilute"])


def tessellations(name):
    """Error and time of tessellated glyphs."""
    def line(row):
        facets, vertices = re.findall(r"(\d+)x(\d+)", row["what"]), re.search(r"of (\d+) vertices", row["what"])
        if not facets and not vertices:
            return [row["what"], "-", "-", "-", timing(row, "wall s", 3), timing(row, "CPU s", 3)]
        triangles = 2 * int(facets[-1][0]) * int(facets[-1][1]) if facets else 2 * (int(vertices.group(1)) - 2)
        return [row["what"], str(triangles), digits(row["silhouette %"], 2) + " %",
                "%s / %.0f" % (digits(row["color mean"], 2), row["color 99 %"]), timing(row, "wall s", 3), timing(row, "CPU s", 3)]
    return markdown(["", "triangles a glyph", "silhouette", "color mean / 99 %", "wall s", "CPU s"], map(line, rows(name)))


def scenes():
    """Kinds of scenes."""
    def embree(row, key):
        return [timing(row, key, 3), "%.2f" % (row[key] / row["CPU s"])] if row[key] != "" else ["", ""]
    return markdown(["scene", "CPU s", "ratio to the first row", "Embree, single rays: s", "ratio", "Embree, packets: s", "ratio"],
                    [[row["scene"], timing(row, "CPU s", 3), timing(row, "cost beside the first", 3)] + embree(row, "Embree s") + embree(row, "Embree packets s")
                     for row in rows("scenes")])


def gpu():
    """Frames a second on a GPU, with the plugin's and the driver's BVH."""
    rates = {(name, row["shape"], row["glyphs"], row["light"]): row for name in ("trees", "boxes") for row in rows("gpu-" + name)}

    def cell(name, shape, glyphs, light, key, count):
        row = rates.get((name, shape, glyphs, light))
        return digits(row[key], count) if row else ""

    kinds = sorted({(shape, glyphs) for _, shape, glyphs, _ in rates}, key=lambda kind: (["spheres", "ellipsoids", "arrows", "superquadrics"].index(kind[0]), kind[1]))
    lights = ("local", "occlusion", "paths")
    return markdown(
        ["shape", "glyphs"] + ["%s: %s" % (name, light) for name in ("plugin's BVH", "driver's BVH") for light in lights] + ["%s: %s" % (name, what) for what in ("build s", "bytes a glyph") for name in ("plugin's BVH", "driver's BVH")],
        [[shape, "%d" % glyphs] + [cell(name, shape, glyphs, light, "frames per second", 2) for name in ("trees", "boxes") for light in lights]
         + [cell(name, shape, glyphs, "local", "rebuild s", 2) for name in ("trees", "boxes")]
         + [cell(name, shape, glyphs, "local", "bytes per glyph", 2) for name in ("trees", "boxes")] for shape, glyphs in kinds])


def directions():
    """Spherical functions and tubes in large numbers."""
    return markdown(["", "first picture: s", "making the meshes: s", "frame: wall s", "CPU s", "memory: MB"],
                    [[row["kind"], timing(row, "first", 3), timing(row, "making", 2) if row["making"] else "", timing(row, "frame", 3),
                      timing(row, "frame cpu", 3), "%.0f" % (row["bytes"] / 1e6)] for row in rows("directions")])


def build():
    """Host's stages of new glyphs, on all cores; and their sum on one."""
    every, stages = {}, ("boxes s", "order s", "tree s")
    for row in rows("build"):
        every.setdefault(row["shape"], []).append(row)
    return markdown(["shape", "bounds", "sort", "BVH", "sum", "one thread"],
                    [[shape] + [timing(cores, stage, 3) for stage in stages] + ["%.3f" % sum(row[stage] for stage in stages) for row in (cores, one)]
                     for shape, (one, cores) in every.items()])


def build_picture():
    """The first picture of ten million spheres, without ParaView."""
    row, = rows("build-picture")
    stages = ("commit s", "sort s", "build s", "upload s", "picture s", "all s")
    return markdown(["Scene::Commit()", "of it sort", "BVH", "upload", "compile and trace", "all", "peak memory: MB", "of it data: MB"],
                    [[timing(row, stage, 3) for stage in stages] + ["%.0f" % row["peak MB"], "%.0f" % row["MB before"]]])


def large_data():
    """Stages of ten million points."""
    found = {row["what"]: row for row in rows("large-data")}
    return markdown(["stage", "one thread", "all cores", "ratio"], [
        [stage, timing(row, "one thread", 3), timing(row, "all cores", 3), "%.2f" % (row["one thread"] / row["all cores"])]
        for stage, row in (("gathering", found["gatherSeconds"]), ("bounds", found["boundsSeconds"]), ("instances", found["instanceSeconds"]),
                           ("colors", found["colorSeconds"]))])


def scale():
    """A million glyphs and more, and ParaView's own representations."""
    return markdown(["", "glyphs", "first picture: s", "of it ParaView's array ranges", "frame: s", "while turning", "peak memory: GB", "data: GB", "device: bytes a glyph"],
                    [[row["kind"], "%d million" % (row["count"] / 1e6)] +
                     ([timing(row, key, 3) for key in ("first", "information", "frame", "turning")] +
                      [digits(row["peak bytes"] / 1e9, 3), digits(row["count"] * POINT_BYTES[row["kind"]] / 1e9, 2),
                       "%.1f" % ((row["device bytes"] - DEVICE_BYTES) / row["count"]) if row["device bytes"] else ""] if row["first"] else ["none"] + [""] * 6)
                     for row in rows("scale") if row["count"] >= 1e6])


def reduced():
    """The first picture by ParaView's level of detail, without the search for ranges."""
    def seconds(row, clock):
        return row["first" + clock] - row["information" + clock]
    found = {(row["kind"], row["count"]): row for row in rows("reduced")}
    pairs = [(row, found["spheres", count]) for (kind, count), row in found.items() if kind != "spheres"]
    return markdown(["spheres", "shown instead", "first picture: s", "of all: s", "ratio", "CPU ratio", "error of sums of values", "of areas", "while turning: s"], [
        ["%d million" % (row["count"] / 1e6), "%.1f million" % (row["reduced"] / 1e6), digits(seconds(row, ""), 3), digits(seconds(whole, ""), 3)] +
        ["%.2f" % (seconds(row, clock) / seconds(whole, clock)) for clock in ("", " cpu")] +
        ["%.0e" % max(row["error of values"], 1e-15), "%.0e" % row["error of areas"], digits(row["turning"], 2)] for row, whole in pairs])


#: of a point's data in scale.py
POINT_BYTES = {"spheres": 20, "arrows": 32, "signed tensors": 44, "Point Gaussian": 20, "3D Glyphs": 20}
#: what the device holds besides glyphs: pictures of 1200 x 1200 pixels
DEVICE_BYTES = 23e6


def slopes():
    """Exponents of time against count: of a frame where scenes have left the caches."""
    def slope(kind, least, seconds):
        found = [(row["count"], seconds(row)) for row in rows("scale") if row["kind"] == kind and row["count"] >= least and row["first"]]
        xs, ys = [math.log(count) for count, _ in found], [math.log(value) for _, value in found]
        x, y = statistics.fmean(xs), statistics.fmean(ys)
        return "%.2f" % (sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs))

    def building(row):
        return sum(row[stage + "Seconds"] for stage in ("instance", "sort", "build", "upload"))
    return markdown(["", "a frame, from 10^5 glyphs", "building, from 10^3", "building, from 10^5"],
                    [[kind, slope(kind, 1e5, lambda row: row["frame"]), slope(kind, 1e3, building), slope(kind, 1e5, building)]
                     for kind in ("spheres", "arrows", "signed tensors")])


def ranks():
    """What ranks send each other, hold and take."""
    def name(row):
        return row["mode"] + (", " + row["light"] if row["light"] != "Local" else "") + (", radius %d" % row["radius"] if row["radius"] else "")
    found = rows("ranks")
    alone = {name(row): row["frame"] for row in found if row["ranks"] == 1}
    return markdown(["", "ranks", "glyphs received", "MB", "bytes a glyph", "device, all ranks: MB", "first picture: s", "frame: s", "speedup"],
                    [[name(row), "%d" % row["ranks"], "%d" % row["from others"], "%.2f" % (row["bytes from others"] / 1e6),
                      "%.1f" % (row["bytes from others"] / row["from others"]) if row["from others"] else "", "%.0f" % (row["device bytes"] / 1e6),
                      timing(row, "first picture", 3), timing(row, "frame", 3), "%.2f" % (alone[name(row)] / row["frame"])] for row in found])


def steps():
    """Where the time of a step of a time series goes; the first one compiles."""
    found = rows("steps")[1:]

    cells = [timing(spread_columns(stage, quartiles([1000.0 * row[stage] for row in found])), stage, 3)
             for stage in ("pipeline", "sort", "build", "upload", "trace", "other", "total")]
    return markdown(["ParaView's pipeline: ms", "sort", "BVH", "upload", "trace", "other", "total"], [cells])


def light_cost():
    """A sample of each kind of light over one of local shading."""
    lights = ["occlusion"] + ["path %d" % bounces for bounces in (1, 2, 3, 4, 10)]
    found = {(row["scene"], row["light"]): row for row in rows("light-cost")}
    return markdown(["scene", "local: s", "occlusion, one direction", "path, 1 bounce"] + ["%d bounces" % bounces for bounces in (2, 3, 4, 10)],
                    [[scene, timing(row, "cpu_seconds", 3)] + [timing(found[scene, other], "over_local", 3) for other in lights]
                     for (scene, one), row in found.items() if one == "local"])


def motion_cost():
    """A sample of moving glyphs over one of the same at rest."""
    return markdown(["path in radii", "ratio to rest", "time segments", "build: s"],
                    [["%g" % row["radii"], timing(row, "over_rest", 3), "%d" % row["slices"], timing(row, "build_cpu_seconds", 2)]
                     for row in rows("motion-cost")])


def sphere_formulas():
    """Error of t, error of the normal, wrong hits: the cases in which formulas differ."""
    formulas = {"plugin": "plugin", "Ray Tracing Gems": "Ray Tracing Gems, chapter 7", "Embree's projection": "Embree's projection",
                "moved origin": "moved origin", "textbook": "textbook"}
    found = {(row["case"], row["formula"]): "%.1e, %.1e, %d" % (row["t_max_sizes"], row["normal_max_radians"], row["false_hits"] + row["false_misses"])
             for row in rows("sphere-formulas")}
    return markdown(["hard case"] + list(formulas.values()), [[case] + [found[case, formula] for formula in formulas] for case in (
        "plain", "grazing", "along axes", "from the surface", "1e4 from the origin, size 0.02, camera 1 away",
        "1e7 from the origin, size 0.02, camera 1 away", "camera 1e4 sizes away", "camera 1e6 sizes away")])


def hard_cases():
    """All shapes together, case by case, in float."""
    cases = {}
    for row in rows("shape-errors"):
        if row["arithmetic"] == "float":
            cases.setdefault(row["case"], []).append(row)

    def line(case, found):
        def largest(key):
            return max(row[key] for row in found)

        def total(key):
            return "%d" % sum(row[key] for row in found)
        return [case, total("rays"), "%.2g" % statistics.median(row["t_median_ulps"] for row in found), "%.2g" % largest("t_max_ulps"),
                "%.1e" % largest("t_max_sizes"), "%.2g" % largest("t_max_over_bound"), "%.1e" % largest("normal_max_radians"),
                total("false_hits") + " / " + total("false_misses")]
    return markdown(["hard case", "rays", "median of dt (ulps of t)", "largest dt (ulps of t)", "largest dt (glyph sizes)",
                     "largest dt over the bound", "largest normal error (rad)", "false hits / misses"],
                    [line(case, found) for case, found in cases.items()])


def superquadric_errors():
    """Families of superquadrics and tensor glyphs, in float."""
    return markdown(["glyphs", "ns a ray, random / all", "error of t, 99.9 %", "max", "normal, max (rad)", "t / normals out of bound",
                     "false hits / misses"],
                    [[("*beyond:* " if row["range"] == "beyond" else "") + row["family"],
                      timing(row, "ns_per_ray_random", 3) + " / " + timing(row, "ns_per_ray_all", 3), "%.1e" % row["t_p999_sizes"], "%.1e" % row["t_max_sizes"],
                      "%.1e" % row["normal_max_radians"], "%d / %d" % (row["t_out_of_bound"], row["normals_out_of_bound"]),
                      "%d / %d" % (row["false_hits"], row["false_misses"])]
                     for row in rows("superquadric-errors") if row["arithmetic"] == "float"])


def million_errors():
    """A million rays of each family, in float."""
    return markdown(["glyphs", "rays", "error of t, 99.9 %", "max", "largest dt over the bound", "normal, max (rad)", "t / normals out of bound",
                     "false hits / misses", "at a silhouette", "at that of a lobe"],
                    [[row["family"], "%d" % row["rays"], "%.1e" % row["t_p999_sizes"], "%.1e" % row["t_max_sizes"], "%.2g" % row["t_max_over_bound"],
                      "%.1e" % row["normal_max_radians"], "%d / %d" % (row["t_out_of_bound"], row["normals_out_of_bound"]),
                      "%d / %d" % (row["false_hits"], row["false_misses"]), "%d" % row["silhouettes"], "%d" % row["lobes"]]
                     for row in rows("million-errors")])


def superquadric_solvers():
    """Solvers, in float, all rays together."""
    return markdown(["glyphs", "solver", "ns a ray", "error of t, 99.9 %", "max", "normal, max (rad)", "false hits / misses a million"],
                    [[row["family"], row["solver"], timing(row, "ns_per_ray", 3), "%.1e" % row["t_p999_sizes"], "%.1e" % row["t_max_sizes"],
                      "%.1e" % row["normal_max_radians"], "%.0f / %.0f" % (row["false_hits_per_million"], row["misses_per_million"])]
                     for row in rows("superquadric-solvers") if row["case"] == "all" and row["arithmetic"] == "float"])


#: name -> (document, CSV files, function that gives the table)
TABLES = {
    "speed": (BENCHMARKS, ["speed-dilute", "speed-packed"], speed),
    "shapes": (DETAILS, ["shapes-scene"], shapes),
    "tessellations": (BENCHMARKS, ["tessellations"], lambda: tessellations("tessellations")),
    "tessellations-harmonics": (DETAILS, ["tessellations-harmonics"], lambda: tessellations("tessellations-harmonics")),
    "scenes": (DETAILS, ["scenes"], scenes),
    "gpu": (BENCHMARKS, ["gpu-trees", "gpu-boxes"], gpu),
    "directions": (DETAILS, ["directions"], directions),
    "build": (DETAILS, ["build"], build),
    "build-picture": (DETAILS, ["build-picture"], build_picture),
    "scale": (BENCHMARKS, ["scale"], scale),
    "reduced": (BENCHMARKS, ["reduced"], reduced),
    "slopes": (DETAILS, ["scale"], slopes),
    "ranks": (DETAILS, ["ranks"], ranks),
    "large-data": (DETAILS, ["large-data"], large_data),
    "light": (DETAILS, ["light-spheres", "light-vessel", "light-tensors"],
              lambda: light.table([(name, path_of("light-" + name)) for name in ("spheres", "vessel", "tensors")])),
    "light-cost": (BENCHMARKS, ["light-cost"], light_cost),
    "motion-cost": (BENCHMARKS, ["motion-cost"], motion_cost),
    "steps": (DETAILS, ["steps"], steps),
    "sphere-formulas": (SHAPES, ["sphere-formulas"], sphere_formulas),
    "hard-cases": (SHAPES, ["shape-errors"], hard_cases),
    "superquadric-errors": (SHAPES, ["superquadric-errors"], superquadric_errors),
    "million-errors": (SHAPES, ["million-errors"], million_errors),
    "superquadric-solvers": (SHAPES, ["superquadric-solvers"], superquadric_solvers),
}


def made(results):
    """{name: table} of those tables whose CSV files all lie in that folder."""
    global RESULTS
    before, RESULTS = RESULTS, results
    try:
        return {name: make() for name, (_, files, make) in TABLES.items() if all(os.path.exists(path_of(file)) for file in files)}
    finally:
        RESULTS = before


def between(text, name):
    """(start, end) of the text between the markers of a table."""
    begin, end = "<!-- table %s -->\n" % name, "\n<!-- end of table %s -->" % name
    if text.count(begin) != 1 or text.count(end) != 1:
        raise SystemExit("tables.py: %s has no markers '%s' and '%s'" % (TABLES[name][0], begin.strip(), end.strip()))
    return text.index(begin) + len(begin), text.index(end)


def main():
    """Writes or checks."""
    check, wrong = "--check" in sys.argv[1:], []
    for file in sorted({file for _, files, _ in TABLES.values() for file in files}):
        if not head(path_of(file)).get("commit"):
            wrong.append("results/%s.csv does not say of which commit it is; write it with Testing/Benchmarks/run" % file)
    for name, (document, files, make) in TABLES.items():
        path = os.path.join(ROOT, document)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        start, end = between(text, name)
        new = text[:start] + make() + text[end:]
        if new == text:
            continue
        if check:
            wrong.append("the table %s of %s differs from %s; run Testing/Benchmarks/tables.py" % (
                name, document, " and ".join("results/%s.csv" % file for file in files)))
        else:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(new)
    if wrong:
        raise SystemExit("\n".join(wrong))


if __name__ == "__main__":
    main()
