#!/usr/bin/python3
"""What checkpoints cost: `checkpoints.py --repose build/release/src/repose [--size 156000] [--ranks 2]`.

Runs a bed in which every grain touches eight others (a settled one: five to six), writes a checkpoint every 200 steps, and
prints the seconds of one, its size, and its share of a minute."""

import argparse
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools" / "python"))
import repose  # noqa: E402

DECK = """
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[[material]]
name = "bauxite"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 3592.0
[[pair]]
materials = ["bauxite", "bauxite"]
restitution = 0.5
sliding_friction = 0.5
rolling_friction = 0.1
[[particles]]
type = "csv"
file = "bed.csv"
[[phase]]
name = "all"
until = "steps"
steps = 2000
[output]
checkpoint_steps = 200
checkpoint_minutes = 0
"""


def write_bed(path, size):
    """A body-centred lattice whose grains overlap by 0.1 % of their diameter and move at random."""
    diameter = 385e-6
    spacing = 0.999 * diameter * 2 / 3**0.5
    cells = round((size / 2) ** (1 / 3))
    draw = random.Random(1)
    with open(path, "w") as file:
        file.write("x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n")
        for site in range(2 * cells**3):
            cell, corner = divmod(site, 2)
            place = [(c + 0.5 * corner) * spacing for c in (cell % cells, cell // cells % cells, cell // cells**2)]
            velocity = [draw.uniform(-0.01, 0.01) for _ in range(3)]
            file.write(",".join(f"{v:.9g}" for v in place + velocity + [0.0, 0.0, 0.0, diameter / 2]) + ",bauxite\n")
    return 2 * cells**3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repose", required=True)
    parser.add_argument("--size", type=int, default=156000)
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--folder", default=None, help="of the output; default: the system's temporary folder")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as folder:
        grains = write_bed(Path(folder, "bed.csv"), options.size)
        Path(folder, "deck.toml").write_text(DECK)
        output = Path(folder, "output")
        command = ["mpirun", "-n", str(options.ranks), options.repose, "run", f"{folder}/deck.toml", "--output", str(output),
                   "--quiet"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        largest = 0
        while process.poll() is None:
            try:
                process.wait(timeout=0.2)
            except subprocess.TimeoutExpired:
                largest = max([largest, *(size_of(p) for p in output.glob("checkpoint_*.hdf"))])
        assert process.returncode == 0
        timing = repose.Run(output).summary["timing"]
    seconds = timing["checkpoints_wall_s"] / timing["checkpoints"]
    print(f"{grains} grains on {options.ranks} ranks: {timing['checkpoints']} checkpoints of {largest / 1e6:.0f} MB, "
          f"{seconds:.2f} s each: {100 * seconds / 60:.2f} % of a minute")


def size_of(path):
    try:
        return path.stat().st_size
    except FileNotFoundError:
        return 0


if __name__ == "__main__":
    main()
