"""The thesis's calibrations at full size, by levels: the decks of input/, beside what the thesis found."""

import json

import contours
import numpy as np
from bench import RESULTS, ROOT, input_deck, print_table, save
from kept_runs import kept
from one_funnel import by_radius

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


def terms_at(point, centre):
    """Of the logarithm of a count at a point, or at many: 1, x, y, x^2, x y from the centre."""
    x, y = (value - middle for value, middle in zip(point, centre))
    return np.stack([np.ones_like(x), x, y, x * x, x * y], axis=-1)


def fits_of_counts(calibration, centre):
    """{figure: (coefficients, covariance)} of the logarithm of each count by terms_at: least squares over the runs of the cheapest
    level that are done, weighted as counts scatter; the covariance is scaled by what the fit leaves over. None for too few runs."""
    grid, fits = calibration.grid, {}
    own = (grid["state"] == "done") & (grid["level"] == calibration.levels[0])
    terms = terms_at([grid[name][own] for name in calibration.parameters], centre)
    for figure in calibration.figures:
        counts = grid[figure][own]
        weighted = terms * np.sqrt(counts)[:, None]
        found, _, rank, _ = np.linalg.lstsq(weighted, np.log(counts) * np.sqrt(counts), rcond=None)
        if rank < terms.shape[1] or len(counts) <= rank:
            return None
        over = np.sum((terms @ found - np.log(counts)) ** 2 * counts) / (len(counts) - rank)
        fits[figure] = found, np.linalg.inv(weighted.T @ weighted) * max(1.0, over)
    return fits


def slopes_of_counts(calibration, fits):
    """A row for each count and parameter: how the logarithm of the count grows with the parameter at the centre."""
    return [{"figure": figure, "parameter": name, "slope of the logarithm": found[k], "standard error": covariance[k, k] ** 0.5,
             "count at the point": float(np.exp(found[0]))}
            for figure, (found, covariance) in fits.items() for k, name in enumerate(calibration.parameters, 1)]


def runs_of_the_whole(calibration, centre):
    """Runs with all of the mass, around the circles of the laboratory's counts: the scattering test at full size (studies.py full),
    with the coefficients of its deck, and the runs that are done of the levels above the cheapest."""
    test = json.loads((RESULTS / "carbohsp_mono.json").read_text())
    counts = {row["figure"]: row["here"] for row in test["comparisons"]}
    runs = [{"level": "scattering test", "point": tuple(centre), "counts": {figure: counts[figure] for figure in calibration.figures},
             "state_hash": test["summary"]["state_hash"]}]
    grid = calibration.grid
    for n in np.flatnonzero((grid["state"] == "done") & (grid["level"] != calibration.levels[0])):
        runs.append({"level": str(grid["level"][n]), "point": tuple(float(grid[name][n]) for name in calibration.parameters),
                     "counts": {figure: float(grid[figure][n]) for figure in calibration.figures},
                     "state_hash": calibration.run(n).summary["state_hash"]})
    return runs


class Tie:
    """The counts of all of the mass as those of the cheapest level (of fits_of_counts) times one factor for each area, which the runs
    of runs_of_the_whole say; and what the laboratory's counts then say of both coefficients."""

    def __init__(self, calibration, fits, runs, centre):
        self.fits, self.centre = fits, np.array(centre, dtype=float)
        self.terms = terms_at(np.array([run["point"] for run in runs]).T, centre)
        self.factors, self.around, self.variance, self.wanted = {}, {}, {}, {}
        for observable in calibration.estimate["observables"]:
            figure = observable["figure"]
            counts, expected = np.array([run["counts"][figure] for run in runs]), np.exp(self.terms @ fits[figure][0])
            self.factors[figure] = float(counts.sum() / expected.sum())
            self.around[figure] = counts @ self.terms / counts.sum()
            self.variance[figure] = 1.0 / counts.sum() + (observable["standard_error"] / observable["laboratory"]) ** 2
            self.wanted[figure] = np.log(observable["laboratory"] / self.factors[figure])

    def rest(self, figure, x, y):
        """What the logarithm of the laboratory's count is above that at a point, or at many, and its variance: of the laboratory's
        mean, of the factor's counts and of the fit."""
        (found, own), terms = self.fits[figure], terms_at((x, y), self.centre)
        away = terms - self.around[figure]
        return self.wanted[figure] - terms @ found, self.variance[figure] + np.einsum("...i,ij,...j", away, own, away)

    def misfit(self, x, y):
        """T at a point, or at many: the squares of both rests over their variances."""
        rests = [self.rest(figure, x, y) for figure in self.fits]
        return sum(rest ** 2 / variance for rest, variance in rests)

    def crossing(self):
        """The point where both counts are the laboratory's and the covariance of its coefficients; None where they cross nowhere."""
        point = self.centre.copy()
        for _ in range(50):
            x, y = point - self.centre
            jacobian = np.array([[f[1] + 2.0 * f[3] * x + f[4] * y, f[2] + f[4] * x] for f, _ in self.fits.values()])
            rests = [self.rest(figure, *point) for figure in self.fits]
            point = point + np.linalg.solve(jacobian, [rest for rest, _ in rests])
        if not np.max(np.abs([rest for rest, _ in rests])) <= 1e-9:  # or the steps have run off
            return None
        inverse = np.linalg.inv(jacobian)
        return point, inverse @ np.diag([variance for _, variance in rests]) @ inverse.T

    def region(self, parameters, limit, count=401):
        """The least and the greatest value of each coefficient where T is below its limit, on a lattice over the ranges."""
        lattice = np.meshgrid(*(np.linspace(p["min"], p["max"], count) for p in parameters))
        inside = self.misfit(*lattice) <= limit
        return [(float(values[inside].min()), float(values[inside].max())) if inside.any() else None for values in lattice]


def tied_to_the_whole(calibration, fits, centre):
    """What the laboratory's counts say of both coefficients (Tie): the factors, a row for each run that they are from, and a row for
    each coefficient with its standard error and its extent in the region."""
    runs, estimate, rows = runs_of_the_whole(calibration, centre), calibration.estimate, []
    tie = Tie(calibration, fits, runs, centre)
    for run, at in zip(runs, tie.terms):
        rows.append({"level": run["level"], **dict(zip(calibration.parameters, run["point"]))})
        for figure, (found, _) in fits.items():
            rows[-1] |= {figure: run["counts"][figure], f"{figure} by the fit": tie.factors[figure] * np.exp(at @ found)}
        rows[-1]["state_hash"] = run["state_hash"]
    crossing = tie.crossing()
    regions = tie.region(estimate["parameters"], estimate["limit"])
    coefficients = []
    for k, (name, region) in enumerate(zip(calibration.parameters, regions)):
        coefficients.append({"coefficient": name})
        if crossing is not None:
            point, covariance = crossing
            coefficients[-1] |= {"value": float(point[k]), "standard error": float(covariance[k, k] ** 0.5)}
        if region is not None:
            coefficients[-1] |= {"region from": region[0], "to": region[1]}
    return {"factors": tie.factors, "runs": rows, "misfit of the thesis's": float(tie.misfit(*centre)), "coefficients": coefficients}


def study(options):
    """The calibrations of the cases, one after the other; each with its picture; of one that is stopped what its runs say so far."""
    for case in options.cases or CASES:
        name = f"calibration_{case}"
        with kept(options, name):
            calibration, content = contours.calibrate(options, name, ROOT / "input" / CASES[case], so_far=True)
        differences, along, of_case = [], [], {}
        if case != "carbohsp_restitution":
            differences, along = above_the_cheapest(calibration, content["rows"]), along_the_first(calibration)
            of_case["by_radius"] = by_radius(options, calibration)
        else:  # its levels count around piles of their own
            centre = [pair["restitution"] for pair in input_deck("scatter_carbohsp.toml")["pair"]]
            fits = fits_of_counts(calibration, centre)
            if fits:
                of_case = {"slopes_of_counts": slopes_of_counts(calibration, fits),
                           "tied_to_the_whole": tied_to_the_whole(calibration, fits, centre)}
        tied = of_case.get("tied_to_the_whole", {})
        for rows, digits in ((differences, 4), (along, 3), (of_case.get("by_radius"), 4), (of_case.get("slopes_of_counts"), 3),
                             (tied.get("runs"), 3), (tied.get("coefficients"), 3)):
            if rows:
                print_table(rows, digits=digits)
        is_complete = calibration.states["waiting"] == 0
        save(options.results / f"{name}.json", case=case, is_complete=is_complete, above_the_cheapest=differences,
             along_the_first=along, **of_case, **content)
        if not is_complete:
            raise SystemExit(f"{name} is not complete: the same command goes on")
