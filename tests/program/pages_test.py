"""Completions and man pages name every command and option that --help names."""
import os
import pathlib
import re
import subprocess

from program import PROGRAM, ProgramTest, main


def declared(text):
    """The long options of a help text."""
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE))


class Pages(ProgramTest):
    def commands(self):
        listed = self.expect(0, "--help").stdout.split("Commands:\n")[1].split("\n\n")[0]
        return [line.split()[0] for line in listed.splitlines()]

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


if __name__ == "__main__":
    main()
