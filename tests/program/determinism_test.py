"""One hash over all states: the same however a run is looked at, wherever it runs, and with the binaries named as arguments."""
import json
import os
import pathlib
import subprocess
import sys

from program import FLYING, PROGRAM, ProgramTest, comma_locale, main

SCENES = ("demo", "pile", "ladder", "tilted_drop", "fig1_stack", "dominoes")
PROBE = os.path.join(os.environ["BUILD"], "tests", "scene_probe")
OTHERS = [name for name in sys.argv[1:] if os.path.exists(name)]
OTHER_MACHINES = ({"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA"}, {"OMP_NUM_THREADS": "7", "LP_NUM_THREADS": "7"})


class Determinism(ProgramTest):
    def state_hash(self, scene, *options, program=PROGRAM, until="1", **environment):
        self.program = program
        done = self.call("run", scene, "--until", until, "--json", "--quiet", *options, env={**os.environ, **environment})
        return json.loads(done.stdout)["audit"]["state_hash"]

    def test_looking_changes_nothing(self):
        for scene in SCENES:
            expected = self.state_hash(scene)
            for looks in (("--states", "s.csv", "--fps", "7"), ("--forces", "f.csv", "--fps", "90"), ("--sample", "0.1,0.77"),
                          ("-o", "f/", "--size", "64x64", "--fps", "5")):
                with self.subTest(scene, looks=looks):
                    self.assertEqual(self.state_hash(scene, *looks), expected)

    def test_other_machines_find_the_same(self):
        for scene in SCENES:
            expected = self.state_hash(scene)
            for environment in OTHER_MACHINES:
                with self.subTest(scene, environment=environment):
                    self.assertEqual(self.state_hash(scene, **environment), expected)

    def test_other_machines_find_the_same_where_friction_is_hard(self):
        """Programs at impacts of crowds that rub are tried from several starting points."""
        expected = self.state_hash("demo", until="2.5")
        for environment in OTHER_MACHINES:
            with self.subTest(environment=environment):
                self.assertEqual(self.state_hash("demo", until="2.5", **environment), expected)

    def test_other_machines_draw_the_same(self):
        layers = "cubes,rods,forces,contact-forces,velocities,mechanism,values,symbols,hud,contacts,trails"
        for scene in ("pile", "trebuchet"):
            for suffix in ("png", "svg"):
                names = [f"{number}.{suffix}" for number in range(1 + len(OTHER_MACHINES))]
                for name, environment in zip(names, ({}, *OTHER_MACHINES)):
                    self.expect(0, "figure", scene, "--time", "0.37", "--layers", layers, "-o", name, env={**os.environ, **environment})
                with self.subTest(scene, suffix=suffix):
                    self.assertEqual(1, len({pathlib.Path(self.path(name)).read_bytes() for name in names}))

    def test_a_comma_locale_changes_nothing(self):
        comma = comma_locale(self.folder)
        for scene in SCENES:
            self.assertEqual(self.state_hash(scene, **comma), self.state_hash(scene))
        done = self.expect(0, "run", self.scene(FLYING), "--states", "-", "--fps", "4", "--quiet", env=comma)
        self.assertIn("0.25,a,0.25,", done.stdout)
        # Nor does it where somebody else's program, which uses the library, has made it its own.
        for name in SCENES:
            scene = os.path.join(os.environ["SCENES"], name + ".toml")
            found = [subprocess.run([PROBE, "--normalise", scene, *locale], env=comma, check=True, capture_output=True).stdout
                     for locale in ((), ("de_DE.UTF-8",))]
            self.assertEqual(found[0], found[1])

    def test_it_tells_motions_apart(self):
        hashes = [self.state_hash("ladder", *options) for options in ((), ("--integrator", "rattle"), ("--tolerance", "1e-9"),
                                                                            ("--set", "gravity=[0,-9.81000000001]"))]
        self.assertEqual(len(set(hashes)), len(hashes))

    def test_other_builds_find_the_same(self):
        for program in OTHERS:
            for scene in SCENES:
                for options in ((), ("--integrator", "rattle"), ("--integrator", "moreau"), ("--integrator", "euler")):
                    with self.subTest(program, scene=scene, options=options):
                        self.assertEqual(self.state_hash(scene, *options, program=program), self.state_hash(scene, *options))


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    main()
