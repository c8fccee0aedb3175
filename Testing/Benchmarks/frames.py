"""What a frame costs while the camera turns, memory, and rows of tables that have processes of their own."""
import csv
import json
import os
import resource
import statistics
import subprocess
import sys
import time

#: what stands between a figure's turns in a cell, and between those of one process and of the next
TURN, PROCESS = ";", "|"
#: what names of columns end with that have the spread of a figure
LOWER, UPPER = " lower quartile", " upper quartile"
#: seconds of frames in a process after which no further one is taken: the slowest have one in each
LONGEST = 20.0


def cpu_seconds():
    """User and system time of this process on all cores."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def quartiles(values):
    """(lower quartile, median, upper quartile). Of one value, that."""
    return tuple(statistics.quantiles(values, n=4, method="inclusive")) if len(values) > 1 else 3 * tuple(values)


def spread(processes):
    """(lower, median, upper) of the turns of several processes: the median of all turns, the lowest of the processes' lower quartiles and the
    highest of their upper ones. Turns of one process are alike, so quartiles of all turns together would understate the spread between processes.
    """
    each = [quartiles(turns) for turns in processes]
    return min(lower for lower, _, _ in each), statistics.median(sum(processes, [])), max(upper for _, _, upper in each)


def spread_columns(name, figures):
    """(lower, median, upper) as the columns of a row."""
    return dict(zip((name + LOWER, name, name + UPPER), figures))


def seconds_of(render):
    """Wall and processor seconds that render() takes."""
    start, start_cpu = time.monotonic(), cpu_seconds()
    render()
    return time.monotonic() - start, cpu_seconds() - start_cpu


def columns(found, of_wall, of_cpu):
    """Columns of what seconds_of() has found, of each of several frames: lists."""
    wall, cpu = zip(*found)
    return {of_wall: wall, of_cpu: cpu}


def turning(render, frames, of_wall="frame", of_cpu="frame cpu"):
    """Columns of wall and processor seconds that render() takes, the camera turning by a degree before each; of fewer frames where they take long."""
    import paraview.simple as pv

    camera, found = pv.GetActiveCamera(), []
    end = time.monotonic() + LONGEST
    while len(found) < frames and (not found or time.monotonic() < end):
        camera.Azimuth(1.0)
        found.append(seconds_of(render))
    return columns(found, of_wall, of_cpu)


def begin(pixels):
    """The first view of a process, of so many pixels a side, with the plugin loaded."""
    import paraview.simple as pv

    pv._DisableFirstRenderCameraReset()
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=vars(pv))
    view = pv.CreateView("RenderView")
    view.ViewSize = [pixels, pixels]
    return view


def source(data):
    """A source of these data, of which ParaView knows the arrays and their ranges."""
    import paraview.simple as pv

    producer = pv.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    producer.GetDataInformation().GetNumberOfPoints()
    return producer


def counters(shown):
    """RenderStatistics."""
    shown.UpdatePropertyInformation()
    return json.loads(shown.GetProperty("RenderStatistics").GetElement(0))


def work(shown):
    """Numbers of glyphs and bytes, and seconds of stages, as columns."""
    found = counters(shown)
    return {"glyphs": found["glyphs"], "device bytes": found["deviceBytes"], **{name: found[name] for name in found if name.endswith("Seconds")}}


def memory(name, process="self"):
    """Bytes of a process, this one or that number, by its status: VmHWM, VmRSS."""
    with open("/proc/%s/status" % process, encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(name + ":"))


def figures_of(what, arguments, limit, command=("pvpython",)):
    """The last line, JSON, that a script prints in processes of its own; nothing where it dies or does not end within `limit` seconds."""
    print("measuring %s ..." % what, flush=True)
    try:
        run = subprocess.run(list(command) + arguments, stdout=subprocess.PIPE, check=True, timeout=limit)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        print("no figures: %s" % error, file=sys.stderr)
        return {}
    figures = json.loads(run.stdout.decode().splitlines()[-1])
    print(figures, flush=True)
    return figures


def read_cells(path):
    """Rows of a CSV file as dictionaries of text; what the commented lines at its beginning say is left out."""
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def turns_of(cell):
    """The turns that a cell has, as a list for each process."""
    return [list(map(float, turns.split(TURN))) for turns in cell.split(PROCESS)]


def read_table(path):
    """Rows of a CSV file as dictionaries of text. A figure of several turns is their median, and the columns LOWER and UPPER of its name have its spread()."""
    rows = []
    for cells in read_cells(path):
        row = {}
        for name, cell in cells.items():
            row[name] = cell
            if TURN in cell or PROCESS in cell:
                row.update(spread_columns(name, ("%.6g" % value for value in spread(turns_of(cell)))))
        rows.append(row)
    return rows


def write_table(path, rows):
    """Rows as CSV, with a column for each figure that some row has; of a figure that is a list, one for each turn, the cell has all. Six digits of floats."""
    def text(value):
        return "%.6g" % value if isinstance(value, float) else str(value)

    rows = [{key: TURN.join(map(text, cell)) if isinstance(cell, (list, tuple)) else text(cell) for key, cell in row.items()} for row in rows]
    columns = list(dict.fromkeys(column for row in rows for column in row))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
