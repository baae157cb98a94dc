"""The Python package: what it reads is what stands in the files, what it runs is the program's run, what fails is one
line.

Usage: python_package_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

from repose_runs import Program, SharedFolderTest, read_series
from study_decks import GRID, MORRIS, REDUCED, SEARCH, case_text, head

sys.dont_write_bytecode = True


class Package(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        global repose
        import repose
        overrides = dict(text.split("=", 1) for text in REDUCED)
        overrides |= {"output.snapshot_interval": 0.01, "run.seed": 3,
                      "wall.vessel.points": [[0.004, 0.04], [0.004, 0.0], [0.00175, 0.0]]}
        cls.run_folder = cls.path("run")
        cls.run_ = repose.run(cls.deck("discharge_quick.toml"), cls.run_folder, set=overrides, ranks=2,
                              program=cls.program.executable, mpirun=cls.program.mpiexec)

    @classmethod
    def deck(cls, name):
        return cls.program.deck(name)

    def raises(self, pattern, function, *arguments, **named):
        with self.assertRaisesRegex(repose.ReposeError, pattern) as caught:
            function(*arguments, **named)
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception

    def test_run_starts_the_program(self):
        with open(os.path.join(self.run_folder, "summary.json")) as file:
            summary = json.load(file)
        self.assertEqual(self.run_.summary, summary)
        self.assertEqual(summary["ranks"], 2)
        self.assertEqual(self.run_.deck["run"]["seed"], 3)
        self.assertEqual(self.run_.deck["particles"][0]["mass"], 0.03e-3)
        again = repose.run(os.path.join(self.run_folder, "deck.resolved.toml"), self.run_folder, restart=True,
                           program=self.program.executable)  # complete: taken as it is
        self.assertEqual(again.summary["wall_seconds"], summary["wall_seconds"])
        self.assertEqual(again.summary["state_hash"], summary["state_hash"])

    def test_what_fails_is_the_programs_line(self):
        error = self.raises('^--set run.sed=1: .*"sed"', repose.run, self.deck("discharge_quick.toml"),
                            self.path("none"),
                            set={"run.sed": 1}, program=self.program.executable)
        self.assertEqual(error.code, 2)
        error = self.raises("absent.toml: cannot open", repose.run, "absent.toml", self.path("none"), ranks=2,
                            program=self.program.executable, mpirun=self.program.mpiexec)
        self.assertEqual(error.code, 4)
        self.raises("cannot be started", repose.run, "a.toml", self.path("none"), program=self.path("nobody"))

    def test_a_warning_is_not_what_fails(self):
        killed = self.path("killed")
        with open(killed, "w") as file:
            file.write("#!/bin/sh\necho 'repose: warning: the time step is long' >&2\nexit 137\n")
        os.chmod(killed, 0o755)
        error = self.raises("^ended with exit code 137$", repose.run, "a.toml", self.path("none"), program=killed)
        self.assertEqual(error.code, 137)

    def test_what_mpirun_says_is_what_fails(self):
        crowded = self.path("mpirun")
        with open(crowded, "w") as file:
            file.write("#!/bin/sh\ncat >&2 <<END\n" + "-" * 70 + "\nThere are not enough slots for the 9\nthat were asked for:\n\n"
                       "  repose\n" + "-" * 70 + "\nEND\nexit 1\n")
        os.chmod(crowded, 0o755)
        self.raises("^There are not enough slots for the 9 that were asked for:$", repose.run, "a.toml", self.path("none"), ranks=9,
                    program=self.program.executable, mpirun=crowded)

    def test_the_program_is_found(self):
        before = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
        os.environ["REPOSE"] = "/named"
        self.assertEqual(repose.find_program(), "/named")
        del os.environ["REPOSE"]
        os.environ["PATH"] = os.path.dirname(self.program.executable)
        self.assertTrue(os.access(repose.find_program(), os.X_OK))

    def test_figures(self):
        summary = self.run_.summary
        self.assertEqual(self.run_.figure("discharged_mass_kg"), summary["discharged_mass_kg"])
        self.assertEqual(self.run_.figures["retained_mass_kg"], summary["retained_mass_kg"])
        self.assertNotIn("ranks", self.run_.figures)
        self.assertIsNone(self.run_.figure("tilt_onset_deg"))
        self.assertEqual(self.run_.is_plugged, summary["plugged"])
        self.raises('figure "discharged": summary.json has no such key', self.run_.figure, "discharged")
        self.raises("is not one number", self.run_.figure, "phases")
        quick = repose.Run(self.run_folder)
        quick.summary = {"angle_of_repose_stderr_deg": 0.5, "scattering": {"area_1": {"count": 4, "error": 2.0}}}
        self.assertEqual(quick.error("angle_of_repose_deg"), 0.5)
        self.assertEqual(quick.error("scattering.area_1.count"), 2.0)
        self.assertIsNone(quick.error("discharged_mass_kg"))

    def test_series_and_walls(self):
        rows = read_series(self.run_folder)
        series = self.run_.series
        self.assertEqual(list(series), list(rows[0]))
        self.assertEqual(series.rows, len(rows))
        for name, values in series.items():
            self.assertEqual(values.tolist(), [row[name] for row in rows])
        self.assertEqual(series.row(-1), rows[-1])
        self.assertEqual(len(self.run_.walls["lid_force_z_N"]), len(rows))
        self.assertIsNone(self.run_.trace)
        self.assertIsNone(self.run_.surface_angle)
        self.assertIsNone(self.run_.flow_energy)

    def test_a_file_that_grows(self):
        begun = self.path("begun")
        os.mkdir(begun)
        with open(os.path.join(self.run_folder, "deck.resolved.toml")) as source:
            deck = source.read()
        with open(os.path.join(self.run_folder, "series.csv")) as source:
            lines = source.read().splitlines()
        with open(os.path.join(begun, "deck.resolved.toml"), "w") as file:
            file.write(deck)
        run = repose.Run(begun)
        for written in (lines[3][:9], lines[3][:-1]):
            with open(os.path.join(begun, "series.csv"), "w") as file:
                file.write("\n".join(lines[:3]) + "\n" + written)
            self.assertEqual(run.series.rows, 2)
        self.assertFalse(run.is_complete)
        self.raises("has no summary.json: the run is not complete", lambda: run.summary)
        progress = run.progress
        self.assertEqual(progress["phase"], "settle")
        self.assertAlmostEqual(progress["most_time_s"], 0.015 + 0.06)
        with open(os.path.join(begun, "series.csv"), "w") as file:
            file.write("\n".join([lines[0], lines[1][:5], lines[2]]) + "\n")
        self.raises("series.csv: is damaged", lambda: run.series)

    def test_snapshots(self):
        snapshots = self.run_.snapshots
        self.assertGreater(len(snapshots), 3)
        self.assertEqual(sorted(s.time_s for s in snapshots), [s.time_s for s in snapshots])
        last = snapshots[-1]
        with h5py.File(last.path) as file:
            for name in ("id", "position", "velocity", "angular_velocity", "radius", "mass", "material"):
                expected = file["particles"][name][...]
                for found in (getattr(last, name), last[name]):
                    self.assertEqual(found.dtype, expected.dtype)
                    self.assertTrue(np.array_equal(found, expected))
            self.assertEqual(last.deck_text, file.attrs["deck"])
        self.assertEqual((len(last), last.step), (self.run_.summary["particles"]["inside"], self.run_.summary["steps"]))
        self.assertEqual(last.state_hash, self.run_.summary["state_hash"])
        self.assertEqual(last.inserted, last.left + len(last))
        self.assertEqual(last.build["commit"], self.run_.summary["build"]["commit"])
        self.assertEqual(last.deck, self.run_.deck)
        self.assertEqual(set(last.material_names), {"carbohsp"})
        self.assertEqual(self.run_.snapshot(0.011).time_s,
                         min((s.time_s for s in snapshots), key=lambda t: abs(t - 0.011)))
        self.raises('has no array "colour"', lambda: last["colour"])
        self.raises("cannot be read", repose.Snapshot, self.path("absent.hdf"))

    def test_contacts_of_a_checkpoint(self):
        output = self.path("stopped")
        with self.assertRaises(repose.ReposeError) as caught:
            repose.run(self.deck("discharge_quick.toml"), output, set={"particles.0.mass": "0.2 g"},
                       options=("--time-limit", "00:00:02"), program=self.program.executable)
        self.assertEqual(caught.exception.code, 75)
        contacts = repose.Run(output).checkpoint_contacts
        self.raises("the deck has no output.contacts", repose.Run(output).contacts)
        with h5py.File(next(os.path.join(output, n) for n in os.listdir(output) if n.startswith("checkpoint"))) as file:
            ids, counts = file["particles/id"][...], file["particles/pair_contacts"][...]
            self.assertEqual(len(contacts.wall), len(file["wall_contacts/wall"]))
        self.assertEqual(2 * len(contacts.pairs), counts.sum())
        self.assertTrue((contacts.pairs[:, 0] < contacts.pairs[:, 1]).all())
        self.assertEqual(dict(zip(contacts.ids.tolist(), contacts.coordination().tolist())),
                         dict(zip(ids.tolist(), counts.tolist())))
        self.assertEqual(contacts.spring.shape, (len(contacts.pairs), 3))
        self.assertIsNone(self.run_.checkpoint_contacts)
        self.assertIsNone(self.run_.picture("top_view", "pdf"))

    def test_calibrate_and_validate(self):
        """As run, but for what they return."""
        for start, name in ((repose.calibrate, "a calibration"), (repose.validate, "a validation")):
            error = self.raises("absent.toml: cannot open", start, "absent.toml", self.path("none"), set=["run.seed=2"],
                                program=self.program.executable)
            self.assertEqual(error.code, 4, name)

    def test_plots_of_a_run(self):
        plots = repose.plots
        for draw in (plots.discharge, plots.energies, plots.walls):
            figure = draw(self.run_)
            self.assertGreater(len(figure.axes[0].lines), 0, draw.__name__)
        curve = plots.discharge(self.run_).axes[0].lines[0]
        self.assertTrue(np.array_equal(curve.get_xdata(), self.run_.series["time_s"]))
        drawn, mass = curve.get_ydata(), self.run_.series["discharged_mass_kg"]
        self.assertTrue(np.allclose(drawn / drawn.max(), mass / mass.max()))
        snapshot = self.run_.snapshots[-1]
        speed = np.linalg.norm(snapshot.velocity, axis=1)
        shown = plots.speeds(snapshot).axes[0].collections[0]
        factor = shown.get_clim()[1] / np.percentile(speed, 99.0)
        self.assertIn(round(math.log10(factor), 9), (0, 3, 6, 9))
        self.assertAlmostEqual(shown.get_array().max() / (factor * speed.max()), 1.0, places=12)

    def test_the_example_draws_a_figure(self):
        picture = self.path("example.png")
        done = subprocess.run([os.path.join(self.program.source, "tools", "python", "example.py"), self.run_folder,
                               self.run_folder, "--output", picture], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(os.path.getsize(picture), 5000)

    def test_a_calibration(self):
        output = self.study("calibrate", head(self.deck("discharge_quick.toml")) + GRID)
        calibration = repose.open(output)
        self.assertIsInstance(calibration, repose.Calibration)
        with open(os.path.join(output, "grid.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(calibration.grid.rows, len(rows))
        self.assertEqual(calibration.grid["sliding"].tolist(), [float(r["sliding"]) for r in rows])
        self.assertEqual(calibration.grid["state"].tolist(), [r["state"] for r in rows])
        self.assertEqual(calibration.states["done"], sum(r["state"] == "done" for r in rows))
        for run, row in zip(calibration.runs, rows):
            self.assertEqual(run.figure("discharged_mass_kg"), float(row["discharged_mass_kg"]))
            self.assertEqual(run.deck["run"]["seed"], int(row["seed"]))
        with open(os.path.join(output, "estimate.json")) as file:
            estimate = json.load(file)
        self.assertEqual(calibration.estimate, estimate)
        self.assertEqual(list(calibration.values), ["sliding", "restitution"])
        point = (estimate["points"] or [estimate["nearest"]])[0]["values"]
        self.assertEqual(list(calibration.values.values()), point)
        surfaces = calibration.surfaces
        self.assertEqual(surfaces.misfit.tolist(), estimate["surfaces"]["misfit"])
        self.assertEqual(surfaces.mean["retained_mass_kg"].shape, (len(surfaces.y), len(surfaces.x)))
        self.assertEqual(calibration.figures, ["discharged_mass_kg", "retained_mass_kg"])
        nearest = calibration.nearest_runs
        off = [abs(calibration.grid["sliding"][k] - point[0]) / 0.3 +
               abs(calibration.grid["restitution"][k] - point[1]) / 0.6
               for k in (nearest[0], nearest[-1])]
        self.assertEqual(len(nearest), calibration.states["done"])
        self.assertLess(off[0], off[1])
        self.assertEqual((calibration.levels, calibration.first_level_surfaces), ([], None))
        self.assertIsNone(calibration.search)
        marks = {line.get_gid() for axes in repose.plots.calibration(calibration).axes for line in axes.lines}
        self.assertLessEqual({f"run-{row}-{row + 1}" for row in range(0, len(rows), 2)}, marks)
        os.mkdir(os.path.join(output, "calibration.png"))  # in the way of the picture
        drawn = subprocess.run([os.path.join(self.program.source, "tools", "plot_calibration.py"), output],
                               capture_output=True, text=True)
        self.assertEqual(drawn.returncode, 1)
        self.assertRegex(drawn.stderr, "^plot_calibration.py: .*calibration.png.*\n$")
        os.remove(os.path.join(output, "estimate.json"))
        self.raises("has no estimate.json", lambda: repose.Calibration(output).estimate)

    def test_a_search_over_levels(self):
        output = self.study("calibrate", head(self.deck("discharge_quick.toml")) + SEARCH)
        calibration = repose.Calibration(output)
        self.assertEqual(calibration.levels, ["small", "large"])
        self.assertEqual(len(calibration.first_level_surfaces.x), len(calibration.surfaces.x))
        search = calibration.search
        self.assertEqual(search["runs"][-1], calibration.grid.rows)
        self.assertAlmostEqual(search["core_hours"][-1],
                               sum(level["core_hours"] for level in calibration.estimate["levels"]), 12)
        last, half_width = search["half_width"][-1], calibration.estimate["half_width"]
        self.assertTrue(last == half_width or (half_width is None and last != last), (last, half_width))
        self.assertGreater(len(repose.plots.search(calibration).axes[0].lines[0].get_xdata()), 1)
        for folder, level in zip(calibration.folders, calibration.grid["level"]):
            self.assertEqual(repose.Run(folder).deck["particles"][0]["mass"], {"small": 2e-5, "large": 3e-5}[level])
        self.assertTrue(all(calibration.grid["level"][row] == "large" for row in calibration.nearest_runs))

    def test_a_sensitivity_study(self):
        study = repose.open(self.study("sensitivity", head(self.deck("discharge_quick.toml")) + MORRIS))
        self.assertIsInstance(study, repose.Sensitivity)
        effects, grid = study.effects("discharged_mass_kg"), study.grid
        self.assertEqual(list(effects), study.parameters)
        upper = (grid["sliding"] == 0.7) & (grid["restitution"] == 0.5)
        self.assertAlmostEqual(effects["sliding"]["upper"]["mean"] / grid["discharged_mass_kg"][upper].mean(), 1.0,
                               places=12)
        with open(os.path.join(study.directory, "sensitivity.json")) as file:
            walks = {e["parameter"]: e for e in json.load(file)["morris"]}
        self.assertEqual(study.morris("discharged_mass_kg"), walks)
        self.assertEqual(study.figures, ["discharged_mass_kg"])
        bars = repose.plots.effects(study).axes[0].patches
        self.assertEqual([bar.get_width() for bar in bars], [1e3 * e["effect"] for e in effects.values()])

    def test_a_validation(self):
        text = 'title = "two cases"\npublished = "theirs"\n' + "".join(
            case_text(name, self.deck("discharge_quick.toml"), [*REDUCED, f"run.seed={seed}"])
            for name, seed in (("one", 1), ("two", 2)))
        validation = repose.open(self.study("validate", text, ranks=0))
        self.assertIsInstance(validation, repose.Validation)
        self.assertEqual(list(validation.cases), ["one", "two"])
        for name, run in validation.runs.items():
            self.assertEqual(validation.cases[name][0]["here"], run.figure("discharged_mass_kg"))
        self.assertEqual(validation.title, "two cases")
        os.remove(self.path(self.id(), "validation.json"))
        begun = repose.open(self.path(self.id()))
        self.assertEqual(list(begun.runs), ["one", "two"])
        self.raises("the cases are not complete", lambda: begun.cases)

    def test_a_directory_that_is_none_of_them(self):
        self.raises("holds no run", repose.open, tempfile.mkdtemp(dir=self.folder))
        self.raises("is no directory$", repose.open, self.path("absent"))
        for kind in (repose.Run, repose.Calibration, repose.Sensitivity, repose.Validation):
            self.raises("is no directory of ", kind, tempfile.mkdtemp(dir=self.folder))

    def test_flow_properties_of_a_yield_locus(self):
        from repose.shear import flow_properties
        slope, cohesion = math.radians(30.0), 800.0
        centre = 9000.0
        radius = cohesion * math.cos(slope) + centre * math.sin(slope)  # of Mohr's circle that touches the locus
        points = [(x, cohesion + x * math.tan(slope)) for x in (2000.0, 3500.0, 5000.0)]
        beyond = math.radians(85.0)  # it touches at 120 degrees from the axis of normal stresses
        found = flow_properties(points, (centre + radius * math.cos(beyond), radius * math.sin(beyond)))
        for key, value in {"internal_friction_deg": 30.0, "cohesion_Pa": cohesion,
                           "unconfined_yield_strength_Pa": 2.0 * cohesion * math.sqrt(3.0),
                           "major_consolidation_stress_Pa": centre + radius,
                           "effective_internal_friction_deg": math.degrees(math.asin(radius / centre)),
                           "flowability": (centre + radius) / (2.0 * cohesion * math.sqrt(3.0))}.items():
            self.assertAlmostEqual(found[key] / value, 1.0, places=10, msg=key)
        dry = flow_properties([(x, 0.5 * x) for x in (1.0, 2.0, 3.0)], (4.0, 2.0))  # the circle touches at this point
        self.assertAlmostEqual(dry["cohesion_Pa"], 0.0, places=12)
        self.assertAlmostEqual(dry["effective_internal_friction_deg"], dry["internal_friction_deg"], places=5)

    def test_pandas_is_asked_for_by_frame_alone(self):
        code = ("import sys, repose\n"
                "assert not {'pandas', 'matplotlib', 'h5py'} & set(sys.modules), 'imported too early'")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": os.path.join(self.program.source, "tools", "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        try:
            import pandas
        except ImportError:
            self.assertRaises(ImportError, self.run_.series.frame)
            return
        frame = self.run_.series.frame()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(frame["time_s"].tolist(), self.run_.series["time_s"].tolist())


if __name__ == "__main__":
    Package.program = Program(*(os.path.abspath(a) if os.path.exists(a) else a for a in sys.argv[1:4]))
    unittest.main(argv=sys.argv[:1], verbosity=2)
