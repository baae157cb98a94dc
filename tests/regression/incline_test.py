#!/usr/bin/env python3
"""A ball on a plain plate that tilts: it begins to roll at atan(mu_r), and to slide at atan(mu) when it cannot turn.

usage: incline_test.py REPOSE MPIEXEC SOURCE
"""

import math
import sys
import tempfile
import unittest

from repose_runs import Program

DECK = """
[domain]
min = ["-50 mm", "-20 mm", "-5 mm"]
max = ["50 mm", "20 mm", "50 mm"]
[[material]]
name = "metal"
youngs_modulus = 5e9
poisson_ratio = 0.3
density = 6960.0
[[pair]]
materials = ["metal", "metal"]
restitution = 0.3
sliding_friction = 0.3
rolling_friction = 0.12757
[[wall]]
name = "plate"
type = "plane"
material = "metal"
point = [0.0, 0.0, 0.0]
[[particles]]
type = "fill"
material = "metal"
diameter = "28 mm"
count = 1
jitter = 0.0
region = "cylinder"
centre = [0.0, 0.0, 0.0]
radius = "14.1 mm"
height = "28.1 mm"
[tilt]
axis_direction = [0.0, 1.0, 0.0]
angular_velocity = "20 deg/s"
phases = ["tilt"]
[time]
expected_speed = 0.3
[[phase]]
name = "rest"
until = "kinetic_energy"
kinetic_energy = 1e-14
min_time = "50 ms"
max_time = 2.0
[[phase]]
name = "tilt"
until = "tilt_onset"
max_time = 2.0
[measurement.tilt_onset]
against = "metal"
"""


class Incline(unittest.TestCase):
    def onset(self, *overrides):
        with tempfile.TemporaryDirectory() as folder:
            deck = folder + "/plate.toml"
            with open(deck, "w") as file:
                file.write(DECK)
            return program.run(deck, folder + "/out", *overrides)

    def check(self, summary, friction):
        expected = math.degrees(math.atan(friction))
        self.assertAlmostEqual(summary["tilt_onset_deg"], expected, delta=0.1)
        self.assertAlmostEqual(summary["tilt_onset_excess_deg"], summary["tilt_onset_deg"] - expected, places=9)
        at_rates = summary["tilt_onsets"]
        self.assertEqual(len(at_rates), 2)
        self.assertAlmostEqual(at_rates[1]["rate_deg_s"], 0.5 * at_rates[0]["rate_deg_s"])
        self.assertGreater(at_rates[0]["onset_deg"], at_rates[1]["onset_deg"])  # seen later, the faster it tilts
        self.assertGreater(at_rates[1]["onset_deg"], expected)

    def test_rolls_at_the_angle_of_rolling_friction(self):
        self.check(self.onset(), 0.12757)

    def test_another_axis_and_sense(self):
        self.check(self.onset("tilt.axis_direction=[-1, 2, 0]", "tilt.angular_velocity=-20 deg/s",
                              "pair.0.rolling_friction=0.05"), 0.05)

    def test_a_particle_that_there_is_not_is_refused_before_anything_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = folder + "/plate.toml"
            with open(deck, "w") as file:
                file.write(DECK)
            done = program.call("check", deck, "--set", "measurement.tilt_onset.particle=1")
            self.assertEqual(done.returncode, 2)
            self.assertIn("measurement.tilt_onset.particle = 1: the deck has particles 0 to 0", done.stderr)

    def test_slides_at_the_angle_of_sliding_friction_when_it_cannot_turn(self):
        self.check(self.onset("particles.0.rotation_blocked=true"), 0.3)


if __name__ == "__main__":
    program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
