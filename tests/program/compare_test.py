"""`compare` as the golden test of somebody else's project."""
import json
import os
import shutil

from program import FALLING, STANDING, ProgramTest, main, png_size

SMALL = ("--size", "200x120")


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        os.makedirs(self.path("a/sub"))
        os.makedirs(self.path("b"))
        self.draw("a/one.png", STANDING)
        self.draw("a/sub/two.png", FALLING)
        shutil.copytree(self.path("a"), self.path("b"), dirs_exist_ok=True)

    def draw(self, name, scene, *arguments):
        self.expect(0, "figure", self.scene(scene), "-o", name, *SMALL, *arguments)

    def report(self, code, *arguments):
        return json.loads(self.expect(code, "compare", *arguments, "--json").stdout)

    def test_equal_files_are_identical(self):
        done = self.expect(0, "compare", "a/one.png", "b/one.png", "-o", "d.png")
        self.assertEqual(done.stdout, "identical\n")
        self.assertNotIn("d.png", self.files())

    def test_a_different_picture_is_shown_side_by_side(self):
        self.draw("b/one.png", STANDING, "--layers", "cubes,hud")
        done = self.expect(1, "compare", "a/one.png", "b/one.png", "-o", "new/d.png")
        self.assertRegex(done.stdout, r"^different: \d+ pixels .*largest difference \d+ at \(\d+, \d+\), within")
        self.assertEqual(png_size(self.path("new/d.png")), (3 * 200 + 4 * 12, 120 + 26 + 12))

    def test_the_difference_replaces_no_picture_that_is_compared(self):
        for expected, actual, output in (("a/one.png", "b/one.png", "a/../a/one.png"), ("a/one.png", "b/one.png", "b/one.png"), ("a", "b", "a/")):
            done = self.expect(2, "compare", expected, actual, "-o", output)
            self.assertIn(f"{output} is read and would be replaced", done.stderr)

    def test_the_report_names_the_worst_place(self):
        self.draw("b/one.png", STANDING, "--layers", "cubes,hud")
        picture = self.report(1, "a/one.png", "b/one.png")["pictures"][0]
        left, top, right, bottom = picture["box"]
        x, y = picture["worst"]
        self.assertTrue(left <= x < right <= 200 and top <= y < bottom <= 120, picture)
        self.assertEqual(picture["share"], picture["changed"] / (200 * 120))

    def test_both_thresholds_can_be_set(self):
        self.draw("b/one.png", STANDING, "--layers", "cubes,hud")
        picture = self.report(1, "a/one.png", "b/one.png")["pictures"][0]
        difference, share = picture["largest_difference"], picture["share"]
        enough = ("--max-difference", str(difference), "--max-share", repr(share))
        self.assertEqual(self.report(0, "a/one.png", "b/one.png", *enough)["pictures"][0]["verdict"], "near_enough")
        self.report(1, "a/one.png", "b/one.png", "--max-difference", str(difference - 1), "--max-share", "1")
        self.report(1, "a/one.png", "b/one.png", "--max-difference", "255", "--max-share", repr(share * 0.99))
        for bad in (("--max-difference", "256"), ("--max-difference", "0.5"), ("--max-share", "1.1"), ("--max-share", "x")):
            self.expect(2, "compare", "a/one.png", "b/one.png", *bad)

    def test_folders_are_compared_file_by_file(self):
        self.assertEqual(self.expect(0, "compare", "a", "b").stdout, "0 of 2 pictures differ\n")
        self.draw("b/sub/two.png", FALLING, "--layers", "cubes")
        report = self.report(1, "a", "b", "-o", "d")
        self.assertEqual((report["compared"], report["different"], report["worst"]), (2, 1, "sub/two.png"))
        self.assertEqual((self.files("d"), self.files("d/sub")), (["sub"], ["two.png"]))

    def test_missing_and_new_pictures_are_differences(self):
        os.rename(self.path("b/one.png"), self.path("b/three.png"))
        report = self.report(1, "a/", "b/")
        verdicts = {picture["name"]: picture["verdict"] for picture in report["pictures"]}
        self.assertEqual(verdicts, {"one.png": "missing", "three.png": "new", "sub/two.png": "identical"})

    def test_update_accepts_what_is_there_now(self):
        self.draw("b/one.png", STANDING, "--layers", "cubes")
        os.rename(self.path("b/sub"), self.path("b/new"))
        done = self.expect(1, "compare", "a", "b", "--update")  # sub/two.png is still missing
        self.assertRegex(done.stdout, r"sub/two.png: missing.*delete it\n")
        self.assertTrue(done.stdout.endswith("1 of 3 pictures differ, most of all sub/two.png\n"), done.stdout)
        self.expect(0, "compare", "a/one.png", "b/one.png")
        self.expect(0, "compare", "a/new/two.png", "b/new/two.png")
        os.remove(self.path("a/sub/two.png"))
        self.assertEqual(self.report(0, "a", "b", "--update")["different"], 0)
        self.expect(0, "compare", "fresh/one.png", "b/one.png", "--update")
        self.expect(0, "compare", "a/one.png", "fresh/one.png")

    def test_what_is_no_picture_is_an_error(self):
        with open(self.path("text.png"), "w") as file:
            file.write("no picture")
        for arguments in (("a/one.png", "text.png"), ("a/one.png", "nowhere.png"), ("nowhere.png", "a/one.png"),
                          ("a", "b/one.png"), ("a/one.png", "b"), ("/dev/zero", "a/one.png"), ("nowhere.png", "text.png", "--update")):
            with self.subTest(arguments):
                self.assertTrue(self.expect(2, "compare", *arguments).stderr.strip())
        self.assertFalse(os.path.exists(self.path("nowhere.png")))

    def test_where_the_difference_cannot_be_written_nothing_is_accepted(self):
        self.draw("b/one.png", STANDING, "--layers", "cubes")
        with open(self.path("file"), "w"):
            pass
        self.expect(5, "compare", "a/one.png", "b/one.png", "-o", "file/d.png", "--update")
        self.expect(1, "compare", "a/one.png", "b/one.png")


if __name__ == "__main__":
    main()
