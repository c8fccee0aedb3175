"""Coloring by vtkOriginalPointIds, which ExtractSelection gives its points, is that of any array in ParaView's 3D Glyphs.

Usage: pvpython original_ids.py
"""
import numpy
import paraview.simple as pv

import comparison
import session
from checks import Checks
from selection_through import expect

ARRAY = "vtkOriginalPointIds"


def extracted():
    """Some points of a cloud, with the numbers that they have there."""
    points = numpy.random.default_rng(5).uniform(-1.0, 1.0, (60, 3))
    source = session.source(session.poly_data(points, scalar=points[:, 0]))
    ids = [number for point in range(0, 60, 3) for number in (-1, point)]
    selection = pv.IDSelectionSource(FieldType="POINT", IDs=ids)
    return pv.ExtractSelection(Input=source, Selection=selection)


def main():
    """The same balls by ParaView's 3D Glyphs and as ray-traced glyphs, colored by their numbers."""
    session.load()
    checks = Checks()
    points = extracted()
    # 3D Glyphs of ParaView 6.1 replace an array of the very name by the numbers of the points that they show.
    copied = pv.Calculator(Input=points, Function=ARRAY, ResultArrayName="number")
    view = session.view(240, 180)
    pictures, said = {}, {}
    for kind in ("3D Glyphs", session.REPRESENTATION):
        data, array = (copied, "number") if kind == "3D Glyphs" else (points, ARRAY)
        shown = pv.Show(data, view)
        shown.SetRepresentationType(kind)
        if kind == "3D Glyphs":
            shown.GlyphType = "Sphere"
            shown.GlyphType.ThetaResolution = shown.GlyphType.PhiResolution = 64
            shown.GlyphType.Radius, shown.Scaling = 0.15, 0
        else:
            shown.Orient, shown.ScaleFactor, shown.SamplesPerPixel = 0, 0.3, 1
        pv.ColorBy(shown, ("POINTS", array))
        shown.SetScalarBarVisibility(view, False)
        pv.GetColorTransferFunction(array).RescaleTransferFunction(0.0, 60.0)
        session.look(view, (0.0, 0.0, 5.0))
        said[kind] = session.messages(lambda: pv.Render(view))
        pictures[kind] = session.capture(view, "original-ids-" + kind.split()[0].lower())
        if kind == session.REPRESENTATION:
            places = numpy.array(points.GetClientSideObject().GetOutputDataObject(0).GetPoints().GetData())
            nearest = int(places[:, 2].argmax())
            # What is selected are the numbers that the extracted points have themselves.
            expect(checks, "a click on the nearest glyph", view, "POINT", session.pixel_of(view, places[nearest]), points, nearest)
        pv.Delete(shown)
    print(said)
    colors = {tuple(color) for color in pictures["3D Glyphs"].reshape(-1, 3)[::7]}
    checks.true("ParaView's 3D Glyphs have one color", len(colors) > 20)
    checks.no_message("coloring by " + ARRAY, said[session.REPRESENTATION])
    checks.failures += comparison.against_paraview(pictures[session.REPRESENTATION], pictures["3D Glyphs"], "original-ids")
    checks.report()


if __name__ == "__main__":
    main()
