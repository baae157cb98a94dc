#!/usr/bin/env python3
"""The rotating drum: what the wall bears, and the slope of the bed, in a reduced size.

usage: drum_test.py REPOSE MPIEXEC SOURCE
"""

import csv
import sys
import tempfile
import unittest

from repose_runs import Program

REDUCED = ["particles.0.count=1800", "particles.0.diameter=1.6 mm", "particles.0.spacing=1.75 mm", "phase.fill.time=0.15",
           "phase.turn.time=1.2", "measurement.surface_angle.from=0.5", "measurement.surface_angle.interval=10 ms"]


class Drum(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.summary = program.run(program.deck("rotating_drum.toml"), folder + "/out", *REDUCED)
            with open(folder + "/out/walls.csv") as file:
                cls.rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]

    def mean(self, column, begin, end):
        values = [row[column] for row in self.rows if begin <= row["time_s"] <= end]
        return sum(values) / len(values)

    def test_the_drum_bears_the_weight(self):
        mass = 1800 * 3592.0 * 4.18879020478639 * 0.8e-3**3
        self.assertAlmostEqual(self.mean("drum_force_z_N", 0.12, 0.15) / (-9.81 * mass), 1.0, delta=0.02)
        self.assertAlmostEqual(self.mean("drum_force_z_N", 0.5, 1.35) / (-9.81 * mass), 1.0, delta=0.05)

    def test_the_bed_resists_the_rotation(self):
        # The weight's lever arm is the way of the bed's centre of mass: a torque against the rotation about +y.
        self.assertLess(self.mean("drum_torque_y_Nm", 0.5, 1.35), -1e-3)
        self.assertLess(abs(self.mean("drum_torque_y_Nm", 0.12, 0.15)), 2e-4)  # at rest, but for some sloshing

    def test_the_surface_slopes(self):
        # Turning about +y the shell moves towards -x at the bottom and carries the bed up there: the surface falls
        # towards +x. Grains of this friction flow at 30 to 45 degrees.
        self.assertGreater(self.summary["surface_angle_samples"], 50)
        self.assertLess(self.summary["surface_angle_deg"], -28.0)
        self.assertGreater(self.summary["surface_angle_deg"], -46.0)
        self.assertLess(self.summary["surface_angle_deviation_deg"], 6.0)


if __name__ == "__main__":
    program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
