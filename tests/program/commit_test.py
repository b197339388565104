"""tests/benchmark/bench/commit.cmake in small repositories, run by Ninja as the build does: right commits, and nothing to do when nothing has changed."""
import os
import re
import subprocess

from program import ProgramTest, main

SCRIPT = os.path.join(os.environ["PROJECT"], "tests/benchmark/bench/commit.cmake")
RULES = """
rule commit
  command = cmake -DROOT={root} -DOUTPUT={build}/commit.cpp -DDEPFILE={build}/commit.cpp.d -P {script}
  depfile = {build}/commit.cpp.d
  restat = 1
build {build}/commit.cpp: commit
"""


class Commit(ProgramTest):
    def run_in(self, folder, *command):
        # No settings of the user's, and no repository but the one in the folder.
        settings = {k: v for k, v in os.environ.items() if not k.startswith("GIT_")}
        settings.update(GIT_CONFIG_GLOBAL=os.devnull, GIT_CONFIG_NOSYSTEM="1", GIT_CEILING_DIRECTORIES=self.folder)
        done = subprocess.run(command, cwd=folder, env=settings, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{command}: {done.stdout}{done.stderr}")
        return done.stdout.strip()

    def git(self, folder, *arguments):
        return self.run_in(folder, "git", "-c", "user.name=a", "-c", "user.email=a@example.org", *arguments)

    def source(self, name):
        """A folder with one file of the program and one that is none of it."""
        folder = self.path(name)
        os.makedirs(folder + "/core")
        for file in ("core/a b.cpp", "README.md"):
            self.write(folder, file, "one\n")
        return folder

    def write(self, folder, file, text):
        with open(os.path.join(folder, file), "w") as stream:
            stream.write(text)

    def repository(self, name):
        folder = self.source(name)
        self.git(folder, "init", "-q")
        self.commit_all(folder)
        return folder

    def commit_all(self, folder):
        self.git(folder, "add", ".")
        self.git(folder, "commit", "-q", "-m", "some")

    def head(self, folder):
        return self.git(folder, "rev-parse", "--short=12", "HEAD")

    def built(self, root):
        """What commit() would say after a build; a second build must have nothing to do."""
        build = root + ".build"
        os.makedirs(build, exist_ok=True)
        self.write(build, "build.ninja", RULES.format(root=root, build=build, script=SCRIPT))
        self.run_in(build, "ninja")
        self.assertIn("no work to do", self.run_in(build, "ninja", "-n"))
        with open(build + "/commit.cpp") as source:
            return re.search('return "(.*)"', source.read())[1]

    def test_it_follows_commits_and_changes(self):
        folder = self.repository("plain")
        self.assertEqual(self.built(folder), self.head(folder))
        self.write(folder, "core/a b.cpp", "two\n")
        self.assertEqual(self.built(folder), self.head(folder) + "+")
        before = self.head(folder)
        self.commit_all(folder)
        self.assertNotEqual(self.head(folder), before)
        self.assertEqual(self.built(folder), self.head(folder))
        os.remove(folder + "/core/a b.cpp")
        self.assertEqual(self.built(folder), self.head(folder) + "+")
        self.git(folder, "checkout", "-q", ".")
        self.assertEqual(self.built(folder), self.head(folder))

    def test_what_is_no_part_of_the_program_does_not_count(self):
        folder = self.repository("plain")
        self.write(folder, "README.md", "two\n")
        self.assertEqual(self.built(folder), self.head(folder))

    def test_it_knows_worktrees(self):
        folder = self.repository("plain")
        tree = self.path("tree")
        self.git(folder, "worktree", "add", "-q", "-b", "other", tree)
        self.assertEqual(self.built(tree), self.head(tree))
        self.write(tree, "core/a b.cpp", "two\n")
        self.commit_all(tree)
        self.assertNotEqual(self.head(tree), self.head(folder))
        self.assertEqual(self.built(tree), self.head(tree))

    def test_it_is_unknown_outside_git_and_in_a_repository_of_others(self):
        self.assertEqual(self.built(self.source("alone")), "unknown")
        folder = self.repository("theirs")
        self.source("theirs/wuerfel")
        self.commit_all(folder)
        self.assertEqual(self.built(folder + "/wuerfel"), "unknown")


if __name__ == "__main__":
    main()
