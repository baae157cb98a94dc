"""What a calibration knows of its parameters by samples of their joint density."""

import math

import numpy as np

from repose.files import read_table


class Posterior:
    """The posterior of a calibration with priors or more than three parameters.

    samples      `Table` with a column for each parameter, and `log_density` up to a constant
    marginals    of each parameter, by its name: `mean`, `deviation`, `median`, `interval`, `prior_deviation`,
                 `off_prior`, `determined`
    correlations between the parameters, in their order
    """

    def __init__(self, estimate, path):
        content = estimate["posterior"]
        self.samples = read_table(path)
        self._parameters = {p["name"]: p for p in estimate["parameters"]}
        self.marginals = dict(zip(self._parameters, content["marginals"]))
        self.correlations = np.array(content["correlations"], dtype=float)

    def prior_density(self, name, values):
        """Of a parameter at values within its range."""
        p = self._parameters[name]
        prior, low, high = p["prior"], p["min"], p["max"]
        if prior["kind"] == "uniform":
            return np.full(len(values), 1.0 / (high - low))
        mean, deviation = prior["mean"], prior["deviation"]
        of = lambda x: x  # noqa: E731
        slope = 1.0
        if prior["kind"] == "lognormal":
            variance = math.log1p((deviation / mean) ** 2)
            mean, deviation = math.log(mean) - 0.5 * variance, math.sqrt(variance)
            of, slope = np.log, 1.0 / values
        below = [0.5 * (1.0 + math.erf((of(end) - mean) / deviation / math.sqrt(2.0))) for end in (low, high)]
        density = np.exp(-0.5 * ((of(values) - mean) / deviation) ** 2) / (deviation * math.sqrt(2.0 * math.pi))
        return slope * density / (below[1] - below[0])
