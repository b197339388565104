"""Fails where a file of core/time has neither a test of its name at the same place of tests/unit nor is named in the first
line of another's test ("also shown_joints.cpp"). Run: mirror.py ROOT"""
import pathlib
import re
import sys


def untested(sources, first_lines):
    """`sources`: below core; `first_lines` of tests by their paths below tests/unit."""
    named = {name for line in first_lines.values() for name in re.findall(r"\w+\.cpp", line)}
    for source in sources:
        test = source.removesuffix(".cpp") + "_test.cpp"
        if test not in first_lines and source.rsplit("/", 1)[-1] not in named:
            yield source


def catches():
    """A rule that lets everything pass would be none."""
    lines = {"time/a_test.cpp": "// A, also b.cpp", "time/x/d_test.cpp": "// D"}
    assert list(untested(["time/a.cpp", "time/b.cpp", "time/c.cpp", "time/d.cpp"], lines)) == ["time/c.cpp", "time/d.cpp"]


def main():
    catches()
    root = pathlib.Path(sys.argv[1])
    tests = {path.relative_to(root / "tests/unit").as_posix(): path.read_text(encoding="utf-8").split("\n", 1)[0]
             for path in root.glob("tests/unit/time/**/*_test.cpp")}
    sources = sorted(path.relative_to(root / "core").as_posix() for path in root.glob("core/time/**/*.cpp"))
    missing = list(untested(sources, tests))
    for source in missing:
        print(f"core/{source}: no test of its name, and no other test says that it is one of it")
    return 1 if missing or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
