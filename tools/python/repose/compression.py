"""A bed under a lid: porosity and stiffness over stress."""

import math

import numpy as np

from repose.files import ReposeError, Table

LEAST_TURN = 0.06  # share of the stress by which it must turn back to count as a reversal
FITTED = (0.02, 0.12)  # the part of an unloading, by what the stress has fallen since the reversal, that gives its modulus


def turning_points(stress):
    """Rows at which the stress turns by more than LEAST_TURN of itself, first and last row included."""
    points, extreme, rising = [0], 0, None
    for k in range(1, len(stress)):
        if rising is None:
            if abs(stress[k] - stress[0]) > LEAST_TURN * max(stress[k], stress[0]):
                rising, extreme = stress[k] > stress[0], k
        elif (stress[k] > stress[extreme]) == rising:
            extreme = k
        elif abs(stress[k] - stress[extreme]) > LEAST_TURN * max(stress[k], stress[extreme]):
            points.append(extreme)
            rising, extreme = not rising, k
    return [*points, extreme, len(stress) - 1] if extreme not in (points[-1], len(stress) - 1) else [*points, len(stress) - 1]


class Compression:
    """What compression.csv of a run with [measurement.compression] says, from the moment at which the lid carries `least` Pa on.

    stress, strain, height, porosity, time_s: arrays over the samples; unloadings: Table of `stress_Pa`, `modulus_Pa`, `porosity`,
    `time_s`, `contacts` (of a grain with others) of every unloading, the last three as it begins; exponent, exponent_error: of the
    modulus over the stress, by a straight line between the logarithms; hertz_exponent, hertz_exponent_error: the same of the modulus
    over (solid share x contacts)^(2/3), which is 1/3 for Hertz's law where every contact bears alike (Walton 1987,
    doi:10.1016/0022-5096(87)90036-6)."""

    def __init__(self, run, least=None):
        samples = run.compression
        if samples is None:
            raise ReposeError(f"{run.directory}: has no compression.csv: its deck has no [measurement.compression]")
        if least is None:
            least = 0.02 * samples["stress_Pa"].max()
        loaded = np.flatnonzero(samples["stress_Pa"] >= least)
        if len(loaded) < 10:
            raise ReposeError(f"{run.directory}: the lid carries {least:.3g} Pa in {len(loaded)} samples only")
        rows = slice(loaded[0], loaded[-1] + 1)
        self.stress, self.height, self.porosity, self.time_s = (
            samples[name][rows] for name in ("stress_Pa", "height_m", "porosity", "time_s"))
        self.strain = -np.log(self.height / self.height[0])
        self.unloadings = self._unloadings(run.series)
        modulus = self.unloadings["modulus_Pa"]
        self.exponent, self.exponent_error = self._exponent(modulus)
        density = (1.0 - self.unloadings["porosity"]) * self.unloadings["contacts"]
        self.hertz_exponent, self.hertz_exponent_error = self._exponent(modulus / density ** (2.0 / 3.0))

    def _unloadings(self, series):
        contacts = 2.0 * series["pair_contacts"] / np.maximum(series["particles"], 1)
        points = turning_points(self.stress)
        found = []
        for begin, end in zip(points[:-1], points[1:]):
            fallen = 1.0 - self.stress[begin:end + 1] / self.stress[begin]
            part = begin + np.flatnonzero((fallen >= FITTED[0]) & (fallen <= FITTED[1]))
            if self.stress[end] >= self.stress[begin] or len(part) < 5:
                continue
            modulus = np.polyfit(self.strain[part], self.stress[part], 1)[0]
            found.append((self.stress[part].mean(), modulus, self.porosity[begin], self.time_s[begin],
                          np.interp(self.time_s[begin], series["time_s"], contacts)))
        columns = np.array(found).reshape(-1, 5).T
        return Table(zip(("stress_Pa", "modulus_Pa", "porosity", "time_s", "contacts"), columns))

    def _exponent(self, values):
        """Slope of the logarithm of values over that of stress, and its standard error."""
        if self.unloadings.rows < 3:
            return None, None
        x, y = np.log(self.unloadings["stress_Pa"]), np.log(values)
        slope, offset = np.polyfit(x, y, 1)
        rest = y - slope * x - offset
        return float(slope), float(math.sqrt((rest @ rest) / (len(x) - 2) / ((x - x.mean()) ** 2).sum()))
