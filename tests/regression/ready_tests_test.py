"""repose new: the ready tests, as they are and for other grains. Each is the deck of input/ when nothing is asked for, passes
`repose check` for grains and sizes of all kinds, runs, and gives its figures in a reduced size.

Usage: ready_tests_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import math
import os
import re
import sys
import tomllib
import unittest

import h5py
import numpy as np

from repose_runs import FolderTest, Program

GRAINS = [
    (),
    ("--diameter", "120 um", "--density", "7.8 g/cm3"),
    ("--diameter", "25 mm", "--density", "900", "--youngs-modulus", "20 MPa"),
    ("--diameter", "0.003", "--grains", "1000", "--sliding-friction", "0.7"),
    ("--grains", "50000", "--restitution", "0.2", "--rolling-friction", "0"),
]


def short(deck):
    """Overrides that make each phase a few steps long, but those after which a wall appears where grains would still be."""
    sets = []
    for phase, following in zip(deck["phase"], [*deck["phase"][1:], {}]):
        name = phase["name"]
        if following.get("add_walls"):
            continue
        sets += [f"phase.{name}.time=1 ms"] if phase["until"] == "time" else [f"phase.{name}.max_time=1 ms"]
        sets += [f"phase.{name}.min_time=0"] if "min_time" in phase else []
    return sets


# Of the decks as they are, docs/laboratory-tests.md. Heaps of 1200 grains are five grains high and scatter by some degrees;
# the bed that stays in a vessel of so few has a slope of three rings.
FIGURES = {
    "lifted_cylinder": {"angle_of_repose_deg": (19.6, 5.0)},
    "lifted_cylinder_disc": {"angle_of_repose_deg": (33.5, 6.0)},
    "granuheap": {"angle_of_repose_deg": (27.7, 6.0)},
    "draw_down": {"angle_of_repose_deg": (30.3, 6.0), "retained_slope_deg": (35.9, 10.0)},
    "ledge": {"surface_angle_deg": (31.7, 5.0)},
    "tilting_box": {"static_angle_of_repose_deg": (37.7, 6.0), "slope_after_avalanche_deg": (30.8, 5.0)},
    "powder_rheometer": {"specific_flow_energy_J_kg": (1.27, 0.5)},  # more in a vessel that is narrow for its grains
}


class ReadyTests(FolderTest):
    @classmethod
    def setUpClass(cls):
        done = cls.program.call("new")
        assert done.returncode == 0, done.stderr
        cls.titles = dict(line.split(maxsplit=1) for line in done.stdout.splitlines())

    def new(self, test, *options):
        """The path of the deck."""
        path = self.path(f"{test}{len(os.listdir(self.folder))}.toml")
        done = self.program.call("new", test, *options, "--output", path)
        self.assertEqual((done.returncode, done.stdout), (0, path + "\n"), done.stderr)
        return path

    def test_each_is_the_deck_in_the_input_folder(self):
        self.assertGreater(len(self.titles), 4)
        for test, title in self.titles.items():
            with open(self.program.deck(test + ".toml")) as file:
                text = file.read()
            self.assertEqual(tomllib.loads(text)["run"]["title"], title)
            self.assertEqual(self.program.call("new", test).stdout, text)

    def test_comments_hold_for_any_grains(self):
        for test in self.titles:
            with open(self.program.deck(test + ".toml")) as file:
                comments = " ".join(re.findall(r"#(.*)", file.read()))
            self.assertIsNone(re.search(r"\d\s*(mm|um|m|s|ms|kg|g|rpm|MPa|Pa)\b", comments), test)

    def test_each_checks_and_runs_for_all_kinds_of_grains(self):
        for test in self.titles:
            for options in GRAINS:
                path = self.new(test, *options)
                done = self.program.call("check", path)
                self.assertEqual(done.returncode, 0, f"{test} {options}: {done.stderr}")
            with open(path) as file:
                deck = tomllib.loads(file.read())
            with self.subTest(test):
                summary = self.program.run(self.new(test, "--grains", "1000", "--diameter", "2 mm"), self.path(test), *short(deck))
                self.assertEqual(summary["particles"]["inserted"], 1000)

    def test_numbers_are_those_that_were_asked_for(self):
        path = self.new("lifted_cylinder", "--diameter", "440 um", "--density", "3592", "--youngs-modulus", "7 GPa", "--grains", "2000",
                        "--restitution", "0.3", "--sliding-friction", "0.827", "--rolling-friction", "0.172")
        with open(path) as file:
            text = file.read()
        deck = tomllib.loads(text)
        grains, wall = deck["material"]
        self.assertEqual([grains["density"], grains["youngs_modulus"], wall["youngs_modulus"], wall["density"]],
                         [3592.0, 7e9, 7e9, "2.5 g/cm3"])
        self.assertNotIn("soft, for", text)  # the comment of the modulus that was replaced
        self.assertEqual([deck["pair"][0][key] for key in ("restitution", "sliding_friction", "rolling_friction")], [0.3, 0.827, 0.172])
        block = deck["particles"][0]
        self.assertEqual([block["diameter"], block["spacing"], block["count"]], ["0.44 mm", "0.484 mm", 2000])
        radius = 9.0 * 0.44 * (2000 / 5000) ** (1 / 3)
        self.assertAlmostEqual(float(block["radius"].removesuffix(" mm")), radius, delta=1e-5 * radius)

    def test_a_test_of_four_times_the_length_is_the_same_test(self):
        """With powers of four even its bits: times are doubled, stresses are four times as large."""
        states = []
        for diameter, time in (("1 mm", 0.02), ("4 mm", 0.04)):
            path, output = self.new("lifted_cylinder", "--diameter", diameter, "--grains", "5000"), self.path(diameter)
            self.program.run(path, output, *(f"phase.{phase}={value}" for phase, value in (
                ("settle.min_time", 0), ("settle.max_time", time), ("lift.time", time), ("rest.min_time", 0), ("rest.max_time", time))))
            with h5py.File(sorted(glob.glob(output + "/run_*.hdf"))[-1]) as file:
                states.append(file["particles/position"][...])
        np.testing.assert_array_equal(4.0 * states[0], states[1])

    def test_figures_in_small(self):
        tests = [(test, self.new(test, "--grains", "1200")) for test in FIGURES]
        summaries = self.program.run_all(((path, self.path(test)) for test, path in tests), options=("--quiet",))
        for (test, _), summary in zip(tests, summaries):
            for figure, (value, scatter) in FIGURES[test].items():
                self.assertAlmostEqual(summary[figure], value, delta=scatter, msg=f"{test} {figure}")
            particles = summary["particles"]
            self.assertEqual(particles["inside"] + particles["left"], 1200)
            if test in ("lifted_cylinder_disc", "granuheap", "ledge"):  # what has no room there has fallen off
                self.assertGreater(particles["left"], 100, test)
        flow = summaries[list(FIGURES).index("draw_down")]
        grain = 2500.0 * math.pi / 6.0 * 1e-9
        self.assertAlmostEqual((flow["discharged_mass_kg"] + flow["retained_mass_kg"]) / grain, 1200, delta=1e-6)
        self.assertFalse(flow["plugged"])

    def test_bad_input(self):
        self.fails(2, r'no ready test "lifted_cilinder"; did you mean lifted_cylinder\?', "new", "lifted_cilinder")
        self.fails(2, r'no ready test "drum"; did you mean rotating_drum\?', "new", "drum")
        self.fails(2, r"--diameter 3 kg: must be a length above 0", "new", "ledge", "--diameter", "3 kg")
        self.fails(2, r"--diameter -1: must be a length", "new", "ledge", "--diameter=-1")
        self.fails(2, r"--density heavy: must be a density", "new", "ledge", "--density", "heavy")
        self.fails(2, r"--grains 20: must be a number from 100", "new", "ledge", "--grains", "20")
        self.fails(2, r"--restitution 2: must be a number from 0 to 1", "new", "ledge", "--restitution", "2")
        self.fails(2, r"--grains 1e9: must be a number from 100 to less than 1e9", "new", "ledge", "--grains", "1e9")
        for test in ("tilting_box", "direct_shear"):
            self.fails(2, f"{test} of this size cannot be set up; take more --grains: ", "new", test, "--grains", "100")
        path = self.new("ledge")
        self.fails(4, r"is there already; name another file", "new", "ledge", "--output", path)
        self.fails(4, r"nowhere", "new", "ledge", "--output", self.path("nowhere/ledge.toml"))
        self.assertFalse(os.path.exists(self.path("nowhere")))


if __name__ == "__main__":
    FolderTest.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
