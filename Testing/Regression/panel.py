"""The properties panel as its XML describes it: path tracing's material is in the group of ray tracing whatever
Interpolation is, and nowhere with other shading.

Usage: pvpython panel.py
"""
import paraview.simple as pv

import session
from checks import Checks

MATERIAL = ("Metallic", "Roughness", "CoatStrength", "CoatIOR", "CoatRoughness", "CoatColor")
GROUPS = ("Ray Traced Image", "Ray Traced Material")


def children(element, name):
    """The elements of that name in an XML element."""
    nested = [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())] if element else []
    return [child for child in nested if child.GetName() == name]


def value_of(proxy, name):
    """A property's value as text."""
    value = proxy.GetProperty(name)
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


def panel(shown):
    """Names of a display's visible properties in the groups."""
    proxy, found = shown.SMProxy, set()
    for i in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(i)
        for j in range(group.GetNumberOfProperties()):
            member = group.GetProperty(j)
            if group.GetXMLLabel() in GROUPS and "never" not in (group.GetPanelVisibility(), member.GetPanelVisibility()) \
                    and visible(proxy, group.GetHints()) and visible(proxy, member.GetHints()):
                found.add(proxy.GetPropertyName(member))
    return found


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
                found = panel(shown)
                what = "%s, %s, Interpolation %s: the panel has " % (kind, mode, interpolation)
                print(what + str(sorted(found)))
                ours, traced = kind != "Surface", kind != "Surface" and mode == "Path Tracing"
                checks.equal(what + "ShadingMode", "ShadingMode" in found, ours)
                checks.equal(what + "MaximumBounces", "MaximumBounces" in found, traced)
                # They may have names of their own, such as PathMetallic.
                material = [name for name in MATERIAL if any(other.endswith(name) for other in found)]
                checks.equal(what + "material", material, list(MATERIAL) if traced else [])
    checks.report()


if __name__ == "__main__":
    main()
