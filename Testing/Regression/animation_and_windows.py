"""Playing a time series, windows of no size, and multisampled windows.

Usage: pvpython animation_and_windows.py DATA-FOLDER
"""
import sys

import numpy
import paraview.simple as pv

import comparison
import session


def impact(folder, width=300, height=200):
    """(view, reader, representation) of the simulation as spheres."""
    reader = pv.OpenDataFile(folder + "/impact/impact.vtk.series")
    view = session.view(width, height)
    shown = session.glyphs(reader, view, "Sphere", Orient=0, SelectScaleArray="diameter",
                           ScaleMode="Magnitude", ScaleFactor=1.0)
    session.solid(shown, (0.9, 0.7, 0.3))
    session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 4.0), (0.0, 0.0, 1.0))
    return view, reader, shown


def depths_of(view):
    """Where ParaView clips the step that is shown; the first picture of a step still counts the bounds of the last one."""
    pv.Render(view)
    return view.GetActiveCamera().GetClippingRange()


def play(folder, cache):
    """Each step looks different and builds one structure; going back gives the same pictures and bounds again."""
    pv.GetSettingsProxy("GeneralSettings").CacheGeometryForAnimation = cache
    view, reader, shown = impact(folder)
    scene = pv.GetAnimationScene()
    scene.PlayMode = "Snap To TimeSteps"
    failures, pictures, depths = [], [], []
    scene.GoToFirst()  # before the view's first picture, which ParaView keeps as that of the first step
    pv.Render(view)
    steps = len(reader.TimestepValues)
    for step in range(steps):
        before = session.statistics(shown)
        if step:
            scene.GoToNext()
        pictures.append(session.capture(view, "animation-%d" % step))
        depths.append(depths_of(view))
        after = session.statistics(shown)
        builds = after["structureBuilds"] - before["structureBuilds"]
        uploads = after["instanceUploads"] - before["instanceUploads"]
        if step and (builds != 1 or uploads != 1):
            failures.append("step %d: %d structures built, %d uploads of instances" % (step, builds, uploads))
        if step and comparison.difference(pictures[-1], pictures[-2])[0] < 0.001:
            failures.append("step %d looks like the one before" % step)
    for step in reversed(range(steps)):
        if (session.capture(view, "animation-back-%d" % step) != pictures[step]).any():
            failures.append("step %d looks different when played backwards" % step)
        if depths_of(view) != depths[step]:
            failures.append("step %d lies between other depths when played backwards: %s, %s"
                            % (step, depths_of(view), depths[step]))
        scene.GoToPrevious()
    # Steps that are at hand get an array of several, too.
    shown.SelectScaleArray, shown.ScaleMode = "diameter, diameter, diameter", "Vector Components"
    for step in range(steps):
        said = session.messages(scene.GoToFirst if step == 0 else scene.GoToNext)
        if said.strip() or comparison.difference(session.capture(view, "animation-joined-%d" % step), pictures[step])[0] > 0.001:
            failures.append("step %d with three lengths looks different; %s" % (step, said.strip() or "no message"))
    shown.SelectScaleArray, shown.ScaleMode = "diameter", "Magnitude"
    pv.Render(view)
    scene.GoToFirst()
    before = session.statistics(shown)
    scene.Play()
    after = session.statistics(shown)
    print("played: %d structures for %d steps" % (after["structureBuilds"] - before["structureBuilds"], steps))
    # ParaView begins with the first step, which is at hand.
    if after["structureBuilds"] - before["structureBuilds"] not in (steps - 1, steps):
        failures.append("playing built %d structures" % (after["structureBuilds"] - before["structureBuilds"]))
    if (session.capture(view, "animation-played") != pictures[-1]).any():
        failures.append("the last step looks different after playing")
    pv.Delete(view)
    pv.Delete(reader)
    return ["cache %d: %s" % (cache, failure) for failure in failures]


def no_size(folder):
    """A minimised window has no pixels; afterwards the glyphs are there again, and nothing was said."""
    view, reader, shown = impact(folder)
    pv.Render(view)
    expected = session.capture(view, "window-before")
    failures = []
    # No window of X11 is without a pixel, and ParaView asks in vain for one; a part of it may be.
    for size, part in (([1, 1], 1.0), ([1, 200], 1.0), ([300, 1], 1.0), ([300, 200], 0.0), ([300, 200], 0.001)):
        renderer = view.GetRenderer()

        def shrink():
            view.ViewSize = size
            renderer.SetViewport(0.0, 0.0, part, part)
            pv.Render(view)
        said = session.messages(shrink)
        if said:
            failures.append("size %s: %s" % (size, said))
        view.ViewSize = [300, 200]
        renderer.SetViewport(0.0, 0.0, 1.0, 1.0)
        pv.Render(view)
        if (session.capture(view, "window-after-%d-%d" % tuple(size)) != expected).any():
            failures.append("after size %s, part %g of it, the picture is another one" % (size, part))
    pv.Delete(view)
    pv.Delete(reader)
    return failures


def multisampled(folder):
    """Glyphs through a surface and before one: in a multisampled window as in a plain one, in whatever order."""
    failures, pictures, alone = [], {}, {}
    for samples in (0, 4):
        for glyphs_first in (True, False):
            view = session.view(300, 200)
            view.MultiSamples = samples
            reader = pv.OpenDataFile(folder + "/impact/impact.vtk.series")
            sources = [reader, pv.Sphere(Center=[14.0, 14.0, 4.0], Radius=8.0, ThetaResolution=128, PhiResolution=128)]
            for source in sources if glyphs_first else sources[::-1]:
                if source is reader:
                    shown = session.glyphs(reader, view, "Sphere", samples=16, Orient=0, ScaleFactor=1.0)
                else:
                    shown = pv.Show(source, view)
                    shown.SetRepresentationType("Surface")
                session.solid(shown, (0.9, 0.7, 0.3) if source is reader else (0.2, 0.5, 0.3))
            view.ViewTime = 0.8
            session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 4.0), (0.0, 0.0, 1.0))
            pv.Render(view)
            window = view.GetRenderWindow()
            name = "multisamples-%d-%s" % (samples, "first" if glyphs_first else "last")
            pictures[samples, glyphs_first] = session.capture(view, name)
            print("%s: the window has %d samples" % (name, window.GetMultiSamples()))
            if window.GetMultiSamples() != samples:
                failures.append("%s: the window has %d samples" % (name, window.GetMultiSamples()))
            pv.Hide(sources[1], view)
            pv.Render(view)
            alone[samples] = session.capture(view, name + "-alone")
            pv.Delete(view)
    for samples in (0, 4):
        share, mean, _ = comparison.difference(pictures[samples, True], pictures[samples, False])
        print("%d samples, glyphs first against last: %.3f%%, mean %.4f" % (samples, 100 * share, mean))
        if mean > 0.0:
            failures.append("%d samples: the order of the representations shows" % samples)
    # Four samples resolve a glyph's fraction of a pixel in quarters of the contrast, which is at most 255; how the fraction is
    # rounded is up to the driver.
    # Colors inside are the same. With the surface, that one's own edges are smooth in addition.
    for what, plain, smooth, allowed in (("alone", alone[0], alone[4], 0.0005),
                                         ("with a surface", pictures[0, True], pictures[4, True], 0.01)):
        apart = numpy.abs(plain.astype(int) - smooth.astype(int)).max(axis=2)
        share, touched = float((apart > 255 / 4 + 1).mean()), float((apart > 2).mean())
        print("4 samples against none, %s: %.3f%% differ by more than a quarter, %.3f%% at all" % (what, 100 * share, 100 * touched))
        if share > allowed or not 0.001 < touched < 0.1:
            failures.append("multisampled, %s: %.3f%% of the pixels differ by more than a quarter, %.3f%% at all"
                            % (what, 100 * share, 100 * touched))
    return failures


def main(folder):
    """All of them."""
    session.load()
    failures = play(folder, 0) + play(folder, 1) + no_size(folder) + multisampled(folder)
    session.finish(failures)


if __name__ == "__main__":
    main(sys.argv[1])
