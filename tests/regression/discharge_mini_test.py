"""The mini discharge against LIGGGHTS 3.8 on the same case (contact_distance_factor 1.05, three seeds): grains kept above
the hole after 0.25 s of filling and 1.1 s of discharge, and the angle of the pile.

Usage: discharge_mini_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import sys
import tempfile

from repose_runs import Program

LIGGGHTS_KEPT = [2848, 2798, 2879]
LIGGGHTS_ANGLE_DEG = [31.0, 30.6, 29.2]


def mean(values):
    return sum(values) / len(values)


def main():
    program = Program(*sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        runs = program.run_all((program.deck("discharge_mini.toml"), f"{folder}/{seed}", f"run.seed={seed}")
                               for seed in (1, 2, 3))
    for s in runs:
        particles = s["particles"]
        assert particles["inserted"] == particles["inside"] + particles["left"] == 9362, particles
    grain = (runs[0]["discharged_mass_kg"] + runs[0]["retained_mass_kg"]) / 9362
    kept = [s["retained_mass_kg"] / grain for s in runs]
    angle = [s["angle_of_repose_deg"] for s in runs]
    print("kept", [round(k) for k in kept], "LIGGGHTS", LIGGGHTS_KEPT, "ratio", mean(kept) / mean(LIGGGHTS_KEPT))
    print("angle", angle, "LIGGGHTS", LIGGGHTS_ANGLE_DEG, "difference", mean(angle) - mean(LIGGGHTS_ANGLE_DEG))
    assert abs(mean(kept) / mean(LIGGGHTS_KEPT) - 1.0) < 0.05
    assert abs(mean(angle) - mean(LIGGGHTS_ANGLE_DEG)) < 2.0


main()
