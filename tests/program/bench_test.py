"""`bench` of tests/benchmark: run time against error, as a table, as CSV and as plots."""
import csv
import io
import os

from program import ProgramTest, main, png_size


class Bench(ProgramTest):
    program = os.environ["BENCH"]

    def rows(self, *arguments):
        done = self.expect(0, "--csv", "-", "--budget", "0.002", "--quiet", *arguments)
        return list(csv.DictReader(io.StringIO(done.stdout)))

    def test_motions_by_events_keep_what_the_tolerance_promises(self):
        rows = self.rows("--scenes", "flight,slide,tilt,corner_impact,edge,ladder,rider,drop",
                         "--methods", "event/rigid/auto")
        self.assertEqual(len(rows), 8 * 5)
        for row in rows:
            where = (row["scene"], row["tolerance"])
            self.assertEqual(row["status"], "ok", where)
            promised = float(row["tolerance"])
            self.assertLessEqual(float(row["state_error"]), promised, where)
            self.assertLessEqual(float(row["overlap_m"]), 1e-9, where)
            if row["event_error_s"]:
                self.assertLessEqual(float(row["event_error_s"]), promised, where)
            self.assertGreater(float(row["cpu_s"]), float(row["cpu_setup_s"]) * 0.5, where)
        self.assertEqual({row["scene"] for row in rows if not row["event_error_s"]}, {"flight", "slide"})

    def test_smaller_tolerances_and_steps_give_smaller_errors(self):
        rows = self.rows("--scenes", "tilt", "--methods", "event/rigid,symplectic/rigid")
        by_events = [float(row["state_error"]) for row in rows
                     if row["method"] == "event/rigid/auto"]
        by_steps = [float(row["state_error"]) for row in rows
                    if row["method"] == "symplectic/rigid/auto"]
        self.assertEqual((len(by_events), len(by_steps)), (5, 4))
        self.assertEqual(by_events, sorted(by_events, reverse=True))
        for coarse, fine in zip(by_steps, by_steps[1:]):  # first order: a quarter of the step
            self.assertLess(fine, coarse / 2.5)
            self.assertGreater(fine, coarse / 6.0)

    def test_stands_do_not_move_a_bit(self):
        for row in self.rows("--scenes", "tower_10,pyramid_4,wall_4,mass_ratio_1000000,overhang",
                             "--methods", "auto"):
            self.assertEqual(float(row["state_error"]), 0.0, row["scene"])
            self.assertEqual(row["status"], "ok", row["scene"])

    def test_every_row_tells_where_it_comes_from(self):
        row = self.rows("--scenes", "flight", "--methods", "auto")[0]
        self.assertTrue(row["machine"] and row["compiler"] and row["version"])
        self.assertRegex(row["commit"], r"^([0-9a-f]{12}\+?|unknown)$")
        self.assertEqual((row["engine"], row["bodies"], row["simulated_s"]), ("wuerfel", "1", "1"))

    def test_plots_are_pictures(self):
        self.expect(0, "--scenes", "tilt,tower_3,tower_6", "--methods", "auto,event/rigid/newton",
                    "--budget", "0", "--plot", self.path("plots"), "--quiet")
        names = ["error-tilt", "growth", "solvers"]
        self.assertEqual(self.files("plots"),
                         sorted(name + end for name in names for end in (".gp", ".svg", ".png")))
        for name in names:
            self.assertEqual(png_size(self.path(f"plots/{name}.png")), (1350, 780))
            self.assertTrue(self.content(f"plots/{name}.svg").rstrip().endswith("</svg>"))

    def test_unknown_names_are_refused_with_those_there_are(self):
        for arguments, words in ((("--scenes", "tilted"), "corner_impact"), (("--methods", "events"), "rattle"),
                                 (("--scenes", "tower_x"), "tower"), (("--methods", "event/rigid/auto/x"), "SOLVER")):
            done = self.expect(2, *arguments)
            self.assertIn(words, done.stderr)
            self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    main()
