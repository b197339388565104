"""Points, rods and pins from outside: what `check`, `run` and the tables tell of them."""
import csv
import json

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

    def test_pictures_of_points_and_rods_can_be_drawn(self):
        for layers in ("cubes", "cubes,rods", "cubes,rod-forces,forces,hud,names,velocities,trails"):
            self.expect(0, "figure", self.scene(DOOR), "-o", "door.png", "--size", "320x180", "--layers", layers)
        self.expect(0, "run", self.scene(SWINGING), "-o", "frames/", "--fps", "4", "--size", "160x90", "--layers", "cubes,rod-forces")
        self.expect(0, "reproduce", "frames/frame_000002.png")


if __name__ == "__main__":
    main()
