"""Glyphs among ParaView's other actors: what is in front, behind, intersecting, translucent or on top.

Usage: pvpython compositing.py
Each scene is checked twice: as a picture against its baseline, and glyph pixels against 3D Glyphs in the same scene.
"""
import numpy
import paraview.simple as pv

import comparison
import session

SIZE = (400, 300)
#: of the pixels that may differ from 3D Glyphs' picture by more than comparison.LEVELS, and levels in the mean
SHARE, MEAN = 0.001, 0.2


def grid():
    """3 x 3 spheres in the plane z = 0, colored by column."""
    x, y = numpy.meshgrid([-1.0, 0.0, 1.0], [-1.0, 0.0, 1.0])
    points = numpy.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    return session.source(session.poly_data(points, column=points[:, 0]))


def ours(points, view):
    """The grid as ray-traced glyphs."""
    return session.glyphs(points, view, "Sphere", Orient=0, ScaleFactor=0.8)


def theirs(points, view):
    """The grid as ParaView's 3D Glyphs."""
    shown = pv.Show(points, view)
    shown.SetRepresentationType("3D Glyphs")
    shown.GlyphType = "Sphere"
    shown.GlyphType.ThetaResolution = shown.GlyphType.PhiResolution = 128
    shown.Orient = 0
    # With Scaling off, 3D Glyphs ignore the scale factor too.
    shown.Scaling = 1
    shown.ScaleMode = "No Data Scaling Off"
    shown.ScaleFactor = 0.8
    return shown


def opaque(view):
    """A slanted opaque plane that cuts through the middle of all spheres."""
    plane = pv.Plane(Origin=[-1.6, -1.6, -0.5], Point1=[1.6, -1.6, 0.5], Point2=[-1.6, 1.6, -0.5])
    shown = pv.Show(plane, view)
    session.solid(shown, (0.2, 0.7, 0.3))
    return shown


def wireframe(view):
    """Wires around and in front of the spheres."""
    box = pv.Sphere(Radius=1.5, ThetaResolution=12, PhiResolution=12)
    shown = pv.Show(box, view)
    shown.SetRepresentationType("Wireframe")
    session.solid(shown, (0.0, 0.0, 0.0))
    return shown


def translucent(view):
    """A translucent plane through the spheres' middle: half of each is behind it."""
    plane = pv.Plane(Origin=[-1.6, -1.6, 0.0], Point1=[1.6, -1.6, 0.0], Point2=[-1.6, 1.6, 0.0])
    shown = pv.Show(plane, view)
    session.solid(shown, (0.1, 0.2, 0.9))
    shown.Opacity = 0.5
    return shown


def axes(view):
    """The axes grid; bounds given, because those of 3D Glyphs are the points' and ours the glyphs'."""
    view.AxesGrid.UseCustomBounds = 1
    view.AxesGrid.CustomBounds = [-1.5, 1.5, -1.5, 1.5, -0.5, 0.5]
    return view.AxesGrid


def scalar_bar(view):
    """A scalar bar over the spheres; pictures() shows it."""
    bar = pv.GetScalarBar(pv.GetColorTransferFunction("column"), view)
    bar.WindowLocation = "Any Location"
    bar.Position = [0.45, 0.2]
    return bar


#: what each scene adds to the view and returns, to be shown in this scene only
SCENES = {"opaque": opaque, "wireframe": wireframe, "translucent": translucent, "axes": axes, "scalarbar": scalar_bar}


def hidden(points, view, show):
    """The display of one kind of glyph, not to be seen before its pictures."""
    shown = show(points, view)
    pv.ColorBy(shown, ("POINTS", "column"))
    session.cool_to_warm("column")
    shown.SetScalarBarVisibility(view, False)
    shown.Visibility = 0
    return shown


def pictures(shown, view, added, who):
    """All scenes with one kind of glyph; added: by the scenes' names, what they have added to the view so far."""
    captured = {}
    shown.Visibility = 1
    for scene, add in SCENES.items():
        shown.SetScalarBarVisibility(view, scene == "scalarbar")
        if scene not in added:
            added[scene] = add(view)
        added[scene].Visibility = 1
        # From another place first, so that no scene has the glyphs' image of the one before.
        for distance in (7.1, 7.0):
            session.look(view, (1.0, 2.0, distance))
            pv.Render(view)
        captured[scene] = session.capture(view, "compositing-%s%s" % (scene, who))
        added[scene].Visibility = 0
    shown.Visibility = 0
    return captured


def main():
    """All scenes."""
    session.load()
    view = session.view(*SIZE)
    shown, reference = hidden(grid(), view, ours), hidden(grid(), view, theirs)
    added, failures = {}, []
    # 3D Glyphs first: no picture of theirs is of a view in which ours have been drawn.
    of_paraview = pictures(reference, view, added, "-paraview")
    of_ours = pictures(shown, view, added, "")
    for scene in SCENES:
        name = "compositing-" + scene
        mine, paraviews = of_ours[scene], of_paraview[scene]
        failures += comparison.against_baseline(mine, name)
        # Translucent surfaces, lines and text are ParaView's in both pictures: only depth errors of ours can differ.
        share, mean, apart = comparison.difference(mine[..., :3], paraviews[..., :3])
        comparison.write_image(session.output(name + "-against-paraview.png"), 4 * apart)
        print("%s: %.3f%% of the pixels differ from ParaView's by more than %d, mean %.3f"
              % (name, 100 * share, comparison.LEVELS, mean))
        if share > SHARE or mean > MEAN:
            failures.append("%s: %.3f%% of the pixels differ from 3D Glyphs' picture (allowed %.3f%%), mean %.3f (allowed %.3f)"
                            % (name, 100 * share, 100 * SHARE, mean, MEAN))
    session.finish(failures)


if __name__ == "__main__":
    main()
