"""Each folder of Representation includes only itself and those before it in the table of Representation/README.md.

Usage: python3 folders.py
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2] / "Representation"
FOLDERS = re.findall(r"^\| (\w+) \|", (ROOT / "README.md").read_text(encoding="utf-8").split("## Folders")[1].split("##")[0], re.M)[1:]
SOURCES = [source for source in sorted(ROOT.glob("*/*")) if source.suffix in (".h", ".cxx")]
PLACE = {source.name: FOLDERS.index(source.parent.name) for source in SOURCES}
FAILURES = ["%s/%s includes %s of %s" % (source.parent.name, source.name, header, FOLDERS[PLACE[header]])
            for source in SOURCES for header in re.findall(r'#include "(\w+\.h)"', source.read_text(encoding="utf-8"))
            if PLACE.get(header, 0) > PLACE[source.name]]
print("%d sources in the folders %s" % (len(SOURCES), ", ".join(FOLDERS)))
sys.exit("\n".join(FAILURES) if FAILURES else 0)
