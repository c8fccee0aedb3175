"""Every link in the project's documents leads to a file that is there, and to a heading that is in it; every test that
a table names in a column 'test' is one.

Usage: python3 links.py
"""
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def anchors(path):
    """The headings of a document as links name them."""
    with open(path, encoding="utf-8") as stream:
        headings = re.findall(r"^#+ (.*)$", stream.read(), re.M)
    return {re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", "-") for heading in headings}


def documents():
    """All of them; what git ignores is not the project's."""
    listed = []
    if shutil.which("git"):
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "*.md"], stdout=subprocess.PIPE, check=False, text=True).stdout.split()
    return listed or [os.path.relpath(os.path.join(folder, name), ROOT) for folder, _, names in os.walk(ROOT)
                      for name in names if name.endswith(".md") and "/build" not in folder]


def tests():
    """Every word of the files that define tests."""
    words = set()
    for folder, _, names in os.walk(os.path.join(ROOT, "Testing")):
        for name in names:
            if name == "CMakeLists.txt" or name.endswith(".cmake"):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    words.update(re.findall(r"[\w-]+", stream.read()))
    return words


def named_tests(text):
    """What the last columns of tables name where they are headed 'test'."""
    named = []
    for table in re.findall(r"^\|.*\| test \|\n\|[-|]+\|\n((?:\|.*\|\n)+)", text, re.M):
        for row in table.splitlines():
            named += [name.strip() for name in row.rstrip("|").split("|")[-1].split(",")]
    return named


def main():
    """Lists what leads nowhere."""
    failures, links, known = [], 0, tests()
    for document in documents():
        path = os.path.join(ROOT, document)
        with open(path, encoding="utf-8") as stream:
            text = re.sub(r"^    .*$|`[^`]*`", "", stream.read(), flags=re.M)
        failures += ["%s: no test %s" % (document, name) for name in named_tests(text) if name not in known]
        for target in re.findall(r"\]\(([^)]+)\)", text):
            if "://" in target:
                continue
            links += 1
            name, _, anchor = target.partition("#")
            found = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
            if not os.path.exists(found):
                failures.append("%s: no %s" % (document, name))
            elif anchor and anchor not in anchors(found):
                failures.append("%s: no heading #%s in %s" % (document, anchor, name or document))
    print("%d links" % links)
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures or not links else 0


if __name__ == "__main__":
    sys.exit(main())
