"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import contours
from bench import ROOT, save
from kept_runs import kept

CASES = {"carbohsp_friction": "calibrate_carbohsp_levels.toml", "sand_friction": "calibrate_sand_levels.toml",
         "carbohsp_restitution": "calibrate_carbohsp_restitution_levels.toml"}


def study(options):
    """The calibrations of the cases, one after the other; each with its picture; of one that is stopped what its runs say so far."""
    for case in options.cases or CASES:
        name = f"calibration_{case}"
        with kept(options, name):
            calibration, content = contours.calibrate(options, name, ROOT / "input" / CASES[case], so_far=True)
        is_complete = calibration.states["waiting"] == 0
        save(options.results / f"{name}.json", case=case, is_complete=is_complete, **content)
        if not is_complete:
            raise SystemExit(f"{name} is not complete: the same command goes on")
