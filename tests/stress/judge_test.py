"""The sweep sees every fault that it is there to see: programs that answer wrongly, and scenes to make smaller."""
import json
import math
import os
import stat
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

from case import Case, run_case  # noqa: E402
from laws import around, obeys  # noqa: E402
from overlap import deepest  # noqa: E402
from random_scenes import KINDS, random_scene  # noqa: E402
from shrink import shrink  # noqa: E402

GOOD = {"audit": {"max_penetration": 0.0, "energy": {"start": 1.0, "end": 1.0, "impact_loss": 0.0, "drift": 0.0}},
        "cost": {"steps": 3}, "samples": [{"t": 1.0, "bodies": {"a": {"x": 0.0, "y": 2.0, "theta": 0.0}, "b": {"x": 3.0, "y": 2.0, "theta": 0.0}}}]}
SCENE = {"version": 1, "duration": 1.0, "cube": [{"name": "a", "position": [0.123456, 2], "size": 0.5}, {"name": "b", "position": [3, 2]}]}


def changed(**audit):
    return json.dumps({**GOOD, "audit": {**GOOD["audit"], **audit}})


class Judge(unittest.TestCase):
    def program(self, body):
        """A program in place of the real one: a shell script."""
        file = tempfile.NamedTemporaryFile("w", suffix=".sh", delete=False)
        self.addCleanup(os.remove, file.name)
        file.write("#!/bin/sh\n" + body)
        file.close()
        os.chmod(file.name, stat.S_IRWXU)
        return file.name

    def status(self, body, limit=2.0, **case):
        return run_case(self.program(body), Case(SCENE, **case), limit).status

    def answers(self, text, code=0):
        return f"cat > /dev/null\ncat <<'END'\n{text}\nEND\nexit {code}\n"

    def test_a_good_answer_is_fine(self):
        self.assertEqual(self.status(self.answers(json.dumps(GOOD))), "fine")

    def test_a_program_that_does_not_end_hangs(self):
        self.assertEqual(self.status("exec sleep 30\n", 0.1), "hang")
        self.assertEqual(self.status("while :; do :; done\n", 1.0), "hang")

    def test_a_signal_is_a_crash(self):
        self.assertEqual(self.status("kill -SEGV $$\n"), "crash")

    def test_exit_codes_are_told_apart(self):
        self.assertEqual(self.status(self.answers("", 4)), "internal error")
        self.assertEqual(self.status(self.answers("", 2)), "refused")
        self.assertEqual(self.status(self.answers("", 2), refuse=True), "fine")
        self.assertEqual(self.status(self.answers(json.dumps(GOOD)), refuse=True), "wrong answer")
        self.assertEqual(self.status(self.answers(json.dumps(GOOD), 3)), "over budget")
        self.assertEqual(self.status(self.answers("half an ans")), "internal error")

    def test_null_anywhere_is_not_a_number(self):
        self.assertEqual(self.status(self.answers(json.dumps({**GOOD, "samples": [{"t": 1.0, "bodies": {"a": {"x": None}}}]}))), "not a number")

    def test_overlap_counts_against_the_smaller_side(self):
        self.assertEqual(self.status(self.answers(changed(max_penetration=0.4e-9))), "fine")
        self.assertEqual(self.status(self.answers(changed(max_penetration=0.6e-9))), "overlap")

    def test_an_overlap_is_seen_behind_exit_code_three(self):
        self.assertEqual(self.status(self.answers(changed(max_penetration=0.1), 3)), "overlap")

    def test_an_overlap_that_the_audit_does_not_show_is_seen(self):
        into = {"x": 0.7, "y": 2.0, "theta": 0.0}  # 0.05 m into a, whose half side is 0.25 m
        bodies = {**GOOD["samples"][0]["bodies"], "b": into}
        self.assertEqual(self.status(self.answers(json.dumps({**GOOD, "samples": [{"t": 1.0, "bodies": bodies}]}))), "overlap")
        self.assertAlmostEqual(deepest(SCENE, {"bodies": bodies}), 0.05, delta=1e-15)
        sunk = {**SCENE, "plane": [{"point": [0, 2]}], "fixed": [{"size": 1, "position": [0, 2.6], "angle": math.pi / 4}]}
        self.assertAlmostEqual(deepest(sunk, GOOD["samples"][0]), 0.5, delta=1e-15)

    def test_energy_may_be_lost_but_not_gained(self):
        energy = {"start": 1.0, "end": 1.0, "impact_loss": 0.0}
        self.assertEqual(self.status(self.answers(changed(energy={**energy, "drift": -1e-3}))), "fine")
        self.assertEqual(self.status(self.answers(changed(energy={**energy, "drift": 1e-3}))), "gains energy")

    def test_what_a_case_expects_is_asked(self):
        self.assertEqual(self.status(self.answers(json.dumps(GOOD)), expect=lambda answer: "no"), "wrong answer")

    def test_a_case_that_follows_must_hold_as_well(self):
        def then(a_scene, answer):
            return Case(a_scene, expect=lambda seen: None if seen == answer else "no", then=lambda *_: Case(a_scene, expect=lambda _: "no"))
        self.assertEqual(self.status(self.answers(json.dumps(GOOD)), then=then), "wrong answer")


class Laws(unittest.TestCase):
    def said_of(self, y, acceleration, mu=0.5):
        """Of a unit cube that slides to the right on a floor, or above it, at 1 m/s."""
        a_scene = {"material": {"friction": mu}, "plane": [{"name": "floor", "normal": [0, 1]}], "cube": [{"name": "a", "size": [1, 1], "mass": 2.0}]}
        ax, ay = acceleration

        def state(t):
            return {"x": 1 + t + ax * t * t / 2, "y": y + ay * t * t / 2, "theta": 0, "vx": 1 + ax * t, "vy": ay * t, "omega": 0}
        times = [0.0]
        samples = [{"t": t, "bodies": {"a": state(t)}} for t in around(0.0)]
        return obeys(a_scene, times)({"cost": {"hand_overs": 0}, "events": [], "samples": samples})

    def test_what_no_forces_explain_is_seen(self):
        self.assertIsNone(self.said_of(1.0, (0, -9.81)))
        self.assertIsNone(self.said_of(0.5, (-0.5 * 9.81, 0)))
        self.assertIsNotNone(self.said_of(1.0, (0, -9.8)))
        self.assertIsNotNone(self.said_of(0.5, (-0.51 * 9.81, 0)))
        self.assertIsNotNone(self.said_of(0.5, (0, 0)))


class Shrink(unittest.TestCase):
    def test_only_what_makes_it_fail_is_left(self):
        """Fails whenever there is a body b: all else goes, and numbers become round."""
        file = tempfile.NamedTemporaryFile("w", suffix=".sh", delete=False)
        self.addCleanup(os.remove, file.name)
        file.write("#!/bin/sh\nif grep -q '\"b\"'; then exit 4; fi\nexit 2\n")
        file.close()
        os.chmod(file.name, stat.S_IRWXU)
        scene = {**SCENE, "cube": SCENE["cube"] + [{"name": "c", "position": [8.7654321, 1]}]}
        scene["cube"][1] = {"name": "b", "position": [3.14159, 2.5]}
        smaller = shrink(file.name, Case(scene), "internal error", 5.0).scene
        self.assertEqual(smaller["cube"], [{"name": "b", "position": [3.0, 2.0]}])
        self.assertLessEqual(smaller["duration"], 0.02)


class RandomScenes(unittest.TestCase):
    def test_a_seed_always_gives_the_same_scene_and_all_kinds_come(self):
        self.assertEqual(random_scene(7), random_scene(7))
        self.assertEqual({random_scene(seed)["title"].split()[0] for seed in range(100)}, set(KINDS))


if __name__ == "__main__":
    unittest.main(verbosity=2)
