"""What goes wrong around the program: disks, streams, ffmpeg, other people's files, work without end."""
import fcntl
import json
import math
import os
import signal
import stat
import struct
import subprocess
import time
import unittest
import zlib

from program import FLOOR, FLYING, PROGRAM, STANDING, ProgramTest, main, png_chunks

SPINNING = {"version": 1, "cube": [{"name": "a", "position": [0, 5], "spin": 1.0}]}


class Endless(ProgramTest):
    def test_what_rests_costs_nothing_however_long(self):
        self.expect(0, "run", self.scene(STANDING), "--until", "1e12", timeout=20)
        self.expect(0, "figure", self.scene(STANDING), "-t", "1e9", "-o", "f.png", "--size", "64x64", timeout=20)

    def test_more_steps_than_anybody_can_wait_for_are_refused(self):
        for command in (("run", "--until", "1"), ("figure", "-t", "1", "-o", "f.png")):
            for integrator in ("rattle", "moreau", "euler"):
                done = self.expect(2, command[0], self.scene(FLYING), *command[1:], "--integrator", integrator, "--step", "1e-300")
                self.assertIn("--step: ", done.stderr)

    def test_a_motion_that_would_never_end_says_so(self):
        thin = {"version": 1, "plane": [FLOOR, {"name": "wall", "point": [-3, 0], "normal": [1, 0]}], "material": {"restitution": 0.5},
                "cube": [{"name": "b", "position": [5, 0.8], "angle": 0.3, "velocity": [-1e12, -3], "spin": 1e9}]}
        for command in (("run", "--until", "1", "--checkpoint", "c"), ("figure", "-t", "1", "-o", "f.png")):
            done = self.expect(3, command[0], self.scene(thin), *command[1:], timeout=120)
            self.assertRegex(done.stderr, "wuerfel: stopped at .* s: with steps of .* s the way to [15] s takes more than 1e\\+09 of them")
        self.assertEqual(self.files(), ["c", "scene.json"])

    def test_what_turns_fast_takes_time_and_no_memory(self):
        for others in ((), ({"name": "b", "position": [100, 5]},)):
            scene = {"version": 1, "cube": [{**SPINNING["cube"][0], "spin": 3e6}, *others]}
            self.expect(0, "run", self.scene(scene), "--until", "1", "--max-memory", "40M")

    def test_devices_without_end_are_no_files(self):
        os.symlink("/dev/zero", self.path("zero.svg"))
        for arguments in (("reproduce", "/dev/zero"), ("reproduce", "zero.svg"), ("replay", "/dev/zero"), ("run", "demo", "--resume", "/dev/zero"),
                          ("check", "/dev/zero"), ("compare", "/dev/zero", "/dev/zero")):
            with self.subTest(arguments):
                self.expect(2, *arguments, timeout=60)

    def test_a_long_wait_is_told(self):
        process = subprocess.Popen([PROGRAM, "run", self.scene(SPINNING), "--until", "4e10"], stderr=subprocess.PIPE, text=True)
        line = process.stderr.readline()
        process.terminate()
        process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assertRegex(line, r"simulating +\d % .* left")

    def test_long_work_says_how_much_it_will_write(self):
        done = self.expect(0, "run", self.scene(STANDING), "--until", "200", "--states", "s.csv", timeout=60)
        self.assertRegex(done.stderr, r"wuerfel: 12001 frames, about \d+ MB on disk")
        done = self.expect(0, "run", self.scene(STANDING), "--until", "200", "-o", "f.apng", "--size", "16x16", timeout=60)
        self.assertRegex(done.stderr, r"wuerfel: 12001 frames, about [1-9]\d+ kB on disk")
        self.assertEqual(self.expect(0, "run", self.scene(STANDING), "--until", "200", "--states", "s.csv", "--quiet").stderr, "")

    def test_what_no_disk_holds_is_refused_before_it_begins(self):
        done = self.expect(2, "run", self.scene(FLYING), "--until", "1e3", "--size", "16384x16384", "--speed", "0.1", "-o", "f/")
        self.assertRegex(done.stderr, r"would take .* GB or more, .* has .* free; ask for less")
        self.assertFalse(os.path.exists(self.path("f")))

    def test_memory_has_the_limit_that_is_given(self):
        options = ("run", "pile", "--until", "2", "--states", "s.csv", "--checkpoint", "c", "--every", "0.1")
        done = self.expect(4, *options, "--max-memory", "1M")
        self.assertRegex(done.stderr, r"out of memory: \d+ MB are held, --max-memory allows 1 MB")
        self.assertFalse(os.path.exists(self.path("s.csv")))
        self.expect(0, "run", "pile", "--until", "0.1", "--max-memory", "4G")
        self.assertIn("'4GB'", self.expect(2, "run", "pile", "--max-memory", "4GB").stderr)
        self.assertIn("did you mean 500M?", self.expect(2, "run", "pile", "--max-memory", "500").stderr)


class Frames(ProgramTest):
    def test_frames_of_two_runs_never_lie_side_by_side(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f/", "--fps", "20", "--size", "64x64")
        process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING, "again.json"), "-o", "f/", "--fps", "500", "--until", "50", "--size", "64x64",
                                    "--view", "0,5,10", "--layers", "cubes"], cwd=self.folder, stderr=subprocess.DEVNULL)
        time.sleep(1.5)
        process.kill()
        process.wait()
        times = [float(self.time_of(name)) for name in self.files("f") if name.startswith("frame_")]
        self.assertEqual(times, [k / 500 for k in range(len(times))])

    def time_of(self, name):
        from program import png_texts
        return png_texts(self.path("f/" + name))["Simulated time"]


class Ffmpeg(ProgramTest):
    def fake(self, script):
        os.mkdir(self.path("bin"))
        with open(self.path("bin/ffmpeg"), "w") as file:
            file.write("#!/bin/sh\n" + script)
        os.chmod(self.path("bin/ffmpeg"), 0o755)
        return {**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]}

    def test_one_that_hangs_can_be_left(self):
        environment = self.fake("cat > /dev/null; exec sleep 1000\n")
        process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING), "-o", "a.mp4", "--size", "64x64", "--until", "0.1"], cwd=self.folder,
                                   env=environment, stderr=subprocess.DEVNULL)
        time.sleep(2.0)
        self.assertIsNone(process.poll())
        process.terminate()
        self.assertEqual(process.wait(timeout=10), 128 + signal.SIGTERM)
        self.assertEqual(self.files(), ["bin", "scene.json"])

    def test_one_that_is_killed_is_told(self):
        environment = self.fake("head -c 1000 > /dev/null; kill -9 $$\n")
        done = self.expect(5, "run", self.scene(FLYING), "-o", "a.mp4", "--size", "64x64", env=environment)
        self.assertIn("ffmpeg failed on a.mp4", done.stderr)
        self.assertEqual(self.files(), ["bin", "scene.json"])


class Pipes(ProgramTest):
    def setUp(self):
        super().setUp()
        os.mkfifo(self.path("pipe"))
        self.process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING), "--states", "pipe", "--fps", "2"], cwd=self.folder, stderr=subprocess.DEVNULL)
        time.sleep(0.5)

    def test_one_that_nobody_reads_can_be_left(self):
        self.assertIsNone(self.process.poll())
        self.process.terminate()
        self.assertEqual(self.process.wait(timeout=30), 128 + signal.SIGTERM)

    def test_a_late_reader_gets_all(self):
        with open(self.path("pipe")) as file:
            lines = file.read().splitlines()
        self.assertEqual(self.process.wait(timeout=30), 0)
        self.assertEqual([line.split(",")[0] for line in lines], ["t", "0", "0.5", "1"])


class Names(ProgramTest):
    def test_umlauts_and_spaces(self):
        self.scene(STANDING, "ein Türmchen (1).json")
        self.expect(0, "run", "ein Türmchen (1).json", "-o", "Bilder Ä/", "--fps", "2", "--size", "64x64", "--states", "Zustände 1.csv")
        self.assertIn("frame_000000.png", self.files("Bilder Ä"))
        self.assertIn("Zustände 1.csv", self.files())

    def test_nobody_can_wait_with_a_link_under_a_temporary_name(self):
        with open(self.path("victim"), "w") as file:
            file.write("mine")
        shell = f'ln -s victim .s.$$.part.csv; exec "{PROGRAM}" run "{self.scene(FLYING)}" --states s.csv --until 0.1'
        subprocess.run(["sh", "-c", shell], cwd=self.folder, check=True)
        self.assertEqual(self.content("victim"), "mine")
        self.assertFalse(os.path.islink(self.path("s.csv")))

    def test_what_killed_programs_left_is_removed_and_nothing_else(self):
        os.mkdir(self.path("f"))
        dead = (".s.0123456789abcdef.part.csv", "f/.frame_000007.0123456789abcdef.part.png")
        others = (".s.mine.part.csv", ".t.0123456789abcdef.part.csv", "f/.mine.0123456789abcdef.part.png", ".s.fedcba9876543210.part.csv")
        for name in dead + others:
            with open(self.path(name), "w"):
                pass
        with open(self.path(".s.fedcba9876543210.part.csv"), "a") as living:
            fcntl.flock(living, fcntl.LOCK_EX)
            self.expect(0, "run", self.scene(FLYING), "--until", "0.1", "--states", "s.csv", "-o", "f/", "--size", "64x64")
        self.assertEqual([name for name in dead + others if os.path.exists(self.path(name))], list(others))

    def test_a_written_file_replaces_one_that_is_read_only(self):
        with open(self.path("s.csv"), "w") as file:
            file.write("old")
        os.chmod(self.path("s.csv"), stat.S_IRUSR)
        self.expect(0, "run", self.scene(FLYING), "--states", "s.csv", "--until", "0.1")
        self.assertTrue(self.content("s.csv").startswith("t,body"))


class HostilePictures(ProgramTest):
    def setUp(self):
        super().setUp()
        self.expect(0, "figure", self.scene(STANDING), "-o", "good.png", "--size", "64x64")

    def altered(self, key, value):
        """good.png with another text under a key, check sums right."""
        with open(self.path("bad.png"), "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n")
            for kind, content in png_chunks(self.path("good.png")):
                if kind in ("tEXt", "zTXt", "iTXt") and content.startswith(key.encode() + b"\0"):
                    kind, content = "tEXt", key.encode() + b"\0" + value
                file.write(struct.pack(">I", len(content)) + kind.encode() + content + struct.pack(">I", zlib.crc32(kind.encode() + content)))

    def options(self):
        for kind, content in png_chunks(self.path("good.png")):
            if content.startswith(b"Options\0") or content.startswith(b"Comment\0"):
                return content.split(b"\0", 1)
        for kind, content in png_chunks(self.path("good.png")):
            if kind == "tEXt" and b"--size" in content:
                return content.split(b"\0", 1)
        self.fail("no options in the picture")

    def refuse(self, code=2):
        done = self.call("reproduce", "bad.png", timeout=30)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("\x1b", done.stderr + done.stdout)
        return done.stderr

    def test_what_it_says_of_its_size_is_checked_before_it_is_drawn(self):
        key, options = self.options()
        self.altered(key.decode(), options.replace(b"--size 64x64", b"--size 16384x16384"))
        self.assertIn("it has 64x64 pixels and says that they are 16384x16384", self.refuse())

    def test_times_and_rates_beyond_all_use_are_refused(self):
        key, options = self.options()
        for more in (b" --layers trails --fps 3e8", b" --strip 2147483647x2", b" --theme \x1b[31m"):
            text = options.replace(b"--layers", b"--zoom 1 --layers") if b"trails" not in more else options[:options.index(b"--layers")] + options[options.index(b"--theme"):]
            self.altered(key.decode(), text + more)
            with self.subTest(more):
                self.assertIn(self.call("reproduce", "bad.png", timeout=30).returncode, (1, 2))

    def test_several_times_for_one_place_are_refused(self):
        self.altered("Simulated time", b"0,1,2")
        self.assertIn("its simulated times make no sense", self.refuse())


class Replay(ProgramTest):
    PROGRAM_LINE = {"block_size": 3, "M_diag": [1, 1, 0.2], "F": [0, -9.81, 0], "J_triplets": [[0, 1, 1], [0, 2, 0.5], [1, 1, 1], [1, 2, -0.5]],
                    "b": [0, 0], "E_triplets": [], "d": []}

    def write(self, *lines):
        with open(self.path("p.jsonl"), "w") as file:
            for line in lines:
                file.write((line if isinstance(line, str) else json.dumps(line)) + "\n")

    def test_programs_are_solved_again_by_all_solvers(self):
        self.write(self.PROGRAM_LINE, self.PROGRAM_LINE)
        done = self.expect(0, "replay", "p.jsonl", "--json")
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([a["program"] for a in answers], [1, 2])
        self.assertEqual({a["solver"] for a in answers[0]["answers"]} >= {"auto", "newton", "interior-point"}, True)
        self.assertLess(answers[0]["answers"][0]["residual"], 1e-10)
        self.assertIn("program 1: 3 unknowns, 2 rows", self.expect(0, "replay", "p.jsonl").stdout)

    def test_what_is_no_program_is_refused_with_its_place(self):
        for wrong in ("nonsense", {"M_diag": []}, {**self.PROGRAM_LINE, "M_diag": [-1, 1, 1]}, {**self.PROGRAM_LINE, "J_triplets": [[0, 9, 1]]},
                      {**self.PROGRAM_LINE, "J_triplets": [[2, 1, 1]]}, {**self.PROGRAM_LINE, "J_triplets": [[0, 1e30, 1]]},
                      {**self.PROGRAM_LINE, "J_triplets": [[-1, 1, 1]]}, {**self.PROGRAM_LINE, "block_size": 1e30}):
            self.write(self.PROGRAM_LINE, wrong)
            self.assertIn("p.jsonl:2: no program: ", self.expect(2, "replay", "p.jsonl").stderr)
        self.expect(2, "replay", "nosuch.jsonl")

    def test_what_rubs_is_solved_by_coulombs_law(self):
        # A block pushed along the floor: J presses, E does not let it slide, friction 0.5.
        block = {"block_size": 3, "M_diag": [1, 1, 0.2], "F": [6, -10, 0], "J_triplets": [[0, 1, 1]], "b": [0],
                 "E_triplets": [[0, 0, 1], [1, 2, 1]], "d": [0, 0], "contacts": [[0, 0, 0.5, 0]]}
        self.write(block)
        answer = json.loads(self.expect(0, "replay", "p.jsonl", "--json").stdout)["answers"]
        self.assertEqual([a["solver"] for a in answer], ["coulomb"])
        self.assertLess(answer[0]["residual"], 1e-10)
        for wrong in ([[1, 0, 0.5, 0]], [[0, 2, 0.5, 0]], [[0, 0, -0.5, 0]], [[0, -1, 0.5, 0]], [[0, 0, 0.5, 0], [0, 1, 0.5, 0]], [7], [[0]]):
            self.write({**block, "contacts": wrong})
            self.assertIn("p.jsonl:1: no program: ", self.expect(2, "replay", "p.jsonl").stderr)

    def test_what_a_run_missed_is_kept_told_and_solved_again(self):
        # A mass of 1e12 on one of 1: more than Newton's method alone can do.
        heavy = {"version": 1, "plane": [FLOOR], "cube": [{"name": "l", "position": [0, 0.5]}, {"name": "h", "position": [0.4, 1.5], "mass": 1e12}]}
        done = self.expect(3, "run", self.scene(heavy), "--until", "0.02", "--solver", "newton", "--failed-programs", "p.jsonl", "--json", "--quiet")
        self.assertEqual(json.loads(done.stdout)["audit"]["first_violation"], {"what": "programs", "t": 0, "bodies": ["l", "h"]})
        self.assertIn("first at 0 s among l, h", done.stderr)
        replayed = [json.loads(line) for line in self.expect(3, "replay", "p.jsonl", "--json").stdout.splitlines()]
        for program in replayed:
            status = {answer["solver"]: answer["status"] for answer in program["answers"]}
            self.assertEqual(status["newton"], "inaccurate")
            self.assertEqual(status["ipopt"], "optimal")

    def test_programs_that_miss_coulombs_law_are_kept(self):
        # A heavy hit inside a jammed wall: what the solver is known not to reach. Once it does, harder ones are to be found.
        hit = {"version": 1, "material": {"friction": 2}, "plane": [FLOOR], "wall": [{"name": "w", "rows": 6, "columns": 6, "base": [0, 0]}],
               "cube": [{"name": "ball", "position": [-6.2, 3.3], "velocity": [20, 0], "mass": 200}]}
        done = self.expect(3, "run", self.scene(hit), "--until", "0.15", "--failed-programs", "p.jsonl", "--json", "--quiet")
        self.assertGreater(json.loads(done.stdout)["audit"]["friction_inexact"], 0)
        replayed = [json.loads(line) for line in self.expect(3, "replay", "p.jsonl", "--json").stdout.splitlines()]
        self.assertIn("coulomb", [answer["solver"] for program in replayed for answer in program["answers"]])

    def test_a_run_that_solves_everything_keeps_none(self):
        self.expect(0, "run", self.scene(STANDING), "--failed-programs", "p.jsonl")
        self.assertEqual(self.content("p.jsonl"), "")


class Limits(ProgramTest):
    """At the limits of doubles a verdict is undecided, never wrong."""

    def verdict(self, scene):
        return json.loads(self.call("check", self.scene(scene), "--json").stdout)["verdict"]

    def test_towers_beyond_what_doubles_hold(self):
        for count in (100, 5000):
            self.assertEqual(self.verdict({"version": 1, "plane": [FLOOR], "tower": [{"count": count, "base": [0, 0]}]}), "stands", count)
        self.assertEqual(self.verdict({"version": 1, "plane": [FLOOR], "tower": [{"count": 25000, "base": [0, 0]}]}), "undecided")

    def test_what_falls_never_stands(self):
        leaning = {"version": 1, "plane": [FLOOR], "tower": [{"count": 24000, "base": [0, 0], "lean": 6e-5}]}
        plank = {"version": 1, "plane": [FLOOR], "cube": [{"position": [0, 0.5]}, {"size": [1e8, 1], "position": [0.6, 1.5]}]}
        for scene in (leaning, plank):
            self.assertIn(self.verdict(scene), ("falls", "undecided"))
        plank["cube"][1]["position"][0] = 0.4
        self.assertIn(self.verdict(plank), ("stands", "undecided"))

    def test_mass_ratios(self):
        for ratio in (1e6, 1e9):
            pair = [{"name": "l", "position": [0, 0.5]}, {"name": "h", "position": [0, 1.5], "mass": ratio}]
            self.assertEqual(self.verdict({"version": 1, "plane": [FLOOR], "cube": pair}), "stands", ratio)
        for offset in (0.0, 0.6):
            pair = [{"name": "l", "position": [0, 0.5]}, {"name": "h", "position": [offset, 1.5], "mass": 1e14}]
            expected = ("stands", "undecided") if offset == 0.0 else ("falls", "undecided")
            self.assertIn(self.verdict({"version": 1, "plane": [FLOOR], "cube": pair}), expected)

    def test_light_bodies_beside_heavy_ones_have_forces_as_exact_as_theirs(self):
        light, lighter, off = 1.97e-6, 1e-9, 0.2
        scene = {"version": 1, "plane": [FLOOR], "cube": [{"name": "h", "position": [0, 0.5], "mass": 5e5}, {"name": "l", "position": [0, 1.5], "mass": light},
                                                            {"name": "m", "position": [off, 2.5], "mass": lighter}]}
        for contact in json.loads(self.expect(0, "check", self.scene(scene), "--json").stdout)["contacts"]:
            # l stands from -0.5 to 0.5, m on it from off - 0.5 to 0.5.
            x = contact["point"][0]
            exact = {"lh": 9.81 * (light / 2 + lighter * (0.5 + math.copysign(off, x))),
                     "ml": 9.81 * lighter * (0.5 if x > 0 else 0.5 - off) / (1 - off)}.get(contact["on"] + contact["from"])
            if exact is not None:
                self.assertAlmostEqual(contact["force"] / exact, 1, delta=1e-9)
                self.assertTrue(contact["unique"])

    def test_far_from_the_origin_the_coordinates_are_named(self):
        scene = {"version": 1, "plane": [{"name": "f", "point": [1e7, 1e7], "normal": [0, 1]}],
                 "tower": [{"count": 8, "size": [1, 0.3], "on": "f", "lean": 0.01}]}
        self.assertIn("coordinates of 1e+07 m have no digits below 2e-09 m", self.expect(2, "check", self.scene(scene)).stderr)


class Strict(ProgramTest):
    def test_a_run_within_the_budget_goes_through(self):
        self.assertEqual(self.summary(STANDING, "--strict")["t_end"], 0.1)

    def test_the_first_violation_is_told_and_ends_a_strict_run(self):
        # Steps as long as they like, for a tolerance that allows nearly all, turn the rods too far.
        coarse = ("double_pendulum", "--until", "2", "--integrator", "rattle", "--step", "1", "--tolerance", "0.9", "--json", "--quiet")
        done = self.expect(3, "run", *coarse, "--fps", "50", "--states", "s.csv")
        self.assertIn("over the error budget: energy drifted by", done.stderr)
        first = json.loads(done.stdout)["audit"]["first_violation"]
        self.assertEqual(first["what"], "energy")
        self.assertIn(f"first at {first['t']:.6g} s", done.stderr)
        strict = json.loads(self.expect(3, "run", *coarse, "--strict").stdout)
        self.assertLess(strict["t_end"], 2.0)
        self.assertAlmostEqual(strict["t_end"], first["t"], delta=0.021)


if __name__ == "__main__":
    main()
