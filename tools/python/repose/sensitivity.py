"""The directory of a sensitivity study."""

import functools

from repose.study import Study


class Sensitivity(Study):
    """What `repose sensitivity FILE --output DIR` has left in DIR."""

    result_file, deck_file, command = "sensitivity.json", "sensitivity.toml", "sensitivity"

    @functools.cached_property
    def result(self):
        """sensitivity.json: `one_at_a_time` and `morris`, lists of effects."""
        return self._result()

    @property
    def figures(self):
        """Names of the figures whose changes are looked at."""
        return list(self.deck["figures"])

    def effects(self, figure):
        """By parameter, what its way from `min` to `max` does to a figure, in the unit of the figure: `effect` with
        `standard_error`, and `lower` and `upper` with `mean`, `deviation` and `runs`."""
        return {e["parameter"]: e for e in self.result["one_at_a_time"] if e["figure"] == figure}

    def morris(self, figure):
        """By parameter, the effects of Morris over the range, in the unit of the figure: `mu_star` with
        `mu_star_error`, `mu`, `sigma`. Empty when the study has no [morris]."""
        return {e["parameter"]: e for e in self.result["morris"] if e["figure"] == figure}
