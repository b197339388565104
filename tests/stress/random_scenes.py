"""Scenes drawn by a seed: each seed always gives the same scene."""
import random

FLOOR = {"name": "floor"}


def bin_of(width, height):
    return [{"name": "left", "size": [0.5, height], "position": [-width / 2 - 0.25, height / 2]},
            {"name": "right", "size": [0.5, height], "position": [width / 2 + 0.25, height / 2]}]


def pile(draw):
    width, count = draw.uniform(2.2, 6), draw.randint(2, 16)
    scene = {"plane": [FLOOR], "fixed": bin_of(width, 40),
             "pile": [{"count": count, "size": draw.uniform(0.4, 1), "seed": draw.randint(1, 10**6),
                       "region": [-width / 2 + 0.01, 0.3, width / 2 - 0.01, 3 + 2.2 * count]}]}
    return scene


def tower(draw):
    count = draw.randint(2, 10)
    scene = {"plane": [FLOOR], "tower": [{"name": "t", "count": count, "base": [0, 0],
                                          "lean": draw.choice([draw.uniform(-0.4, 0.4), 1 / count, 0.5, 0.25])}]}
    if draw.random() < 0.5:
        side = draw.choice([-1, 1])
        scene["cube"] = [{"name": "bullet", "size": draw.uniform(0.2, 0.8), "mass": 10**draw.uniform(-3, 3),
                          "position": [-6 * side, draw.uniform(1, count)], "velocity": [side * draw.uniform(4, 40), 0]}]
    return scene


def scattered(draw, turned=True, spin=10.0):
    """Up to nine cubes on a coarse grid, each free in its cell."""
    cubes = []
    for i in range(draw.randint(1, 9)):
        cubes.append({"name": f"c{i}", "size": draw.choice([1, 0.5, [1, 0.5], [2, 0.2], [0.3, 1.7]]),
                      "mass": draw.choice([1, 1, 10, 1e-3, 1e4]), "position": [2.9 * (i % 3) - 3, 1.7 + 2.9 * (i // 3)],
                      "angle": draw.uniform(-3, 3) if turned and draw.random() < 0.7 else 0,
                      "velocity": [draw.uniform(-5, 5), draw.uniform(-5, 5)],
                      "spin": draw.uniform(-spin, spin) if turned else 0})
    scene = {"plane": [FLOOR] if draw.random() < 0.9 else [], "cube": cubes}
    if draw.random() < 0.3:
        scene["plane"].append({"name": "slope", "point": [5, 0], "normal": [-1, draw.choice([0, 0.3, 1])]})
    if draw.random() < 0.3:
        scene["fixed"] = [{"name": "beam", "size": [3, 0.4], "position": [0, -1.2 if not scene["plane"] else 0.2],
                           "angle": 0 if scene["plane"] else draw.uniform(-0.5, 0.5)}]
    if not scene["plane"]:
        scene["gravity"] = draw.choice([[0, 0], [0, -9.81], [3, -3]])
    return scene


def grid(draw):
    """Aligned cubes with equal or no gaps: many contacts at one instant."""
    gap = draw.choice([0, 0, 1e-12, 1e-9, 1e-6, 0.01, 0.3])
    rows, columns, lift = draw.randint(1, 4), draw.randint(1, 4), draw.choice([0, 0.5, 1.0])
    cubes = [{"name": f"g{r}_{c}", "position": [c * (1 + gap), 0.5 + lift + r * (1 + gap)]}
             for r in range(rows) for c in range(columns)]
    if draw.random() < 0.5:
        cubes[draw.randrange(len(cubes))]["velocity"] = [draw.uniform(-3, 3), draw.choice([0, draw.uniform(-3, 3)])]
    return {"plane": [FLOOR], "cube": cubes}


def bridge(draw):
    """Planks and blocks put on each other, each with an offset."""
    cubes, below = [], "floor"
    for i in range(draw.randint(2, 7)):
        cubes.append({"name": f"b{i}", "size": draw.choice([1, 1, [2, 0.3], [0.4, 1.2], [3, 0.5]]),
                      "mass": 10**draw.choice([0, 0, draw.uniform(-4, 4)]), "on": below,
                      "offset": draw.choice([0, 0.5, 0.25, draw.uniform(-0.7, 0.7)])})
        below = f"b{i}"
    return {"plane": [FLOOR], "cube": cubes}


def valley(draw):
    """Cubes that fall into a V of two planes and wedge there."""
    scene = scattered(draw)
    scene.pop("fixed", None)
    scene.pop("gravity", None)
    steep = draw.choice([1, 0.5, 2, draw.uniform(0.2, 3)])
    scene["plane"] = [{"name": "left", "point": [0, -6 * steep - 3], "normal": [steep, 1]},
                      {"name": "right", "point": [0, -6 * steep - 3], "normal": [-steep, 1]}]
    scene["duration"] = 3.0
    return scene


KINDS = {"pile": pile, "tower": tower, "scattered": scattered, "upright": lambda draw: scattered(draw, turned=False),
         "spinning": lambda draw: scattered(draw, spin=300.0), "grid": grid, "bridge": bridge, "valley": valley}


def random_scene(seed):
    draw = random.Random(seed)
    kind = draw.choice(list(KINDS))
    scene = {"version": 1, "title": f"{kind} {seed}", "duration": draw.choice([0.5, 1.0, 2.0])}
    scene.update(KINDS[kind](draw))
    return scene
