"""What the directories of calibrations and sensitivity studies have in common: runs over parameters, and their
table."""

import functools
import itertools
import math
import pathlib

import numpy as np

from repose.files import ReposeError, read_json, read_rows, read_table, read_text, read_toml
from repose.run_directory import Run

STATES = ("done", "plugged", "failed", "running", "waiting")
TEXTS = ("experiment", "level", "state", "reason")


class Study:
    """A directory with grid.csv and runs/. `result_file` is what is made of them, `deck_file` what was asked for."""

    result_file = deck_file = command = ""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        if not (self.directory / self.deck_file).exists():
            raise ReposeError(f"{directory}: is no directory of `repose {self.command}`: it has no {self.deck_file}")

    def __repr__(self):
        return f"<{type(self).__name__} {self.directory}>"

    @property
    def is_complete(self):
        """Whether there is a result of these parameters. It may be older than the newest runs."""
        path = self.directory / self.result_file
        return path.exists() and [parameter["name"] for parameter in read_json(path)["parameters"]] == self.parameters

    @property
    def has_grid(self):
        """Whether there is a table of runs over these parameters."""
        path = self.directory / "grid.csv"
        return path.exists() and set(self.parameters) <= set(read_rows(path)[0])

    @functools.cached_property
    def deck(self):
        """The file that it was started with, as a dict; its values are as they were written, texts with units among
        them."""
        return read_toml(self.directory / self.deck_file)

    @property
    def deck_text(self):
        """The file that it was started with, below a comment for each `--set` that it was given."""
        return read_text(self.directory / self.deck_file)

    @property
    def overrides(self):
        """Those `--set`s, as texts "key=value"."""
        lines = itertools.takewhile(lambda line: line.startswith("# --set "), self.deck_text.splitlines())
        return [line.removeprefix("# --set ") for line in lines]

    @property
    def title(self):
        return self.deck.get("title", "")

    def _result(self):
        if not self.is_complete:
            raise ReposeError(f"{self.directory}: has no {self.result_file} of {self.deck_file}: the runs are not complete")
        return read_json(self.directory / self.result_file)

    @functools.cached_property
    def parameters(self):
        """Names of the parameters, in the order of the file."""
        return [parameter["name"] for parameter in self.deck["parameter"]]

    @functools.cached_property
    def grid(self):
        """grid.csv: a row for each run with `experiment` and `level` (if there are several), the parameters, `seed`, `state` (done,
        plugged, failed, running, waiting), the figures in the units of their names (NaN: none) and the `reason` of a
        failure."""
        return read_table(self.directory / "grid.csv", TEXTS)

    def column(self, figure):
        """The values of a figure in the rows of `grid`, NaN: none; of a figure that only `repose estimate --deck` asked for, those of
        the runs."""
        if figure in self.grid:
            return self.grid[figure]
        values = [run.figure(figure.removeprefix(self.before(row)))
                  if run is not None and run.is_complete and self.is_asked(row, figure) else None for row, run in enumerate(self.runs)]
        return np.array([math.nan if value is None else value for value in values])

    def before(self, row):
        """What stands before the names of a row's figures."""
        return f"{self.grid['experiment'][row]}." if "experiment" in self.grid else ""

    def is_asked(self, row, figure):
        """Whether a row is of the experiment that has a figure."""
        return figure.startswith(self.before(row))

    @functools.cached_property
    def folders(self):
        """The folder of each row of `grid`."""
        names, rows = read_rows(self.directory / "grid.csv")
        place = {name: number for number, name in enumerate(names)}
        folders = []
        for row in rows:
            name = ",".join(f"{key}={row[place[key]]}" for key in [*self.parameters, "seed"])
            below = [row[place[key]] for key in ("experiment", "level") if key in place]
            folders.append(self.directory.joinpath("runs", *below, name))
        return folders

    def run(self, row):
        """The `Run` of a row of `grid`."""
        return Run(self.folders[row])

    @property
    def runs(self):
        """A `Run` for each row of `grid`; None for one that has not begun."""
        return [Run(folder) if (folder / "deck.resolved.toml").exists() else None for folder in self.folders]

    @property
    def states(self):
        """How many runs are done, plugged, failed, running and waiting."""
        state = self.grid["state"]
        return {name: int((state == name).sum()) for name in STATES}

    @property
    def levels(self):
        """Names of the levels of the model, the cheapest first; empty when there is one alone."""
        return list(dict.fromkeys(self.grid["level"].tolist())) if "level" in self.grid else []

    @property
    def experiments(self):
        """Names of the tests that share the parameters; empty when there is one alone."""
        return list(dict.fromkeys(self.grid["experiment"].tolist())) if "experiment" in self.grid else []
