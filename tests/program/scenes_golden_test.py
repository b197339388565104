"""Golden pictures of shipped scenes, from the scene file to the pixels: the motion, the forces and how they are drawn.

    tests/program/scenes_golden_test.py --update-golden    stores what is drawn now; look at it before committing
"""
import os
import sys

from program import ProgramTest, main

EXPECTED = os.path.join(os.environ["PROJECT"], "tests/golden/scenes")

SCENES = {
    "wall": ("wall",),
    "pile": ("pile", "-t", "2"),
    "ladder": ("ladder", "-t", "0.75"),
    "demo": ("demo", "-t", "0.8", "--layers", "cubes,forces,velocities,names,hud"),
}
UPDATE = "--update-golden" in sys.argv


class ShippedScenes(ProgramTest):
    def test_look_as_they_did(self):
        for name, arguments in SCENES.items():
            with self.subTest(name):
                picture = os.path.join(EXPECTED, name + ".png")
                self.expect(0, "figure", *arguments, "--size", "960x540", "-o", picture if UPDATE else name + ".png")
                self.expect(0, "compare", picture, picture if UPDATE else name + ".png")

    def test_a_force_more_is_seen(self):
        """The comparison is fine enough for the smallest thing that a picture says."""
        self.expect(0, "figure", "wall", "--size", "960x540", "--set", "wall.1.rows=4", "-o", "w.png")
        self.expect(1, "compare", os.path.join(EXPECTED, "wall.png"), "w.png")
        self.expect(0, "figure", "ladder", "-t", "0.75", "--size", "960x540", "--layers", "cubes,hud", "-o", "l.png")
        self.expect(1, "compare", os.path.join(EXPECTED, "ladder.png"), "l.png")


if __name__ == "__main__":
    if UPDATE:
        sys.argv.remove("--update-golden")
    main()
