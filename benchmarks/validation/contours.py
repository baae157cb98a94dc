"""The thesis's calibrations at reduced size: contours of its figures over its grids of coefficients.

The laboratory of each is the reduced test itself with the coefficients that the thesis found (those of the deck), so that the lines of
all figures should cross there; how they run tells what the test can and cannot tell apart."""

import json
import statistics
import sys

import numpy as np

from bench import ROOT, STOPPED, Bench, flat_floor, input_deck, places, print_table, repose, save, time_limit, values_of, vessel
from kept_runs import kept
from repose import plots
from repose.program import call

sys.path.insert(0, str(ROOT / "tests" / "regression"))
from laboratories import misfit_at  # noqa: E402

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
# Rings around the pile, mm: those of the decks, and wider and narrower ones
RINGS = {"carbohsp_restitution": ((10, 15), (10, 20), (10, 30), (10, None), (14, None), (18, None), (25, None), (35, None)),
         "sand_restitution": ((12, 17), (12, 25), (12, 40), (12, None), (18, None), (25, None), (35, None), (45, None))}
MIDDLE = (0.3, 0.7)  # of the restitution between grains: where its effects are told from


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
    value = input_deck(deck)
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


def crossings(calibration, truth):
    """A row for each point where the lines cross, with standard errors, and one that says whether the region has the
    coefficients behind the laboratory, and with which T."""
    estimate = calibration.estimate
    rows = [{"point": "crossing", **{name: f"{value:.3g} +- {error:.2g}" for name, value, error in
                                     zip(calibration.parameters, point["values"], point["standard_errors"])}}
            for point in estimate["points"]]
    if not estimate["points"]:
        rows.append({"point": "nearest", **{name: f"{value:.3g}" for name, value in calibration.values.items()}})
    misfit = misfit_at(estimate["surfaces"], truth)
    return [*rows, {"point": f"the deck's, {'in' if misfit <= estimate['limit'] else 'outside'} the region (T = {misfit:.3g})",
                    **{name: f"{value:.3g}" for name, value in zip(calibration.parameters, truth)}}]


def estimate_of(calibration):
    """estimate.json without the values on its lattices."""
    return {key: value for key, value in calibration.estimate.items() if key not in ("surfaces", "first_level_alone")}


def counts(state, observable):
    """Whether a run in this state counts for an observable, as in a calibration: one whose hole was plugged for the mass alone, unless
    that is one of flowing runs only."""
    is_mass = observable["figure"] in ("discharged_mass_kg", "retained_mass_kg")
    return state == "done" or (state == "plugged" and is_mass and not observable.get("flowing_only", False))


def mean_of(grid, rows, observable):
    """Of an observable over those of the rows of a grid that count and have it; None without any."""
    column = grid[observable["figure"]]
    values = [column[n] for n in rows if counts(grid["state"][n], observable) and not np.isnan(column[n])]
    return round(float(np.mean(values)), 7) if values else None


def rows_by_point(calibration):
    """The keys of a point, its parameters and the level if there are several, and {point: the numbers of its rows in the grid}."""
    grid = calibration.grid
    keys = [*calibration.parameters, *(["level"] if calibration.levels else [])]
    points = {}
    for number in range(grid.rows):
        points.setdefault(tuple(grid[key][number].item() for key in keys), []).append(number)
    return keys, points


def grid_rows(calibration):
    """A row for each point of the grid, with the means over its seeds and the state hashes of its runs."""
    grid = calibration.grid
    keys, points = rows_by_point(calibration)
    return [{**dict(zip(keys, point)), "state": " ".join(grid["state"][own]),
             **{observable["figure"]: mean_of(grid, own, observable) for observable in calibration.laboratory},
             "state_hash": [calibration.run(n).summary["state_hash"] for n in own if grid["state"][n] in ("done", "plugged")]}
            for point, own in points.items()]


def scatter_of_seeds(calibration):
    """A row for each level, or one where there are none, whose points have several seeds: the standard deviation of each figure from
    seed to seed, pooled over the points all of whose runs are done, which one whose hole was plugged is not, and have all figures."""
    grid, figures = calibration.grid, calibration.figures
    keys, points = rows_by_point(calibration)
    done = {}
    for point, own in points.items():
        if len(own) > 1 and all(grid["state"][n] == "done" and not np.isnan([grid[figure][n] for figure in figures]).any() for n in own):
            done.setdefault(point[len(calibration.parameters):], []).append(own)
    return [{**dict(zip(keys[len(calibration.parameters):], level)), "points": len(of_level),
             **{figure: float(np.sqrt(np.mean([np.var(grid[figure][own], ddof=1) for own in of_level]))) for figure in figures}}
            for level, of_level in done.items()]


def calibrate(options, name, path, rings=(), so_far=False):
    """A calibration over two parameters, drawn, beside the coefficients of its base; it and what is saved of it. What was stopped
    goes on. rings: those in which the grains of each run are counted. so_far: of one that is stopped by --time-limit, what its
    runs say until then."""
    try:
        calibration = repose.calibrate(path, options.work / name, ranks=options.ranks, program=options.program,
                                       options=time_limit(options))
    except repose.ReposeError as error:
        if not so_far or error.code != STOPPED:
            raise SystemExit(f"{name}: {error}") from None
        print(f"{name}: {error}")
        try:
            print(call(["estimate", options.work / name], program=options.program))
        except repose.ReposeError as too_few:
            raise SystemExit(f"{name}: {too_few}") from None
        calibration = repose.Calibration(options.work / name)
    finally:
        if rings:
            for summary in (options.work / name).glob("runs/*/summary.json"):
                count_in_rings(summary.parent, rings)
    plots.plane(calibration).savefig(options.work / f"{name}.png", dpi=100)
    deck = calibration.deck
    rows = crossings(calibration, [coefficient(deck["base"], p["key"]) for p in deck["parameter"]])
    scatter = scatter_of_seeds(calibration)
    print_table(rows)
    if scatter:
        print_table(scatter, digits=2)
    return calibration, {"estimate": estimate_of(calibration), "crossings": rows, "scatter_of_seeds": scatter,
                         "rows": grid_rows(calibration)}


def ring_name(low, high):
    return f"{low} to {high}" if high else f"beyond {low}"


def count_in_rings(folder, rings):
    """How many grains lie in rings around the axis at the end of a run, {name of the ring: number}; kept in its folder."""
    path = folder / "rings.json"
    if not path.exists():
        from_axis, above = places(repose.Run(folder).snapshots[-1])
        lying = 1e3 * from_axis[~above]
        path.write_text(json.dumps({ring_name(low, high): int(np.count_nonzero((lying >= low) & (lying < (high or np.inf))))
                                    for low, high in rings}))
    return json.loads(path.read_text())


def effects_by_ring(calibration, rings):
    """How the grains in a ring around the pile depend on both restitutions: slopes of the logarithm of their number, from the
    points with middling restitution between the grains, and the share of the wall's in both."""
    grid = calibration.grid
    chosen = [n for n in range(grid.rows) if grid["state"][n] == "done" and
              MIDDLE[0] - 1e-9 <= grid["restitution"][n] <= MIDDLE[1] + 1e-9]
    terms = np.array([[1.0, grid["restitution"][n], grid["wall_restitution"][n]] for n in chosen])
    counted = [count_in_rings(calibration.folders[n], rings) for n in chosen]
    rows = []
    for ring in counted[0]:
        counts = np.array([of_run[ring] for of_run in counted])
        logs = np.log(np.maximum(counts, 1))
        found, *_ = np.linalg.lstsq(terms, logs, rcond=None)
        rest = logs - terms @ found
        covariance = np.linalg.inv(terms.T @ terms) * (rest @ rest) / (len(logs) - 3)
        grains, wall = found[1:]
        own, walls = np.sqrt(np.diag(covariance)[1:])
        rows.append({"ring, mm": ring, "grains": int(np.median(counts)), "restitution": f"{grains:.2f} +- {own:.2f}",
                     "with the wall": f"{wall:.2f} +- {walls:.2f}", "wall's over both": f"{wall / (grains + wall):.2f}"})
    return rows


def study(options):
    """The calibrations of the cases, one after the other; each with its contours as a picture and its grid in the results."""
    for case in options.cases or CASES:
        name = f"contours_{case}"
        file, deck, sets = CASES[case]
        full = input_deck(file)
        rings = RINGS.get(case, ())
        with kept(options, name):
            found = laboratory(options, name, deck, sets, [o["figure"] for o in full["observable"]])
            figures = {figure: value for figure, value in found.items() if value}
            path = options.work / f"{name}.toml"
            path.write_text(deck_text(full, deck, sets, figures, options.seeds))
            calibration, content = calibrate(options, name, path, rings)
            effects = effects_by_ring(calibration, rings) if rings else []
        if effects:
            print_table(effects)
        save(options.results / f"{name}.json", case=case, seeds=options.seeds, laboratory=found, rings=effects, **content)
