"""The directory of a calibration."""

import functools

import numpy as np

from repose.files import read_table
from repose.posterior import Posterior
from repose.study import Study


class Surfaces:
    """What the runs say between themselves, on a lattice over two parameters.

    x, y        values of the first and the second parameter
    misfit      squared deviation from the laboratory, a row for each y
    limit       of the misfit in the confidence region
    mean, deviation     of each figure, by its name: in its unit, a row for each y
    laboratory_lines    of each figure, by its name: lines on which it has the laboratory's value; arrays with rows (x,
                        y)
    """

    def __init__(self, content):
        self.x, self.y = np.array(content["x"]), np.array(content["y"])
        self.misfit, self.limit = np.array(content["misfit"]), content["limit"]
        found = content["observables"]
        self.mean = {o["figure"]: np.array(o["mean"]) for o in found}
        self.deviation = {o["figure"]: np.array(o["deviation"]) for o in found}
        self.laboratory_lines = {o["figure"]: [np.array(line) for line in o["laboratory_lines"]] for o in found}


class Calibration(Study):
    """What `repose calibrate FILE --output DIR` has left in DIR."""

    result_file, deck_file, command = "estimate.json", "calibration.toml", "calibrate"

    @functools.cached_property
    def estimate(self):
        """estimate.json: `verdict`, `points` (calibrated `values` with `standard_errors`, in the order of
        `parameters`), `parts` of the confidence region with their `intervals`, `nearest`, `observables`, and with two
        parameters `surfaces`."""
        return self._result()

    @functools.cached_property
    def surfaces(self):
        """`Surfaces` over two parameters; None for another number of them."""
        return Surfaces(self.estimate["surfaces"]) if "surfaces" in self.estimate else None

    @functools.cached_property
    def first_level_surfaces(self):
        """`Surfaces` of what the cheapest level alone would say; None without levels or two parameters."""
        content = self.estimate.get("first_level_alone", {}).get("surfaces")
        return Surfaces(content) if content else None

    @functools.cached_property
    def posterior(self):
        """`Posterior` of the parameters; None where the region was not found by sampling."""
        return Posterior(self.estimate, self.directory / "posterior.csv") if "posterior" in self.estimate else None

    @functools.cached_property
    def search(self):
        """search.csv of a calibration with [adaptive]: a row after each batch with the `points` and `runs` so far,
        their `core_hours` and the `half_width` of the widest interval of the region over its range (NaN: there was no
        region); None without one."""
        path = self.directory / "search.csv"
        return read_table(path) if path.exists() else None

    @property
    def figures(self):
        """Names of the figures that are compared with the laboratory; a curve's are known when its runs are complete:
        NAME.1 and so on, its components."""
        if self.is_complete:
            return [observable["figure"] for observable in self.estimate["observables"]]
        return [o["figure"] for o in self.laboratory if not o["is_curve"]]

    @property
    def curves(self):
        """Names of the curves that are compared; known when the runs are complete."""
        return [c["name"] for c in self.estimate.get("curves", [])]

    @property
    def laboratory(self):
        """The observables of the deck, those of all experiments: as they were written, with `figure`, the name in
        tables, and `is_curve`."""
        found = [("", o) for o in self.deck.get("observable", [])]
        found += [(e["name"] + ".", o) for e in self.deck.get("experiment", []) for o in e["observable"]]
        return [{**o, "figure": before + o.get("figure", o.get("name", "")), "is_curve": "curve" in o}
                for before, o in found]

    def asked_rows(self, figure):
        """Which rows of `grid` are of the experiment that has a figure."""
        return np.array([self.is_asked(row, figure) for row in range(self.grid.rows)], dtype=bool)

    @property
    def values(self):
        """The calibrated values by parameter, of the first crossing or, without one, of the nearest point."""
        points = self.estimate["points"] or [self.estimate["nearest"]]
        return dict(zip(self.parameters, points[0]["values"]))

    @property
    def nearest_runs(self):
        """Rows of `grid` that are done, of the last level, in the order of their distance from `values` over the
        ranges."""
        answer = np.array([self.values[name] for name in self.parameters])
        ranges = np.array([p["max"] - p["min"] for p in self.estimate["parameters"]])
        points = np.column_stack([self.grid[name] for name in self.parameters])
        distance = np.linalg.norm((points - answer) / np.where(ranges > 0.0, ranges, 1.0), axis=1)
        usable = self.grid["state"] == "done"
        if self.levels:
            usable &= self.grid["level"] == self.estimate["levels"][-1]["name"]
        return [int(row) for row in np.argsort(distance, kind="stable") if usable[row]]
