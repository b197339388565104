"""Completions and man pages name every command and option that --help names; what the pages say of the program is so."""
import json
import os
import pathlib
import re
import subprocess

from program import PROGRAM, ProgramTest, main

PROJECT = pathlib.Path(os.environ["PROJECT"])


def declared(text):
    """The long options of a help text."""
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE))


class Pages(ProgramTest):
    def commands(self):
        listed = self.expect(0, "--help").stdout.split("Commands:\n")[1].split("\n\n")[0]
        return [line.split()[0] for line in listed.splitlines()]

    def known_options(self):
        texts = [self.expect(0, "--help").stdout] + [self.expect(0, command, "--help").stdout for command in self.commands()]
        sweeps = [line.split()[0] for line in texts[1 + self.commands().index("sweep")].split("Commands:\n")[1].split("\n\n")[0].splitlines()]
        texts += [self.expect(0, "sweep", command, "--help").stdout for command in sweeps]
        return {option for text in texts for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)}

    def complete(self, *words):
        """What bash offers for the last of the words."""
        script = ("source completions; COMP_WORDS=(wuerfel " + " ".join(f"'{word}'" for word in words) +
                  "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _wuerfel; printf '%s\\n' \"${COMPREPLY[@]}\"")
        path = f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}"
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              env={**os.environ, "PATH": path}, check=True)
        return done.stdout.split()

    def test_bash_completes_commands_options_values_and_scenes(self):
        with open(self.path("completions"), "w") as file:
            file.write(self.expect(0, "completions", "bash").stdout)
        self.assertEqual(self.complete("che"), ["check"])
        self.assertEqual(self.complete("run", "--inte"), ["--integrator"])
        self.assertEqual(self.complete("run", "demo", "--integrator", "ra"), ["rattle"])
        self.assertEqual(self.complete("figure", "demo", "--theme", "tr"), ["transparent"])
        self.assertIn("ladder", self.complete("check", "lad"))
        self.assertEqual(self.complete("run", "demo", "-o", "compl"), ["completions"])

    def test_every_shell_learns_every_option(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.expect(0, "completions", shell).stdout
            for command in self.commands():
                self.assertIn(command, script)
                for option in declared(self.expect(0, command, "--help").stdout):
                    self.assertIn(option.removeprefix("--") if shell == "fish" else option, script, (shell, command))

    def test_a_shell_that_is_not_there(self):
        self.assertIn("bash, zsh or fish", self.expect(2, "completions", "csh").stderr)

    def test_a_man_page_for_every_command(self):
        folder = pathlib.Path(os.environ["BUILD"], "app", "pages", "man", "man1")
        self.assertIn("check", (folder / "wuerfel.1").read_text())
        for command in self.commands():
            page = (folder / f"wuerfel-{command}.1").read_text().replace("\\-", "-")
            for option in declared(self.expect(0, command, "--help").stdout):
                self.assertIn(option, page, command)

    def test_commands_on_pages_have_only_options_that_there_are(self):
        known = self.known_options()
        asked = 0
        folders = ("app", "assets", "core", "render", "tests")
        for page in [*PROJECT.glob("*.md"), *(page for folder in folders for page in (PROJECT / folder).rglob("*.md"))]:
            for command in re.findall(r"`(wuerfel [^`\n]+)`|^\$ (wuerfel [^|\n]+)", page.read_text(), re.MULTILINE):
                for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", "".join(command)):
                    self.assertIn(option, known, f"{page}: {command}")
                    asked += 1
        self.assertGreater(asked, 10)

    def test_the_first_scene_of_the_readme_has_the_answer_shown(self):
        page = (PROJECT / "README.md").read_text()
        section = page.split("\n## A scene and its answer\n")[1].split("\n## ")[0]
        with open(self.path("floor.toml"), "w") as file:
            file.write(re.search(r"```toml\n(.*?)```", section, re.DOTALL)[1])
        shown = re.search(r"```\n\$ wuerfel check floor.toml\n(.*?)\n\$ wuerfel run", section, re.DOTALL)[1]
        self.assertEqual(self.expect(1, "check", "floor.toml").stdout.rstrip(), shown)
        outcome = json.loads(re.search(r"jq -c .outcome\n(.*?)\n", section)[1])
        run = self.expect(0, "run", "floor.toml", "--until", "1", "-o", "floor.mp4", "--size", "64x64", "--json")
        self.assertEqual(json.loads(run.stdout)["outcome"], outcome)


if __name__ == "__main__":
    main()
