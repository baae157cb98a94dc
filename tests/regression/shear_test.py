#!/usr/bin/env python3
"""The shear box: the yield locus of grains without cohesion leads through the origin, internal friction rises with sliding
friction, less and less where grains roll, and is greater where they cannot.

usage: shear_test.py REPOSE MPIEXEC SOURCE
"""

import os
import sys
import unittest

from repose_runs import Program, SharedFolderTest

FRICTIONS = (0.0, 0.2, 0.5, 1.0)


class DirectShear(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        deck = cls.program.deck("direct_shear.toml")
        runs = [(deck, cls.path(f"{kind}_{friction}"), f"pair.grain-grain.sliding_friction={friction}",
                 f"particles.0.rotation_blocked={blocked}")
                for kind, blocked in (("rolling", "false"), ("blocked", "true")) for friction in FRICTIONS]
        runs += [(deck, cls.path(f"force_{force}"), f"wall.lid.servo.force={force}") for force in (11.52, 23.04)]
        cls.program.run_all(runs)
        import repose
        from repose.shear import Shear
        cls.of = staticmethod(lambda name: Shear(repose.Run(cls.path(name))))
        for _, folder, *_ in runs:
            test = cls.of(folder)
            print(f"{os.path.basename(folder):12} {test.steady_normal:8.0f} Pa  {test.friction_deg:6.2f} degrees, peak {test.peak:.3f}")

    def angles(self, kind):
        return [self.of(f"{kind}_{friction}").friction_deg for friction in FRICTIONS]

    def test_the_yield_locus_leads_through_the_origin(self):
        from repose.shear import yield_locus
        tests = [self.of(name) for name in ("rolling_0.5", "force_11.52", "force_23.04")]
        angle, cohesion = yield_locus(tests)
        self.assertLess(abs(cohesion), 0.05 * tests[-1].steady_normal)
        for test in tests:  # a box of 16 by 8 grains scatters by some degrees
            self.assertAlmostEqual(test.friction_deg, angle, delta=4.0)

    def test_internal_friction_rises_and_saturates_where_grains_roll(self):
        angles = self.angles("rolling")
        self.assertEqual(angles, sorted(angles), angles)
        self.assertLess(angles[3] - angles[2], 0.5 * (angles[2] - angles[0]), angles)

    def test_grains_that_cannot_roll_resist_more(self):
        rolling, blocked = self.angles("rolling"), self.angles("blocked")
        self.assertEqual(blocked, sorted(blocked), blocked)
        for free, held in zip(rolling[1:], blocked[1:]):
            self.assertGreater(held, free + 5.0)


if __name__ == "__main__":
    DirectShear.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
