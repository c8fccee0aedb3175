"""Velocities by differences to the step shown before: right over unequal steps, jumps, and ids that come, go and change places.

Usage: pvpython step_velocity.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet

import comparison
import session

#: Time, ids, x of the points; y is id / 4 - 0.5, but grows by time / 8 for id 2. The order changes from step to step.
STEPS = ((0.0, (1, 2, 3), (-1.0, 0.0, 1.0)),
         (1.0, (3, 1, 2), (1.2, -0.5, 0.0)),
         (3.0, (2, 7, 1, 7), (0.4, 0.5, -0.9, 0.6)),
         (3.5, (), ()),
         (4.0, (2, 1), (0.0, -0.2)))

# ParaView runs the scripts of sources in the main module, and fills that with functions of its own that are called as Python's: all,
# any, max, min, sum.
SCRIPT = """
import numpy
nan = numpy.nan
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPolyData
steps = %r
info = self.GetOutputInformation(0)
wanted = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) if info.Has(
    vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) else 0.0
time, ids, places = [step for step in steps if step[0] <= wanted][-1]
def fill(data, part):
    rows = list(range(len(ids)))[part]
    at = numpy.array([places[i] + (0.0,) for i in rows])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(at.reshape(-1, 3).astype(numpy.float64), deep=True))
    data.SetPoints(points)
    array = numpy_to_vtk(numpy.array([ids[i] for i in rows], dtype=numpy.%s), deep=True)
    array.SetName("who")
    data.GetPointData().AddArray(array)
    if %r:
        data.GetPointData().SetActiveGlobalIds("who")
output = self.GetOutputDataObject(0)
if output.IsA("vtkMultiBlockDataSet"):
    for block, part in enumerate((slice(0, 1), slice(1, None))):
        data = vtkPolyData()
        fill(data, part)
        output.SetBlock(block, data)
else:
    fill(output, slice(None))
output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
"""

INFORMATION = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
info = self.GetOutputInformation(0)
info.Remove(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
for time in %r:
    info.Append(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), time)
info.Remove(vtkStreamingDemandDrivenPipeline.TIME_RANGE())
info.Append(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), %r)
info.Append(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), %r)
"""


def series(kind="vtkPolyData", integer="int32", global_ids=False, steps=None):
    """A source of steps: time, ids, and x and y of the points; of STEPS by default."""
    steps = steps or [(time, ids, [tuple(position(step, who, at).tolist()[:2]) for who, at in zip(ids, x)]) for step, (time, ids, x) in enumerate(STEPS)]
    times = [step[0] for step in steps]
    return pv.ProgrammableSource(
        OutputDataSetType=kind, Script=SCRIPT % (steps, integer, global_ids),
        ScriptRequestInformation=INFORMATION % (times, times[0], times[-1]))


def position(step, who, at=None):
    """Where the point of that id is in a step, or the one that has that x; None: not there, or not the only one."""
    time, ids, x = STEPS[step]
    if at is None and ids.count(who) != 1:
        return None
    return numpy.array([x[ids.index(who)] if at is None else at, who / 4.0 - 0.5 + (time / 8.0 if who == 2 else 0.0), 0.0])


def expected(step, before):
    """The velocity of each point of a step, in the order of id and x."""
    rows = []
    for who, x in sorted(zip(STEPS[step][1], STEPS[step][2])):
        now = position(step, who)
        then = None if before is None else position(before, who)
        velocity = numpy.zeros(3)
        if now is not None and then is not None:
            velocity = (now - then) / (STEPS[step][0] - STEPS[before][0])
        rows.append((who, x) + tuple(velocity))
    return numpy.array(rows).reshape(-1, 5)


class Series:
    """One representation of a series, step by step, alone in a view."""

    def __init__(self, failures, name, view, source, ids="who"):
        self.failures, self.name, self.view = failures, name, view
        session.look(self.view, (0.0, 0.0, 5.0), parallel_scale=0.5)
        self.view.ViewTime = STEPS[0][0]
        self.shown = session.glyphs(source, self.view, samples=16, Orient=0, ScaleFactor=0.2)
        session.solid(self.shown, (1.0, 1.0, 1.0))
        self.shown.MotionBlur, self.shown.VelocityArray, self.shown.AccelerationArray = 1, "From Previous Step", "None"
        self.shown.PointIdArray = ids

    def delivered(self):
        """The points that are rendered: id, x, velocity, sorted."""
        representation = self.shown.GetClientSideObject().GetActiveRepresentation()
        leaf = representation.GetRenderedDataObject(0).NewIterator()
        parts = [numpy.zeros((0, 5))]
        while not leaf.IsDoneWithTraversal():
            data = leaf.GetCurrentDataObject()
            values = data.GetPointData()
            if data.GetNumberOfPoints() > 0:
                parts.append(numpy.concatenate([
                    vtk_to_numpy(values.GetArray("who"))[:, None], vtk_to_numpy(data.GetPoints().GetData())[:, :1],
                    vtk_to_numpy(values.GetArray("From Previous Step"))], axis=1))
            leaf.GoToNextItem()
        rows = numpy.concatenate(parts)
        return rows[numpy.lexsort((rows[:, 1], rows[:, 0]))]

    def go(self, step, before, words=()):
        """Shows a step; velocities must be those since step `before`, and the only message have these words."""
        def show():
            self.view.ViewTime = STEPS[step][0]
            pv.Render(self.view)
            pv.Render(self.view)
        text = session.messages(show)
        where = "%s, step %d after %s" % (self.name, step, before)
        found, wanted = self.delivered(), expected(step, before)
        if found.shape != wanted.shape or not numpy.allclose(found, wanted, atol=1e-6):
            self.failures.append("%s: velocities\n%s\ninstead of\n%s" % (where, found, wanted))
        if text.count("Warning:") != (1 if words else 0) or [word for word in words if word not in text]:
            self.failures.append("%s: the messages are '%s' instead of one with %s" % (where, text.strip(), words))
        glyphs = session.statistics(self.shown)["glyphs"]
        if glyphs != len(STEPS[step][1]):
            self.failures.append("%s: %d glyphs" % (where, glyphs))

    def end(self):
        """Takes it out of the view."""
        source = self.shown.Input
        pv.Delete(self.shown)
        pv.Delete(source)


def steps(failures, view):
    """Forwards, in jumps, and backwards; an empty step; the same step again."""
    shown = Series(failures, "steps", view, series())
    offered = shown.shown.GetProperty("VelocityArray").GetAvailable()
    if "From Previous Step" not in offered or "From Previous Step" in shown.shown.GetProperty("AccelerationArray").GetAvailable():
        failures.append("velocities to choose from: %s" % offered)
    shown.go(0, None)  # all stand still
    shown.go(1, 0)
    shown.go(1, 0)
    shown.go(2, 1, ("2 of 4", "at time 1"))
    shown.go(3, 2)
    shown.go(4, 3)  # no points were there before: nothing moves, without a further message
    shown.go(0, 4)
    shown.go(4, 0)
    shown.go(1, 4)
    shown.go(2, 1)
    # The properties that need nothing new leave all as it is; switched off and on, it begins anew.
    shown.shown.ShutterTime = 0.5
    shown.go(2, 1)
    shown.shown.VelocityArray = "None"
    said = session.messages(lambda: pv.Render(shown.view))
    if said.count("Warning:") != 1 or "VelocityArray" not in said:
        failures.append("switched off, and without a VelocityArray: not one message: " + said)
    shown.shown.VelocityArray = "From Previous Step"
    shown.go(2, None)
    shown.end()


def blur(failures, view):
    """The streak reaches from the last step's place to this one's: Backward, open for the time between the two."""
    shown = Series(failures, "blur", view, series())
    shown.shown.ShutterOpening, shown.shown.ShutterTime, shown.shown.SamplesPerPixel = "Backward", 1.0, 64
    session.messages(lambda: pv.Render(shown.view))
    still = comparison.covered(session.capture(shown.view, "step-velocity-first"))
    shown.go(1, 0)
    streak = comparison.covered(session.capture(shown.view, "step-velocity-second"))
    # Id 1, at y = -0.25: from x = -1 to -0.5, with a radius of 0.1, 100 pixels a unit; id 3, at 0.25, from 1 to 1.2.
    for image, ranges in ((still, ((75, 90, 110), (25, 290, 310))), (streak, ((75, 90, 160), (25, 290, 330)))):
        for row, first, last in ranges:
            columns = numpy.flatnonzero(image[row])
            columns = columns[(columns > first - 60) & (columns < last + 60)]
            if len(columns) == 0 or numpy.abs(columns[[0, -1]] - [first, last]).max() > 2:
                failures.append("row %d is covered from %s to %s instead of %d to %d" % (
                    row, columns[:1], columns[-1:], first, last))
    shown.end()


def kinds(failures, view):
    """Global ids, ids of 64 bits, data in blocks; no ids, no time."""
    for name, source, ids in (("global ids", series(global_ids=True), "None"), ("64 bits", series(integer="int64"), "who"),
                              ("ids in float", series(integer="float32"), "who"),
                              ("blocks", series(kind="vtkMultiblockDataSet"), "who"),
                              ("blocks with global ids", series(kind="vtkMultiblockDataSet", global_ids=True), "None")):
        shown = Series(failures, name, view, source, ids)
        shown.go(0, None)  # all stand still
        shown.go(1, 0)
        shown.end()
    for ids in ("None", "nonesuch"):
        shown = Series(failures, "without ids", view, series(), ids)
        shown.go(0, None, ("PointIdArray",))
        shown.go(1, None)
        shown.end()
    still = session.source(session.poly_data(numpy.zeros((2, 3)), who=numpy.arange(2)))
    shown = Series([], "without time", view, still)
    text = session.messages(lambda: pv.Render(shown.view))
    if text.count("Warning:") != 1 or "time of the data" not in text or shown.delivered()[:, 2:].any():
        failures.append("without time: %s" % text.strip())


def repeated(failures, view):
    """Ids that begin anew in each block, as those of Point And Cell Ids do."""
    def data(time):
        blocks = vtkMultiBlockDataSet()
        for block in range(2):
            part = session.poly_data(numpy.array([[0.5 * time * (block + 1), 0.2 * i, block] for i in range(3)]), who=numpy.arange(3))
            blocks.SetBlock(block, part)
        blocks.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return blocks

    shown = Series(failures, "repeated ids", view, session.source(data(0.0)))
    pv.Render(view)
    session.replace_data(shown.shown.Input, data(1.0))
    text = session.messages(lambda: pv.Render(view)).strip()
    found = sorted(shown.delivered()[:, 2].tolist())
    if not numpy.allclose(found, [0.5] * 3 + [1.0] * 3) or text:
        failures.append("repeated ids: velocities %s; %s" % (found, text or "no message"))
    shown.end()


def main():
    """Runs all."""
    session.load()
    failures = []
    view = session.view(400, 100)
    steps(failures, view)
    blur(failures, view)
    kinds(failures, view)
    repeated(failures, view)
    session.finish(failures)


if __name__ == "__main__":
    main()
