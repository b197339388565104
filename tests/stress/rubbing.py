"""What rubs and bounces: friction from next to nothing to without bounds, restitution, seams, momentum, and scenes by seed."""
import math
import random

from case import Case
from gallery import cube, scene
from random_scenes import bin_of, random_scene

GRAVITY = 9.81


def near(wanted, allowed, what, value):
    return None if abs(value - wanted) <= allowed else f"{what} is {value:.17g} in place of {wanted:.17g}"


def rubs(a_scene, mu, e=0.0):
    return {**a_scene, "material": {"friction": mu, "restitution": e}}


# --- friction
def thrown_block(mu):
    """A flat block is thrown along the floor at 3 m/s: it slides as the law says (beyond mu = 9 it would tip)."""
    v, end = 3.0, 2.0
    stop = v / (mu * GRAVITY)
    way = v * end - mu * GRAVITY * end * end / 2 if stop > end else v * stop / 2

    def slid(answer):
        return near(way, 1e-9 * max(1, way), "the way", answer["samples"][-1]["bodies"]["a"]["x"])
    block = scene([cube("a", 0, 0.05, size=[1, 0.1], velocity=[v, 0])], end)
    return Case(rubs(block, mu), expect=slid if mu < 9 else None)


def friction(mu):
    pile = {"version": 1, "duration": 2.0, "plane": [{"name": "floor"}], "fixed": bin_of(4, 20),
            "pile": [{"count": 10, "size": 0.8, "seed": 4, "region": [-1.9, 0.3, 1.9, 12]}]}
    ladder = scene([cube("ladder", 1.24, 1.63, size=[4, 0.1], angle=-math.atan2(0.8, 0.6))], 1.0,
                   planes=({"name": "floor"}, {"name": "wall", "normal": [1, 0]}))
    dominoes = scene([cube("d0", 0, 0.5, size=[0.2, 1], velocity=[0.6, 0], spin=-1.2)]
                     + [cube(f"d{i}", 0.5 * i, 0.5, size=[0.2, 1]) for i in range(1, 5)], 1.5)
    tower = {"version": 1, "duration": 1.5, "plane": [{"name": "floor"}], "tower": [{"count": 5, "base": [0, 0], "lean": 0.3}]}
    return [thrown_block(mu)] + [Case(rubs(s, mu)) for s in (pile, ladder, dominoes, tower)]


# --- restitution
def bounces(e):
    """A cube falls flat by 1 m; after its first blow it rises to e^2 of that."""
    fall = math.sqrt(2 / GRAVITY)

    def risen(answer):
        return near(0.5 + e * e, 1e-9, "the height", answer["samples"][-1]["bodies"]["a"]["y"])
    ball = scene([cube("a", 0, 1.5)], fall * (1 + e))
    tumbling = scene([cube("a", 0, 2, angle=0.4, spin=2.0), cube("b", 0.3, 4, angle=-0.3)], 2.0)
    row = scene([cube("hammer", -3, 0.5, velocity=[4, 0])] + [cube(f"c{i}", 1.01 * i, 0.5) for i in range(4)], 2.0)
    return [Case(rubs(ball, 0.3, e), expect=risen if e > 1e-3 else None), Case(rubs(tumbling, 0.3, e)), Case(rubs(row, 0.1, e))]


# --- what no motion may change
def seams(v):
    """A cube slides over flush tiles without friction: as over one."""
    end = 8 / v
    tiles = [{"name": f"t{i}", "size": [1, 0.5], "position": [i + 0.5, -0.25]} for i in range(12)]

    def slid(answer):
        body = answer["samples"][-1]["bodies"]["a"]
        return near(v, 1e-9 * v, "the velocity", body["vx"]) or near(0.0, 1e-9 * v, "the spin", body["omega"])
    over = scene([cube("a", 1, 0.25, size=0.5, velocity=[v, 0])], end, planes=(), fixed=tiles)
    return [Case(over, ("--integrator", name), expect=slid) for name in ("auto", "rattle")]


def momentum(count):
    """Cubes meet in space: their momentum stays, whatever rubs and bounces."""
    draw = random.Random(int(count))
    side = math.ceil(math.sqrt(count))
    cubes = [cube(f"c{i}", 1.6 * (i % side), 1.6 * (i // side), angle=draw.uniform(-3, 3),
                  velocity=[draw.uniform(-1, 1) - (i % side - side / 2), draw.uniform(-1, 1) - (i // side - side / 2)])
             for i in range(int(count))]
    space = scene(cubes, 2.0, planes=(), gravity=[0, 0])
    at_hand = sum(math.hypot(*c["velocity"]) for c in cubes)

    def kept(answer):
        for axis in (0, 1):
            end = sum(b[("vx", "vy")[axis]] for b in answer["samples"][-1]["bodies"].values())
            wrong = near(sum(c["velocity"][axis] for c in cubes), 1e-12 * at_hand, "momentum", end)
            if wrong:
                return wrong
        # m (x v_y - y v_x) + I omega, with m = side = 1
        turning = sum(c["position"][0] * c["velocity"][1] - c["position"][1] * c["velocity"][0] for c in cubes)
        end = sum(b["x"] * b["vy"] - b["y"] * b["vx"] + b["omega"] / 6 for b in answer["samples"][-1]["bodies"].values())
        return near(turning, 1e-9 * at_hand * 1.6 * side, "angular momentum", end)
    return [Case(rubs(space, mu, e), energy=at_hand, expect=kept) for mu, e in ((0.0, 0.0), (0.5, 0.0), (0.5, 0.6))]


# --- by seed
def random_rubbing(seed):
    """The random scenes again, of materials that rub, and some of them bounce."""
    draw = random.Random(f"rubbing {int(seed)}")
    mu = draw.choice([0.1, 0.3, 0.6, 1.0, 10 ** draw.uniform(-4, 1)])
    return [Case(rubs(random_scene(int(seed)), mu, draw.choice([0, 0, 0, 0.3, 0.9])))]


def standing_bricks(draw):
    """A wall, a pyramid, columns or stairs of unit cubes that stand by themselves."""
    kind = draw.choice(["wall", "pyramid", "columns", "stairs"])
    columns, rows = draw.randint(2, 8), draw.randint(2, 6)

    def place(row, column):
        shift = {"wall": 0.5 * (row % 2), "pyramid": 0.5 * row, "columns": 0.2 * column, "stairs": 0.0}[kind]
        return [column + 0.5 + shift, row + 0.5]
    there = {"pyramid": lambda row, column: column < columns - row, "stairs": lambda row, column: row <= column}.get(kind, lambda row, column: True)
    return [{"name": f"w{row}_{column}", "position": place(row, column)}
            for row in range(rows) for column in range(columns) if there(row, column)]


def random_standing(seed):
    """Few cubes that tip from what stands, slide against it, fall on it or are thrown at it."""
    draw = random.Random(f"standing {int(seed)}")
    bricks = standing_bricks(draw)
    highest = max(y + 0.5 for _, y in (b["position"] for b in bricks))
    right = max(x + 0.5 for x, y in (b["position"] for b in bricks) if y + 0.5 == highest)
    movers = []
    for k in range(draw.randint(1, 3)):
        side = draw.choice([0.3, 0.5, 1.0])
        mover = {"name": f"m{k}", "size": side, "mass": draw.choice([side**2, 0.1, 5.0])}
        how = draw.choice(["tips", "slides", "falls", "flies"])
        if how == "tips" and k == 0:
            mover["position"] = [right + draw.uniform(0.0, 0.2) * side, highest + 0.5 * side]
        elif how == "slides":
            mover |= {"position": [-1.5 - 2.0 * k, 0.5 * side], "velocity": [draw.uniform(0.5, 4.0), 0.0]}
        elif how == "falls":
            mover |= {"position": [draw.uniform(0.0, right), highest + 1.5 + 2.0 * k], "angle": draw.uniform(-1.0, 1.0)}
        else:
            mover |= {"position": [-2.0 - 2.0 * k, draw.uniform(1.0, highest)], "velocity": [draw.uniform(1.0, 6.0), draw.uniform(0.0, 3.0)],
                      "angle": draw.uniform(-1.0, 1.0), "spin": draw.uniform(-3.0, 3.0)}
        movers.append(mover)
    cubes = bricks + movers
    a_scene = {"version": 1, "duration": 1.0, "plane": [{"name": "floor"}], "cube": cubes}
    return [Case(rubs(a_scene, draw.choice([0.3, 0.5, 0.6, 1.0]), draw.choice([0, 0, 0, 0.3, 0.8])))]


def random_events(seed):
    """The same from event to event, without end at one instant in some valleys."""
    return [Case(case.scene, ("--integrator", "event")) for case in random_rubbing(seed)]


def any_friction(draw):
    return draw.choice([0.1, 0.3, 0.6, 1.0, 10 ** draw.uniform(-12, 6), 10 ** draw.uniform(-4, 1), 10 ** draw.uniform(-4, 1)])


def any_restitution(draw):
    return draw.choice([0, 0, 0, 0, 0.3, 0.9, 1.0, draw.random(), 10 ** draw.uniform(-12, 0)])


def joined(a_scene, draw):
    """Up to five rods from places of cubes to others, or to the world."""
    cubes = [c for c in a_scene.get("cube", []) if "position" in c]
    if not cubes:
        return a_scene

    def place(name):
        return name + draw.choice(["", ".ne", ".sw", ".n", ".e", ".se", ".w"])
    rods = []
    for _ in range(draw.randint(1, max(1, min(5, len(cubes))))):
        a = draw.choice(cubes)
        if draw.random() < 0.3:
            x, y = a["position"]
            rods.append({"from": place(a["name"]), "to": [x + draw.uniform(-3, 3), y + draw.uniform(1, 4)]})
        else:
            b = draw.choice(cubes)
            if b is not a:
                rods.append({"from": place(a["name"]), "to": place(b["name"])})
    return {**a_scene, "rod": rods} if rods else a_scene


def random_joined(seed):
    """The random scenes, of all materials in each, three in ten with rods, by one of three integrators."""
    a_scene = random_scene(int(seed))
    draw = random.Random(f"drive {int(seed)}")
    a_scene["material"] = {"friction": any_friction(draw), "restitution": any_restitution(draw)}
    if draw.random() < 0.5:
        for body in (b for kind in ("cube", "plane", "fixed", "tower", "pile") for b in a_scene.get(kind, [])):
            if draw.random() < 0.7:
                body["friction"] = any_friction(draw)
            if draw.random() < 0.4:
                body["restitution"] = any_restitution(draw)
    if draw.random() < 0.3:
        a_scene = joined(a_scene, draw)
    chosen = draw.random()
    integrator = "auto" if chosen < 0.72 else "rattle" if chosen < 0.9 else "event"
    return [Case(a_scene, ("--integrator", integrator))]
