"""Scenes at rest by seed, whose statics and their reasons must be the same seen otherwise: mirrored, turned, moved, in other units,
in another order."""
import copy
import dataclasses
import itertools
import math
import random

from case import Case
from gallery import scene

SAME = 1e-6  # of the weight, of a length of 1 m, of 1 rad


@dataclasses.dataclass
class View:
    name: str
    angle: float = 0.0
    side: float = 1.0  # -1: mirrored
    shift: tuple = (0.0, 0.0)
    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0
    order: int = 1  # -1: the last cube first

    def direction(self, v):
        c, s, x = math.cos(self.angle), math.sin(self.angle), self.side * v[0]
        return [c * x - s * v[1], s * x + c * v[1]]

    def place(self, p):
        return [self.length * d + s for d, s in zip(self.direction(p), self.shift)]

    def of(self, a_scene):
        seen = copy.deepcopy(a_scene)
        seen["gravity"] = [self.length / self.time**2 * g for g in self.direction(a_scene["gravity"])]
        for plane in seen["plane"]:
            plane |= {"point": self.place(plane.get("point", [0, 0])), "normal": self.direction(plane.get("normal", [0, 1]))}
        for cube in seen["cube"]:
            cube |= {"position": self.place(cube["position"]), "angle": self.angle, "size": [self.length * s for s in cube["size"]],
                     "mass": self.mass * cube["mass"]}
        for rod in seen["rod"]:
            rod |= {end: self.end(rod[end]) for end in ("from", "to")}
        for bodies in ("cube", "rod"):
            seen[bodies] = seen[bodies][::self.order]
        return seen

    def end(self, place):
        """A place in the world, or of a body, which turns with it."""
        if not isinstance(place, str):
            return self.place(place)
        body, dot, of_body = place.partition(".")
        return body + dot + (of_body.translate(str.maketrans("ew", "we")) if self.side < 0 else of_body)


VIEWS = (View("mirrored", side=-1), View("turned", angle=0.7), View("moved", shift=(7, -3)), View("in other order", order=-1),
         View("in other units", length=3.7, mass=0.14, time=1.9))


SIDES = {"": (0, 0), ".n": (0, 1), ".e": (1, 0), ".s": (0, -1), ".w": (-1, 0), ".ne": (1, 1), ".se": (1, -1), ".sw": (-1, -1), ".nw": (-1, 1)}


def some_rods(draw, cubes):
    """Up to three, from the middle, a side or a corner of a cube to that of another or to a place in the world."""
    def end(cube):
        side = draw.choice(list(SIDES))
        return cube["name"] + side, [p + s * d / 2 for p, s, d in zip(cube["position"], SIDES[side], cube["size"])]
    for k in range(draw.randint(1, 3)):
        one, other = draw.choice(cubes), draw.choice(cubes)
        in_world = [draw.uniform(-3, 5), draw.uniform(0, 5)]
        (start, here), (to, there) = end(one), end(other) if other is not one else (in_world, in_world)
        if math.dist(here, there) > 1e-6:
            yield {"name": f"r{k}", "from": start, "to": to}


def stack(draw, joined=False):
    """Up to four courses of bricks, flush with one another or not, on a floor and sometimes at a wall; ground tilted in half of them."""
    cubes, y = [], 0.0
    for _ in range(draw.randint(1, 4)):
        height, x = draw.choice([1.0, 0.5, draw.uniform(0.2, 2)]), draw.choice([0.0, 0.5, draw.uniform(-1, 1)])
        for _ in range(draw.randint(1, 3)):
            width = draw.choice([1.0, 2.0, draw.uniform(0.3, 3)])
            cubes.append({"name": f"b{len(cubes)}", "size": [width, height], "position": [x + width / 2, y + height / 2],
                          "mass": draw.choice([1.0, 10**draw.uniform(-1, 1)]), "friction": draw.choice([0, 0.3, 0.6, draw.random()])})
            x += width + draw.choice([0.0, 0.0, draw.uniform(0.01, 1)])
        y += height
    planes = [{"name": "floor"}] + ([{"name": "wall", "point": [-1, 0], "normal": [1, 0]}] if draw.random() < 0.3 else [])
    tilt = draw.choice([0, draw.uniform(-0.3, 0.3)])
    rods = list(some_rods(draw, cubes)) if joined else []
    return scene(cubes, planes=planes, rod=rods, gravity=[9.81 * math.sin(tilt), -9.81 * math.cos(tilt)], material={"friction": draw.choice([0.3, 0.6])})


def lengths(body, view):
    """Intervals along the ground, to the right as the first scene sees it, m there."""
    for key in ("shift", "move"):
        ends = [None if end is None else view.side * end / view.length for end in body[key]] if key in body else None
        yield key, ends[::int(view.side)] if ends else None


def back(view, p):
    """The place that `view` shows at p."""
    x, y = ((a - s) / view.length for a, s in zip(p, view.shift))
    c, s = math.cos(view.angle), math.sin(view.angle)
    return [view.side * (c * x + s * y) + 0.0, c * y - s * x + 0.0]


def back_force(view, force, unit):
    origin = dataclasses.replace(view, shift=(0, 0), length=1.0)
    return [f / unit for f in back(origin, force)]


def reasons(answer, view, unit):
    """Of `explain`, likewise."""
    yield "verdict", answer["verdict"]
    for cause in sorted(answer["causes"], key=lambda c: (sorted(c["part"]), sorted(c["on"]))):
        name = f"{sorted(cause['part'])} on {sorted(cause['on'])}"
        yield f"outside of {name}", cause["outside"] / view.length if cause["corner"] else name
        for x in back(view, cause["corner"]) if cause["corner"] else ():
            yield f"corner of {name}", x
    for fix in sorted(answer["fixes"], key=lambda f: (f["kind"], f["body"])):
        name = f"{fix['kind']} of {fix['body']}"
        yield name, fix["verified"]
        for x in back(view, fix["point"]):
            yield f"point of {name}", x
        yield f"distance of {name}", fix["distance"] and view.side * fix["distance"] / view.length
        for f in back_force(view, fix["force"], unit) if fix["force"] else ():
            yield f"force of {name}", f


def statics(answer, view, unit):
    """(name, number or None) of all that must be the same of `check`; forces in `unit`."""
    yield "verdict", answer["verdict"]
    yield "facts", str(answer.get("facts"))
    if answer["verdict"] != "stands":
        return
    for contact in sorted(answer["contacts"], key=lambda c: (sorted((c["on"], c["from"])), [round(x, 6) for x in back(view, c["point"])])):
        name = "-".join(sorted((contact["on"], contact["from"])))
        yield f"unique of {name}", contact["unique"]
        for key in ("force", "min", "max"):
            yield f"{key} of {name}", None if contact[key] is None else contact[key] / unit
    for rod in sorted(answer.get("rods", []), key=lambda r: r["name"]):
        yield f"unique of {rod['name']}", rod["unique"]
        for key in ("force", "min", "max"):
            yield f"{key} of {rod['name']}", None if rod.get(key) is None else rod[key] / unit
    for key, tilt in sorted((answer["margin"]["tilt"] or {}).items()):
        if isinstance(tilt, dict):
            left, right = (tilt["left"], tilt["right"])[::int(view.side)]
            yield f"tilt {key} left", left
            yield f"tilt {key} right", right
    for name, body in sorted(answer["margin"]["bodies"].items()):
        for key in ("load", "lift"):
            yield f"{key} of {name}", body[key] / unit if body.get(key) is not None else str(key in body)
        for key, ends in lengths(body, view):
            for end in ends or ["none"]:
                yield f"{key} of {name}", end


def differ(a, b):
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) > SAME * max(1.0, abs(a))
    return a != b


ASKED = {"check": (("--margin", "--ranges"), statics), "explain": ((), reasons)}


def same_as(answer, a_scene, view, numbers):
    weight = 9.81 * sum(c["mass"] for c in a_scene["cube"])

    def expect(seen):
        pairs = itertools.zip_longest(numbers(answer, View(""), weight), numbers(seen, view, weight * view.mass * view.length / view.time**2),
                                      fillvalue=("something", "nothing"))
        wrong = [f"{name} is {b} in place of {a}" for (name, a), (_, b) in pairs if differ(a, b)]
        return f"{view.name}: {wrong[0]}" if wrong else None
    return expect


def seen_otherwise(seed, joined=False, command="check"):
    arguments, numbers = ASKED[command]

    def look(views):
        def then(a_scene, answer):
            view, rest = views[0], views[1:]
            follow = (lambda _, __: look(rest)(a_scene, answer)) if rest else None
            return Case(view.of(a_scene), arguments, command, same_as(answer, a_scene, view, numbers), then=follow)
        return then
    name = "seen joined" if joined else "seen"
    return [Case(stack(random.Random(f"{name} {int(seed)}"), joined), arguments, command, then=look(VIEWS))]
