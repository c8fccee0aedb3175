"""The properties panel as its XML describes it: path tracing's material is in ParaView's group Lighting whatever Interpolation is, and with other
shading where ParaView has it; 3D Glyphs' properties are there for both kinds of glyphs where they have an effect, and Coloring where it says what is seen.
Rows are counted in the window (gui.py).

Usage: pvpython panel.py
"""
import paraview.simple as pv

import session
from checks import Checks

MATERIAL = ("Metallic", "Roughness", "CoatStrength", "CoatIOR", "CoatRoughness", "CoatColor")
#: some of those that have an effect on surfaces of polygons alone
OTHERS = {"PointSize", "LineWidth", "EdgeColor", "BackfaceOpacity", "SelectTangentArray", "SeamlessU", "Triangulate", "UseShaderReplacements", "CoordinateShiftScaleMethod"}
GROUPS, LIGHTING, GLYPHS = ("Ray Traced Image (Whole View)",), "Lighting", "Glyph Parameters"
#: what both kinds of glyphs have
SHARED = {"Orient", "OrientationMode", "SelectOrientationVectors", "Scaling", "ScaleMode", "ScaleFactor", "SelectScaleArray", "GlyphType",
          "UseGlyphTable", "GlyphTableIndexArray"}
#: rows that are there where they have an effect, and not elsewhere; settings add up
EFFECTS = [("GlyphScaleFunction", seen, settings) for seen, settings in (
    (True, {"GlyphShape": "Spherical Harmonics", "ScaleMode": "No Data Scaling Off"}), (False, {"GlyphShape": "None"}),
    (True, {"ScaleMode": "Magnitude"}), (True, {"GlyphShape": "Capsule"}), (False, {"ScaleMode": "No Data Scaling Off"}))] + [
    ("GlyphTensorAxis", True, {"GlyphShape": "Tensor Ellipsoid"}), ("GlyphTensorAxis", False, {"GlyphShape": "Capsule"}),
    ("AngularVelocityArray", True, {"MotionBlur": 1}), ("AngularVelocityArray", False, {"GlyphShape": "Principal Axes"}),
    ("PointIdArray", False, {}), ("PointIdArray", True, {"VelocityArray": "From Previous Step"}), ("PointIdArray", False, {"MotionBlur": 0}),
    ("AngularVelocityArray", False, {"MotionBlur": 1, "GlyphShape": "Capsule", "Representation": "Ray Traced Tubes"})]
ORIENTATION = {"Orient", "OrientationMode", "SelectOrientationVectors"}


def children(element, name):
    """The elements of that name in an XML element."""
    nested = [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())] if element else []
    return [child for child in nested if child.GetName() == name]


def value_of(proxy, name):
    """A property's value as text, of a source of glyphs its name."""
    value = proxy.GetProperty(name)
    if value and hasattr(value, "GetProxy"):
        return value.GetProxy(0).GetXMLName() if value.GetNumberOfProxies() and value.GetProxy(0) else ""
    return str(value.GetElement(0)) if value and hasattr(value, "GetElement") else ""


def holds(proxy, element):
    """Whether a decorator, an expression of decorators, shows what it decorates."""
    if element.GetName() == "Expression":
        parts = [holds(proxy, child) for name in ("PropertyWidgetDecorator", "Expression") for child in children(element, name)]
        return any(parts) if element.GetAttribute("type") == "or" else all(parts)
    if element.GetAttribute("type") == "CompositeDecorator":
        return all(holds(proxy, child) for child in children(element, "Expression"))
    if element.GetAttribute("type") != "GenericDecorator" or element.GetAttribute("mode") != "visibility":
        return True
    wanted = (element.GetAttribute("values") or "").split() or [element.GetAttribute("value")]
    shown = value_of(proxy, element.GetAttribute("property")) in wanted
    return shown != (element.GetAttribute("inverse") == "1")


def visible(proxy, hints):
    """Whether all decorators among an element's hints show it."""
    return all(holds(proxy, decorator) for decorator in children(hints, "PropertyWidgetDecorator"))


def panel(shown, label=None, advanced=True):
    """Names of a display's visible properties in the groups of that label, or in all. A property's last group is the one that shows it."""
    proxy, group_of, found = shown.SMProxy, {}, set()
    for i in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(i)
        for j in range(group.GetNumberOfProperties()):
            group_of[proxy.GetPropertyName(group.GetProperty(j))] = group
    for name, group in group_of.items():
        member = proxy.GetProperty(name)
        hidden = ("never",) if advanced or str(shown.Representation).strip("'").lower() == member.GetPanelVisibilityDefaultForRepresentation() \
            else ("never", "advanced")
        if label in (None, group.GetXMLLabel()) and "never" not in (group.GetPanelVisibility(), member.GetPanelVisibility()) \
                and member.GetPanelVisibility() not in hidden and visible(proxy, group.GetHints()) and visible(proxy, member.GetHints()):
            found.add(name)
    return found


def rows(checks, view):
    """What is seen of glyphs."""
    shown = session.glyphs(session.source(session.poly_data([[0.0] * 3, [1.0] * 3], v=[[1.0, 0.0, 0.0]] * 2)), view)
    for name, properties in (("sphere", {"GlyphType": "Sphere"}), ("arrow", {"GlyphType": "Arrow"}), ("tensor", {"GlyphShape": "Tensor Superquadric"})):
        for key, value in properties.items():
            setattr(shown, key, value)
        wanted = {"sphere": SHARED - ORIENTATION, "arrow": SHARED, "tensor": {"Scaling", "ScaleMode", "ScaleFactor", "SelectScaleArray"}}
        checks.equal(name + ": properties of 3D Glyphs", SHARED & panel(shown, GLYPHS), wanted[name])
    for coloring, seen in (("Trace", False), ("None", True)):
        shown.GlyphTensorColoring = coloring
        checks.equal("GlyphTensorColoring %s: ParaView's Coloring" % coloring, "LookupTable" in panel(shown, "Coloring"), seen)
    for name, seen, settings in EFFECTS:
        for key, value in settings.items():
            setattr(shown, key, value)
        checks.equal("%s beside %s" % (name, settings), name in panel(shown), seen)
    shown.SetRepresentationType("3D Glyphs")
    checks.equal("3D Glyphs' own properties", SHARED & panel(shown, GLYPHS), SHARED)
    shown.SetRepresentationType("Surface")
    checks.equal("3D Glyphs' properties of a surface", panel(shown, GLYPHS), set())
    pv.Delete(shown)


def main():
    """Glyphs, surfaces and tubes, in each shading mode, with each interpolation."""
    session.load()
    checks = Checks()
    view = session.view(80, 60)
    shown = pv.Show(pv.Sphere(), view)
    for kind in (session.REPRESENTATION, "Ray Traced Surface", "Ray Traced Tubes", "Surface"):
        shown.SetRepresentationType(kind)
        for mode in ("Path Tracing", "Local"):
            shown.ShadingMode = mode
            for interpolation in ("Flat", "Gouraud", "PBR"):
                shown.Interpolation = interpolation
                found = panel(shown, *GROUPS)
                what = "%s, %s, Interpolation %s: the panel has " % (kind, mode, interpolation)
                print(what + str(sorted(found)))
                ours, traced = kind != "Surface", kind != "Surface" and mode == "Path Tracing"
                checks.equal(what + "ShadingMode", "ShadingMode" in found, ours)
                checks.equal(what + "Illumination", "Illumination" in found, traced)
                checks.equal(what + "Statistics", panel(shown, "Statistics"), {"RenderStatistics"} if ours else set())
                checks.equal(what + "rows of other kinds of displays", panel(shown) & OTHERS, set() if ours else OTHERS)
                material = panel(shown, LIGHTING) & set(MATERIAL)
                checks.equal(what + "material", material, set(MATERIAL) if traced or interpolation == "PBR" else set())
    rows(checks, view)
    checks.report()


if __name__ == "__main__":
    main()
