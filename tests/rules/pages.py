"""Fails where a page names a file that is not there: in a link, or in `code` that begins with a folder of the project or ends
like a source file. Run: pages.py ROOT"""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
CODE = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"(?:^|[\s(])((?:app|core|render|tests|assets|\.ci)/[\w./-]*\w)")
SOURCE = re.compile(r"(?<![\w*/])([\w/]+\.(?:h|cpp|py|cmake))\b")
OF_ANY_NAME = re.compile(r"[A-Z]{2}|\*")


def missing(page, text, root, names):
    for link in LINK.findall(text):
        if not (page.parent / link).exists():
            yield f"{page}: the link {link}"
    for code in CODE.findall(text):
        for path in PATH.findall(code):
            there = any((root / (path + ending)).exists() for ending in ("", ".h", ".cpp"))
            if not there and not OF_ANY_NAME.search(path):
                yield f"{page}: {path}"
        for source in SOURCE.findall(code):
            if not OF_ANY_NAME.search(source) and pathlib.Path(source).name not in names:
                yield f"{page}: {source}"


def catches(root):
    """A rule that lets everything pass would be none."""
    text = "[a](core/README.md), [b](core/none.md), `core/none/a.h` and `core/README.md`, `none.cpp`, `app/commands/NAME.cpp`"
    found = list(missing(root / "a.md", text, root, {"README.md"}))
    assert len(found) == 4, found


def main():
    root = pathlib.Path(sys.argv[1])
    catches(root)
    folders = ("app", "assets", "core", "render", "tests", ".ci")
    files = [path for folder in folders for path in (root / folder).rglob("*") if path.is_file()]
    names = {path.name for path in files}
    pages = list(root.glob("*.md")) + [path for path in files if path.suffix == ".md"]
    wrong = [line for page in pages for line in missing(page, page.read_text(encoding="utf-8"), root, names)]
    print("\n".join(wrong))
    return 1 if wrong or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
