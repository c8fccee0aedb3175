"""What a change of a property does, in stated terms: scenes whose pictures are known, and claims about pictures and numbers.

A claim is a function of a Change: it looks at what is shown before and after, and reports to the checks what does not hold.
"""
import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_QUAD, vtkDataObject, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

import comparison
import orientations
import session

GLYPHS, SURFACE, TUBES = session.REPRESENTATION, "Ray Traced Surface", "Ray Traced Tubes"
#: what kinds of displays show of the balls: their centers, lines as short as nothing, or, the others, polygons
FORMS = {GLYPHS: "points", "3D Glyphs": "points", TUBES: "lines"}
#: pixels of a side of the view
SIDE = 100
#: levels in [0, 1] by which pictures and closed forms may differ: rounding, and the noise of paths
LEVEL = 3.0 / 255.0
#: fraction by which areas, and lengths in world units by which places may differ
AREA, LENGTH = 0.02, 0.01
#: pixels that must change, or a picture that equals another one would say nothing
CHANGED = 20

#: scene -> (centers of the balls, their diameter, world units from the picture's middle to its edge)
SCENES = {
    "ball": ([[0.0, 0.0, 0.0]], 1.0, 0.75),
    "small": ([[-0.4, 0.0, 0.0]], 0.5, 1.25),
    "arrow": ([[-0.5, 0.0, 0.0]], 1.0, 0.75),
    "two": ([[-0.6, 0.0, 0.0], [0.6, 0.0, 0.0]], 1.0, 1.25),
    "blocks": ([[-0.6, 0.0, 0.0], [0.6, 0.0, 0.0]], 1.0, 1.25),
    "quad": ([[-0.6, -0.6, 0.0], [0.6, -0.6, 0.0], [0.6, 0.6, 0.0], [-0.6, 0.6, 0.0]], 0.5, 1.25),
    "crowd": (numpy.random.default_rng(4).uniform(-0.7, 0.7, (60, 3)), 0.5, 1.0),
    "coarse": ([[0.0, 0.0, 0.0]], 1.0, 0.75),
    "curved": ([[0.0, 0.0, 0.0]], 1.0, 0.75),
}
#: what all rows begin with
START = {"ColorArrayName": [None, ""], "AmbientColor": [0.8] * 3, "DiffuseColor": [0.8] * 3, "SamplesPerPixel": 1, "Denoising": "Never"}
START_OF_GLYPHS = {"GlyphType": "Sphere", "Orient": 0, "Scaling": 1}
#: what shows its own color and nothing else
UNLIT = {"Ambient": 1.0, "Diffuse": 0.0}
#: the same in white: its green is how far it covers a pixel of the background, which has none
WHITE = {**UNLIT, "AmbientColor": [1.0] * 3, "DiffuseColor": [1.0] * 3, "SamplesPerPixel": 16}


def arrays(count):
    """Arrays that properties choose among, for so many points."""
    number = numpy.arange(count)
    x, y, z = orientations.ANGLES[0]
    matrix = orientations.turn(2, z) @ orientations.turn(0, x) @ orientations.turn(1, y)
    same = {
        "quarter": 0.25, "half": 0.5, "lengths": (1.0, 0.5, 0.5), "exponents": (1.0, 1.0, 1.0),
        "velocity": (0.5, 0.0, 0.0), "upward": (0.0, 0.5, 0.0), "push": (0.8, 0.0, 0.0), "spin": (0.0, 0.0, 0.5 * numpy.pi),
        "angles": (x, y, z), "quaternion": orientations.quaternion(matrix), "matrix": matrix.ravel(), "axes": matrix.T.ravel(),
        "tensor": (1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5), "disc": (0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0),
        "negative": (-1.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, -0.5), "turning": (0.5, 0.0, 0.6, 0.0, 0.5, 0.0, -0.6, 0.0, 0.5),
        "six": (1.0, 0.5, 0.6, 0.1, 0.2, 0.3), "rows": (1.0, 0.5, 0.6, 0.5, 0.1, 0.2, 0.6, 0.2, 0.3),
        # Harmonics of a ball of radius 0.5, of one of 0.25, and of one form in the bases DIPY Legacy and MRtrix3
        "round": (numpy.sqrt(4.0 * numpy.pi), 0.0, 0.0, 0.0, 0.0, 0.0), "flat": (numpy.sqrt(numpy.pi), 0.0, 0.0, 0.0, 0.0, 0.0),
        "standing": (3.0, 0.5, 0.2, 0.3, 0.1, -0.4), "lying": (3.0, -0.4, 0.1, 0.3, 0.2, 0.5),
    }
    made = {name: numpy.tile(numpy.array(value, dtype=float), (count, 1)) for name, value in same.items()}
    made.update({
        "size": numpy.where(number % 2 == 0, 0.5, 1.0), "id": number.astype(numpy.int32),
        "index": (number % 2).astype(numpy.int32), "other index": (1 - number % 2).astype(numpy.int32),
        "green": numpy.tile(numpy.array([0, 255, 0], dtype=numpy.uint8), (count, 1)),
        "own": numpy.stack([4 * number, 255 - 3 * number, 255 * (number % 2)], axis=1).astype(numpy.uint8)})
    return made


def points_of(scene, centers):
    """Balls as points; those of "quad" are the corners of a cell."""
    data = session.poly_data(centers, **arrays(len(centers)))
    if scene == "quad":
        session.with_cells(data, "Polys", [range(4)])
    return data


def quadratic_disc(diameter):
    """One quadratic cell, whose corners and middles of edges lie on a circle."""
    angles = numpy.pi / 4.0 * numpy.array([0, 2, 4, 6, 1, 3, 5, 7])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(0.5 * diameter * numpy.stack([numpy.cos(angles), numpy.sin(angles), 0.0 * angles], axis=1), deep=True))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_QUADRATIC_QUAD, 8, range(8))
    return grid


def polygons_of(scene, centers):
    """The same balls as polygons; the points of each have its values, and "height" differs from point to point."""
    if scene == "curved":
        return quadratic_disc(SCENES[scene][1])
    append, values = vtkAppendPolyData(), arrays(len(centers))
    for number, center in enumerate(centers):
        ball = vtkSphereSource()
        ball.SetCenter(center)
        ball.SetRadius(0.5 * SCENES[scene][1])
        # Coarse ones show their facets.
        ball.SetThetaResolution(8 if scene == "coarse" else 64)
        ball.SetPhiResolution(8 if scene == "coarse" else 64)
        ball.Update()
        data = vtkPolyData()
        data.ShallowCopy(ball.GetOutput())
        height = vtk_to_numpy(data.GetPoints().GetData())[:, 1].astype(float)
        session.add_arrays(data, height=height, **{name: numpy.repeat(value[number:number + 1], len(height), axis=0) for name, value in values.items()})
        append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def lines_of(scene, centers):
    """The same balls as tubes: lines of a thousandth of their diameter. That of "coarse" is half as long as it is thick, and "height" differs from
    end to end."""
    half = 0.25 if scene == "coarse" else 0.0005 * SCENES[scene][1]
    ends = numpy.repeat(centers, 2, axis=0) + numpy.tile([[0.0, -half, 0.0], [0.0, half, 0.0]], (len(centers), 1))
    data = session.poly_data(ends, height=numpy.tile([-0.5, 0.5], len(centers)),
                             **{name: numpy.repeat(value, 2, axis=0) for name, value in arrays(len(centers)).items()})
    return session.with_cells(data, "Lines", [(2 * number, 2 * number + 1) for number in range(len(centers))])


MAKERS = {"points": points_of, "lines": lines_of, "polygons": polygons_of}


def data_of(scene, kind, time=0.0):
    """A scene for that kind of display; with time it moves along x. "point" identifies points over time, "changing" does not."""
    make = MAKERS[FORMS.get(kind, "polygons")]
    centers = numpy.array(SCENES[scene][0], dtype=float) + [0.5 * time, 0.0, 0.0]
    parts = [make(scene, centers[i:i + 1]) for i in range(len(centers))] if scene == "blocks" else [make(scene, centers)]
    for number, part in enumerate(parts):
        point = 10000 * number + numpy.arange(part.GetNumberOfPoints())
        session.add_arrays(part, point=point, changing=point + int(1e6 * time))
    made = parts[0]
    if scene == "blocks":
        made = vtkMultiBlockDataSet()
        for number, part in enumerate(parts):
            made.SetBlock(number, part)
    made.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
    return made


class Bench:
    """One view, in which one display is seen at a time, with stated properties and otherwise those of a fresh one."""

    def __init__(self, checks):
        self.checks = checks
        self.view = session.view(SIDE, SIDE)
        self.view.DepthPeeling = 1
        self.displays = {}
        self.seen, self.settings = None, None  # the display that is seen

    def display(self, scene, kind):
        """The display of a scene's points, lines or polygons."""
        form = FORMS.get(kind, "polygons")
        if (scene, form) not in self.displays:
            self.displays[scene, form] = pv.Show(session.source(data_of(scene, kind)), self.view)
            self.displays[scene, form].SetRepresentationType(kind)
            self.displays[scene, form].Visibility = 0
        return self.displays[scene, form]

    def show(self, scene, kind, properties):
        """Shows that display with these properties, and no other one."""
        shown = self.display(scene, kind)
        if shown is not self.seen:
            if self.seen:
                self.settings.set({})
            self.seen, self.settings = shown, session.Settings(shown)
        start = {"Representation": kind, "Visibility": 1, **START}
        if kind == GLYPHS:
            start.update(START_OF_GLYPHS, ScaleFactor=SCENES[scene][1])
        elif kind == TUBES:
            start.update(TubeRadius=0.5 * SCENES[scene][1])
        self.settings.set({name: value(self) if callable(value) else value for name, value in {**start, **properties}.items() if value is not LEFT})
        session.look(self.view, (0.0, 0.0, 10.0), parallel_scale=SCENES[scene][2])
        return shown


#: a start that is not set, for the value that a display begins with
LEFT = object()


class Change:
    """One row's change: what is seen before and after it, and a way to see more."""

    def __init__(self, bench, row, kind):
        self.bench, self.row, self.kind, self.checks = bench, row, kind, bench.checks
        self.name = "%s %s of %s" % (row.name, row.text, kind)
        self.pictures = {}
        self.start = {**getattr(row.claim, "needs", {}), **row.properties}
        self.base = self.start
        self.before = self.look("before")
        self.counted_before = self.counted()
        if row.value is not LEFT:
            self.base = {**self.start, row.name: row.value}
        self.after = self.look("after")
        self.counted_after = self.counted()

    def look(self, what, **properties):
        """The picture, its channels in [0, 1], with other properties."""
        return self.look_at(what, self.kind, {**self.base, **properties})

    def look_at(self, what, kind, properties):
        """The picture of any kind of display."""
        # What ParaView's 3D Glyphs show is cut off by the camera's near plane until the second update.
        for _ in range(2 if kind == "3D Glyphs" else 1):
            self.shown = self.bench.show(self.row.scene, kind, properties)
            # A screenshot without a file
            image = self.bench.view.SMProxy.CaptureWindow(1)
        pixels = session.pixels_of(image)[..., :3]
        self.pictures[what] = pixels.copy()
        return pixels.astype(float) / 255.0

    def goes_back(self):
        """With the value of before the picture is that of before."""
        again = self.look_at("back", self.kind, self.start)
        self.checks.true("%s: set back, %d pixels differ from before" % (self.name, (again != self.before).any(axis=2).sum()), (again == self.before).all())

    def keep_pictures(self):
        """Files of all that was seen, to look at."""
        for what, pixels in self.pictures.items():
            comparison.write_image(session.output("every-property-%s-%s-%s.png" % (self.row.name, self.kind.split()[-1].lower(), what)), pixels)

    def counted(self):
        """RenderStatistics."""
        return session.statistics(self.shown)

    def within(self, what, found, wanted, tolerance):
        """Numbers that are the wanted ones."""
        found, wanted = numpy.round(numpy.atleast_1d(found), 4), numpy.atleast_1d(wanted)
        self.checks.true("%s: %s %s, not %s to %s" % (self.name, what, found.tolist(), numpy.round(wanted, 4).tolist(), tolerance),
                         bool((numpy.abs(found - wanted) <= tolerance).all()))

    def ratio(self, what, found, low, high):
        """A number in an interval."""
        self.checks.within("%s: %s" % (self.name, what), round(float(found), 4), low, high)

    def changed(self):
        """Whatever the rest says, the picture is another one."""
        count = int((numpy.abs(self.after - self.before).max(axis=2) > LEVEL).sum())
        self.checks.true("%s: only %d pixels change" % (self.name, count), count >= CHANGED)

    def same(self, what, picture):
        """The picture after the change is that one."""
        self.checks.picture("%s: %s" % (self.name, what), 255.0 * self.after, 255.0 * picture, pixels=0.003)


def needing(**properties):
    """The function is a claim about displays that have these properties besides the row's."""
    def give(claim):
        claim.needs = properties
        return claim
    return give


def coverage(picture):
    """How far white covers each pixel, rows from the bottom."""
    return picture[::-1, :, 1]


def axes_of(change):
    """World coordinates of the columns, which are those of the rows, too."""
    half = SCENES[change.row.scene][2]
    return (numpy.arange(SIDE) + 0.5) * 2.0 * half / SIDE - half


def moments(change, picture):
    """(area, center, variance along x and y) of what is covered, in world units."""
    covered, axis = coverage(picture), axes_of(change)
    total = covered.sum()
    share = [covered.sum(axis=side) / total for side in (0, 1)]
    center = numpy.array([(part * axis).sum() for part in share])
    return total * (axis[1] - axis[0]) ** 2, center, numpy.array([(part * (axis - at) ** 2).sum() for part, at in zip(share, center)])


def area(*wanted):
    """What is covered of the picture, or of so many equal parts of it from left to right, in world units."""
    @needing(**WHITE)
    def claim(change):
        change.changed()
        pixel = (2.0 * SCENES[change.row.scene][2] / SIDE) ** 2
        found = [part.sum() * pixel for part in numpy.split(coverage(change.after), len(wanted), axis=1)]
        change.within("areas", found, wanted, AREA * max(max(wanted), 0.1))
    return claim


def moved(x, y):
    """The middle of what is covered moves so far."""
    @needing(**WHITE)
    def claim(change):
        change.within("way of the middle", moments(change, change.after)[1] - moments(change, change.before)[1], [x, y], LENGTH)
    return claim


def spread(x, y):
    """The variance of what is covered grows so much: by that of the way that is gone while the shutter is open."""
    @needing(**WHITE)
    def claim(change):
        grown = moments(change, change.after)[2] - moments(change, change.before)[2]
        change.within("growth of the variance", grown, [x, y], 0.001)
    return claim


def colors(*wanted):
    """The color in the middle of equal parts of the picture, from left to right."""
    @needing(**UNLIT)
    def claim(change):
        change.changed()
        width = SIDE // len(wanted)
        found = [change.after[SIDE // 2, width // 2 + part * width] for part in range(len(wanted))]
        change.within("colors", found, wanted, LEVEL)
    return claim


def pixels_of(color, low, high):
    """So many pixels of the color come, there having been none."""
    @needing(**UNLIT)
    def claim(change):
        number = [int((numpy.abs(picture - color).max(axis=2) < 0.2).sum()) for picture in (change.before, change.after)]
        change.ratio("pixels of the color before", number[0], 0, 0)
        change.ratio("pixels of the color", number[1], low, high)
    return claim


def as_with(**properties):
    """The picture is that of these properties."""
    def claim(change):
        change.changed()
        change.same("against %s" % properties, change.look("other", **properties))
    return claim


def as_before(change):
    """The picture stays."""
    change.same("against the picture before", change.before)


def as_paraview(change, kind, properties):
    """The picture is that of a display of ParaView's own."""
    change.changed()
    theirs = 255.0 * change.look_at("paraview", kind, properties)
    change.checks.failures += comparison.against_paraview(255.0 * change.after, theirs, change.name.replace(" ", "-"))


def as_surface(change):
    """The picture is that of ParaView's own Surface of the same balls with the same properties."""
    own = change.bench.display(change.row.scene, "Surface").SMProxy
    as_paraview(change, "Surface", {name: value for name, value in change.base.items() if own.GetProperty(name)})


def as_3d_glyphs(**properties):
    """The picture is that of ParaView's 3D Glyphs, boxes both, with these properties and the same place."""
    @needing(GlyphType="Box")
    def claim(change):
        place = {name: value for name, value in change.base.items() if name in ("Orientation", "Origin", "Position", "Scale")}
        as_paraview(change, "3D Glyphs", {"GlyphType": "Box", "ScaleFactor": SCENES[change.row.scene][1], **properties, **place})
    return claim


def to_light(level):
    """IEC 61966-2-1 (sRGB): light of a display's level."""
    level = numpy.asarray(level, dtype=float)
    return numpy.where(level <= 0.04045, level / 12.92, ((level + 0.055) / 1.055) ** 2.4)


def to_level(light):
    """The inverse."""
    light = numpy.clip(light, 0.0, 1.0)
    return numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1.0 / 2.4) - 0.055)


def filmic(light):
    """Narkowicz's fit of the ACES curve."""
    return numpy.clip(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0.0, 1.0)


def schlick(reflectance, cosine):
    """Reflection of a mirror, in Schlick's approximation."""
    return reflectance + (1.0 - reflectance) * (1.0 - cosine) ** 5


def light_of_ball(light):
    """The ball shows this light, a function of the cosine between its normal and the direction of view."""
    @needing(ShadingMode="Path Tracing", Illumination="Uniform", ToneMapping="None", SamplesPerPixel=8)
    def claim(change):
        change.changed()
        axis = axes_of(change)
        away = numpy.hypot(axis[:, None], axis[None, :]) / (0.5 * SCENES[change.row.scene][1])
        found, wanted = [], []
        # Rings, over which the noise of single pixels averages out.
        for inner, outer in ((0.0, 0.4), (0.4, 0.7), (0.7, 0.85), (0.85, 0.93)):
            ring = (away >= inner) & (away < outer)
            cosine = numpy.sqrt(1.0 - away[ring] ** 2)
            found.append(to_level(to_light(change.after[::-1][ring]).mean(axis=0)))
            wanted.append(to_level([(part * numpy.ones_like(cosine)).mean() for part in light(cosine)]))
        change.within("levels of four rings", found, wanted, LEVEL)
    return claim


def developed(curve):
    """Each pixel's light goes through the curve."""
    def claim(change):
        change.changed()
        mask = comparison.covered(255.0 * change.before)
        wanted = to_level(curve(to_light(change.before[mask])))
        change.within("largest difference from the curve", numpy.abs(change.after[mask] - wanted).max(), 0.0, LEVEL)
    return claim


def light(low, high):
    """The mean of what is covered becomes so many times as bright."""
    def claim(change):
        mask = comparison.covered(255.0 * change.before)
        change.ratio("ratio of mean light", to_light(change.after)[mask].mean() / to_light(change.before)[mask].mean(), low, high)
    return claim


def noise(low, high, **truth):
    """The squared error against the picture with these properties becomes so many times as large."""
    def claim(change):
        true = change.look("true", **truth)
        error = [float(numpy.square(picture - true).mean()) for picture in (change.before, change.after)]
        change.checks.true("%s: there is no noise to begin with" % change.name, error[0] > 1e-4)
        change.ratio("ratio of squared errors", error[1] / max(error[0], 1e-12), low, high)
    return claim


def glyphs(number):
    """So many glyphs are shown."""
    def claim(change):
        change.checks.true("%s: as many before" % change.name, change.counted_before["glyphs"] != number)
        change.checks.equal(change.name + ": glyphs", change.counted_after["glyphs"], number)
    return claim


def reads(name, wanted, tolerance=1e-6, part=slice(None)):
    """A property, or a part of it, perhaps another one, or a number of RenderStatistics, has this value after the next picture."""
    def claim(change):
        counted = change.counted()
        found = counted[name] if name in counted else change.shown.GetPropertyValue(name)
        change.within(name, list(found)[part] if hasattr(found, "__len__") else found, wanted, tolerance)
    return claim


def both(*claims):
    """All of these claims."""
    def claim(change):
        for one in claims:
            one(change)
    claim.needs = {name: value for one in claims for name, value in getattr(one, "needs", {}).items()}
    return claim
