"""Glyphs whose points choose their form from a table, against ParaView's 3D Glyphs with the same table.

Also: numbers outside the table, picking, colors, hiding, another table, bad input.
"""
import numpy
import paraview.simple as pv
from vtkmodules.vtkCommonCore import vtkCollection

import comparison
import session

COUNT = 60


def scene():
    """Points in a plane that choose by `form`, among them numbers outside a table of three and fractions."""
    generator = numpy.random.default_rng(3)
    x, y = numpy.meshgrid(numpy.arange(10), numpy.arange(6))
    points = numpy.stack([x.ravel() - 4.5, y.ravel() - 2.5, 0.0 * x.ravel()], axis=1)
    form = generator.integers(0, 3, COUNT).astype(float)
    form[:6] = [-1.0, 7.0, 1.9, 0.4, 2.0, 3.0]
    return session.source(session.poly_data(points, form=form, scalar=points[:, 0], vector=generator.normal(size=(COUNT, 3))))


def table():
    """A cone, a box and a cylinder, as one data set of three blocks."""
    return pv.GroupDatasets(Input=[pv.Cone(Resolution=64), pv.Box(XLength=0.6, YLength=0.9), pv.Cylinder(Resolution=64, Radius=0.2)])


def ours(points, view, forms):
    shown = session.glyphs(points, view, "Arrow", Orient=1, SelectOrientationVectors="vector", ScaleFactor=0.8)
    shown.GlyphType = forms
    shown.UseGlyphTable, shown.UseCompositeGlyphTable = 1, 1
    shown.GlyphTableIndexArray = "form"
    return shown


def theirs(points, view, forms):
    shown = pv.Show(points, view)
    shown.SetRepresentationType("3D Glyphs")
    shown.GlyphType = forms
    shown.Orient, shown.OrientationMode, shown.SelectOrientationVectors = 1, "Direction", "vector"
    shown.Scaling, shown.ScaleMode, shown.ScaleFactor = 1, "No Data Scaling Off", 0.8
    shown.UseGlyphTable = 1
    shown.GlyphTableIndexArray = "form"
    shown.UseCompositeGlyphTable = 1
    return shown


def color(shown, view, how):
    if how == "solid":
        session.solid(shown, (0.8, 0.5, 0.2))
    else:
        pv.ColorBy(shown, ("POINTS", "scalar"))
        shown.SetScalarBarVisibility(view, False)


def main():
    session.load()
    view = session.view()
    session.look(view, (1.0, 2.0, 14.0))
    failures = []
    points, forms = scene(), table()
    pictures = {}
    for who, show in (("paraview", theirs), ("ours", ours)):
        shown = show(points, view, forms)
        for how in ("solid", "table"):
            color(shown, view, how)
            pv.Render(view)
            pictures[who, how] = session.capture(view, "GlyphTable-%s-%s" % (how, who))
        if who == "paraview":
            pv.Hide(points, view)
            pv.Delete(shown)
    for how in ("solid", "table"):
        failures += comparison.against_paraview(pictures["ours", how], pictures["paraview", how], "GlyphTable-" + how)

    # Every glyph can be picked, whatever its form.
    pv.Render(view)
    representations, sources = vtkCollection(), vtkCollection()
    view.SMProxy.SelectSurfacePoints([0, 0, view.ViewSize[0] - 1, view.ViewSize[1] - 1], representations, sources, 0)
    selected = set()
    for i in range(sources.GetNumberOfItems()):
        selected.update(pv.servermanager._getPyProxy(sources.GetItemAsObject(i)).IDs[1::2])
    if selected != set(range(COUNT)):
        failures.append("picked %d of %d points: %s are missing" % (len(selected), COUNT, sorted(set(range(COUNT)) - selected)))

    # Hidden and shown again; one form less; none of the points chooses; no table at all.
    shown.Visibility = 0
    if comparison.covered(session.capture(view, "GlyphTable-hidden")).any():
        failures.append("hidden glyphs are there")
    shown.Visibility = 1
    again = session.capture(view, "GlyphTable-again")
    if (again != pictures["ours", "table"]).any():
        failures.append("shown again the picture differs")
    shown.UseCompositeGlyphTable = 0
    flat = comparison.covered(session.capture(view, "GlyphTable-off"))
    if (flat == comparison.covered(again)).all():
        failures.append("without table the forms are the same")
    shown.UseCompositeGlyphTable = 1
    two = pv.GroupDatasets(Input=[pv.Cone(Resolution=64), pv.Box(XLength=0.6, YLength=0.9)])
    shown.GlyphType = two
    session.capture(view, "GlyphTable-two")
    shown.GlyphType = forms
    if (session.capture(view, "GlyphTable-three") != again).any():
        failures.append("the first table again, the picture differs")

    # Bad input: one clear message each, and the other glyphs stay.
    shown.GlyphTableIndexArray = "None"
    session.capture(view, "GlyphTable-none")
    bad = session.source(session.poly_data([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [-2.0, 0.0, 0.0]], form=[0.0, float("nan"), 1.0]))
    pv.Hide(points, view)
    partly = pv.GroupDatasets(Input=[pv.Cone(), pv.PointSource(NumberOfPoints=3)])
    shown = ours(bad, view, partly)
    shown.Orient = 0
    told = session.messages(lambda: session.capture(view, "GlyphTable-bad"))
    for words in ("1 of 3 points have no glyph: the index of their mesh, from the point array 'form', is not finite",
                  "Entry 1 of GlyphType has no polygons"):
        if told.count(words) != 1:
            failures.append("'%s' was said %d times in:\n%s" % (words, told.count(words), told))
    if session.statistics(shown)["glyphs"] != 1:
        failures.append("%s glyphs where one is good" % session.statistics(shown)["glyphs"])
    shown.GlyphTableIndexArray = "nothing"
    told = session.messages(lambda: session.capture(view, "GlyphTable-missing"))
    if told.count("There is no point array 'nothing', which GlyphTableIndexArray names") != 1:
        failures.append("the missing array was not named once:\n" + told)
    session.finish(failures)


if __name__ == "__main__":
    main()
