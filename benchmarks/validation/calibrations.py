"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import contours
from bench import ROOT, save
from kept_runs import kept

CASES = {"carbohsp_friction": "calibrate_carbohsp_levels.toml", "sand_friction": "calibrate_sand_levels.toml",
         "carbohsp_restitution": "calibrate_carbohsp_restitution_levels.toml"}


def study(options):
    """The calibrations of the cases, one after the other; each with its picture."""
    for case in options.cases or CASES:
        name = f"calibration_{case}"
        with kept(options, name):
            _, content = contours.calibrate(options, name, ROOT / "input" / CASES[case])
        save(options.results / f"{name}.json", case=case, **content)
