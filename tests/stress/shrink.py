"""Makes a failing scene smaller as long as it fails in the same way."""
import copy
import dataclasses

from case import run_case

GROUPS = ("cube", "fixed", "plane", "tower", "wall", "pyramid", "pile")


def without_one_body(scene):
    for kind in GROUPS:
        for i in reversed(range(len(scene.get(kind, [])))):
            smaller = copy.deepcopy(scene)
            del smaller[kind][i]
            if not smaller[kind]:
                del smaller[kind]
            yield smaller


def with_fewer(scene):
    """Generators with fewer cubes, and half the time."""
    for kind in GROUPS:
        for i, body in enumerate(scene.get(kind, [])):
            for key in ("count", "rows", "columns"):
                for fewer in sorted({1, body.get(key, 1) // 2, body.get(key, 1) - 1}):
                    if 1 <= fewer < body.get(key, 1):
                        smaller = copy.deepcopy(scene)
                        smaller[kind][i][key] = fewer
                        yield smaller
    if scene.get("duration", 0) > 0.02:
        yield {**copy.deepcopy(scene), "duration": scene["duration"] / 2}


def paths(value, path=()):
    """Where the floating-point numbers of a scene are."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from paths(inner, (*path, key))
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from paths(inner, (*path, i))
    elif isinstance(value, float):
        yield path


def with_rounder_numbers(scene):
    for path in paths(scene):
        for digits in (0, 1, 2, 4):
            rounder = copy.deepcopy(scene)
            inner = rounder
            for key in path[:-1]:
                inner = inner[key]
            rounded = float(f"{inner[path[-1]]:.{digits}f}")
            if rounded != inner[path[-1]]:
                inner[path[-1]] = rounded
                yield rounder


def shrink(program, case, status, limit, budget=300):
    """The smallest scene found within `budget` calls that still ends with `status`."""
    smaller, calls, progress = case, 0, True
    while progress:
        progress = False
        for candidates in (without_one_body, with_fewer, with_rounder_numbers):
            again = True
            while again and calls < budget:
                again = False
                for scene in candidates(smaller.scene):
                    calls += 1
                    candidate = dataclasses.replace(smaller, scene=scene)
                    if run_case(program, candidate, limit).status == status:
                        smaller, again, progress = candidate, True, True
                        break
                    if calls >= budget:
                        return smaller
        if calls >= budget:
            break
    return smaller
