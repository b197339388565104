"""Degenerate geometry: what is measure zero and happens all the time in scenes made by hand."""
import math

from case import Case

FLOOR = {"name": "floor"}


def cube(name, x, y, **more):
    return {"name": name, "position": [x, y], **more}


def scene(cubes, duration=2.0, planes=(FLOOR,), **more):
    return {"version": 1, "duration": duration, "plane": list(planes), "cube": cubes, **more}


def corners():
    eighth = math.pi / 4
    return {
        "corner falls on corner": scene([cube("low", 0, 0.5), cube("high", 1, 2.5)]),
        "corner falls on corner, both turned": scene([cube("low", 0, 1.5, angle=eighth), cube("high", 0, 4, angle=eighth)]),
        "corner falls on the middle of a side": scene([cube("low", 0, 0.5), cube("high", 0, 2.5, angle=eighth)]),
        "corner falls on the end of a side": scene([cube("low", 0, 0.5), cube("high", 0.5, 2.5, angle=eighth)]),
        "corner touches corner, at rest": scene([cube("a", 0, 0.5), cube("b", 1, 1.5)]),
        "three corners meet in a point": scene([cube("a", -0.5, 0.5), cube("b", 0.5, 0.5), cube("c", 0.5, 1.5), cube("d", -0.5, 2.5)]),
        "balanced on a corner": scene([cube("a", 0, math.sqrt(0.5), angle=eighth)]),
        "balanced on a corner on a corner": scene([cube("a", 0, math.sqrt(0.5), angle=eighth), cube("b", 0, 3 * math.sqrt(0.5), angle=eighth)]),
        "four corners of turned squares meet": scene([cube(f"c{i}{j}", i * math.sqrt(2), 2 + j * math.sqrt(2), angle=eighth)
                                                      for i in range(3) for j in range(3)]),
    }


def sides():
    return {
        "side slides past the end of a side": scene([cube("low", 0, 0.5), cube("high", 0, 1.5, velocity=[1.5, 0])]),
        "exactly half over the edge": scene([cube("low", 0, 0.5), cube("high", 0.5, 1.5)]),
        "slides along a wall it touches": scene([cube("a", 0, 3)], fixed=[{"name": "wall", "size": [1, 6], "position": [1, 3]}]),
        "falls through a shaft of its own width": scene(
            [cube("a", 0, 3)], fixed=[{"name": "left", "size": [1, 6], "position": [-1, 3]}, {"name": "right", "size": [1, 6], "position": [1, 3]}]),
        "falls into a shaft of its own width": scene(
            [cube("a", 0, 3)], fixed=[{"name": "left", "size": [1, 2], "position": [-1, 1]}, {"name": "right", "size": [1, 2], "position": [1, 1]}]),
        "grid falls as one": scene([cube(f"c{i}{j}", i, 1.5 + j) for i in range(4) for j in range(4)], 1.0),
        "grid collapses from its lowest row": scene([cube(f"c{i}{j}", i, 0.5 + j, velocity=[0.5 * (2 * i - 3) if j == 0 else 0, 0])
                                                     for i in range(4) for j in range(4)]),
        "bin of exactly three squares' width": scene(
            [cube(f"c{i}", 0.5 + i % 3, 0.5 + 1.001 * (i // 3)) for i in range(9)],
            fixed=[{"name": "left", "position": [-0.5, 3], "size": [1, 6]}, {"name": "right", "position": [3.5, 3], "size": [1, 6]}]),
        "two fall flat on one at the same time": scene([cube("low", 0, 0.5, size=[3, 1]), cube("a", -1, 2), cube("b", 1, 2)]),
        "squeezed between two that move": scene([cube("l", -2, 0.5, velocity=[3, 0]), cube("m", 0, 0.5), cube("r", 2, 0.5, velocity=[-3, 0])]),
        "row struck at its end": scene([cube(f"r{i}", i, 0.5) for i in range(8)] + [cube("hit", -4, 0.5, velocity=[10, 0])]),
    }


def shapes():
    return {
        "needle falls on its point": scene([cube("n", 0, 3, size=[1e-6, 2])]),
        "needle falls flat": scene([cube("n", 0, 1, size=[2, 1e-6])]),
        "needle across a gap": scene([cube("a", -1, 0.5), cube("b", 1, 0.5), cube("n", 0, 1.5, size=[3, 1e-6])]),
        "sheets on sheets": scene([cube("s0", 0, 5e-5, size=[2, 1e-4])] +
                                  [{"name": f"s{i}", "size": [2, 1e-4], "on": f"s{i - 1}", "offset": 0.05} for i in range(1, 10)]),
        "leaning plank": scene([cube("p", 0, 3 * math.sin(1.2) / 2 + 0.1 * math.cos(1.2) / 2 + 1e-3, size=[3, 0.1], angle=1.2)],
                               fixed=[{"name": "wall", "size": [1, 8], "position": [2, 4]}]),
        "wedge in a valley": scene([cube("a", 0, 3, angle=math.pi / 4), cube("b", 0.1, 5)], 3.0,
                                   planes=({"name": "l", "normal": [1, 1]}, {"name": "r", "normal": [-1, 1]})),
        "square in a valley that fits": scene([cube("a", 0, 2, angle=math.pi / 4)],
                                              planes=({"name": "l", "normal": [1, 1]}, {"name": "r", "normal": [-1, 1]})),
        "valley nearly as narrow as a slot": scene([cube("a", 0, 30), cube("b", 0.2, 34)], 4.0,
                                                   planes=({"name": "l", "normal": [20, 1]}, {"name": "r", "normal": [-20, 1]})),
        "slope that is nearly a wall": scene([cube("a", 1, 3)], planes=(FLOOR, {"name": "s", "normal": [1, 1e-6]})),
        "slope that is nearly flat": scene([cube("a", 0, 0.5)], 5.0, planes=({"name": "s", "normal": [1e-9, 1]},)),
        "turned by a hair on its side": scene([cube("a", 0, 0.5 + 0.5e-6, angle=1e-6)]),
        "turned by many times around": scene([cube("a", 0, 2, angle=1e5)]),
    }


def starts():
    return {
        "no gravity, at rest, touching": scene([cube("a", 0, 0.5), cube("b", 0, 1.5)], gravity=[0, 0]),
        "no gravity, pressed together": scene([cube("a", 0, 0, velocity=[1, 0]), cube("b", 1, 0, velocity=[-1, 0])], planes=(), gravity=[0, 0]),
        "impact at the start": scene([cube("a", 0, 0.5, velocity=[0, -2]), cube("b", 0, 1.5, velocity=[0, -1])]),
        "impact at the start, spinning": scene([cube("a", 0, 0.5, spin=-5.0)]),
        "spin of a cube at rest on another": scene([cube("a", 0, 0.5), cube("b", 0, 1.5, spin=20.0)]),
        "no time at all": scene([cube("a", 0, 0.5), cube("b", 0.6, 1.5)], 0.0),
        "gravity upwards": scene([cube("a", 0, 0.5), cube("b", 0, 1.5)], gravity=[0, 9.81]),
        "gravity of a millionth": scene([cube("a", 0, 0.5), cube("b", 0.7, 1.5)], 500.0, gravity=[0, -1e-6]),
        "gravity of a million": scene([cube("a", 0, 0.5), cube("b", 0.7, 1.5)], 0.01, gravity=[0, -1e6]),
    }


def gallery():
    scenes = {**corners(), **sides(), **shapes(), **starts()}
    return [Case(scenes[name], name=name) for name in scenes]
