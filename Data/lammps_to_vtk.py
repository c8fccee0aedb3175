#!/usr/bin/python3
"""Turns LAMMPS text dumps into a time series that every ParaView reads.

Usage: lammps_to_vtk.py NAME TIMESTEP FOLDER DUMP...

Writes FOLDER/NAME_00.vtk, ... (legacy binary poly data, one point per particle) and FOLDER/NAME.vtk.series
with the times. Needs numpy only. Legacy files because Debian's XML readers reject appended raw data.
"""
import json
import os
import sys

import numpy

#: columns of the dump -> array of the file; a column that the dump lacks leaves its array out
ARRAYS = {
    "diameter": ("diameter",),
    "velocity": ("vx", "vy", "vz"),
    "shape": ("c_shape[1]", "c_shape[2]", "c_shape[3]"),
    "quaternion": ("c_rotation[1]", "c_rotation[2]", "c_rotation[3]", "c_rotation[4]"),
    "stress": tuple("c_stress[%d]" % i for i in range(1, 7)),
}


def read_dump(path):
    """Columns by name and the step number of a dump with one snapshot."""
    with open(path) as dump:
        lines = dump.read().split("\n")
    step = int(lines[1])
    names = lines[8].split()[2:]
    rows = numpy.array([line.split() for line in lines[9:] if line], dtype=float)
    return step, dict(zip(names, rows.T))


def particle_arrays(columns):
    """Named arrays with one row per particle, single precision but for the ids."""
    arrays = {"id": columns["id"].astype(numpy.int32)[:, None]}
    for name, parts in ARRAYS.items():
        if all(part in columns for part in parts):
            arrays[name] = numpy.stack([columns[part] for part in parts], axis=1)
    force = numpy.stack([columns[part] for part in ("fx", "fy", "fz")], axis=1)
    arrays["acceleration"] = force / columns["mass"][:, None]
    return {name: values if name == "id" else values.astype(numpy.float32) for name, values in arrays.items()}


def write_vtk(path, title, points, arrays):
    """Legacy binary poly data (big-endian): points, one vertex cell each, point arrays."""
    count = len(points)
    with open(path, "wb") as out:
        out.write(("# vtk DataFile Version 3.0\n%s\nBINARY\nDATASET POLYDATA\nPOINTS %d float\n" % (title, count)).encode())
        out.write(points.astype(">f4").tobytes())
        cells = numpy.stack([numpy.ones(count), numpy.arange(count)], axis=1)
        out.write(("\nVERTICES %d %d\n" % (count, 2 * count)).encode())
        out.write(cells.astype(">i4").tobytes())
        out.write(("\nPOINT_DATA %d\nFIELD FieldData %d\n" % (count, len(arrays))).encode())
        for name, values in arrays.items():
            kind, code = ("int", ">i4") if values.dtype.kind == "i" else ("float", ">f4")
            out.write(("%s %d %d %s\n" % (name, values.shape[1], count, kind)).encode())
            out.write(values.astype(code).tobytes())
            out.write(b"\n")


def main():
    """Converts the dumps named on the command line."""
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    name, timestep, folder = sys.argv[1], float(sys.argv[2]), sys.argv[3]
    files = []
    for index, path in enumerate(sorted(sys.argv[4:])):
        step, columns = read_dump(path)
        if index == 0:
            first = step
        points = numpy.stack([columns[axis] for axis in "xyz"], axis=1)
        target = "%s_%02d.vtk" % (name, index)
        write_vtk(os.path.join(folder, target), "%s, LAMMPS step %d" % (name, step), points, particle_arrays(columns))
        files.append({"name": target, "time": round((step - first) * timestep, 9)})
    with open(os.path.join(folder, name + ".vtk.series"), "w") as series:
        json.dump({"file-series-version": "1.0", "files": files}, series, indent=1)
        series.write("\n")


if __name__ == "__main__":
    main()
