"""Pictures and answers for a study of how well people read glyphs in four renderings.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython stimuli.py OUTPUT-FOLDER [--trials 4] [--seed 1] [--size 800 600] [--samples 64]
"""
import argparse
import csv
import os
import tempfile

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

TASKS = ("lengths", "direction", "count")
#: glyphs of a scene
DENSITIES = {"sparse": 150, "dense": 600}
BLUR = {"MotionBlur": 1, "VelocityArray": "velocity", "MotionBlurMask": "context", "ShutterTime": 1.0}
RENDERINGS = {
    "local": {"ShadingMode": "Local"},
    "occlusion": {"ShadingMode": "Ambient Occlusion", "Denoising": "Always"},
    "paths": {"ShadingMode": "Path Tracing", "Denoising": "Always"},
    "blur": {"ShadingMode": "Local", **BLUR}}
#: how much of what a question is about must be seen
SEEN = 0.6
GRAY, COLORS = (170, 170, 175), {"orange": (235, 120, 20), "blue": (40, 90, 220), "red": (205, 30, 45), "green": (30, 150, 60), "violet": (140, 60, 170)}
BALL, ARROW = 0.12, 0.4
EYE, ANGLE = 5.0, 30.0


class Stage:
    """A view with arrows and balls, whose numbers change from scene to scene."""

    def __init__(self, size, samples):
        self.view = pv.CreateView("RenderView")
        self.view.ViewSize, self.view.OrientationAxesVisibility = list(size), 0
        self.view.UseColorPaletteForBackground, self.view.BackgroundColorMode, self.view.Background = 0, "Single Color", [1.0] * 3
        self.samples, self.sources, self.shown = samples, {}, {}

    def set(self, kind, scene):
        """Gives balls or arrows their places, lengths, directions and colors; velocities are those of what blurs."""
        data, points = vtkPolyData(), vtkPoints()
        points.SetData(numpy_to_vtk(scene["place"], deep=True))
        data.SetPoints(points)
        for name, values in scene.items():
            array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        if kind not in self.sources:
            self.sources[kind] = pv.TrivialProducer()
        self.sources[kind].GetClientSideObject().SetOutput(data)
        self.sources[kind].MarkModified(self.sources[kind])
        self.sources[kind].UpdatePipeline()
        if kind not in self.shown:
            shown = self.shown[kind] = pv.Show(self.sources[kind], self.view)
            shown.SetRepresentationType("Ray Traced Glyphs")
            shown.GlyphType, shown.Orient, shown.SelectOrientationVectors = kind, int(kind == "Arrow"), "direction"
            shown.Scaling, shown.ScaleMode, shown.ScaleFactor = 1, "Magnitude", 1.0
            pv.ColorBy(shown, ("POINTS", "rgb"))
            shown.MapScalars = 0
        self.shown[kind].Visibility = 1
        self.scale(kind, "length")

    def scale(self, kind, array):
        """Which array has the lengths: where it is zero there is no glyph."""
        self.shown[kind].SelectScaleArray = array

    def look(self, eye=(0.0, 0.0, EYE), focus=(0.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), parallel_scale=None):
        """Sets the camera."""
        self.view.CameraPosition, self.view.CameraFocalPoint, self.view.CameraViewUp = list(eye), list(focus), list(up)
        self.view.CameraViewAngle, self.view.CameraParallelProjection = ANGLE, int(parallel_scale is not None)
        self.view.CameraParallelScale = parallel_scale or 1.0

    def ids(self, kind):
        """Of each pixel the number of the ball or arrow whose surface is seen at its center, or -1; rows from below."""
        import raytracedglyphs  # comes with the plugin
        first = next(iter(self.shown.values()))
        first.SamplesPerPixel, first.ShadingMode, first.Denoising = 1, "Local", "Never"
        others = [shown for name, shown in self.shown.items() if name != kind and shown.Visibility]
        with tempfile.TemporaryDirectory() as folder:
            raytracedglyphs.SaveFeatureImage(os.path.join(folder, "ids.vti"), self.view)
            reader = vtkXMLImageDataReader()
            reader.SetFileName(os.path.join(folder, "ids.vti"))
            reader.Update()
        image = reader.GetOutput()
        found = vtk_to_numpy(image.GetPointData().GetArray("OriginalId")).reshape(image.GetDimensions()[1::-1])
        if others:
            # The color identifies the display: balls and arrows have no color in common.
            albedo = vtk_to_numpy(image.GetPointData().GetArray("Albedo")).reshape(found.shape + (3,))
            own = vtk_to_numpy(self.sources[kind].GetClientSideObject().GetOutputDataObject(0).GetPointData().GetArray("rgb")) / 255.0
            at = numpy.clip(found, 0, len(own) - 1)
            found = numpy.where(numpy.abs(albedo - own[at]).max(axis=-1) < 0.01, found, -1)
        return found

    def counts(self, kind, count):
        """How many pixels of each are seen."""
        found = self.ids(kind)
        return numpy.bincount(found[found >= 0], minlength=count)


def directions(random, count):
    """Unit vectors, evenly distributed."""
    vectors = random.normal(size=(count, 3))
    return vectors / numpy.linalg.norm(vectors, axis=1)[:, None]


def crowd(random, count, lengths):
    """Gray glyphs at random places in a cube, of random directions and velocities."""
    return {"place": random.uniform(-1.0, 1.0, (count, 3)), "length": lengths, "direction": directions(random, count),
            "velocity": 0.25 * directions(random, count), "rgb": numpy.tile(numpy.array(GRAY, dtype=numpy.uint8), (count, 1)), "context": numpy.ones(count)}


def mark(scene, number, color):
    """Makes one of them a colored one that stays sharp."""
    scene["rgb"][number], scene["context"][number] = COLORS[color], 0.0


def alone(scene):
    """The lengths of the marked ones; zero of the others."""
    return numpy.where(scene["context"] > 0.0, 0.0, scene["length"])


def seen(stage, kind, scene, marked):
    """The least fraction of a marked glyph that the others leave to be seen."""
    scene["alone"] = alone(scene)
    stage.set(kind, scene)
    stage.look()
    among = stage.counts(kind, len(scene["length"]))[marked]
    stage.scale(kind, "alone")
    single = stage.counts(kind, len(scene["length"]))[marked]
    stage.scale(kind, "length")
    return (among / numpy.maximum(single, 1)).min()


def length_of(stage, scene, number):
    """Length of an arrow as a camera beside it sees it, in pixels."""
    stage.scale("Arrow", "alone")
    way = scene["direction"][number]
    middle = scene["place"][number] + 0.5 * scene["length"][number] * way
    side = numpy.cross(way, numpy.eye(3)[numpy.abs(way).argmin()])
    stage.look(middle + side / numpy.linalg.norm(side), middle, numpy.cross(side, way), 0.3)
    columns = numpy.flatnonzero((stage.ids("Arrow") == number).any(axis=0))
    stage.scale("Arrow", "length")
    return len(columns)


def lengths(stage, random, count):
    """Which of two arrows is longer."""
    while True:
        scene = crowd(random, count, random.uniform(0.5, 1.0, count) * ARROW)
        ratio = random.choice([1.1, 1.2, 1.35, 1.5])
        longer = int(random.integers(2))
        # Both lie nearly across the view.
        scene["direction"][:2] *= [1.0, 1.0, 0.4]
        scene["direction"][:2] /= numpy.linalg.norm(scene["direction"][:2], axis=1)[:, None]
        scene["length"][:2] = 0.7 * ARROW
        scene["length"][longer] *= ratio
        mark(scene, 0, "orange")
        mark(scene, 1, "blue")
        share = seen(stage, "Arrow", scene, [0, 1])
        if share >= SEEN:
            found = [length_of(stage, scene, number) for number in range(2)]
            answer = ("orange", "blue")[int(found[1] > found[0])]
            return {"question": "Which arrow is longer: orange or blue?", "answer": answer, "difficulty": ratio, "seen": share}


def direction(stage, random, count):
    """Which of four balls an arrow points at."""
    names = ("red", "green", "blue", "violet")
    while True:
        scene = crowd(random, count, random.uniform(0.5, 1.0, count) * ARROW)
        scene["place"][0] *= 0.5
        way = scene["direction"][0]
        scene["length"][0] = ARROW
        mark(scene, 0, "orange")
        others = [vector for vector in directions(random, 60) if 0.5 < vector @ way < 0.95]
        targets = numpy.array([way] + others[:3])
        order = random.permutation(4)
        places = scene["place"][0] + targets[order] * random.uniform(0.7, 0.9, (4, 1))
        balls = {"place": places, "length": numpy.full(4, BALL), "rgb": numpy.array([COLORS[name] for name in names], dtype=numpy.uint8), "context": numpy.zeros(4),
                 "velocity": numpy.zeros((4, 3))}
        apart = numpy.linalg.norm(places[:, None] - places, axis=2) + numpy.eye(4)
        if len(others) < 3 or apart.min() < 2.0 * BALL:
            continue
        # What would hide the balls goes to the other side.
        near = numpy.linalg.norm(scene["place"][:, None] - places, axis=2).min(axis=1) < ARROW
        scene["place"][near & (scene["context"] > 0.0)] *= -1.0
        share = seen(stage, "Arrow", scene, [0])
        stage.set("Sphere", balls)
        among = stage.counts("Sphere", 4)
        stage.shown["Arrow"].Visibility = 0
        single = stage.counts("Sphere", 4)
        share = min(share, (among / numpy.maximum(single, 1)).min())
        if share >= SEEN:
            # What a camera at the arrow's tail sees in the middle of its picture
            stage.look(scene["place"][0], scene["place"][0] + way, numpy.eye(3)[numpy.abs(way).argmin()])
            found = stage.ids("Sphere")
            stage.shown["Arrow"].Visibility = 1
            angle = numpy.degrees(numpy.arccos(max(vector @ way for vector in others[:3])))
            return {"question": "Which ball does the orange arrow point at: %s, %s, %s or %s?" % names, "answer": names[found[found.shape[0] // 2, found.shape[1] // 2]],
                    "difficulty": round(float(angle), 1), "seen": share}
        stage.shown["Arrow"].Visibility = 1
        stage.shown["Sphere"].Visibility = 0


def count(stage, random, count):
    """How many balls of a color are seen."""
    scene = crowd(random, count, random.uniform(0.7, 1.0, count) * BALL)
    stage.set("Sphere", scene)
    stage.look()
    pixels = stage.counts("Sphere", count)
    # Of a disc of that size, at that distance
    height = stage.view.ViewSize[1] / (2.0 * numpy.tan(numpy.radians(0.5 * ANGLE)))
    share = pixels / (numpy.pi * (0.5 * scene["length"] * height / (EYE - scene["place"][:, 2])) ** 2)
    marked = random.permutation(numpy.flatnonzero(share >= SEEN))[:random.integers(4, 12)]
    for number in marked:
        mark(scene, number, "orange")
    stage.set("Sphere", scene)
    found = stage.ids("Sphere")
    found = numpy.unique(found[found >= 0])
    return {"question": "How many orange balls do you see?", "answer": int((scene["context"][found] == 0.0).sum()), "difficulty": count, "seen": share[marked].min()}


def make(folder, trials=4, seed=1, size=(800, 600), samples=64):
    """Writes all pictures and answers.csv; returns its rows."""
    os.makedirs(folder, exist_ok=True)
    pv._DisableFirstRenderCameraReset()
    rows = []
    for task in TASKS:
        stage = Stage(size, samples)
        for density, number in DENSITIES.items():
            for trial in range(1, trials + 1):
                random = numpy.random.default_rng([seed, TASKS.index(task), number, trial])
                found = {"lengths": lengths, "direction": direction, "count": count}[task](stage, random, number)
                stage.look()
                for rendering, properties in RENDERINGS.items():
                    for shown in stage.shown.values():
                        shown.MotionBlur = 0
                        for name, value in properties.items():
                            setattr(shown, name, value)
                        shown.SamplesPerPixel = samples
                    name = "%s-%s-%d-%s.png" % (task, density, trial, rendering)
                    pv.SaveScreenshot(os.path.join(folder, name), stage.view, ImageResolution=list(size))
                    rows.append({"file": name, "task": task, "rendering": rendering, "density": density, "trial": trial,
                                 **found, "seen": round(float(found["seen"]), 3)})
                for shown in stage.shown.values():
                    shown.MotionBlur = 0
        pv.Delete(stage.view)
    with open(os.path.join(folder, "answers.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    return rows


def main():
    """Makes everything."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder")
    parser.add_argument("--trials", type=int, default=4, help="scenes of each task and density")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", type=int, nargs=2, default=(800, 600), help="of the pictures, in pixels")
    parser.add_argument("--samples", type=int, default=64, help="a pixel")
    options = parser.parse_args()
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=globals())
    rows = make(options.folder, options.trials, options.seed, options.size, options.samples)
    print("%d pictures and answers.csv are in %s" % (len(rows), options.folder))


if __name__ == "__main__":
    main()
