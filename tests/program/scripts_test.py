"""app/setup with a package manager that only keeps a diary, and app/run from anywhere."""
import os
import subprocess

from program import ProgramTest, main

ROOT = os.environ["PROJECT"]


class SetUp(ProgramTest):
    def machine(self, missing=(), failing_installs=0):
        """Programs on PATH that pretend: all packages are there but `missing`."""
        os.makedirs(self.path("bin"), exist_ok=True)
        fakes = {
            "dpkg-query": f"""
                for p in "$@"; do case "$p" in -*|*'$'*) continue;; esac
                  case " {' '.join(missing)} " in *" $p "*) echo "dpkg-query: no packages found matching $p" >&2; bad=1;;
                    *) echo "$p:amd64 installed";; esac
                done; exit ${{bad:-0}}""",
            "apt-get": f"""
                echo "$*" >>{self.path('diary')}
                case "$*" in *install*) n=$(grep -c install {self.path('diary')}); [ "$n" -gt {failing_installs} ];; esac""",
            "id": "echo 0"}
        for name, text in fakes.items():
            with open(self.path("bin/" + name), "w") as file:
                file.write("#!/bin/bash\n" + text + "\n")
            os.chmod(self.path("bin/" + name), 0o755)
        done = subprocess.run([os.path.join(ROOT, "app/setup")], capture_output=True, text=True,
                              env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        if not os.path.exists(self.path("diary")):
            return done, []
        with open(self.path("diary")) as diary:
            return done, diary.read().splitlines()

    def test_it_is_silent_when_all_is_there(self):
        done, diary = self.machine()
        self.assertEqual((done.returncode, done.stdout, done.stderr, diary), (0, "", "", []))

    def test_it_installs_what_is_missing_and_only_that(self):
        done, diary = self.machine(missing=("ffmpeg", "g++"))
        self.assertEqual(done.returncode, 0)
        self.assertEqual(len(diary), 1)
        self.assertTrue(diary[0].endswith("g++ ffmpeg"), diary)
        self.assertEqual(done.stdout, "")
        self.assertIn("g++ ffmpeg", done.stderr)

    def test_it_refreshes_the_lists_once(self):
        done, diary = self.machine(missing=("cmake",), failing_installs=1)
        self.assertEqual(done.returncode, 0)
        self.assertEqual([line.split()[4] for line in diary], ["install", "update", "install"])

    def test_it_fails_where_nothing_helps(self):
        done, diary = self.machine(missing=("cmake",), failing_installs=9)
        self.assertEqual((done.returncode, len(diary)), (4, 3))
        self.assertIn("could not install: cmake", done.stderr)


class Run(ProgramTest):
    def test_it_works_from_any_folder_with_the_paths_of_the_caller(self):
        if os.path.join(ROOT, "build/release") != os.environ["BUILD"]:
            self.skipTest("this is not the build that app/run makes")
        self.scene({"version": 1, "cube": [{"position": [0, 0]}]}, "mine.json")
        done = subprocess.run([os.path.join(ROOT, "app/run"), "check", "mine.json"], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout.split()[0], done.stderr), (1, "falls", ""))


if __name__ == "__main__":
    main()
