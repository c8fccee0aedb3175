"""ParaView's level of detail: few glyphs stand for many while the camera is turned, and in a window before many are built.

Usage: pvpython reduction.py
"""
import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet

import accumulation
import comparison
import session
from checks import Checks, information, refine, stepwise

COUNT = 60000
#: of the sums over all points; of what a picture covers
SUMS, COVERED = 1e-6, 0.04
#: of the spheres
SETTINGS = {"ScaleMode": "Magnitude", "ScaleFactor": 1.0, "Orient": 0, "SelectScaleArray": "size"}
NUMBERS = "vtkRayTraced_Reduced"
#: of the level of detail: cells along the cube's side, about 20 points in each
RESOLUTION = 0.055


def cloud():
    """Random points in a cube with sizes, vectors and tensors of mixed signs; as two blocks."""
    random = numpy.random.default_rng(7)
    places = random.uniform(-1.0, 1.0, (COUNT, 3))
    size = 2.0 * COUNT ** (-1.0 / 3.0)
    arrays = {"size": size * random.uniform(0.1, 0.5, COUNT), "kind": random.integers(0, 5, COUNT),
              "flow": size * (0.3 * numpy.stack([numpy.ones(COUNT), places[:, 0], -places[:, 2]], 1) + 0.05 * random.normal(size=(COUNT, 3))),
              "tensor": size * random.uniform(-0.2, 0.5, (COUNT, 6))}
    arrays["flow"][::1000] = numpy.nan
    data = vtkMultiBlockDataSet()
    data.SetNumberOfBlocks(2)
    for number, half in enumerate((slice(0, COUNT // 2), slice(COUNT // 2, COUNT))):
        data.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), "half%d" % number)
        data.SetBlock(number, session.poly_data(places[half], **{name: values[half] for name, values in arrays.items()}))
    return data, places, arrays


def reduced(shown, port=1):
    """What the last frame showed instead of the display's data, or (port 0) those."""
    return shown.SMProxy.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(port)


def blocks_of(shown, port):
    """Of each block of reduced() its point arrays, and its points as 'place'."""
    data = reduced(shown, port)
    found = []
    for number in range(data.GetNumberOfBlocks()):
        block = data.GetBlock(number)
        values = {block.GetPointData().GetArrayName(i): vtk_to_numpy(block.GetPointData().GetArray(i))
                  for i in range(block.GetPointData().GetNumberOfArrays())} if block.GetNumberOfPoints() else {}
        found.append({**values, "place": vtk_to_numpy(block.GetPoints().GetData())} if values else {})
    return found


def apart(found, wanted):
    """The largest difference of sums, as a fraction of the sum of magnitudes."""
    wanted = wanted[numpy.isfinite(wanted).reshape(len(wanted), -1).all(1)]
    return float(numpy.abs(found - wanted.sum(0)).max() / numpy.abs(wanted).sum())


def check_sums(checks, what, shown, arrays, name, areas):
    """Number times mean, and areas, summed over what is left."""
    left = blocks_of(shown, 1)
    numbers = numpy.concatenate([block[NUMBERS] for block in left])
    means = numpy.concatenate([block[name] for block in left])
    shows = numpy.isfinite(arrays[name]).reshape(COUNT, -1).all(1)
    error = apart((numbers[:, :1] * means.reshape(len(means), -1)).sum(0), arrays[name].reshape(COUNT, -1))
    area_error = abs(numbers[:, 1].sum() / areas[shows].sum() - 1.0)
    print("%s: %d points for %d; error of the sum of '%s' %.1e, of areas %.1e" % (what, len(numbers), COUNT, name, error, area_error))
    checks.within(what + ": points that are left", len(numbers), 100, COUNT // 4)
    checks.within(what + ": error of the sums", error, 0.0, SUMS)
    checks.within(what + ": error of the areas", area_error, 0.0, SUMS)
    checks.equal(what + ": points that they stand for", numbers[:, 0].sum(), shows.sum())
    for block, whole in zip(left, blocks_of(shown, 0)):
        own = block["vtkRayTraced_PointIds"]
        checks.true(what + ": ids are not those of the places", (whole["place"][own] == block["place"]).all())


def pictures(view, shown, what):
    """The first picture, as a window has it, and the finished one."""
    stepwise(shown)
    shown.ScaleFactor = 1.0001 * shown.ScaleFactor # builds anew
    pv.Render(view)
    waits = information(shown, "RefinementProgress") < 1.0
    first = accumulation.shown_by(view)
    done = refine(view, shown)
    last = accumulation.shown_by(view)
    for name, picture in (("%s-first" % what, first), (what, last)):
        comparison.write_image(session.output("reduction-%s.png" % name), picture)
    return first, last, waits and done


def set_detail(view, threshold):
    """ParaView's settings: size in MB above which it is used, and its resolution."""
    for name, value in (("LODThreshold", threshold), ("LODResolution", RESOLUTION)):
        view.SMProxy.GetProperty(name).SetElement(0, value)
    view.SMProxy.UpdateVTKObjects()


def main():
    """Spheres, arrows and tensors; then what holds of all of them."""
    session.load()
    checks = Checks()
    data, places, arrays = cloud()
    view = session.view(400, 400)
    session.look(view, (1.2, 0.9, 4.6))
    set_detail(view, 0.0)
    source = session.source(data)
    shown = session.glyphs(source, view, "Sphere", **SETTINGS)
    shown.SetScalarColoring("kind", pv.servermanager.GetAssociationFromString("POINTS"))
    length = numpy.linalg.norm(arrays["flow"], axis=1)
    arrow = (0.2 + 0.04 + 0.2) / 3.0 # of an arrow of length 1 the mean of the faces of its box
    for what, name, areas, properties in (
            ("spheres", "size", arrays["size"] ** 2, {}),
            ("arrows", "flow", arrow * length ** 2, {"Orient": 1, "SelectOrientationVectors": "flow", "SelectScaleArray": "flow"}),
            ("tensors", "tensor", None, {"GlyphTensorArray": "tensor", "Scaling": 0})):
        shape = {"spheres": "Sphere", "arrows": "Arrow", "tensors": "Tensor Ellipsoid"}[what]
        session.assign_shape(shown, shape)
        for key, value in properties.items():
            setattr(shown, key, value)
        shown.ScaleFactor = 1.0
        if areas is None:
            values = arrays["tensor"]
            matrices = values[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3)
            sides = numpy.abs(numpy.linalg.eigvalsh(matrices))
            sides = numpy.maximum(sides, 0.02 * sides.max(1)[:, None]) # flat glyphs have a thickness
            areas = (sides[:, 0] * sides[:, 1] + sides[:, 1] * sides[:, 2] + sides[:, 2] * sides[:, 0]) / 3.0
        pv.Render(view)
        view.SMProxy.InteractiveRender()
        check_sums(checks, what, shown, arrays, name, areas)
        first, last, in_two = pictures(view, shown, what)
        checks.true(what + ": the window has no first picture before the finished one", in_two)
        checks.true(what + ": the first picture shows all points", not numpy.array_equal(first, last))
        stepwise(shown, 0)
        # Finished pictures are the same with it and without.
        view.SMProxy.InteractiveRender()
        turned = session.capture(view, "reduction-with")
        set_detail(view, 1e6)
        checks.true(what + ": the finished picture depends on the level of detail", numpy.array_equal(turned, session.capture(view, "reduction-without")))
        checks.true(what + ": the window's last picture is another one", numpy.array_equal(turned, last))
        set_detail(view, 0.0)
        # What stands for all, as a display of its own: the inner part, because at the border glyphs reach half a cell further.
        view.SMProxy.InteractiveRender()
        fewer = session.source(reduced(shown))
        shown.Visibility = 0
        alone = session.glyphs(fewer, view, shape, **{**SETTINGS, **properties})
        seen = session.capture(view, "reduction-%s-reduced" % what)
        covered = [float(comparison.covered(picture[100:300, 100:300]).mean()) for picture in (seen, last)]
        print("%s: covered %.4f by few glyphs, %.4f by all" % (what, *covered))
        checks.within(what + ": covered area over that of all", covered[0] / covered[1], 1.0 - COVERED, 1.0 + COVERED)
        pv.Delete(alone)
        pv.Delete(fewer)
        shown.Visibility = 1

    # Turning and coming to rest sends nothing again; a click while it is turned selects a point that is there.
    counts = []
    for _ in range(5):
        view.SMProxy.InteractiveRender()
        pv.Render(view)
        counts.append(session.statistics(shown))
    for counter in ("instanceUploads", "instanceBuilds", "structureBuilds", "sorts"):
        checks.equal("turning: " + counter, counts[4][counter], counts[2][counter])
    center = (200, 200)
    wanted = session.picked(view, "POINT", center)
    view.SMProxy.InteractiveRender()
    checks.true("no glyph is in the middle of the picture", wanted)
    checks.equal("selected while turned", session.picked(view, "POINT", center), wanted)

    # A hidden block has nothing that stands for it, and what a mask chooses is shown itself.
    shown.BlockSelectors = ["/Root/half1"]
    pv.Render(view)
    view.SMProxy.InteractiveRender()
    checks.equal("reduced blocks where one is hidden", [NUMBERS in block for block in blocks_of(shown, 1)], [False, True])
    shown.GlyphMode = "Every Nth"
    pv.Render(view)
    view.SMProxy.InteractiveRender()
    checks.true("a mask's points are reduced", reduced(shown) is None)
    checks.report()


if __name__ == "__main__":
    main()
