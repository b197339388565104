"""Motions that must be the same seen otherwise: moved, turned, mirrored, in other units, in another order, beside a stranger."""
import copy
import json
import math

from program import ProgramTest, main

# A short motion with falls, impacts, sliding and rest, not long enough to forget where it comes from.
SCENE = {"version": 1, "gravity": [0.3, -9.81], "plane": [{"name": "floor", "point": [0, 0], "normal": [0, 1]}],
         "fixed": [{"name": "step", "size": [1.0, 0.4], "position": [3.0, 0.2]}],
         "cube": [{"name": "a", "size": 1.0, "mass": 1.0, "position": [0.0, 1.0], "angle": 0.2, "velocity": [0.5, 0.0]},
                  {"name": "b", "size": [0.6, 0.4], "mass": 2.0, "position": [-1.4, 0.2]},
                  {"name": "c", "size": 0.5, "mass": 0.5, "position": [1.9, 0.9], "spin": 2.0}]}
UNTIL = 0.6
KEYS = ("x", "y", "theta", "vx", "vy", "omega")


def turned(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [c * v[0] - s * v[1], s * v[0] + c * v[1]]


class Metamorphic(ProgramTest):
    def end(self, scene, until=UNTIL, *options):
        out = self.summary(scene, "--sample", repr(until), "--until", repr(until), "--quiet", *options)["samples"][0]["bodies"]
        return {name: [body[key] for key in KEYS] for name, body in out.items()}

    def compare(self, expected, got, tolerance=1e-7):
        self.assertEqual(set(expected), set(got))
        for name, values in expected.items():
            for key, want, have in zip(KEYS, values, got[name]):
                self.assertAlmostEqual(want, have, delta=tolerance * max(1.0, abs(want)), msg=f"{name}.{key}")

    def mapped(self, vector, angle=lambda a: a, spin=lambda w: w, velocity=None, scene=SCENE):
        """The scene with every place, direction and angle sent through a map."""
        velocity = velocity or vector
        s = copy.deepcopy(scene)
        s["gravity"] = velocity(s["gravity"])
        for plane in s["plane"]:
            plane["point"], plane["normal"] = vector(plane["point"]), velocity(plane["normal"])
        for body in s["fixed"] + s["cube"]:
            body["position"] = vector(body["position"])
            body["angle"] = angle(body.get("angle", 0.0))
            if "velocity" in body:
                body["velocity"] = velocity(body["velocity"])
            if "spin" in body:
                body["spin"] = spin(body["spin"])
        return s

    def test_translation(self):
        dx, dy = 7.25, -3.5
        moved = self.end(self.mapped(lambda p: [p[0] + dx, p[1] + dy], velocity=lambda v: v))
        self.compare({n: [v[0] + dx, v[1] + dy, *v[2:]] for n, v in self.end(SCENE).items()}, moved)

    def test_rotation_of_everything_gravity_too(self):
        phi = 0.7
        got = self.end(self.mapped(lambda p: turned(p, phi), angle=lambda a: a + phi))
        expected = {n: [*turned(v[:2], phi), v[2] + phi, *turned(v[3:5], phi), v[5]] for n, v in self.end(SCENE).items()}
        self.compare(expected, got)

    def test_mirror_image(self):
        flip = lambda p: [-p[0], p[1]]
        got = self.end(self.mapped(flip, angle=lambda a: -a, spin=lambda w: -w))
        self.compare({n: [-v[0], v[1], -v[2], -v[3], v[4], -v[5]] for n, v in self.end(SCENE).items()}, got)

    def test_units_of_length_mass_and_time(self):
        length, mass, time = 1e-3, 250.0, 0.04
        speed = length / time
        scale = lambda p: [length * p[0], length * p[1]]
        s = self.mapped(scale, spin=lambda w: w / time, velocity=lambda v: [speed * v[0], speed * v[1]])
        s["gravity"] = [g * length / time**2 for g in SCENE["gravity"]]
        for body in s["fixed"] + s["cube"]:
            size = body["size"]
            body["size"] = [length * w for w in size] if isinstance(size, list) else length * size
            if "mass" in body:
                body["mass"] *= mass
        got = self.end(s, UNTIL * time)
        back = {n: [v[0] / length, v[1] / length, v[2], v[3] / speed, v[4] / speed, v[5] * time] for n, v in got.items()}
        self.compare(self.end(SCENE), back)

    def test_other_order_and_names(self):
        s = copy.deepcopy(SCENE)
        s["cube"] = [s["cube"][k] for k in (2, 0, 1)]
        names = {"a": "zebra", "b": "Ärger", "c": "1"}
        for cube in s["cube"]:
            cube["name"] = names[cube["name"]]
        self.compare({names[n]: v for n, v in self.end(SCENE).items()}, self.end(s))

    def test_a_stranger_far_away_changes_no_bit(self):
        s = copy.deepcopy(SCENE)
        s["cube"].append({"name": "stranger", "position": [1000.0, 500.0], "spin": 3.0})
        got = self.end(s)
        got.pop("stranger")
        self.assertEqual(self.end(SCENE), got)

    def test_twice_the_masses(self):
        s = copy.deepcopy(SCENE)
        for cube in s["cube"]:
            cube["mass"] *= 2.0
        self.compare(self.end(SCENE), self.end(s))

    def test_a_rectangle_is_two_squares_on_two_pins(self):
        # It falls on a corner and comes to rest; two pins hold one direction twice.
        angle, spin, at, velocity = 0.3, 0.7, [0.0, 2.0], [0.4, 0.0]
        along = turned([0.5, 0.0], angle)

        def square(name, side):
            arm = [side * along[0], side * along[1]]
            return {"name": name, "position": [at[0] + arm[0], at[1] + arm[1]], "angle": angle, "spin": spin,
                    "velocity": [velocity[0] - spin * arm[1], velocity[1] + spin * arm[0]]}

        whole = {"plane": [{"name": "floor"}], "cube": [{"name": "r", "size": [2, 1], "mass": 2, "position": at, "angle": angle, "velocity": velocity, "spin": spin}]}
        split = {"plane": [{"name": "floor"}], "cube": [square("a", -1), square("b", 1)],
                 "pin": [{"from": "a.ne", "to": "b.nw"}, {"from": "a.se", "to": "b.sw"}]}
        for until in (0.5, 0.62, 2.5):
            halves = self.end(split, until)
            self.compare(self.end(whole, until), {"r": [0.5 * (a + b) for a, b in zip(halves["a"], halves["b"])]}, 1e-9)

    def test_looking_more_often_changes_no_bit(self):
        self.assertEqual(self.end(SCENE), self.end(SCENE, UNTIL, "--states", "s.csv", "--fps", "333"))


if __name__ == "__main__":
    main()
