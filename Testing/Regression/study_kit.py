"""The answers of the study kit, which come from pictures of ids, are those that the numbers of its scenes give.

Usage: pvpython study_kit.py FOLDER-OF-THE-KIT
"""
import os
import sys

import numpy

import session
from checks import Checks

sys.path.insert(0, sys.argv[1])
import stimuli  # noqa: E402

SIZE = (240, 180)


def seen_balls(scene):
    """The balls that are seen at some pixel's center, by intersecting each ray with all of them."""
    width, height = SIZE
    step = 2.0 * numpy.tan(numpy.radians(0.5 * stimuli.ANGLE)) / height
    x, y = numpy.meshgrid((numpy.arange(width) + 0.5 - width / 2) * step, (numpy.arange(height) + 0.5 - height / 2) * step)
    rays = numpy.stack([x, y, -numpy.ones_like(x)], axis=-1).reshape(-1, 3)
    rays /= numpy.linalg.norm(rays, axis=1)[:, None]
    nearest, which = numpy.full(len(rays), numpy.inf), numpy.full(len(rays), -1)
    for number, (place, diameter) in enumerate(zip(scene["place"] - [0.0, 0.0, stimuli.EYE], scene["length"])):
        along = rays @ place
        chord = (0.5 * diameter) ** 2 - place @ place + along * along
        t = numpy.where(chord > 0.0, along - numpy.sqrt(numpy.maximum(chord, 0.0)), numpy.inf)
        which, nearest = numpy.where(t < nearest, number, which), numpy.minimum(t, nearest)
    return numpy.unique(which[which >= 0])


def answer_of(task, scenes):
    """By the numbers of a scene: arrows, or balls, or both."""
    arrows, balls = scenes.get("Arrow"), scenes.get("Sphere")
    if task == "lengths":
        return ("orange", "blue")[int(arrows["length"][1] > arrows["length"][0])]
    if task == "direction":
        ways = balls["place"] - arrows["place"][0]
        return ("red", "green", "blue", "violet")[(ways @ arrows["direction"][0] / numpy.linalg.norm(ways, axis=1)).argmax()]
    return str((balls["context"][seen_balls(balls)] == 0.0).sum())


def main():
    """Makes a small set."""
    session.load()
    checks = Checks()
    scenes, wanted, shown = {}, {}, stimuli.Stage.set

    def keep(stage, kind, scene):
        scenes[kind] = scene
        shown(stage, kind, scene)

    stimuli.Stage.set = keep
    for task in stimuli.TASKS:
        function = getattr(stimuli, task)

        def kept(stage, random, count, task=task, function=function):
            scenes.clear()
            found = function(stage, random, count)
            wanted.setdefault(task, []).append(answer_of(task, scenes))
            return found

        setattr(stimuli, task, kept)
    folder = session.output("study")
    rows = stimuli.make(folder, trials=1, size=SIZE, samples=4)
    checks.equal("rows", len(rows), len(stimuli.TASKS) * len(stimuli.DENSITIES) * len(stimuli.RENDERINGS))
    with open(os.path.join(folder, "answers.csv"), encoding="utf-8") as file:
        checks.equal("lines of answers.csv", len(file.readlines()), len(rows) + 1)
    for number, row in enumerate(rows):
        trial = number % (len(stimuli.DENSITIES) * len(stimuli.RENDERINGS)) // len(stimuli.RENDERINGS)
        checks.equal("the answer of " + row["file"], str(row["answer"]), wanted[row["task"]][trial])
        checks.within("what is seen in " + row["file"], row["seen"], stimuli.SEEN, 1.1)
        picture = session.read_image(os.path.join(folder, row["file"]))
        checks.equal("size of " + row["file"], picture.shape[1::-1], SIZE)
    for start in range(0, len(rows), len(stimuli.RENDERINGS)):
        pictures = [session.read_image(os.path.join(folder, row["file"])).astype(int) for row in rows[start:start + len(stimuli.RENDERINGS)]]
        apart = [numpy.abs(picture - pictures[0]).mean() for picture in pictures[1:]]
        checks.true("renderings of %s look alike: %s" % (rows[start]["file"], apart), numpy.array(apart).min() > 1.0)
    checks.report()


if __name__ == "__main__":
    main()
