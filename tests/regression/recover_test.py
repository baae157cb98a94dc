"""A known answer is found again: figures of eight runs with hidden parameters and other seeds are given to `repose calibrate`
as those of a laboratory, with the scatter of those eight as their deviation. The truth has to lie in the 95 % region: friction
from discharged mass and angle of repose, restitution from the grains in areas 1 and 3; four hidden sets each. One of
the eight may be outside, as chance has it one time in four; two in one time of seventeen.

Usage: recover_test.py EXECUTABLE MPIEXEC SOURCE_DIR [FOLDER]
"""

import json
import math
import os
import sys

from laboratories import FRICTION, RESTITUTION, misfit_at
from repose_runs import Program, cores, folder_of_runs

STUDIES = {"friction": FRICTION, "restitution": RESTITUTION}


class Case:
    def __init__(self, program, name, folder):
        self.program, self.name, self.folder = program, name, os.path.join(folder, name)
        self.study, self.base = STUDIES[name], program.deck("discharge_quick.toml")
        os.makedirs(self.folder, exist_ok=True)

    def deck(self, name, text):
        path = os.path.join(self.folder, name + ".toml")
        with open(path, "w") as file:
            file.write(text)
        return path

    def calibrate(self, name, text):
        output = os.path.join(self.folder, name)
        done = self.program.call("calibrate", self.deck(name, text), "--output", output, "--quiet", ranks=cores(), timeout=14000)
        assert done.returncode == 0, done.stderr
        return output

    def found(self, truth, laboratory, output):
        """Whether the truth is in the region that the grid's runs give with this laboratory."""
        deck = self.deck("laboratory", self.study.grid(self.base, laboratory))
        done = self.program.call("estimate", output, "--deck", deck)
        assert done.returncode == 0, done.stderr
        with open(os.path.join(output, "estimate.json")) as file:
            estimate = json.load(file)
        misfit = misfit_at(estimate["surfaces"], truth)
        widest = max(max(row) for row in estimate["surfaces"]["misfit"])
        assert widest > estimate["limit"], f"{self.name} {truth}: the region is all of the ranges"
        best = [f"{v:.3f} +- {e:.3f}" for p in estimate["points"][:1]
                for v, e in zip(p["values"], [e if e is not None else math.inf for e in p["standard_errors"]])]
        print(f"{self.name} {truth}: {best or estimate['verdict']}, T = {misfit:.2f} of {estimate['limit']:.2f}, "
              f"laboratory {['%.4g +- %.2g' % pair for pair in laboratory]}", flush=True)
        return misfit <= estimate["limit"]

    def recovered(self):
        """How many of the hidden sets are found again."""
        values = self.study.laboratory_values(self.calibrate("hidden", self.study.laboratories(self.base)))
        if self.study is RESTITUTION:
            assert all(mean >= 200 for sample in values for mean, _ in sample), values
        output = self.calibrate("grid", self.study.grid(self.base, values[0]))
        return sum(self.found(truth, v, output) for truth, v in zip(self.study.hidden, values))


def main():
    program = Program(*sys.argv[1:4])
    with folder_of_runs(sys.argv) as folder:
        recovered = sum(Case(program, name, folder).recovered() for name in STUDIES)
    total = sum(len(study.hidden) for study in STUDIES.values())
    print(f"{recovered} of {total} found again")
    assert recovered >= total - 1


main()
