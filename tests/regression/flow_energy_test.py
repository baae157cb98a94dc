"""Whether the flow energy of input/powder_rheometer.toml, with half of its grains, tells what it should: three seeds each show
that it rises with the sliding and with the rolling friction between grains. What docs/laboratory-tests.md says about it is what
this prints. Runs in FOLDER that are complete are not run again.

Usage: flow_energy_test.py EXECUTABLE MPIEXEC SOURCE_DIR [FOLDER]
"""

import json
import math
import os
import statistics
import sys

from repose_runs import Program, folder_of_runs

SEEDS = range(1, 4)
POINTS = [(0.5, 0.2), (0.2, 0.2), (0.5, 0.0)]  # sliding and rolling friction
HALF = ("particles.0.count=2000", "wall.arm_1.corner=[0, -0.001, 0.0125]", "wall.arm_2.corner=[0, 0.001, 0.0125]", "phase.stir.time=0.75",
        "output.snapshot_interval=0", "output.walls=false")


def main():
    program = Program(*sys.argv[1:4])
    with folder_of_runs(sys.argv) as folder:
        outputs = {(point, seed): os.path.join(folder, f"sliding_{point[0]}_rolling_{point[1]}_seed_{seed}") for point in POINTS for seed in SEEDS}
        program.run_all([(program.deck("powder_rheometer.toml"), output, *HALF, f"run.seed={seed}", f"pair.0.sliding_friction={point[0]}",
                          f"pair.0.rolling_friction={point[1]}") for (point, seed), output in outputs.items()
                         if not os.path.exists(os.path.join(output, "summary.json"))], options=("--quiet",))
        energies = {}
        for (point, _), output in outputs.items():
            with open(os.path.join(output, "summary.json")) as file:
                summary = json.load(file)
            assert summary["particles"]["left"] == 0, f"{output}: grains were thrown out"
            energies.setdefault(point, []).append(summary["specific_flow_energy_J_kg"])
    print("| sliding friction | rolling friction | flow energy, mJ/g |\n|---|---|---|")
    error = {}
    for point, values in energies.items():
        error[point] = statistics.stdev(values) / math.sqrt(len(values))
        print(f"| {point[0]} | {point[1]} | {statistics.mean(values):.3f} +- {error[point]:.3f} |")
    first = POINTS[0]
    for other in POINTS[1:]:
        rise = statistics.mean(energies[first]) - statistics.mean(energies[other])
        assert rise > 4.0 * math.hypot(error[first], error[other]), f"from {other} to {first} the flow energy rises by {rise}"


main()
