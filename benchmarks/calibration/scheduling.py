#!/usr/bin/python3
"""How well groups of ranks share a grid of uneven runs; see README.md."""

import pathlib
import re
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402

# Fills of 0.05 to 0.5 g, the smallest first in the deck: runs that differ by a factor of ten or more.
DECK = """
base = "{base}"
seeds = 2
set = ["output.snapshot_interval=0", "phase.settle.max_time=40 ms", "phase.settle.min_time=0",
       "phase.discharge.max_time=60 ms", "phase.discharge.min_time=0", "domain.max=[0.015, 0.015, 0.06]",
       "wall.vessel.points=[[0.004, 0.06], [0.004, 0.0], [0.00175, 0.0]]", "particles.0.height=58 mm"]
[[parameter]]
name = "mass"
key = "particles.0.mass"
min = 0.05e-3
max = 0.5e-3
points = 6
[[parameter]]
name = "sliding_friction"
key = "pair.0.sliding_friction"
values = [0.2, 0.5, 0.8]
[[observable]]
figure = "discharged_mass_kg"
laboratory = 50e-6
deviation = 5e-6
[[observable]]
figure = "retained_mass_kg"
laboratory = 50e-6
deviation = 5e-6
"""


def calibrate(options, ranks):
    """Wall seconds of the runs and idle share of the ranks."""
    output = options.work / f"on_{ranks}"
    shutil.rmtree(output, ignore_errors=True)
    deck = options.work / "scheduling.toml"
    deck.write_text(DECK.format(base=ROOT / "input" / "discharge_quick.toml"))
    done = subprocess.run(["mpirun", "-n", str(ranks), options.program, "calibrate", str(deck), "--output", str(output),
                           "--quiet"], capture_output=True, text=True, check=True)
    found = re.search(r"runs in ([\d.]+) s on .* idle for ([\d.]+) %", done.stdout)
    return float(found[1]), float(found[2])


def main():
    parser = usual_options(__doc__, "calibration")
    parser.add_argument("--pairs", type=int, default=3, help="of one rank and two, in turn")
    options = parser.parse_args()
    options.program = options.program or repose.find_program()
    options.work.mkdir(parents=True, exist_ok=True)
    ratios, idle = [], []
    for pair in range(options.pairs):
        alone, _ = calibrate(options, 1)
        together, share = calibrate(options, 2)
        ratios.append(together / alone)
        idle.append(share)
        print(f"pair {pair + 1}: {alone:.1f} s on one rank, {together:.1f} s on two ({ratios[-1]:.3f}), idle {share:.1f} %",
              flush=True)
    print(f"median {statistics.median(ratios):.3f} of the time, idle {statistics.median(idle):.1f} %")
    save(options.results / "scheduling.json", ratios=ratios, idle_percent=idle)


if __name__ == "__main__":
    main()
