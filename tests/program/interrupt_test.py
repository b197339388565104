"""Ctrl-C and progress: what a person at a terminal meets."""
import os
import pty
import re
import signal
import subprocess
import time

from program import FLYING, PROGRAM, ProgramTest, main, png_chunks

LONG = ("--until", "100", "--size", "320x180")  # about 6000 frames: more than can be drawn before the signal

ENDLESS = ("--until", "1e6", "--integrator", "symplectic", "--step", "1e-6")


class Interrupt(ProgramTest):
    def stop(self, number, is_time, *arguments):
        process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING), *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 60
        while not is_time():
            self.assertIsNone(process.poll(), "ended before the signal")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        os.killpg(process.pid, number)  # as a terminal does: ffmpeg gets it too
        process.communicate(timeout=30)  # closes the pipes, too
        return process.returncode

    def frames_there(self):
        return os.path.exists(self.path("f/frame_000003.png"))

    def test_only_whole_files_stay(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                code = self.stop(number, self.frames_there, "-o", "f/", "-o", "f.mp4", "--states", "s.csv", *LONG)
                self.assertEqual(code, 128 + number)
                self.assertEqual(self.files(), ["f", "scene.json"])
                for name in self.files("f"):
                    self.assertRegex(name, r"^frame_\d{6}\.png$")
                    png_chunks(self.path("f/" + name))
                    os.remove(self.path("f/" + name))

    def test_a_long_simulation_without_pictures_stops_too(self):
        begin = time.monotonic()
        code = self.stop(signal.SIGINT, lambda: time.monotonic() > begin + 0.5, *ENDLESS)
        self.assertEqual(code, 130)
        self.assertLess(time.monotonic() - begin, 10)


class Progress(ProgramTest):
    def terminal_output(self, **environment):
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING), "-o", "f/", "--fps", "20", "--size", "160x90"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs,
                                   env={"PATH": os.environ["PATH"], "TERM": "xterm", **environment})
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:
                break
            if not piece:
                break
            text += piece
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        return text.decode()

    def test_a_terminal_gets_a_bar_with_a_rate(self):
        text = self.terminal_output()
        self.assertIn("\r[", text)
        self.assertRegex(text, r"21 of 21 frames +[\d.e+]+ frames/s")
        self.assertIn("\x1b[32m", text)

    def test_no_color_is_respected(self):
        self.assertIn("\r[", self.terminal_output(NO_COLOR="1"))
        self.assertNotIn("\x1b[32m", self.terminal_output(NO_COLOR="1"))

    def test_a_log_gets_lines_of_how_far_it_is(self):
        # Which lines are due is tested in unit/app/cli/progress_test.cpp, where no load of the machine moves the clock.
        process = subprocess.Popen([PROGRAM, "run", self.scene(FLYING), "--until", "200", "--integrator", "symplectic", "--step", "1e-5"],
                                   stderr=subprocess.PIPE, text=True)
        lines = [process.stderr.readline() for _ in range(2)]
        process.kill()
        process.communicate()
        done = [float(re.match(r"simulating +\d+ %  ([\d.e+]+) of 200 s [^\r\x1b]*left\n$", line)[1]) for line in lines]
        self.assertLess(done[0], done[1])

    def test_a_log_is_told_nothing_of_what_is_over_at_once(self):
        self.assertEqual(self.expect(0, "run", self.scene(FLYING), "--until", "0.1").stderr, "")


if __name__ == "__main__":
    main()
