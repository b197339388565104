"""What is swept: each family has one number that grows harder, and cases that must hold for it."""
import dataclasses
import math

from case import OVER_BUDGET, Case, Outcome
from gallery import cube, gallery, scene
from random_scenes import random_scene
from rubbing import bounces, friction, momentum, random_events, random_joined, random_rubbing, random_standing, seams
from laws import random_laws
from seen_otherwise import seen_otherwise

EPS = 2.0**-52
GRAVITY = 9.81


@dataclasses.dataclass
class Family:
    name: str
    quantity: str  # what grows, with its unit
    short: list
    long: list
    cases: object  # value -> list of cases
    holds_to: float = None  # the last value of the sweep that is known to hold; None: all of the short form
    known: tuple = ()  # labels of a collection's scenes that are known not to hold
    patience: float = 1  # times the time limit
    collection: bool = False  # the values are scenes, not a quantity: none is harder than the next


def powers(first, last, step=1):
    return [float(f"1e{k}") for k in range(first, last + (1 if last > first else -1), step if last > first else -step)]


def verdict(wanted):
    return lambda answer: None if answer["verdict"] == wanted else f"verdict {answer['verdict']} in place of {wanted}"


def falls_if_it_counts(answer):
    """Accelerations up to 1e-10 g count as none, by definition: a status, not a fault."""
    largest = max(math.hypot(a["ax"], a["ay"]) + abs(a["alpha"]) for a in answer["accelerations"].values())
    if answer["verdict"] == "stands" and largest <= 1e-10 * GRAVITY:
        return Outcome(OVER_BUDGET, "counts as standing: accelerates by 1e-10 g at most")
    return verdict("falls")(answer)


def stays(answer):
    moved = answer["outcome"]["moved"]
    if moved:
        return f"{len(moved)} bodies moved, though all stand"
    return None if answer["outcome"]["at_rest"] else "nothing moved, but it does not count as at rest"


def carries(weight):
    """The floor carries the weight of all, and the scene stands."""
    def expect(answer):
        if answer["verdict"] != "stands":
            return f"verdict {answer['verdict']} in place of stands"
        lift = sum(c["force"] for c in answer["contacts"] if "floor" in (c["on"], c["from"]))
        return None if abs(lift - weight) <= 1e-9 * weight else f"the floor carries {lift:.17g} N in place of {weight:.17g} N"
    return expect


def standing(a_scene, weight):
    return [Case(a_scene, command="check", expect=carries(weight)), Case({**a_scene, "duration": 1.0}, expect=stays)]


def final(body, *keys):
    """State of a body at the end."""
    return lambda answer: [answer["samples"][-1]["bodies"][body][key] for key in keys]


# --- towers
def tower_height(count):
    return standing({"version": 1, "plane": [{"name": "floor"}], "tower": [{"count": int(count), "base": [0, 0]}]}, count * GRAVITY)


def falling_tower(count):
    """Every cube a little more over the edge than a tower of this height bears."""
    lean = 1.5 / count
    return [Case({"version": 1, "duration": 0.5, "plane": [{"name": "floor"}], "tower": [{"count": int(count), "base": [0, 0], "lean": lean}]})]


def knife_edge(distance):
    """A tower of ten leans by 1/10 per cube when it is about to fall."""
    def lean(factor):
        return {"version": 1, "plane": [{"name": "floor"}], "tower": [{"count": 10, "base": [0, 0], "lean": 0.1 * factor}]}
    return [Case(lean(1 - distance), command="check", expect=verdict("stands")),
            Case(lean(1 + distance), command="check", expect=falls_if_it_counts)]


# --- ratios
def mass_ratio(ratio):
    cases = []
    for masses in ((1.0, ratio), (ratio, 1.0), (1.0, ratio, 1.0, ratio, 1.0, ratio), (ratio, 1.0, 1.0, 1.0, ratio)):
        cubes = [cube(f"c{i}", 0, 0.5 + i, mass=m) for i, m in enumerate(masses)]
        cases += standing(scene(cubes), sum(masses) * GRAVITY)
    for low, high in ((1.0, ratio), (ratio, 1.0)):
        cases.append(Case(scene([cube("low", 0, 0.5, mass=low), cube("high", 0.3, 2.5, mass=high, angle=0.2)], 1.0)))
    return cases


def size_ratio(ratio):
    small = 1 / ratio
    on_large = [cube("large", 0, 0.5), {"name": "small", "size": small, "on": "large"}]
    on_small = [{"name": "small", "size": small, "on": "floor"}, {"name": "large", "on": "small"}]
    drops = [Case(scene([cube("large", 0, 0.5), cube("small", 0.1, 1 + 2 * small, size=small, angle=angle)], 4 * math.sqrt(small)))
             for angle in (0.0, 0.3, 0.7)]
    return standing(scene(on_large), 2 * GRAVITY) + standing(scene(on_small), 2 * GRAVITY) + drops


# --- settings
def tumble(x=0.0, y=0.0):
    """A tower that leans and falls on a block, and a tilted drop."""
    cubes = [cube(f"c{i}", x + 0.375 * i, y + 0.5 + i) for i in range(3)] + [cube("drop", x + 3, y + 2, angle=0.25)]
    return scene(cubes, 0.9, planes=({"name": "floor", "point": [x, y]},))


def step(dt):
    """At most 100 000 steps; large steps gain and lose energy by their truncation, which is no fault of theirs."""
    end = min(0.9, 1e5 * dt)
    return [Case({**tumble(), "duration": end}, ("--integrator", name, "--step", repr(dt)), drift=0.1) for name in ("rattle", "moreau")]


class Against:
    """Compares the end of a run with that of another."""
    def __init__(self, reference, allowed, shift=(0.0, 0.0)):
        self.reference, self.allowed, self.shift = reference, allowed, shift

    def __call__(self, answer):
        worst = 0.0
        for name, state in self.reference.items():
            body = answer["samples"][-1]["bodies"][name]
            worst = max(worst, abs(body["x"] - self.shift[0] - state["x"]), abs(body["y"] - self.shift[1] - state["y"]))
        return None if worst <= self.allowed else f"{worst:.2g} m away from where it must be, allowed are {self.allowed:.2g} m"


def tolerance_family(reference):
    """The error of the end may be a hundred times the tolerance: it is a budget per unit of time and scale."""
    return lambda value: [Case(tumble(), ("--tolerance", repr(value)), drift=max(1e-6, 100 * value),
                               expect=Against(reference, 100 * max(value, 1e-12)))]


def distance_family(reference):
    return lambda d: [Case(tumble(d, d), energy=100.0, expect=Against(reference, max(1e-6, 1e3 * EPS * d), (d, d))),
                      Case({**scene([cube(f"c{i}", d, d + 0.5 + i) for i in range(5)], planes=({"name": "floor", "point": [d, d]},)), "duration": 1.0},
                           energy=100.0, expect=stays)]


# --- velocities
def spin(omega):
    low = cube("low", 0, 0.5)
    return [Case(scene([cube("a", 0, 2, spin=omega)], 1.0)), Case(scene([low, cube("a", 0.9, 2.3, spin=-omega)], 1.0)),
            Case(scene([cube("a", 0, 0.5, spin=omega)], 1.0)), Case(scene([cube("a", 0, 0, spin=omega), cube("b", 1.2, 0)], 1.0, planes=(), gravity=[0, 0]))]


def speed(v):
    """A bullet against a wall of a fifth of its size: fixed, free and heavy; and a stack."""
    bullet = cube("bullet", 0, 0, size=0.1, velocity=[v, 0])
    end = 10 / v
    space = {"gravity": [0, 0], "planes": ()}

    def held(wall):
        def expect(answer):
            x = final("bullet", "x")(answer)[0]
            at = 5.0 if wall is None else final(wall, "x")(answer)[0]
            return None if x <= at - 0.06 + 1e-9 else f"the bullet is {x - at + 0.06:.2g} m inside or behind the wall"
        return expect
    return [Case(scene([bullet], end, fixed=[{"name": "wall", "size": [0.02, 5], "position": [5, 0]}], **space), expect=held(None)),
            Case(scene([bullet, cube("wall", 5, 0, size=[0.02, 5], mass=1000)], end, **space), expect=held("wall")),
            Case(scene([bullet, cube("a", 5, 0.2), cube("b", 6.5, -0.3, angle=0.3)], end, **space)),
            Case(scene([cube("bullet", -5, 1.7, size=0.5, velocity=[v, 0])] + [cube(f"c{i}", 0, 0.5 + i) for i in range(4)], 5 / v + 0.3))]


# --- crowds
def pile(count):
    width = 2 * math.ceil(math.sqrt(count))
    height = 2.5 * count / width + 3
    walls = [{"name": n, "size": [1, 2 * height], "position": [s * (width / 2 + 0.5), height]} for n, s in (("left", -1), ("right", 1))]
    return [Case({"version": 1, "duration": 1.0, "plane": [{"name": "floor"}], "fixed": walls,
                  "pile": [{"count": int(count), "size": 1, "seed": 3, "region": [-width / 2 + 0.01, 0.01, width / 2 - 0.01, height]}]})]


# What bodies that lie flush, or corner on corner, have done to each other: more than touching, by a little in each event.
OVERLAPPED_ONCE = [2249, 2947, 5579, 8423, 8669]
# Scenes that gained or lost energy for no reason, that were wedged for none, or took more than half a minute.
BROKEN_ONCE = [203410, 203877, 209269, 221569, 231788, 301867, 302007, 303888, 304275, 305770, 310167, 310291, 310538, 311276,
               311312, 311566, 311652, 325465, 340522]


def random_family(seed):
    return [Case(random_scene(int(seed)))]


def gallery_family(index):
    return [gallery()[int(index)]]


# --- touching
def gap(distance):
    wanted = "stands" if distance <= 1e-9 else "falls"
    cubes = [cube("low", 0, 0.5 + distance), cube("high", 0, 1.5 + 2 * distance)]
    return [Case(scene(cubes), command="check", expect=verdict(wanted)), Case(scene(cubes, 1.0)),
            Case(scene([cube("l", -0.5 - distance / 2, 0.5), cube("r", 0.5 + distance / 2, 0.5), cube("t", 0, 2)], 1.0))]


def overlap(distance):
    cubes = [cube("low", 0, 0.5 - distance), cube("high", 0, 1.5 - 2 * distance)]
    if distance > 1e-9:
        return [Case(scene(cubes), refuse=True)]
    return [Case(scene(cubes), command="check", expect=verdict("stands")), Case(scene(cubes, 1.0))]


# --- long runs
def soak(steps):
    """A stack of three slides for ever and a fourth falls on it; up to a hundred thousand steps also ten cubes that settle in a bin."""
    dt = repr(2 / steps)
    bin_scene = {**pile(10)[0].scene, "duration": 2.0}
    slide = scene([cube(f"c{i}", 0, 0.5 + i, velocity=[2, 0]) for i in range(3)] + [cube("d", 0.2, 6, velocity=[2, 0], spin=3.0)], 2.0)

    def even(answer):
        low = answer["samples"][-1]["bodies"]["c0"]
        return None if low["y"] == 0.5 or abs(low["y"] - 0.5) <= 1e-9 else f"the lowest cube is {low['y'] - 0.5:.2g} m above its place"
    cases = [Case(slide, ("--integrator", "rattle", "--step", dt), drift=1e-3, expect=even)]
    return cases + ([Case(bin_scene, ("--integrator", "rattle", "--step", dt), drift=1e-3)] if steps <= 1e5 else [])


def families(reference):
    """All of them; `reference` is the end of tumble() at the smallest tolerance."""
    near = [9e-10, 1.1e-9]
    return [
        Family("tower", "cubes on each other", [10, 100, 1000, 10000], [10, 30, 100, 300, 1000, 3000, 10000, 30000], tower_height, holds_to=10000),
        Family("falling_tower", "cubes on each other", [3, 10, 30], [3, 10, 30, 100, 300, 1000], falling_tower),
        Family("knife_edge", "relative distance from falling", powers(-2, -12, 2), powers(-2, -15), knife_edge, holds_to=1e-8),
        Family("mass_ratio", "ratio of masses", powers(0, 12, 3), powers(0, 15), mass_ratio, holds_to=1e13),
        Family("size_ratio", "ratio of sides", powers(0, 4), powers(0, 12), size_ratio, holds_to=1e7),
        Family("step", "step / s", powers(0, -4, 2), [100.0, 10.0] + powers(0, -7), step, holds_to=1e-6),
        Family("tolerance", "tolerance", powers(-3, -11, 2), powers(-1, -14), tolerance_family(reference)),
        Family("spin", "spin / (rad/s)", powers(0, 5), powers(0, 6), spin),
        Family("speed", "speed / (m/s)", powers(0, 5), powers(0, 7), speed),
        Family("distance", "distance from the origin / m", powers(0, 6, 2), powers(0, 9), distance_family(reference), holds_to=1e6),
        Family("pile", "cubes in a bin", [10, 100], [10, 100, 300, 1000, 3000, 10000, 30000], pile),
        Family("random", "scenes", list(range(200)) + OVERLAPPED_ONCE, list(range(10000)), random_family, collection=True,
               known=("random 1796", "random 2756", "random 8917")),
        Family("friction", "coefficient of friction", [1e-12, 1e-6, 1e-3, 1.0, 10.0, 1e6], powers(-12, 6), friction),
        Family("restitution", "coefficient of restitution", [1e-12, 0.5, 1.0], [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.3, 0.5, 0.8, 0.9, 0.99, 0.999, 1.0], bounces),
        Family("seams", "speed / (m/s)", powers(0, 3), powers(0, 6), seams),
        Family("momentum", "cubes in space", [4, 16], [4, 9, 16, 36, 64, 100], momentum),
        Family("random_rubbing", "scenes", list(range(60)), list(range(10000)), random_rubbing, collection=True,
               known=("random_rubbing 9733",)),
        Family("random_joined", "scenes", BROKEN_ONCE, list(range(200000, 210000)), random_joined, collection=True),
        Family("random_standing", "scenes", [*range(60), 2802, 7741, 8173, 9956], list(range(10000)), random_standing, collection=True,
               known=("random_standing 4471",)),
        Family("random_events", "scenes", [40, 61, 133, 256], list(range(1000)), random_events, collection=True),
        Family("seen_otherwise", "scenes", [*range(40), 1086], list(range(10000)), seen_otherwise, collection=True),
        Family("seen_joined", "scenes", list(range(40)), list(range(10000)), lambda seed: seen_otherwise(seed, joined=True), collection=True),
        Family("explained", "scenes", list(range(40)), list(range(10000)), lambda seed: seen_otherwise(seed, command="explain"), collection=True),
        Family("laws", "scenes", list(range(60)), list(range(10000)), random_laws, collection=True),
        Family("gallery", "scenes", list(range(len(gallery()))), list(range(len(gallery()))), gallery_family, collection=True,
               known=("needle across a gap",)),
        Family("soak", "steps", [1e4], powers(4, 7), soak, patience=5),
        Family("gap", "gap / side", [1e-15, 1e-12, *near, 1e-6], powers(-16, -10) + near + powers(-8, -4), gap),
        Family("overlap", "overlap / side", [1e-15, 1e-12, *near, 1e-6], powers(-16, -10) + near + powers(-8, -4), overlap),
    ]
