"""check --margin --ranges --bodies, and explain: answers, their JSON, bad input."""
import json
import math
import os
import re
from xml.etree import ElementTree

from program import FALLING, FLYING, LANDING, STANDING, ProgramTest, main, png_size, png_texts

G = 9.81
TOWER = {"version": 1, "plane": [{"name": "floor", "point": [0, 0], "normal": [0, 1]}],
         "cube": [{"name": f"c{i}", "position": [0.1 * (i % 2), 0.5 + i]} for i in range(4)]}
RUBBING = {**TOWER, "material": {"friction": 0.6}}


class Margins(ProgramTest):
    def check(self, scene, *arguments, code=0):
        return json.loads(self.expect(code, "check", self.scene(scene), "--json", *arguments).stdout)

    def test_nothing_is_added_that_was_not_asked_for(self):
        answer = self.check(TOWER)
        for key in ("margin", "degree", "interfaces"):
            self.assertNotIn(key, answer)
        self.assertNotIn("min", answer["contacts"][0])

    def test_all_margins(self):
        margin = self.check(TOWER, "--margin")["margin"]
        self.assertEqual(list(margin), ["tilt", "bodies", "smallest", "error", "weakest"])
        self.assertEqual(margin["tilt"]["unit"], "rad")
        self.assertEqual(margin["tilt"]["given"], {"left": 0.0, "right": 0.0})
        self.assertGreater(margin["tilt"]["no_sliding"]["left"], 0.1)
        top = margin["bodies"]["c3"]
        self.assertAlmostEqual(top["shift"][0], -0.5, places=12)
        self.assertAlmostEqual(top["shift"][1], 0.4, places=12)
        self.assertIsNone(margin["bodies"]["c0"]["load"])  # no limit in the middle
        self.assertAlmostEqual(top["lift"], G, places=8)
        self.assertAlmostEqual(top["move"][1], 0.4, places=8)
        self.assertEqual(margin["bodies"]["c0"]["move"], [None, None])
        self.assertAlmostEqual(margin["smallest"], 0.4, places=12)
        self.assertEqual(margin["weakest"], "c3")
        self.assertLess(margin["error"], 1e-8)

    def test_some_of_them(self):
        scene = self.scene(TOWER)
        for form in (("--margin", "tilt"), ("--margin=tilt",)):
            margin = json.loads(self.expect(0, "check", scene, *form, "--json").stdout)["margin"]
            self.assertEqual(list(margin), ["tilt", "error"])
        margin = json.loads(self.expect(0, "check", "--json", "--margin", scene, "--bodies", "c1,c3").stdout)["margin"]
        self.assertEqual(list(margin["bodies"]), ["c1", "c3"])
        margin = self.check(TOWER, "--margin", "load,shift")["margin"]
        self.assertEqual(sorted(margin["bodies"]["c0"]), ["lift", "load", "shift"])

    def test_ranges(self):
        wide = {"version": 1, "fixed": [{"name": f"s{i}", "size": 0.5, "position": [x, -0.25]} for i, x in enumerate((-1, 0, 1))],
                "cube": [{"name": "beam", "size": [3, 0.5], "position": [0, 0.25], "mass": 2}]}
        answer = self.check(wide, "--ranges")
        self.assertEqual(answer["degree"], 4)
        self.assertEqual(len(answer["interfaces"]), 3)
        for contact in answer["contacts"]:
            self.assertLessEqual(contact["min"], contact["force"] + 1e-9)
            self.assertGreaterEqual(contact["max"], contact["force"] - 1e-9)
            self.assertEqual(contact["max"] - contact["min"] < 1e-9, contact["unique"])
        middle = next(f for f in answer["interfaces"] if "s1" in f["bodies"])
        self.assertEqual(list(middle), ["bodies", "normal", "resultant", "range", "center", "center_range", "eccentricity"])
        self.assertAlmostEqual(middle["range"][1], 2 * G, places=7)
        self.assertAlmostEqual(middle["center_range"][0], -0.25, places=9)

    def test_text(self):
        text = self.expect(0, "check", self.scene(TOWER), "--margin", "--ranges").stdout
        for words in ("degrees to the left", "no limit", "hyperstatic of degree 0", "shift of weight"):
            self.assertIn(words, text)
        text = self.expect(0, "check", self.scene(RUBBING), "--margin").stdout
        self.assertIn("an equilibrium exists", text)
        self.assertIn("not sufficient", text)

    def test_friction_sets_a_limit_to_tilting(self):
        tilt = self.check(RUBBING, "--margin", "tilt")["margin"]["tilt"]
        self.assertLess(tilt["given"]["left"], math.atan(0.6) + 1e-9)

    def test_what_moves_has_none(self):
        done = self.expect(1, "check", self.scene(FLYING), "--margin", "--json")
        self.assertNotIn("margin", json.loads(done.stdout))
        self.assertIn("this one moves", done.stderr)

    def test_what_an_impact_at_the_start_has_stopped_stands_there(self):
        margin = self.check(LANDING, "--margin")["margin"]
        self.assertEqual(margin["bodies"]["a"]["shift"], [-0.5, 0.5])

    def test_rounding_is_no_result_and_columns_stand_below_their_names(self):
        long = "a pillar with a long name"
        sliding = {"version": 1, "material": {"friction": 0.15}, "plane": [{"name": "ground", "normal": [-0.2, 1]}],
                   "cube": [{"name": long, "size": [0.6, 1.5], "mass": 300, "on": "ground"},
                            {"name": "cap", "size": [1, 0.3], "mass": 100, "on": long, "offset": 0.1}]}
        text = self.expect(1, "check", self.scene(sliding), "--ranges").stdout
        self.assertNotRegex(text, r"e-1\d")
        for table in (text.split("\n\n")[k] for k in (1, 3)):
            lines = table.strip("\n").split("\n")
            self.assertGreater(len(lines), 2)
            column = lines[0].index("from")
            self.assertEqual({line[column:column + 6].strip() for line in lines[1:]}, {"cap", "ground"})
            self.assertEqual(len({len(line) for line in lines}), 1, table)

    def test_what_does_not_move_and_what_does_not_press_is_no_rounding(self):
        wall = {"version": 1, "material": {"friction": 0.6}, "plane": [{"name": "ground"}],
                "wall": [{"name": "w", "rows": 6, "columns": 3, "size": [0.4, 0.2], "density": 2400, "on": "ground"}]}
        self.assertNotRegex(self.expect(0, "check", self.scene(wall)).stdout, r"e-1\d")
        slides = {"version": 1, "material": {"friction": 0.6}, "plane": [{"name": "ground"}],
                  "cube": [{"name": "base", "size": [1, 0.25], "on": "ground"},
                           {"name": "tips", "size": [1, 0.25], "on": "base", "offset": 0.6}]}
        text = self.expect(1, "check", self.scene(slides)).stdout
        self.assertIn("  tips: ", text)
        self.assertNotRegex(text, r"  base: .*e-1\d")

    def test_names_that_are_not_there(self):
        scene = self.scene(TOWER)
        self.assertIn("there is no cube 'd1'; did you mean", self.expect(2, "check", scene, "--margin", "--bodies", "d1").stderr)
        self.assertIn("floor", self.expect(2, "check", scene, "--ranges", "--bodies", "floor").stderr)
        self.assertIn("'tlit' is unknown", self.expect(2, "check", scene, "--margin", "tlit,load").stderr)
        foo = self.expect(2, "check", scene, "--margin", "foo").stderr
        self.assertIn("--margin: 'foo' is unknown", foo)
        self.assertIn("tilt, load, shift, move", foo)
        self.assertIn("nowhere.toml: no such file", self.expect(2, "check", "--margin", "nowhere.toml").stderr)
        self.expect(1, "check", "--margin", "fig1_stack")
        self.assertIn("does nothing", self.expect(0, "check", scene, "--bodies", "c1").stderr)


class Explain(ProgramTest):
    def explain(self, scene, *arguments, code=1):
        return json.loads(self.expect(code, "explain", self.scene(scene), "--json", *arguments).stdout)

    def test_a_falling_stack(self):
        answer = self.explain(FALLING)
        self.assertEqual(list(answer), ["verdict", "certificate", "causes", "mechanism", "fixes", "text"])
        self.assertEqual(answer["verdict"], "falls")
        self.assertGreater(answer["certificate"]["power"], 0)
        self.assertGreater(answer["certificate"]["worst_closing"], -1e-9)
        cause, = answer["causes"]
        self.assertEqual((cause["part"], cause["on"]), (["b"], ["a"]))
        self.assertAlmostEqual(cause["outside"], 0.1, places=9)
        self.assertEqual(cause["corner"], [0.5, 1.0])
        for fix in answer["fixes"]:
            self.assertEqual(fix["verified"], "stands")
        move = next(f for f in answer["fixes"] if f["kind"] == "move")
        self.assertAlmostEqual(move["distance"], -0.1, places=8)
        self.assertIn("100 mm outside", answer["text"][0])

    def test_every_fix_mends_the_scene(self):
        answer = self.explain(FALLING)
        move = next(f for f in answer["fixes"] if f["kind"] == "move")
        for share, code in ((1.0, 0), (0.999, 1)):
            x = 0.6 + share * move["distance"]
            self.expect(code, "check", self.scene(FALLING), "--set", f"cube.b.position=[{x!r}, 1.5]")

    def test_corners_are_named_as_the_sides_of_a_leaning_body_lie(self):
        s = math.sqrt(0.5)  # two bars of 45 degrees, hinged at their heads
        bar = {"size": [2, 0.2], "density": 2500, "friction": 0.4}
        frame = {"version": 1, "plane": [{"name": "ground", "friction": 0.4}],
                 "cube": [{"name": name, "angle_deg": -45 * side, "position": [side * s, 1.1 * s], **bar}
                          for name, side in (("left", -1), ("right", 1))],
                 "pin": [{"from": "left.e", "to": "right.w", "collide": False}]}
        answer = self.explain(frame)
        left = next(f for f in answer["fixes"] if f["body"] == "left")
        for k, at in enumerate((0.1 * s, 1.9 * s + 0.1 * s)):
            self.assertAlmostEqual(left["point"][k], at, places=9)
        # By hand: what lifts the crown there by F leaves H = 0.4286 W - 0.4762 F, of which 0.4 (W - 0.5263 F) is to be had.
        self.assertAlmostEqual(left["force"][1] / (1000 * G), 0.10755, places=4)
        self.assertTrue(any("at the lower right corner of left" in text for text in answer["text"]), answer["text"])

    def test_all_that_gives_way_together_is_told(self):
        side = [{"name": f"{name}{k}", "size": [1, 0.25], "position": [sign * x, 0.125 + 0.25 * k]}
                for name, sign in (("l", -1), ("r", 1)) for k, x in enumerate((2, 1.85, 1.55, 1.1, 0.5))]
        arch = {"version": 1, "material": {"friction": 0.6}, "plane": [{"name": "ground"}],
                "cube": [*side, {"name": "key", "size": [1.2, 0.25], "position": [0, 1.375]}]}
        told = self.explain(arch)
        self.assertEqual(len(told["mechanism"]), 5)
        moving = [text for text in told["text"] if "of the work" in text]
        self.assertAlmostEqual(sum(int(text.split("does ")[1].split(" %")[0]) for text in moving), 100, delta=2)
        self.assertIn("l2 and l3 turn to the right, part from l1; their weight does", moving[0])
        self.assertIn("l2 und l3 drehen sich nach rechts, lösen sich von l1", self.explain(arch, "--language", "de")["text"][1])

    def test_both_languages(self):
        scene = self.scene(FALLING)
        self.assertIn("tips to the right", self.expect(1, "explain", scene).stdout)
        german = self.expect(1, "explain", scene, "--language", "de").stdout
        self.assertIn("kippt nach rechts", german)
        self.assertIn("1,64 N", self.expect(1, "explain", scene, "--language", "de").stdout)
        self.assertIn("en or de", self.expect(2, "explain", scene, "--language", "fr").stderr)

    def test_what_stands_and_what_moves(self):
        answer = self.explain(STANDING, code=0)
        self.assertEqual((answer["causes"], answer["certificate"]), ([], None))
        self.assertIn("It stands.", answer["text"])
        self.assertIn("a is moving from the start.", self.expect(1, "explain", self.scene(FLYING)).stdout)

    def test_where_something_rubs_the_tilt_is_that_of_friction(self):
        block = {"version": 1, "material": {"friction": 0.5}, "plane": [{"name": "floor"}],
                 "cube": [{"name": "b", "size": [1, 0.5], "on": "floor"}]}
        text = self.explain(block, code=0)["text"]
        self.assertIn("Forces that hold it exist up to a tilt of 26.6° to the left and 26.6° to the right.", text)  # atan 0.5
        self.assertIn("If nothing could slide, it would stand up to a tilt of 63.4° to the left and 63.4° to the right.", text)
        self.assertFalse(any("Forces that" in line for line in self.explain(TOWER, code=0)["text"]))

    def test_facts_where_something_rubs(self):
        answer = self.explain(RUBBING, code=0)
        self.assertEqual(answer["facts"], {"equilibrium_exists": True, "acceleration_zero": True})

    def test_every_shipped_scene_is_explained(self):
        folder = os.environ["SCENES"]
        for name in sorted(os.listdir(folder)):
            if not name.endswith(".toml"):
                continue
            for language in ("en", "de"):
                with self.subTest(name=name, language=language):
                    done = self.call("explain", os.path.join(folder, name), "--language", language)
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    self.assertGreater(len(done.stdout), 10)
                    self.assertNotIn("{", done.stdout)

    def test_a_picture(self):
        scene = self.scene(FALLING)
        for name in ("why.png", "why.svg", "why.pdf"):
            text = self.expect(1, "explain", scene, "-o", name, "--size", "400x300", "--language", "de").stdout
            self.assertIn("kippt", text)
            self.assertIn(name, self.files())
        self.assertEqual(png_size(self.path("why.png")), (400, 300))
        self.assertIn("--why de", png_texts(self.path("why.png"))["Options"])
        for name in ("why.png", "why.svg"):
            self.expect(0, "reproduce", name)

    def texts(self, scene, *options):
        """Of the picture of a scene, and what is noted."""
        done = self.expect(1, "explain", scene, "-o", "why.svg", *options)
        with open(self.path("why.svg")) as file:
            drawn = file.read()
        return [text.text for text in ElementTree.fromstring(drawn).iter("{http://www.w3.org/2000/svg}text")], drawn, done.stderr

    def test_a_picture_tells_how_all_gives_way_together(self):
        texts, _, _ = self.texts("drawbridge")
        self.assertIn("No part fails by itself; together they give way:", texts)
        self.assertEqual(len([text for text in texts if "of the work" in text]), 3, texts)

    def test_a_picture_marks_two_causes_and_what_helps_above_them(self):
        sliding = {"version": 1, "material": {"friction": 0.15}, "plane": [{"name": "ground", "normal": [-0.2, 1]}],
                   "cube": [{"name": "pillar", "size": [0.6, 1.5], "mass": 300, "on": "ground"},
                            {"name": "cap", "size": [1, 0.3], "mass": 100, "on": "pillar", "offset": 0.1}]}
        texts, drawn, _ = self.texts(self.scene(sliding))
        self.assertTrue(any(text.startswith("cap moves") for text in texts), texts)
        self.assertTrue(any(text.startswith("pillar and cap together move") for text in texts), texts)
        self.assertLess(drawn.index('"causes"'), drawn.index('"fixes"'))

    def test_a_picture_holds_what_a_fix_moves(self):
        plank = {"version": 1, "fixed": [{"name": "post", "size": 0.5, "position": [0, -0.25]}],
                 "cube": [{"name": "plank", "size": [4, 0.2], "on": "post"}]}
        for side in (1, -1):
            plank["cube"][0]["offset"] = 2.2 * side
            self.expect(1, "explain", self.scene(plank), "-o", "why.png")
            x, _, width = (float(number) for number in re.search(r"--view ([-\d.e]+),([-\d.e]+),([-\d.e]+)", png_texts(self.path("why.png"))["Options"]).groups())
            # It is moved onto the edge of the post, and reaches 1.75 m to the other side.
            self.assertLess(-side * x - width / 2, -1.75)
            self.assertGreater(-side * x + width / 2, 1.75)

    def test_names_without_room_are_noted(self):
        long = {**FALLING, "cube": [{**cube, "name": "the one whose name is much too long for it " + cube["name"]}
                                    for cube in FALLING["cube"]]}
        self.assertIn("labels have no room", self.texts(self.scene(long), "--size", "320x240")[2])

    def test_pictures_of_what_stands_and_of_what_moves(self):
        for scene, code in ((STANDING, 0), (FLYING, 1)):
            self.expect(code, "explain", self.scene(scene), "-o", "why.png", "--size", "320x180", "--theme", "dark")
            self.expect(0, "reproduce", "why.png")

    def test_picture_names_that_make_no_sense(self):
        scene = self.scene(FALLING)
        for name in ("-", "why.gif", "why", ""):
            with self.subTest(name=name):
                self.expect(2, "explain", scene, "-o", name)
        self.expect(2, "explain", scene, "-o", "why.png", "--size", "3x3")
        self.assertEqual(self.files(), ["scene.json"])
        self.assertIn("does nothing", self.expect(1, "explain", scene, "--theme", "dark").stderr)

    def test_check_names_the_first_cause(self):
        text = self.expect(1, "check", self.scene(FALLING)).stdout
        self.assertIn("b tips to the right over the corner of a: its centre of mass is 100 mm outside.", text)


if __name__ == "__main__":
    main()
