"""Values of options that are refused, each with what is wrong with it."""
from program import FLYING, ProgramTest, main


class OptionValues(ProgramTest):
    def test_an_empty_name_is_refused(self):
        scene = self.scene(FLYING)
        for command, options in {"run": ("--states", "--forces", "--events", "--summary", "--failed-programs", "--checkpoint", "--resume"),
                                 "explain": ("-o",), "figure": ("-o",)}.items():
            for option in options:
                with self.subTest(option):
                    self.assertIn("must not be empty", self.refuse(command, scene, option, ""))
        for arguments in (("run", ""), ("check", ""), ("scenes", ""), ("compare", "", scene), ("reproduce", scene, "-o", ""),
                          ("compare", scene, scene, "-o", ""), ("sweep", "plan", scene, "-o", ""), ("sweep", "verify", ".", "--id", "")):
            with self.subTest(arguments):
                self.assertIn("must not be empty", self.refuse(*arguments))
        self.assertEqual(self.files(), ["scene.json"])

    def test_a_number_below_0_is_no_time_where_none_is_asked_for(self):
        for option in ("--velocity-scale", "--acceleration-scale", "--color-top", "--explode", "--rod-scale", "--ghosts"):
            with self.subTest(option):
                self.assertIn(f"{option}: -1 is less than 0", self.refuse("figure", self.scene(FLYING), "-o", "f.png", option, "-1"))

    def test_lengths_and_times_nobody_can_draw_are_refused(self):
        scene = self.scene(FLYING)
        for arguments, words in ((("figure", scene, "-o", "f.pdf", "--width", "1e9mm"), "not between 1 mm and 5080 mm"),
                                 (("figure", scene, "-o", "f.svg", "--width", "1e-9mm"), "not between 1 mm and 5080 mm"),
                                 (("figure", scene, "-o", "f.png", "--scale", "1e-7"), "not between 0.01 and 8"),
                                 (("figure", scene, "-o", "f.png", "--strip", "2x2", "--until", "1e308"), "more than 1e+15"),
                                 (("figure", scene, "-o", "f.png", "--set", "duration=1e9"), "--fit instant"),
                                 (("run", scene, "-o", "f.gif", "--fps", "1e-300"), "less than 0.001"),
                                 (("run", scene, "-o", "f.gif", "--hold", "1e14"), "--hold")):
            with self.subTest(arguments):
                self.assertIn(words, self.refuse(*arguments))
        self.expect(0, "figure", scene, "-o", "f.png", "--size", "64x64", "--set", "duration=1e9", "--fit", "instant")
        self.assertEqual(self.files(), ["f.png", "scene.json"])


if __name__ == "__main__":
    main()
