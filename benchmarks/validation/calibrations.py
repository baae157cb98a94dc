"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import contours
from bench import ROOT, save

CASES = {"carbohsp_friction": "calibrate_carbohsp_levels.toml", "sand_friction": "calibrate_sand_levels.toml"}


def study(options):
    """The calibrations of the cases, one after the other; each with its picture."""
    for name in options.cases or CASES:
        _, content = contours.calibrate(options, f"calibration_{name}", ROOT / "input" / CASES[name])
        save(options.results / f"calibration_{name}.json", case=name, **content)
