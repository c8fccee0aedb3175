"""Numbers that are none, and enumerations out of range: the view stays alive, and what does not change builds nothing.

Usage: pvpython extreme_values.py

A number that differs from itself would make glyphs, bounds or images anew at each render.
"""
import math

import numpy
import paraview.simple as pv

import session
from checks import Checks

#: many samples are slow, and images that grow step by step move their counters; after a coloring, ColorBy()'s too, ParaView touches the color table once more
LEFT_OUT = {"SamplesPerPixel", "SamplesPerRender", "ColorFromData"}
STATES = ({"shape": "Arrow", "ScaleMode": "Magnitude", "SelectScaleArray": "length"},
          {"shape": "Tensor Ellipsoid", "GlyphTensorArray": "tensor", "MotionBlur": 1, "VelocityArray": "vector"})


def counts(shown):
    """RenderStatistics of renders, without seconds."""
    return {name: value for name, value in session.statistics(shown).items() if "Seconds" not in name and name != "pulls"}


def scales(checks):
    """Lengths whose squares are no floats give a message, and no others, however far away something lies."""
    random = numpy.random.default_rng(2)
    places = random.uniform(-1.0, 1.0, (20, 3))
    for scale, outlier in ((1e-20, 0.0), (1e-12, 0.0), (1.0, 1e30), (1e15, 0.0), (1e21, 0.0)):
        points = scale * places
        points[0] += outlier
        source = session.source(session.with_cells(session.poly_data(points), "Lines", [range(20)]))
        for kind in ("Sphere", "Mesh", "Ray Traced Tubes", "Ray Traced Surface"):
            if outlier and "Ray" in kind:
                continue  # it is part of a line, or of a surface
            view = session.view(64, 48)
            shown = pv.Show(pv.Sphere(Radius=scale) if "Surface" in kind else source, view)
            shown.SetRepresentationType(kind if "Ray" in kind else session.REPRESENTATION)
            shown.SamplesPerPixel, shown.TubeRadius = 1, 0.05 * scale
            if "Ray" not in kind:
                shown.GlyphType, shown.ScaleFactor, shown.Orient = session.shaped(kind)["GlyphType"], 0.3 * scale, 0
            session.look(view, (0.0, 0.0, 5.0 * scale))
            text = session.messages(lambda: pv.Render(view))
            if 1e-16 < scale < 1e18:
                checks.no_message("%s, scale %g" % (kind, scale), text)
            else:
                checks.one_message("%s, scale %g" % (kind, scale), text, "largest size", "Transform")
            pv.Delete(view)


def main():
    """Each number and each choice of the representation, one at a time."""
    session.load()
    checks = Checks()
    random = numpy.random.default_rng(1)
    points = session.source(session.poly_data(random.uniform(-1.0, 1.0, (50, 3)), length=random.uniform(0.5, 2.0, 50),
                                              vector=random.normal(size=(50, 3)), tensor=random.normal(size=(50, 9))))
    tried = 0
    for state in STATES:
        view = session.view(32, 24)
        session.look(view, (0.0, 0.0, 5.0))
        shown = session.glyphs(points, view, **{"Orient": 0, "ScaleFactor": 0.2, **state})
        pv.Render(view)
        manager = pv.servermanager.ProxyManager().SMProxyManager
        prototypes = [manager.GetPrototypeProxy("representations", "RayTracedRepresentation"),
                      manager.GetPrototypeProxy("internal_representations", "RayTracedImage")]
        for name in sorted(shown.ListProperties()):
            inner = prototypes[0].GetProperty(name) or prototypes[1].GetProperty(name)
            if not inner or inner.GetInformationOnly() or name in LEFT_OUT:
                continue
            kind = inner.GetClassName()
            if "DoubleVectorProperty" in kind:
                values = [math.nan, math.inf]
            elif kind == "vtkSMIntVectorProperty" and inner.GetNumberOfElements() == 1:
                values = [-5, 1000]
            else:
                continue
            own = shown.SMProxy.GetProperty(name)
            before = [own.GetElement(i) for i in range(own.GetNumberOfElements())]
            for value in values:
                for i in range(len(before)):
                    own.SetElement(i, value)
                shown.SMProxy.UpdateVTKObjects()
                session.messages(lambda: pv.Render(view))
                first = counts(shown)
                session.messages(lambda: pv.Render(view))
                second = counts(shown)
                moved = {counter: (first[counter], second[counter]) for counter in first if first[counter] != second[counter]}
                checks.true("%s, %s = %s: a second render moves %s" % (state["shape"], name, value, moved), not moved)
                tried += 1
            for i, value in enumerate(before):
                own.SetElement(i, value)
            shown.SMProxy.UpdateVTKObjects()
        pixels = session.capture(view, "extreme-values")
        checks.covered(state["shape"] + ", all properties as they were", pixels, 0.02)
        pv.Delete(view)
    scales(checks)
    print(tried, "values")
    checks.true("only %d values were tried" % tried, tried > 150)
    checks.report()


if __name__ == "__main__":
    main()
