"""Several scenes at once: order, errors in place, exit codes, the same text for any number of threads."""
import json
import subprocess

from program import FALLING, FLYING, STANDING, ProgramTest, main


def lines(*scenes):
    return "".join(json.dumps(scene) + "\n" for scene in scenes)


def tower(lean):
    return {"plane": [{}], "tower": [{"count": 8, "base": [0, 0], "lean": lean}]}


class Batch(ProgramTest):
    def test_answers_come_in_order_with_errors_in_their_place(self):
        text = lines(STANDING, {"cub": []}, FALLING, STANDING)
        done = self.expect(2, "check", "--json", "-", input=text)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([a.get("verdict") for a in answers], ["stands", None, "falls", "stands"])
        self.assertIn('scene 2: unknown key "cub"; did you mean "cube"?', answers[1]["error"])
        self.assertEqual(done.stderr, "")

    def test_a_file_of_many_scenes_is_told_how_to_come_in(self):
        with open(self.path("many.jsonl"), "w") as file:
            file.write((json.dumps(STANDING) + "\n") * 2)
        self.assertIn("many.jsonl: is not one scene; check and run read a scene a line from standard input: - < many.jsonl",
                      self.expect(2, "check", "many.jsonl").stderr)
        with open(self.path("one.jsonl"), "w") as file:
            file.write(json.dumps(STANDING) + "\n")
        self.expect(0, "check", "one.jsonl")

    def test_the_exit_code_is_the_largest(self):
        self.expect(0, "check", "--json", "-", input=lines(STANDING, STANDING))
        self.expect(1, "check", "--json", "-", input=lines(STANDING, FALLING, STANDING))
        self.expect(2, "check", self.scene(STANDING), "no-such-file")

    def test_any_number_of_threads_says_the_same(self):
        text = lines(*(tower(0.01 * k) if k % 7 else {"cube": 3} for k in range(60)))
        one, two, five = (self.expect(2, "check", "--threads", n, "-", input=text) for n in "125")
        self.assertEqual(len(one.stdout.splitlines()), 51)
        self.assertEqual((one.stdout, one.stderr), (two.stdout, two.stderr))
        self.assertEqual((one.stdout, one.stderr), (five.stdout, five.stderr))

    def test_runs_are_the_same_in_threads_and_alone(self):
        scenes = [FLYING, {"x": 1}, FALLING, tower(0.2)]
        for threads in "1", "3":
            done = self.expect(2, "run", "--json", "--until", "0.1", "--sample", "0.1", "--threads", threads, "-", input=lines(*scenes))
            answers = [json.loads(line) for line in done.stdout.splitlines()]
            self.assertEqual(len(answers), 4)
            self.assertIn("error", answers[1])
            for k in 0, 2, 3:
                alone = self.summary(scenes[k], "--until", "0.1", "--sample", "0.1")
                alone.pop("cost"), answers[k].pop("cost")
                self.assertEqual(alone, answers[k])

    def test_each_answer_comes_as_soon_as_its_scene_is_there(self):
        with subprocess.Popen([self.program, "check", "--json", "--threads", "2", "-"], text=True, bufsize=1,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE) as asked:
            asked.stdin.write(lines(STANDING, FALLING, STANDING))
            asked.stdin.flush()
            self.assertEqual([json.loads(asked.stdout.readline())["verdict"] for _ in range(2)], ["stands", "falls"])
            asked.stdin.close()
            asked.wait(60)

    def test_margins_of_several_scenes_are_for_programs(self):
        scenes = self.scene(STANDING, "a.json"), self.scene(FALLING, "b.json")
        for option in "--margin", "--ranges":
            self.assertIn("add --json", self.refuse("check", *scenes, option))
            self.assertIn("add --json", self.expect(2, "check", "-", option, input=lines(STANDING, FALLING)).stderr)
        answers = [json.loads(line) for line in self.expect(1, "check", *scenes, "--margin", "--json").stdout.splitlines()]
        self.assertTrue(all("margin" in json.dumps(answer) for answer in answers), answers)

    def test_threads_of_one_scene_are_for_ranges(self):
        scene = self.scene(STANDING)
        self.assertIn("--threads does nothing", self.expect(0, "check", "--threads", "2", scene).stderr)
        self.assertEqual(self.expect(0, "check", "--threads", "2", scene, "--ranges").stderr, "")

    def test_bad_numbers_of_threads_are_refused(self):
        for bad in "0", "-1", "1.5", "x", "100000":
            self.assertIn("--threads", self.expect(2, "check", "--threads", bad, self.scene(STANDING)).stderr)


if __name__ == "__main__":
    main()
