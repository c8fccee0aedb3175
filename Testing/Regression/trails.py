"""Trails: where glyphs were in earlier steps, as tubes whose points and radii are those of numpy; however the step was reached, whatever becomes of ids.

Usage: pvpython trails.py
"""
import os

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import comparison
import session
import step_velocity
from checks import Checks
from step_velocity import series

NAN = float("nan")
#: Time, ids and places of the points. Their order changes; 7 is born, 3 dies, 5 has no place in one step, and 9 is there twice in another.
STEPS = ((0.0, (1, 2, 3, 5, 9), ((-1.5, -0.6), (-1.0, 0.5), (0.0, 0.7), (1.0, 0.0), (1.6, -0.8))),
         (1.0, (2, 9, 1, 3, 5), ((-0.7, 0.4), (1.6, -0.6), (-1.2, -0.7), (0.2, 0.6), (1.1, 0.3))),
         (2.5, (9, 5, 3, 7, 2, 1, 9), ((1.5, -0.4), (1.2, 0.4), (0.3, 0.7), (0.2, -0.2), (-0.4, 0.5), (-0.9, -0.5), (0.9, 0.9))),
         (3.0, (1, 2, 7, 9, 5), ((-0.6, -0.7), (-0.1, 0.3), (0.4, -0.1), (1.4, -0.3), (NAN, 0.5))),
         (4.0, (7, 9, 1, 2, 5), ((0.7, -0.2), (1.5, 0.0), (-0.2, -0.5), (0.2, 0.4), (1.3, 0.7))))
#: of the balls, and pixels of the picture
DIAMETER, WIDTH, HEIGHT, SCALE = 0.2, 400, 200, 1.0


def shown_in(view, source, steps, **properties):
    """Balls with trails."""
    return session.glyphs(source, view, Orient=0, ScaleFactor=DIAMETER, TrailSteps=steps, SamplesPerPixel=1,
                          **{"PointIdArray": "who", "ColorArrayName": [None, ""], "Ambient": 1.0, "Diffuse": 0.0, "AmbientColor": [1.0] * 3, "DiffuseColor": [1.0] * 3, **properties})


def places(steps, number, count, box=None):
    """Of each point of a step (number: which), in the order of ids, its id and its places in it and in so many before, as far as they are known; box: lengths
    along x and y that repeat."""
    found = []
    for who, x in sorted(zip(*steps[number][1:])):
        if not numpy.isfinite(x).all():
            continue
        line = [numpy.array(x)]
        for _, ids, there in reversed(steps[:number][-count:]):
            if steps[number][1].count(who) != 1 or ids.count(who) != 1 or not numpy.isfinite(there[ids.index(who)]).all():
                break
            way = there[ids.index(who)] - line[-1]
            line.append(line[-1] + (way if box is None else way - numpy.round(way / box) * box))
        found.append((who, numpy.array(line)))
    return found


def delivered(shown):
    """The same, of what is rendered."""
    leaf = shown.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0).NewIterator()
    found = []
    while not leaf.IsDoneWithTraversal():
        data = leaf.GetCurrentDataObject()
        if data.GetNumberOfPoints() > 0:
            points, trail = vtk_to_numpy(data.GetPoints().GetData())[:, :2], data.GetPointData().GetArray("vtkRayTraced_Trail")
            earlier = vtk_to_numpy(trail).reshape(len(points), -1, 3) if trail else numpy.zeros((len(points), 0, 3))
            for who, x, row in zip(vtk_to_numpy(data.GetPointData().GetArray("who")), points, earlier):
                if numpy.isfinite(x).all():
                    found.append((int(who), numpy.concatenate([[x], row[numpy.isfinite(row).all(axis=1)][:, :2]])))
        leaf.GoToNextItem()
    return sorted(found, key=lambda point: (point[0], *point[1][0]))


def coverage(trails, count):
    """The pixels of discs at the last places and of the hulls of discs along the trails, and those too near to an edge to decide."""
    x = (numpy.arange(WIDTH) + 0.5 - WIDTH / 2) / (HEIGHT / 2) * SCALE
    y = -(numpy.arange(HEIGHT) + 0.5 - HEIGHT / 2) / (HEIGHT / 2) * SCALE
    pixels = numpy.stack(numpy.meshgrid(x, y), axis=-1)
    depth = numpy.full(pixels.shape[:2], -numpy.inf)  # within the nearest outline
    for _, line in trails:
        depth = numpy.maximum(depth, 0.5 * DIAMETER - numpy.linalg.norm(pixels - line[0], axis=-1))
        for step, (a, b) in enumerate(zip(line[:-1], line[1:])):
            r, s = (0.25 * DIAMETER * (1.0 - (step + end) / count) for end in (0, 1))
            length = numpy.linalg.norm(b - a)
            axis = (b - a) / length
            along = (pixels - a) @ axis
            across = numpy.abs((pixels - a) @ [-axis[1], axis[0]])
            # The place on the axis whose disc reaches out farthest toward a pixel; where the first disc holds the other, the first
            slope = (r - s) / length
            at = numpy.clip(along - across * slope / numpy.sqrt(1.0 - slope * slope), 0.0, length) if slope < 1.0 else 0.0
            depth = numpy.maximum(depth, r - slope * at - numpy.hypot(along - at, across))
    return depth > 0.0, numpy.abs(depth) < 1e-4


def compare(checks, what, view, shown, steps, number, count, box=None):
    """Points and picture of a step."""
    wanted, found = places(steps, number, count, box), delivered(shown)
    checks.equal(what + ": ids", [who for who, _ in found], [who for who, _ in wanted])
    for (who, line), (_, right) in zip(found, wanted):
        checks.true("%s: id %d was at\n%s instead of\n%s" % (what, who, line, right), line.shape == right.shape and numpy.allclose(line, right, atol=1e-12))
    picture = session.capture(view, "trails-" + what.replace(" ", "-").replace(",", ""))
    covered, unsure = coverage(wanted, count)
    wrong = (comparison.covered(picture) != covered) & ~unsure
    print("%s: %d pixels of %d are wrong, %d too near to an edge" % (what, wrong.sum(), covered.sum(), unsure.sum()))
    checks.equal(what + ": wrong pixels", int(wrong.sum()), 0)
    return picture


def go(view, steps, number):
    """Shows a step; returns what is said."""
    def show():
        view.ViewTime = steps[number][0]
        pv.Render(view)
    return session.messages(show)


def reached(checks, view):
    """Played to, jumped to, gone back to; off; ids of other kinds; blocks; another number of steps."""
    source = series(steps=STEPS)
    shown = shown_in(view, source, 0)
    go(view, STEPS, 4)
    without = session.capture(view, "trails-without")
    shown.TrailSteps = 3
    checks.no_message("switched on", go(view, STEPS, 4))
    jumped = compare(checks, "jumped to", view, shown, STEPS, 4, 3)
    for number in range(5):
        said = go(view, STEPS, number)
        checks.true("step %d: %s" % (number, said), not said or (number == 3 and "position is not finite" in said))
        played = compare(checks, "played to %d" % number, view, shown, STEPS, number, 3)
    checks.equal("played to and jumped to: pixels that differ", int((played != jumped).sum()), 0)
    go(view, STEPS, 2)
    compare(checks, "gone back to", view, shown, STEPS, 2, 3)
    shown.TrailSteps = 10
    go(view, STEPS, 3)
    compare(checks, "more steps than there are", view, shown, STEPS, 3, 10)
    go(view, STEPS, 4)
    source.Script = source.Script.replace("-0.6, -0.7", "-0.6, -0.8")
    changed = STEPS[:3] + ((3.0, STEPS[3][1], ((-0.6, -0.8),) + STEPS[3][2][1:]),) + STEPS[4:]
    go(view, STEPS, 4)
    compare(checks, "another pipeline", view, shown, changed, 4, 10)
    shown.TrailSteps = 0
    go(view, STEPS, 4)
    checks.equal("switched off: pixels that differ", int((session.capture(view, "trails-off") != without).sum()), 0)
    pv.Delete(shown)
    for what, source, ids in (("global ids", series(steps=STEPS, global_ids=True), "None"), ("64 bits", series(steps=STEPS, integer="int64"), "who"),
                              ("blocks", series(steps=STEPS, kind="vtkMultiblockDataSet"), "who")):
        shown = shown_in(view, source, 2, PointIdArray=ids)
        go(view, STEPS, 4)
        compare(checks, what, view, shown, STEPS, 4, 2)
        pv.Delete(shown)


#: A box of lengths 2 and 2 about the origin: 1 leaves it along x, 2 along both axes; nine others hardly move.
BOX = numpy.array([2.0, 2.0])
CROSSING = tuple((float(time), tuple(range(1, 12)), tuple(
    [tuple(((numpy.array(start) + time * numpy.array(way) + 1.0) % BOX - 1.0).tolist()) for start, way in (((0.5, -0.3), (0.3, 0.05)), ((0.75, 0.6), (0.1, 0.2)))] +
    [(-0.8 + 0.15 * i, -0.7 + 0.01 * time) for i in range(9)])) for time in range(4))
TRICLINIC = [2.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 1.0]


def periodic(checks, view):
    """Across the border of a box trails go on to the nearest image; where the box is not known they end there."""
    shown = shown_in(view, series(steps=CROSSING), 3, PeriodicBoundary=1, PeriodicVectors=[2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0])
    checks.no_message("a box", go(view, CROSSING, 3))
    compare(checks, "a box", view, shown, CROSSING, 3, 3, BOX)
    shown.PeriodicBoundary = 0
    go(view, CROSSING, 3)
    checks.equal("without a box: places of the two that cross it, and of one that does not", [len(line) for _, line in delivered(shown)[:3]], [2, 1, 4])
    pv.Delete(shown)
    # One point that moves evenly in a box whose edges are not at right angles, by its lattice coordinates
    edges = numpy.array(TRICLINIC).reshape(3, 3)[:2, :2]
    lattice = [(0.3 + 0.25 * time, 0.8 + 0.2 * time) for time in range(4)]
    steps = tuple((float(time), (1,), (tuple((numpy.array(at) % 1.0 @ edges).tolist()),)) for time, at in enumerate(lattice))
    shown = shown_in(view, series(steps=steps), 3, PeriodicBoundary=1, PeriodicVectors=TRICLINIC)
    go(view, steps, 3)
    ways = numpy.diff(delivered(shown)[0][1], axis=0)
    checks.true("a triclinic box: ways %s" % ways, ways.shape == (3, 2) and numpy.allclose(ways, -numpy.array([0.25, 0.2]) @ edges))
    pv.Delete(shown)


#: So many points that several threads match them: each step has others of them, and more, in another order.
MANY = """
import numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
time = self.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
who = numpy.random.default_rng(int(time)).permutation(60000)[:40000 + 5000 * int(time)]
points = numpy.stack([who / 60000.0, 0.01 * time + 0.0 * who, 0.0 * who], axis=1)
arrays, mine = {"who": who}, slice(0, len(who))
self.GetOutput().GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
"""


def many(checks, view):
    """The places of many points are those of their ids."""
    shown = shown_in(view, session.points_of_ranks(MANY, step_velocity.INFORMATION % ([0.0, 1.0, 2.0], 0.0, 2.0)), 2)
    view.ViewTime = 2.0
    pv.Render(view)
    there = [set(numpy.random.default_rng(time).permutation(60000)[:40000 + 5000 * time].tolist()) for time in range(3)]
    wrong = [who for who, line in delivered(shown) if len(line) != (1 if who not in there[1] else 2 if who not in there[0] else 3) or
             not numpy.allclose(line, [(who / 60000.0, 0.01 * (2 - i)) for i in range(len(line))], atol=1e-6)]
    checks.equal("many points: wrong trails", (wrong, len(delivered(shown))), ([], 50000))
    pv.Delete(shown)


def looks(checks, view):
    """Opacity that falls evenly, in one tube without seams; opaque again; the width of an arrow's trail; what is picked."""
    line = tuple((float(time), (1,), ((-1.0 + 0.5 * time, 0.0),)) for time in range(5))
    shown = shown_in(view, series(steps=line), 4)
    go(view, line, 4)
    opaque = session.capture(view, "trails-opaque")
    for fading in (1.0, 0.4):
        shown.TrailFading = fading
        pv.Render(view)
        picture = session.capture(view, "trails-fading-%g" % fading)
        columns = numpy.arange(210, 295)
        age = (300.0 - columns - 0.5) / 200.0
        alpha = 1.0 - fading * age
        # White in front of a background without green, through the front and the back of the tube
        wanted = 255.0 * (1.0 - (1.0 - alpha) ** 2)
        columns, wanted = columns[age > 0.06], wanted[age > 0.06]
        apart = numpy.abs(picture[HEIGHT // 2, columns, 1] - wanted).max()
        checks.within("levels that TrailFading %g is off" % fading, float(apart), 0.0, 3.0)
        checks.equal("the ball with TrailFading %g" % fading, picture[HEIGHT // 2, 300].tolist()[:3], [255] * 3)
    shown.TrailFading = 0.0
    pv.Render(view)
    checks.equal("TrailFading 0 again: pixels that differ", int((session.capture(view, "trails-opaque-again") != opaque).sum()), 0)
    # Of an arrow of length 0.8 the head is 0.16 wide: that is the middle of its three extents.
    shown.GlyphType, shown.ScaleFactor = "Arrow", 0.8
    pv.Render(view)
    rows = comparison.covered(session.capture(view, "trails-arrow"))[:, 250].sum()
    checks.within("pixels that the trail of an arrow is wide one step before", int(rows), 5, 7)
    pv.Delete(shown)

    shown = shown_in(view, series(steps=STEPS), 3)
    go(view, STEPS, 4)
    line = dict(places(STEPS, 4, 3))[2]
    at = session.pixel_of(view, (*(0.5 * (line[0] + line[1])), 0.0))
    checks.equal("the point under a trail", session.picked(view, "POINT", at), [(shown.Input.SMProxy, "POINT", 3)])
    pv.Delete(shown)


def messages(checks, view):
    """No trails, and a message with the reason."""
    still = session.poly_data(numpy.zeros((2, 3)), who=numpy.arange(2))
    for what, source, properties, words in (
            ("one step", session.source(still), {}, ("TrailSteps", "several time steps")),
            ("no ids", series(steps=STEPS), {"PointIdArray": "None"}, ("TrailSteps", "PointIdArray")),
            ("a missing array of ids", series(steps=STEPS), {"PointIdArray": "nonesuch"}, ("TrailSteps", "PointIdArray"))):
        shown = shown_in(view, source, 2, **properties)
        checks.one_message(what, go(view, STEPS, 4), *words)
        checks.no_message(what + ", once more", go(view, STEPS, 2))
        pv.Delete(shown)


def unreadable(checks, view):
    """Trails end after a step that cannot be read, which one warning says; other steps, and the one shown, are as ever."""
    steps = tuple((float(time), ids, there) for time, (_, ids, there) in enumerate(STEPS))
    files = [session.output("trails-%d.vtp" % time) for time in range(len(steps))]
    for name, (_, ids, there) in zip(files, steps):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(name)
        writer.SetInputData(session.poly_data(numpy.array([(*x, 0.0) for x in there]), who=numpy.array(ids)))
        writer.Write()
    os.remove(files[1])
    source = pv.XMLPolyDataReader(FileName=files)
    shown = shown_in(view, source, 3)
    lacking = steps[:1] + ((1.0, (), ()),) + steps[2:]
    said = go(view, lacking, 4)
    checks.true("the step that cannot be read is named: %s" % said, said.count("The time step at 1 cannot be read") == 1)
    compare(checks, "after an unreadable step", view, shown, lacking, 4, 3)
    go(view, lacking, 3)
    compare(checks, "one step before", view, shown, lacking, 3, 3)
    pv.Delete(shown)


def main():
    """Runs all."""
    session.load()
    checks = Checks()
    view = session.view(WIDTH, HEIGHT)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=SCALE)
    reached(checks, view)
    periodic(checks, view)
    looks(checks, view)
    many(checks, view)
    messages(checks, view)
    unreadable(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
