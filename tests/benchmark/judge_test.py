"""The gate sees every fault that it is there to see: worse figures, higher counts, rows that come or go."""
import os
import stat
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

from judge import RATIO, bound_of, judge, read_bounds, write_bounds  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
BOUNDS = {"tilt": {"state_error": 4e-11, "event_error_s": 1e-12}, "tower": {"state_error": 0.0}, "count: tilt": {RATIO: 0.6}}


class Judge(unittest.TestCase):
    def judged(self, row, **figures):
        return judge(BOUNDS, {**BOUNDS, row: {**BOUNDS.get(row, {}), **figures}})

    def test_what_is_as_good_or_better_passes(self):
        self.assertEqual(judge(BOUNDS, BOUNDS), [])
        self.assertEqual(self.judged("tilt", state_error=0.0), [])

    def test_a_worse_error_fails(self):
        self.assertEqual(self.judged("tilt", state_error=5e-11), ["tilt: state_error is 5e-11, its bound 4e-11"])

    def test_a_stand_that_moves_at_all_fails(self):
        self.assertEqual(len(self.judged("tower", state_error=1e-300)), 1)

    def test_a_higher_count_fails(self):
        self.assertEqual(self.judged("count: tilt", ratio=0.61), ["count: tilt: ratio is 0.61, its bound 0.6"])

    def test_what_is_not_a_number_fails(self):
        self.assertEqual(len(self.judged("tilt", state_error=float("nan"))), 1)

    def test_a_row_that_only_one_side_has_fails(self):
        self.assertEqual(self.judged("new", state_error=0.0), ["new: has no bound"])
        self.assertEqual(judge(BOUNDS, {row: BOUNDS[row] for row in ("tilt", "count: tilt")}), ["tower: was not measured"])

    def test_a_figure_that_only_one_side_has_fails(self):
        self.assertEqual(self.judged("tower", event_error_s=0.0), ["tower: event_error_s has no bound"])
        self.assertEqual(judge(BOUNDS, {**BOUNDS, "tilt": {"state_error": 0.0}}), ["tilt: event_error_s was not measured"])

    def test_every_complaint_is_told(self):
        self.assertEqual(len(judge(BOUNDS, {"tilt": {"state_error": 1.0, "event_error_s": 1.0}})), 4)


class Bounds(unittest.TestCase):
    def test_they_leave_room_above_rounding_but_none_to_what_stands(self):
        self.assertEqual(bound_of("state_error", 1e-8), 4e-8)
        self.assertEqual(bound_of("state_error", 1e-16), 1e-13)
        self.assertEqual(bound_of("state_error", 0.0), 0.0)
        self.assertEqual(bound_of("overlap_m", 0.0), 1e-12)
        self.assertEqual(bound_of(RATIO, 2.0), 3.0)

    def test_they_are_read_as_written(self):
        with tempfile.TemporaryDirectory() as folder:
            write_bounds(folder + "/bounds.csv", {"tilt": {"state_error": 1e-11, "overlap_m": 0.0}, "count: tilt": {RATIO: 0.4}})
            self.assertEqual(read_bounds(folder + "/bounds.csv"),
                             {"tilt": {"state_error": 4e-11, "overlap_m": 1e-12}, "count: tilt": {RATIO: 0.6}})


class Gate(unittest.TestCase):
    """The script itself, with programs in place of the real ones."""

    def gate(self, task, variable, body):
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + "/program", "w") as file:
                file.write("#!/bin/sh\n" + body)
            os.chmod(folder + "/program", stat.S_IRWXU)
            return subprocess.run([sys.executable, os.path.join(HERE, "gate"), task], capture_output=True, text=True,
                                  env={**os.environ, variable: folder + "/program"})

    def bench(self, error, status):
        """A bench that knows one row."""
        return self.gate("errors", "BENCH", f"""cat <<'END'
scene,method,tolerance,step,state_error,event_error_s,overlap_m,energy_drift_J,residual,status
tilt,auto/rigid/auto,1e-08,,{error},0,0,0,0,{status}
END
""")

    def test_a_planted_error_fails_and_is_named(self):
        done = self.bench(1, "ok")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tilt auto/rigid/auto tolerance 1e-08: state_error is 1,", done.stdout)
        self.assertIn("tower_10 auto/rigid/auto tolerance 1e-08: was not measured", done.stdout)
        self.assertNotIn("state_error", self.bench(0, "ok").stdout)

    def test_a_row_that_did_not_end_well_fails(self):
        self.assertIn("tolerance 1e-08: 2 times unresolved", self.bench(0, "2 times unresolved").stdout)

    def test_a_planted_count_fails_and_is_named(self):
        done = self.gate("counts", "VALGRIND", """
for argument in "$@"; do case "$argument" in --callgrind-out-file=*) out=${argument#*=};; esac; done
printf 'desc: Trigger: Program termination\\ntotals: 5\\n' > "$out"
printf 'desc: Trigger: Client Request: kernel\\ntotals: 10\\n' > "$out.1"
printf 'desc: Trigger: Client Request: tilt\\ntotals: 9999\\n' > "$out.2"
""")
        if done.returncode == 77:
            self.skipTest(done.stdout)
        self.assertEqual(done.returncode, 1)
        self.assertIn("count: tilt: ratio is 1e+03,", done.stdout)
        self.assertIn("count: rider: was not measured", done.stdout)

    def test_a_program_that_fails_or_is_not_there_is_told(self):
        self.assertIn("ended with 3", self.gate("errors", "BENCH", "exit 3\n").stderr)
        done = subprocess.run([sys.executable, os.path.join(HERE, "gate"), "errors"], capture_output=True, text=True,
                              env={**os.environ, "BENCH": "/nowhere/bench"})
        self.assertEqual((done.returncode, "build first" in done.stderr), (1, True))


if __name__ == "__main__":
    unittest.main(verbosity=2)
