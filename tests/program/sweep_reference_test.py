"""Labels of data sets against the reference cases: verdicts, and heights at the end of motions."""
import glob
import json
import math
import os
import tarfile

from program import ProgramTest, main

CASES = os.path.join(os.environ["PROJECT"], "tests", "data", "reference", "*.json")


def scene_of(case):
    """The scene of a case as the program reads it."""
    material = {key: case[name] for key, name in (("friction", "mu"), ("restitution", "e")) if isinstance(case.get(name), (int, float))}
    scene = {"version": 1, "title": case["name"], "duration": case.get("t_end", 0.0), "material": material, "cube": [], "plane": [], "fixed": [], "pair": []}
    if "gravity" in case:
        scene["gravity"] = case["gravity"]
    for body in case.get("bodies", []):
        state = body["state"]
        scene["cube"].append({"name": body["id"], "size": [body["shape"]["width"], body["shape"]["height"]], "mass": body["mass"], "position": [state["x"], state["y"]],
                              "angle": state["theta"], "velocity": [state["vx"], state["vy"]], "spin": state["omega"]})
    for body in case.get("static", []):
        if body["type"] == "halfplane":
            scene["plane"].append({"name": body["id"], "point": body["point"], "normal": body["normal"]})
        else:
            scene["fixed"].append({"name": body["id"], "size": [body["width"], body["height"]], "position": [body["x"], body["y"]], "angle": body["theta"]})
    scene["pair"] = [{"bodies": pair["bodies"], "friction": pair["mu"]} for pair in case.get("pair_mu", [])]
    return scene


def height_at_end(case):
    """m, of the highest corner at the end; None where the answer does not tell all states there."""
    states = {e["body"]: e["value"] for e in case["expected"] if e["type"] == "state" and e["t"] == case.get("t_end")}
    if not states or set(states) != {body["id"] for body in case["bodies"]}:
        return None
    return max(states[b["id"]]["y"] + 0.5 * (b["shape"]["width"] * abs(math.sin(states[b["id"]]["theta"])) + b["shape"]["height"] * abs(math.cos(states[b["id"]]["theta"])))
               for b in case["bodies"])


class Labels(ProgramTest):
    def labels(self, name, case, until):
        """What a sweep over one case says of it."""
        sweep = {"version": 1, "name": name, "cases": 1, "scene": scene_of(case), "reject": {"overlapping": False},
                 "vary": [{"key": "duration", "choice": [case.get("t_end", 0.0)]}], "labels": {"check": ["verdict", "contacts"]}}
        if until:
            sweep["labels"]["run"] = {"until": until, "columns": ["final_height", "moved", "at_rest"]}
        with open(self.path(f"{name}.json"), "w") as file:
            json.dump(sweep, file)
        self.expect(0, "sweep", "plan", f"{name}.json", "-o", name)
        self.expect(0, "sweep", "run", name, "--quiet", "--jobs", "1")
        archive, = glob.glob(self.path(f"{name}/shards/*.tar"))
        with tarfile.open(archive) as tar:
            return json.load(tar.extractfile(tar.getmembers()[0]))["labels"]

    def test_labels_agree_with_the_exact_answers(self):
        verdicts = heights = 0
        for path in sorted(glob.glob(CASES)):
            with open(path) as file:
                case = json.load(file)
            height = height_at_end(case) if case["kind"] == "trajectory" else None
            expected = [e["value"] for e in case["expected"] if e["type"] == "classification"] if case["kind"] == "qp_geometry" and "extension" not in case else []
            if height is None and not expected:
                continue
            with self.subTest(case=case["name"]):
                labels = self.labels(os.path.basename(path)[:-5], case, case["t_end"] if height is not None else None)
                if expected:
                    verdicts += 1
                    self.assertEqual(labels["verdict"] == "stands", expected[0] == "rest", labels)
                    self.assertNotEqual(labels["verdict"], "undecided")
                if height is not None:
                    heights += 1
                    self.assertAlmostEqual(labels["final_height"], height, delta=1e-6 * max(1.0, abs(height)))
        self.assertGreater(verdicts, 60)
        self.assertGreater(heights, 10)


if __name__ == "__main__":
    main()
