"""Still pictures: formats, strips, cameras."""
import subprocess

from program import FALLING, FLYING, STANDING, ProgramTest, main, png_chunks, png_size, png_texts

SMALL = ("--size", "320x180")


class Formats(ProgramTest):
    def test_svg_and_pdf_show_the_same_as_png(self):
        scene = self.scene(FALLING)
        for name in ("f.png", "f.svg", "f.pdf"):
            self.expect(0, "figure", scene, "-t", "0.1", "-o", name, *SMALL)
        subprocess.run(["rsvg-convert", self.path("f.svg"), "-o", self.path("svg.png")], check=True)
        subprocess.run(["pdftoppm", "-r", "96", "-singlefile", "-png", self.path("f.pdf"), self.path("pdf")], check=True)
        # Text and edges are antialiased in other ways; a missing arrow is more than that. Poppler moves its letters.
        for name, difference in (("svg.png", 110), ("pdf.png", 230)):
            self.assertEqual(png_size(self.path(name)), (320, 180))
            self.expect(0, "compare", "f.png", name, "--max-difference", str(difference), "--max-share", "0.07")
        self.expect(0, "figure", scene, "-t", "0.1", "-o", "g.png", "--layers", "cubes,hud", *SMALL)
        self.expect(1, "compare", "g.png", "svg.png", "--max-difference", "110", "--max-share", "0.07")

    def test_the_same_figure_has_the_same_bytes(self):
        for suffix in ("png", "svg", "pdf"):
            contents = []
            for name in ("a", "b"):
                self.expect(0, "figure", self.scene(FALLING), "-o", f"{name}.{suffix}", *SMALL)
                with open(self.path(f"{name}.{suffix}"), "rb") as file:
                    contents.append(file.read())
            self.assertEqual(*contents)
        self.assertNotIn(b"CreationDate", contents[0])

    def test_both_encoders_write_the_same_pixels(self):
        for encoder in ("isa-l", "libpng"):
            self.expect(0, "figure", self.scene(STANDING), "-o", f"{encoder}.png", "--encoder", encoder, *SMALL)
        self.assertEqual(self.expect(0, "compare", "isa-l.png", "libpng.png").stdout, "identical\n")

    def test_a_large_picture_is_drawn(self):
        self.expect(0, "figure", self.scene(STANDING), "-o", "f.png", "--size", "7680x4320")
        self.assertEqual(png_size(self.path("f.png")), (7680, 4320))


class Strips(ProgramTest):
    def test_even_times_go_from_the_start_to_the_end(self):
        self.expect(0, "figure", self.scene(FLYING), "--strip", "3x2", "-o", "f.png", *SMALL)
        self.assertEqual(png_texts(self.path("f.png"))["Simulated time"], "0,0.2,0.4,0.6,0.8,1")
        self.expect(0, "figure", self.scene(FLYING), "--strip", "3x1", "--until", "0.5", "-o", "f.png", *SMALL)
        self.assertEqual(png_texts(self.path("f.png"))["Simulated time"], "0,0.25,0.5")
        self.assertEqual(png_size(self.path("f.png")), (320, 180))

    def test_given_times_come_in_their_order(self):
        self.expect(0, "figure", self.scene(FLYING), "--strip", "2x2", "-t", "0.5,0.125", "-t", "0.25", "-o", "f.png", *SMALL)
        self.assertEqual(png_texts(self.path("f.png"))["Simulated time"], "0.125,0.25,0.5")

    def test_a_strip_can_be_a_vector_figure(self):
        self.expect(0, "figure", self.scene(FLYING), "--strip", "3x2", "-o", "f.svg", *SMALL)
        subprocess.run(["rsvg-convert", self.path("f.svg"), "-o", self.path("svg.png")], check=True)
        self.expect(0, "figure", self.scene(FLYING), "--strip", "3x2", "-o", "f.png", *SMALL)
        self.expect(0, "compare", "f.png", "svg.png", "--max-difference", "160", "--max-share", "0.12")

    def test_wrong_strips_are_errors(self):
        scene = self.scene(FLYING)
        for arguments in (("--strip", "3"), ("--strip", "0x2"), ("--strip", "2x2", "-t", "0,1,2,3,4"), ("-t", "0,1"),
                          ("--until", "1"), ("--strip", "2x1", "-t", "0,1", "--until", "1"), ("--strip", "100x100"),
                          ("--strip", "2x2", "-t", "-1")):
            with self.subTest(arguments):
                self.assertTrue(self.expect(2, "figure", scene, "-o", "f.png", *arguments, *SMALL).stderr.strip())
        self.assertEqual(self.files(), ["scene.json"])


class Cameras(ProgramTest):
    def pixels(self, *arguments, scene=FLYING):
        self.expect(0, "figure", self.scene(scene), "-o", "f.png", "--layers", "cubes", *arguments, *SMALL)
        return b"".join(content for kind, content in png_chunks(self.path("f.png")) if kind == "IDAT")

    def test_a_followed_body_stays_in_the_middle(self):
        self.assertEqual(self.pixels("--view", "follow:a"), self.pixels("--view", "follow:a", "-t", "0.25"))
        self.assertNotEqual(self.pixels("--view", "0,10,14"), self.pixels("--view", "0,10,14", "-t", "0.25"))

    def test_zoom_makes_a_view_narrower(self):
        self.assertEqual(self.pixels("--view", "0,10,8", "--zoom", "2"), self.pixels("--view", "0,10,4"))
        self.assertEqual(self.pixels("--zoom", "2", "--view", "0,10,8"), self.pixels("--view", "0,10,4"))
        self.assertNotEqual(self.pixels(), self.pixels("--zoom", "1.5"))

    def test_lines_and_text_grow_with_the_scale(self):
        self.assertNotEqual(self.pixels("--view", "0,10,8"), self.pixels("--view", "0,10,8", "--scale", "2"))

    def test_wrong_views_are_errors_and_nothing_is_touched(self):
        scene = self.scene(FLYING)
        for view in ("follow:nobody", "follow:", "0,1", "0,1,0", "everything"):
            with self.subTest(view):
                self.expect(2, "figure", scene, "-o", "f.png", "--view", view)
                self.expect(2, "run", scene, "-o", "f/", "--view", view)
        self.expect(2, "figure", scene, "-o", "f.png", "--zoom", "0")
        self.assertEqual(self.files(), ["scene.json"])


if __name__ == "__main__":
    main()
