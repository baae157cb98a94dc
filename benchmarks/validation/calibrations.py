"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import tomllib

from bench import ROOT, print_table, repose, save
from contours import coefficient, crossings, estimate_of, grid_rows
from repose import plots

CASES = {"carbohsp_friction": "calibrate_carbohsp_levels.toml", "sand_friction": "calibrate_sand_levels.toml"}


def study(options):
    """The calibrations of the cases, one after the other; each with its picture. What was stopped goes on."""
    for name in options.cases or CASES:
        path = ROOT / "input" / CASES[name]
        limit = ["--time-limit", options.time_limit] if options.time_limit else []
        calibration = repose.calibrate(path, options.work / f"calibration_{name}", ranks=options.ranks, program=options.program,
                                       options=limit)
        plots.plane(calibration).savefig(options.work / f"calibration_{name}.png", dpi=100)
        deck = tomllib.loads(path.read_text())
        rows = crossings(calibration, [coefficient(deck["base"], p["key"]) for p in deck["parameter"]])
        print_table(rows)
        save(options.results / f"calibration_{name}.json", case=name, estimate=estimate_of(calibration), crossings=rows,
             rows=grid_rows(calibration))
