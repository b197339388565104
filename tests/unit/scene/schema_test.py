"""The JSON Schema of the scene format against an independent validator (python3-jsonschema).

Usage: schema_test.py SCENE_PROBE SCENES_FOLDER

1. The schema itself is valid (draft 7) and every table refuses unknown keys.
2. Every shipped scene, as written and normalised, is valid.
3. Thousands of damaged scenes (fixed seed): what the program reads, the schema allows.
4. Mistakes that need no more than one table to be seen: the schema refuses them as the program does.
"""
import copy
import json
import pathlib
import random
import subprocess
import sys
import tomllib

import jsonschema

probe, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*arguments, text=""):
    return subprocess.run([probe, *arguments], input=text, capture_output=True, text=True, check=True).stdout


schema = json.loads(run())
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)


def tables(part):
    if isinstance(part, dict):
        if part.get("type") == "object":
            yield part
        for value in part.values():
            yield from tables(value)
    elif isinstance(part, list):
        for value in part:
            yield from tables(value)


assert len(list(tables(schema))) == 21, "the document, [material], thirteen arrays of tables and six places in the frame of a body"
for table in tables(schema):
    assert table["additionalProperties"] is False
    assert all("description" in key for key in table["properties"].values())
    for name, key in table["properties"].items():
        if "default" in key:
            jsonschema.Draft7Validator(key).validate(key["default"])

scenes = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.toml"))}
assert len(scenes) >= 15
for name, scene in scenes.items():
    validator.validate(scene)
    validator.validate(json.loads(run("--normalise", str(folder / f"{name}.toml"))))

everything = {
    "version": 1, "title": "all keys", "gravity": [0, -1], "duration": 2.5,
    "material": {"friction": 0.5, "restitution": 0.5},
    "plane": [{"name": "floor", "point": [0, 0], "normal": [0, 2], "friction": 1, "restitution": 0}],
    "fixed": [{"name": "table", "size": [4, 1], "position": [20, 0.5], "angle_deg": 0, "friction": 1}],
    "cube": [{"name": "a", "size": 1, "mass": 2, "position": [0, 5], "angle": 0.1, "velocity": [1, 2], "spin": 1,
              "friction": 0, "restitution": 1, "color": "#00ffAA"},
             {"on": "floor", "offset": 3, "density": 2, "size": [1, 2], "color": "sky blue"}],
    "tower": [{"count": 2, "on": "table", "lean": 0.1}],
    "wall": [{"rows": 2, "columns": 3, "base": [-20, 0], "bond": "running"}],
    "pyramid": [{"rows": 2, "base": [-30, 0]}],
    "pile": [{"count": 3, "region": [30, 0, 40, 10], "seed": 4, "size": 0.5}],
    "pair": [{"bodies": ["a", "floor"], "friction": 0.5}],
    "point": [{"name": "p", "mass": 2, "position": [0, 9], "velocity": [1, 0]}],
    "rod": [{"name": "r", "from": "a.ne", "to": "p"}, {"from": [0, 12], "to": "p", "length": 3}],
    "chain": [{"count": 3, "from": [-40, 5], "to": [-38, 5], "length": 3, "mass": 2},
              {"name": "c", "count": 2, "from": "chain1_2", "to": [-39, 1], "loose": True, "size": [0.3, 0.1], "density": 2,
               "friction": 1, "restitution": 0, "color": "blue"}],
    "truss": [{"name": "t", "count": 3, "from": [-50, 0], "to": [-47, 0], "height": 0.5, "kind": "warren", "supports": "pins", "mass": 2}],
    "pin": [{"name": "hinge", "from": {"body": "p", "at": [0, 0]}, "to": [0, 9], "collide": True}],
}
validator.validate(everything)
assert run("--parse", text=json.dumps(everything)) == "ok\n"
missing = set(schema["properties"]) - set(everything)
assert not missing, missing

# What a value may turn into; the schema and the program must agree about all of it.
strange = [-1, 0, 1, 2, 2.5, 1e16, -1e16, 1e-13, 1e-31, 200001, True, False, None, "", "a", "floor", "blue", "#12345g", "x" * 101, "a\nb",
           [], [0, 1], [0, 0], [0, "x"], [1, 2, 3], [0, 0, 9, 9], ["a", "floor"], {}, {"a": 1}, [{}], 3.0]


def spots(part, path=()):
    yield path
    items = part.items() if isinstance(part, dict) else enumerate(part) if isinstance(part, list) else ()
    for key, value in items:
        yield from spots(value, path + (key,))


donors = [table for kind in everything.values() if isinstance(kind, list) for table in kind if isinstance(table, dict)]


def damaged(scene, dice):
    scene = copy.deepcopy(scene)
    for _ in range(dice.randint(1, 2)):
        path = dice.choice([path for path in spots(scene) if path])
        parent = scene
        for key in path[:-1]:
            parent = parent[key]
        action = dice.randrange(3)
        if action == 0:
            parent[path[-1]] = copy.deepcopy(dice.choice(strange))
        elif action == 1:
            del parent[path[-1]]
        elif isinstance(parent, dict):
            donor = dice.choice(donors)
            key = dice.choice(sorted(donor))
            parent[key] = copy.deepcopy(donor[key])
    return scene


dice = random.Random(20)
cases = [damaged(dice.choice([everything, *scenes.values()]), dice) for _ in range(3000)]
answers = run("--parse", text="".join(json.dumps(case) + "\n" for case in cases)).splitlines()
assert len(answers) == len(cases)
counts = {"both accept": 0, "both refuse": 0, "program only": 0}
# What only the program can see: it needs more than one table.
global_mistakes = ("overlap", "taken by", "there is no body", "clear of all others", "goes round", "must not be zero",
                   "two different", "given twice", "out of range", "no cubes", "xmin < xmax", "in a pile", "at most 200000",
                   "has no length", "has no part", "is a point", "is a plane", "cannot move", "of one body", "must coincide",
                   "distance of the two places", "inside of", "distance of its ends", "taut between", "longer than the chain",
                   "another place than", "no place yet", "no place on an arc", "in a chain")
for case, answer in zip(cases, answers):
    errors = list(validator.iter_errors(case))
    if answer == "ok":
        assert not errors, (case, errors[0].message)
        counts["both accept"] += 1
    elif errors:
        counts["both refuse"] += 1
    else:
        assert any(mistake in answer for mistake in global_mistakes), (case, answer)
        counts["program only"] += 1
assert counts["both accept"] > 200 and counts["both refuse"] > 1000, counts
print(f"{len(scenes)} scenes valid; of {len(cases)} damaged scenes: {counts}")
