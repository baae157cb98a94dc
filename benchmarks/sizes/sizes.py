#!/usr/bin/python3
"""Particle-steps per cpu-second of settled beds of several size ratios, cost of their lists, ghosts; see README.md."""

import argparse
import math
import pathlib
import statistics
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "python"))
import repose  # noqa: E402

BED = ROOT / "benchmarks" / "throughput" / "inputs" / "bed.toml"
BEDS = {"1:1": (440e-6, 440e-6), "1:3.5": (208e-6, 724e-6), "1:10": (150e-6, 1500e-6), "ball": (400e-6, 400e-6)}
BALL = 22e-3  # m, on a million grains; goes with the third root of their number
DEPTH = 20    # of a bed, in grains of mean volume
SOLID = 0.57  # its solid fraction, roughly
LOOSE = 0.2   # solid fraction before it settles

MATERIAL = """
[[material]]
name = "ball"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 2500.0
"""
PAIR = """
[[pair]]
materials = ["ball", "{other}"]
restitution = 0.5
sliding_friction = 0.5
rolling_friction = 0.01
"""


class Bed:
    """A box of grains in a folder of its own: made once, measured often."""

    def __init__(self, name, size, work, program):
        self.smallest, self.largest = BEDS[name]
        self.name, self.size, self.program = name, size, program
        self.folder = work / f"{name.replace(':', '_')}_{size}"
        a, b = self.smallest, self.largest
        # A uniform distribution of the mass has the mean volume pi/6 / <d^-3>.
        self.volume = size * math.pi / 6.0 * 2.0 * (a * b) ** 2 / (a + b)
        self.ball = BALL * (size / 1e6) ** (1.0 / 3.0) if name == "ball" else 0.0
        depth = DEPTH * (6.0 * self.volume / (math.pi * size)) ** (1.0 / 3.0)
        self.half = max(0.5 * math.sqrt(self.volume / (SOLID * depth)), 0.75 * self.ball)
        self.loose = max(self.volume / (LOOSE * (2 * self.half) ** 2), 1.5 * self.largest)

    def run(self, output, blocks, phase, ranks=1, more=(), restart=False):
        """The summary of a run; blocks and phase are texts of a deck."""
        self.folder.mkdir(parents=True, exist_ok=True)
        deck = self.folder / f"{output}.toml"
        text = BED.read_text() + (MATERIAL + "".join(PAIR.format(other=o) for o in ("carbohsp", "steel", "ball"))
                                  if self.ball else "")
        deck.write_text(text + blocks + "\n[output]\nseries_interval = 1e3\n" + phase)
        h, top = self.half, self.loose + 2 * self.ball + 1e-3
        sets = [f"domain.min=[{-2 * h}, {-2 * h}, -1e-3]", f"domain.max=[{2 * h}, {2 * h}, {top}]",
                f"wall.x_low.point=[{-h}, 0.0, 0.0]", f"wall.x_high.point=[{h}, 0.0, 0.0]",
                f"wall.y_low.point=[0.0, {-h}, 0.0]", f"wall.y_high.point=[0.0, {h}, 0.0]", *more]
        return repose.run(deck, self.folder / output, set=sets, ranks=ranks, program=self.program,
                          restart=restart).summary

    def settle(self, output, blocks):
        # The guard is raised: a large grain that falls on small ones presses into them while the bed settles.
        energy = 3592.0 * self.volume / self.size * 1e-7  # 1e-7 J/kg
        self.run(output, blocks, f'\n[[phase]]\nname = "settle"\nuntil = "kinetic_energy"\nkinetic_energy = {energy}\n'
                 'min_time = 0.05\nmax_time = 0.3\n', more=["guards.max_overlap=0.5"], restart=True)
        repose.Run(self.folder / output).snapshot_paths[0].rename(self.folder / f"{output}.hdf")

    def make(self):
        """The settled state, unless it is there."""
        if (self.folder / "bed.hdf").exists():
            return
        h = self.half
        sizes = (f'type = "classes"\ndiameters = [{self.largest}]\nshares = [1.0]\n'
                 if self.smallest == self.largest else
                 f'type = "uniform"\nby = "mass"\nmin_diameter = {self.smallest}\nmax_diameter = {self.largest}\n')
        fill = (f'\n[[particles]]\ntype = "fill"\nmaterial = "carbohsp"\ncount = {self.size}\nregion = "box"\n'
                f"min = [{-h}, {-h}, 0.0]\nmax = [{h}, {h}, {self.loose}]\n[particles.sizes]\n{sizes}")
        self.settle("grains" if self.ball else "bed", fill)
        if self.ball:  # laid onto the bed, clear of its highest grain
            surface = self.highest(self.folder / "grains.hdf")
            (self.folder / "ball.csv").write_text("x,y,z,radius,material\n"
                                                  f"0,0,{surface + 0.5 * self.ball},{0.5 * self.ball},ball\n")
            self.settle("bed", '\n[[particles]]\ntype = "snapshot"\nfile = "grains.hdf"\n'
                               '\n[[particles]]\ntype = "csv"\nfile = "ball.csv"\n')

    @staticmethod
    def highest(snapshot):
        grains = repose.Snapshot(snapshot)
        return float((grains.position[:, 2] + grains.radius).max())

    def measure(self, steps, ranks=1):
        return self.run(f"measured_{ranks}", '\n[[particles]]\ntype = "snapshot"\nfile = "bed.hdf"\n',
                        f'\n[[phase]]\nname = "rest"\nuntil = "steps"\nsteps = {steps}\n', ranks)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--size", type=int, default=15600, help="grains of each bed")
    parser.add_argument("--steps", type=int, default=2000, help="steps that are measured")
    parser.add_argument("--rounds", type=int, default=3, help="all beds in alternation, so often")
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=list(BEDS), help="which; the first is divided by")
    parser.add_argument("--repose", default=str(ROOT / "build/release/src/repose"), help="executable")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/benchmarks/sizes", help="what is made")
    args = parser.parse_args()
    beds = [Bed(name, args.size, args.work.resolve(), args.repose) for name in args.beds]
    for bed in beds:
        bed.make()
    rounds = [[bed.measure(args.steps) for bed in beds] for _ in range(args.rounds)]
    rate = [[s["timing"]["particle_steps_per_cpu_second"] for s in one] for one in rounds]
    print(f"{'bed':8} {'million particle-steps per cpu-s':>33} {'over ' + args.beds[0]:>11} {'lists, ns':>10}"
          f" {'pairs':>6} {'ghosts on 2 ranks':>18}")
    for k, bed in enumerate(beds):
        last = rounds[-1][k]
        share = statistics.median(one[k] / one[0] for one in rate)
        lists = 1e9 * last["timing"]["stages"]["lists"]["mean_s"] / (args.steps * bed.size)
        two = bed.measure(max(args.steps // 10, 10), ranks=2)["lists"]
        print(f"{bed.name:8} {1e-6 * statistics.median(one[k] for one in rate):33.2f} {share:11.2f} {lists:10.2f}"
              f" {last['lists']['listed_pairs_per_particle']:6.1f} {two['ghosts']:18}")


if __name__ == "__main__":
    main()
