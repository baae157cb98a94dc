"""The same bits on 1 and 4 ranks, and with other lists, for every kind of scene: whole decks in reduced size.

Usage: scenes_test.py EXECUTABLE MPIEXEC SOURCE_DIR

Each line of SCENES and of DOSTA2024 is a test: a deck of the input folder or of benchmarks/dosta2024, and what reduces
it to seconds.
"""

import os
import subprocess
import sys
import tempfile
import unittest

from repose_runs import Program

COLUMN = ("particles.0.height=12 mm", "phase.settle.min_time=5 ms", "phase.settle.max_time=8 ms",
          "phase.discharge.min_time=5 ms", "phase.discharge.max_time=8 ms")

SCENES = [
    ("carbohsp_multi.toml", ("particles.0.mass=0.1 g", *COLUMN)),
    ("sand_multi.toml", ("particles.0.mass=0.3 g", *COLUMN)),
    ("sand_mono.toml", ("particles.0.mass=0.3 g", *COLUMN)),
    ("scatter_carbohsp.toml", ("particles.0.mass=0.1 g", *COLUMN)),
    ("scatter_sand.toml", ("particles.0.mass=0.3 g", *COLUMN)),
    ("rotating_drum.toml", ("particles.0.count=600", "particles.0.diameter=2 mm", "particles.0.spacing=2.2 mm",
                            "phase.fill.time=60 ms", "phase.turn.time=60 ms")),
    ("inclined_plane.toml", ("phase.rest.max_time=30 ms", "phase.rest.min_time=1 ms", "phase.tilt.max_time=30 ms",
                             "measurement.tilt_onset.extrapolate=false")),
    ("inclined_plane_sand.toml", ("phase.rest.max_time=30 ms", "phase.rest.min_time=1 ms", "phase.tilt.max_time=30 ms",
                                  "measurement.tilt_onset.extrapolate=false")),
    ("pour_quick.toml", ("phase.pour.max_time=30 ms",)),
    ("lifted_cylinder.toml", ("particles.0.count=1000", "phase.settle.min_time=5 ms", "phase.settle.max_time=8 ms", "phase.lift.time=8 ms",
                              "phase.rest.min_time=0", "phase.rest.max_time=1 ms")),
    ("ledge.toml", ("particles.0.count=1000", "phase.settle.time=8 ms", "phase.collapse.time=8 ms")),
]

DOSTA2024 = [
    ("penetration.toml", ("phase.impact.time=0.1 ms", "particles.1.first=[0,0,-0.046]")),  # the ball touches the bed
    ("drum.toml", ("phase.turn.time=0.1 ms",)),
    ("drum_mesh.toml", ("phase.turn.time=0.1 ms",)),
    ("silo.toml", ("particles.0.count=2000", "phase.settle.min_time=1 ms", "phase.settle.max_time=1.5 ms",
                   "phase.discharge.time=0.6 ms")),
]


class Scenes(unittest.TestCase):
    program = None
    dosta2024 = None  # folder of its decks and of what they read

    def compare(self, deck, overrides):
        with tempfile.TemporaryDirectory() as folder:
            def arguments(name, *more):
                return (deck, os.path.join(folder, name), *overrides, *more)
            quiet = ("--quiet",)
            one, lists = self.program.run_all(
                [arguments("one"), arguments("lists", "neighbours.skin=0.1", "neighbours.inner_skin=0.01")], quiet)
            self.assertGreater(one["particles"]["inside"], 100)
            for other in (self.program.run(*arguments("four"), ranks=4, options=quiet), lists):
                for key in ("state_hash", "steps", "particles", "sizes", "phases"):
                    self.assertEqual(one[key], other[key])
            return one

    def test_snapshot_continues_where_another_run_has_ended(self):
        pour = self.program.deck("pour_quick.toml")
        with tempfile.TemporaryDirectory() as folder:
            first = self.program.run(pour, folder, "phase.pour.max_time=30 ms", options=("--quiet",))
            (name,) = [f for f in os.listdir(folder) if f == f"run_{first['steps']:010d}.hdf"]
            with open(pour) as file:
                text = file.read()
            begin, end = text.index("[[particles]]"), text.index("[[phase]]")
            deck = os.path.join(folder, "continued.toml")
            with open(deck, "w") as file:
                file.write(f'{text[:begin]}[[particles]]\ntype = "snapshot"\nfile = "{name}"\n\n{text[end:]}')
            second = self.compare(deck, ("phase.pour.max_time=10 ms",))
            self.assertEqual(second["particles"]["inserted"], first["particles"]["inside"])


def add_test(deck, overrides, prefix="", folder=lambda: os.path.join(Scenes.program.source, "input")):
    def test(self):
        self.compare(os.path.join(folder(), deck), overrides)

    name = "test_" + prefix + os.path.splitext(deck)[0]
    while hasattr(Scenes, name):
        name += "_"
    setattr(Scenes, name, test)


for scene in SCENES:
    add_test(*scene)
for scene in DOSTA2024:
    add_test(*scene, prefix="dosta2024_", folder=lambda: Scenes.dosta2024)

if __name__ == "__main__":
    Scenes.program = Program(*sys.argv[1:4])
    benchmark = os.path.join(Scenes.program.source, "benchmarks", "dosta2024", "dosta2024.py")
    with tempfile.TemporaryDirectory() as Scenes.dosta2024:
        subprocess.run([sys.executable, benchmark, "prepare", "--work", Scenes.dosta2024], check=True)
        unittest.main(argv=sys.argv[:1], verbosity=2)
