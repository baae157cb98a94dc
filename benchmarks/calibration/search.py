#!/usr/bin/python3
"""How many runs a search saves against a full grid of the same confidence; see README.md."""

import argparse
import csv
import json
import os
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
HIDDEN = ((0.3, 0.12), (0.45, 0.17), (0.55, 0.25))  # sliding, rolling friction of the laboratories
REPEATS = 8
SEEDS = 2
GRID = ([0.2, 0.3, 0.4, 0.5, 0.6, 0.7], [0.05, 0.11, 0.17, 0.23, 0.3])  # 30 points
RANGES = [f"min = {values[0]}\nmax = {values[-1]}" for values in GRID]
FIGURES = ("discharged_mass_kg", "angle_of_repose_deg")

HEAD = 'base = "{base}"\nseeds = {seeds}\nfirst_seed = {first_seed}\nset = ["output.snapshot_interval=0"]\n'
PARAMETER = '[[parameter]]\nname = "{name}_friction"\nkey = "pair.0.{name}_friction"\n{values}\n'
OBSERVABLE = ('[[observable]]\nfigure = "{figure}"\nlaboratory = {value}\ndeviation = {deviation}\nrepeats = {repeats}\n'
              'deviation_is_known = false\n')
SEARCH = "[adaptive]\nstart = 9\nbatch = 4\nbudget = {budget}\nhalf_width = {half_width}\n"


class Studies:
    def __init__(self, options):
        self.options, self.work = options, options.work
        self.work.mkdir(parents=True, exist_ok=True)

    def deck(self, name, laboratory, points, *, seeds=SEEDS, first_seed=1, rest=""):
        """`points`: of each parameter, what its section has beside the key."""
        text = HEAD.format(base=ROOT / "input" / "discharge_quick.toml", seeds=seeds, first_seed=first_seed)
        for parameter, values in zip(("sliding", "rolling"), points):
            text += PARAMETER.format(name=parameter, values=values)
        for figure, (value, deviation) in zip(FIGURES, laboratory):
            text += OBSERVABLE.format(figure=figure, value=value, deviation=deviation, repeats=REPEATS)
        path = self.work / f"{name}.toml"
        path.write_text(text + rest)
        return path

    def say(self, *words):
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())

    def calibrate(self, deck):
        """Does what is missing of the runs of a deck; returns their directory."""
        output = self.work / deck.stem
        self.say("mpirun", "-n", str(self.options.ranks), self.options.program, "calibrate", str(deck), "--output",
                 str(output), "--quiet")
        return output

    def estimate(self, output, deck=None):
        if deck is not None:
            self.say(self.options.program, "estimate", str(output), "--deck", str(deck))
        return json.loads((output / "estimate.json").read_text())

    def laboratories(self):
        """(mean, deviation) of each figure for each hidden set, of runs with seeds of their own."""
        dummies = [(1e-3, 1e-4), (20.0, 1.0)]
        points = "".join(f"[[point]]\nvalues = {list(hidden)}\n" for hidden in HIDDEN)
        output = self.calibrate(self.deck("hidden", dummies, RANGES, seeds=REPEATS, first_seed=1001, rest=points))
        with open(output / "grid.csv") as file:
            rows = list(csv.DictReader(file))
        return [[(statistics.mean(values), statistics.stdev(values))
                 for values in ([float(run[f]) for run in rows[k * REPEATS:(k + 1) * REPEATS]] for f in FIGURES)]
                for k in range(len(HIDDEN))]


def compare(studies, number, hidden, laboratory):
    """Runs and half-widths of the grid and of the search for one laboratory."""
    deck = studies.deck("grid", laboratory, [f"values = {values}" for values in GRID])
    grid = studies.estimate(studies.calibrate(deck), deck)
    grid_runs = len(GRID[0]) * len(GRID[1]) * SEEDS
    row = {"hidden": hidden, "grid_runs": grid_runs, "grid_half_width": grid["half_width"]}
    if grid["half_width"] is None:
        return {**row, "search_runs": None}
    search = SEARCH.format(budget=grid_runs // SEEDS, half_width=grid["half_width"])
    output = studies.calibrate(studies.deck(f"search_{number}", laboratory, RANGES, rest=search))
    found = studies.estimate(output)
    with open(output / "grid.csv") as file:
        runs = sum(1 for _ in csv.DictReader(file))
    return {**row, "search_runs": runs, "search_half_width": found["half_width"],
            "values": [(p["values"], p["standard_errors"]) for p in found["points"]]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=str(ROOT / "build" / "ci" / "src" / "repose"))
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "benchmarks" / "search")
    parser.add_argument("--ranks", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    studies = Studies(options)
    rows = []
    for number, (hidden, laboratory) in enumerate(zip(HIDDEN, studies.laboratories())):
        rows.append(compare(studies, number, hidden, laboratory))
        print(rows[-1], flush=True)
    (options.work / "search.json").write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
