"""Fails where a comment of core names a source, [Author, Author year], that core/README.md does not list, or where the list
has one that nobody names. Run: bibliography.py ROOT"""
import pathlib
import re
import sys

KEY = re.compile(r"\[([A-Z][^\[\]\n]*? (?:18|19|20)\d\d[a-z]?)(?:, [^\[\]\n]*)?\]")
ENTRY = re.compile(r"^- \[([^\[\]]+)\] ", re.MULTILINE)


def named(root):
    """Keys by the files that name them."""
    keys = {}
    for path in sorted(root.glob("core/**/*")):
        if path.suffix in (".h", ".cpp"):
            for key in KEY.findall(path.read_text(encoding="utf-8")):
                keys.setdefault(key, path.relative_to(root))
    return keys


def complaints(keys, listed):
    for key, path in keys.items():
        if key not in listed:
            yield f"{path}: [{key}] is not in the bibliography of core/README.md"
    for key in listed:
        if key not in keys:
            yield f"core/README.md: nobody names [{key}]"


def catches():
    """A rule that lets everything pass would be none."""
    found = KEY.findall("/// by a method [Moreau 1988], as in [Davis 2006, ch. 4] and [Rockafellar 1976a]; [1, 2]")
    assert found == ["Moreau 1988", "Davis 2006", "Rockafellar 1976a"], found
    assert len(list(complaints({"A 1999": "a.h"}, ["B 2000"]))) == 2


def main():
    catches()
    root = pathlib.Path(sys.argv[1])
    listed = ENTRY.findall((root / "core/README.md").read_text(encoding="utf-8"))
    wrong = list(complaints(named(root), listed))
    print("\n".join(wrong))
    return 1 if wrong or not listed else 0


if __name__ == "__main__":
    sys.exit(main())
