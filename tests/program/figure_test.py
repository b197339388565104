"""Still pictures: formats, strips, cameras."""
import subprocess
from xml.etree import ElementTree

from program import FALLING, FLYING, STANDING, ProgramTest, main, png_chunks, png_size, png_texts

SMALL = ("--size", "320x180")
HYPERSTATIC = {"version": 1, "plane": [{"point": [0, 0], "normal": [0, 1]}],
               "wall": [{"rows": 3, "columns": 3, "base": [0, 0], "size": [1, 1]}]}


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

    def test_how_time_is_stepped_does_nothing_for_the_start_alone(self):
        def notes(*options):
            return self.expect(0, "figure", self.scene(STANDING), "-o", "f.svg", *options).stderr
        stepping = ("--integrator", "rattle", "--step", "0.01")
        self.assertEqual(notes(*stepping), "")  # the view fits the motion
        self.assertEqual(notes("--fit", "instant", "-t", "0.1", *stepping), "")
        for name in stepping[::2]:
            self.assertIn(f"{name} does nothing for the start", notes("--fit", "instant", *stepping))

    def test_an_integrator_without_friction_does_something_for_the_start(self):
        for integrator, idle in (("event", True), ("moreau", False), ("euler", False)):
            done = self.expect(0, "figure", "incline_friction", "--fit", "instant", "--integrator", integrator, "-o", f"{integrator}.png", *SMALL)
            self.assertEqual("--integrator does nothing" in done.stderr, idle, integrator)
        self.expect(1, "compare", "event.png", "moreau.png")

    def test_both_encoders_write_the_same_pixels(self):
        for encoder in ("isa-l", "libpng"):
            self.expect(0, "figure", self.scene(STANDING), "-o", f"{encoder}.png", "--encoder", encoder, *SMALL)
        self.assertEqual(self.expect(0, "compare", "isa-l.png", "libpng.png").stdout, "identical\n")

    def test_a_large_picture_is_drawn(self):
        self.expect(0, "figure", self.scene(STANDING), "-o", "f.png", "--size", "7680x4320")
        self.assertEqual(png_size(self.path("f.png")), (7680, 4320))


    def test_svg_is_small_and_says_what_it_shows(self):
        self.expect(0, "figure", "demo", "-t", "1.6", "--layers", "cubes,forces,trails,names,hud", "-o", "f.svg")
        with open(self.path("f.svg")) as file:
            svg = file.read()
        self.assertLess(len(svg), 200_000)
        root = ElementTree.fromstring(svg)
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(root.find(name + "title").text, "Fallende Würfel")
        self.assertIn("Fallende Würfel", [text.text for text in root.iter(name + "text")])
        ids = [rect.get("id") for rect in root.iter(name + "rect") if rect.get("class") == "body"]
        self.assertIn("body-crooked_1", ids)
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual(self.expect(0, "reproduce", "f.svg").stdout, "identical\n")

    def test_width_on_paper(self):
        self.expect(0, "figure", self.scene(STANDING), "--width", "84mm", "-o", "f.svg", *SMALL)
        with open(self.path("f.svg")) as file:
            self.assertIn('width="84mm"', file.read())
        self.assertEqual(self.expect(0, "reproduce", "f.svg").stdout, "identical\n")

    def test_small_print_on_paper_is_noted(self):
        def notes(*options):
            return self.expect(0, "figure", self.scene(STANDING), "-o", "f.pdf", *options).stderr
        # 14 px of 1280 on 84 mm: 0.919 mm, 2.6 pt.
        self.assertIn("letters of 2.6 pt on paper are hard to read: --scale 2.0 makes them 5 pt", notes("--width", "84mm"))
        self.assertIn("take a larger --width", notes("--width", "10mm"))
        for fine in ((), ("--width", "84mm", "--scale", "2"), ("--width", "180mm")):
            self.assertEqual(notes(*fine), "")

    def test_pixels_have_no_width_on_paper(self):
        self.assertIn("--width", self.expect(2, "figure", self.scene(STANDING), "--width", "84mm", "-o", "f.png").stderr)

    def test_height_by_content(self):
        self.expect(0, "figure", self.scene(STANDING), "--size", "640xauto", "-o", "f.png")
        width, height = png_size(self.path("f.png"))
        self.assertEqual(width, 640)
        self.assertNotEqual(height, 360)
        self.expect(0, "reproduce", "f.png")

    def test_a_figure_is_the_frame_of_its_film(self):
        self.expect(0, "run", self.scene(FALLING), "-o", "f/", "--fps", "60", "--layers", "cubes,forces", *SMALL)
        self.expect(0, "figure", self.scene(FALLING), "-t", "0.1", "-o", "f.png", "--layers", "cubes,forces", *SMALL)
        self.assertEqual(self.expect(0, "compare", "f/frame_000006.png", "f.png").stdout, "identical\n")

    def test_options_that_make_no_sense_are_errors(self):
        scene = self.scene(STANDING)
        for arguments in (("--scale", "20"), ("--ghosts", "1.5"), ("--ghosts", "3", "--strip", "2x1"), ("--explode", "-1"),
                          ("--width", "84"), ("--color", "lod"), ("--legend", "cutt"), ("--fit", "film")):
            with self.subTest(arguments):
                self.expect(2, "figure", scene, "-o", "f.png", *arguments)

    def test_words_that_do_not_exist_have_a_suggestion(self):
        scene = self.scene(STANDING)
        for option, value, said in (("--layers", "cubes,force", '"forces"'), ("--layers", "symbol", '"symbols"'),
                                    ("--color", "lod", "load"), ("--legend", "cutt", '"cut"'),
                                    ("--theme", "drak", '"dark"'), ("--fit", "instnat", "instant"),
                                    ("--width", "84 mn", "mm"), ("--width", "84", "mm"), ("--scale", "9", "8"),
                                    ("--size", "1280xaut", "auto")):
            with self.subTest(value):
                done = self.expect(2, "figure", scene, "-o", "f.png" if option != "--width" else "f.svg", option, value)
                self.assertIn(said, done.stderr)
        self.assertEqual(self.files(), ["scene.json"])

    def test_names_without_room_are_told(self):
        scene = self.scene({**STANDING, "cube": [{"name": "a" * 60, "size": 0.1, "position": [0, 0.05]}]})
        for command, what in ((("figure", scene, "-o", "f.png"), "1 label"), (("run", scene, "--until", "0.1", "-o", "f/"), "up to 1 label of a frame")):
            done = self.expect(0, *command, "--layers", "cubes,names", *SMALL)
            self.assertIn(f"note: {what} has no room and is left out", done.stderr)
        summary = self.expect(0, "run", scene, "--until", "0.1", "-o", "f/", "--layers", "cubes,names", "--json", *SMALL)
        self.assertIn("no room", summary.stdout)

    def test_cubes_too_small_to_be_seen_are_told(self):
        scene = self.scene({"version": 1, "duration": 0, "cube": [{"name": f"c{x}", "position": [x, 0.5]} for x in (0, 2, 9000)]})
        done = self.expect(0, "figure", scene, "-o", "f.png")
        view = done.stderr.partition("--view ")[2].split()[0]
        self.assertLess(float(view.split(",")[2]), 30)
        self.assertNotIn("--view", self.expect(0, "figure", scene, "-o", "f.png", "--view", view).stderr)

    def test_a_legend_has_no_force_where_none_occurs(self):
        def texts(time):
            self.expect(0, "figure", "tilted_drop", "-t", time, "-o", "f.svg")
            with open(self.path("f.svg")) as file:
                drawn = [text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")]
            self.assertEqual(self.expect(0, "reproduce", "f.svg").stdout, "identical\n")
            return drawn
        self.assertFalse({"10 N", "thrust"} & set(texts("0.1")), "it flies")
        self.assertLessEqual({"10 N", "thrust"}, set(texts("1")))
        rods = self.call("figure", "newtons_cradle", "--explode", "0.3", "-o", "g.svg")
        self.assertEqual(rods.returncode, 0, rods.stderr)
        self.assertIn(">10 N<", self.content("g.svg"))

    def test_a_strip_has_one_legend(self):
        self.expect(0, "figure", self.scene(STANDING), "--strip", "2x1", "-o", "f.svg")
        with open(self.path("f.svg")) as file:
            texts = [text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")]
        self.assertEqual(sum(text.endswith(" N") for text in texts), 1, texts)
        self.assertEqual(sum(text.startswith("t = ") for text in texts), 2, texts)

    def test_a_legend_takes_a_second_row_or_tells_what_it_leaves_out(self):
        layers = ("--layers", "cubes,contact-forces,weights,velocities,accelerations,thrust,joints,normals,hud")
        scene = self.scene(FALLING)
        done = self.expect(0, "figure", scene, "--strip", "2x1", "--size", "640x360", "-o", "f.svg", *layers)
        self.assertNotIn("legend", done.stderr)
        with open(self.path("f.svg")) as file:
            texts = [text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")]
        for entry in ("weight", "pressure", "thrust", "normal"):
            self.assertIn(entry, texts)
        self.assertEqual(self.expect(0, "reproduce", "f.svg").stdout, "identical\n")
        done = self.expect(0, "figure", scene, "--strip", "2x1", "--size", "160x120", "-o", "f.svg", *layers)
        self.assertIn("entries of the legend have no room", done.stderr)

    def test_large_text_keeps_its_legend_or_tells_that_it_is_left_out(self):
        def drawn(*options):
            done = self.expect(0, "figure", self.scene(STANDING), "-o", "f.svg", "--layers", "cubes,forces,weights,velocities,hud", *options)
            with open(self.path("f.svg")) as file:
                texts = [text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")]
            self.assertEqual(self.expect(0, "reproduce", "f.svg").stdout, "identical\n")
            return texts, done.stderr
        for options in (("--scale", "2.6"), ("--scale", "3"), ("--width", "84mm", "--scale", "3", "--size", "1280xauto")):
            with self.subTest(options):
                texts, notes = drawn(*options)
                for entry in ("standing", "weight", "thrust"):
                    self.assertIn(entry, texts)
                self.assertEqual(notes, "")
        texts, notes = drawn("--scale", "4", "--size", "1280x720")
        self.assertNotIn("weight", texts)
        self.assertIn("the legend is left out", notes)
        self.assertIn("title and legend are left out", drawn("--size", "64x64")[1])
        done = self.expect(0, "run", self.scene(STANDING), "-o", "f/", "--fps", "1", "--scale", "4", "--size", "640x360")
        self.assertIn("the legend is left out", done.stderr)

    def test_forces_of_one_corner_all_have_their_numbers(self):
        done = self.expect(0, "figure", "incline_friction", "-t", "0.5", "--layers", "cubes,contact-forces,values,hud",
                           "-o", "f.png")
        self.assertEqual(done.stderr, "")

    def test_free_bodies_have_weights_and_numbers(self):
        scene = self.scene(STANDING)
        self.expect(0, "figure", scene, "--explode", "0.3", "-o", "f.png")
        self.expect(0, "figure", scene, "--explode", "0.3", "-o", "g.png", "--layers", "cubes,forces,weights,values,hud")
        self.assertEqual(self.expect(0, "compare", "f.png", "g.png").stdout, "identical\n")
        self.expect(0, "figure", scene, "--explode", "0.3", "--strip", "2x1", "-o", "f.svg")
        with open(self.path("f.svg")) as file:
            texts = [text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")]
        self.assertIn("weight", texts)
        self.assertNotIn("thrust", texts)

    def test_the_papers_symbols_stand_in_its_figures(self):
        for scene, layers, symbols in (("fig3_sides", "cubes,sides", "p|i|j|k|A > 0"),
                                       ("fig5_velocities", "cubes,normals,velocities", "p|i|j|k|v|α|1 − α|n"),
                                       ("fig6_relative_motion", "cubes,normals,velocities", "w|i,j|k|v|n"),
                                       ("fig7_masses", "cubes,points", "m/12|2m/3")):
            with self.subTest(scene):
                self.expect(0, "figure", scene, "--layers", layers + ",symbols", "-o", "f.svg")
                with open(self.path("f.svg")) as file:
                    texts = {text.text for text in ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")}
                self.assertLessEqual(set(symbols.split("|")), texts)

    def test_layers_that_show_nothing_alone_are_told(self):
        done = self.expect(0, "figure", self.scene(STANDING), "--layers", "cubes,values", "-o", "f.png", *SMALL)
        self.assertIn("the layer values shows nothing without", done.stderr)

    def test_loads_have_the_colours_of_the_film(self):
        scene = self.scene({**STANDING, "cube": [{"name": "a", "size": 1, "position": [0, 0.5]}, {"name": "b", "size": 1, "position": [0.2, 1.8]}]})
        loads = ("--color", "load", "--layers", "cubes,hud", *SMALL)
        self.expect(0, "run", scene, "-o", "film/", "--until", "0.6", "--fps", "20", *loads)
        self.expect(0, "reproduce", "film/frame_000010.png")

    def test_letters_that_the_font_does_not_have_are_told(self):
        done = self.expect(0, "figure", self.scene({**STANDING, "title": "立方体"}), "-o", "f.png", *SMALL)
        self.assertIn("U+7ACB", done.stderr)
        done = self.expect(0, "figure", self.scene({**STANDING, "title": "مكعب"}), "-o", "f.png", *SMALL)
        self.assertIn("right to left", done.stderr)

    def test_causes_mechanism_and_whiskers_in_every_format(self):
        scene = self.scene(FALLING)
        for layer, stands in (("causes", "fails by itself"), ("mechanism", "mechanism, not to scale"),
                              ("whiskers", "from least to most")):
            with self.subTest(layer):
                of = self.scene(HYPERSTATIC, "wall.json") if layer == "whiskers" else scene
                layers = ("--layers", "cubes,forces,hud," + layer)
                for name in ("f.png", "f.svg", "f.pdf"):
                    self.expect(0, "figure", of, "-o", name, *layers)
                with open(self.path("f.svg"), encoding="utf-8") as file:
                    svg = file.read()
                self.assertIn(stands, svg)
                self.assertIn(f'<g class="{layer}"', svg)
                self.expect(0, "figure", of, "-o", "g.png", "--layers", "cubes,forces,hud")
                self.expect(1, "compare", "f.png", "g.png")
                self.expect(0, "run", of, "-o", "film/", "--until", "0.1", "--fps", "20", "--size", "640x360", *layers)
                self.assertEqual(self.expect(0, "reproduce", "film/frame_000000.png").stdout, "identical\n")

    def test_whiskers_that_show_nothing_say_so(self):
        scene = self.scene(STANDING)
        done = self.expect(0, "figure", scene, "-o", "f.png", "--layers", "cubes,whiskers", *SMALL)
        self.assertIn("shows nothing without forces", done.stderr)
        many = {"version": 1, "plane": [{"point": [0, 0], "normal": [0, 1]}],
                "wall": [{"rows": 15, "columns": 20, "base": [0, 0], "size": [1, 1]}]}
        done = self.expect(0, "figure", self.scene(many), "-o", "f.png", "--layers", "cubes,forces,whiskers", *SMALL)
        self.assertIn("from 300 cubes on", done.stderr)

    def test_every_layer_option_can_be_made_again(self):
        scene = self.scene(FALLING)
        layers = ("cubes,forces,contact-forces,joints,thrust,whiskers,weights,accelerations,mechanism,causes,velocities,"
                  "values,names,symbols,hud")
        for arguments in (("--layers", layers), ("--explode", "0.4", "--layers", layers), ("--ghosts", "4"),
                          ("--color", "load"), ("--color", "speed"), ("--color", "island"), ("--layers", "instances"),
                          ("--fit", "instant"), ("--average", "0.05"), ("--size", "640xauto")):
            with self.subTest(arguments):
                self.expect(0, "figure", scene, "-t", "0.3", "-o", "f.png", *arguments)
                self.assertEqual(self.expect(0, "reproduce", "f.png").stdout, "identical\n")


class Strips(ProgramTest):
    def test_a_strip_has_the_shape_of_its_scene(self):
        self.expect(0, "figure", self.scene(STANDING), "--strip", "2x1", "-o", "f.png")
        width, height = png_size(self.path("f.png"))
        self.assertEqual(width, 1280)
        self.assertNotEqual(height, 720)
        self.assertEqual(self.expect(0, "reproduce", "f.png").stdout, "identical\n")

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

    def test_a_view_is_suggested_where_the_motion_is_wide_not_where_that_was_asked_for(self):
        wide = {"version": 1, "duration": 1, "cube": [{"position": [0, 0]}, {"position": [2000, 0]}]}
        figure = ("figure", self.scene(wide), "-o", "f.png", "--size", "640x360")
        self.assertIn("shows the largest group", self.expect(0, *figure).stderr)
        for asked in (("--zoom", "0.5"), ("--explode", "9")):
            self.assertNotIn("largest group", self.expect(0, *figure, *asked).stderr)

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
