"""repose import: the example script becomes a deck that checks, runs, and ends as LIGGGHTS does; what it lists, refuses and
writes. The way back: dump and H5MD of a snapshot.

Usage: import_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import os
import sys
import unittest

import h5py
import numpy as np

from repose_runs import FolderTest, Program

# LIGGGHTS 3.8 on input/import/in.slump with six seeds, mean and standard deviation of a run, by
# benchmarks/liggghts_tutorials/compare.py input/import build/release/src/repose --seeds 6
LIGGGHTS_HEIGHT_MM = (2.514, 0.054)  # of the centre of mass above the lowest grain's
OURS_MM = 0.096  # deviation of a run of repose, from the same table


class Import(FolderTest):
    def make(self, *options, script=None, folder="deck", ranks=0):
        done = self.program.call("import", script or os.path.join(self.program.source, "input/import/in.slump"),
                                 "--output", self.path(folder), *options, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def script(self, *changes):
        """The example with texts replaced, in the test's folder."""
        with open(os.path.join(self.program.source, "input/import/in.slump")) as file:
            text = file.read()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        with open(self.path("in.changed"), "w") as file:
            file.write(text)
        return self.path("in.changed")

    def test_the_example_ends_as_in_liggghts(self):
        self.assertEqual(self.make("--strict"), f"{self.path('deck')}/slump.toml\n")
        deck = self.path("deck/slump.toml")
        checked = self.program.call("check", deck)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn("particles   400", checked.stdout)
        summary = self.program.run(deck, self.path("run"), "output.snapshot_times=[0.25]", ranks=2)
        self.assertEqual(summary["particles"]["inside"], 400)
        self.assertEqual([phase["steps"] for phase in summary["phases"]], [15000, 15000])
        settling, snapshot = sorted(glob.glob(self.path("run/run_*.hdf")))[-2:]
        with h5py.File(snapshot) as file:
            z, mass = file["particles/position"][:, 2], file["particles/mass"][...]
        height = 1e3 * (np.sum(mass * z) / np.sum(mass) - np.min(z))
        mean, deviation = LIGGGHTS_HEIGHT_MM
        self.assertLess(abs(height - mean), 3 * (deviation**2 + OURS_MM**2) ** 0.5, height)
        self.go_back(settling)

    def go_back(self, snapshot):
        """A dump as the start of the same script; H5MD has the same numbers."""
        dump = self.path("settling.dump")
        done = self.program.call("export", snapshot, "--format", "dump", "--output", dump)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = self.make("--dump", dump, folder="back")
        self.assertIn("fix ins: the grains of", said)
        grains = np.genfromtxt(self.path("back/grains.csv"), delimiter=",", names=True, dtype=None, encoding="utf8")
        with h5py.File(snapshot) as file:
            particles = {name: file["particles"][name][...] for name in file["particles"]}
            time, step = float(file.attrs["time_s"]), int(file.attrs["step"])
        self.assertEqual([grains[c].tolist() for c in "xyz"], particles["position"].T.tolist())
        self.assertEqual(grains["radius"].tolist(), particles["radius"].tolist())
        self.assertEqual(self.program.call("check", self.path("back/slump.toml")).returncode, 0)
        path = self.path("settling.h5")
        done = self.program.call("export", snapshot, "--format", "h5md", "--output", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(path) as file:
            self.assertEqual(file["h5md"].attrs["version"].tolist(), [1, 1])
            group = file["particles/grains"]
            for name in ("position", "velocity", "angular_velocity"):
                self.assertEqual(group[name]["step"][...].tolist(), [step])
                self.assertEqual(group[name]["time"][...].tolist(), [time])
                self.assertTrue(np.array_equal(group[name]["value"][0], particles[name]), name)
            self.assertTrue(np.array_equal(group["mass"][...], particles["mass"]))
            box = group["box"].attrs
            self.assertEqual((box.get_id("dimension").shape, box["dimension"]), ((), 3))
            self.assertEqual((box["boundary"].dtype, box["boundary"].tolist()), ("S4", [b"none"] * 3))
            for of, name in (("author", "name"), ("creator", "name"), ("creator", "version")):
                text = file[f"h5md/{of}"].attrs.get_id(name)  # of a fixed length
                self.assertEqual((text.shape, text.dtype.kind), ((), "S"), name)
            self.assertNotIn("temperature", group)
            self.assertEqual(np.round(group["box/edges"][...], 12).tolist(), [0.2, 0.2, 0.121])

    def test_what_has_no_counterpart_is_listed_or_refused(self):
        script = self.script(("thermo        5000", "fix drag all viscous 0.1"))
        said = self.make(script=script)
        self.assertIn("without a counterpart: in.changed:43: fix drag all viscous 0.1: there is no drag", said)
        with open(self.path("deck/changed.toml")) as file:
            self.assertIn("#   in.changed:43: fix drag all viscous 0.1: there is no drag\n", file.read())
        strict = self.path("strict")
        self.fails(2, "in.changed:43: fix drag all viscous 0.1: there is no drag", "import", script, "--output", strict, "--strict")
        self.assertFalse(os.path.exists(strict))

    def test_a_long_time_step_is_warned_of(self):
        said = self.make("--strict", script=self.script(("timestep    ${dt}", "timestep 1e-4")))
        self.assertIn("\nwarning: in.changed:27: timestep: it takes 0.41 of the Rayleigh time and 0.21 of the Hertz time; shares "
                      "above 0.2 and 0.1 can keep beds from resting\n", said)

    def test_errors_name_the_line(self):
        for change, message in [
            (("peratomtype 0.3", "peratomtype much"), r"in\.changed:20: \"much\" where a number is expected"),
            (("atom_style  granular", "atom_style superquadric"), r"in\.changed:9: atom_style superquadric: only grains"),
            (("${rin}", "${rim}"), r"in\.changed:38: no variable \"rim\" is defined above; the nearest is \"rin\""),
            (("timestep    ${dt}", "timestep 1"), r"in\.changed: as a deck it is refused: .*time.step"),
        ]:
            script = self.script(change)
            self.fails(2, message, "import", script, "--output", self.path("none"))
        self.fails(4, "in.nowhere: cannot", "import", self.path("in.nowhere"), "--output", self.path("none"))
        self.assertFalse(os.path.exists(self.path("none")))

    def test_what_was_edited_stays(self):
        said = self.make(ranks=2)
        self.assertEqual(said.count("slump.toml"), 1, said)
        self.assertEqual(self.make(), said)  # the same bytes
        deck = self.path("deck/slump.toml")
        with open(deck, "a") as file:
            file.write("# mine\n")
        self.fails(4, r"slump\.toml: is there already, with another content; name another folder", "import",
                   os.path.join(self.program.source, "input/import/in.slump"), "--output", self.path("deck"))
        with open(deck) as file:
            self.assertTrue(file.read().endswith("# mine\n"))

    def test_variables_of_the_command_line(self):
        self.make("--var", "r=0.03", script=self.script(("equal 0.02 ", "index 0.02 ")))
        with open(self.path("deck/changed.toml")) as file:
            self.assertIn("points = [[0.03, ", file.read())


Import.program = Program(*sys.argv[1:4])
unittest.main(argv=sys.argv[:1])
