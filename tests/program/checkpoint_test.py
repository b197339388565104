"""Runs that are stopped and taken up again: the same states, frames and books as a run in one go."""
import hashlib
import json
import os
import random
import signal
import subprocess
import sys
import time

from program import FLOOR, PROGRAM, ProgramTest, main

# A crowd: restarts come after so many steps times cubes, so this one has some within its two seconds.
CROWD = {"version": 1, "title": "crowd", "duration": 2.0, "plane": [FLOOR],
         "fixed": [{"name": "left", "size": [0.2, 6], "position": [-2, 3]}, {"name": "right", "size": [0.2, 6], "position": [2, 3]}],
         "pile": [{"count": 40, "region": [-1.7, 0.3, 1.7, 5], "size": 0.3, "seed": 3}]}
KILLS = int(os.environ.get("KILLS", "3"))
LOOKS = ("--fps", "20", "--states", "s.csv", "--forces", "f.csv", "--events", "e.jsonl", "--sample", "0.31,1.7", "--quiet")
# By steps of one length the same work is done soon.
STEPS = ("--integrator", "moreau", "--step", "0.0003", "--set", "pile.pile1.count=11")


class Resume(ProgramTest):
    def setUp(self):
        super().setUp()
        self.crowd = self.scene(CROWD)

    def outputs(self, *names):
        found = {}
        for name in names:
            with open(self.path(name), "rb") as file:
                found[name] = hashlib.sha256(file.read()).hexdigest()
        return found

    def run_through(self, *arguments):
        summary = json.loads(self.expect(0, "run", self.crowd, *LOOKS, *arguments, "--json").stdout)
        summary.pop("cost")
        return summary, self.outputs("s.csv", "f.csv", "e.jsonl")

    def frames_there(self):
        return len([name for name in self.files("f") if name.startswith("frame_")]) if os.path.exists(self.path("f")) else 0

    def stopped(self, number, after, *arguments, frames=0):
        """Runs until a checkpoint and so many frames are there and so long beyond, then sends the signal."""
        process = subprocess.Popen([PROGRAM, "run", self.crowd, *LOOKS, *arguments], cwd=self.folder, stderr=subprocess.DEVNULL)
        while process.poll() is None and not (os.path.exists(self.path("c.bin")) and self.frames_there() >= frames):
            time.sleep(0.002)
        time.sleep(after)
        process.send_signal(number)
        return process.wait(timeout=60)

    def test_a_run_taken_up_again_has_the_bits_of_one_in_one_go(self):
        for options in ((), STEPS):
            with self.subTest(options):
                whole = self.run_through(*options)
                for name in ("s.csv", "f.csv", "e.jsonl"):
                    os.remove(self.path(name))
                code = self.stopped(signal.SIGKILL, 0.0, *options, "--checkpoint", "c.bin", "--every", "0.05")
                self.assertIn(code, (-signal.SIGKILL, 0))
                self.assertEqual(self.run_through(*options, "--resume", "c.bin"), whole)
                # Keeping checkpoints changes nothing either.
                self.assertEqual(self.run_through(*options, "--checkpoint", "c.bin", "--every", "0.05"), whole)
                os.remove(self.path("c.bin"))

    def test_a_signal_leaves_a_checkpoint(self):
        whole = self.run_through(*STEPS)
        for number in (signal.SIGINT, signal.SIGTERM):
            code = self.stopped(number, 0.05, *STEPS, "--checkpoint", "c.bin", "--every", "0.02")
            self.assertIn(code, (128 + number, 0))
            self.assertEqual(self.run_through(*STEPS, "--resume", "c.bin"), whole)
            os.remove(self.path("c.bin"))

    def test_frames_and_films_are_those_of_a_run_in_one_go(self):
        """Killed while it simulates, draws, encodes and writes: at any time, or when some number of frames is there."""
        pictures = ("-o", "f/", "-o", "f.apng", "--size", "160x90", *STEPS)
        checkpoints = ("--checkpoint", "c.bin", "--every", "0.1")
        frames = [f"f/frame_{k:06}.png" for k in range(41)]
        results = ("f.apng", "s.csv", "f.csv", "e.jsonl", *frames)
        begin = time.monotonic()
        self.run_through(*pictures, *checkpoints)
        length = time.monotonic() - begin
        whole = self.outputs(*results)
        shuffle = random.Random(KILLS)
        alive, drawing = 0, 0
        for kill in range(KILLS):
            for name in (*results, "c.bin"):
                os.remove(self.path(name))
            wanted, after = (shuffle.randint(1, 41), 0.02) if kill % 2 else (0, length)
            code = self.stopped(signal.SIGKILL, shuffle.uniform(0.0, after), *pictures, *checkpoints, frames=wanted)
            alive += code == -signal.SIGKILL
            drawing += code == -signal.SIGKILL and self.frames_there() > 0
            left = [name for name in results if os.path.exists(self.path(name))]
            self.assertEqual(self.outputs(*left), {name: whole[name] for name in left})
            self.run_through(*pictures, *checkpoints, "--resume", "c.bin")
            self.assertEqual(self.outputs(*results), whole)
            # Nor does anything stay that was half written.
            self.assertEqual([name for name in self.files() + self.files("f") if ".part" in name], [])
        print(f"{KILLS} kills, {alive} of them before the end, {drawing} after the first frame", file=sys.stderr)
        self.assertGreater(alive, 0)

    def test_what_does_not_belong_is_refused(self):
        self.expect(0, "run", self.crowd, *LOOKS, *STEPS, "--checkpoint", "c.bin", "--every", "0.5")
        with open(self.path("c.bin"), "rb") as file:
            good = file.read()

        def refused(*arguments, words, data=good):
            with open(self.path("c.bin"), "wb") as file:
                file.write(data)
            message = self.expect(2, "run", self.crowd, "--resume", "c.bin", *arguments).stderr
            self.assertIn(words, message)

        same = (*LOOKS, *STEPS)
        refused(*same, "--set", "gravity=[0,-9.8]", words="belongs to another scene")
        refused(*LOOKS, "--integrator", "symplectic", *STEPS[2:], words="belongs to other options of the motion")
        refused("--fps", "30", "--states", "s.csv", *STEPS, words="made at other times")
        refused(*same, words="is damaged", data=good[:-1])
        refused(*same, words="is damaged", data=good[:200] + bytes([good[200] ^ 1]) + good[201:])
        refused(*same, words="is no checkpoint", data=b"frames")
        refused(*same, words="is no checkpoint", data=b"")
        refused(*same, words="another version", data=self.of_another_version(good))
        self.assertIn("there is no", self.expect(2, "run", self.crowd, "--resume", "nosuch.bin").stderr)

    def of_another_version(self, data):
        head, _, rest = data.split(b"\n", 2)
        rest = b"9" + rest
        check = 0xcbf29ce484222325
        for byte in rest:
            check = (check ^ byte) * 0x100000001b3 % 2**64
        return head + b"\n" + f"{check:016x}\n".encode() + rest


if __name__ == "__main__":
    main()
