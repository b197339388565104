"""Points, rods and pins from outside: what `check`, `run` and the tables tell of them."""
import cmath
import csv
import json
import os
import re

from program import ProgramTest, main

DOOR = {"version": 1, "title": "door", "duration": 0.1,
        "cube": [{"name": "door", "mass": 3, "position": [0.5, 0]}],
        "point": [{"name": "bob", "mass": 2, "position": [5, -1]}],
        "pin": [{"name": "hinge", "from": "door.w", "to": [0, 0]}],
        "rod": [{"name": "rope", "from": "door.e", "to": [1, 2]}, {"name": "string", "from": [5, 0], "to": "bob"}]}
SWINGING = {"version": 1, "title": "swinging", "duration": 1.0,
            "point": [{"name": "bob", "position": [1, 0]}],
            "rod": [{"name": "string", "from": "bob", "to": [0, 0]}]}


class Rods(ProgramTest):
    def test_check_gives_the_forces_of_rods_and_pins(self):
        answer = json.loads(self.expect(0, "check", self.scene(DOOR), "--json").stdout)
        self.assertEqual(answer["verdict"], "stands")
        self.assertEqual(set(answer["accelerations"]["bob"]), {"ax", "ay"})
        self.assertEqual(set(answer["accelerations"]["door"]), {"ax", "ay", "alpha"})
        self.assertEqual([rod["name"] for rod in answer["rods"]], ["rope", "string"])
        self.assertEqual(set(answer["rods"][0]), {"name", "force", "unique"})
        self.assertAlmostEqual(answer["rods"][0]["force"], 1.5 * 9.81, delta=1e-9)
        self.assertAlmostEqual(answer["rods"][1]["force"], 2 * 9.81, delta=1e-9)
        self.assertEqual(set(answer["pins"][0]), {"name", "force", "unique"})
        self.assertAlmostEqual(answer["pins"][0]["force"][1], 1.5 * 9.81, delta=1e-9)
        self.assertIs(answer["pins"][0]["unique"], True)

    def test_check_tells_people_too(self):
        text = self.expect(0, "check", self.scene(DOOR)).stdout
        self.assertRegex(text, r"rope +14\.715 pulls")
        self.assertRegex(text, r"hinge")

    def test_points_are_in_samples_and_tables(self):
        s = self.summary(SWINGING, "--sample", "0,1", "--states", "s.csv", "--forces", "f.csv")
        self.assertEqual(set(s["samples"][0]["bodies"]["bob"]), {"x", "y", "theta", "vx", "vy", "omega"})
        self.assertEqual(s["samples"][1]["bodies"]["bob"]["theta"], 0)
        self.assertLessEqual(s["audit"]["max_rod_error"], 1e-12)
        self.assertEqual(s["outcome"]["moved"], ["bob"])
        rows = list(csv.DictReader(self.content("s.csv").splitlines()))
        self.assertEqual({row["body"] for row in rows}, {"bob"})
        forces = list(csv.DictReader(self.content("f.csv").splitlines()))
        self.assertEqual({row["kind"] for row in forces}, {"rod_tension"})
        for row in forces[1:]:
            self.assertLess(float(row["kkt_residual"]), 1e-9)

    def test_a_rod_that_pulls_acts_towards_its_other_end(self):
        self.summary({**DOOR, "duration": 0}, "--forces", "f.csv", "--until", "0")
        forces = {row["on"]: row for row in csv.DictReader(self.content("f.csv").splitlines())
                  if row["kind"] == "rod_tension"}
        self.assertGreater(float(forces["door"]["fy"]), 0)
        self.assertGreater(float(forces["bob"]["fy"]), 0)

    def test_every_integrator_keeps_the_length(self):
        for integrator in ("auto", "event", "rattle", "moreau", "symplectic", "euler"):
            with self.subTest(integrator):
                s = self.summary(SWINGING, "--integrator", integrator, "--sample", "1", code=0)
                bob = s["samples"][0]["bodies"]["bob"]
                self.assertAlmostEqual((bob["x"] ** 2 + bob["y"] ** 2) ** 0.5, 1.0, delta=1e-12)

    def test_rods_that_contradict_each_other_are_named(self):
        scene = {"point": [{"name": "p", "position": [0, 0], "velocity": [0, 1]}],
                 "rod": [{"name": "l", "from": "p", "to": [-1, 0]}, {"name": "r", "from": "p", "to": [1, 0]},
                         {"name": "other", "from": "p", "to": [-3, 0]}]}
        for command in (("check",), ("run", "--json")):
            done = self.expect(2, *command, self.scene(scene))
            self.assertIn("contradict each other", done.stderr)
        scene["rod"].pop()
        self.assertIn('"l", "r"', self.expect(2, "check", self.scene(scene)).stderr)

    def test_rods_that_contradict_each_other_as_soon_as_they_move_are_named(self):
        scene = {"point": [{"name": "p", "position": [0, 0]}, {"name": "q", "position": [0, -1]}],
                 "rod": [{"name": "l", "from": "p", "to": [-1, 0]}, {"name": "r", "from": "p", "to": [1, 0]},
                         {"name": "down", "from": "p", "to": "q"}]}
        for command in (("check",), ("run", "--json"), ("run", "--integrator", "rattle", "--json")):
            done = self.expect(2, *command, self.scene(scene))
            self.assertIn('contradict each other as soon as they move: no acceleration keeps the lengths of "l", "r" at once', done.stderr)
        # What holds it still, or lets a third rod go along, is no contradiction.
        held = {**scene, "rod": scene["rod"] + [{"name": "up", "from": "p", "to": [0, 2]}]}
        self.assertEqual(json.loads(self.expect(0, "check", self.scene(held), "--json").stdout)["verdict"], "stands")
        swing = {"cube": [{"name": "c", "position": [1, -1]}],
                 "rod": [{"from": "c.nw", "to": [-0.5, 0]}, {"from": "c.ne", "to": [0.5, 0]}, {"from": "c.n", "to": [0, 0]}]}
        self.expect(1, "check", self.scene(swing))
        self.assertLessEqual(self.summary({**swing, "duration": 1})["audit"]["max_rod_error"], 1e-12)

    def test_what_a_rope_takes_that_is_struck_across_is_booked(self):
        scene = {"gravity": [0, 0], "duration": 1, "point": [{"name": "p", "position": [0, 0]}],
                 "rod": [{"name": "l", "from": "p", "to": [-1, 0]}, {"name": "r", "from": "p", "to": [1, 0]}],
                 "cube": [{"name": "c", "size": 0.4, "position": [0, 1], "velocity": [0, -4]}]}
        for integrator in ("auto", "event", "rattle", "moreau", "symplectic", "euler"):
            with self.subTest(integrator):
                s = self.summary(scene, "--integrator", integrator)
                self.assertAlmostEqual(s["audit"]["energy"]["impact_loss"], 8, delta=1e-6)
                self.assertAlmostEqual(s["audit"]["energy"]["drift"], 0, delta=1e-6)
                self.assertIn("jam", {event["kind"] for event in s["events"]})
                self.assertEqual(s["audit"]["rods_contradicting"], 0)

    def test_rods_that_lose_their_lengths_are_named(self):
        # A point on the coupler of a crank and a rocker, on one more rod to the centre of curvature of its path: that
        # contradicts nothing to second order, and nothing but rounding can move.
        crank, anchor, l, r = cmath.exp(1.1j), 2, 1.6, 1.4

        def coupler(angle):
            p = cmath.exp(1j * angle)
            d = abs(anchor - p)
            along = (l * l - r * r + d * d) / (2 * d)
            u = (anchor - p) / d
            q = p + u * complex(along, (l * l - along * along) ** 0.5)
            v = (q - p) / l
            return q, p + v * complex(0.9, 0.8)

        e = 1e-3
        path = [coupler(1.1 + k * e)[1] for k in range(-2, 3)]
        first = (8 * (path[3] - path[1]) - path[4] + path[0]) / (12 * e)
        second = (16 * (path[3] + path[1]) - path[4] - path[0] - 30 * path[2]) / (12 * e * e)
        normal = 1j * first / abs(first)
        centre = path[2] + normal * abs(first) ** 2 / (normal.conjugate() * second).real
        at = lambda z: [z.real, z.imag]
        points = {"p": crank, "q": coupler(1.1)[0], "c": path[2]}
        scene = {"duration": 1, "point": [{"name": name, "position": at(z)} for name, z in points.items()],
                 "rod": [{"from": [0, 0], "to": "p"}, {"from": "p", "to": "q"}, {"from": [2, 0], "to": "q"}, {"from": "p", "to": "c"},
                         {"from": "q", "to": "c"}, {"name": "centre", "from": at(centre), "to": "c"}]}
        done = self.expect(3, "run", "--json", self.scene(scene))
        self.assertIn("rods have lost their lengths", done.stderr)
        self.assertIn('among centre', done.stderr)

    def test_bad_input_names_the_place_and_what_to_do(self):
        point = {"name": "pa", "position": [0, -1]}
        cube = {"name": "a", "position": [0, 0]}
        cases = {
            "a missing name": ({"point": [point], "rod": [{"from": "pb", "to": [0, 0]}]}, r'rod\[1\]\.from: there is no body "pb"; did you mean "pa"'),
            "a missing part": ({"cube": [cube], "rod": [{"from": "a.nx", "to": [0, 3]}]}, r'rod\[1\]\.from: "a" has no part "nx"; did you mean "ne"'),
            "a part of a point": ({"point": [point], "rod": [{"from": "pa.n", "to": [0, 0]}]}, r'"pa" is a point, which has no parts'),
            "length 0": ({"point": [point], "rod": [{"from": "pa", "to": [0, -2], "length": 0}]}, r"stay together are joined by a \[\[pin\]\]"),
            "no length": ({"point": [point], "rod": [{"from": "pa", "to": [0, -1]}]}, r"places coincide; use a \[\[pin\]\]"),
            "a length that it has not": ({"point": [point], "rod": [{"from": "pa", "to": [0, 0], "length": 1.5}]}, r"the distance of the two places at the start, 1 m; it is 1.5 m"),
            "a pin apart": ({"point": [point], "pin": [{"from": "pa", "to": [0, -1.02]}]}, r"must coincide; they are 0.02 m apart"),
            "a negative mass": ({"point": [{**point, "mass": -1}]}, r"point\[1\]\.mass: must be greater than 0; it is -1"),
            "a point inside a cube": ({"point": [point], "cube": [{"name": "c", "position": [0.1, -1]}]}, r'the point "pa" lies 0.4 m inside of "c"; move them apart'),
            "two fixed places": ({"point": [point], "rod": [{"from": [0, 0], "to": [1, 0]}]}, r"joins two places that cannot move"),
            "one body": ({"cube": [cube], "rod": [{"from": "a.nw", "to": "a.ne"}]}, r"joins two places of one body"),
            "a mistyped key": ({"point": [point], "rod": [{"frm": "pa", "to": [0, 0]}]}, r'unknown key "frm"; did you mean "from"'),
        }
        for what, (scene, message) in cases.items():
            with self.subTest(what):
                for command in ("check", "run"):
                    self.assertRegex(self.expect(2, command, self.scene(scene)).stderr, message)
        again = {"point": [point], "rod": [{"from": "pa", "to": [0, 0]}, {"from": "pa", "to": [0, 0]}, {"from": "pa", "to": [0, 1]}]}
        answer = json.loads(self.expect(0, "check", self.scene(again), "--json").stdout)
        self.assertEqual([rod["unique"] for rod in answer["rods"]], [False] * 3)
        self.assertAlmostEqual(sum(rod["force"] for rod in answer["rods"]), 9.81, delta=1e-9)

    def test_chains_and_trusses_have_names_and_forces(self):
        scene = {"truss": [{"count": 6, "from": [0, 0], "to": [6, 0]}],
                 "chain": [{"count": 3, "from": "truss1_b3", "to": [3, -3], "loose": True}]}
        answer = json.loads(self.expect(0, "check", self.scene(scene), "--json").stdout)
        rods = {rod["name"]: rod for rod in answer["rods"]}
        # Six bays of 1 m; weights of 1 kg at every joint, four at the middle: moments about the joint over it.
        support = 9.81 * (12 + 3) / 2
        self.assertAlmostEqual(rods["truss1_right"]["force"], -support, delta=1e-8)
        self.assertAlmostEqual(rods["truss1_top2"]["force"], -(3 * (support - 9.81) - 9.81 * 2 * 2 - 9.81 * 2), delta=1e-8)
        self.assertAlmostEqual(rods["chain1_rod1"]["force"], 3 * 9.81, delta=1e-8)
        self.assertTrue(all(rod["unique"] for rod in rods.values()))
        more = self.expect(0, "check", self.scene(scene), "--set", "truss.truss1.kind=warren", "--json").stdout
        self.assertIn("truss1_diagonal12", more)

    def test_the_scenes_of_their_page_do_what_it_says(self):
        with open(os.path.join(os.environ["SCENES"], "README.md")) as page:
            section = page.read().split("\n## Rods\n")[1]
        pendulum, bridge = re.findall(r"```toml\n(.*?)```", section, re.DOTALL)
        for name, text in (("pendulum.toml", pendulum), ("bridge.toml", bridge)):
            with open(self.path(name), "w") as file:
                file.write(text)
        s = json.loads(self.expect(0, "run", "pendulum.toml", "--until", "2", "--json").stdout)
        self.assertEqual(s["outcome"]["moved"], ["upper", "lower"])
        said = self.expect(0, "check", "bridge.toml").stdout.splitlines()
        shown = section.split("```\n$ wuerfel check")[1].split("```")[0].splitlines()[1:]
        self.assertEqual(len(shown), 5)
        for line in shown:
            self.assertIn(line, said)
        self.expect(0, "figure", "bridge.toml", "-o", "bridge.png", "--layers", "cubes,rod-forces,names,hud", "--size", "320x180")

    def test_a_corner_on_the_seam_of_two_decks_stays_on_it(self):
        # The load comes to rest with a corner where two decks meet: steps that lost it there gained 19 kJ.
        s = json.loads(self.expect(0, "run", "truss_bridge", "--integrator", "moreau", "--until", "4", "--json").stdout)
        self.assertLess(abs(s["audit"]["energy"]["drift"]), 20.0)

    def test_pictures_of_points_and_rods_can_be_drawn(self):
        for layers in ("cubes", "cubes,rods", "cubes,rod-forces,forces,hud,names,velocities,trails"):
            self.expect(0, "figure", self.scene(DOOR), "-o", "door.png", "--size", "320x180", "--layers", layers)
        self.expect(0, "run", self.scene(SWINGING), "-o", "frames/", "--fps", "4", "--size", "160x90", "--layers", "cubes,rod-forces")
        self.expect(0, "reproduce", "frames/frame_000002.png")


if __name__ == "__main__":
    main()
