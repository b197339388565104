"""`reproduce` needs only the picture."""
import json
import os
import shutil
import struct
import zlib

from program import FALLING, FLYING, STANDING, ProgramTest, main, png_chunks, png_texts

SMALL = ("--size", "320x180")
EVERYTHING = "cubes,rods,points,sides,normals,forces,rod-forces,velocities,trails,contacts,grid,names,hud"
BOUNCING = {"version": 1, "duration": 1.0, "plane": [{"restitution": 1}],
            "cube": [{"position": [0, 1.5], "restitution": 0.64}]}


class Reproduce(ProgramTest):
    def expect_identical(self, name, *arguments):
        # Elsewhere, without the scene file.
        os.makedirs(self.path("elsewhere"), exist_ok=True)
        shutil.copy(self.path(name), self.path("elsewhere/picture.png"))
        done = self.expect(0, "reproduce", "picture.png", *arguments, cwd=self.path("elsewhere"))
        self.assertEqual(done.stdout, "identical\n")

    def test_every_frame_of_a_film_can_be_made_alone(self):
        self.expect(0, "run", self.scene(FALLING), "-o", "f/", "--fps", "30", *SMALL)
        for name in self.files("f"):
            self.expect_identical("f/" + name)

    def test_frames_of_a_crowd_that_is_stepped_can_be_made_alone(self):
        # Frames fall on ends of steps, where forces hang on the last bit of the time; and bricks part between two frames.
        hit = {"version": 1, "duration": 2, "material": {"friction": 0.5, "restitution": 0.2}, "plane": [{"name": "floor"}],
               "wall": [{"name": "w", "rows": 6, "columns": 6, "base": [0, 0], "size": [0.5, 0.25], "bond": "running"}],
               "cube": [{"name": "ball", "size": 0.4, "mass": 5, "position": [-3, 1.2], "velocity": [8, 1], "spin": 2}]}
        self.expect(0, "run", self.scene(hit), "-o", "f/", "--until", "0.71", *SMALL)
        for number in (28, 36, 38, 42):
            self.expect_identical(f"f/frame_{number:06}.png")

    def test_layers_that_know_the_whole_motion_can_too(self):
        for arguments in (("--layers", EVERYTHING), ("--layers", "cubes,trails", "--speed", "0.3", "--fps", "25"),
                          ("--view", "follow:b", "--zoom", "1.7", "--scale", "2"), ("--force-scale", "0.03"),
                          ("--view", "0,1,6", "--force-scale", "0.03", "--theme", "print"),
                          ("--theme", "transparent", "--zoom", "0.8", "--integrator", "euler", "--step", "0.005")):
            with self.subTest(arguments):
                self.expect(0, "run", self.scene(FALLING), "-o", "f/", "--until", "0.2", *arguments, *SMALL)
                for name in (self.files("f")[0], self.files("f")[-1]):
                    self.expect_identical("f/" + name)
                shutil.rmtree(self.path("f"))

    def test_no_layer_and_odd_names_are_options_too(self):
        name = """a "b" 'c' \\ --d"""
        scene = self.scene({**FLYING, "cube": [{**FLYING["cube"][0], "name": name}]})
        for arguments in (("--layers", ""), ("--legend", ""), ("--view", "follow:" + name), ("--strip", "2x1", "--layers", "")):
            for picture in ("f.png", "f.svg"):
                with self.subTest(arguments=arguments, picture=picture):
                    self.expect(0, "figure", scene, "-t", "0.1", "-o", picture, *SMALL, *arguments)
                    self.assertEqual(self.expect(0, "reproduce", picture).stdout, "identical\n")

    def test_scales_of_what_does_not_occur_are_not_fitted_anew(self):
        whole = ("--layers", EVERYTHING + ",accelerations", *SMALL)
        flying = {**FLYING, "gravity": [0, 0]}
        for scene in (self.scene(FALLING), self.scene(flying, "free.json")):
            for color in ("body", "load", "speed"):
                with self.subTest(scene=scene, color=color):
                    self.expect(0, "figure", scene, "-t", "0", "--fit", "instant", "--color", color, "-o", "f.png", *whole)
                    self.expect_identical("f.png")
        self.expect(0, "run", self.scene(BOUNCING), "-o", "f/", "--until", "0.41", "--fps", "10", *whole)
        for name in self.files("f"):
            self.expect_identical("f/" + name)

    def test_drawing_at_once_and_afterwards_gives_the_same_pictures(self):
        arguments = ("--fps", "20", *SMALL)
        self.expect(0, "run", self.scene(FALLING), "-o", "f/", *arguments)
        words = png_texts(self.path("f/frame_000002.png"))["Options"].split()
        options = dict(zip(words[::2], words[1::2]))
        self.expect(0, "run", self.scene(FALLING), "-o", "g/", "--view", options["--view"], "--force-scale",
                    options["--force-scale"], *arguments)
        self.expect(0, "compare", "f", "g", "--max-difference", "0", "--max-share", "0")

    def test_figures_and_strips_can_be_made_again(self):
        scene = self.scene(FALLING)
        self.expect(0, "figure", scene, "-t", "0.123", "-o", "f.png", "--layers", EVERYTHING, *SMALL)
        self.expect_identical("f.png")
        self.expect(0, "figure", scene, "--strip", "3x2", "-o", "s.png", "--layers", "cubes,trails,forces", *SMALL)
        self.expect_identical("s.png")

    def test_the_figures_of_the_gallery_can_be_made_again(self):
        # Those at the start, which no change of the motion can reach.
        for number in (1, 2, 3, 5, 6, 7):
            self.expect(0, "reproduce", os.path.join(os.environ["PROJECT"], f"assets/gallery/fig{number}.png"))

    def test_names_may_have_spaces(self):
        scene = {**FLYING, "cube": [{"name": "the blue one", "position": [0, 3]}]}
        self.expect(0, "figure", self.scene(scene), "-o", "f.png", "--view", "follow:the blue one", *SMALL)
        self.expect_identical("f.png")

    def test_the_picture_made_again_can_be_kept(self):
        self.expect(0, "figure", self.scene(STANDING), "-o", "f.png", *SMALL)
        self.expect(0, "reproduce", "f.png", "-o", "g.png")
        self.assertEqual(png_chunks(self.path("f.png")), png_chunks(self.path("g.png")))

    def test_the_picture_made_again_does_not_replace_the_one_it_is_compared_with(self):
        self.expect(0, "figure", self.scene(STANDING), "-o", "f.png", *SMALL)
        self.assertIn("f.png is read and would be replaced", self.expect(2, "reproduce", "f.png", "-o", "f.png").stderr)

    def replace_text(self, name, key, old, new):
        """Writes the picture anew with one of its texts changed."""
        chunks = png_chunks(self.path(name))
        with open(self.path(name), "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n")
            for kind, content in chunks:
                if kind in ("tEXt", "zTXt") and content.split(b"\0")[0].decode() == key:
                    text = png_texts(self.path(name + ".copy"))[key]
                    self.assertIn(old, text)
                    kind, content = "tEXt", key.encode() + b"\0" + text.replace(old, new).encode()
                file.write(struct.pack(">I", len(content)) + kind.encode() + content)
                file.write(struct.pack(">I", zlib.crc32(kind.encode() + content)))

    def changed(self, key, old, new):
        self.expect(0, "figure", self.scene(FALLING), "-t", "0.1", "-o", "f.png", *SMALL)
        shutil.copy(self.path("f.png"), self.path("f.png.copy"))
        self.replace_text("f.png", key, old, new)

    def test_a_picture_that_says_something_else_differs(self):
        for change in (("Simulated time", "0.1", "0.2"), ("Options", "theme light", "theme dark"),
                       ("Scene", "0.6,1.5", "0.65,1.5")):
            with self.subTest(change):
                self.changed(*change)
                report = json.loads(self.expect(1, "reproduce", "f.png", "--json").stdout)
                self.assertEqual((report["same"], report["verdict"]), (False, "different"))

    def test_the_line_is_told_in_which_svg_files_differ(self):
        self.expect(0, "figure", self.scene(FALLING), "-o", "f.svg", *SMALL)
        with open(self.path("f.svg")) as file:
            lines = file.read().split("\n")
        lines[5] += " "
        with open(self.path("f.svg"), "w") as file:
            file.write("\n".join(lines))
        self.assertEqual(self.expect(1, "reproduce", "f.svg").stdout, "different: first in line 6\n")

    def test_another_version_is_told(self):
        self.changed("Software", "wuerfel ", "wuerfel 0.0.")
        self.assertIn("was made by wuerfel 0.0.", self.expect(0, "reproduce", "f.png").stderr)

    def test_what_cannot_be_made_again_is_an_error(self):
        self.changed("Options", "--theme light", "--theme pink")
        self.assertIn("pink", self.expect(2, "reproduce", "f.png").stderr)
        self.changed("Options", "--theme light", "--no-such-option")
        self.assertIn("no-such-option", self.expect(2, "reproduce", "f.png").stderr)
        self.expect(2, "reproduce", "nowhere.png")
        with open(self.path("t.png"), "w") as file:
            file.write("no picture")
        self.expect(2, "reproduce", "t.png")


if __name__ == "__main__":
    main()
