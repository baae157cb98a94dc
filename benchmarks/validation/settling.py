"""Whether the beds of the calibrations by levels come to rest with a longer time step."""

import numpy as np

from bench import Bench, identities, print_table, rayleigh_share, repose, save

SHARES = (0.2, 0.3, 0.4)
# Restitutions of grains that are damped, and shares about those with which their beds come to rest; the scattering test has 0.71
DAMPED = {0.1: (0.1, 0.15, 0.2, 0.25), 0.2: (0.15, 0.2, 0.25, 0.3), 0.3: (0.2, 0.25, 0.3), 0.5: (0.25, 0.3, 0.4)}
CARBOHSP = ["pair.0.sliding_friction=0.75", "pair.0.rolling_friction=0.1625"]
CASES = {"carbohsp": ("carbohsp_mono.toml", CARBOHSP, None),  # deck, overrides, and the calibration with its level
         "carbohsp_less": ("carbohsp_mono.toml", CARBOHSP, ("calibrate_carbohsp_levels.toml", "less")),
         "carbohsp_whole": ("carbohsp_mono.toml", CARBOHSP, ("calibrate_carbohsp_restitution_levels.toml", "whole")),
         "sand": ("sand_multi.toml", [], None),
         "sand_less": ("sand_multi.toml", [], ("calibrate_sand_levels.toml", "less")),
         "sand_whole": ("sand_multi.toml", [], ("calibrate_sand_levels.toml", "whole")),
         **{f"carbohsp_restitution_{e:g}": ("scatter_carbohsp.toml", [f"pair.0.restitution={e}"],
                                            ("calibrate_carbohsp_restitution_levels.toml", "less")) for e in DAMPED}}
AFTER = 0.2  # s


def grains_of(calibration, name):
    """What a level of a calibration has otherwise than the test itself, but for its time step and what it measures."""
    level = next(level for level in input_deck(calibration)["level"] if level["name"] == name)
    return [key for key in level["set"] if not key.startswith(("time.", "measurement."))]


def shares_of(case):
    """The time steps of a case, over the Rayleigh time."""
    _, _, restitution = case.partition("restitution_")
    return DAMPED[float(restitution)] if restitution else SHARES


def study(options):
    """Grains that fall into their vessel and lie there until 0.2 s: what still moves with time steps of 20 to 40 % of the Rayleigh
    time and half as much of the Hertz time; with less restitution between grains, of 10 to 40 %."""
    cases = [(case, share) for case in options.cases or CASES for share in shares_of(case)]
    names = [f"settling_{case}_{share:g}" for case, share in cases]
    still = [f"phase.settle.max_time={AFTER}", "phase.settle.kinetic_energy=1e-30", "phase.discharge.min_time=1e-5",
             "phase.discharge.max_time=1e-5", "output.snapshot_interval=0", "output.series_interval=0.01"]
    runs = {}
    for name, (case, share) in zip(names, cases):
        deck, own, calibration = CASES[case]
        level = grains_of(*calibration) if calibration else []
        runs[name] = (deck, [*still, *own, *level, *rayleigh_share(share)])
    summaries = Bench(options).run_all(runs)
    rows = []
    for name, (case, share) in zip(names, cases):
        series = repose.Run(options.work / name).series
        settled = np.flatnonzero(series["phase"] == 0)[-1]  # the last row before the hole is opened
        grains = series["particles"][settled]
        rows.append({"bed": case, "of the Rayleigh time": share, "time step, us": 1e6 * summaries[name]["timestep_s"],
                     "contacts per grain": 2.0 * series["pair_contacts"][settled] / grains,
                     "translation, J/grain": series["translational_energy_J"][settled] / grains,
                     "rotation, J/grain": series["rotational_energy_J"][settled] / grains,
                     "bulk density, kg/m3": summaries[name]["bulk_density_kg_m3"]})
    print_table(rows, digits=4)
    for case in options.cases or CASES:
        own = {name: summaries[name] for name, (of_case, _) in zip(names, cases) if of_case == case}
        save(options.results / f"settling_{case}.json", runs=identities(own), rows=[row for row in rows if row["bed"] == case])
