"""Every kind of view and picture: layouts, large screenshots, transparent background, stereo, time steps, shapes.

Usage: pvpython views.py DATA-FOLDER
"""
import sys

import numpy
import paraview.simple as pv

import comparison
import session


def cross():
    """Five spheres of different sizes at different depths."""
    points = numpy.array([[0, 0, 0], [1, 0, 1], [-1, 0, -1], [0, 1, 1], [0, -1, -1.0]])
    return session.source(session.poly_data(points, size=numpy.array([0.9, 0.6, 0.5, 0.4, 0.3])))


def show(points, view):
    """The cross as spheres."""
    shown = session.glyphs(points, view, "Sphere", Orient=0, SelectScaleArray="size",
                           ScaleMode="Magnitude", ScaleFactor=1.0)
    pv.ColorBy(shown, ("POINTS", "size"))
    session.cool_to_warm("size")
    shown.SetScalarBarVisibility(view, False)
    session.look(view, (1.0, 1.0, 5.0))
    return shown


def layout():
    """Two views side by side, different cameras, one picture."""
    points = cross()
    left = session.view(200, 150)
    arrangement = pv.CreateLayout("two")
    pv.AssignViewToLayout(left, arrangement)
    right = session.view(200, 150)
    pv.AssignViewToLayout(right, arrangement, hint=1)
    arrangement.SetSize(400, 200)
    show(points, left)
    show(points, right)
    session.look(right, (0.0, 0.0, 4.0), parallel_scale=2.0)
    pv.RenderAllViews()
    path = session.output("views-layout.png")
    pv.SaveScreenshot(path, arrangement, ImageResolution=[400, 200])
    failures = comparison.against_baseline(session.read_image(path), "views-layout")
    pv.Delete(left)
    pv.Delete(right)
    return failures


def large():
    """A screenshot larger than the window shows the same scene as the small one."""
    view = session.view(160, 120)
    show(cross(), view)
    pv.Render(view)
    small = session.capture(view, "views-small", ImageResolution=[160, 120])
    big = session.capture(view, "views-large", ImageResolution=[480, 360])
    reduced = big.reshape(120, 3, 160, 3, -1).mean(axis=(1, 3))
    failures = comparison.against_baseline(big, "views-large")
    # Pixels on an outline are mixed in the reduced picture; everything else must agree.
    apart = numpy.abs(reduced - small).max(axis=2)
    share = float((apart > 2 * comparison.LEVELS).mean())
    if big.shape[:2] != (360, 480) or share > 0.05:
        failures.append("large screenshot: size %s, %.2f%% of the pixels differ from the small one" % (big.shape, 100 * share))
    pv.Delete(view)
    return failures


def transparent():
    """The background of a transparent picture has alpha 0, glyphs have 255."""
    view = session.view(200, 150)
    show(cross(), view)
    pv.Render(view)
    pixels = session.capture(view, "views-transparent", TransparentBackground=1)
    pv.Delete(view)
    if pixels.shape[2] != 4:
        return ["transparent background: the picture has %d channels" % pixels.shape[2]]
    center, corner = pixels[75, 100, 3], pixels[2, 2, 3]
    share = float((pixels[..., 3] > 127).mean())
    if center != 255 or corner != 0 or not 0.05 < share < 0.6:
        return ["transparent background: alpha %d on a glyph, %d beside, %.1f%% opaque" % (center, corner, 100 * share)]
    return []


def stereo():
    """Left and right eye differ and each shows the glyphs."""
    view = session.view(200, 150)
    show(cross(), view)
    pv.Render(view)
    eyes = [session.capture(view, "views-" + mode.replace(" ", "-"), StereoMode=mode) for mode in ("Left Eye Only", "Right Eye Only")]
    pv.Delete(view)
    share, _, _ = comparison.difference(*eyes)
    covered = [float(comparison.covered(eye).mean()) for eye in eyes]
    if share < 0.005 or min(covered) < 0.05:
        return ["stereo: eyes differ on %.2f%% of the pixels, covered %s" % (100 * share, covered)]
    return []


def time_steps(folder):
    """Stepping through the simulation moves the glyphs, and going back gives the first picture again."""
    reader = pv.OpenDataFile(folder + "/impact/impact.vtk.series")
    view = session.view(300, 200)
    session.glyphs(reader, view, "Sphere", Orient=0, SelectScaleArray="diameter",
                   ScaleMode="Magnitude", ScaleFactor=1.0)
    session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 4.0), (0.0, 0.0, 1.0))
    pictures = []
    for name, time in (("first", 0.0), ("later", 0.8), ("back", 0.0)):
        view.ViewTime = time
        pv.Render(view)
        pictures.append(session.capture(view, "views-time-" + name))
    failures = comparison.against_baseline(pictures[1], "views-time-later")
    if (pictures[0] != pictures[2]).any():
        failures.append("time steps: the first step looks different the second time")
    if comparison.difference(pictures[0], pictures[1])[0] < 0.02:
        failures.append("time steps: nothing moved")
    pv.Delete(view)
    return failures


def ellipsoids(folder):
    """Components and quaternions: the molecules of the nematic."""
    reader = pv.OpenDataFile(folder + "/nematic/nematic.vtk.series")
    view = session.view(300, 300)
    shown = session.glyphs(reader, view, "Sphere", Orient=1, SelectOrientationVectors="quaternion",
                           OrientationMode="Quaternion", SelectScaleArray="shape",
                           ScaleMode="Vector Components", ScaleFactor=1.0)
    session.solid(shown, (0.9, 0.7, 0.3))
    view.ViewTime = reader.TimestepValues[-1]
    pv.ResetCamera(view)
    pv.Render(view)
    return comparison.against_baseline(session.capture(view, "views-ellipsoids"), "views-ellipsoids")


def main(folder):
    """All of them."""
    session.load()
    failures = layout() + large() + transparent() + stereo() + time_steps(folder) + ellipsoids(folder)
    session.finish(failures)


if __name__ == "__main__":
    main(sys.argv[1])
