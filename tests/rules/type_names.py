"""Fails where two types of one namespace have one name: the linker would take the functions of one for the other's, and say nothing.
Types in unnamed namespaces are their file's own. Run: type_names.py ROOT"""
import pathlib
import re
import sys

NAMESPACE = re.compile(r"namespace (?:(\S+) )?\{")
END_OF_UNNAMED = re.compile(r"\}  // namespace$")
TYPE = re.compile(r"(?:struct|class|enum class) (?:\[\[\w+\]\] )?(\w+)(?: final)?(?: : .*)? ?\{")


def types(lines):
    namespace, own = "", False
    for line in lines:
        if found := NAMESPACE.match(line):
            own = found[1] is None
            namespace = found[1] or namespace
        elif END_OF_UNNAMED.match(line):
            own = False
        elif (found := TYPE.match(line)) and not own:
            yield f"{namespace}::{found[1]}"


def complaints(files):
    """`files`: pairs of a name and its lines."""
    first = {}
    for name, lines in files:
        for one in types(lines):
            if one in first:
                yield f"{name}: {one} is a type of {first[one]}, too"
            first.setdefault(one, name)


def catches():
    """A rule that lets everything pass would be none."""
    a = ["namespace wuerfel {", "namespace {", "struct Own {", "}  // namespace", "struct A {", "enum class B {", "struct C::Impl {"]
    b = ["namespace wuerfel {", "class Own {", "class A : public B {", "namespace wuerfel::other {", "struct B {", "struct A;"]
    assert list(complaints([("a.h", a), ("b.h", b)])) == ["b.h: wuerfel::A is a type of a.h, too"]


def main():
    catches()
    root = pathlib.Path(sys.argv[1])
    paths = [p for folder in ("core", "render", "app") for p in sorted((root / folder).rglob("*")) if p.suffix in (".h", ".cpp")]
    found = list(complaints((p.relative_to(root), p.read_text(encoding="utf-8").splitlines()) for p in paths))
    print("\n".join(found) or f"{len(paths)} files: every type has a name of its own")
    sys.exit(1 if found else 0)


main()
