"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import contours
import numpy as np
from bench import ROOT, input_deck, print_table, save
from kept_runs import kept

CASES = {"carbohsp_friction": "calibrate_carbohsp_levels.toml", "sand_friction": "calibrate_sand_levels.toml",
         "carbohsp_restitution": "calibrate_carbohsp_restitution_levels.toml"}


def means_at(surfaces, figure, x):
    """The means of a figure at a value of the first parameter, over the second: linear between those of the lattice."""
    return [np.interp(x, surfaces.x, row) for row in surfaces.mean[figure]]


def mean_at(surfaces, figure, x, y):
    """The mean of a figure at a point between those of the lattice, linear in both parameters."""
    return float(np.interp(y, surfaces.y, means_at(surfaces, figure, x)))


def along_the_first(calibration, count=7):
    """A row for each of some values of the first parameter, where there is one: the second with which the first figure is the
    laboratory's, and the other figures there; it and they grow with the second parameter."""
    surfaces, (first, *others) = calibration.surfaces, calibration.figures
    laboratory = calibration.estimate["observables"][0]["laboratory"]
    rows = []
    for x in np.linspace(surfaces.x[0], surfaces.x[-1], count):
        means = means_at(surfaces, first, x)
        if not min(means) <= laboratory <= max(means):
            continue
        y = float(np.interp(laboratory, means, surfaces.y))
        rows.append({**dict(zip(calibration.parameters, (float(x), y))),
                     **{figure: mean_at(surfaces, figure, x, y) for figure in others}})
    return rows


def above_the_cheapest(calibration, grid_rows):
    """A row for each point of the levels above the cheapest (of contours.grid_rows): its figures, and less what the surfaces of
    the cheapest have there."""
    surfaces = calibration.first_level_surfaces or calibration.surfaces
    rows = []
    for row in grid_rows:
        if row["level"] == calibration.levels[0] or not row["state_hash"]:
            continue
        x, y = (row[name] for name in calibration.parameters)
        rows.append({"level": row["level"], **dict(zip(calibration.parameters, (x, y)))})
        for figure in calibration.figures:
            if row[figure] is not None:
                rows[-1] |= {figure: row[figure],
                             f"{figure} less that of {calibration.levels[0]}": row[figure] - mean_at(surfaces, figure, x, y)}
    return rows


def scatter_of_seeds(calibration):
    """A row for each level whose points have several seeds: the standard deviation of each figure from seed to seed, pooled over
    the points all of whose runs are done, which one whose hole was plugged is not, and have all figures."""
    grid, rows = calibration.grid, []
    for level in calibration.levels:
        points = {}
        for n in np.flatnonzero(grid["level"] == level):
            points.setdefault(tuple(grid[name][n] for name in calibration.parameters), []).append(n)
        done = [own for own in points.values() if len(own) > 1 and all(
            grid["state"][n] == "done" and not np.isnan([grid[figure][n] for figure in calibration.figures]).any() for n in own)]
        if done:
            rows.append({"level": level, "points": len(done),
                         **{figure: float(np.sqrt(np.mean([np.var(grid[figure][own], ddof=1) for own in done])))
                            for figure in calibration.figures}})
    return rows


def slopes_of_counts(calibration, centre):
    """A row for each count and parameter: how the logarithm of the count grows with the parameter at a point, by least squares over
    the runs of the cheapest level that are done, weighted as counts scatter; its standard error, scaled by what the fit leaves over;
    both over the whole logarithm as 1, x, y, x^2, x y from that point."""
    grid, rows = calibration.grid, []
    own = (grid["state"] == "done") & (grid["level"] == calibration.levels[0])
    x, y = (grid[name][own] - middle for name, middle in zip(calibration.parameters, centre))
    terms = np.column_stack([np.ones_like(x), x, y, x * x, x * y])
    for figure in calibration.figures:
        counts = grid[figure][own]
        weighted = terms * np.sqrt(counts)[:, None]
        found, _, rank, _ = np.linalg.lstsq(weighted, np.log(counts) * np.sqrt(counts), rcond=None)
        if rank < terms.shape[1] or len(counts) <= rank:
            continue
        over = np.sum((terms @ found - np.log(counts)) ** 2 * counts) / (len(counts) - rank)
        errors = np.sqrt(np.diag(np.linalg.inv(weighted.T @ weighted)) * max(1.0, over))
        rows += [{"figure": figure, "parameter": name, "slope of the logarithm": found[k], "standard error": errors[k],
                  "count at the point": float(np.exp(found[0]))} for k, name in enumerate(calibration.parameters, 1)]
    return rows


def study(options):
    """The calibrations of the cases, one after the other; each with its picture; of one that is stopped what its runs say so far."""
    for case in options.cases or CASES:
        name = f"calibration_{case}"
        with kept(options, name):
            calibration, content = contours.calibrate(options, name, ROOT / "input" / CASES[case], so_far=True)
        differences, along = above_the_cheapest(calibration, content["rows"]), along_the_first(calibration)
        scatter = scatter_of_seeds(calibration)
        slopes = []
        if case == "carbohsp_restitution":
            slopes = slopes_of_counts(calibration, [pair["restitution"] for pair in input_deck("scatter_carbohsp.toml")["pair"]])
        for rows, digits in ((differences, 4), (along, 3), (scatter, 2), (slopes, 3)):
            if rows:
                print_table(rows, digits=digits)
        is_complete = calibration.states["waiting"] == 0
        save(options.results / f"{name}.json", case=case, is_complete=is_complete, above_the_cheapest=differences,
             along_the_first=along, scatter_of_seeds=scatter, **({"slopes_of_counts": slopes} if slopes else {}), **content)
        if not is_complete:
            raise SystemExit(f"{name} is not complete: the same command goes on")
