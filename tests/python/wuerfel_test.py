"""The Python module against the program: the same bits, the same pixels, the same errors."""
import copy
import json
import os
import pathlib
import pickle
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import wuerfel as w

PROGRAM = os.environ["WUERFEL"]
SCENES = pathlib.Path(__file__).parents[2] / "assets" / "scenes"
FALLING = {"plane": [{"name": "floor"}], "cube": [{"name": "a", "position": [0, 0.5]}, {"name": "b", "position": [0.6, 1.5]}]}
TOWER = {"plane": [{}], "tower": [{"name": "t", "count": 6, "base": [0, 0]}]}


def program(*arguments, codes=(0,), **options):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, **options)
    assert done.returncode in codes, done.stderr
    return done.stdout


def test_scenes_come_from_paths_texts_dicts_and_names():
    by_name = w.Scene("tower")
    assert by_name == w.Scene(SCENES / "tower.toml") == w.Scene((SCENES / "tower.toml").read_text())
    assert by_name == w.Scene.load(by_name.to_dict()) == w.Scene(by_name.to_json()) == w.Scene(by_name)
    assert by_name.hash == json.loads(program("run", "tower", "--until", "0", "--json"))["scene"]["hash"]
    assert len(w.Scene(FALLING)) == 2 and w.Scene(FALLING).names == ["a", "b"]


def test_keys_are_set_as_on_the_command_line():
    scene = w.Scene(TOWER).with_(**{"tower.t.lean": 0.35}).with_(**{"tower.t.count": 3})
    assert len(scene) == 3 and not w.check(scene) and w.check(TOWER)
    assert scene.to_dict()["cube"][1]["position"][0] == pytest.approx(0.35)


@pytest.mark.parametrize("source, message", [
    ({"cub": []}, 'unknown key "cub"; did you mean "cube"?'),
    ("[[cube]]\nsize = -1\nposition = [0, 0]\n", "text:2:8: cube[1].size: must be greater than 0; it is -1"),
    ("twoer", "tower"),
    ({"cube": [{"position": [0, 0]}, {"position": [0.1, 0]}]}, "overlap"),
])
def test_errors_say_where_and_what_would_be_right(source, message):
    with pytest.raises(w.SceneError) as error:
        w.Scene(source)
    assert message in str(error.value)
    assert isinstance(error.value, ValueError)


def test_wrong_arguments_are_refused():
    for call in (lambda: w.Scene(3), lambda: w.check(None)):
        pytest.raises(TypeError, call)
    for call in (lambda: w.check(FALLING, solver="newtn"), lambda: w.simulate(FALLING, [1, 0.5]), lambda: w.simulate(FALLING, [-1]),
                 lambda: w.Simulation(FALLING, tolerance=0), lambda: w.Simulation(FALLING).advance_to(float("nan")),
                 lambda: w.render(FALLING, layers="cubs"), lambda: w.render(FALLING, size=(0, 5)), lambda: w.render(FALLING, mode="x"),
                 lambda: w.render(FALLING, layers="cubes,,forces"), lambda: w.render(FALLING, scale=9), lambda: w.render(FALLING, scale=0.001),
                 lambda: w.Scene(TOWER).with_(**{"tower.t.laen": 1})):
        pytest.raises(ValueError, call)


def test_numbers_of_numpy_are_numbers():
    given = {"version": np.int64(1), "cube": [{"position": np.array([0.0, 2.0]), "size": np.float32(0.5), "mass": np.float64(3.0)}]}
    assert w.Scene(given) == w.Scene({"version": 1, "cube": [{"position": [0, 2], "size": 0.5, "mass": 3}]})
    assert w.Scene(TOWER).with_(gravity=np.array([0.0, -1.5])).to_dict()["gravity"] == [0, -1.5]
    with pytest.raises(TypeError, match="not set"):
        w.Scene({"version": 1, "cube": {1}})


def test_keys_can_be_set_to_tables():
    scene = w.Scene(TOWER).with_(material={"friction": 0.5}, fixed=[{"name": 'a "b" 🙂', "size": (1, 2), "position": [9, 9]}], title="🙂")
    assert scene.title == "🙂" and scene.to_dict()["fixed"][0]["name"] == 'a "b" 🙂'
    assert scene == w.Scene(TOWER).with_(**{"material.friction": 0.5}).with_(title="🙂", fixed=[{"name": 'a "b" 🙂', "size": [1, 2], "position": [9, 9]}])


def test_threads_beyond_all_use_and_names_that_are_none_are_refused():
    for threads in -1, 100000:
        for many in (lambda: w.check_many([FALLING], threads=threads), lambda: w.simulate_many([FALLING], [0.1], threads=threads)):
            with pytest.raises(ValueError, match="threads: '-?[0-9]+' is no whole number of 0 to 1024"):
                many()
    pytest.raises(TypeError, w.save_film, "demo", None)
    with pytest.raises(w.SceneError, match="empty"):
        w.Scene("")


def test_options_without_effect_are_refused_with_those_that_have_one():
    for arguments, named in (({"step": 0.01}, "rattle"), ({"step": 0.01, "integrator": "event"}, "moreau"),
                             ({"tolerance": 1e-9, "integrator": "euler"}, "auto"), ({"formulation": "points"}, "check")):
        for motion in (lambda **options: w.Simulation(FALLING, **options), lambda **options: w.simulate(FALLING, [0.1], **options)):
            with pytest.raises(ValueError, match=named):
                motion(**arguments)
    w.Simulation(FALLING, integrator="rattle", step=0.01, tolerance=1e-7, formulation="points")
    assert w.check(FALLING, formulation="points").verdict == "falls"


@pytest.mark.parametrize("name", ["demo", "overhang_stands", "incline_friction", "fig1_stack"])
def test_check_answers_as_the_program(name):
    answer = w.check(name)
    told = json.loads(program("check", name, "--json", codes=(0, 1)))
    assert answer.verdict == told["verdict"] and bool(answer) == (told["verdict"] == "stands")
    assert answer.objective == told["objective"] and answer.kkt_residual == told["kkt_residual"]
    assert answer.accelerations.tolist() == [[a["ax"], a["ay"], a["alpha"]] for a in told["accelerations"].values()]
    assert answer.contacts == told["contacts"] and answer.facts == told.get("facts") and answer.margin is None
    assert answer.to_dict() == told


@pytest.mark.parametrize("name", ["overhang_stands", "overhang_falls", "wall"])
def test_margins_and_reasons_are_the_programs(name):
    answer = w.check(name, margin=True, ranges=True)
    assert answer.to_dict() == json.loads(program("check", name, "--margin", "--ranges", "--json", codes=(0, 1)))
    assert answer.margin["smallest"] == answer.to_dict()["margin"]["smallest"]
    assert w.explain(name) == json.loads(program("explain", name, "--json", codes=(0, 1)))
    assert w.explain(name, language="de")["text"] == program("explain", name, "--language", "de", codes=(0, 1)).splitlines()


@pytest.mark.parametrize("name", ["demo", "incline_friction", "tilted_drop"])
def test_states_are_bit_equal_to_the_programs(name):
    times = [0.0, 0.1, 0.25]
    told = json.loads(program("run", name, "--json", "--until", 0.25, "--sample", "0,0.1,0.25"))
    states = [[list(b.values()) for b in s["bodies"].values()] for s in told["samples"]]
    motion = w.simulate(name, times)
    assert motion.states.tolist() == states and motion.states.dtype == np.float64
    assert motion.outcome == told["outcome"] and len(motion.events) == len(told["events"])
    simulation = w.Simulation(name)
    for t, expected in zip(times, states):
        simulation.advance_to(t)
        assert simulation.time == t and simulation.state.tolist() == expected
    assert simulation.audit["drift"] == told["audit"]["energy"]["drift"]
    assert simulation.names == list(told["samples"][0]["bodies"])


@pytest.mark.parametrize("name", ["pile", "incline_friction", "double_pendulum"])
@pytest.mark.parametrize("way", [lambda s: w.Simulation.restore(s.checkpoint()), lambda s: pickle.loads(pickle.dumps(s)), copy.deepcopy])
def test_a_simulation_goes_on_from_its_bytes_to_the_same_bits(name, way):
    whole, first = w.Simulation(name), w.Simulation(name)
    first.advance_to(0.4)
    again = way(way(first))
    assert again.time == 0.4 and np.array_equal(again.state, first.state) and again.scene == first.scene
    for t in 0.5, 1.3:
        whole.advance_to(t)
        again.advance_to(t)
        assert np.array_equal(again.state, whole.state)
    assert again.events == whole.events and again.audit == whole.audit


def test_bytes_that_are_no_simulation_are_refused():
    data = w.Simulation(FALLING).checkpoint()
    for bad, why in (b"", "no checkpoint"), (data[:-1], "damaged"), (data[:-9] + b"#" + data[-8:], "damaged"), (data.replace(w.__version__.encode(), b"0.0.0", 1), "0.0.0"):
        with pytest.raises(ValueError, match=why):
            w.Simulation.restore(bad)


def test_scenes_can_be_pickled():
    scene = w.Scene(TOWER).with_(**{"tower.t.lean": 0.1})
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and again.hash == scene.hash and again.with_(**{"tower.t.count": 2}) == scene.with_(**{"tower.t.count": 2})


def test_films_are_the_programs(tmp_path):
    program("run", "demo", "--until", 0.2, "--fps", 20, "--size", "160x120", "-o", tmp_path / "a.mp4", "-o", f"{tmp_path}/a/")
    w.save_film("demo", tmp_path / "b.mp4", until=0.2, fps=20, size=(160, 120))
    w.save_film("demo", f"{tmp_path}/b/", until=0.2, fps=20, size=(160, 120))
    assert (tmp_path / "a.mp4").read_bytes() == (tmp_path / "b.mp4").read_bytes()
    names = sorted(p.name for p in (tmp_path / "b").iterdir())
    assert len(names) == 5 and all((tmp_path / "a" / n).read_bytes() == (tmp_path / "b" / n).read_bytes() for n in names)
    for bad in {"fps": 0}, {"until": -1}, {"size": (0, 5)}, {"layers": "cubs"}, {"view": "nobody"}:
        pytest.raises(ValueError, w.save_film, "demo", tmp_path / "c.mp4", **bad)
    pytest.raises(ValueError, w.save_film, "demo", tmp_path / "c.mpeg")
    pytest.raises(OSError, w.save_film, "demo", tmp_path / "a.mp4" / "c.mp4", until=0.1)
    assert not (tmp_path / "c.mp4").exists()


def test_states_are_copies():
    simulation = w.Simulation(FALLING)
    before = simulation.state
    simulation.advance_to(0.2)
    assert before[0, 1] == 0.5 and not np.array_equal(before, simulation.state)


@pytest.mark.parametrize("options", [{}, {"theme": "dark", "layers": "cubes,names,grid"}, {"view": "0,1,6", "t": 0.3}])
def test_pixels_are_the_programs(tmp_path, options):
    names = [text for key, value in options.items() for text in ("-t" if key == "t" else f"--{key}", value)]
    program("figure", "demo", "--fit", "instant", "--size", "320x200", *names, "-o", tmp_path / "a.png")
    picture = w.render("demo", size=(320, 200), **options)
    assert picture.shape == (200, 320, 4) and picture.dtype == np.uint8
    from_file = read_png(tmp_path / "a.png")
    assert np.array_equal(picture[..., :from_file.shape[2]], from_file)
    if "t" in options:
        simulation = w.Simulation("demo")
        simulation.advance_to(options.pop("t"))
        assert np.array_equal(picture, w.render(simulation, size=(320, 200), **options))


def read_png(path):
    """Pixels of an 8-bit PNG without interlacing."""
    import struct, zlib
    data = path.read_bytes()
    width, height, depth, color = struct.unpack(">IIBB", data[16:26])
    assert depth == 8
    channels = {2: 3, 6: 4}[color]
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + channels * width)
    pixels = np.zeros((height, width, channels), np.int32)
    for y in range(height):
        kind, line = rows[y, 0], rows[y, 1:].reshape(width, channels).astype(np.int32)
        above = pixels[y - 1] if y else np.zeros_like(line)
        for x in range(width):
            left = pixels[y, x - 1] if x else 0
            corner = above[x - 1] if x else np.zeros(channels, np.int32)
            if kind == 4:
                p = left + above[x] - corner
                d = [np.abs(p - q) for q in (left + np.zeros(channels, np.int32), above[x], corner)]
                guess = np.where((d[0] <= d[1]) & (d[0] <= d[2]), left, np.where(d[1] <= d[2], above[x], corner))
            else:
                guess = {0: 0, 1: left, 2: above[x], 3: (left + above[x]) // 2}[kind]
            pixels[y, x] = (line[x] + guess) & 255
    return pixels.astype(np.uint8)


def test_masks_number_the_cubes():
    mask = w.render(FALLING, size=(160, 120), mode="instance")
    assert mask.shape == (120, 160) and set(np.unique(mask)) == {0, 1, 2}
    assert abs(int((mask == 1).sum()) - int((mask == 2).sum())) <= 0.06 * (mask == 1).sum()


def towers(count):
    return [w.Scene(TOWER).with_(**{"tower.t.lean": 0.35 * k / count}) for k in range(count)]


def test_many_are_as_one_by_one_whatever_the_threads():
    scenes = [*towers(60), {"cub": []}, FALLING]
    alone = [w.check(scene) for scene in scenes[:60]]
    for threads in 1, 4:
        answers = w.check_many(scenes, threads=threads)
        assert [a.verdict for a in answers[:60]] == [a.verdict for a in alone]
        assert all(np.array_equal(a.accelerations, b.accelerations) for a, b in zip(answers, alone))
        assert isinstance(answers[60], w.SceneError) and "did you mean" in str(answers[60])
        assert answers[61].verdict == "falls"
    nearly = w.check_many([TOWER, FALLING], margin=True, ranges=True)
    assert [a.to_dict() for a in nearly] == [w.check(s, margin=True, ranges=True).to_dict() for s in (TOWER, FALLING)]
    one, four = (w.simulate_many([*towers(5), {"x": 1}], [0.0, 0.2], threads=n) for n in (1, 4))
    assert all(np.array_equal(a.states, b.states) for a, b in zip(one[:5], four[:5]))
    assert isinstance(one[5], w.SceneError) and isinstance(four[5], w.SceneError)


def test_other_threads_run_while_it_works():
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)
    clock = threading.Thread(target=tick)
    clock.start()
    start = time.monotonic()
    w.simulate("pile", [1.0])
    end = time.monotonic()
    done.set()
    clock.join()
    inside = [t for t in ticks if start < t < end]
    assert len(inside) > 0.05 * (end - start) / 0.005


def test_import_is_quick_and_draws_nothing():
    script = "import numpy, sys, time\nt = time.process_time()\nimport wuerfel\nprint(time.process_time() - t)\nassert 'OSMesa' not in open('/proc/self/maps').read()\n"
    assert min(float(subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout) for _ in range(5)) < 0.05


def test_replay_says_what_the_program_says(tmp_path):
    path = tmp_path / "p.jsonl"
    program = {"block_size": 3, "M_diag": [1, 1, 0.2], "F": [0, -9.81, 0], "J_triplets": [[0, 1, 1], [0, 2, 0.5], [1, 1, 1], [1, 2, -0.5]],
               "b": [0, 0], "E_triplets": [], "d": []}
    path.write_text(2 * (json.dumps(program) + "\n"))
    said = subprocess.run([PROGRAM, "replay", "--json", str(path)], capture_output=True, text=True, check=True).stdout
    assert w.replay(str(path)) == [json.loads(line) for line in said.splitlines()]
    path.write_text("{}\n")
    with pytest.raises(ValueError, match="p.jsonl:1: no program"):
        w.replay(str(path))


def test_checks_leak_nothing():
    import resource
    scene = w.Scene(FALLING)
    def usage():
        for _ in range(3000):
            w.check(scene).contacts
            w.Simulation.restore(w.Simulation(scene).checkpoint())
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    before = usage()
    assert usage() <= before + 1024  # kB


def test_the_stubs_name_what_there_is():
    stub = (pathlib.Path(w.__file__).parent / "__init__.pyi").read_text()
    for name in w.__all__:
        assert f"class {name}" in stub or f"def {name}" in stub
        assert getattr(w, name).__doc__
        for member in vars(getattr(w, name)) if isinstance(getattr(w, name), type) and getattr(w, name).__module__.endswith("_core") else ():
            assert member.startswith("__") or f" {member}(" in stub, (name, member)


def test_the_examples_run(capsys, monkeypatch):
    monkeypatch.syspath_prepend(str(pathlib.Path(__file__).parents[2] / "app" / "python" / "examples"))
    import stacking
    import verdict_map
    env = stacking.Stacking(blocks=3)
    observation, info = env.reset(seed=1)
    assert observation.shape == (3,) and np.isfinite(observation).sum() == 1
    _, reward, terminated, truncated, info = env.step(0.1)
    assert reward > 1.0 and not terminated and not truncated and info["verdict"] == "stands"
    assert env.step(0.7)[2:4] == (True, False) and env.render().shape == (360, 480, 4)
    x, y, stands = verdict_map.verdicts(13, 13)
    # b and c stand where |c| <= 1/2 and the centre of both, b + c / 2, is above a.
    c, b = np.meshgrid(y, x, indexing="ij")
    assert np.array_equal(stands, (np.abs(c) <= 0.5) & (np.abs(b + c / 2) <= 0.5))
