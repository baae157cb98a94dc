"""`repose calibrate`, `estimate` and `sensitivity`: grids over groups of ranks, each run once, with the same tables and
estimates on any number of ranks; failed runs, wrong decks, grids that grow, searches.

Usage: calibrate_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import h5py

from repose_runs import REFUSED, FolderTest, Program

# Two hundred grains and a wide orifice, for some milliseconds. What they do does not matter here.
REDUCED = ["particles.0.mass=0.03 g", "particles.0.height=20 mm", "output.snapshot_interval=0", "phase.settle.max_time=15 ms",
           "phase.settle.min_time=0", "phase.discharge.max_time=60 ms", "phase.discharge.min_time=0",
           "measurement.discharge.plugged_share=0.02"]
HEAD = """
title = "in small"
base = "{base}"
seeds = {seeds}
ranks_per_run = {ranks_per_run}
set = {sets}
"""
SLIDING = '[[parameter]]\nname = "sliding"\nkey = "pair.0.sliding_friction"\n'
RESTITUTION = '[[parameter]]\nname = "restitution"\nkey = "pair.0.restitution"\n'
MASS = '[[observable]]\nfigure = "discharged_mass_kg"\nlaboratory = 8e-6\ndeviation = 1e-6\nrepeats = 4\n'
RATE = '[[observable]]\nfigure = "retained_mass_kg"\nlaboratory = 22e-6\ndeviation = 1e-6\nrepeats = 4\n'
LINE = SLIDING + "values = [0.1, 0.25, 0.4, 0.55, 0.7]\n"
CURVE = """[[observable]]
name = "spin"
curve = "spin.csv"
series = "series.csv"
x = "time_s"
y = "rotational_energy_J"
phase = "discharge"
"""
CLOSE_ROWS = [*REDUCED, "output.series_interval=1 ms"]
# The small discharge, and the same from a higher fill.
EXPERIMENTS = """
[[experiment]]
name = "low"
[[experiment.observable]]
figure = "discharged_mass_kg"
laboratory = 7e-6
deviation = 1e-6
[[experiment]]
name = "high"
set = ["particles.0.mass=0.04 g"]
seeds = 3
[[experiment.observable]]
figure = "discharged_mass_kg"
laboratory = 8e-6
deviation = 1e-6
[[experiment.observable]]
figure = "retained_mass_kg"
laboratory = 30e-6
deviation = 1e-6
"""
GRID = SLIDING + "values = [0.1, 0.4]\n" + RESTITUTION + "min = 0.2\nmax = 0.8\npoints = 3\n" + MASS + RATE


class Calibrate(FolderTest):
    kept_levels = None

    def setUp(self):
        super().setUp()
        self.output = self.path("out")

    def write(self, text, sets=REDUCED, seeds=2, ranks_per_run=1):
        path = self.path("study.toml")
        with open(path, "w") as file:
            file.write(HEAD.format(base=self.program.deck("discharge_quick.toml"), seeds=seeds,
                                   ranks_per_run=ranks_per_run, sets=json.dumps(sets)) + text)
        return path

    def call(self, command, path, *options, ranks=2, output=None, env=None):
        return self.program.call(command, path, "--output", output or self.output, *options, ranks=ranks, env=env)

    def calibrate(self, *arguments, **named):
        done = self.call("calibrate", *arguments, **named)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def refused(self, path, message, command="calibrate"):
        done = self.call(command, path, env=REFUSED)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn(message, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.output, "runs")))

    def table(self, output=None):
        with open(os.path.join(output or self.output, "grid.csv")) as file:
            return list(csv.DictReader(file))

    def read(self, name, output=None):
        with open(os.path.join(output or self.output, name)) as file:
            return file.read()

    def test_a_grid_is_the_same_on_any_ranks_and_groups(self):
        outputs = [self.path(name) for name in ("one", "two", "three")]
        says = [self.calibrate(self.write(GRID), ranks=1, output=outputs[0]),
                self.calibrate(self.write(GRID), ranks=2, output=outputs[1]),
                self.calibrate(self.write(GRID, ranks_per_run=2), ranks=5, output=outputs[2])]
        for ranks, groups, text in zip((1, 2, 5), (1, 2, 2), says):
            self.assertIn("12 runs in", text)
            self.assertIn(f"on {ranks} rank{'s' if ranks > 1 else ''}, {groups} at a time", text)
            self.assertIn("12 runs: 12 done, 0 plugged, 0 failed, 0 to come\n"
                          "phase discharge was ended by max_time in 12 of 12\n"
                          "phase settle was ended by max_time in 12 of 12\n", text)
            self.assertIn("standard error 5e-07 (1e-06 / sqrt(4))", text)
        for output in outputs[1:]:
            self.assertEqual(self.read("grid.csv", output), self.read("grid.csv", outputs[0]))
            self.assertEqual(self.read("estimate.json", output), self.read("estimate.json", outputs[0]))
        rows = self.table(outputs[0])
        self.assertEqual([(r["sliding"], r["restitution"], r["seed"]) for r in rows[:3]],
                         [("0.1", "0.2", "1"), ("0.1", "0.2", "2"), ("0.1", "0.5", "1")])
        self.assertGreater(len({r["discharged_mass_kg"] for r in rows}), 6)

    def test_the_table_is_that_of_the_runs(self):
        self.calibrate(self.write(GRID))
        rows = self.table()
        with h5py.File(os.path.join(self.output, "grid.h5")) as file:
            runs = file["runs"]
            self.assertEqual(list(runs["parameters"].attrs["names"]), ["sliding", "restitution"])
            self.assertEqual(list(runs["figures"].attrs["names"]), ["discharged_mass_kg", "retained_mass_kg"])
            folders = [name.decode() for name in runs["folder"]]
            for k, row in enumerate(rows):
                with open(os.path.join(self.output, folders[k], "summary.json")) as summary_file:
                    summary = json.load(summary_file)
                self.assertEqual(summary["discharged_mass_kg"], float(row["discharged_mass_kg"]))
                self.assertEqual(summary["discharged_mass_kg"], runs["figures"][k, 0])
                self.assertEqual(summary["state_hash"], runs["state_hash"][k].decode())
                self.assertIn(f"sliding_friction = {float(row['sliding'])}", summary["deck"])
                self.assertIn(f"restitution = {float(row['restitution'])}", summary["deck"])
                self.assertIn(f"seed = {row['seed']}", summary["deck"])
                self.assertIn(row["state"], ("done", "plugged"))
                self.assertEqual(row["state"], runs["state"][k].decode())
                self.assertGreater(file["effort/wall_seconds"][k], 0.0)
            self.assertEqual(file.attrs["deck"], self.read("calibration.toml"))
        self.assertIn("phase discharge ended", self.read(os.path.join(folders[0], "run.log")))

    def test_what_is_complete_is_not_run_again(self):
        self.calibrate(self.write(GRID))
        table = self.read("grid.csv")
        self.assertIn("0 runs in", self.calibrate(self.write(GRID)))
        self.assertEqual(self.read("grid.csv"), table)
        larger = GRID.replace("[0.1, 0.4]", "[0.1, 0.4, 0.7]")
        self.assertIn("6 runs in", self.calibrate(self.write(larger), ranks=3))
        self.assertEqual(len(self.table()), 18)
        self.assertEqual(self.read("grid.csv").splitlines()[:13], table.splitlines())

    def seeds_for(self, seconds):
        """How many seeds of GRID keep one rank of this machine busy for so long, or somewhat longer."""
        begin = time.monotonic()
        self.calibrate(self.write(GRID, seeds=1), ranks=1, output=self.path("probe"))
        return math.ceil(seconds / (time.monotonic() - begin)) + 1

    def test_a_time_limit_stops_it_and_the_same_command_goes_on(self):
        seeds = self.seeds_for(9.0)
        path, calm = self.write(GRID, seeds=seeds), self.path("calm")
        self.calibrate(path, output=calm)
        stopped = 0
        while True:
            done = self.call("calibrate", path, "--time-limit", "00:00:03", ranks=1)
            if done.returncode == 0:
                break
            self.assertEqual(done.returncode, 75, done.stderr)
            self.assertIn(f"of {6 * seeds} runs complete; the same command goes on from there", done.stderr)
            stopped += 1
            self.assertLess(stopped, 40)
        self.assertGreater(stopped, 0)
        self.assertEqual(self.read("grid.csv"), self.read("grid.csv", calm))

    def test_a_failed_run_ends_no_other_and_is_not_tried_again(self):
        text = GRID.replace(RESTITUTION + "min = 0.2\nmax = 0.8\npoints = 3\n",
                            '[[parameter]]\nname = "overlap"\nkey = "guards.max_overlap"\nvalues = [1e-5, 0.2, 0.3]\n')
        says = self.calibrate(self.write(text))
        self.assertIn("12 runs: 8 done, 0 plugged, 4 failed, 0 to come", says)
        for row in self.table():
            self.assertEqual(row["state"], "failed" if row["overlap"] == "1e-05" else "done")
            self.assertEqual("overlap" in row["reason"], row["state"] == "failed")
            self.assertEqual(row["discharged_mass_kg"] == "", row["state"] == "failed")
        self.assertIn("0 runs in", self.calibrate(self.write(text)))

    def test_more_groups_than_runs(self):
        text = SLIDING + "values = [0.1, 0.4]\n" + RESTITUTION + "values = [0.2, 0.3]\n" + MASS + RATE
        self.assertIn("on 7 ranks, 4 at a time", self.calibrate(self.write(text, seeds=1), ranks=7))

    def test_wrong_decks_are_refused_before_any_run(self):
        self.refused(self.write(GRID.replace("sliding_friction", "slidding_friction")), "slidding_friction")
        self.refused(self.write(GRID.replace("discharged_mass_kg", "discharge_mass_kg")),
                     'did you mean "discharged_mass_kg"?')
        self.refused(self.write(GRID.replace("retained_mass_kg", "tilt_onset_deg")),
                     "[measurement.tilt_onset], which the base deck lacks")
        self.refused(self.write(GRID.replace("[0.1, 0.4]", "[0.1, -0.4]")), "sliding_friction=-0.4")
        self.refused(self.write(GRID.replace('"restitution"', '"sliding"')), "names another parameter")
        self.refused(self.write(GRID.replace("min = 0.2", "min = 0.9")), '"max" = 0.8 must be above "min" = 0.9')
        self.refused(self.write(GRID.replace(RATE, "")), "2 parameters take as many [[observable]]s")
        self.refused(self.write(GRID.replace("repeats = 4\n", "deviation_is_known = false\n", 1)), "takes at least 2")
        self.refused(self.write(SLIDING + "values = [0.1, 0.4, 0.7]\n" + MASS), "3 points; a surface needs 4 or more")
        self.refused(self.write(SLIDING + "min = 0.1\nmax = 0.2\n" + MASS), 'lacks "points" or "values"')

    def test_two_jobs_at_once_are_refused(self):
        path = self.write(GRID.replace("points = 3", "points = 60"))
        command = [self.program.executable, "calibrate", path, "--output", self.output]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as first:
            try:
                while not os.path.exists(os.path.join(self.output, "grid.csv")) and first.poll() is None:
                    time.sleep(0.05)
                done = self.call("calibrate", path)
            finally:
                first.kill()
        self.assertEqual(done.returncode, 4, done.stdout)
        self.assertIn("another run is at work in this directory", done.stderr)

    def test_what_was_set_stays_with_the_runs(self):
        self.calibrate(self.write(LINE + MASS, seeds=1), "--set", "output.series_interval=2 ms")
        self.assertTrue(self.read("calibration.toml").startswith("# --set output.series_interval=2 ms\n"))
        self.assertIn("--set &#x27;output.series_interval=2 ms&#x27;", self.report(self.output))
        done = self.program.call("estimate", self.output)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_another_base_deck_in_the_same_directory_is_refused(self):
        self.calibrate(self.write(GRID, seeds=1))
        done = self.call("calibrate", self.write(GRID, sets=[*REDUCED, "pair.1.restitution=0.3"], seeds=1))
        self.assertEqual(done.returncode, 2)
        self.assertIn("restitution", done.stderr)
        self.assertNotIn("pair.1.restitution=0.3", self.read("calibration.toml"))  # what was refused has left nothing

    def test_a_run_that_cannot_be_set_up_is_named_and_tried_again(self):
        """A grid goes on without it; a search, which would decide otherwise without it, does not."""
        radius = '[[parameter]]\nname = "radius"\nkey = "particles.0.radius"\nvalues = [3e-4, 3.5e-3, 3.6e-3]\n'
        text = GRID.replace(RESTITUTION + "min = 0.2\nmax = 0.8\npoints = 3\n", radius)
        for _ in range(2):
            says = self.calibrate(self.write(text, seeds=1))
            self.assertIn("6 runs: 4 done, 0 plugged, 0 failed, 2 to come\nruns/sliding=0.1,radius=0.0003,seed=1: ", says)
            self.assertIn("particles fit into the region", says)
        self.assertEqual([row["state"] for row in self.table() if "fit" in row["reason"]], ["waiting"] * 2)
        narrow = radius.replace("values = [3e-4, 3.5e-3, 3.6e-3]", "min = 3e-4\nmax = 4e-4")
        search = SLIDING + "min = 0.1\nmax = 0.4\n" + narrow + MASS + RATE + \
            "[adaptive]\nstart = 4\nbatch = 2\nbudget = 6\nhalf_width = 0.01\n"
        done = self.call("calibrate", self.write(search, seeds=1), output=self.path("search"))
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertRegex(done.stderr, r"repose: runs/\S+: .*particles fit into the region.*; change the ranges of the parameters")

    def test_estimate_with_other_laboratory_values(self):
        self.calibrate(self.write(GRID))
        own = self.read("estimate.json")
        done = self.program.call("estimate", self.output)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.read("estimate.json"), own)
        done = self.program.call("estimate", self.output, "--deck", self.write(GRID.replace("8e-6", "8.5e-6")))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(self.read("estimate.json"), own)
        rate = GRID.replace("retained_mass_kg", "discharge_rate_kg_s").replace("22e-6", "1e-3")  # which the table does not have
        done = self.program.call("estimate", self.output, "--deck", self.write(rate))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.draw(self.output)

    def test_pictures(self):
        tool = os.path.join(self.program.source, "tools", "plot_calibration.py")
        single = SLIDING + "values = [0.1, 0.2, 0.3, 0.4]\n" + MASS
        for name, text in (("plane", GRID), ("line", single)):
            output = self.path(name)
            self.calibrate(self.write(text), output=output)
            drawn = subprocess.run([tool, output], capture_output=True, text=True)
            self.assertEqual(drawn.returncode, 0, drawn.stderr)
            for ending in ("png", "pdf"):
                self.assertGreater(os.path.getsize(os.path.join(output, f"calibration.{ending}")), 5000)

    PRIOR = 'prior = "normal"\nprior_mean = 0.5\nprior_deviation = 0.1\n'

    def test_a_prior_in_place_of_an_observable(self):
        """The posterior of two parameters from one figure; the same on any ranks, and gone without the prior."""
        known = SLIDING + "values = [0.1, 0.3, 0.5]\n" + RESTITUTION + "min = 0.2\nmax = 0.8\npoints = 3\n"
        text = known + self.PRIOR + MASS
        outputs = [self.path(name) for name in ("one", "three")]
        says = [self.calibrate(self.write(text), ranks=ranks, output=output) for ranks, output in zip((1, 3), outputs)]
        for name in ("grid.csv", "estimate.json", "posterior.csv"):
            self.assertEqual(self.read(name, outputs[0]), self.read(name, outputs[1]))
        found = json.loads(self.read("estimate.json", outputs[0]))
        self.assertIn("posterior of 2 parameters from 1 observable", found["verdict"])
        self.assertIn(found["verdict"], says[0])
        self.assertEqual([p["prior"] for p in found["parameters"]],
                         [{"kind": "uniform"}, {"kind": "normal", "mean": 0.5, "deviation": 0.1}])
        with open(os.path.join(outputs[0], "posterior.csv")) as file:
            samples = list(csv.DictReader(file))
        self.assertEqual(len(samples), found["posterior"]["samples"])
        for name, low, high, marginal in zip(("sliding", "restitution"), (0.1, 0.2), (0.5, 0.8),
                                             found["posterior"]["marginals"]):
            values = [float(row[name]) for row in samples]
            self.assertGreaterEqual(min(values), low)
            self.assertLessEqual(max(values), high)
            self.assertAlmostEqual(sum(values) / len(values), marginal["mean"], 6)
        if found["points"]:
            self.assertIn(f"  restitution              best {found['points'][0]['values'][1]:.4g}; ", says[0])
        self.draw(outputs[0])
        self.assertGreater(os.path.getsize(os.path.join(outputs[0], "calibration.png")), 5000)
        done = self.program.call("estimate", outputs[0], "--deck", self.write(known + MASS + RATE))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("posterior", self.read("estimate.json", outputs[0]))
        self.assertFalse(os.path.exists(os.path.join(outputs[0], "posterior.csv")))

    def test_a_search_over_four_parameters(self):
        """With fewer observables than parameters, and a design in place of a grid."""
        text = (SLIDING + "min = 0.1\nmax = 0.7\n" + RESTITUTION + "min = 0.2\nmax = 0.8\n" + self.PRIOR +
                '[[parameter]]\nname = "wall"\nkey = "pair.1.sliding_friction"\nmin = 0.1\nmax = 0.7\n'
                '[[parameter]]\nname = "stiffness"\nkey = "material.0.youngs_modulus"\nmin = 1e6\nmax = 6e6\n'
                'prior = "lognormal"\nprior_mean = 3e6\nprior_deviation = 1e6\n' + MASS + RATE +
                "[adaptive]\nstart = 12\nbatch = 2\nbudget = 16\nhalf_width = 0.01\n")
        outputs = [self.path(name) for name in ("one", "three")]
        for ranks, output in zip((1, 3), outputs):
            self.calibrate(self.write(text, seeds=1), ranks=ranks, output=output)
        for name in ("grid.csv", "estimate.json", "posterior.csv", "search.csv"):
            self.assertEqual(self.read(name, outputs[0]), self.read(name, outputs[1]))
        self.assertEqual(len(self.table(outputs[0])), 16)
        found = json.loads(self.read("estimate.json", outputs[0]))
        self.assertEqual(len(found["posterior"]["marginals"]), 4)
        self.assertEqual(len(found["posterior"]["correlations"][3]), 4)

    def test_wrong_priors_are_refused(self):
        known = GRID.replace("min = 0.2", "PRIORmin = 0.2").replace(RATE, "")
        def wrong(prior, message, text=known, **named):
            self.refused(self.write(text.replace("PRIOR", prior)), message, **named)
        wrong('prior = "flat"\n', "must be one of uniform, normal, lognormal")
        wrong("prior_mean = 0.5\n", 'take prior = "normal" or "lognormal"')
        wrong('prior = "normal"\nprior_mean = 0.5\n', 'takes "prior_mean" and "prior_deviation"')
        wrong(self.PRIOR.replace("0.1", "0"), "prior_deviation")
        wrong(self.PRIOR.replace("0.5", "1.5"), "of its prior lies from min = 0.2 to max = 0.8")
        wrong(self.PRIOR.replace("normal", "lognormal").replace("0.5", "-0.5"), "must be above 0 for a lognormal prior")
        wrong(self.PRIOR.replace("normal", "lognormal"), "must be above 0 for a lognormal prior",
              text=known.replace("min = 0.2", "min = 0"))
        wrong(self.PRIOR, "is only allowed with a calibration", command="sensitivity",
              text='figures = ["discharged_mass_kg"]\n' + RESTITUTION + "PRIORmin = 0.2\nmax = 0.8\nfixed = 0.5\n")
        many = "".join(f'[[parameter]]\nname = "p{k}"\nkey = "particles.{k}.mass"\nmin = 0.1\nmax = 0.2\n' for k in range(7))
        wrong("", "7 parameters; at most 6 can be estimated together",
              text=many + MASS + "[adaptive]\nstart = 12\nbatch = 2\nbudget = 16\nhalf_width = 0.01\n")

    def test_a_search_depends_on_nothing_but_its_runs(self):
        search = (SLIDING + "min = 0.1\nmax = 0.7\n" + RESTITUTION + "min = 0.2\nmax = 0.8\n" + MASS + RATE +
                  "[adaptive]\nstart = 5\nbatch = 2\nbudget = 9\nhalf_width = 0.01\n")
        outputs = [self.path(name) for name in ("one", "three")]
        for ranks, output in zip((1, 3), outputs):
            self.assertIn("18 runs: ", self.calibrate(self.write(search), ranks=ranks, output=output))
        self.assertEqual(self.read("grid.csv", outputs[0]), self.read("grid.csv", outputs[1]))
        self.assertEqual(self.read("estimate.json", outputs[0]), self.read("estimate.json", outputs[1]))
        convergence = self.read("search.csv", outputs[0])
        self.assertEqual(convergence, self.read("search.csv", outputs[1]))
        self.assertEqual([line.split(",")[:2] for line in convergence.splitlines()],
                         [["points", "runs"], ["5", "10"], ["7", "14"], ["9", "18"]])
        self.assertIn("0 runs in", self.calibrate(self.write(search), output=outputs[0]))
        self.assertEqual(convergence, self.read("search.csv", outputs[0]))

    def levels(self, extra=""):
        """A search over two levels of few grains."""
        text = (SLIDING + "min = 0.1\nmax = 0.7\n" + RESTITUTION + "min = 0.2\nmax = 0.8\n" + MASS + RATE +
                'discrepancy_share = 0.1\n[[level]]\nname = "small"\nset = ["particles.0.mass=0.02 g"]\nstart = 6\n'
                '[[level]]\nname = "large"\nranks_per_run = 2\n'
                '[adaptive]\nstart = 4\nbatch = 2\nbudget_core_hours = BUDGET\nhalf_width = 0.01\n')
        return self.write(text.replace("BUDGET", extra or "0.0027"))

    def levels_on_three_ranks(self):
        """The directory of that search, made once for all tests, which must leave it as it is."""
        if self.kept_levels is None:
            folder = tempfile.TemporaryDirectory()
            self.addClassCleanup(folder.cleanup)
            output = os.path.join(folder.name, "three")
            self.calibrate(self.levels(), ranks=3, output=output)
            type(self).kept_levels = output
        return self.kept_levels

    def test_a_search_over_levels_depends_on_nothing_but_its_runs(self):
        outputs = [self.path("one"), self.levels_on_three_ranks()]
        text = self.calibrate(self.levels(), ranks=1, output=outputs[0])
        for name in ("grid.csv", "estimate.json"):
            self.assertEqual(self.read(name, outputs[0]), self.read(name, outputs[1]))
        for part in ("level small ", "level large ", "large = ", "small alone: ", "without the discrepancy of the model: "):
            self.assertIn(part, text)
        rows = self.table(outputs[0])
        counts = {level: sum(r["level"] == level for r in rows) for level in ("small", "large")}
        self.assertGreater(len(rows), 20)  # the first design
        self.assertEqual(counts["small"] + counts["large"], len(rows))
        found = json.loads(self.read("estimate.json", outputs[0]))
        spent = sum(level["core_hours"] for level in found["levels"])
        self.assertLess(spent, 0.003)
        self.assertEqual([level["runs"] for level in found["levels"]], [counts["small"], counts["large"]])
        self.assertEqual(found["observables"][0]["links"][0]["below"], "small")
        self.assertIn("verdict", found["without_discrepancy"])
        ranks = {"small": set(), "large": set()}
        for row in rows:
            folder = os.path.join("runs", row["level"], f"sliding={row['sliding']},restitution={row['restitution']},"
                                  f"seed={row['seed']}")
            one, three = (json.loads(self.read(os.path.join(folder, "summary.json"), output)) for output in outputs)
            self.assertEqual(one["discharged_mass_kg"], float(row["discharged_mass_kg"]))
            self.assertIn("mass = 2e-05" if row["level"] == "small" else "mass = 3e-05", one["deck"])
            ranks[row["level"]].add(three["ranks"])
        self.assertEqual(ranks["large"], {3})
        self.assertIn(1, ranks["small"])  # 2 of the 3 ranks where a batch has no more than two
        says = self.program.call("info", os.path.join(outputs[0], "grid.h5"))
        self.assertEqual(says.returncode, 0, says.stderr)
        self.assertIn(f"small {counts['small']}", says.stdout)
        self.assertIn("0 runs in", self.calibrate(self.levels(), output=outputs[0]))
        self.draw(outputs[0])

    def test_a_level_with_too_few_runs_is_left_out_of_the_estimate(self):
        shutil.copytree(self.levels_on_three_ranks(), self.output)
        self.program.call("estimate", self.output)  # takes the runs in the order of their names, too
        whole = json.loads(self.read("estimate.json"))
        large = os.path.join(self.output, "runs", "large")
        points = sorted({name.rsplit(",seed=", 1)[0] for name in os.listdir(large)})
        for name in os.listdir(large):
            if name.rsplit(",seed=", 1)[0] not in points[:3]:
                shutil.rmtree(os.path.join(large, name))
        done = self.program.call("estimate", self.output)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("level large is left out: 3 points of it are done, a surface needs 4 or more\n"))
        self.assertNotIn("small alone", done.stdout)
        found = json.loads(self.read("estimate.json"))
        self.assertEqual([level["name"] for level in found["levels"]], ["small"])
        alone = whole["first_level_alone"]
        self.assertEqual({key: found[key] for key in ("verdict", "points", "parts", "surfaces")},
                         {key: alone[key] for key in ("verdict", "points", "parts", "surfaces")})
        self.assertIn("Left out of the estimate: large. Too few points of large are done", self.report(self.output))

    def test_keys_that_the_study_sets_itself_are_refused(self):
        """They would be set in vain."""
        sliding = "pair.0.sliding_friction=0.7"
        for key, message in ((sliding, f'study.toml:6: {sliding}: parameter "sliding" sets this key, too'),
                             ("run.seed=3", 'study.toml:6: run.seed=3: "seeds" and "first_seed" set this key, too')):
            self.refused(self.write(LINE + MASS, sets=[*REDUCED, key]), message)
        path = self.write(LINE + MASS)
        for override, setter in (("pair.carbohsp-carbohsp.sliding_friction=0.7", 'parameter "sliding"'),
                                 ("run . seed=3", '"seeds" and "first_seed"')):
            done = self.call("calibrate", path, "--set", override, env=REFUSED)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(f"repose: --set {override}: {setter} ", done.stderr)
        again = SLIDING.replace('"sliding"', '"again"').replace("pair.0.", "pair.carbohsp-carbohsp.") + "values = [0.2, 0.3]\n"
        self.refused(self.write(LINE + again + MASS + RATE), 'parameter "again" sets this key, too')

    def test_parameters_that_cannot_be_estimated_are_refused(self):
        def points(*values):
            return "".join(f"[[point]]\nvalues = {list(value)}\n" for value in values)
        ends = SLIDING + "min = 0.1\nmax = 0.8\n" + RESTITUTION + "min = 0.1\nmax = 0.9\n" + MASS + RATE
        message = 'parameter "restitution" is 0.5 at all points; to estimate it takes two values or more'
        self.refused(self.write(ends + points((0.1, 0.5), (0.3, 0.5), (0.5, 0.5), (0.7, 0.5))), message)
        one = RESTITUTION + "values = [0.5]\nmin = 0.1\nmax = 0.9\n"
        self.refused(self.write(LINE + one + MASS + RATE), message)
        self.refused(self.write(LINE.replace('"sliding"', '"level"') + MASS), '"level" is the name of another column of the tables')
        self.refused(self.write(LINE.replace('"sliding"', '"discharged_mass_kg"') + MASS), "is a figure's name, too")
        self.refused(self.write(LINE.replace('"sliding"', f'"{"s" * 220}"') + MASS), "shorten the names of the parameters")
        self.refused(self.write("first_seed = 9223372036854775807\n" + LINE + MASS), "first_seed")

    def test_a_figure_that_no_run_has_is_told_with_its_line(self):
        path = self.write(LINE + MASS.replace("discharged_mass_kg", "discharged_mass"))
        with open(path) as file:
            line = 1 + file.read().splitlines().index('figure = "discharged_mass"')
        self.refused(path, f'{path}:{line}: "discharged_mass" is no figure that runs have; did you mean "discharged_mass_kg"?')

    def test_wrong_levels_are_refused(self):
        def wrong(old, new, message):
            with open(self.levels()) as file:
                text = file.read()
            self.assertIn(old, text)
            with open(self.path("study.toml"), "w") as file:
                file.write(text.replace(old, new, 1))
            self.refused(self.path("study.toml"), message)
        wrong('name = "large"', 'name = "small"', '"small" names another level')
        wrong('name = "large"', 'name = "la/rge"', "la/rge")
        wrong('set = ["particles.0.mass=0.02 g"]\n', "", 'is the same model as level "small"')
        wrong("budget_core_hours = 0.0027\n", "", 'lacks "budget" or "budget_core_hours"')
        wrong("budget_core_hours = 0.0027", "budget = 9", '"start" of all levels = 10')
        wrong("discrepancy_share = 0.1", "discrepancy_share = 0.1\ndiscrepancy = 1e-6", "exclude each other")
        wrong("discrepancy_share = 0.1", "discrepancy_share = -0.1", "discrepancy_share")
        wrong("start = 6", "start = 3", "start")
        wrong("particles.0.mass=0.02 g", "particles.0.masss=0.02 g", "masss")
        listed = '[[point]]\nvalues = [0.3, 0.5]\nlevel = "large"\n[adaptive]'
        wrong("[adaptive]", listed.replace("large", "huge"), '"huge" is no [[level]] of the file')
        wrong("[adaptive]", listed.replace("0.5]", "0.9]"), "restitution = 0.9 is not from 0.2 to 0.8")
        wrong("[adaptive]", listed.replace("[adaptive]", listed.replace('level = "large"\n', "")), "this point stands here twice")
        wrong("[adaptive]\nstart = 4", listed + "\nbudget = 10\nstart = 4", '"start" of all levels and each [[point]] = 11')
        self.refused(self.write(SLIDING + "min = 0.1\nmax = 0.7\n" + MASS + '[[point]]\nvalues = [0.3]\nlevel = "large"\n'),
                     '"level" belongs to a search, which takes [adaptive]')

    def test_a_listed_point_is_run_at_its_level(self):
        with open(self.levels()) as file:
            text = file.read()
        with open(self.path("study.toml"), "w") as file:
            file.write(text + '[[point]]\nvalues = [0.3, 0.5]\nlevel = "large"\n')
        says = self.program.call("check", self.path("study.toml"))
        self.assertEqual(says.returncode, 0, says.stderr)
        self.assertIn("small: 12 at 6 points", says.stdout)
        self.assertIn("large: 10 at 5 points", says.stdout)

    def curve_of_runs(self, output, sliding, name="spin.csv", header="x,y,deviation"):
        """A laboratory's curve that is the mean of the runs at a friction, at times between their rows."""
        times = [0.0043 + 0.004 * k for k in range(13)]
        means = [0.0] * len(times)
        for seed in (1, 2):
            folder = os.path.join(output, "runs", f"sliding={sliding},seed={seed}")
            with open(os.path.join(folder, "summary.json")) as file:
                summary = json.load(file)
            begin = summary["phases"][0]["steps"] * summary["timestep_s"]
            with open(os.path.join(folder, "series.csv")) as file:
                rows = [(float(row["time_s"]) - begin, float(row["rotational_energy_J"])) for row in csv.DictReader(file)]
            for k, t in enumerate(times):
                after = next(i for i, row in enumerate(rows) if row[0] > t)
                (t0, y0), (t1, y1) = rows[after - 1], rows[after]
                means[k] += 0.5 * (y0 + (y1 - y0) * (t - t0) / (t1 - t0))
        with open(self.path(name), "w") as file:
            file.write(header + "\n" + "".join(f"{t:.17g},{y:.17g},1e-9\n" for t, y in zip(times, means)))

    def test_a_curve_against_itself(self):
        outputs = [self.path(name) for name in ("one", "three")]
        self.calibrate(self.write(LINE + MASS, sets=CLOSE_ROWS), output=outputs[0])
        self.curve_of_runs(outputs[0], 0.4)
        path = self.write(LINE + CURVE, sets=CLOSE_ROWS)
        says = self.calibrate(path, output=outputs[0])
        self.assertIn("0 runs in", says)
        self.assertRegex(says, "curve spin +13 points on [1-4] components?, which leave out")
        found = json.loads(self.read("estimate.json", outputs[0]))
        inside = [i for part in found["parts"] for i in part["intervals"] if i["lower"] <= 0.4 <= i["upper"]]
        self.assertTrue(inside, says)
        self.assertLess(found["curves"][0]["laboratory_rest"], 2.0)
        self.assertEqual([o["figure"] for o in found["observables"]],
                         [f"spin.{k + 1}" for k in range(len(found["curves"][0]["components"]))])
        # The mean of the scores of the runs is that of the laboratory.
        scores = [float(row["spin.1"]) for row in self.table(outputs[0]) if row["sliding"] == "0.4"]
        self.assertAlmostEqual(sum(scores) / 2, found["observables"][0]["laboratory"], delta=1e-6)
        self.assertIn("10 runs in", self.calibrate(path, ranks=3, output=outputs[1]))
        for name in ("grid.csv", "estimate.json"):
            self.assertEqual(self.read(name, outputs[1]), self.read(name, outputs[0]))
        done = self.program.call("info", os.path.join(outputs[0], "grid.h5"))
        self.assertIn("spin.1", done.stdout)
        os.remove(self.path("spin.csv"))  # the directory has its own
        done = self.program.call("estimate", outputs[0])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.read("estimate.json", outputs[0]), self.read("estimate.json", outputs[1]))
        self.draw(outputs[0])
        self.assertIn("laboratory off them", self.report(outputs[0]))

    def draw(self, output):
        """The pictures of a directory."""
        drawn = subprocess.run([os.path.join(self.program.source, "tools", "plot_calibration.py"), output],
                               capture_output=True, text=True)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)

    def report(self, output):
        """The page of a directory."""
        done = self.program.call("report", output, env={"REPOSE_PYTHON": sys.executable})
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.read("report.html", output)

    def test_an_estimate_takes_runs_of_one_deck_within_the_ranges(self):
        self.calibrate(self.write(LINE + MASS))
        narrow = self.write(SLIDING + "values = [0.1, 0.25, 0.4, 0.55]\n" + MASS)
        done = self.program.call("estimate", self.output, "--deck", narrow)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("runs beyond the ranges of the parameters are left out: 2\n8 runs: 8 done"),
                        done.stdout)
        deck = os.path.join(self.output, "runs", "sliding=0.4,seed=2", "deck.resolved.toml")
        with open(deck) as file:
            text = file.read()
        with open(deck, "w") as file:
            file.write(text.replace("mass = 3e-05", "mass = 4e-05"))
        done = self.program.call("estimate", self.output)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("sliding=0.1,seed=1 and sliding=0.4,seed=2 are of different decks: particles[0].mass: 3e-05 in the one, "
                      "4e-05 in the other", done.stderr)

    def test_defaults_that_follow_from_a_parameter_are_of_one_deck(self):
        diameter = '[[parameter]]\nname = "diameter"\nkey = "particles.0.diameter"\nmin = 4.2e-4\nmax = 5e-4\npoints = 4\n'
        self.calibrate(self.write(diameter + MASS, seeds=1))
        done = self.program.call("estimate", self.output)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_wrong_curves_are_refused(self):
        path = self.write(LINE + CURVE, sets=CLOSE_ROWS)

        def wrong(text, message, deck=path):
            with open(self.path("spin.csv"), "w") as file:
                file.write(text)
            self.refused(deck, message)
        done = self.call("calibrate", path)
        self.assertEqual(done.returncode, 4, done.stdout)
        self.assertIn("spin.csv: cannot open", done.stderr)
        wrong("t,y,deviation\n1,2,3\n2,2,3\n", 'spin.csv:1: the header line reads "t,y,deviation"; it must read x,y,deviation')
        wrong("x,y,deviation\n2,2,3\n1,2,3\n", "spin.csv:3: x = 1 is not above the 2 before; x must rise")
        good = "x,y,deviation\n0.01,2e-9,1e-9\n0.02,2e-9,1e-9\n"
        wrong(good, "laboratory", self.write(LINE + CURVE + "laboratory = 3\n"))
        wrong(good, "names a folder", self.write(LINE + CURVE.replace('"spin"', '"a/b"')))
        wrong(good, 'has no phase "drain", but settle, discharge',
              self.write(LINE + CURVE.replace('"discharge"', '"drain"'), sets=CLOSE_ROWS))
        wrong(good, "runs write no serie.csv; their tables are series.csv, walls.csv",
              self.write(LINE + CURVE.replace('"series.csv"', '"serie.csv"'), sets=CLOSE_ROWS))

    def test_curves_that_the_runs_do_not_have(self):
        """Said when the first of them is complete: what is run is kept."""
        def wrong(text, message, deck=CURVE):
            with open(self.path("spin.csv"), "w") as file:
                file.write("x,y,deviation\n" + text)
            done = self.call("calibrate", self.write(LINE + deck, sets=CLOSE_ROWS), env=REFUSED)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(message, done.stderr)
            self.assertEqual(len([line for line in done.stderr.splitlines() if line.startswith("repose:")]), 1, done.stderr)
        good = "0.01,2e-9,1e-9\n0.02,2e-9,1e-9\n"
        wrong("0.01,2e-9,1e-9\n0.2,2e-9,1e-9\n", "has x from 0.01 to 0.2, but time_s of ")
        wrong(good, 'did you mean "rotational_energy_J"?', CURVE.replace("rotational_energy_J", "rotation_energy_J"))
        wrong(good, "series.csv:", CURVE.replace('x = "time_s"', 'x = "discharged_mass_kg"'))
        with open(self.path("spin.csv"), "w") as file:
            file.write("x,y,deviation\n" + good)
        says = self.calibrate(self.write(LINE + CURVE, sets=CLOSE_ROWS))
        self.assertLess(int(re.search(r"(\d+) runs in", says)[1]), 10)  # of 10
        for message, curve in (('has no phase "drain", but settle, discharge', CURVE.replace('"discharge"', '"drain"')),
                               ("runs write no serie.csv; their tables are", CURVE.replace('"series.csv"', '"serie.csv"'))):
            done = self.program.call("estimate", self.output, "--deck", self.write(LINE + curve, sets=CLOSE_ROWS))
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(message, done.stderr)

    def test_several_tests_in_one_calibration(self):
        outputs = [self.path(name) for name in ("one", "three", "low", "high")]
        points = SLIDING + "values = [0.1, 0.3, 0.5, 0.7]\n"
        path = self.write(points + EXPERIMENTS)
        says = self.calibrate(path, ranks=1, output=outputs[0])
        self.assertIn("20 runs: 20 done", says)
        self.assertIn("laboratory high.retained_mass_kg", says)
        self.assertIn("low alone: ", says)
        self.assertIn("high alone: ", says)
        self.calibrate(path, ranks=3, output=outputs[1])
        for name in ("grid.csv", "estimate.json"):
            self.assertEqual(self.read(name, outputs[1]), self.read(name, outputs[0]))
        rows = self.table(outputs[0])
        self.assertEqual([r["experiment"] for r in rows], ["low"] * 8 + ["high"] * 12)
        for row in rows:
            self.assertEqual(row["low.discharged_mass_kg"] == "", row["experiment"] == "high")
            self.assertEqual(row["high.retained_mass_kg"] == "", row["experiment"] == "low")
        # Each test is what it is alone.
        self.calibrate(self.write(points + MASS.replace("8e-6", "7e-6").replace("repeats = 4\n", "")), output=outputs[2])
        alone = {(r["sliding"], r["seed"]): r["discharged_mass_kg"] for r in self.table(outputs[2])}
        self.assertEqual({(r["sliding"], r["seed"]): r["low.discharged_mass_kg"] for r in rows if r["experiment"] == "low"},
                         alone)
        self.calibrate(self.write(points + MASS + RATE, sets=[*REDUCED, "particles.0.mass=0.04 g"], seeds=3), output=outputs[3])
        own = json.loads(self.read("estimate.json", outputs[0]))["experiments_alone"]["low alone"]
        with open(os.path.join(outputs[2], "estimate.json")) as file:
            other = json.load(file)
        self.assertEqual((own["verdict"], own["parts"]), (other["verdict"], other["parts"]))
        self.assertEqual([r["high.retained_mass_kg"] for r in rows if r["experiment"] == "high"],
                         [r["retained_mass_kg"] for r in self.table(outputs[3])])
        self.assertIn("0 runs in", self.calibrate(self.write(points + EXPERIMENTS), output=outputs[0]))
        done = self.program.call("estimate", outputs[0])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.read("estimate.json", outputs[0]), self.read("estimate.json", outputs[1]))
        done = self.program.call("info", os.path.join(outputs[0], "grid.h5"))
        self.assertIn("low 8, high 12", done.stdout)
        self.draw(outputs[0])
        self.assertIn("high, sliding", self.report(outputs[0]))

    def test_a_search_by_several_tests_over_levels(self):
        text = (SLIDING + "min = 0.1\nmax = 0.7\n" + '[[level]]\nname = "soft"\n'
                'set = ["material.0.youngs_modulus=1 MPa", "material.1.youngs_modulus=1 MPa"]\n[[level]]\nname = "hard"\n' +
                EXPERIMENTS + '[[experiment.level]]\nname = "soft"\nset = ["particles.0.mass=0.03 g"]\n'
                "[adaptive]\nstart = 4\nbatch = 2\nbudget = 10\nhalf_width = 0.01\n")
        outputs = [self.path(name) for name in ("one", "three")]
        for ranks, output in zip((1, 3), outputs):
            self.calibrate(self.write(text), ranks=ranks, output=output)
        for name in ("grid.csv", "estimate.json", "search.csv"):
            self.assertEqual(self.read(name, outputs[0]), self.read(name, outputs[1]))
        rows = self.table(outputs[0])
        self.assertEqual({(r["experiment"], r["level"]) for r in rows},
                         {(e, l) for e in ("low", "high") for l in ("soft", "hard")})
        self.assertEqual(self.read("search.csv", outputs[0]).splitlines()[-1].split(",")[:2], ["10", "50"])

    def test_sensitivity(self):
        text = ('figures = ["discharged_mass_kg", "discharge_time_s"]\n[morris]\ntrajectories = 2\n' + SLIDING +
                "min = 0.1\nmax = 0.7\nfixed = 0.4\n" + RESTITUTION + "min = 0.2\nmax = 0.8\nfixed = 0.5\n")
        path = self.write(text)
        done = self.call("sensitivity", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(self.read("sensitivity.json"))
        mass = [e for e in result["one_at_a_time"] if e["figure"] == "discharged_mass_kg"]
        self.assertEqual([e["parameter"] for e in mass], ["sliding", "restitution"])
        rows = {(r["sliding"], r["restitution"], r["seed"]): float(r["discharged_mass_kg"]) for r in self.table()}
        lower = (rows["0.1", "0.5", "1"] + rows["0.1", "0.5", "2"]) / 2
        upper = (rows["0.7", "0.5", "1"] + rows["0.7", "0.5", "2"]) / 2
        self.assertNotEqual(upper, lower)
        self.assertAlmostEqual(mass[0]["effect"] / (upper - lower), 1.0, places=12)
        self.assertEqual({e["effects"] for e in result["morris"]}, {2.0})


def main():
    Calibrate.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)


main()
