"""What ParaView does to finished pictures leaves glyphs whole: FXAA every pixel, its ambient occlusion no stripes; lens and lines.

Usage: pvpython screen_effects.py
"""
import numpy
import paraview.simple as pv

import session
from accumulation import shown_by
from checks import Checks, cloud

#: of the balls of the wall
RADIUS = 0.165


def scene(stage, count=400, size=0.25, samples=8):
    """Puts a packing of spheres on the stage."""
    data = cloud(count).GetClientSideObject().GetOutputDataObject(0)
    session.solid(stage.show(data, "Sphere", Orient=0, ScaleFactor=size, SamplesPerPixel=samples), (0.9, 0.6, 0.3))
    session.look(stage.view, (0.0, 0.0, 4.5))


def inner(mask, width=3):
    """A mask without the pixels that are so near to its edge."""
    for _ in range(width):
        smaller = mask.copy()
        smaller[1:] &= mask[:-1]
        smaller[:-1] &= mask[1:]
        smaller[:, 1:] &= mask[:, :-1]
        smaller[:, :-1] &= mask[:, 1:]
        mask = smaller
    return mask


def holes(checks, stage):
    """Transparent pictures have no wholly transparent pixels among glyphs."""
    view = stage.view
    for name, samples in (("smooth", 8), ("hard", 1)):
        scene(stage, samples=samples)
        pv.Render(view)
        alphas = {}
        for effect in (0, 1):
            view.UseFXAA = effect
            alphas[effect] = session.capture(view, "screen-effects-alpha-%s-%d" % (name, effect), TransparentBackground=1)[..., 3]
        # The display is that of the case before, with other samples.
        checks.equal("%s edges: pixels are covered in part" % name, bool(((alphas[0] > 0) & (alphas[0] < 255)).any()), name == "smooth")
        # Where all around is covered there must be something.
        for effect, alpha in alphas.items():
            count = int((inner(alphas[0] > 0, 1) & (alpha == 0)).sum())
            print("%s edges, UseFXAA %d: %d holes in %d pixels" % (name, effect, count, (alphas[0] > 0).sum()))
            checks.equal("%s edges, UseFXAA %d: wholly transparent pixels among glyphs" % (name, effect), count, 0)


def kept(checks, stage):
    """FXAA smooths ParaView's own geometry and changes no pixel of glyphs, nor of the background beside them."""
    view = stage.view
    scene(stage, count=100)
    tilted = pv.Box(XLength=1.2, YLength=1.2, ZLength=0.1, Center=[2.4, 0.0, 0.0])
    pv.Show(tilted, view).Orientation = [0.0, 0.0, 8.0]
    session.look(view, (1.0, 0.0, 7.0))
    pictures = []
    for effect in (0, 1):
        view.UseFXAA = effect
        pictures.append(session.capture(view, "screen-effects-kept-%d" % effect)[..., :3].astype(int))
    changed = (pictures[0] != pictures[1]).any(axis=2)
    ordinary = pictures[0].shape[1] * 5 // 8  # left of it are glyphs, right of it the box
    print("pixels that FXAA changes: %d of glyphs, %d of a box" % (changed[:, :ordinary].sum(), changed[:, ordinary:].sum()))
    checks.equal("pixels of glyphs that FXAA changes", int(changed[:, :ordinary].sum()), 0)
    checks.true("FXAA smooths no edge of a box", changed[:, ordinary:].sum() > 20)
    changed[:, :ordinary] = False
    growing(checks, view, changed)
    pv.Hide(tilted, view)


def growing(checks, view, edges):
    """Of an image that grows the frame that ends it, or after which it is stopped, is smoothed, and no other: its user waits for them."""
    import raytracedglyphs  # comes with the plugin
    raytracedglyphs.SetSamplesPerRender(3, view)  # of 8
    for what in ("finished", "stopped"):
        view.CameraPosition = [1.0, 0.001 * len(what), 7.0]
        frames = []
        for _ in range(5):
            pv.Render(view)
            frames.append(shown_by(view)[edges])
            if what == "stopped" and len(frames) == 2:
                raytracedglyphs.StopRefinement(view)
        checks.equal("%s: frames in which a box becomes smooth" % what, [bool((a != b).any()) for a, b in zip(frames, frames[1:])],
                     [False, True, False, False])
    raytracedglyphs.SetSamplesPerRender(0, view)


def walls():
    """(view, points, hidden displays by kinds): a wall of balls before an ordinary ball, in a wire box: what those leave in the buffers matters."""
    columns, rows = numpy.meshgrid(numpy.linspace(-2.0, 2.0, 14), numpy.linspace(-1.5, 1.5, 14))
    points = numpy.stack([columns.ravel(), rows.ravel(), numpy.zeros(columns.size)], axis=1)
    view = session.view(240, 180)
    displays = {}
    for kind in (session.REPRESENTATION, "3D Glyphs"):
        shown = session.glyphs(session.source(session.poly_data(points)), view, Orient=0, ScaleFactor=2 * RADIUS, samples=1)
        shown.SetRepresentationType(kind)
        if kind == "3D Glyphs":
            shown.GlyphType = "Sphere"
            shown.GlyphType.ThetaResolution = shown.GlyphType.PhiResolution = 24
            shown.GlyphType.Radius, shown.Scaling = RADIUS, 0
        session.solid(shown, (0.9, 0.6, 0.3))
        shown.Visibility = 0
        displays[kind] = shown
    pv.Show(pv.Box(XLength=4.5, YLength=3.5, ZLength=1.0), view).SetRepresentationType("Wireframe")
    pv.Show(pv.Sphere(Center=[0.0, 0.0, -0.3], Radius=0.6), view)
    return view, points, displays


def darkened(view, points, kind, position):
    """Patches of pixels in the middle of the balls: brightness with the view's ambient occlusion over that without."""
    session.look(view, position)
    pictures = []
    for effect in (0, 1):
        view.UseAmbientOcclusion = effect
        pv.Render(view)
        name = "screen-effects-ssao-%s-%d" % (kind.split()[0].lower(), effect)
        pictures.append(session.capture(view, name).sum(axis=2, dtype=int))
    ratio = pictures[1] / numpy.maximum(pictures[0], 1)
    toward = RADIUS * numpy.array(position) / numpy.linalg.norm(position)
    patches = []
    for point in points[numpy.hypot(points[:, 0], points[:, 1]) > 0.8]:
        column, row = session.pixel_of(view, point + toward)
        if 4 < column < 235 and 4 < row < 175:
            patches.append(ratio[177 - row:182 - row, column - 2:column + 3])
    return numpy.array(patches).reshape(len(patches), -1)


def stripes(checks):
    """The view's own ambient occlusion draws no stripes or dots on glyphs: it leaves all as they are, or darkens them as
    it does 3D Glyphs.
    """
    view, points, displays = walls()
    positions = ((0.0, 0.0, 6.0), (2.0, 1.0, 6.0))
    patches_of = {}
    # 3D Glyphs first: no picture of theirs is of a view in which ours have been drawn.
    for kind in ("3D Glyphs", session.REPRESENTATION):
        displays[kind].Visibility = 1
        # On ours both effects work at once.
        view.UseFXAA = int(kind == session.REPRESENTATION)
        patches_of[kind] = [darkened(view, points, kind, position) for position in positions]
        displays[kind].Visibility = 0
    for position, ours, theirs in zip(positions, patches_of[session.REPRESENTATION], patches_of["3D Glyphs"]):
        # Darkest ball, brightest ball, darkest pixel.
        ours, theirs = ((patches.mean(axis=1).min(), patches.mean(axis=1).max(), patches.min()) for patches in (ours, theirs))
        what = "SSAO from %s: balls have %.2f to %.2f of their brightness, single pixels at least %.2f" % (position, *ours)
        what += "; with 3D Glyphs %.2f to %.2f, %.2f" % theirs
        print(what)
        untouched = ours[2] > 0.98
        alike = ours[0] > theirs[0] - 0.1 and ours[1] < theirs[1] + 0.1 and ours[2] > theirs[2] - 0.1
        checks.true(what, untouched or alike)


def spread(alpha):
    """Mean square distance of what covers a picture from its middle, along one axis, in pixels."""
    rows, columns = (numpy.arange(size) + 0.5 - size / 2 for size in alpha.shape)
    return (alpha * (rows[:, None] ** 2 + columns ** 2)).sum() / 2 / alpha.sum()


def lens(checks, stage):
    """What is out of the focus of ParaView's camera is as wide as a thin lens makes it, with both projections."""
    view = stage.view
    session.solid(stage.show(session.poly_data(numpy.zeros((1, 3))), "Sphere", Orient=0, ScaleFactor=0.5, SamplesPerPixel=256), (0.9, 0.6, 0.3))
    for scale, focus in ((None, 4.0), (None, 8.0), (1.5, 4.0)):
        session.look(view, (0.0, 0.0, 6.0), parallel_scale=scale)
        view.CameraFocalDisk = 0.9
        found = []
        for distance in (0.0, focus, 6.0):
            view.CameraFocalDistance = distance
            found.append(spread(session.capture(view, "screen-effects-lens", TransparentBackground=1)[..., 3] / 255.0))
        # In the plane in focus; rays of a parallel projection fan out from it alone.
        pixel = 2 * scale / 180 if scale else 2 * focus * numpy.tan(numpy.radians(view.CameraViewAngle / 2)) / 180
        wanted = 0.45 * abs(6.0 - focus) / (focus if scale else 6.0) / pixel
        radius = 2 * numpy.sqrt(found[1] - found[0])
        print("focus at %g: circle of confusion %.2f pixels, %.2f expected" % (focus, radius, wanted))
        checks.true("focus at %g: circle of %.2f pixels, not %.2f" % (focus, radius, wanted), abs(radius - wanted) < 0.03 * wanted)
        checks.true("in focus: spread %.3f, not %.3f" % (found[2], found[0]), abs(found[2] - found[0]) < 0.02 * found[0])
    view.CameraFocalDistance = 0.0


def outlines(checks, stage):
    """Lines lie around what is sharp, and nowhere where a lens or motion blurs: the left ball stands, the right one moves."""
    view = stage.view
    data = session.poly_data(numpy.array([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), velocity=numpy.array([[0.0, 0.0, 0.0], [0.5, 0.3, 0.0]]))
    shown = stage.show(data, "Sphere", Orient=0, ScaleFactor=1.0, SamplesPerPixel=16, OutlineWidth=2.0, Ambient=1.0, Diffuse=0.0)
    session.solid(shown, (0.9, 0.6, 0.3))
    session.look(view, (0.0, 0.0, 6.0))
    for what, focus, moves, wanted in (("sharp", 0.0, 0, [True, True]), ("a lens in focus", 6.0, 0, [True, True]), ("a lens out of focus", 5.0, 0, [False, False]),
                                       ("motion", 0.0, 1, [True, False])):
        view.CameraFocalDisk, view.CameraFocalDistance = 0.9, focus
        shown.MotionBlur, shown.VelocityArray, shown.ShutterTime = moves, "velocity", 0.4
        black = session.capture(view, "screen-effects-outlines")[..., :3].max(axis=2) < 60
        found = [int(half.sum()) for half in (black[:, :120], black[:, 120:])]
        checks.true("%s: lines of %s pixels" % (what, found), all(pixels > 150 if line else pixels == 0 for pixels, line in zip(found, wanted)))
    view.CameraFocalDistance = 0.0


def joined(checks, view):
    """Lines run around a surface and a tube, not around the triangles and the pieces that they are made of."""
    kinds = {"Ray Traced Surface": pv.Sphere(Center=[-0.7, 0.0, 0.0], ThetaResolution=24, PhiResolution=16),
             "Ray Traced Tubes": pv.Line(Point1=[0.3, -0.5, 0.0], Point2=[1.1, 0.5, 0.0], Resolution=10)}
    displays = [session.show(source, view, kind, samples=16, Ambient=1.0, Diffuse=0.0, **({"TubeRadius": 0.15} if "Tubes" in kind else {})) for kind, source in kinds.items()]
    for display in displays:
        session.solid(display, (0.9, 0.6, 0.3))
    session.look(view, (0.2, 0.0, 3.0))
    pictures = []
    for width in (0.0, 2.0):
        displays[0].OutlineWidth = width
        pictures.append(session.capture(view, "screen-effects-joined-%d" % width)[..., :3].astype(int))
    shown = (abs(pictures[0] - pictures[0][0, 0]) > 20).any(axis=2)
    changed = (abs(pictures[1] - pictures[0]) > 20).any(axis=2)
    for kind, half in zip(kinds, (numpy.s_[:, :120], numpy.s_[:, 120:])):
        checks.true("%s: a line around it" % kind, changed[half].sum() > 100)
        checks.equal("%s: pixels with a line within" % kind, int((changed & inner(shown, 4))[half].sum()), 0)
    for display in displays:
        display.Visibility = 0


def main():
    """All parts."""
    session.load()
    checks = Checks()
    stage = session.Stage(session.view(240, 180))
    holes(checks, stage)
    kept(checks, stage)
    lens(checks, stage)
    outlines(checks, stage)
    stage.hide()
    joined(checks, stage.view)
    stripes(checks)
    checks.report()


if __name__ == "__main__":
    main()
