"""The thesis's calibrations at reduced size: contours of its figures over its grids of coefficients.

The laboratory of each is the reduced test itself with the coefficients that the thesis found (those of the deck), so that the lines of
all figures should cross there; how they run tells what the test can and cannot tell apart."""

import json
import statistics
import tomllib

from bench import ROOT, Bench, flat_floor, print_table, repose, save, values_of, vessel
from repose import plots

LABORATORY_SEEDS, FIRST_SEED = 4, 101
SMALL = vessel("1.5 g", flat_floor(0.006, 0.051), 0.07)
SMALL_SAND = vessel("3 g", flat_floor(0.008, 0.052), 0.07)
# The file of the calibration at full size, whose parameters and figures are taken; the deck and its overrides
CASES = {
    "carbohsp_mono_friction": ("calibrate_carbohsp_friction.toml", "carbohsp_mono.toml", [*SMALL, "particles.0.spacing=770 um"]),
    "carbohsp_multi_friction": ("calibrate_carbohsp_multi_friction.toml", "carbohsp_multi.toml", SMALL),
    "sand_multi_friction": ("calibrate_sand_friction.toml", "sand_multi.toml", SMALL_SAND),
    "carbohsp_restitution": ("calibrate_carbohsp_restitution.toml", "scatter_mini.toml", []),
    "sand_restitution": ("calibrate_sand_restitution.toml", "scatter_sand.toml",
                         [*SMALL_SAND, "measurement.scattering.base_radius=12 mm", "measurement.scattering.area_3_radius=25 mm"]),
}


def laboratory(options, name, deck, sets, figures):
    """{figure: (mean, deviation)} of runs with the coefficients of the deck."""
    runs = {f"{name}_laboratory_{seed}": (deck, [*sets, "output.snapshot_interval=0", f"run.seed={FIRST_SEED + seed}"])
            for seed in range(LABORATORY_SEEDS)}
    summaries = Bench(options).run_all(runs)
    found = {}
    for figure in figures:
        values = values_of(summaries.values(), figure)
        found[figure] = (statistics.mean(values), statistics.stdev(values)) if len(values) > 1 else None
    return found


def coefficient(deck, key):
    """Of a deck, such as pair.0.restitution."""
    value = tomllib.loads((ROOT / "input" / deck).read_text())
    for part in key.split("."):
        value = value[int(part)] if part.isdigit() else value[part]
    return value


def deck_text(full, deck, sets, figures, seeds):
    text = (f'title = "{full["title"]}, reduced"\nbase = "{ROOT / "input" / deck}"\nseeds = {seeds}\n'
            f'set = {json.dumps([*sets, "output.snapshot_interval=0"])}\n')
    for parameter in full["parameter"]:
        text += "[[parameter]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in parameter.items())
    for observable in full["observable"]:
        if observable["figure"] not in figures:
            continue
        mean, deviation = figures[observable["figure"]]
        own = {**observable, "laboratory": mean, "deviation": deviation, "repeats": LABORATORY_SEEDS}
        text += "[[observable]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in own.items())
    return text


def study(options):
    """The calibrations of the cases, one after the other; each with its contours as pictures and its grid in the results."""
    rows = []
    for name in options.cases or CASES:
        file, deck, sets = CASES[name]
        full = tomllib.loads((ROOT / "input" / file).read_text())
        found = laboratory(options, name, deck, sets, [o["figure"] for o in full["observable"]])
        figures = {figure: value for figure, value in found.items() if value}
        path = options.work / f"contours_{name}.toml"
        path.write_text(deck_text(full, deck, sets, figures, options.seeds))
        calibration = repose.calibrate(path, options.work / f"contours_{name}", ranks=options.ranks, program=options.program)
        for figure in figures:
            plots.contours(calibration, figure).savefig(options.work / f"contours_{name}_{figure}.png", dpi=150)
        own = [{"parameter": p["name"], "thesis": coefficient(deck, p["key"]), "found": calibration.values[p["name"]]}
               for p in full["parameter"]]
        save(options.results / f"contours_{name}.json", case=name, laboratory=found, estimate=calibration.estimate, rows=own)
        rows += [{"case": name, **row, "verdict": calibration.estimate["verdict"]} for row in own]
    print_table(rows)
