"""Exit codes: 0 fine, 1 falls or moves, 2 usage or scene, 3 undecided, 4 internal, 5 output."""
import json
import os
import signal
import shutil
import subprocess

from program import FALLING, FLYING, LANDING, PROGRAM, STANDING, ProgramTest, main


class Usage(ProgramTest):
    def test_version_and_help_are_no_errors(self):
        self.assertRegex(self.expect(0, "--version").stdout, r"^wuerfel \d+\.\d+\.\d+\n$")
        self.assertIn("check", self.expect(0, "--help").stdout)
        self.assertIn("--integrator", self.expect(0, "run", "--help").stdout)

    def test_what_does_not_exist_is_refused(self):
        scene = self.scene(FLYING)
        for arguments in ((), ("jump",), ("run",), ("check",), ("figure", scene), ("--json",),
                          ("run", scene, "--nonsense"), ("run", scene, "--fsp", "30"), ("run", scene, "extra"),
                          ("run", scene, "--resume"), ("check", scene, "--fps", "30"), ("check", scene, "--margins"),
                          ("figure", scene, "-o", "a.png", "--fps", "4"), ("scenes", "nosuch"),
                          ("schema", "extra")):
            with self.subTest(arguments):
                self.refuse(*arguments)

    def test_values_that_make_no_sense_are_refused(self):
        scene = self.scene(FLYING)
        for option, values in {
                "--fps": ("0", "-30", "nan", "inf", "fast", "", "30x"),
                "--speed": ("0", "-1", "nan"),
                "--until": ("-1", "nan", "inf", "soon"),
                "--size": ("320", "320x", "x180", "0x0", "320x-180", "99999x99999", "320x180x2", "8x8"),
                "--layers": ("cubes,nothing", "Cubes", "cubes,,forces", "cubes,", ",cubes"),
                "--legend": ("contact,,cut",),
                "--theme": ("pink",),
                "--force-scale": ("0", "-1", "nan"),
                "--view": ("1,2", "1,2,0", "1,2,-3", "a,b,c", "fitted", "1,2,nan"),
                "--integrator": ("magic", ""),
                "--formulation": ("boxes",),
                "--solver": ("guess",),
                "--tolerance": ("0", "-1", "nan"),
                "--step": ("0", "-0.1", "inf"),
                "--sample": ("", "0.1,", "x", "-0.1", "0.1,,0.2", "1.0000001"),
                "-o": ("film.xyz", "film", "film.MP4.txt", ""),
                "--set": ("nonsense", "cube.zzz.angle=1", "=", "gravty=[0,0]")}.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.refuse("run", scene, "--until", "1", option, value)
        self.assertEqual(self.files(), ["scene.json"])

    def test_a_mistyped_name_is_answered_with_the_names_there_are(self):
        self.assertIn("symplectic", self.refuse("run", self.scene(FLYING), "--integrator", "symplektic"))
        self.assertIn("cubes", self.refuse("run", self.scene(FLYING), "--layers", "cube"))

    def test_a_mistyped_command_or_option_is_answered_with_the_nearest(self):
        scene = self.scene(FLYING)
        for arguments, words in ((("rnu",), 'did you mean "run"?'), (("run", scene, "--untill", "3"), 'did you mean "--until"?'),
                                 (("run", "--untill=3", scene), 'did you mean "--until"?'), (("check", scene, "--jsn"), '"--json"'),
                                 (("chekc", scene), '"check"'), (("figure", scene, "--outptu", "f.png"), '"--output"'),
                                 (("check", scene, "--step", "1"), "there is no option --step")):
            with self.subTest(arguments):
                self.assertIn(words, self.refuse(*arguments))
        self.assertIn("wuerfel run --help", self.refuse("run", scene, "--untill", "3"))

    def test_values_that_are_missing_or_too_many_are_told_in_plain_words(self):
        scene = self.scene(FLYING)
        for arguments, message in {("--theme", "dark", "--theme", "light"): "--theme is given more than once",
                                   ("--until",): "--until needs a value, T", ("--json=3",): "--json takes no value"}.items():
            self.assertEqual(self.refuse("run", scene, *arguments), f"wuerfel: {message} (see wuerfel run --help)\n")

    def test_numbers_beyond_all_use_are_refused(self):
        scene = self.scene(FLYING)
        for arguments in (("--strip", "2147483647x2"), ("--strip", "65536x65536"), ("--strip", "2x2", "--scale", "1e9"),
                          ("-t", "1e300", "--layers", "trails"), ("--tolerance", "1e-18")):
            with self.subTest(arguments):
                self.refuse("figure", scene, "-o", "f.png", *arguments)
        self.assertEqual(self.files(), ["scene.json"])

    def test_two_outputs_of_one_name_are_refused(self):
        scene = self.scene(FLYING)
        for arguments in (("--states", "x.csv", "--forces", "x.csv"), ("--states", "x.csv", "--events", "./x.csv"),
                          ("-o", "f.gif", "-o", "f.gif"), ("-o", "f/", "-o", "f/../f")):
            with self.subTest(arguments):
                self.refuse("run", scene, *arguments)
        self.assertEqual(self.files(), ["scene.json"])

    def test_options_without_effect_are_refused_with_those_that_have_one(self):
        scene = self.scene(FLYING)
        for arguments, named in ((("--step", "0.01"), "rattle"), (("--step", "0.01", "--integrator", "event"), "moreau"),
                                 (("--tolerance", "1e-9", "--integrator", "euler"), "auto"),
                                 (("--formulation", "points"), "check"), (("--formulation", "points", "--integrator", "event"), "euler")):
            with self.subTest(arguments):
                self.assertIn(named, self.refuse("run", scene, *arguments))
                self.refuse("figure", scene, "-o", "a.png", *arguments)
        self.expect(0, "run", scene, "--integrator", "rattle", "--step", "0.01", "--tolerance", "1e-7", "--formulation", "points")
        self.expect(1, "check", scene, "--formulation", "points", "--solver", "ipopt")

    def test_too_many_frames_are_refused_before_they_fill_the_memory(self):
        self.refuse("run", self.scene(FLYING), "-o", "f/", "--fps", "1e15")

    def test_standard_output_is_for_one_thing_at_a_time(self):
        self.refuse("run", self.scene(FLYING), "--json", "--states", "-")
        self.refuse("run", self.scene(FLYING), "--events", "-", "--summary", "-")


class Scenes(ProgramTest):
    def test_a_bad_scene_is_refused_and_nothing_is_written(self):
        cube = {"position": [0, 1]}
        for name, text in {
                "empty": "", "cut": "[1,2", "list": "[1,2]", "brace": "{", "binary": "\0\1\2",
                "size": json.dumps({"version": 1, "cube": [{**cube, "size": -1}]}),
                "mass": '{"version":1,"cube":[{"size":1,"mass":1e999,"position":[0,1]}]}',
                "no bodies": json.dumps({"version": 1, "cube": []}),
                "unknown key": json.dumps({"version": 1, "cubes": []}),
                "overlap": json.dumps({"version": 1, "cube": [cube, {"position": [0.3, 1]}]}),
                "sunk": json.dumps({"version": 1, "plane": [{"point": [0, 0], "normal": [0, 1]}],
                                    "cube": [{"position": [0, 0.4]}]})}.items():
            with self.subTest(name):
                with open(self.path("bad"), "w") as file:
                    file.write(text)
                for command in (("run", "bad", "-o", "none/", "--states", "s.csv", "--json"), ("check", "bad", "--json"),
                                ("figure", "bad", "-o", "none.png")):
                    done = self.expect(2, *command)
                    self.assertEqual(done.stdout, "")
                    self.assertNotEqual(done.stderr, "")
                self.assertEqual(self.files(), ["bad"])

    def test_a_scene_that_is_not_there_is_named(self):
        done = self.expect(2, "run", "nowhere.toml")
        self.assertIn("nowhere.toml", done.stderr)
        self.expect(2, "run", ".")
        self.assertIn("fig1_stack", self.expect(2, "run", "fig1_stak").stderr)


class Check(ProgramTest):
    def verdict(self, scene, code, *arguments):
        answer = json.loads(self.expect(code, "check", self.scene(scene), "--json", *arguments).stdout)
        self.assertEqual(set(answer), {"verdict", "accelerations", "contacts", "rods", "pins", "objective", "kkt_residual"})
        return answer

    def test_painleve_is_told(self):
        rod = {"name": "rod", "size": [2.0, 0.001], "position": [0, 0.7836377146116188], "angle": 0.9}
        for velocity, jams in ((-1.0, True), (1.0, False)):
            scene = {"version": 1, "material": {"friction": 2.0}, "plane": [{"name": "floor"}], "cube": [{**rod, "velocity": [velocity, 0]}]}
            answer = json.loads(self.expect(1, "check", self.scene(scene), "--json").stdout)
            self.assertEqual(answer.get("painleve", False), jams)

    def test_what_stands_is_fine(self):
        answer = self.verdict(STANDING, 0)
        self.assertEqual(answer["verdict"], "stands")
        self.assertEqual(set(answer["accelerations"]["a"]), {"ax", "ay", "alpha"})
        self.assertAlmostEqual(sum(c["force"] for c in answer["contacts"]), 9.81, delta=1e-6)
        for contact in answer["contacts"]:
            self.assertEqual(set(contact), {"on", "from", "point", "normal", "force", "tangential", "unique"})

    def test_what_falls_or_moves_is_one(self):
        self.assertEqual(self.verdict(FALLING, 1)["verdict"], "falls")
        self.assertEqual(self.verdict(FLYING, 1)["verdict"], "moves")

    def test_set_changes_the_answer(self):
        self.assertEqual(self.verdict(FALLING, 0, "--set", "cube.b.position=[0.4,1.5]")["verdict"], "stands")

    def test_for_people_the_verdict_comes_first(self):
        done = self.expect(1, "check", self.scene(FALLING))
        self.assertTrue(done.stdout.startswith("falls\n"), done.stdout)
        self.assertIn("largest acceleration: b", done.stdout)

    def test_for_people_it_says_who_moves_only_where_somebody_does(self):
        self.assertNotIn("acceleration", self.expect(0, "check", self.scene(STANDING)).stdout)
        self.assertIn("moving at the start: a", self.expect(1, "check", self.scene(FLYING)).stdout)

    def test_nobody_reading_is_an_output_error(self):
        with open("/dev/full", "w") as full:
            self.expect(5, "check", self.scene(STANDING), "--json", capture_output=False, stdout=full)


class MissingSolver(ProgramTest):
    """Without its module Ipopt solves nothing: the run ends at once and says why."""

    def refuse(self, *arguments):
        os.mkdir(self.path("alone"))
        program = shutil.copy(PROGRAM, self.path("alone/wuerfel"))
        # Found before the module on the run path, and no library.
        with open(self.path("alone/libwuerfel_ipopt.so"), "w"):
            pass
        done = subprocess.run([program, *arguments, "--solver", "ipopt"], capture_output=True, text=True, timeout=10,
                              env={**os.environ, "LD_LIBRARY_PATH": self.path("alone")})
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("the Ipopt module libwuerfel_ipopt.so cannot be loaded", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_ends_a_check(self):
        self.refuse("check", self.scene(STANDING))

    def test_ends_a_run(self):
        self.refuse("run", self.scene(FALLING), "--json")


class Run(ProgramTest):
    def test_a_motion_beyond_all_bounds_ends_a_run_with_what_to_do(self):
        done = self.expect(4, "run", "hanging_chain", "--integrator", "euler", "--quiet")
        self.assertRegex(done.stderr, r"runs away from all bounds at .* s: steps of .* are too long for --integrator euler; try a shorter --step")

    def test_falling_is_no_failure_of_a_run(self):
        self.expect(0, "run", self.scene(FALLING))
        self.expect(0, "run", self.scene(LANDING))

    def test_nothing_asked_for_is_nothing_written(self):
        done = self.expect(0, "run", self.scene(STANDING), "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertEqual(self.files(), ["scene.json"])


class StandardStreams(ProgramTest):
    """What happens to people's messages must not happen to data."""

    def run_states(self, **options):
        self.expect(0, "run", self.scene(FALLING), "--fps", "3000", "--states", "s.csv", "--theme", "dark", **options)
        self.assertTrue(self.content("s.csv").startswith("t,body"), self.content("s.csv")[:80])

    def test_messages_that_cannot_be_written_are_lost_and_no_more(self):
        with open("/dev/full", "w") as full:
            self.run_states(capture_output=False, stderr=full)
            self.expect(2, "check", "nosuch", capture_output=False, stderr=full)
        reader, writer = os.pipe()
        os.close(reader)
        self.run_states(capture_output=False, stderr=writer)
        os.close(writer)

    def test_closed_streams_do_not_end_up_in_files(self):
        for closed in ((2,), (0, 1, 2)):
            self.run_states(capture_output=False, preexec_fn=lambda: [os.close(stream) for stream in closed])
        self.expect(2, "check", "nosuch", capture_output=False, preexec_fn=lambda: os.close(2))
        self.expect(5, "check", self.scene(STANDING), capture_output=False, preexec_fn=lambda: os.close(1))

    def test_a_reader_that_has_enough_hears_no_complaint(self):
        reader, writer = os.pipe()
        os.close(reader)
        done = self.call("run", self.scene(FLYING), "--states", "-", capture_output=False, stdout=writer, stderr=subprocess.PIPE)
        os.close(writer)
        self.assertEqual((done.returncode, done.stderr), (128 + signal.SIGPIPE, ""))

    def test_help_that_cannot_be_written_is_an_output_error(self):
        with open("/dev/full", "w") as full:
            for arguments in (("--help",), ("--version",), ("run", "--help")):
                self.expect(5, *arguments, capture_output=False, stdout=full)


class Causes(ProgramTest):
    """One cause has one code, whatever the command."""

    def test_a_drawing_library_that_is_missing(self):
        # An empty file of its name before all others.
        os.mkdir(self.path("lib"))
        with open(self.path("lib/libOSMesa.so.8"), "w"):
            pass
        missing = {**os.environ, "LD_LIBRARY_PATH": self.path("lib")}
        scene = self.scene(STANDING)
        osmesa = ("--rasteriser", "osmesa")
        self.expect(0, "figure", scene, "-o", "f.png", "--size", "64x64", *osmesa)
        for arguments in (("figure", scene, "-o", "g.png", *osmesa), ("run", scene, "-o", "f/", *osmesa),
                          ("run", scene, "-o", "f.apng", *osmesa), ("reproduce", "f.png")):
            with self.subTest(arguments):
                done = self.expect(5, *arguments, env=missing)
                self.assertIn("pictures need OSMesa", done.stderr)
                self.assertIn("libosmesa6", done.stderr)
        self.assertEqual(self.files(), ["f.png", "lib", "scene.json"])


class Listing(ProgramTest):
    def test_shipped_scenes_are_listed_printed_and_found_by_name(self):
        names = [line.split()[0] for line in self.expect(0, "scenes").stdout.splitlines()]
        self.assertIn("fig1_stack", names)
        self.assertEqual(names, sorted(names))
        text = self.expect(0, "scenes", "fig1_stack").stdout
        with open(os.path.join(os.environ["SCENES"], "fig1_stack.toml")) as file:
            self.assertEqual(text, file.read())
        on_disk = {name[:-5] for name in os.listdir(os.environ["SCENES"]) if name.endswith(".toml")}
        self.assertEqual(set(names), on_disk)
        self.expect(0, "check", "overhang_stands")

    def test_a_file_is_preferred_to_a_shipped_scene(self):
        self.scene(FLYING, "overhang_stands")
        self.expect(1, "check", "overhang_stands")

    def test_the_schema_is_json(self):
        self.assertIn("properties", json.loads(self.expect(0, "schema").stdout))


if __name__ == "__main__":
    main()
