#!/usr/bin/env python3
"""The oedometer: the lid's force follows its course, and the stiffness of unloading goes with a power of the stress.

usage: compression_test.py REPOSE MPIEXEC SOURCE
"""

import json
import os
import subprocess
import sys
import unittest

from repose_runs import Program, SharedFolderTest


class Compression(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.program = program
        cls.summary = program.run(program.deck("uniaxial_compression.toml"), cls.path("run"))
        tool = os.path.join(program.source, "tools", "compression.py")
        done = subprocess.run([sys.executable, tool, cls.path("run")], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        with open(cls.path("run", "compression.json")) as file:
            cls.found = json.load(file)

    def test_the_modulus_goes_with_stress_as_hertz_and_the_number_of_contacts_say(self):
        # A crystal has 1/3 (tests/parallel/servo_test.cpp); a disordered bed gains contacts with stress, so its exponent lies
        # between 1/3 and 1/2, nearer to 1/3 once the mean number of contacts is taken out.
        self.assertEqual(len(self.found["unloadings"]), 6)
        self.assertGreater(self.found["exponent"], self.found["hertz_exponent"])
        self.assertLess(self.found["exponent"], 0.5)
        self.assertAlmostEqual(self.found["hertz_exponent"], 1.0 / 3.0, delta=0.05)
        self.assertLess(self.found["hertz_exponent_error"], 0.02)

    def test_the_bed_is_compacted_for_good(self):
        first, *_, last = self.found["unloadings"]  # both from 64 kPa, before and after the cycle
        self.assertLess(abs(last["stress_Pa"] / first["stress_Pa"] - 1.0), 0.03)
        self.assertLessEqual(last["porosity"], first["porosity"])
        self.assertGreater(first["porosity"], 0.36)
        self.assertLess(first["porosity"], 0.46)

    def test_the_lid_stands_at_its_last_target(self):
        lid = self.summary["servos"]["lid"]
        self.assertAlmostEqual(lid["force_N"] / lid["target_N"], 1.0, delta=0.02)  # still unloading, some looks behind


if __name__ == "__main__":
    program = Program(*sys.argv[1:4])
    Compression.program = program
    unittest.main(argv=sys.argv[:1])
