"""Host memory that runs out while glyphs are made: the process lives, one message names memory and a remedy, and the
next render without the limit is right.

Usage: pvpython memory_limit.py MEGABYTES
       pvpython memory_limit.py held
       mpiexec -n 2 pvbatch memory_limit.py ranks
MEGABYTES: that the process may take beyond what it has before the glyphs are made, which take some 100.
held: what the process keeps of glyphs after their picture.
ranks: memory runs out on one rank while data are gathered and measured; the others must not wait for it.
"""
import ctypes
import resource
import sys

import numpy
import paraview.simple as pv

import session
from checks import Checks

POINTS = 1000000


def show(source, view):
    """Small spheres."""
    shown = session.glyphs(source, view, Orient=0, ScaleFactor=0.02)
    session.solid(shown, (0.9, 0.8, 0.3))
    return shown


def held_bytes(statistics):
    """Bytes of the heap that are in use, without the device's, which GPUs and some lavapipes have elsewhere."""
    with open("/proc/self/maps") as maps:
        inside = "llvmpipe" in statistics["DeviceName"] and "/memfd:allocation" not in maps.read()
    return session.allocated() - (statistics["deviceBytes"] if inside else 0)


def held():
    """The arrays that the kernels compare with the next ones, and the order of the glyphs; neither low parts of centers nor
    velocities where all are zero."""
    session.load()
    checks = Checks()
    generator = numpy.random.default_rng(1)
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 6.0))
    centers = (generator.integers(-1024, 1024, (POINTS, 3)) / 1024.0).astype(numpy.float32)  # no rounding
    directions = generator.uniform(-1.0, 1.0, (POINTS, 3)).astype(numpy.float32)
    few, many = (session.source(session.poly_data(centers[:count], direction=directions[:count], still=numpy.zeros((count, 3), numpy.float32)))
                 for count in (100, POINTS))

    def shown_as(source, shape, properties):
        """The display, after its picture."""
        shown = session.glyphs(source, view, shape, Orient=int(shape != "Sphere"), SelectOrientationVectors="direction", ScaleFactor=0.02,
                               ScaleMode="Magnitude", SelectScaleArray="direction", **properties)
        session.solid(shown, (0.9, 0.8, 0.3))
        pv.Render(view)
        return shown

    # Bytes of a center, a size, a rotation, and a place in the order of the plugin's BVH
    for shape, arrays, properties in (("Sphere", 12 + 4 + 4, {}), ("Box", 12 + 4 + 16 + 4, {}),
                                      ("Sphere", 12 + 4 + 4, {"MotionBlur": 1, "VelocityArray": "still"})):
        pv.Delete(shown_as(few, shape, properties))  # its program stays
        shown = shown_as(many, shape, properties)
        shown.Visibility = 0
        pv.Render(view)
        before = session.allocated()
        shown.Visibility = 1
        pv.Render(view)
        after = held_bytes(session.statistics(shown))
        checks.within("%s, %s: bytes that a glyph keeps" % (shape, properties), (after - before) / POINTS, arrays - 4, arrays + 6)
        pv.Delete(shown)
    checks.report()


def limited(megabytes):
    """Glyphs under the limit, then without it."""
    session.load()
    checks = Checks()
    generator = numpy.random.default_rng(1)
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 6.0))
    few = session.source(session.poly_data(generator.uniform(-1.0, 1.0, (1000, 3)).astype(numpy.float32)))
    show(few, view)
    pv.Render(view)  # device, programs and OpenGL are there before the limit
    many = session.source(session.poly_data(generator.uniform(-1.0, 1.0, (POINTS, 3)).astype(numpy.float32)))
    show(many, view)
    view.SMProxy.Update()  # the points are gathered, no glyphs made
    resource.setrlimit(resource.RLIMIT_AS, (session.memory("VmSize") + megabytes * 2**20, resource.RLIM_INFINITY))
    said = session.messages(lambda: pv.Render(view))
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    print("%d MB: %s" % (megabytes, said.strip()))
    what = "%d MB" % megabytes
    checks.one_message(what, said, "memory")
    checks.true(what + ": the message names no remedy: " + said.strip(), "GlyphMode" in said or "hide" in said.lower())
    checks.no_message(what + ", limit lifted", session.messages(lambda: pv.Render(view)))
    pixels = session.capture(view, "memory-limit-%d" % megabytes)
    fresh = session.view(80, 60)
    session.look(fresh, (0.0, 0.0, 6.0))
    show(few, fresh)
    show(many, fresh)
    expected = session.capture(fresh, "memory-limit-%d-fresh" % megabytes)
    checks.covered(what + ", fresh view", expected, 0.1)
    checks.picture(what + ", limit lifted", pixels, expected, pixels=0.002, mean=0.1)
    checks.report()


#: Script of a source of which each rank has half of the points.
HALVES = """
import numpy
generator = numpy.random.default_rng(1)
points = generator.uniform(-1.0, 1.0, (%d, 3)).astype(numpy.float32)
arrays = {name: generator.normal(size=len(points)).astype(numpy.float32) for name in "uvw"}
mine = slice(rank * len(points) // ranks, (rank + 1) * len(points) // ranks)
""" % POINTS


def arrows(source, view, scales):
    """Arrows whose heads, lengths and factor depend on the points of all ranks."""
    return session.glyphs(source, view, "Arrow", ArrowHeads="Fixed", SelectOrientationVectors="u, v, w", ScaleMode="Magnitude", SelectScaleArray=scales)


def fill_heap():
    """Takes what is left free of the heap: blocks in it are asked of no limit of the address space."""
    libc = ctypes.CDLL(None)
    libc.malloc.restype, libc.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
    libc.sbrk.restype, libc.sbrk.argtypes = ctypes.c_void_p, [ctypes.c_ssize_t]
    end = libc.sbrk(0)
    while libc.sbrk(0) == end:
        libc.malloc(60000)  # below the threshold beyond which blocks are mapped


def on_one_rank():
    """Limits that one rank reaches in one step or another of an update, in which the ranks find numbers together."""
    session.load()
    checks = Checks()
    view = session.view(80, 60)
    session.look(view, (0.0, 0.0, 6.0))
    halves = session.points_of_ranks(HALVES)
    shown = arrows(halves, view, "u, v")
    pv.Render(view)
    fill_heap()
    failures = 0
    for trial, megabytes in enumerate(range(20)):
        shown.SelectScaleArray = ("u, w", "u, v")[trial % 2]  # the points are gathered again
        resource.setrlimit(resource.RLIMIT_AS, (session.memory("VmSize") + megabytes * 2**20, resource.RLIM_INFINITY))
        said = session.messages(view.SMProxy.Update)
        resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        print("%d MB: %s" % (megabytes, said.strip()), flush=True)
        if said:
            checks.one_message("%d MB" % megabytes, said, "memory")
            failures += 1
    checks.true("memory ran out %d times" % failures, 2 <= failures < 20)
    shown.SelectScaleArray = "v, w"
    checks.no_message("limit lifted", session.messages(lambda: pv.Render(view)))
    pixels = session.capture(view, "memory-limit-ranks")
    fresh = session.view(80, 60)
    session.look(fresh, (0.0, 0.0, 6.0))
    arrows(halves, fresh, "v, w")
    checks.picture("limit lifted", pixels, session.capture(fresh, "memory-limit-ranks-fresh"), pixels=0.002, mean=0.1)
    checks.report()


if __name__ == "__main__":
    {"ranks": on_one_rank, "held": held}.get(sys.argv[1], lambda: limited(int(sys.argv[1])))()
