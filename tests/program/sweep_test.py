"""Data sets: plans, shards, resumed runs, merged bytes, and what is refused."""
import csv
import hashlib
import io
import json
import os
import random
import signal
import struct
import subprocess
import tarfile
import time
import zipfile
import zlib

from program import ProgramTest, main

SWEEP = """
version = 1
name = "towers"
seed = 7
cases = 24
[scene]
duration = 0.4
plane = [{}]
tower = [{ name = "t", count = 3, base = [0.0, 0.0] }]
[[vary]]
key = "tower.t.lean"
uniform = [-0.6, 0.6]
[[vary]]
key = "tower.t.count"
integers = [2, 4]
[split]
validation = 0.25
held_out = [{ key = "tower.t.count", values = [4] }]
[labels]
check = ["verdict", "contacts", "margin", "weakest", "causes"]
[labels.run]
columns = ["time_of_fall", "moved", "at_rest", "final_height", "first_event", "first_event_time", "events"]
[output]
states = { fps = 10 }
"""
PICTURES = "first_frame = true\nlayers = \"cubes,forces\"\nmasks = [\"instance\"]\nsize = [64, 48]\n"


def digest(folder):
    """Every file of a folder by the hash of its bytes."""
    sums = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                sums[os.path.relpath(path, folder)] = hashlib.sha256(file.read()).hexdigest()
    return sums


def npy(data):
    """(dtype, shape, bytes) of an NPY file."""
    length = struct.unpack("<H", data[8:10])[0]
    head = eval(data[10:10 + length], {})  # a literal, by the format
    return head["descr"], head["shape"], data[10 + length:]


def gray_pixels(png):
    """Numbers of an 8-bit grey PNG without filters, row by row."""
    width, height = struct.unpack(">II", png[16:24])
    start = png.index(b"IDAT")
    rows = zlib.decompress(png[start + 4:start + 4 + struct.unpack(">I", png[start - 4:start])[0]])
    return [value for y in range(height) for value in rows[y * (width + 1) + 1:(y + 1) * (width + 1)]]


class Sweep(ProgramTest):
    def sweep(self, text=SWEEP, name="sweep.toml"):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def plan(self, text=SWEEP, folder="plan", *arguments):
        self.expect(0, "sweep", "plan", self.sweep(text), "-o", folder, *arguments)
        return folder

    def manifest(self, folder="plan"):
        return [json.loads(line) for line in self.content(f"{folder}/manifest.jsonl").splitlines()]

    def merged(self, plan, folder):
        self.expect(0, "sweep", "merge", plan, "-o", folder)
        return digest(self.path(folder))

    def refused(self, message, text, code=2):
        done = self.expect(code, "sweep", "plan", self.sweep(text), "-o", "never")
        self.assertIn(message, done.stderr)
        self.assertNotIn("never", self.files())


class Plans(Sweep):
    def test_a_plan_is_the_same_for_any_number_of_threads(self):
        self.plan(SWEEP, "one", "--jobs", "1")
        self.plan(SWEEP, "three", "--jobs", "3")
        self.assertEqual(digest(self.path("one")), digest(self.path("three")))

    def test_cases_have_distinct_ids_and_keep_them_and_their_split_when_more_are_asked_for(self):
        few = self.manifest(self.plan())
        more = self.manifest(self.plan(SWEEP, "more", "--cases", "48"))
        self.assertEqual(more[:24], few)
        self.assertEqual(len({case["id"] for case in more}), 48)
        self.assertEqual({case["split"] for case in more if case["values"]["tower.t.count"] == 4}, {"test_ood"})
        self.assertNotIn("test_ood", {case["split"] for case in more if case["values"]["tower.t.count"] != 4})

    def test_another_seed_and_another_name_give_other_ids(self):
        first = {case["id"] for case in self.manifest(self.plan())}
        for k, text in enumerate((SWEEP.replace("seed = 7", "seed = 8"), SWEEP.replace('"towers"', '"others"'))):
            self.assertFalse(first & {case["id"] for case in self.manifest(self.plan(text, f"other{k}"))})

    def test_values_are_those_of_their_distributions(self):
        text = """
name = "all"
cases = 400
scene = "tower"
[[vary]]
key = "gravity"
choice = [[0.0, -9.81], [0.0, -1.62]]
[[vary]]
key = "duration"
log_uniform = [0.01, 10.0]
[[vary]]
key = "material.friction"
normal = [0.5, 0.2]
clip = [0.0, 0.9]
"""
        cases = [case["values"] for case in self.manifest(self.plan(text))]
        self.assertEqual({tuple(case["gravity"]) for case in cases}, {(0.0, -9.81), (0.0, -1.62)})
        durations = sorted(case["duration"] for case in cases)
        self.assertTrue(0.01 <= durations[0] and durations[-1] <= 10.0)
        self.assertTrue(0.2 < durations[200] < 0.5)  # the median of 0.01 .. 10 is 0.316
        friction = [case["material.friction"] for case in cases]
        self.assertTrue(0.0 <= min(friction) and max(friction) == 0.9)
        self.assertAlmostEqual(sum(friction) / 400, 0.5, delta=0.05)

    def test_a_latin_hypercube_meets_every_stratum_once(self):
        text = SWEEP.replace("cases = 24", 'cases = 24\nsampling = "latin"')
        values = sorted(case["values"]["tower.t.lean"] for case in self.manifest(self.plan(text)))
        for k, value in enumerate(values):
            self.assertTrue(-0.6 + 0.05 * k <= value <= -0.6 + 0.05 * (k + 1), (k, value))

    def test_a_grid_has_every_combination_once(self):
        text = """
name = "grid"
sampling = "grid"
[scene]
plane = [{}]
cube = [{ name = "a", position = [0.0, 5.0] }, { name = "b", position = [3.0, 5.0] }]
[[vary]]
key = "cube.*.angle"
values = [0.0, 0.1, 0.2]
[[vary]]
key = "material.friction"
choice = [0.0, 0.5]
"""
        values = [tuple(case["values"].values()) for case in self.manifest(self.plan(text))]
        self.assertEqual(values, [(a, f) for a in (0.0, 0.1, 0.2) for f in (0.0, 0.5)])

    def test_every_element_has_a_value_of_its_own(self):
        text = """
name = "each"
cases = 5
[scene]
plane = [{}]
cube = [{ name = "a", position = [0.0, 5.0] }, { name = "b", position = [3.0, 5.0] }]
[[vary]]
key = "cube.*.mass"
uniform = [1.0, 2.0]
"""
        for case in self.manifest(self.plan(text)):
            self.assertEqual(set(case["values"]), {"cube.1.mass", "cube.2.mass"})
            self.assertNotEqual(*case["values"].values())

    def test_overlapping_scenes_and_unwanted_verdicts_are_drawn_again(self):
        text = """
name = "two"
cases = 20
[scene]
plane = [{}]
cube = [{ name = "a", on = "plane1" }, { name = "b", on = "plane1" }]
[[vary]]
key = "cube.b.offset"
uniform = [-3.0, 3.0]
[reject]
verdicts = ["falls"]
"""
        cases = self.manifest(self.plan(text))
        self.assertEqual(len(cases), 20)
        self.assertTrue(all(abs(case["values"]["cube.b.offset"]) >= 1.0 for case in cases))
        self.assertGreater(json.loads(self.content("plan/plan.json"))["rejected"]["overlapping"], 0)
        self.refused("overlap", text.replace("[reject]", "[reject]\noverlapping = false"))

    def test_labels_are_balanced(self):
        text = SWEEP.replace("cases = 24", "") + "[balance]\nstands = 10\nfalls = 5\n"
        self.plan(text)
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        with open(self.path("data/labels.csv")) as file:
            verdicts = [row["verdict"] for row in csv.DictReader(file)]
        self.assertEqual((verdicts.count("stands"), verdicts.count("falls")), (10, 5))

    def test_another_number_of_cases_than_that_of_the_balance_is_refused(self):
        with open(self.path("both.toml"), "w") as file:
            file.write(SWEEP + "[balance]\nstands = 10\nfalls = 5\n")
        self.assertIn("cases: is 24, but [balance] makes 15; leave cases out", self.expect(2, "sweep", "plan", "both.toml", "--dry-run").stderr)

    def test_a_balanced_sweep_of_another_number_keeps_its_proportions_and_cases(self):
        text = SWEEP.replace("cases = 24", "") + "[balance]\nstands = 10\nfalls = 5\n"
        self.plan(text, "all")
        self.plan(text, "few", "--cases", "7")
        self.expect(0, "sweep", "run", "few")
        self.merged("few", "data")
        with open(self.path("data/labels.csv")) as file:
            verdicts = [row["verdict"] for row in csv.DictReader(file)]
        self.assertEqual((verdicts.count("stands"), verdicts.count("falls")), (5, 2))
        self.assertLessEqual({case["id"] for case in self.manifest("few")}, {case["id"] for case in self.manifest("all")})

    def test_another_number_is_taken_where_the_file_gives_the_number_beside_the_balance(self):
        self.plan(SWEEP + "[balance]\nstands = 16\nfalls = 8\n", "few", "--cases", "6")
        self.assertEqual(len(self.manifest("few")), 6)

    def test_a_long_plan_tells_how_far_it_is(self):
        text = SWEEP.replace("cases = 24", "cases = 20000").replace("[labels]", "[reject]\nmargin_below = 1e-3\n[labels]")
        with subprocess.Popen([self.program, "sweep", "plan", self.sweep(text), "--dry-run", "--jobs", "1"], stderr=subprocess.PIPE, text=True) as process:
            line = process.stderr.readline()
            process.terminate()
        self.assertRegex(line, r"^drawing +\d+ %  \d+ of 20000 cases  \d+ cases/s")

    def test_a_dry_run_writes_nothing(self):
        done = self.expect(0, "sweep", "plan", self.sweep(), "--dry-run")
        self.assertIn("24 cases", done.stderr)
        self.assertEqual(self.files(), ["sweep.toml"])

    def test_scenes_lie_beside_the_sweep_file_or_come_along(self):
        os.mkdir(self.path("sub"))
        with open(self.path("sub/mine.toml"), "w") as file:
            file.write('[[plane]]\n[[cube]]\nname = "a"\nposition = [0.0, 0.5]\n')
        text = 'name = "x"\ncases = 3\nscene = "mine.toml"\n[[vary]]\nkey = "cube.a.mass"\nuniform = [1.0, 2.0]\n'
        self.expect(0, "sweep", "plan", self.sweep(text, "sub/s.toml"), "-o", "plan")
        os.remove(self.path("sub/mine.toml"))
        self.expect(0, "sweep", "run", "plan")

    def test_bad_sweep_files_are_refused_with_place_and_suggestion(self):
        self.refused('sweep.toml:3:1: unknown key "sed"; did you mean "seed"?', SWEEP.replace("seed = 7", "sed = 7").lstrip())
        self.refused('sweep.toml:10: vary[1]: tower.x.lean=', SWEEP.replace("tower.t.lean", "tower.x.lean"))
        self.refused('sweep.toml:13: vary[2]: tower.t.count=', SWEEP.replace("integers = [2, 4]", "integers = [-4, -2]"))
        self.refused('vary[1]', SWEEP.replace("uniform = [-0.6, 0.6]", "uniform = [0.6, -0.6]"))
        self.refused("low <= high", SWEEP.replace("uniform = [-0.6, 0.6]", "uniform = [0.6, -0.6]"))
        self.refused("both ends must be greater than 0", SWEEP.replace("uniform = [-0.6, 0.6]", "log_uniform = [0.0, 1.0]"))
        self.refused("standard deviation", SWEEP.replace("uniform = [-0.6, 0.6]", "normal = [0.0, 0.0]"))
        self.refused("normal: must be two numbers, not 1", SWEEP.replace("uniform = [-0.6, 0.6]", "normal = 1"))
        self.refused("must be greater than 0; it is -", SWEEP.replace("tower.t.lean", "tower.t.mass").replace("uniform = [-0.6, 0.6]", "normal = [1.0, 0.6]"))
        self.refused("; normal has no ends where clip = [low, high] sets none", SWEEP.replace("tower.t.lean", "tower.t.mass").replace("uniform = [-0.6, 0.6]", "normal = [1.0, 0.6]"))
        self.refused("must not be empty", SWEEP.replace("uniform = [-0.6, 0.6]", "choice = []"))
        self.refused("needs uniform or normal", SWEEP.replace("uniform = [-0.6, 0.6]", ""))
        self.refused("cannot be given together", SWEEP.replace("uniform = [-0.6, 0.6]", "uniform = [0.0, 1.0]\nchoice = [1]"))
        self.refused("must be greater than 0; it is 0", SWEEP.replace("cases = 24", "cases = 0"))
        self.refused("needs cases", SWEEP.replace("cases = 24", ""))
        self.refused('did you mean "lean"?', SWEEP.replace("tower.t.lean", "tower.t.laen"))
        self.refused('there is no tower "s"', SWEEP.replace("tower.t.lean", "tower.s.lean"))
        self.refused("the template has no [[wall]]", SWEEP.replace("tower.t.lean", "wall.*.mass"))
        self.refused('"mrgin" is unknown; did you mean "margin"?', SWEEP.replace('"contacts"', '"mrgin"'))
        self.refused('labels.check[2]: "verdict" stands twice', SWEEP.replace('"contacts"', '"verdict"'))
        self.refused("add up to 1", SWEEP.replace("validation = 0.25", "train = 0.5\nvalidation = 0.25"))
        self.refused("does not vary", SWEEP.replace('held_out = [{ key = "tower.t.count"', 'held_out = [{ key = "tower.t.cont"'))
        self.refused("a grid needs a list here", SWEEP.replace("seed = 7", 'sampling = "grid"'))
        self.refused("random", SWEEP.replace("seed = 7", 'sampling = "randm"'))
        self.refused("empty", "  \n")
        self.refused("no such file", SWEEP.replace("[scene]\nduration = 0.4\nplane = [{}]\ntower = [{ name = \"t\", count = 3, base = [0.0, 0.0] }]", "").replace("cases = 24", 'cases = 24\nscene = "gone.toml"'))
        self.assertIn("no such file", self.expect(2, "sweep", "plan", "gone.toml", "-o", "never").stderr)
        self.assertIn("-o PLAN is missing", self.expect(2, "sweep", "plan", self.sweep()).stderr)

    def test_cases_that_cannot_be_found_are_told(self):
        text = 'name = "few"\ncases = 10\n[scene]\nplane = [{}]\ncube = [{ name = "a", on = "plane1" }]\n[[vary]]\nkey = "cube.a.mass"\nchoice = [1, 2, 3]\n'
        self.refused("only 3 of 10 cases can be found", text)

    def test_a_balance_that_cannot_be_reached_is_told(self):
        text = SWEEP.replace("cases = 24", "") + "[balance]\nstands = 2\nmoves = 3\n"
        self.refused("sweep.toml: balance.moves: none of 100", text)
        self.refused("draws moves; let other values vary, or wider, or ask for no such cases", text)

    def test_what_a_killed_plan_left_is_removed_by_the_next_and_a_living_one_left_alone(self):
        endless = SWEEP.replace("cases = 24", "cases = 2000000").replace("[labels]", "[reject]\nmargin_below = 1e-3\n[labels]")
        plan = [self.program, "sweep", "plan", self.sweep(endless, "long.toml"), "-o", self.path("plan"), "--jobs", "1"]
        partial = lambda: [name for name in self.files() if ".partial-" in name]
        for number, left in ((signal.SIGINT, 0), (signal.SIGTERM, 0), (signal.SIGKILL, 1)):
            with subprocess.Popen(plan, stderr=subprocess.PIPE, text=True) as process:
                process.stderr.readline()  # it draws
                process.send_signal(number)
            self.assertEqual(len(partial()), left)
        with subprocess.Popen(plan, stderr=subprocess.PIPE, text=True) as process:
            process.stderr.readline()
            alive = partial()
            self.plan()
            self.assertEqual((len(alive), partial()), (1, alive))
            process.terminate()

    def test_nothing_is_overwritten(self):
        self.plan()
        self.assertIn("is there already", self.expect(2, "sweep", "plan", self.sweep(), "-o", "plan").stderr)


class Samples(Sweep):
    def test_the_same_bytes_for_any_shards_and_threads(self):
        text = SWEEP + PICTURES
        self.plan(text, "whole")
        self.expect(0, "sweep", "run", "whole", "--jobs", "1")
        whole = self.merged("whole", "a")
        self.plan(text, "parts")
        for k in 2, 0, 1:
            self.expect(0, "sweep", "run", "parts", "--shard", f"{k}/3", "--jobs", "2")
        self.assertEqual(whole, self.merged("parts", "b"))
        self.assertEqual(set(whole), {"SHA256SUMS", "card.md", "labels.csv", "labels.npz", "plan/manifest.jsonl", "plan/plan.json",
                                      "plan/sweep.toml", "train-000000.tar", "validation-000000.tar", "test_ood-000000.tar"})
        done = self.expect(0, "sweep", "verify", "a", "--sample", "5")
        self.assertIn("5 samples made again, 0 differences", done.stdout)
        subprocess.run(["sha256sum", "--quiet", "-c", "SHA256SUMS"], cwd=self.path("a"), check=True)

    def test_what_rests_after_the_impact_at_its_start_has_a_margin(self):
        self.plan('version = 1\nname = "hits"\ncases = 2\n[scene]\nplane = [{}]\n'
                  'cube = [{ name = "a", position = [0.0, 0.5], velocity = [0.0, -1.0] }]\n'
                  '[[vary]]\nkey = "cube.a.mass"\nuniform = [1.0, 2.0]\n[labels]\ncheck = ["verdict", "margin", "weakest"]\n')
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        rows = list(csv.DictReader(self.content("data/labels.csv").splitlines()))
        self.assertEqual([(row["verdict"], row["weakest"]) for row in rows], 2 * [("stands", "a")])
        for row in rows:
            self.assertAlmostEqual(float(row["margin"]), 0.5, delta=1e-12)

    def test_samples_hold_what_the_program_says_of_their_scenes(self):
        self.plan(SWEEP + PICTURES)
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        cases = {case["id"]: case for case in self.manifest()}
        seen = 0
        for split in "train", "validation", "test_ood":
            with tarfile.open(self.path(f"data/{split}-000000.tar")) as archive:
                names = archive.getnames()
                for member in [name for name in names if name.endswith(".json")]:
                    sample = json.load(archive.extractfile(member))
                    case = cases[sample["id"]]
                    seen += 1
                    self.assertEqual((case["split"], case["values"]), (split, sample["values"]))
                    check = json.loads(self.call("check", "--json", "--margin", "shift", self.scene(sample["scene"])).stdout)
                    self.assertAlmostEqual(sample["labels"]["margin"], check["margin"]["smallest"], delta=1e-12)
                    self.assertEqual(sample["labels"]["weakest"], check["margin"]["weakest"])
                    why = json.loads(self.call("explain", "--json", self.scene(sample["scene"])).stdout)
                    first = "+".join(why["causes"][0]["part"]) if why["causes"] else None
                    self.assertEqual(sample["labels"]["causes"], first)
                    self.assertEqual(sample["labels"]["verdict"], check["verdict"])
                    self.assertEqual(sample["labels"]["contacts"], len(check["contacts"]))
                    times = ",".join(str(k / 10) for k in range(5))
                    run = json.loads(self.expect(0, "run", "--json", "--sample", times, self.scene(sample["scene"])).stdout)
                    kind, shape, data = npy(archive.extractfile(sample["id"] + ".states.npy").read())
                    self.assertEqual((kind, shape), ("<f8", (5, len(sample["bodies"]), 6)))
                    states = [body[key] for at in run["samples"] for body in at["bodies"].values() for key in ("x", "y", "theta", "vx", "vy", "omega")]
                    self.assertEqual(states, list(struct.unpack(f"<{len(states)}d", data)))
                    self.assertEqual(sample["labels"]["moved"], len(run["outcome"]["moved"]))
                    self.assertEqual(sample["labels"]["at_rest"], run["outcome"]["at_rest"])
                    if check["verdict"] == "stands":
                        self.assertIsNone(sample["labels"]["time_of_fall"])
                    if seen > 6:
                        continue
                    with open(self.path("first.png"), "wb") as file:
                        file.write(archive.extractfile(sample["id"] + ".first.png").read())
                    self.expect(0, "reproduce", "first.png")
        self.assertEqual(seen, 24)

    def test_masks_of_violations_number_what_falls_by_itself(self):
        text = SWEEP.replace("uniform = [-0.6, 0.6]", "uniform = [0.4, 0.6]").replace("cases = 24", "cases = 4")
        self.plan(text + PICTURES.replace('["instance"]', '["instance", "violation"]'))
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        with tarfile.open(self.path("data/train-000000.tar")) as archive:
            for name in [n for n in archive.getnames() if n.endswith(".violation.png")]:
                sample = json.load(archive.extractfile(name.replace(".violation.png", ".json")))
                instances = gray_pixels(archive.extractfile(name.replace("violation", "instance")).read())
                part = {1 + sample["bodies"].index(cube) for cube in sample["labels"]["causes"].split("+")}
                below = min(part) - 1
                expected = [1 if k in part else 2 if k == below and k else 0 for k in instances]
                self.assertEqual(gray_pixels(archive.extractfile(name).read()), expected)

    def test_knife_edges_are_drawn_again(self):
        text = SWEEP.replace("uniform = [-0.6, 0.6]", "choice = [0.1, 0.499, 0.5, 0.501]").replace("integers = [2, 4]", "choice = [2]").replace("values = [4]", "values = [3]")
        self.plan(text.replace("cases = 24", "cases = 4"), "all")
        self.refused("only 1 of 2 cases", text.replace("cases = 24", "cases = 2") + "[reject]\nmargin_below = 0.01\n")
        self.plan(text.replace("cases = 24", "cases = 1") + "[reject]\nmargin_below = 0.01\n")
        self.assertEqual(self.manifest()[0]["values"]["tower.t.lean"], 0.1)

    def test_masks_number_the_bodies(self):
        self.plan(SWEEP.replace("uniform = [-0.6, 0.6]", "uniform = [0.0, 0.1]") + PICTURES.replace("[64, 48]", "[160, 120]"))
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        with tarfile.open(self.path("data/train-000000.tar")) as archive:
            name = next(n for n in archive.getnames() if n.endswith(".instance.png"))
            png = archive.extractfile(name).read()
            bodies = len(json.load(archive.extractfile(name.replace(".instance.png", ".json")))["bodies"])
        self.assertEqual(struct.unpack(">IIBB", png[16:26]), (160, 120, 8, 0))
        numbers = bytes(gray_pixels(png))
        pixels = [numbers[y * 160:(y + 1) * 160] for y in range(120)]
        counts = [sum(row.count(k) for row in pixels) for k in range(bodies + 1)]
        self.assertEqual(sum(counts), 160 * 120)
        self.assertTrue(all(abs(c - counts[1]) <= 0.1 * counts[1] for c in counts[1:]), counts)  # cubes of one size
        middle = [row[80] for row in pixels]
        self.assertEqual([k for i, k in enumerate(middle) if k and k != middle[i - 1]], list(range(bodies, 0, -1)))

    def test_tables_say_what_samples_say(self):
        self.plan()
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        with open(self.path("data/labels.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["id"] for row in rows], [case["id"] for case in self.manifest()])
        with zipfile.ZipFile(self.path("data/labels.npz")) as table:
            self.assertIsNone(table.testzip())
            self.assertEqual(set(table.namelist()), {name + ".npy" for name in rows[0]})
            kind, shape, data = npy(table.read("final_height.npy"))
            self.assertEqual((kind, shape), ("<f8", (24,)))
            self.assertEqual([float(row["final_height"]) for row in rows], list(struct.unpack("<24d", data)))
            kind, shape, data = npy(table.read("verdict.npy"))
            self.assertEqual([row["verdict"] for row in rows],
                             [data[k:k + len(data) // 24].decode("utf-32-le").rstrip("\0") for k in range(0, len(data), len(data) // 24)])
        self.assertIn("24 samples", self.content("data/card.md"))

    def test_a_film_is_a_film(self):
        self.plan(SWEEP.replace("cases = 24", "cases = 2") + "size = [64, 48]\nvideo = { fps = 20 }\n")
        self.expect(0, "sweep", "run", "plan")
        first = self.merged("plan", "data")
        self.plan(SWEEP.replace("cases = 24", "cases = 2") + "size = [64, 48]\nvideo = { fps = 20 }\n", "again")
        self.expect(0, "sweep", "run", "again", "--jobs", "2")
        self.assertEqual(first, self.merged("again", "data2"))
        done = self.expect(0, "sweep", "verify", "data")
        self.assertIn("2 samples made again, 0 differences", done.stdout)


class Resuming(Sweep):
    def test_killed_at_any_moment_it_goes_on_to_the_same_bytes(self):
        text = SWEEP.replace("cases = 24", "cases = 1000").replace("states = { fps = 10 }", "states = { fps = 200 }")
        self.plan(text, "whole")
        self.expect(0, "sweep", "run", "whole")
        whole = self.merged("whole", "a")
        self.plan(text)
        dice = random.Random(5)
        kills = 0
        while kills < int(os.environ.get("KILLS", "12")):
            with subprocess.Popen([self.program, "sweep", "run", "plan", "--quiet", "--jobs", "2"], cwd=self.folder) as run:
                time.sleep(dice.uniform(0.0, 0.15))
                if run.poll() is not None:
                    break
                run.send_signal(signal.SIGKILL)
                kills += 1
        self.expect(0, "sweep", "run", "plan")
        self.assertGreater(kills, 2)
        self.assertEqual(whole, self.merged("plan", "b"))

    def test_cut_archives_and_journals_count_as_far_as_they_are_whole(self):
        self.plan()
        self.expect(0, "sweep", "run", "plan")
        whole = self.merged("plan", "a")
        for cut in "tar", "jsonl":
            name = self.path("plan/shards/" + sorted(n for n in self.files("plan/shards") if n.endswith(cut))[-1])
            os.truncate(name, os.path.getsize(name) * 2 // 3)
            status = json.loads(self.expect(1, "sweep", "status", "plan", "--json").stdout)
            self.assertTrue(0 < status["left"] < 24, status)
            self.assertIn("cases are missing", self.expect(2, "sweep", "merge", "plan", "-o", "b").stderr)
            self.expect(0, "sweep", "run", "plan")
        self.assertEqual(whole, self.merged("plan", "b"))

    def test_damaged_samples_are_noticed(self):
        self.plan()
        self.expect(0, "sweep", "run", "plan")
        name = self.path("plan/shards/00000-of-00001.0000.tar")
        with open(name, "r+b") as file:
            file.seek(600)
            file.write(b"#")
        done = self.expect(2, "sweep", "merge", "plan", "-o", "data")
        self.assertIn("is damaged; remove the file", done.stderr)
        self.assertNotIn("data", self.files())

    def test_out_of_time_is_exit_75(self):
        self.plan()
        self.expect(75, "sweep", "run", "plan", "--time-budget", "0")
        self.expect(1, "sweep", "status", "plan")
        self.expect(0, "sweep", "run", "plan", "--time-budget", "1h30m")
        self.expect(0, "sweep", "status", "plan")
        for span in ("soon", "3x", "-1h"):
            self.assertIn(f"--time-budget: '{span}' is no time, as 3h50m", self.expect(2, "sweep", "run", "plan", "--time-budget", span).stderr)
        self.assertIn("--sample: '-1' is no whole number of 0 to", self.expect(2, "sweep", "verify", "plan", "--sample", "-1").stderr)

    def test_a_full_disk_is_exit_5_and_can_be_resumed(self):
        self.plan(SWEEP + PICTURES)
        done = self.call("sweep", "run", "plan", preexec_fn=lambda: __import__("resource").setrlimit(
            __import__("resource").RLIMIT_FSIZE, (20000, 20000)))
        self.assertEqual(done.returncode, 5, done.stderr)
        self.expect(0, "sweep", "run", "plan")
        self.plan(SWEEP + PICTURES, "whole")
        self.expect(0, "sweep", "run", "whole")
        self.assertEqual(self.merged("plan", "a"), self.merged("whole", "b"))

    def test_engines_say_which_shard_is_meant(self):
        self.plan()
        slurm = {"SLURM_ARRAY_TASK_ID": "5", "SLURM_ARRAY_TASK_MIN": "4", "SLURM_ARRAY_TASK_MAX": "6", "SLURM_ARRAY_TASK_COUNT": "3"}
        done = self.expect(0, "sweep", "run", "plan", env={**os.environ, **slurm})
        self.assertIn("shard 1 of 3, by SLURM_ARRAY_TASK_ID", done.stderr)
        self.expect(0, "sweep", "run", "plan", env={**os.environ, "OMPI_COMM_WORLD_RANK": "0", "OMPI_COMM_WORLD_SIZE": "3"})
        self.expect(0, "sweep", "run", "plan", "--shard", "*/3", env={**os.environ, "PARALLEL_SEQ": "3"})
        self.expect(0, "sweep", "status", "plan")
        for bad in "3/3", "-1/3", "1", "x/3", "1/0", "*/3":
            self.assertIn("--shard", self.expect(2, "sweep", "run", "plan", "--shard", bad).stderr)

    def test_what_is_of_another_plan_is_refused(self):
        self.plan()
        self.expect(0, "sweep", "run", "plan", "--shard", "0/2")
        self.plan(SWEEP.replace("seed = 7", "seed = 8"), "other")
        os.rename(self.path("plan/shards"), self.path("other/shards"))
        self.assertIn("belongs to another plan", self.expect(2, "sweep", "run", "other").stderr)
        with open(self.path("plan/manifest.jsonl"), "a") as file:
            file.write("{}\n")
        self.assertIn("has been changed since the plan was made", self.expect(2, "sweep", "run", "plan").stderr)
        plan = json.loads(self.content("other/plan.json"))
        plan["version"] = "0.0.1"
        with open(self.path("other/plan.json"), "w") as file:
            json.dump(plan, file)
        self.assertIn("made by wuerfel \"0.0.1\"", self.expect(2, "sweep", "status", "other").stderr)
        self.assertIn("holds no plan.json", self.expect(2, "sweep", "run", ".").stderr)

    def test_a_changed_data_set_is_noticed(self):
        self.plan()
        self.expect(0, "sweep", "run", "plan")
        self.merged("plan", "data")
        with open(self.path("data/train-000000.tar"), "r+b") as file:
            file.seek(700)
            file.write(b"#")
        done = self.expect(1, "sweep", "verify", "data", "--json")
        self.assertEqual(json.loads(done.stdout)["differences"], ["train-000000.tar: is not what its sum says"])
        # Even where the sums were made anew.
        with open(self.path("data/SHA256SUMS"), "w") as file:
            subprocess.run("find . -type f ! -name SHA256SUMS -printf '%P\\n' | xargs sha256sum", shell=True, cwd=self.path("data"), stdout=file, check=True)
        done = self.expect(1, "sweep", "verify", "data", "--sample", "0")
        self.assertIn(".json: differs", done.stdout)


class Family(Sweep):
    def test_commands_and_templates(self):
        self.assertIn("merge", self.expect(0, "sweep", "--help").stdout)
        self.assertIn("a command is missing", self.expect(2, "sweep").stderr)
        self.assertIn("did you mean plan?", self.expect(2, "sweep", "pln").stderr.replace('"', ""))
        for engine in "slurm", "parallel", "make", "snakemake":
            self.assertIn("sweep run", self.expect(0, "sweep", "template", engine).stdout)
        self.assertIn("slurm", self.expect(2, "sweep", "template", "slrum").stderr)
        for engine in "slurm", "parallel":
            subprocess.run(["bash", "-n"], input=self.expect(0, "sweep", "template", engine).stdout, text=True, check=True)

    def test_make_runs_a_sweep(self):
        self.plan()
        with open(self.path("sweep.mk"), "w") as file:
            file.write(self.expect(0, "sweep", "template", "make").stdout)
        subprocess.run(["make", "-s", "-j2", "-f", "sweep.mk", "PLAN=plan", "SHARDS=3", f"WUERFEL={self.program}"],
                       cwd=self.folder, check=True, capture_output=True)
        self.assertIn("labels.csv", self.files("plan.dataset"))

    def test_a_sheet_shows_cases(self):
        self.plan()
        self.expect(0, "sweep", "sheet", "plan", "-o", "sheet.png", "--strip", "4x3", "--size", "400x330")
        with open(self.path("sheet.png"), "rb") as file:
            self.assertEqual(struct.unpack(">II", file.read()[16:24]), (400, 330))
        self.expect(0, "sweep", "sheet", "plan", "-o", "sheet.png")  # 24 cases: three of eight rows
        with open(self.path("sheet.png"), "rb") as file:
            width, height = struct.unpack(">II", file.read()[16:24])
        self.assertEqual(width, 1600)
        self.assertLess(height, 1760 * 0.4)
        self.assertIn("the height of a sheet has to be told", self.refuse("sweep", "sheet", "plan", "-o", "s.png", "--size", "400xauto"))


if __name__ == "__main__":
    main()
