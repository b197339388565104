"""Frames, films and figures as files."""
import filecmp
import json
import os
import resource
import shutil
import stat
import struct
import subprocess

from program import FALLING, FLYING, LANDING, PROGRAM, STANDING, ProgramTest, main, png_chunks, png_size, png_texts

SMALL = ("--size", "160x90")


class Frames(ProgramTest):
    def test_both_ends_have_a_frame(self):
        for until, fps, count in ((1, 30, 31), (0.57, 100, 58), (0, 60, 1), (0.99, 10, 10), (0.3, 10, 4)):
            with self.subTest(until=until, fps=fps):
                self.expect(0, "run", self.scene(FLYING), "-o", f"f{fps}{until}/", "--until", str(until), "--fps",
                            str(fps), *SMALL)
                self.assertEqual(self.files(f"f{fps}{until}"), [f"frame_{k:06d}.png" for k in range(count)])

    def test_frames_carry_exact_times_whatever_the_step_is(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f/", "--fps", "7", "--integrator", "symplectic", "--step", "0.013", *SMALL)
        times = [float(png_texts(self.path(f"f/{name}"))["Simulated time"]) for name in self.files("f")]
        self.assertEqual(times, [k / 7 for k in range(8)])

    def test_slow_motion_has_more_frames_of_the_same_time(self):
        s = self.summary(FLYING, "-o", "f/", "--fps", "10", "--speed", "0.5", "--until", "0.5", *SMALL)
        self.assertEqual((s["cost"]["frames"], len(self.files("f"))), (11, 11))
        self.assertEqual(float(png_texts(self.path("f/frame_000003.png"))["Simulated time"]), 3 * 0.5 / 10)

    def test_frames_that_look_the_same_are_counted_and_not_drawn_again(self):
        still = ("--layers", "cubes,forces", "--fps", "100", *SMALL)
        for view in ((), ("--view", "0,5,20", "--force-scale", "0.05")):  # drawn afterwards and at once
            cost = self.summary(STANDING, "-o", "f/", *still, *view)["cost"]
            self.assertEqual((cost["frames"], cost["frames_reused"]), (11, 10))
            cost = self.summary(FLYING, "-o", "f/", "--until", "0.1", *still, *view)["cost"]
            self.assertEqual((cost["frames"], cost["frames_reused"]), (11, 0))
            # The clock of the HUD goes on with every frame, in as many digits as that takes.
            cost = self.summary(STANDING, "-o", "f/", "--fps", "4000", "--until", "0.01", "--size", "480x270", *view)["cost"]
            self.assertEqual((cost["frames"], cost["frames_reused"]), (41, 0))
        cost = self.summary(FLYING, "--states", "s.csv")["cost"]
        self.assertEqual((cost["frames"], cost["frames_reused"]), (0, 0))

    def test_unchanged_frames_differ_in_their_time_alone(self):
        self.expect(0, "run", self.scene(STANDING), "-o", "f/", "--layers", "cubes", "--fps", "20", *SMALL)
        first, second = (png_chunks(self.path("f/" + name)) for name in self.files("f")[:2])
        self.assertEqual([a[0] for a, b in zip(first, second) if a != b], ["tEXt"])
        self.assertEqual(png_texts(self.path("f/frame_000001.png"))["Simulated time"], "0.05")

    def test_a_frame_is_as_large_as_asked(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f/", "--until", "0", "--size", "161x91")
        self.assertEqual(png_size(self.path("f/frame_000000.png")), (161, 91))
        self.expect(0, "run", self.scene(FLYING), "-o", "g/", "--until", "0")
        self.assertEqual(png_size(self.path("g/frame_000000.png")), (1280, 720))

    def test_a_frame_carries_its_origin_and_nothing_of_this_machine(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f/", "--until", "0", *SMALL)
        texts = png_texts(self.path("f/frame_000000.png"))
        self.assertEqual(set(texts), {"Software", "Options", "Simulated time", "Scene"})
        self.assertRegex(texts["Software"], r"^wuerfel \d")
        self.assertIn("--size 160x90", texts["Options"])
        self.assertEqual(json.loads(texts["Scene"])["title"], "flying")
        with open(self.path("f/frame_000000.png"), "rb") as picture:
            everything = picture.read() + "".join(texts.values()).encode()
        self.assertNotIn(self.folder.encode(), everything)
        self.assertFalse(any(kind == "tIME" for kind, _ in png_chunks(self.path("f/frame_000000.png"))))
        # The scene in the picture is a scene again.
        self.expect(1, "check", "-", input=texts["Scene"])

    def test_two_runs_write_the_same_bytes(self):
        for folder in ("f", "g"):
            self.expect(0, "run", self.scene(LANDING), "-o", folder + "/", "--fps", "30", *SMALL)
        match, mismatch, errors = filecmp.cmpfiles(self.path("f"), self.path("g"), self.files("f"), shallow=False)
        self.assertEqual((len(match), mismatch, errors), (2, [], []))

    def test_frames_differ_where_the_scene_moves(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f/", "--fps", "4", *SMALL)
        pictures = {b"".join(content for kind, content in png_chunks(self.path(f"f/{name}")) if kind == "IDAT")
                    for name in self.files("f")}
        self.assertEqual(len(pictures), 5)

    def test_frames_of_an_earlier_longer_run_do_not_stay_behind(self):
        scene = self.scene(FLYING)
        self.expect(0, "run", scene, "-o", "f/", "--fps", "4", *SMALL)
        with open(self.path("f/mine.png"), "w"):
            pass
        self.expect(0, "run", scene, "-o", "f/", "--fps", "2", *SMALL)
        self.assertEqual(self.files("f"), ["frame_000000.png", "frame_000001.png", "frame_000002.png", "mine.png"])


class Films(ProgramTest):
    def probe(self, name):
        done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                               "stream=width,height,nb_read_frames,pix_fmt,codec_name,r_frame_rate", "-of", "json",
                               self.path(name)], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)["streams"][0]

    def test_every_kind_of_film_has_every_frame(self):
        names = ("f.mp4", "f.webm", "f.gif", "f.apng")
        outputs = [argument for name in names for argument in ("-o", name)]
        self.expect(0, "run", self.scene(FLYING), *outputs, "--fps", "10", "--hold", "0", *SMALL)
        self.assertEqual(self.files(), sorted([*names, "scene.json"]))
        codecs = {}
        for name in names:
            film = self.probe(name)
            self.assertEqual((film["width"], film["height"], film["nb_read_frames"]), (160, 90, "11"), name)
            codecs[name] = film["codec_name"]
        self.assertEqual(codecs["f.mp4"], "h264")
        self.assertEqual(self.probe("f.mp4")["pix_fmt"], "yuv420p")
        self.assertEqual(self.probe("f.mp4")["r_frame_rate"], "10/1")

    def test_loops_hold_their_last_frame(self):
        self.expect(0, "run", self.scene(FLYING), "-o", "f.mp4", "-o", "f.gif", "--fps", "10", *SMALL)
        self.assertEqual(self.probe("f.mp4")["nb_read_frames"], "11")
        seconds = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0",
                                  self.path("f.gif")], capture_output=True, text=True, check=True).stdout
        self.assertAlmostEqual(float(seconds), 2.1, delta=0.15)

    def test_a_gif_takes_its_own_rate_with_a_note(self):
        done = self.expect(0, "run", self.scene(FLYING), "-o", "f.gif", "--until", "0.2", "--hold", "0", *SMALL)
        self.assertIn("50 frames", done.stderr)
        self.assertEqual(self.probe("f.gif")["nb_read_frames"], "11")

    def test_a_film_needs_a_height(self):
        self.assertIn("--size", self.expect(2, "run", self.scene(FLYING), "-o", "f.mp4", "--size", "320xauto").stderr)

    def test_odd_sizes_are_padded(self):
        done = self.expect(0, "run", self.scene(FLYING), "-o", "f.mp4", "--until", "0.2", "--fps", "10", "--size", "161x91")
        self.assertIn("162x92", done.stderr)
        self.assertEqual((self.probe("f.mp4")["width"], self.probe("f.mp4")["height"]), (162, 92))

    def test_frames_and_a_film_come_from_one_run(self):
        s = self.summary(FLYING, "-o", "f/", "-o", "f.mp4", "--until", "0.2", "--fps", "10", *SMALL)
        self.assertEqual((s["cost"]["frames"], len(self.files("f")), self.probe("f.mp4")["nb_read_frames"]), (3, 3, "3"))

    def test_a_missing_ffmpeg_is_noticed_before_the_work(self):
        done = self.expect(5, "run", self.scene(FLYING), "-o", "f.mp4", "-o", "f/", "--until", "100000",
                           env={**os.environ, "PATH": self.folder}, timeout=20)
        self.assertIn("ffmpeg", done.stderr)
        self.assertEqual(self.files(), ["scene.json"])

    def test_a_failing_ffmpeg_leaves_nothing_behind(self):
        os.mkdir(self.path("bin"))
        with open(self.path("bin/ffmpeg"), "w") as fake:
            fake.write("#!/bin/sh\necho cannot encode today >&2\nexit 1\n")
        os.chmod(self.path("bin/ffmpeg"), 0o755)
        done = self.expect(5, "run", self.scene(FLYING), "-o", "f.mp4", *SMALL,
                           env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertIn("ffmpeg", done.stderr)
        self.assertEqual(self.files(), ["bin", "scene.json"])

    def test_a_film_that_has_no_room_for_its_end_is_none(self):
        os.mkdir(self.path("bin"))
        with open(self.path("bin/ffmpeg"), "w") as full:  # writing fails and no signal comes, as on a full disk
            full.write(f'#!/bin/sh\ntrap "" XFSZ\nulimit -f 3\nexec {shutil.which("ffmpeg")} "$@"\n')
        os.chmod(self.path("bin/ffmpeg"), 0o755)
        for film in ("f.mp4", "f.webm", "f.gif"):
            with self.subTest(film):
                done = self.expect(5, "run", self.scene(FLYING), "-o", film, "--fps", "20",
                                   env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
                self.assertIn(f"ffmpeg failed on {film}: ", done.stderr)
                self.assertEqual(self.files(), ["bin", "scene.json"])


class Unwritable(ProgramTest):
    def test_it_is_noticed_before_the_work(self):
        scene = self.scene(FLYING)
        with open(self.path("file"), "w"):
            pass
        for arguments in (("-o", "file/frames/"), ("-o", "file/f.mp4"), ("--states", "file/s.csv"),
                          ("--summary", "file/s.json"), ("--events", "file/e"), ("--forces", ".")):
            with self.subTest(arguments):
                done = self.expect(5, "run", scene, "--until", "10000", *arguments, timeout=60)
                self.assertTrue(done.stderr.strip())
        self.assertEqual(self.files(), ["file", "scene.json"])
        self.expect(5, "figure", scene, "-o", "file/f.png")

    def test_a_full_disk_leaves_whole_files_only(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1500, 1500))
        for arguments in (("-o", "f/"), ("--states", "s.csv", "--fps", "1000"), ("-o", "f.mp4")):
            with self.subTest(arguments):
                done = self.expect(5, "run", self.scene(FLYING), *arguments, preexec_fn=limit)
                self.assertTrue(done.stderr.strip())
                for name in self.files("f") if "f" in self.files() else ():
                    png_chunks(self.path("f/" + name))
                self.assertLessEqual(set(self.files()), {"f", "scene.json"})

    def test_a_file_that_exists_survives_a_failed_run(self):
        with open(self.path("s.csv"), "w") as file:
            file.write("precious")
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1500, 1500))
        self.expect(5, "run", self.scene(FLYING), "--states", "s.csv", "--fps", "1000", preexec_fn=limit)
        self.assertEqual(self.content("s.csv"), "precious")

    def test_a_film_is_not_a_folder(self):
        os.mkdir(self.path("d.mp4"))
        self.assertIn("is a folder", self.expect(5, "run", self.scene(FLYING), "-o", "d.mp4", *SMALL).stderr)
        self.assertEqual(self.files("d.mp4"), [])

    def test_a_pipe_is_not_replaced_by_a_file(self):
        scene = self.scene(FLYING)
        for picture, time in (("a.png", "0"), ("b.png", "1")):
            self.expect(0, "figure", scene, "-o", picture, "-t", time, "--size", "64x64")
        for name in ("pipe.png", "pipe.gif", "pipe.apng"):
            os.mkfifo(self.path(name))
        for arguments in (("compare", "a.png", "b.png", "-o", "pipe.png"), ("reproduce", "a.png", "-o", "pipe.png"),
                          ("run", scene, "-o", "pipe.gif", *SMALL), ("run", scene, "-o", "pipe.apng", *SMALL)):
            with self.subTest(arguments):
                self.assertIn("it is a pipe or a device", self.expect(5, *arguments).stderr)
        for name in ("pipe.png", "pipe.gif", "pipe.apng"):
            self.assertTrue(stat.S_ISFIFO(os.stat(self.path(name)).st_mode))

    def test_pictures_are_not_named_as_if_they_were_others(self):
        scene = self.scene(FLYING)
        for picture, time in (("a.png", "0"), ("b.png", "1"), ("a.svg", "0")):
            self.expect(0, "figure", scene, "-o", picture, "-t", time, "--size", "64x64")
        for arguments in (("compare", "a.png", "b.png", "-o", "d.jpg"), ("reproduce", "a.png", "-o", "d.svg"),
                          ("reproduce", "a.svg", "-o", "d.png")):
            with self.subTest(arguments):
                self.assertIn("does not end in .", self.refuse(*arguments))

    def test_a_folder_is_no_file_to_read(self):
        os.mkdir(self.path("d.png"))
        for arguments in (("reproduce", "d.png"), ("replay", "d.png")):
            with self.subTest(arguments):
                self.assertIn("cannot read d.png: it is a folder", self.refuse(*arguments))
        self.assertIn("cannot read none.svg: No such file", self.refuse("reproduce", "none.svg"))

    def test_a_scene_is_not_replaced_by_what_is_made_of_it(self):
        scene = self.scene(FLYING)
        before = self.content("scene.json")
        for option in ("--summary", "--states", "--forces", "--events", "--failed-programs", "--checkpoint"):
            done = self.expect(2, "run", scene, option, "./scene.json", *SMALL)
            self.assertIn("scene.json is read and would be replaced", done.stderr)
        self.assertEqual(self.content("scene.json"), before)

    def test_frames_may_go_to_a_folder_with_the_name_of_a_shipped_scene(self):
        for _ in range(2):
            self.expect(0, "run", "tower", "-o", "tower/", "--until", "0", *SMALL)

    def test_devices_are_written_to_and_not_replaced(self):
        self.expect(0, "run", self.scene(FLYING), "--states", "/dev/null", "--summary", "/dev/null")
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_no_link_is_followed(self):
        outputs = {"s.csv": ("run", "--states", "s.csv", "--fps", "1"), "e.jsonl": ("run", "--events", "e.jsonl"), "j.json": ("run", "--summary", "j.json"),
                   "c": ("run", "--checkpoint", "c", "--every", "0.1"), "p.png": ("figure", "-o", "p.png", *SMALL), "p.svg": ("figure", "-o", "p.svg"),
                   "f.apng": ("run", "-o", "f.apng", *SMALL), "f.mp4": ("run", "-o", "f.mp4", *SMALL)}
        for name, (command, *options) in outputs.items():
            with self.subTest(name):
                with open(self.path("precious"), "w") as file:
                    file.write("precious")
                os.symlink("precious", self.path(name))
                self.expect(0, command, self.scene(FLYING), *options)
                self.assertFalse(os.path.islink(self.path(name)))
                self.assertEqual(self.content("precious"), "precious")

    def test_links_of_the_system_to_open_files_are_written_to(self):
        with open(self.path("out.csv"), "w") as out:
            out.write("before\n")
            out.flush()
            done = subprocess.run([PROGRAM, "run", self.scene(FLYING), "--states", "/dev/stdout", "--fps", "1", "--quiet"], cwd=self.folder, stdout=out)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(self.content("out.csv").startswith("before\nt,body"))


class Figure(ProgramTest):
    def test_a_figure_shows_the_instant_asked_for(self):
        self.expect(0, "figure", self.scene(FLYING), "-t", "0.25", "-o", "f.png", *SMALL)
        self.assertEqual(png_size(self.path("f.png")), (160, 90))
        self.assertEqual(png_texts(self.path("f.png"))["Simulated time"], "0.25")
        self.assertEqual(self.files(), ["f.png", "scene.json"])

    def test_standard_output_takes_a_picture(self):
        self.expect(0, "figure", self.scene(FLYING), "-o", "f.png", *SMALL)
        done = self.expect(0, "figure", self.scene(FLYING), "-o", "-", *SMALL, text=False)
        with open(self.path("f.png"), "rb") as file:
            self.assertEqual(done.stdout, file.read())

    def test_endings_may_be_in_capitals(self):
        self.expect(0, "figure", self.scene(FLYING), "-o", "F.PNG", *SMALL)
        png_chunks(self.path("F.PNG"))
        self.expect(0, "figure", self.scene(FLYING), "-o", "F.Svg", *SMALL)
        self.assertIn("<svg", self.content("F.Svg"))
        self.expect(0, "run", self.scene(FLYING), "--until", "0.1", "-o", "F.MP4", "-o", "F.ApnG", *SMALL)
        self.assertEqual(self.files(), ["F.ApnG", "F.MP4", "F.PNG", "F.Svg", "scene.json"])

    def test_other_formats_are_not_there(self):
        for name in ("f.jpg", "f", "f.eps"):
            self.expect(2, "figure", self.scene(FLYING), "-o", name)

    def test_themes_and_layers_change_the_picture(self):
        scene = self.scene(STANDING)
        pictures = set()
        for arguments in ((), ("--theme", "dark"), ("--layers", "cubes"), ("--layers", "cubes,rods"),
                          ("--view", "0,0,20"), ("--view", "-1.5,0,20"), ("--force-scale", "0.01")):
            self.expect(0, "figure", scene, "-o", "f.png", *arguments, *SMALL)
            pictures.add(b"".join(content for kind, content in png_chunks(self.path("f.png")) if kind == "IDAT"))
        self.assertEqual(len(pictures), 7)


if __name__ == "__main__":
    main()
