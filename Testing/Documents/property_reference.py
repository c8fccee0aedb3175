"""Writes Representation/PROPERTIES.md from the XML that the panel's tool tips and the plugin's help page show.

Usage: python3 property_reference.py [--check]
Without --check the program writes the file. With it the program fails where the file differs from the XML, or where a
property has more than three sentences.
"""
import difflib
import os
import re
import sys
import xml.etree.ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
FOLDER = os.path.join(ROOT, "Representation", "ServerManager")
DOCUMENT = os.path.join(ROOT, "Representation", "PROPERTIES.md")
SENTENCES = 3
HEAD = """<!-- Written by Testing/Documents/property_reference.py from the XML in ServerManager. -->
# Properties

Ray Traced Glyphs, Ray Traced Surface and Ray Traced Tubes have all properties of ParaView's Surface, with the same values, and those below.
The panel shows the same texts as tool tips, but for rows of 3D Glyphs such as Scale Factor, which have ParaView's; the toolbar's button *?* opens them as a page. [README.md](README.md) has the shapes, formulas and orders of components."""


def definitions(name):
    """(properties by name, groups of names) of one XML file, in its order."""
    root = xml.etree.ElementTree.parse(os.path.join(FOLDER, name)).getroot()
    properties = {}
    for proxy in root.iter():
        if proxy.tag.endswith("RepresentationProxy") or proxy.get("name") == "RayTracedImage":
            for entry in proxy:
                if entry.tag.endswith("Property") and entry.get("name"):
                    properties.setdefault(entry.get("name"), entry)
    groups = {}  # those of one label are one; shared ones stand in the extension itself
    for holder in list(root.iter("ExposedProperties")) + list(root.iter("Extension")):
        for group in holder.findall("PropertyGroup"):
            title = next((hint.get("title") for hint in group.iter("RayTraced") if hint.get("title")), group.get("label"))
            groups.setdefault(title, []).extend((entry.get("name"), entry.get("exposed_name")) for entry in group if entry.tag == "Property")
    return properties, list(groups.items())


def properties():
    """Those of ray-traced displays by name, and those of the view's image."""
    return tuple(definitions("RayTraced%s.xml" % name)[0] for name in ("Glyphs", "Image"))


def contents():
    """Names of properties -> the representations that the panel shows them for; the others are for all."""
    root = xml.etree.ElementTree.parse(os.path.join(FOLDER, "RayTracedGlyphs.xml")).getroot()
    shown = {}
    for group in root.iter("PropertyGroup"):
        of_group = {hint.get("value") for hint in group.iter("PropertyWidgetDecorator") if hint.get("property") == "Representation"}
        for entry in group.findall("Property") if of_group else ():
            shown[entry.get("name")] = of_group
    for name, entry in properties()[0].items():
        own = {hint.get("value") for hint in entry.findall("Hints/PropertyWidgetDecorator") if hint.get("property") == "Representation" and hint.get("value")}
        if own:
            shown[name] = own
    return shown


def words(entry):
    """What ParaView shows in the tool tip, and the rest, which stands on the help page."""
    documentation = entry.find("Documentation")
    texts = ("", "") if documentation is None else (documentation.text or "", documentation.get("long_help", ""))
    return re.sub(r"\s+", " ", " ".join(texts)).strip()


def values(entry):
    """What the property can be, as its documentation says, else its domains, which are the sliders' ends."""
    stated = re.search(r"\b[Ii]n (\[[^\]]*\])", words(entry))
    for domain in entry:
        if domain.find("Entry") is not None:
            return ", ".join(item.get("text") for item in domain.iter("Entry"))
        if domain.tag == "BooleanDomain":
            return "0, 1"
        if domain.tag in ("ArrayListDomain", "RayTracedArrayListDomain", "RepresentedArrayListDomain"):
            return "an array"
        if domain.tag in ("ProxyGroupDomain", "ProxyListDomain"):
            return "a proxy"
        if domain.tag in ("DoubleRangeDomain", "IntRangeDomain"):
            least, most = domain.get("min"), domain.get("max")
            least, most = (least or "").split(" ")[0], (most or "").split(" ")[0]
            if stated:
                return stated.group(1)
            if least and most:
                return "[%s, %s]" % (least, most)
            if least:
                return "%s and more" % least
    kinds = {"InputProperty": "a source", "Property": "*command*"}
    return kinds.get(entry.tag, "text" if entry.tag.endswith("StringVectorProperty") else "numbers")


def default(entry):
    """The value without data, or what the data give; what the client chooses for a display stands in the texts only."""
    if re.search(r"\b[Dd]efault on\b", words(entry)):
        return "1"
    if entry.get("default_values") == "None":
        return "None"
    if re.search(r"\bBy default \w+FromData finds", words(entry), re.IGNORECASE):
        return "from the data"
    for domain in entry:
        if domain.tag in ("ArrayListDomain", "RayTracedArrayListDomain", "RepresentedArrayListDomain",
                          "RayTracedRadiusDomain"):
            return "from the data"
        if domain.find("Entry") is not None:
            return next((item.get("text") for item in domain.iter("Entry") if item.get("value") == entry.get("default_values")), "")
    given = entry.get("default_values")
    return "" if given in (None, "none") else given


def row(name, entry):
    """One line of the table."""
    text = words(entry)
    if not text:
        raise SystemExit("property_reference.py: %s has no Documentation" % name)
    if entry.get("information_only") == "1":
        return "| %s | *information* | | %s |" % (name, text.replace("|", "\\|"))
    return "| %s | %s | %s | %s |" % (name, values(entry), default(entry), text.replace("|", "\\|"))


def sections():
    """(title, [(name that scripts know, XML element)]): the panel's groups in their order, then the rest."""
    displays, image = properties()
    known = {**displays, **image}
    groups = definitions("RayTracedGlyphs.xml")[1] + definitions("RayTracedImage.xml")[1]
    grouped = {name for _, names in groups for name, _ in names}
    information = [name for name, entry in known.items() if entry.get("information_only") == "1" and name not in grouped]
    rest = [name for name, entry in known.items()
            if name not in grouped and name not in information and entry.get("is_internal") != "1" and name != "Input"]
    groups = groups + [("Information", [(name, None) for name in information]), ("Selection", [(name, None) for name in rest])]
    return [(title, [(exposed or name, known[name]) for name, exposed in names]) for title, names in groups]


def table():
    """The whole file."""
    lines = [HEAD]
    for title, entries in sections():
        lines.extend(["", "## " + title, "", "| property | values | default | meaning |", "|---|---|---|---|"])
        lines.extend(row(name, entry) for name, entry in entries)
    return "\n".join(lines) + "\n"


def too_long():
    """Properties whose texts have more than three sentences."""
    return [name for _, entries in sections() for name, entry in entries if len(re.split(r"(?<=[.!?]) (?=[A-Z])", words(entry))) > SENTENCES]


def main():
    """Writes or checks."""
    new = table()
    if "--check" not in sys.argv[1:]:
        with open(DOCUMENT, "w", encoding="utf-8") as stream:
            stream.write(new)
        return
    with open(DOCUMENT, encoding="utf-8") as stream:
        old = stream.read()
    sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), new.splitlines(True), "PROPERTIES.md", "as the XML has it"))
    if new != old:
        raise SystemExit("Representation/PROPERTIES.md differs from the XML; run Testing/Documents/property_reference.py")
    if too_long():
        raise SystemExit("more than %d sentences: %s" % (SENTENCES, ", ".join(too_long())))


if __name__ == "__main__":
    main()
