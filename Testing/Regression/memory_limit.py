"""Host memory that runs out while glyphs are made: the process lives, one message names memory and a remedy, and the
next render without the limit is right.

Usage: pvpython memory_limit.py MEGABYTES
MEGABYTES: that the process may take beyond what it has before the glyphs are made, which take some 100.
"""
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


if __name__ == "__main__":
    limited(int(sys.argv[1]))
