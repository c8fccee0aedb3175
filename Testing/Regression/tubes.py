"""Ray-traced tubes: as ParaView's Tube filter shows them, picked by cell and point, translucent without seams, bad input said once.

Usage: pvpython tubes.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

import comparison
import session
from checks import Checks, stepwise
from direction_colors import levels

TUBES = "Ray Traced Tubes"
#: fraction of the pixels that may be covered in one of two pictures only, or have other colors; levels of 255 by which the rest may differ in the mean
SILHOUETTE, INTERIOR = 0.002, 1.0
UNLIT = {"Ambient": 1.0, "Diffuse": 0.0}


def line_data(lines, cell_arrays=None, **arrays):
    """vtkPolyData of poly-lines, each a list of points; arrays of all points one after another, and of cells."""
    data = session.poly_data(numpy.concatenate([numpy.asarray(line, dtype=float) for line in lines]), **arrays)
    ends = numpy.cumsum([len(line) for line in lines])
    session.with_cells(data, "Lines", [range(end - len(line), end) for line, end in zip(lines, ends)])
    session.add_arrays(data, data.GetCellData(), **(cell_arrays or {}))
    return data


def show(source, view, radius=None, samples=1, **properties):
    """Shows a source as tubes."""
    if radius is not None:
        properties = {"TubeRadius": radius, **properties}
    return session.show(source, view, TUBES, samples, **properties)


def helix(count=1200):
    """Points of three turns."""
    angle = numpy.linspace(0.0, 6.0 * numpy.pi, count)
    return numpy.stack([numpy.cos(angle), numpy.linspace(-1.1, 1.1, count), numpy.sin(angle)], axis=1)


def rods():
    """Straight lines of three pieces in several directions."""
    return [numpy.outer([-1.0, -0.2, 0.5, 1.0], way) + middle
            for way, middle in (((1.2, 0.3, 0.1), (0, 0.9, 0)), ((0.9, -0.2, 0.5), (0, 0.1, 0)), ((0.1, 0.3, 1.3), (0.3, -0.8, 0)))]


def inside(mask, pixels=2):
    """The pixels of a mask that are so far from its edge."""
    for _ in range(pixels):
        padded = numpy.pad(mask, 1)
        mask = mask & padded[2:, 1:-1] & padded[:-2, 1:-1] & padded[1:-1, 2:] & padded[1:-1, :-2]
    return mask


def like_tube_filter(view, checks):
    """Same camera, lights and colors as the Tube filter with 64 sides and caps."""
    curve = helix()
    height = curve[:, 1].copy()
    wave = 1.0 + 0.5 * numpy.sin(numpy.linspace(0.0, 12.0, len(curve)))
    bundle = numpy.concatenate(rods())
    scenes = {
        "helix": (line_data([curve], height=height), {"TubeRadius": 0.15}, {"VaryRadius": "Off", "Radius": 0.15}, ("POINTS", "height")),
        "rods": (line_data(rods(), {"number": numpy.array([0.0, 1.0, 2.0])}), {"TubeRadius": 0.2}, {"VaryRadius": "Off", "Radius": 0.2},
                 ("CELLS", "number")),
        "values along rods": (line_data(rods(), value=bundle[:, 0] ** 2), {"TubeRadius": 0.2}, {"VaryRadius": "Off", "Radius": 0.2},
                              ("POINTS", "value")),
        "radii": (line_data([curve], thickness=0.12 * wave), {"TubeRadius": 1.0, "TubeRadiusArray": "thickness"},
                  {"VaryRadius": "By Absolute Scalar", "Scalars": ["POINTS", "thickness"]}, None),
    }
    stage, displays = session.Stage(view, TUBES), {}
    for name, (data, ours, theirs, colored) in scenes.items():
        shown = stage.show(data, TubeEnds="Flat", SamplesPerPixel=1, **ours)
        if not displays:
            tube = pv.Tube(Input=stage.source, NumberofSides=64, Capping=1)
            displays = {"ours": shown, "paraview": pv.Show(tube, view)}
        for key, value in theirs.items():
            setattr(tube, key, value)
        pictures = {}
        for who, shown in displays.items():
            for each in displays.values():
                each.Visibility = int(each is shown)
            if colored:
                pv.ColorBy(shown, colored)
                session.cool_to_warm(colored[1])
                pv.GetColorTransferFunction(colored[1]).RescaleTransferFunction(-1.1 if colored[1] == "height" else 0.0,
                                                                               {"height": 1.1, "number": 2.0, "value": 1.5}[colored[1]])
                shown.SetScalarBarVisibility(view, False)
            else:
                session.solid(shown, (0.8, 0.5, 0.2))
            session.look(view, (1.5, 1.0, 5.0))
            pictures[who] = session.capture(view, "tubes-%s-%s" % (name.replace(" ", "-"), who))
            if who == "ours":
                counted = session.statistics(shown)
                checks.true(name + ": no ray has been traced", counted["primaryRays"] > 0)
                # Of the helix some are left out at its flat ends, and others whose pieces are a tenth of the radius long.
                pieces = data.GetNumberOfPoints() - data.GetNumberOfLines()
                checks.within(name + ": pieces", counted["glyphs"], (0.45 if pieces > 100 else 0.9) * pieces, pieces)
        masks = {who: comparison.covered(picture) for who, picture in pictures.items()}
        outline = float((masks["ours"] != masks["paraview"]).mean())
        apart = numpy.abs(pictures["ours"].astype(int) - pictures["paraview"].astype(int))
        comparison.write_image(session.output("tubes-%s-difference.png" % name.replace(" ", "-")), 8 * apart)
        both = inside(masks["ours"] & masks["paraview"])
        print("%s: silhouettes differ on %.3f%% of the pixels, colors by %.3f levels in the mean, %d at most, over %d pixels"
              % (name, 100 * outline, apart[both].mean(), apart[both].max(), both.sum()))
        checks.within(name + ": fraction of the pixels that one covers alone", outline, 0.0, SILHOUETTE)
        checks.within(name + ": mean difference in levels", float(apart[both].mean()), 0.0, INTERIOR)
        # Where one turn hides another, outlines are inside, too.
        checks.within(name + ": fraction of the pixels inside that are of another color",
                      float((apart[both].max(axis=1) > comparison.LEVELS).mean()), 0.0, SILHOUETTE)
        checks.within(name + ": covered pixels", int(both.sum()), 3000, 10 ** 6)
    pv.Delete(displays["paraview"])
    pv.Delete(tube)
    stage.close()


def dense(view, checks):
    """A track of pieces that are much shorter than its radius costs what its outline costs, and looks like it."""
    curve = 100.0 * helix(12000)
    pictures, counted = [], []
    for points in (curve, curve[::25]):
        shown = show(session.source(line_data([points], height=points[:, 1])), view, radius=20.0)
        pv.ColorBy(shown, ("POINTS", "height"))
        session.look(view, (150.0, 100.0, 500.0))
        pictures.append(session.capture(view, "tubes-dense-%d" % len(points)))
        counted.append(session.statistics(shown))
        print("%d points: %d pieces, %.3f s" % (len(points), counted[-1]["glyphs"], counted[-1]["traceSeconds"]))
        pv.Delete(shown)
    checks.within("pieces of a dense track", counted[0]["glyphs"], 0.5 * counted[1]["glyphs"], 1.5 * counted[1]["glyphs"])
    checks.picture("a dense track", pictures[0], pictures[1], pixels=0.002, mean=1.0)
    # In one spot; time that grows with the square of the points would be hours.
    shown = show(session.source(line_data([numpy.linspace((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), 600000)])), view, radius=1.0)
    pv.Render(view)
    checks.within("pieces of a track in one spot", session.statistics(shown)["glyphs"], 1, 2)
    pv.Delete(shown)


def directions(view, checks):
    """In the window tubes that nothing colors have the colors of their directions, until that is switched off; scripts ask for it."""
    ways = numpy.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.6, 0.8]])
    lines = line_data([numpy.outer([-1.0, 0.2, 1.0], way) for way in ways])
    for in_window in (False, True):
        shown = pv.Show(session.source(lines), view)
        shown = stepwise(shown) if in_window else shown
        shown.SetRepresentationType(TUBES)
        shown.SamplesPerPixel, shown.TubeRadius, shown.Ambient, shown.Diffuse = 1, 0.1, 1.0, 0.0
        session.look(view, (4.0, 3.0, 6.0))
        pv.Render(view)
        checks.equal("GlyphDirectionColoring, in a window: %s" % in_window, shown.GlyphDirectionColoring, "Axes" if in_window else "None")
        for shown.GlyphDirectionColoring in ("Sphere", "Axes"):
            pixels = session.capture(view, "tubes-directions")
            for way in ways:
                x, y = session.pixel_of(view, 0.8 * way)
                checks.within("color along %s" % way, float(abs(pixels[::-1][y, x, :3] - levels(way, shown.GlyphDirectionColoring)).max()), 0.0, 1.0)
        shown.GlyphDirectionColoring = "None"
        checks.true("still colored by direction", (session.capture(view, "tubes-directions-off")[..., :3] != pixels[..., :3]).any())
        stepwise(shown, 0)
        pv.Delete(shown)
    for radii, wanted in (({"MaximumInscribedSphereRadius": numpy.full(9, 0.1)}, "MaximumInscribedSphereRadius"),
                          ({"pore.diameter": numpy.full(9, 0.1), "throat.diameter": numpy.full(9, 0.1)}, "None")):
        shown = stepwise(pv.Show(session.source(line_data([numpy.outer([-1.0, 0.2, 1.0], way) for way in ways], Curvature=numpy.ones(9), **radii)), view))
        shown.SetRepresentationType(TUBES)
        pv.Render(view)
        checks.equal("radius of tubes in a window", shown.SMProxy.GetProperty("TubeRadiusArray").GetElement(0), wanted)
        checks.true("the array's radius is not exact: %g" % shown.TubeRadius, wanted == "None" or shown.TubeRadius == 1.0)
        stepwise(shown, 0)
        pv.Delete(shown)


def picking(view, checks):
    """A pixel names the line cell and the nearer point of the data, which have other cells, too."""
    data = line_data([[(-1.5, 0.5, 0), (0, 0.5, 0), (1.5, 0.5, 0)], [(-1.5, -0.5, 0), (1.5, -0.5, 0)]])
    session.with_cells(data, "Verts", [[0]])
    shown = show(session.source(data), view, 0.2)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    pv.Render(view)
    for place, cell, point in (((-1.0, 0.5, 0.0), 1, 0), ((0.2, 0.6, 0.0), 1, 1), ((1.0, 0.4, 0.0), 1, 2), ((0.5, -0.5, 0.0), 2, 4)):
        at = session.pixel_of(view, place)
        for kind, wanted in (("CELL", cell), ("POINT", point)):
            found = [(what, number) for _, what, number in session.picked(view, kind, at)]
            checks.equal("picked at %s" % (place,), found, [(kind, wanted)])
    nothing = session.picked(view, "CELL", session.pixel_of(view, (0.0, 0.0, 0.0)))
    checks.equal("picked between the lines", nothing, [])
    pv.Delete(shown)


def translucent(view, checks):
    """A ray enters and leaves a poly-line once: its pieces leave no seams."""
    ways = {
        "straight": [(x, 0.0, 0.0) for x in (-1.6, -1.1, -0.3, -0.25, 0.6, 1.6)],
        "zigzag": [(-1.6, -0.7, 0.0), (-0.8, 0.7, 0.0), (0.0, -0.7, 0.0), (0.8, 0.7, 0.0), (1.6, -0.7, 0.0)],
        "arc": [(1.3 * numpy.cos(angle), 1.8 * numpy.sin(angle) - 0.8, 0.0) for angle in numpy.linspace(0.1, numpy.pi - 0.1, 60)],
    }
    half = numpy.array([0.5, 0.5, 0.5])
    background = numpy.array(session.BACKGROUND) / 255.0
    wanted = 255.0 * (0.75 * half + 0.25 * background)
    stage = session.Stage(view, TUBES)
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    for name, way in ways.items():
        for ends in ("Rounded", "Flat", "Covariances"):
            # Radii that change along the way
            radii = 0.25 + 0.03 * numpy.sin(2.0 * numpy.array(way)[:, 0])
            data = line_data([way], thickness=radii, squares=numpy.outer(radii ** 2, numpy.diag([1.0, 0.7, 0.5]).ravel()))
            form = {"TubeRadiusArray": "squares"} if ends == "Covariances" else {"TubeRadiusArray": "thickness", "TubeEnds": ends}
            shown = stage.show(data, TubeRadius=1.0, Opacity=0.5, SamplesPerPixel=1, **UNLIT, **form)
            session.solid(shown, half)
            pixels = session.capture(view, "tubes-translucent-%s-%s" % (name, ends.lower()))
            mask = inside(comparison.covered(pixels), 1)
            wrong = int((numpy.abs(pixels[mask][:, :3].astype(float) - wanted).max(axis=1) > 1.5).sum())
            print("translucent %s, %s: %d of %d pixels are not of two layers" % (name, ends, wrong, mask.sum()))
            checks.equal("translucent %s, %s: pixels that are not of two layers" % (name, ends), wrong, 0)
            checks.within("translucent %s, %s: pixels" % (name, ends), int(mask.sum()), 9000, 10 ** 6)
            # Rays that pass by chance meet the same layers: in the mean it is the same picture.
            if ends == "Rounded" and name == "zigzag":
                stage.settings.add({"ShadingMode": "Path Tracing", "SamplesPerPixel": 16, "Illumination": "Lights of the View"})
                level = float(session.capture(view, "tubes-translucent-by-chance")[..., 1][mask].mean())
                checks.within("translucent zigzag by chance: mean level", level, wanted[1] - 1.0, wanted[1] + 1.0)
    stage.close()


def outline(points, matrices, x, y):
    """How deep lines along z go into the ellipsoids that sweep a line (1: they touch), at each x, y: by many of them."""
    least = numpy.full(x.shape, numpy.inf)
    for first, last, a, b in zip(points, points[1:], matrices, matrices[1:]):
        for part in 0.5 - 0.5 * numpy.cos(numpy.linspace(0.0, numpy.pi, 801)):  # closer at the ends, which may be thin
            middle, matrix = first + part * (last - first), numpy.linalg.inv((a + part * (b - a))[:2, :2])
            dx, dy = x - middle[0], y - middle[1]
            least = numpy.minimum(least, matrix[0, 0] * dx * dx + 2.0 * matrix[0, 1] * dx * dy + matrix[1, 1] * dy * dy)
    return least


def covariances(view, checks):
    """Tensors sweep ellipsoids along the line: those of spheres are round tubes, others have the outline of their covariances."""
    points = numpy.array([(-1.5, -0.5, 0.3), (-0.6, 0.4, -0.2), (0.5, 0.5, 0.0), (1.4, -0.6, 0.4)])
    turns = [numpy.linalg.qr(numpy.random.default_rng(seed).normal(size=(3, 3)))[0] for seed in range(4)]
    diagonals = numpy.array([(1.0, 0.2, 0.05), (0.1, 1.0, 0.3), (0.02, 0.02, 1.0), (1.0, 0.0, 0.3)])
    matrices = numpy.array([turn @ numpy.diag(diagonal) @ turn.T for turn, diagonal in zip(turns, diagonals)])
    ball = numpy.tile(numpy.eye(3).ravel(), (4, 1))
    data = line_data([points], ball=ball, nine=matrices.reshape(4, 9), six=matrices[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]])
    stage, pictures = session.Stage(view, TUBES), {}
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    shown = stage.show(data, TubeRadius=0.3, SamplesPerPixel=1)
    for shown.Opacity in (0.5, 1.0):
        for array in ("None", "ball", "nine", "six"):
            shown.TubeRadiusArray, shown.TubeRadius = array, 0.3
            pictures[array] = session.capture(view, "tubes-covariances-%s-%g" % (array, shown.Opacity))
        checks.picture("covariances of spheres, opacity %g" % shown.Opacity, pictures["ball"], pictures["None"], pixels=0.0002, mean=0.2)
    checks.equal("pixels that six and nine components have otherwise", int((pictures["six"] != pictures["nine"]).any(axis=2).sum()), 0)
    rows, columns = pictures["nine"].shape[:2]
    y, x = numpy.mgrid[0:rows, 0:columns]
    depth = outline(points, 0.09 * matrices, (x + 0.5 - columns / 2.0) * 3.0 / rows, (rows / 2.0 - y - 0.5) * 3.0 / rows)
    sure = numpy.abs(depth - 1.0) > 2e-3
    wrong = int((comparison.covered(pictures["nine"]) != (depth < 1.0))[sure].sum())
    print("covariances: %d of %d pixels are wrong, %d next to the outline are not judged" % (wrong, sure.sum(), (~sure).sum()))
    checks.equal("covariances: wrong pixels", wrong, 0)
    checks.within("covariances: pixels not judged", int((~sure).sum()), 0, 200)
    checks.within("covariances: covered pixels", int((depth < 1.0).sum()), 9000, 10 ** 6)
    stage.close()


def blocks(view, checks):
    """Blocks have colors of their own; ghost lines, which another rank shows, and points that no line has are left out."""
    parts = vtkMultiBlockDataSet()
    for number in (0, 1):
        parts.SetBlock(number, line_data([[(-1.5, 0.6 - 1.2 * number, 0), (1.5, 0.6 - 1.2 * number, 0)]]))
    shown = show(session.source(parts), view, 0.3, **UNLIT)
    session.solid(shown, (1.0, 0.0, 0.0))
    shown.BlockColors = ["/Root/Block1", "0", "1", "0"]
    session.look(view, (0.0, 0.0, 5.0), parallel_scale=1.5)
    pixels = session.capture(view, "tubes-blocks")
    checks.equal("colors of blocks", [pixels[row, 200, :3].tolist() for row in (90, 210)], [[255, 0, 0], [0, 255, 0]])
    pv.Delete(shown)
    ways = [[(-1.5, 0.6 - 1.2 * number, 0), (1.5, 0.6 - 1.2 * number, 0)] for number in (0, 1)]
    ghosts = line_data(ways, {"vtkGhostType": numpy.array([0, 1], dtype=numpy.uint8)})
    shown = show(session.source(ghosts), view, 0.3)
    mask = comparison.covered(session.capture(view, "tubes-ghosts"))
    checks.equal("a line and a ghost line are seen", (bool(mask[90, 200]), bool(mask[210, 200])), (True, False))
    pv.Delete(shown)


def default_radius(view, checks):
    """A hundredth of the longest side; with an array the thickest tube has it; what is set stays; many lines are thinner."""
    data = line_data([[(-2.0, 0, 0), (0, 1, 0), (2.0, 0, 0)]], force=numpy.array([10.0, 500.0, 0.0]))
    shown = show(session.source(data), view)
    checks.within("TubeRadius", shown.TubeRadius, 0.04 - 1e-9, 0.04 + 1e-9)
    shown.TubeRadiusArray = "force"
    checks.within("TubeRadius with an array", shown.TubeRadius, 0.04 / 500.0 - 1e-9, 0.04 / 500.0 + 1e-9)
    shown.TubeRadius = 0.001
    shown.TubeRadiusArray = "None"
    checks.equal("TubeRadius that was set", shown.TubeRadius, 0.001)
    pv.Delete(shown)
    for pieces, wanted in ((39, 0.005), (1, 0.01)):  # 96 lines, or as many pieces
        ways = [[(10.0 * i / pieces, 0.01 * y, 0.0) for i in range(pieces + 1)] for y in range(96)]
        shown = show(session.source(line_data(ways)), view)
        checks.within("TubeRadius of lines of %d pieces" % pieces, shown.TubeRadius, 9.999 * wanted, 10.001 * wanted)
        pv.Delete(shown)


def bounds(view, checks):
    """Follow the radii of cells, also when only these change; what is infinite does not count."""
    data = line_data([[(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0)], [(-1.0, 1.0, 0.0), (1.0, 1.0, 0.0)]], {"thick": numpy.array([0.1, numpy.inf])})
    source = session.source(data)
    shown = show(source, view, 1.0, TubeRadiusArray="thick")
    thick = data.GetCellData().GetArray("thick")
    for radius in (0.1, 0.4, 0.2):
        thick.SetValue(0, radius)
        thick.Modified()
        data.Modified()
        source.GetClientSideObject().Modified()
        source.MarkModified(source)
        session.messages(lambda: pv.Render(view))
        found = view.GetRenderer().ComputeVisiblePropBounds()
        checks.within("bounds of a radius of %g" % radius, found[5], radius - 1e-6, 1.01 * radius)
    pv.Delete(shown)


def bad_input(view, checks):
    """One clear message each, and the rest is shown."""
    good = [(-1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]
    broken = [(-1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.5, numpy.nan, 0.0), (1.0, 0.0, 0.0)]
    polygons = vtkPolyData()
    sphere = pv.Sphere()
    sphere.UpdatePipeline()
    polygons.ShallowCopy(sphere.GetClientSideObject().GetOutputDataObject(0))
    radii = {"TubeRadiusArray": "radius"}
    cases = (
        # Between two messages that differ in numbers alone another case: these are not reported anew.
        ("one point", line_data([good, [(0.0, 1.0, 0.0)]]), {}, ("1 of 3 pieces",), True),
        ("repeated points", line_data([good[:1] * 2 + good[1:2] * 3 + good[2:]]), {}, (), True),
        ("nothing but repeated points", line_data([good, good[:1] * 3]), {}, ("1 of 3 pieces",), True),
        ("zero radius", line_data([good + [(2.0, 0.0, 0.0)]], radius=numpy.array([1.0, 1.0, 0.0, 0.0])), radii, (), True),
        ("NaN position", line_data([broken]), {}, ("2 of 3 pieces", "finite"), True),
        ("only zero radii", line_data([good], radius=numpy.zeros(3)), radii, ("radii are zero",), False),
        ("NaN radius", line_data([good], radius=numpy.array([1.0, 1.0, numpy.nan])), radii, ("1 of 2 pieces",), True),
        ("missing radii", line_data([good]), radii, ("'radius'", "TubeRadiusArray"), True),
        ("negative radius", line_data([good], radius=numpy.array([1.0, 1.0, -1.0])), radii, ("1 of 2 pieces", "negative"), True),
        ("only zero variances", line_data([good], radius=numpy.zeros((3, 9))), radii, ("radii are zero",), False),
        ("negative variance", line_data([good], radius=numpy.array([[1.0, 1.0, 1.0, 0.0, 0.0, 0.0]] * 2 + [[1.0, -1.0, 1.0, 0.0, 0.0, 0.0]])), radii,
         ("1 of 2 pieces", "covariance"), True),
        ("no lines", polygons, {}, ("no lines",), False),
        ("NaN variance", line_data([good], radius=numpy.array([[1.0] * 3 + [0.0] * 3] * 2 + [[numpy.nan] * 6])), radii, ("1 of 2 pieces",), True),
        ("no points", vtkPolyData(), {}, (), False),
        ("missing color", line_data([good]), {"ColorArrayName": ["POINTS", "nonesuch"]}, ("nonesuch",), True),
    )
    stage = session.Stage(view, TUBES)
    for name, data, properties, words, visible in cases:
        def twice():
            session.solid(stage.show(data, TubeRadius=0.2, SamplesPerPixel=1), (0.8, 0.5, 0.2))
            stage.settings.add(properties)
            stage.settings.add({"TubeRadius": 0.2})
            for distance in (5.0, 5.001):
                session.look(view, (0.0, 0.0, distance), parallel_scale=1.5)
                pv.Render(view)

        text = session.messages(twice)
        print("%s: %s" % (name, text.strip() or "no message"))
        if words:
            checks.one_message(name, text, *words)
        else:
            checks.no_message(name, text)
        pixels = session.capture(view, "tubes-bad-" + name.replace(" ", "-"))
        checks.equal(name + ": something is shown", bool(comparison.covered(pixels)[150, 150]), visible)
        stage.hide()
    stage.close()


def main():
    """All parts."""
    session.load()
    checks = Checks()
    view = session.view()
    for part in (like_tube_filter, dense, directions, picking, translucent, covariances, blocks, default_radius, bounds, bad_input):
        part(view, checks)
    checks.report()


if __name__ == "__main__":
    main()
