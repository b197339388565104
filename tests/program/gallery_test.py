"""The commands of the gallery's page make the pictures that it shows."""
import os
import re
import subprocess

from program import PROGRAM, ProgramTest, main

GALLERY = os.path.join(os.environ["PROJECT"], "assets/gallery")


class Gallery(ProgramTest):
    def test_every_command_makes_the_picture_shown(self):
        subprocess.run([os.path.join(GALLERY, "draw"), self.folder], env={**os.environ, "WUERFEL": PROGRAM}, check=True,
                       capture_output=True, timeout=600)
        with open(os.path.join(GALLERY, "README.md")) as page:
            shown = re.findall(r"^!\[.*\]\((.*)\)$", page.read(), re.MULTILINE)
        self.assertEqual(sorted(shown), self.files())
        for name in shown:
            if name.endswith(".png"):
                with self.subTest(name):
                    self.expect(0, "compare", os.path.join(GALLERY, name), name)


if __name__ == "__main__":
    main()
