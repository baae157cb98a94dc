#!/usr/bin/env python3
"""Shear cells: internal friction over sliding friction as published, a box and a ring agree, the steady stresses of grains without
cohesion lie on a line through the origin, and grains that cannot roll resist more.

usage: shear_test.py REPOSE MPIEXEC SOURCE [FOLDER]
"""

import os
import statistics
import sys
import unittest

from repose_runs import Program, SharedFolderTest

# Stress ratio in slow simple shear of spheres by their sliding friction: Chialvo, Sun and Sundaresan 2012, Table II
# (Physical Review E 85, 021305, doi:10.1103/PhysRevE.85.021305).
PUBLISHED = {0.0: 0.105, 0.1: 0.268, 0.3: 0.357, 0.5: 0.382, 1.0: 0.405}
BOTH = (0.1, 0.5)  # sliding frictions of which a box and a ring are compared
SEEDS = (1, 2)
FORCES = ("14.4 N", "57.6 N")  # half and twice that of the deck


class ShearCells(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        box, ring = cls.program.deck("direct_shear.toml"), cls.program.deck("ring_shear.toml")
        friction = "pair.grain-grain.sliding_friction={}".format
        runs = [(ring, cls.path(f"ring_{value}_1"), friction(value)) for value in PUBLISHED]
        runs += [(deck, cls.path(f"{name}_{value}_{seed}"), friction(value), f"run.seed={seed}")
                 for value in BOTH for seed in SEEDS for name, deck in (("ring", ring), ("box", box))
                 if (name, seed) != ("ring", 1)]
        runs += [(ring, cls.path(f"blocked_{value}_1"), friction(value), "particles.0.rotation_blocked=true")
                 for value in BOTH]
        runs += [(box, cls.path(f"force_{force[:-2]}"), f"wall.lid.servo.force={force}") for force in FORCES]
        cls.program.run_all(runs)
        import repose
        from repose.shear import Shear
        cls.of = staticmethod(lambda name: Shear(repose.Run(cls.path(name))))
        for _, folder, *_ in runs:
            test = cls.of(os.path.basename(folder))
            print(f"{os.path.basename(folder):12} {test.steady_normal:8.0f} Pa  {test.friction_deg:6.2f} degrees, peak {test.peak_deg:6.2f}")

    def test_internal_friction_rises_with_sliding_friction_as_published(self):
        import numpy as np
        found = [self.of(f"ring_{value}_1").friction_deg for value in PUBLISHED]
        self.assertEqual(found, sorted(found), found)
        for angle, ratio in zip(found, PUBLISHED.values()):
            self.assertAlmostEqual(angle, np.degrees(np.arctan(ratio)), delta=2.0)

    def test_a_box_and_a_ring_agree(self):
        for value in BOTH:
            box, ring = (statistics.mean(self.of(f"{name}_{value}_{seed}").friction_deg for seed in SEEDS)
                         for name in ("box", "ring"))
            self.assertAlmostEqual(box, ring, delta=2.0)

    def test_the_line_through_the_steady_stresses_leads_through_the_origin(self):
        from repose.shear import steady_locus
        tests = [self.of(name) for name in ("force_14.4", "box_0.5_1", "force_57.6")]
        angle, cohesion = steady_locus(tests)
        self.assertLess(abs(cohesion), 0.05 * tests[-1].steady_normal)
        for test in tests:
            self.assertAlmostEqual(test.friction_deg, angle, delta=2.5)

    def test_grains_that_cannot_roll_resist_more(self):
        for value in BOTH:
            self.assertGreater(self.of(f"blocked_{value}_1").friction_deg, self.of(f"ring_{value}_1").friction_deg + 3.0)
        self.assertGreater(self.of("blocked_0.5_1").friction_deg, self.of("blocked_0.1_1").friction_deg)


if __name__ == "__main__":
    ShearCells.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
