"""Runs kept among the results of benchmarks/validation: a calibration whose folders are gone goes on from them.

Usage: kept_runs_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import pathlib
import shutil
import sys
import types
import unittest

from repose_runs import FolderTest, Program

DECK = """
base = "{base}"
set = ["particles.0.mass=0.03 g", "output.snapshot_interval=0", "phase.settle.max_time=20 ms", "phase.settle.min_time=0",
       "phase.discharge.max_time=40 ms", "phase.discharge.min_time=0"]
[[parameter]]
name = "sliding_friction"
key = "pair.0.sliding_friction"
values = {values}
[[observable]]
figure = "discharged_mass_kg"
laboratory = 20e-6
deviation = 3e-6
"""


class KeptRuns(FolderTest):
    def setUp(self):
        super().setUp()
        folder = pathlib.Path(self.folder)
        self.options = types.SimpleNamespace(work=folder / "work", results=folder / "results")
        self.options.work.mkdir()

    def calibrate(self, values=(0.1, 0.3, 0.5, 0.7, 0.9)):
        """As a study of benchmarks/validation does it; the estimate."""
        import kept_runs
        import repose
        deck = self.options.work / "friction.toml"
        deck.write_text(DECK.format(base=self.program.deck("discharge_quick.toml"), values=list(values)))
        with kept_runs.kept(self.options, "friction"):
            return repose.calibrate(deck, self.options.work / "friction", program=self.program.executable).estimate

    def kept_file(self):
        (path,) = (self.options.results / "runs").iterdir()
        return path.read_bytes()

    def test_a_calibration_goes_on_from_them(self):
        estimate, kept = self.calibrate(), self.kept_file()
        shutil.rmtree(self.options.work / "friction")
        again = self.calibrate()
        self.assertEqual(again["observables"], estimate["observables"])
        self.assertEqual(self.kept_file(), kept)
        # None was run again: a run leaves its series, what is kept is the summary.
        self.assertEqual(list(self.options.work.glob("friction/runs/*/series.csv")), [])

    def test_only_what_is_missing_is_run(self):
        self.calibrate(values=(0.1, 0.3, 0.7, 0.9))
        shutil.rmtree(self.options.work / "friction")
        self.calibrate()
        ran = [path.parent.name for path in self.options.work.glob("friction/runs/*/series.csv")]
        self.assertEqual(ran, ["sliding_friction=0.5,seed=1"])

    def test_what_was_run_stays_when_the_study_fails(self):
        import kept_runs
        with self.assertRaises(ZeroDivisionError), kept_runs.kept(self.options, "friction"):
            run = self.options.work / "friction" / "runs" / "a"
            run.mkdir(parents=True)
            (run / "failed.json").write_text('{"code": 4}')
            raise ZeroDivisionError
        shutil.rmtree(self.options.work / "friction")
        with kept_runs.kept(self.options, "friction"):
            self.assertEqual((self.options.work / "friction" / "runs" / "a" / "failed.json").read_text(), '{"code": 4}')

    def test_runs_that_are_there_are_left(self):
        import kept_runs
        self.calibrate()
        run = self.options.work / "friction" / "runs" / "sliding_friction=0.1,seed=1"
        (run / "summary.json").write_text("{}")
        with kept_runs.kept(self.options, "friction"):
            self.assertEqual((run / "summary.json").read_text(), "{}")


if __name__ == "__main__":
    KeptRuns.program = Program(*sys.argv[1:4])
    sys.path.insert(0, os.path.join(sys.argv[3], "benchmarks", "validation"))
    sys.path.insert(0, os.path.join(sys.argv[3], "tools", "python"))
    unittest.main(argv=sys.argv[:1], verbosity=2)
