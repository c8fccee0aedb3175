"""Translucent glyphs show all their layers, as ParaView's depth peeling shows those of surfaces, in every shading mode.

The surfaces are the Glyph filter's. Not 3D Glyphs: to those vtkGlyph3DMapper applies the opacity twice, so that spheres of
opacity 0.2 cover 0.07 of what is behind them in place of 1 - 0.8^2 = 0.36.

Usage: pvpython translucent.py
"""
import numpy
import paraview.simple as pv

import comparison
import session
from same_as_3d_glyphs import RESOLUTION, give_shape, ours, scene

#: tessellations for depth peeling, which takes all of them again for every layer
COARSER = {**RESOLUTION, "Sphere": {"ThetaResolution": 64, "PhiResolution": 64}}
#: mean differences in levels of 255. ParaView blends each layer into 8 bits, twice for every layer: half a level each.
COLOR = 2.0


def peeling_view():
    """A view that peels as many layers as there are."""
    view = session.view()
    view.UseLight = 1
    view.DepthPeeling = 1
    view.MaximumNumberOfPeels = 100
    session.look(view, (2.0, 1.5, 5.0))
    return view


def theirs(points, view, shape):
    """The scene as the surfaces of ParaView's Glyph filter."""
    kind = shape.replace("Mesh", "")
    glyph = pv.Glyph(Input=points, GlyphType=kind, OrientationArray=["POINTS", "vector"], ScaleArray=["POINTS", "vector"],
                     VectorScaleMode="Scale by Magnitude", ScaleFactor=0.3, GlyphMode="All Points")
    for name, value in COARSER.get(shape, {}).items():
        setattr(glyph.GlyphType, name, value)
    shown = pv.Show(glyph, view)
    shown.SetRepresentationType("Surface")
    return shown


def wall(view, kind):
    """An opaque plane through the middle of the glyphs."""
    plane = pv.Plane(Origin=[-1.5, -1.5, -0.2], Point1=[1.5, -1.5, 0.2], Point2=[-1.5, 1.5, -0.2])
    shown = pv.Show(plane, view)
    shown.SetRepresentationType(kind)
    session.solid(shown, (0.2, 0.7, 0.3))
    return shown


class Scene:
    """The scene in a view of its own, by one of the two."""

    def __init__(self, points, who):
        self.points, self.view, self.who = points, peeling_view(), who
        self.shown, self.wall = None, None

    def display(self, shape):
        """Of ParaView's a new one for each shape: its surfaces stay without normals once their data have had none."""
        if self.shown and self.who == "ours":
            give_shape(self.shown, shape)
            return self.shown
        if self.shown:
            pv.Delete(self.shown)
        self.shown = (ours if self.who == "ours" else theirs)(self.points, self.view, shape)
        session.solid(self.shown, (0.8, 0.5, 0.2))
        return self.shown

    def picture(self, shape, opacity, with_wall):
        """What the view shows."""
        self.display(shape).Opacity = opacity
        if with_wall and not self.wall:
            self.wall = wall(self.view, "Ray Traced Surface" if self.who == "ours" else "Surface")
        if self.wall:
            self.wall.Visibility = int(with_wall)
        return session.capture(self.view, "translucent-%s-%g%s-%s" % (shape, opacity, "-wall" if with_wall else "", self.who))


def unlit(points):
    """Glyphs that show their color whatever shines on them, by two shading modes, as floats."""
    view = peeling_view()
    shown = session.glyphs(points, view, "Sphere", samples=16, Orient=0, ScaleFactor=0.7, Illumination="Lights of the View", Ambient=1.0,
                           Diffuse=0.0, Opacity=0.3)
    session.solid(shown, (0.8, 0.5, 0.2))
    view.Background = [0.0, 0.0, 0.0]
    captured = []
    for mode in ("Local", "Path Tracing"):
        shown.ShadingMode = mode
        pv.Render(view)
        captured.append(session.capture(view, "translucent-unlit-" + mode.split()[0].lower()).astype(float)[..., :3])
    pv.Delete(view)
    return captured


def own_opacities(failures):
    """Opacities from an array multiply that of the representation; of 0 there is no glyph, beyond 1 and NaN count as 1."""
    generator = numpy.random.default_rng(7)
    places = generator.uniform(-1.0, 1.0, (24, 3))
    half = numpy.arange(24) % 2 == 0
    values = {"half": numpy.full(24, 0.5), "some": numpy.where(half, 0.0, 7.0), "odd": numpy.where(half, numpy.nan, 1.0)}
    every, rest = session.poly_data(places, **values), session.poly_data(places[~half])
    stage = session.Stage(peeling_view())

    def picture(name, data, opacity=1.0, **properties):
        shown = stage.show(data, "Sphere", Orient=0, ScaleFactor=0.6, Opacity=opacity, **properties)
        session.solid(shown, (0.8, 0.5, 0.2))
        said = session.messages(lambda: pv.Render(stage.view))
        if said:
            failures.append("opacities, %s: %s" % (name, said))
        return session.capture(stage.view, "opacities-" + name)

    # An opacity of 0 makes the whole set translucent, whose edges are blended into eight bits once more.
    for name, mine, other, allowed in (
            ("half of half", picture("half of half", every, 0.5, GlyphOpacityArray="half"), picture("quarter", every, 0.25), 0),
            ("some", picture("some", every, GlyphOpacityArray="some"), picture("rest", rest), 1),
            ("not a number", picture("not a number", every, GlyphOpacityArray="odd"), picture("opaque", every), 0)):
        apart = int(numpy.abs(mine.astype(int) - other).max())
        print("opacities, %s: %d levels apart at most" % (name, apart))
        if apart > allowed or (mine == mine[0, 0]).all():
            failures.append("opacities, %s: %d levels apart" % (name, apart))


def edges(failures):
    """The background does not show between an opaque glyph and what is behind it, nearly opaque, of another display."""
    view = session.view(200, 150, (0, 255, 0))
    session.look(view, (0.0, 0.0, 5.0))
    ball = session.glyphs(session.source(session.poly_data(numpy.array([[0.0, 0.0, 1.0]]))), view, "Sphere", samples=16, Orient=0, ScaleFactor=1.4)
    box = session.glyphs(session.source(session.poly_data(numpy.array([[0.0, 0.0, -5.0]]))), view, "Box", Orient=0, ScaleFactor=9.0, Opacity=0.999)
    for shown, color in (ball, (0.9, 0.1, 0.1)), (box, (0.2, 0.2, 0.9)):
        session.solid(shown, color)
    for mode in ("Local", "Ambient Occlusion", "Path Tracing"):
        ball.ShadingMode = mode
        pv.Render(view)
        picture = session.capture(view, "translucent-edge-" + mode.split()[0].lower()).astype(int)
        green = picture[..., 1] - picture[..., [0, 2]].max(axis=2)
        print("edges, %s: %d levels greener than red or blue at most" % (mode, green.max()))
        if green.max() > 0:
            failures.append("edges, %s: the background shows in %d pixels, by up to %d levels" % (mode, (green > 0).sum(), green.max()))
    pv.Delete(view)


def main():
    """Against ParaView, then mode against mode."""
    session.load()
    points = scene()
    failures = []
    scenes = Scene(points, "ours"), Scene(points, "paraview")
    for shape, opacity, with_wall in (("Sphere", 0.5, False), ("Arrow", 0.5, False), ("Box", 0.2, False),
                                      ("Sphere", 0.5, True), ("MeshSphere", 0.5, False)):
        mine, paraviews = (each.picture(shape, opacity, with_wall) for each in scenes)
        failures += comparison.against_paraview(
            mine, paraviews, "translucent-%s-%g%s" % (shape, opacity, "-wall" if with_wall else ""), color=COLOR)

    # Path tracing stops at each layer by chance: the same in the mean. A pixel's mean of 16 samples of at most 255 levels is off by
    # 32, that of 20000 pixels by a quarter of a level.
    local, path = unlit(points)
    both = (local.max(axis=2) > 0) & (path.max(axis=2) > 0)
    apart = (local - path)[both].mean(axis=0)
    print("path tracing differs from local shading by %s levels over %d pixels" % (numpy.round(apart, 2), both.sum()))
    if both.sum() < 20000 or numpy.abs(apart).max() > 1.0:
        failures.append("path tracing shows other layers than local shading: %s levels apart over %d pixels" % (apart, both.sum()))
    own_opacities(failures)
    edges(failures)
    session.finish(failures)


if __name__ == "__main__":
    main()
