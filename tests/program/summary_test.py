"""What `run` reports: the JSON summary, samples, tables, and where they go."""
import csv
import glob
import json
import math
import os
import subprocess
import sys

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.append(os.path.join(TESTS, "stress"))

import overlap  # noqa: E402
from program import FALLING, FLYING, FLYING_TOML, LANDING, STANDING, ProgramTest, main  # noqa: E402


class Summary(ProgramTest):
    def test_the_keys_are_those_of_the_contract(self):
        s = self.summary(LANDING, "--sample", "0")
        self.assertEqual(list(s), ["version", "scene", "settings", "t_end", "samples", "events", "audit", "notes", "outcome", "cost"])
        self.assertEqual(set(s["scene"]), {"title", "hash"})
        self.assertEqual(set(s["settings"]), {"integrator", "formulation", "solver", "tolerance", "step"})
        self.assertEqual(set(s["audit"]), {"max_penetration", "max_rod_error", "max_kkt_residual", "unresolved", "searches_given_up", "wedged", "friction_inexact",
                                            "friction_residual", "restitution_reduced", "rods_contradicting", "momentum", "momentum_settled", "energy", "state_hash"})
        self.assertEqual(set(s["audit"]["momentum"]), {"linear", "angular"})
        self.assertEqual(set(s["audit"]["energy"]), {"start", "end", "impact_loss", "friction_loss", "drift"})
        self.assertEqual(set(s["outcome"]), {"moved", "at_rest"})
        self.assertEqual(set(s["cost"]), {"wall_s", "cpu_s", "start_s", "steps", "qp_solves", "qp_skipped", "frames",
                                          "frames_reused", "hand_overs", "skipped"})
        self.assertEqual(set(s["cost"]["skipped"]), {"free", "rest", "certificate"})
        self.assertEqual(sum(s["cost"]["skipped"].values()), s["cost"]["qp_skipped"])
        self.assertEqual(set(s["samples"][0]["bodies"]["a"]), {"x", "y", "theta", "vx", "vy", "omega"})
        self.assertEqual(set(s["events"][0]), {"t", "kind", "bodies", "point", "impulse"})

    def test_the_values_are_those_of_the_scene(self):
        s = self.summary(LANDING, "--step", "0.01", "--integrator", "euler")
        self.assertEqual(s["scene"]["title"], "landing")
        self.assertEqual(s["t_end"], 0.05)
        self.assertEqual((s["settings"]["integrator"], s["settings"]["step"]), ("euler", 0.01))
        self.assertEqual(s["cost"]["frames"], 0)
        self.assertAlmostEqual(s["audit"]["energy"]["impact_loss"], 2.0, delta=1e-6)  # m v^2 / 2
        self.assertEqual(s["events"][0]["kind"], "impact")
        self.assertEqual(set(s["events"][0]["bodies"]), {"a", "floor"})
        self.assertGreater(s["cost"]["start_s"], 0.0)

    def test_who_moved_and_who_rests_is_told(self):
        self.assertEqual(self.summary(STANDING)["outcome"], {"moved": [], "at_rest": True})
        outcome = self.summary(FALLING)["outcome"]
        self.assertIn("b", outcome["moved"])
        self.assertFalse(outcome["at_rest"])

    def test_the_hash_names_the_scene_whatever_it_is_written_in(self):
        from_json = self.summary(FLYING)["scene"]["hash"]
        with open(self.path("scene.toml"), "w") as file:
            file.write(FLYING_TOML)
        from_toml = json.loads(self.expect(0, "run", "scene.toml", "--json").stdout)["scene"]["hash"]
        self.assertEqual(from_json, from_toml)
        self.assertNotEqual(from_json, self.summary(FLYING, "--set", "cube.a.angle=0.1")["scene"]["hash"])

    def test_the_same_run_reports_the_same(self):
        first, second = (self.summary(FALLING, "--sample", "0.05") for _ in range(2))
        first.pop("cost"), second.pop("cost")
        self.assertEqual(first, second)


    def test_who_looks_changes_nothing_of_it(self):
        alone = self.summary(FALLING)
        for looks in (("-o", "f/", "--size", "64x36", "--fps", "7"), ("--forces", "forces.csv", "--fps", "90"), ("--states", "s.csv")):
            with self.subTest(looks):
                watched = self.summary(FALLING, *looks)
                forces = watched.pop("forces", None)
                self.assertEqual(forces is not None, "--forces" in looks)
                for key in ("wall_s", "cpu_s", "start_s", "frames", "frames_reused"):
                    alone["cost"][key] = watched["cost"][key] = 0
                self.assertEqual(watched, alone)

    def test_forces_come_with_their_residual(self):
        s = self.summary(STANDING, "--forces", "forces.csv")
        self.assertLessEqual(s["forces"]["max_kkt_residual"], 1e-12)
        with open(self.path("forces.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(max(float(r["kkt_residual"]) for r in rows), s["forces"]["max_kkt_residual"])


class Samples(ProgramTest):
    def test_times_come_back_exactly_as_asked_in_order_and_once(self):
        asked = "0.7,0.1,0.30000000000000004,0.1,0,1,0.123456789012345678"
        samples = self.summary(FLYING, "--sample", asked)["samples"]
        self.assertEqual([s["t"] for s in samples], [0, 0.1, 0.123456789012345678, 0.30000000000000004, 0.7, 1])
        for s in samples:
            self.assertAlmostEqual(s["bodies"]["a"]["x"], s["t"], delta=1e-12)

    def test_the_option_can_be_repeated(self):
        samples = self.summary(FLYING, "--sample", "0.5", "--sample", "0.25")["samples"]
        self.assertEqual([s["t"] for s in samples], [0.25, 0.5])

    def test_looking_does_not_change_the_motion(self):
        alone = self.summary(FALLING, "--sample", "0.1")["samples"]
        often = self.summary(FALLING, "--sample", "0.001,0.0333,0.07,0.1")["samples"]
        self.assertEqual(alone[-1], often[-1])

    def test_a_run_of_no_length_shows_the_state_after_the_impact_at_the_start(self):
        s = self.summary(LANDING, "--until", "0", "--sample", "0")
        self.assertEqual(s["t_end"], 0)
        self.assertAlmostEqual(s["samples"][0]["bodies"]["a"]["vy"], 0.0, delta=1e-9)

    def test_until_may_go_beyond_the_duration(self):
        self.assertEqual(self.summary(FLYING, "--until", "2", "--sample", "2")["t_end"], 2)


class Streams(ProgramTest):
    def test_a_scene_comes_from_standard_input_in_both_languages(self):
        for text in (json.dumps(FLYING), "\n  " + json.dumps(FLYING), FLYING_TOML):
            done = self.expect(0, "run", "-", "--json", input=text)
            self.assertEqual(json.loads(done.stdout)["scene"]["title"], "flying")

    def test_data_goes_to_stdout_and_notes_to_stderr_and_into_the_summary(self):
        for quiet in ((), ("--quiet",)):
            done = self.expect(0, "run", self.scene(FLYING), "--json", "--fps", "30", *quiet)
            self.assertEqual(json.loads(done.stdout)["notes"], ["--fps does nothing without -o, --states or --forces"])
            self.assertEqual("--fps does nothing" in done.stderr, not quiet)

    def test_nothing_to_note_is_an_empty_list(self):
        self.assertEqual(self.summary(FLYING)["notes"], [])

    def test_options_that_do_nothing_are_noted(self):
        for arguments, words in ((("--size", "64x64"), "--size does nothing without -o"),
                                 (("-o", "f/", "--rod-scale", "2"), "without the layer rod-forces"),
                                 (("-o", "f/", "--layers", "cubes", "--legend", "cut"), "--legend does nothing without the layer hud"),
                                 (("--threads", "2"), "--threads does nothing for one scene"),
                                 (("-o", "f.apng", "--encoder", "libpng"), "without a folder"),
                                 (("-o", "f.mp4", "--size", "65x64"), "f.mp4 is 66x64"),
                                 (("-o", "f.mp4", "--theme", "transparent"), "no transparency")):
            with self.subTest(arguments):
                notes = self.summary(FLYING, "--until", "0.05", *arguments)["notes"]
                self.assertTrue(any(words in note for note in notes), notes)

    def test_samples_that_nobody_gets_are_noted(self):
        sampled = ("run", self.scene(FLYING), "--until", "0.05", "--sample", "0.05")
        self.assertIn("--sample does nothing without --json or --summary", self.expect(0, *sampled).stderr)
        self.assertEqual(self.expect(0, *sampled, "--summary", "s.json").stderr, "")

    def test_the_summary_goes_to_a_file_too(self):
        s = self.summary(FLYING, "--summary", "s.json")
        with open(self.path("s.json")) as file:
            self.assertEqual(json.load(file), s)
        self.assertEqual(self.expect(0, "run", "scene.json", "--summary", "-").stdout[0], "{")


class SeveralScenes(ProgramTest):
    def test_each_is_answered_on_a_line_in_order(self):
        files = [self.scene(scene, f"{k}.json") for k, scene in enumerate((STANDING, FALLING, FLYING))]
        lines = self.expect(1, "check", *files, "--json").stdout.splitlines()
        self.assertEqual([json.loads(line)["verdict"] for line in lines], ["stands", "falls", "moves"])
        lines = self.expect(0, "run", *files, "--json", "--until", "0.01").stdout.splitlines()
        self.assertEqual([json.loads(line)["scene"]["title"] for line in lines], ["standing", "falling", "flying"])

    def test_standard_input_may_have_one_json_scene_a_line(self):
        text = "\n".join(json.dumps(scene) for scene in (STANDING, FALLING)) + "\n\n"
        lines = self.expect(1, "check", "-", "--json", input=text).stdout.splitlines()
        self.assertEqual([json.loads(line)["verdict"] for line in lines], ["stands", "falls"])
        lines = self.expect(1, "check", "-", input=text).stdout.splitlines()
        self.assertEqual(lines, ["standard input, scene 1: stands", "standard input, scene 2: falls"])

    def test_a_document_of_many_lines_is_one_scene(self):
        self.assertEqual(self.expect(0, "check", "-", input=json.dumps(STANDING, indent=1)).stdout.split()[0], "stands")
        done = self.expect(2, "check", "-", input="\n\nversion = 1\nsize = 1\n")
        self.assertIn("standard input:4:", done.stderr)  # lines are counted from the first

    def test_what_fails_is_an_error_of_its_own(self):
        text = "\n".join((json.dumps(STANDING), '{"version": 1, "cube": []}', "{", json.dumps(FALLING)))
        done = self.expect(2, "check", "-", "--json", input=text)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([list(answer)[0] for answer in answers], ["verdict", "error", "error", "verdict"])
        self.assertIn("scene 2", answers[1]["error"])
        answers = self.expect(2, "check", self.scene(STANDING), "nowhere.toml", self.scene(STANDING), "--json").stdout
        self.assertEqual(len(answers.splitlines()), 3)

    def test_overrides_hold_for_all(self):
        text = "\n".join([json.dumps(FALLING)] * 2)
        lines = self.expect(0, "check", "-", "--set", "cube.b.position=[0.4,1.5]", input=text).stdout.splitlines()
        self.assertTrue(all(line.endswith(": stands") for line in lines), lines)

    def test_files_are_for_one_scene(self):
        self.expect(2, "run", self.scene(FLYING), self.scene(STANDING, "b.json"), "--states", "s.csv")
        self.assertEqual(self.files(), ["b.json", "scene.json"])

    def test_a_scene_is_answered_before_the_next_is_there(self):
        process = subprocess.Popen([self.program, "check", "-", "--json"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        process.stdin.write((json.dumps(STANDING) + "\n") * 2)
        process.stdin.flush()
        self.assertEqual(json.loads(process.stdout.readline())["verdict"], "stands")
        process.communicate()


class Tables(ProgramTest):
    def test_steps_without_friction_have_forces_without_friction(self):
        scene = self.scene({**STANDING, "material": {"friction": 0.5, "restitution": 0.5}, "cube": [{**STANDING["cube"][0], "velocity": [2, 0]}]})
        for integrator in ("moreau", "symplectic", "euler"):
            with self.subTest(integrator):
                self.expect(0, "run", scene, "--until", "0.1", "--integrator", integrator, "--forces", "f.csv")
                with open(self.path("f.csv")) as file:
                    self.assertEqual({row["kind"] for row in csv.DictReader(file)}, {"contact"})

    def rows(self, name):
        with open(self.path(name), newline="") as file:
            return list(csv.DictReader(file))

    def test_states_are_written_at_every_frame_time(self):
        self.expect(0, "run", self.scene(FALLING), "--fps", "30", "--states", "states.csv")
        rows = self.rows("states.csv")
        self.assertEqual([(float(r["t"]), r["body"]) for r in rows],
                         [(k / 30, body) for k in range(4) for body in ("a", "b")])
        self.assertEqual(list(rows[0]), ["t", "body", "x", "y", "theta", "vx", "vy", "omega"])

    def test_numbers_in_tables_have_all_their_digits(self):
        self.expect(0, "run", self.scene(FLYING), "--fps", "7", "--states", "states.csv")
        sample = self.summary(FLYING, "--sample", repr(3 / 7))["samples"][0]["bodies"]["a"]
        row = self.rows("states.csv")[3]
        self.assertEqual({key: float(row[key]) for key in sample}, sample)

    def test_forces_carry_the_weight(self):
        self.expect(0, "run", self.scene(STANDING), "--fps", "10", "--forces", "forces.csv")
        rows = self.rows("forces.csv")
        for t in {r["t"] for r in rows}:
            lift = sum(float(r["fy"]) for r in rows if r["t"] == t)
            self.assertAlmostEqual(lift, 9.81, delta=1e-5)

    def test_forces_tell_who_pushes_whom(self):
        scene = {"version": 1, "plane": [{"name": "floor"}], "fixed": [{"name": "post", "size": 1, "position": [3, 0.5]}],
                 "cube": [{"name": "low", "on": "floor"}, {"name": "high, up", "on": "low"}, {"name": "cap", "on": "post"},
                          {"name": "bob", "size": 0.2, "position": [3, 4]}],
                 "rod": [{"from": [3, 5], "to": "bob"}]}
        self.expect(0, "run", self.scene(scene), "--until", "0", "--forces", "forces.csv")
        rows = self.rows("forces.csv")
        self.assertEqual(list(rows[0]), ["t", "on", "from", "kind", "x", "y", "fx", "fy", "kkt_residual"])
        self.assertEqual({(row["on"], row["from"], row["kind"]) for row in rows},
                         {("low", "floor", "contact"), ("high, up", "low", "contact"), ("cap", "post", "contact"),
                          ("bob", "", "rod_tension")})
        self.assertNotIn("-0", {row[key] for row in rows for key in ("fx", "fy")})

    def test_events_are_lines_of_json(self):
        s = self.summary(LANDING, "--events", "events.jsonl")
        with open(self.path("events.jsonl")) as file:
            self.assertEqual([json.loads(line) for line in file], s["events"])

    def test_a_table_can_go_to_standard_output(self):
        done = self.expect(0, "run", self.scene(FLYING), "--states", "-", "--fps", "1")
        self.assertEqual(done.stdout.splitlines()[0], "t,body,x,y,theta,vx,vy,omega")
        self.assertEqual(len(done.stdout.splitlines()), 3)

    def test_states_are_the_same_bits_on_every_kind_of_processor(self):
        # The C library then takes the sine, cosine and square root of older processors.
        older = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2"}
        self.expect(0, "run", "demo", "--until", "1.5", "--states", "here.csv", "--quiet")
        self.expect(0, "run", "demo", "--until", "1.5", "--states", "older.csv", "--quiet", env=older)
        self.assertEqual(self.content("here.csv"), self.content("older.csv"))
        self.assertGreater(len(self.content("here.csv")), 10000)

    def test_every_shipped_scene_runs_to_its_end_exactly(self):
        names = [line.split()[0] for line in self.expect(0, "scenes").stdout.splitlines()]
        self.assertIn("demo", names)
        for name in names:
            with self.subTest(name):
                s = json.loads(self.expect(0, "run", name, "--json", "--quiet").stdout)
                self.assertLessEqual(s["audit"]["max_kkt_residual"], 1e-10)
                self.assertLessEqual(s["audit"]["max_penetration"], 1e-9)
                self.assertLessEqual(s["audit"]["max_rod_error"], 1e-12)


class Books(ProgramTest):
    def test_they_close_at_every_look_where_a_pile_bounces_and_rubs(self):
        # Looks within steps in which one cube strikes several others.
        for count, seed, friction, restitution in ((7, 3, 0.3, 0.5), (9, 1, 0.3, 0.5), (9, 4, 0.3, 0.5), (12, 3, 0.0, 0.7)):
            with self.subTest((count, seed)):
                wall = {"size": [1, 40]}
                scene = {"version": 1, "material": {"friction": friction, "restitution": restitution}, "plane": [{"name": "floor"}],
                         "fixed": [{"name": "left", "position": [-2.5, 20], **wall}, {"name": "right", "position": [2.5, 20], **wall}],
                         "pile": [{"count": count, "size": 0.7, "seed": seed, "region": [-1.9, 0.1, 1.9, 12]}]}
                self.expect(0, "run", self.scene(scene), "--until", "2", "--fps", "60", "--states", "s.csv", "--quiet")

    def test_they_close_at_every_look_where_a_tower_bounces(self):
        # Looks within steps in which planks rock from corner to corner, slower than an impact.
        planks = ((1, 1, 0, 0.5), (1.5, 0.5, 0, 1.25), (0.5, 0.5, 0.3088888984323831, 1.75),
                  (1.5, 0.5, -0.15291487897597011, 2.25), (1, 1, -0.15291487897597011, 3.0))
        cubes = [{"name": f"c{k}", "size": [w, h], "position": [x, y]} for k, (w, h, x, y) in enumerate(planks)]
        scene = {"version": 1, "material": {"restitution": 0.8}, "plane": [{"name": "floor"}], "cube": cubes}
        self.expect(0, "run", self.scene(scene), "--until", "2", "--fps", "60", "--states", "s.csv", "--quiet")

    def test_they_close_where_light_cubes_carry_heavy_ones(self):
        # An event a moment behind a step of 1e-16 s: no polynomial may be followed that far.
        heavy, light = 3794.7689254228235, 0.0002635206568970671
        stack = ((0.2999908798122497, 0.5, 1, 1, heavy), (0.2999908798122497, 1.25, 1.5, 0.5, light), (0.4246051036725459, 1.75, 0.5, 0.5, 1),
                 (0.8778315328760202, 2.5, 1, 1, light), (1.3602974572166775, 3.25, 1.5, 0.5, heavy), (1.3602974572166775, 4.0, 1, 1, light))
        cubes = [{"name": f"c{k}", "size": [w, h], "mass": m, "position": [x, y]} for k, (x, y, w, h, m) in enumerate(stack)]
        scene = {"version": 1, "material": {"friction": 0.5}, "plane": [{"name": "floor"}], "cube": cubes}
        energy = self.summary(scene, "--until", "0.2")["audit"]["energy"]
        self.assertLess(abs(energy["drift"]), 1e-3)
        self.assertLess(energy["friction_loss"], energy["start"])

    def test_fixed_bodies_carry_what_rests_beside_what_is_hit(self):
        # Its rest was certified by steps before, so that no forces are at hand.
        s = json.loads(self.expect(0, "run", "wall_hit", "--integrator", "moreau", "--until", "1", "--json").stdout)
        self.assertLess(s["audit"]["momentum"]["linear"], 1e-9)

    def test_they_close_where_all_that_bounces_slides_as_one(self):
        # Nothing moves but along the floor, which rubs: it pays for what a step would gain, and no step is halved for it.
        cubes = [{"name": "below", "position": [0, 0.5], "velocity": [-2.109113567713827, 0]}, {"name": "above", "position": [0, 1.5]}]
        scene = {"version": 1, "duration": 1.0, "material": {"friction": 0.6, "restitution": 0.9}, "plane": [{"name": "floor"}], "cube": cubes}
        s = self.summary(scene)
        self.assertLess(abs(s["audit"]["energy"]["drift"]), 1e-9)
        self.assertLess(s["cost"]["steps"], 400)


def energy(scene, sample):
    """(J, of which in motion)"""
    moving = height = 0.0
    for c in scene["cube"]:
        b = sample["bodies"][c["name"]]
        (w, h), m = c["size"], c["mass"]
        moving += 0.5 * m * (b["vx"]**2 + b["vy"]**2) + m * (w * w + h * h) / 24 * b["omega"]**2
        height += m * 9.81 * b["y"]
    return moving + height, moving


class LooksWithinSteps(ProgramTest):
    def test_no_energy_rises_and_nothing_overlaps(self):
        for file in sorted(glob.glob(os.path.join(TESTS, "data", "looks", "*.json"))):
            with self.subTest(os.path.basename(file)), open(file) as text:
                case = json.load(text)
                scene, fps = case["scene"], case["fps"]
                times = [k / fps for k in range(math.ceil(case["from"] * fps), math.floor(case["to"] * fps) + 1)]
                samples = self.summary(scene, "--until", "3", "--sample", ",".join(map(repr, times)))["samples"]
                side = min(min(c["size"]) for c in scene["cube"])
                most = max(energy(scene, s)[1] for s in samples)
                for before, now in zip(samples, samples[1:]):
                    self.assertLessEqual(energy(scene, now)[0] - energy(scene, before)[0], 1e-6 * most)
                    self.assertLessEqual(overlap.deepest(scene, now), 1e-9 * side)


if __name__ == "__main__":
    main()
