#!/usr/bin/python3
"""How many runs a search saves against a full grid of the same confidence; see README.md."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks"), str(ROOT / "tests" / "regression")]
from laboratories import FRICTION  # noqa: E402
from report import save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402

BASE = ROOT / "input" / "discharge_quick.toml"


class Calibrations:
    def __init__(self, options):
        self.options, self.work = options, options.work
        self.work.mkdir(parents=True, exist_ok=True)

    def calibrate(self, name, text):
        """Does what is missing of the runs of a deck and estimates."""
        deck = self.work / f"{name}.toml"
        deck.write_text(text)
        return repose.calibrate(deck, self.work / name, ranks=self.options.ranks, program=self.options.program)

    def grid(self, laboratory):
        """What the whole grid's runs give with this laboratory."""
        return self.calibrate("grid", FRICTION.grid(BASE, laboratory)).estimate

    def search(self, number, laboratory, half_width):
        """The estimate of a search that stops at this half-width, and its runs."""
        adaptive = {"start": 9, "batch": 2, "budget": FRICTION.points(), "half_width": half_width}
        found = self.calibrate(f"search_{number}", FRICTION.search(BASE, laboratory, adaptive))
        return found.estimate, found.grid.rows


def compare(calibrations, number, laboratory):
    """Runs, half-widths and best values of the grid and of the search for one laboratory."""
    grid = calibrations.grid(laboratory)
    row = {"hidden": FRICTION.hidden[number], "grid_runs": FRICTION.points() * FRICTION.seeds,
           "grid_half_width": grid["half_width"], "grid_values": [p["values"] for p in grid["points"]]}
    if grid["half_width"] is None:
        return row
    found, runs = calibrations.search(number, laboratory, grid["half_width"])
    return {**row, "search_runs": runs, "search_half_width": found["half_width"],
            "search_values": [p["values"] for p in found["points"]]}


def main():
    parser = usual_options(__doc__, "calibration")
    parser.set_defaults(work=ROOT / "build" / "benchmarks" / "search")
    parser.add_argument("--ranks", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    calibrations = Calibrations(options)
    values = FRICTION.laboratory_values(calibrations.calibrate("hidden", FRICTION.laboratories(BASE)).directory)
    rows = []
    for number, laboratory in enumerate(values):
        rows.append(compare(calibrations, number, laboratory))
        print(rows[-1], flush=True)
        save(options.results / "search.json", rows=rows)


if __name__ == "__main__":
    main()
