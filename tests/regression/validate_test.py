"""`repose validate`: cases are run once, compared with what was measured elsewhere, and go on where they were interrupted.

Usage: validate_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import json
import os
import signal
import subprocess
import sys
import time
import tomllib
import unittest

from repose_runs import FolderTest, Program
from study_decks import case_text

# A hundred grains through a wide orifice onto a near plate: seconds.
REDUCED = ["particles.0.mass=0.05 g", "particles.0.height=20 mm", "output.snapshot_interval=0", "phase.settle.max_time=50 ms",
           "phase.settle.min_time=0", "phase.discharge.max_time=150 ms", "phase.discharge.min_time=0"]


class Validate(FolderTest):
    def setUp(self):
        super().setUp()
        self.output = self.path("out")

    def write(self, *cases):
        path = self.path("validation.toml")
        with open(path, "w") as file:
            file.write('published = "theirs"\n')
            for case in cases:
                deck = self.program.deck("discharge_quick.toml")
                file.write(case_text(**{"deck": deck, "set": REDUCED, **case}))
        return path

    def validate(self, path, *options, ranks=0):
        return self.program.call("validate", path, "--output", self.output, "--quiet", *options, ranks=ranks)

    def test_cases_are_compared_and_run_once(self):
        path = self.write({"name": "one"}, {"name": "two", "set": [*REDUCED, "run.seed=2"]})
        done = self.validate(path, ranks=2)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in done.stdout.splitlines()]
        self.assertEqual(rows[0], ["case", "figure", "laboratory", "theirs", "difference", "here", "difference"])
        self.assertEqual([row[0] for row in rows[2:]], ["one", "one", "two", "two"])
        self.assertEqual(rows[2][1:5], ["discharged mass, g", "0.04000 +- 0.0020", "0.04100", "+2.5 %"])
        self.assertEqual(rows[3][1:5], ["angle of repose, degrees", "30.00", "none", "-"])
        with open(os.path.join(self.output, "validation.json")) as file:
            cases = json.load(file)["cases"]
        for case in cases:
            with open(os.path.join(self.output, case["name"], "summary.json")) as file:
                summary = json.load(file)
            self.assertEqual(case["state_hash"], summary["state_hash"])
            self.assertEqual([c["here"] for c in case["comparisons"]],
                             [summary["discharged_mass_kg"], summary["angle_of_repose_deg"]])
        self.assertNotEqual(cases[0]["state_hash"], cases[1]["state_hash"])
        here = 1e3 * cases[0]["comparisons"][0]["here"]
        self.assertEqual(rows[2][5:], [f"{here:#.4g}", f"{100 * (here / 0.04 - 1):+.1f} %"])

        written = os.stat(os.path.join(self.output, "one", "summary.json")).st_mtime_ns
        again = self.validate(path)
        self.assertEqual((again.returncode, again.stdout), (0, done.stdout))
        self.assertEqual(os.stat(os.path.join(self.output, "one", "summary.json")).st_mtime_ns, written)

    def test_figures_are_shown_in_units_of_the_laboratory(self):
        done = self.validate(self.write({"name": "one", "figure": "discharge_rate_kg_s"}))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines()[3].split("|")[2].strip(), "discharge rate, g/s")

    def test_one_case_of_several(self):
        path = self.write({"name": "one"}, {"name": "two"}, {"name": "three"})
        done = self.validate(path, "--case", "three", "--case", "one")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line.split("|")[1].strip() for line in done.stdout.splitlines()[2::2]], ["one", "three"])
        self.assertFalse(os.path.exists(os.path.join(self.output, "two")))
        done = self.validate(path, "--case", "two")  # beside those that are complete
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line.split("|")[1].strip() for line in done.stdout.splitlines()[2::2]], ["one", "two", "three"])
        path = self.write({"name": "one", "set": [*REDUCED, "run.seed=9"]}, {"name": "two"}, {"name": "three"})
        done = self.validate(path, "--case", "two")  # what is there of "one" is of another deck
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.output, "validation.json")) as file:
            self.assertEqual([case["name"] for case in json.load(file)["cases"]], ["two", "three"])

    def test_an_interrupted_case_goes_on(self):
        longer = [*REDUCED, "phase.discharge.max_time=2", "phase.discharge.min_time=2"]  # some seconds of wall time
        path = self.write({"name": "one", "set": longer})
        whole = self.validate(path)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        self.output = self.path("parts")
        command = [self.program.executable, "validate", path, "--output", self.output, "--quiet"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            series = os.path.join(self.output, "one", "series.csv")
            while process.poll() is None and (not os.path.exists(series) or os.path.getsize(series) < 2000):
                time.sleep(0.01)
            process.send_signal(signal.SIGUSR1)
        self.assertEqual(process.returncode, 75)
        self.assertFalse(os.path.exists(os.path.join(self.output, "one", "summary.json")))
        done = self.validate(path)
        self.assertEqual((done.returncode, done.stdout), (0, whole.stdout), done.stderr)

    def test_mistakes_are_one_line(self):
        for case, code, message in (
                ({"name": "one", "figure": "angle_of_repose"}, 2, 'did you mean "angle_of_repose_deg"'),
                ({"name": "one", "figure": "phases"}, 2, '"phases" is no figure that runs have'),
                ({"name": "../one"}, 2, "names a folder"),
                ({"name": "one", "deck": "absent.toml"}, 4, "absent.toml: cannot open"),
                ({"name": "other", "set": ["run.sed=1"]}, 2, "validation.toml:6: run.sed=1: unknown key")):
            done = self.validate(self.write(case))
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(message, done.stderr)
        done = self.validate(self.write({"name": "one"}, {"name": "two"}), "--case", "three")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r"--case three: .*validation\.toml has no such case, but one, two$")
        self.assertFalse(os.path.exists(self.output))
        done = self.validate(self.write({"name": "one"}, {"name": "two", "figure": "pile_hight_m"}))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("pile_height_m", done.stderr)
        self.assertFalse(os.path.exists(self.output), "a case was run before the mistake in the next one was said")
        done = self.validate(self.write({"name": "one"}, {"name": "one"}))
        self.assertIn('"one" is the name of another case, too', done.stderr)

    def test_the_decks_of_the_thesis(self):
        path = self.program.deck("validation.toml")
        with open(path, "rb") as file:
            cases = tomllib.load(file)["case"]
        self.assertEqual(len(cases), 3)
        for case in cases:
            settings = [part for setting in case.get("set", []) for part in ("--set", setting)]
            done = self.program.call("check", self.program.deck(case["deck"]), *settings)
            self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    Validate.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
