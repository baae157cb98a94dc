"""Reports of the four kinds of directories: well-formed, whole in themselves, with the numbers of the files.

Usage: report_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from report_page import Page, check
from repose_runs import Program, SharedFolderTest
from study_decks import GRID, MASS, MORRIS, REDUCED, SEARCH, SLIDING, case_text, head

sys.dont_write_bytecode = True
MOST_BYTES = 5_000_000
# A pile, so that there are a silhouette and an angle; of soft grains, whose time step is three times as long.
PILED = ["particles.0.mass=0.3 g", "phase.settle.max_time=60 ms", "phase.settle.min_time=1 ms",
         "phase.discharge.max_time=200 ms",
         "phase.discharge.min_time=200 ms", "material.0.youngs_modulus=0.5 MPa", "material.1.youngs_modulus=0.5 MPa"]


class Report(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.base = cls.program.deck("discharge_quick.toml")

    def read(self, *names):
        with open(os.path.join(*names)) as file:
            return json.load(file)

    def text(self, path):
        with open(path, encoding="utf-8") as file:
            return file.read()

    def page(self, directory):
        """The report, after all that holds for each."""
        from repose import report
        path = report.write(directory, self.path("report.html"))
        self.assertLess(os.path.getsize(path), MOST_BYTES)
        page = Page(self.text(path))
        check(self, page)
        return page

    def test_a_run(self):
        output = self.path(self.id())
        summary = self.program.run(self.base, output, *PILED)
        page = self.page(output)
        self.assertIsNotNone(summary["angle_of_repose_deg"])
        expected = (summary["angle_of_repose_deg"], summary["angle_of_repose_stderr_deg"])
        self.assertIn(expected, page.titled("answer")["angle_of_repose_deg"])
        figures = page.titled("figures")
        for name in ("discharged_mass_kg", "retained_mass_kg", "pile_height_m", "discharge_rate_kg_s"):
            self.assertEqual(figures[name], [(summary[name], None)])
        for number in (1, 2, 3):
            area = summary["scattering"][f"area_{number}"]
            self.assertEqual(figures[f"scattering.area_{number}.count"], [(area["count"], area["error"])])
        pictures = [node.get("aria-label") for node in page.root.iter("svg")]
        self.assertEqual(pictures[:2], ["silhouette", "top view"])
        self.assertLessEqual({"energies", "forces on the walls", "discharged mass and its rate"}, set(pictures))
        circles = sum(node.tag == "circle" for node in page.section("pictures").iter())
        self.assertGreater(circles, summary["particles"]["inside"] // 4)
        for text in (summary["state_hash"], summary["build"]["commit"], summary["build"]["version"]):
            self.assertIn(text, page.words("repeat"))
        with open(os.path.join(output, "deck.resolved.toml")) as file:
            self.assertIn(" ".join(file.read().split()), page.words("repeat"))
        self.assertIn("ended by its max_time", page.words("warnings"))

    def test_a_run_that_is_not_complete(self):
        output = self.path(self.id())
        self.program.run(self.base, output, *REDUCED)
        os.remove(os.path.join(output, "summary.json"))
        page = self.page(output)
        progress = page.root.find(".//progress")
        self.assertGreater(float(progress.get("value")), 0.5)
        self.assertIn("Not complete", page.text)
        self.assertNotIn("figures", page.ids)
        self.assertIn("course", page.ids)

    def test_a_calibration(self):
        output = self.study("calibrate", head(self.base, "grains <&> \"piles\"") + GRID)
        estimate = self.read(output, "estimate.json")
        page = self.page(output)
        self.assertEqual(page.root.find(".//h1").text, 'grains <&> "piles"')
        found = page.titled("answer")
        for point in estimate["points"]:
            for k, name in enumerate(("sliding", "restitution")):
                self.assertIn((point["values"][k], point["standard_errors"][k]), found[name])
                interval = estimate["parts"][point["part"]]["intervals"][k]
                self.assertIn((interval["lower"], None), found["lower"])
        if not estimate["points"]:
            self.assertEqual([found[name][0][0] for name in ("sliding", "restitution")], estimate["nearest"]["values"])
        for observable in estimate["observables"]:
            self.assertIn((observable["laboratory"], observable["standard_error"]),
                          page.titled("asked")[observable["figure"]])
        marks = [node for node in page.section("surfaces").iter("a") if node.get("class") == "run"]
        self.assertGreaterEqual(len(marks), 6)
        from repose import Calibration
        grid = Calibration(output).grid
        mark = next(node for node in marks if node.get("href") == "#run-0")
        self.assertIn("sliding 0.1, restitution 0.2, seed 1", mark.find("title").text)
        self.assertIn("sliding 0.1, restitution 0.2, seed 2", mark.find("title").text)
        near = Calibration(output).nearest_runs[0]
        self.assertIn(f"#pile-{near}", [node.get("href") for node in page.section(f"run-{near}").iter("a")])
        values = page.values("runs")
        for figure in ("discharged_mass_kg", "retained_mass_kg"):
            self.assertLessEqual({v for v in grid[figure] if v == v}, set(values))
        self.assertEqual(page.root.find(".//section[@class='state']"), None)
        self.assertIn("seeds = 2", page.words("repeat"))
        self.assertIn("Phase discharge was ended by its max_time, not by its condition, in 12 of 12 runs", page.words("warnings"))

    def test_results_of_other_parameters_are_none_of_this_calibration(self):
        output = shutil.copytree(self.study("calibrate", head(self.base) + GRID), self.path("renamed"))
        path = os.path.join(output, "calibration.toml")
        text = self.text(path)
        with open(path, "w") as file:
            file.write(text.replace('name = "restitution"', 'name = "bounce"'))
        page = self.page(output)
        self.assertIn("There is no estimate yet", page.words("answer"))
        self.assertIn("Not one run is complete", page.text)

    def test_a_calibration_with_a_prior(self):
        prior = 'prior = "normal"\nprior_mean = 0.5\nprior_deviation = 0.05\n'
        output = self.study("calibrate", head(self.base) + GRID.replace("min = 0.2\n", "min = 0.2\n" + prior))
        marginals = self.read(output, "estimate.json")["posterior"]["marginals"]
        page = self.page(output)
        table = page.titled("posterior")
        for name, marginal in zip(("sliding", "restitution"), marginals):
            self.assertIn((marginal["mean"], marginal["deviation"]), table[name])
        self.assertIn("normal, 0.500 ± 0.050", page.words("posterior"))
        labels = [node.get("aria-label") for node in page.section("posterior").iter("svg")]
        self.assertEqual(labels, ["posterior"])

    def test_a_calibration_renews_its_report(self):
        """It is there from before the first run, is that of the end afterwards, and nothing else depends on it."""
        without = self.study("calibrate", head(self.base) + GRID)
        study, output, path = (self.path("renewed" + end) for end in (".toml", "", ".html"))
        with open(study, "w") as file:
            file.write(head(self.base) + GRID)
        env = {**os.environ, "REPOSE_PYTHON": sys.executable}
        command = [self.program.mpiexec, "-n", "2", self.program.executable, "calibrate", study, "--output", output,
                   "--quiet", "--report"]
        job = subprocess.Popen([*command, path], env=env, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while not os.path.exists(path) and job.poll() is None:
            time.sleep(0.05)
        first = Page(self.text(path))
        self.assertIsNone(job.poll(), "the runs were over before there was a report")
        check(self, first)
        self.assertIn("There is no estimate yet.", first.words("answer"))
        self.assertEqual(("", 0), (job.communicate()[1], job.returncode))
        self.program.call("report", output, env=env)
        self.assertEqual(*(re.sub("Made by.*?</footer>", "", self.text(name))
                           for name in (path, os.path.join(output, "report.html"))))
        self.assertFalse(os.path.exists(path + ".partial"))
        for name in ("grid.csv", "estimate.json"):
            self.assertTrue(filecmp.cmp(os.path.join(without, name), os.path.join(output, name), shallow=False), name)
        command[-3:] = [self.path("refused"), "--report", self.path("absent", "x.html")]
        failed = subprocess.run(command, env=env, capture_output=True, text=True)
        self.assertEqual(failed.returncode, 4)
        self.assertRegex(failed.stderr, "repose: .*x.html: cannot be written")
        self.assertFalse(os.path.exists(self.path("refused", "runs")))

    def test_a_calibration_that_goes_on(self):
        output = self.study("calibrate", head(self.base) + GRID)
        os.remove(os.path.join(output, "estimate.json"))
        path = os.path.join(output, "grid.csv")
        with open(path) as file:
            names, first, second, third, *rest = file.read().splitlines()
        parameters = ",".join(first.split(",")[:3])
        failed = f'{parameters},failed,,,"step 8: <b>too deep</b>, & more"'
        waiting = ",".join(third.split(",")[:3]) + ",waiting,,,"
        with open(path, "w") as file:
            file.write("\n".join([names, failed, second.replace(",done,", ",plugged,"), waiting, *rest]) + "\n")
        page = self.page(output)
        self.assertIn(f"Not complete: {len(rest) + 2} of {len(rest) + 3} runs have ended", page.text)
        self.assertIn("Run 1 failed: step 8: <b>too deep</b>, & more", page.words("warnings"))
        self.assertIn("run-0", [node.get("href", "")[1:] for node in page.section("warnings").iter("a")])
        self.assertIn("runs plugged: ", page.words("warnings"))
        self.assertIn("There is no estimate yet.", page.words("answer"))
        self.assertNotIn("surfaces", page.ids)

    def test_a_study_of_very_many_runs(self):
        """The table has all of them; boxes, which cost most, stand for those that matter most."""
        from repose.report import study
        before, study.MOST_BOXES = study.MOST_BOXES, 4
        self.addCleanup(setattr, study, "MOST_BOXES", before)
        page = self.page(self.study("calibrate", head(self.base) + GRID))
        boxes = [name for name in page.ids if name.startswith("run-")]
        self.assertEqual(len(boxes), 4)
        from repose import Calibration
        nearest = Calibration(self.path(self.id())).nearest_runs[:4]
        self.assertEqual(set(boxes), {f"run-{row}" for row in nearest})
        self.assertEqual(len(page.section("runs").findall(".//tbody/tr")), 12)
        marks = [node for node in page.section("surfaces").iter("a") if node.get("class") == "run"]
        self.assertEqual({node.get("href") is None for node in marks}, {True, False})

    def test_a_calibration_of_one_parameter(self):
        page = self.page(self.study("calibrate", head(self.base) + SLIDING + "values = [0.1, 0.2, 0.3, 0.4]\n" + MASS +
                                    "discrepancy_share = 0.1\n"))
        self.assertIn("without the discrepancy of the model", page.words("others"))
        pictures = [node.get("aria-label") for node in page.section("surfaces").iter("svg")]
        self.assertEqual(pictures, ["discharged_mass_kg over sliding"])
        self.assertEqual(sum(node.get("class") == "run" for node in page.section("surfaces").iter("a")), 8)

    def test_a_search_over_levels(self):
        output = self.study("calibrate", head(self.base) + SEARCH)
        estimate, page = self.read(output, "estimate.json"), self.page(output)
        values = page.values("levels")
        for level in estimate["levels"]:
            self.assertIn(level["core_hours"], values)
        for observable in estimate["observables"]:
            for link in observable["links"]:
                self.assertIn((link["rho"], link["rho_standard_error"]), page.titled("levels")["rho"])
                self.assertIn(link["scatter_from"], page.words("levels"))
        self.assertIn("small alone", page.words("others"))
        self.assertIn("without the discrepancy", page.words("others"))
        from repose import Calibration
        search = Calibration(output).search
        self.assertLessEqual({v for v in search["half_width"] if v == v} | set(search["core_hours"]),
                             set(page.values("search")))
        self.assertIn("convergence of the search",
                      [node.get("aria-label") for node in page.section("search").iter("svg")])

    def test_a_sensitivity_study(self):
        output = self.study("sensitivity", head(self.base) + MORRIS)
        result, page = self.read(output, "sensitivity.json"), self.page(output)
        found = page.titled("effects")["discharged_mass_kg"]
        for e in result["one_at_a_time"]:
            self.assertIn((e["effect"], e["standard_error"]), found)
            self.assertIn((e["lower"]["mean"], e["lower"]["deviation"]), found)
        for e in result["morris"]:
            self.assertIn((e["mu_star"], e["mu_star_error"]), found)
        self.assertIn("boxes", page.ids)
        self.assertNotIn("With one seed", page.words("answer"))

    def test_a_sensitivity_study_of_one_seed(self):
        output = self.study("sensitivity", head(self.base).replace("seeds = 2", "seeds = 1") + MORRIS)
        result, page = self.read(output, "sensitivity.json"), self.page(output)
        for e in result["one_at_a_time"]:
            self.assertIsNone(e["standard_error"])
            self.assertIn(e["effect"], page.values("answer"))
        self.assertIn("With one seed an effect has no standard error", page.words("answer"))

    def test_a_validation(self):
        text = 'title = "two cases"\npublished = "theirs"\n' + "".join(
            case_text(name, self.base, [*PILED, f"run.seed={seed}"])
            for name, seed in (("one", 1), ("two", 2)))
        output = self.study("validate", text, ranks=0)
        result, page = self.read(output, "validation.json"), self.page(output)
        found = page.titled("answer")
        for case in result["cases"]:
            self.assertIn(case["state_hash"], page.words("repeat"))
            for c in case["comparisons"]:
                self.assertIn((c["laboratory"], c["deviation"]), found[c["figure"]])
                if c["here"] is not None:
                    self.assertIn((c["here"], c["error"]), found[c["figure"]])
        mass = result["cases"][0]["comparisons"][0]
        self.assertIn(100.0 * (mass["here"] / mass["laboratory"] - 1.0), page.values("answer"))
        three = os.path.join(output, "three")
        os.mkdir(three)
        shutil.copy(os.path.join(output, "one", "deck.resolved.toml"), three)
        self.assertIn("that of an earlier call; not in it are three", self.page(output).text)
        shutil.rmtree(three)
        os.remove(os.path.join(output, "validation.json"))
        self.assertIn("2 of 2 cases that have begun are done", self.page(output).text)

    def test_numbers_have_no_more_digits_than_their_error(self):
        from repose.report import numbers
        for value, error, text in ((22.124865, 0.7423, "22.12 ± 0.74"), (0.40641, 0.0427, "0.406 ± 0.043"),
                                   (86, 9.27, "86.0 ± 9.3"), (1234.5, 156.0, "1230 ± 160"),
                                   (0.0999, 0.0996, "0.10 ± 0.10"), (-3.2e-9, 4.1e-10, "(-3.20 ± 0.41) · 10⁻⁹"),
                                   (21.9, 3e-6, "21.9000"), (1.6e-4, 3e-20, "0.000160000"), (5.0, None, "5"), (0.27371, 0.0, "0.2737"), (None, 1.0, "none"),
                                   (float("nan"), None, "none"),
                                   (6.455e-6, None, "6.455 · 10⁻⁶")):
            self.assertEqual(numbers.with_error(value, error), text)
        for value, error, text in ((7e-14, 3e-14, ">7.0 · 10⁻¹⁴<"), (-1.7e-13, 3e-14, ">−1.70 · 10⁻¹³<"),
                                   (0.40641, 0.0427, ">0.406<"), (6.455e-6, None, ">6.455 · 10⁻⁶<"), (None, 1.0, ">none<")):
            self.assertIn(text, numbers.beside("rolling", value, error))
        from repose.units import prefixed
        self.assertEqual([prefixed(value, "N") for value in (5000.0, 20.0, 0.02)], [(1e-3, "kN"), (1.0, "N"), (1e3, "mN")])
        self.assertIn('value="0.000271"', numbers.figure("discharged_mass_kg", 0.000271))
        self.assertIn(">0.2710 g<", numbers.figure("discharged_mass_kg", 0.000271))

    def test_the_command(self):
        output, path = self.path(self.id()), self.path("by_command.html")
        self.program.run(self.base, output, *REDUCED)
        env = {"REPOSE_PYTHON": sys.executable}
        done = self.program.call("report", output, "--output", path, env=env)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, path + "\n", ""))
        done = self.program.call("report", output, env=env, ranks=2)  # once, by rank 0
        self.assertEqual((done.returncode, done.stdout), (0, os.path.join(output, "report.html") + "\n"), done.stderr)
        texts = []
        for name in (path, os.path.join(output, "report.html")):
            texts.append(re.sub(r"Made by.*?</footer>", "", self.text(name)))
        self.assertEqual(texts[0], texts[1])
        bare = self.path("bare_python")
        with open(bare, "w") as file:
            file.write(f'#!/bin/sh\nexec {sys.executable} -S "$@"\n')
        os.chmod(bare, 0o755)
        lonely = self.path("lonely")
        shutil.copy(self.program.executable, lonely)
        for program, python, arguments, code, message in (
                (self.program.executable, sys.executable, [self.folder + "/absent"], 4, "absent: is no directory"),
                (self.program.executable, bare, [output], 4, "report needs the Python module numpy; install it"),
                (self.program.executable, self.path("nopython"), [output], 4,
                 "nopython cannot be started; install python3"),
                (self.program.executable, sys.executable, [output, "--output", self.path("none/x.html")], 4,
                 "x.html: cannot be written"),
                (self.program.executable, sys.executable, [], 2, "DIR is required"),
                (lonely, sys.executable, [output], 4, "the Python package is not beside it")):
            done = subprocess.run([program, "report", *arguments], capture_output=True, text=True,
                                  env={**os.environ, "REPOSE_PYTHON": python})
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertRegex(done.stderr, f"^repose: .*{message}.*\n$")

    def test_what_cannot_be_reported_is_one_line(self):
        from repose import report
        script = os.path.join(os.path.dirname(report.__file__), "..", "..", "repose_report.py")
        for arguments, message in (([self.folder + "/absent"], "absent: is no directory"),
                                   ([tempfile.mkdtemp()], "holds no run")):
            done = subprocess.run([sys.executable, script, *arguments], capture_output=True, text=True)
            self.assertEqual(done.returncode, 4)
            self.assertRegex(done.stderr, f"^repose: .*{message}.*\n$")
        done = subprocess.run([sys.executable, "-S", script, self.folder], capture_output=True, text=True,
                              env={"PATH": "/usr/bin"})
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, "^repose: report needs the Python module numpy; .*\n$")


if __name__ == "__main__":
    Report.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
