"""The directory of a validation."""

import functools
import pathlib

from repose.files import ReposeError, read_json
from repose.run_directory import Run


class Validation:
    """What `repose validate FILE --output DIR` has left in DIR."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        if not self.is_complete and not self._folders():
            raise ReposeError(f"{directory}: is no directory of `repose validate`: it has neither validation.json nor "
                              "cases")

    def __repr__(self):
        return f"<Validation {self.directory}>"

    def _folders(self):
        return sorted(path.parent for path in self.directory.glob("*/deck.resolved.toml"))

    @property
    def is_complete(self):
        """Whether all cases of the last call are done: validation.json is written then."""
        return (self.directory / "validation.json").exists()

    @functools.cached_property
    def result(self):
        """validation.json: `title`, `published` (whose the published values are), `cases`, `build`."""
        if not self.is_complete:
            raise ReposeError(f"{self.directory}: has no validation.json: the cases are not complete")
        return read_json(self.directory / "validation.json")

    @property
    def title(self):
        return self.result["title"] if self.is_complete else ""

    @property
    def not_compared(self):
        """Names of cases that have begun and are not in validation.json, which an earlier call has written."""
        return sorted({folder.name for folder in self._folders()} - set(self.cases)) if self.is_complete else []

    @property
    def cases(self):
        """By name, the comparisons of each case: `figure`, `here` with `error`, `laboratory` with `deviation`,
        `published`; in the unit of the figure, None where there is none."""
        return {case["name"]: case["comparisons"] for case in self.result["cases"]}

    @property
    def runs(self):
        """The `Run` of each case, by its name; without validation.json those that have begun."""
        if self.is_complete:
            return {case["name"]: Run(self.directory / case["name"]) for case in self.result["cases"]}
        return {folder.name: Run(folder) for folder in self._folders()}
