"""A bed under a lid with a servo: porosity and stiffness over stress."""

import math

import numpy as np

from repose.files import ReposeError, Table

LEAST_TURN = 0.06  # share of the stress by which it must turn back to count as a reversal
FITTED = (0.02, 0.12)  # the part of an unloading, by what the stress has fallen since the reversal, that gives its modulus


def lid_of(deck, name=None):
    """The wall with a servo that presses; by its name where there are several."""
    lids = [wall for wall in deck.get("wall", []) if name in (None, wall["name"]) and
            "servo" in wall and wall["servo"].get("type", "translation") == "translation"]
    if len(lids) != 1:
        raise ReposeError(f"{len(lids)} walls have a [wall.servo] that presses; name one of them" if name is None else
                          f'there is no wall "{name}" with a [wall.servo] that presses')
    return lids[0]


def area_of(lid):
    """m2, of a disc or a rectangle."""
    if lid["type"] == "disc":
        return math.pi * lid["radius"] ** 2
    if lid["type"] == "rectangle":
        return float(np.linalg.norm(np.cross(lid["edge_u"], lid["edge_v"])))
    raise ReposeError(f'the lid is a {lid["type"]}, which has no area of its own: give the area')


def body_of(deck, names):
    """The walls of these names, and behind them those that move with one of them."""
    return names + [wall["name"] for wall in deck["wall"] if wall.get("moves_with") in names]


def axis_of(lid):
    direction = np.asarray(lid["servo"]["direction"], float)
    return direction / np.linalg.norm(direction)


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
    """What walls.csv of a run says of the bed below its lid, from the moment at which the lid carries `least` Pa on.

    stress, strain, porosity, time_s: arrays over the rows; unloadings: Table of `stress_Pa`, `modulus_Pa`, `porosity`, `time_s`,
    `contacts` (of a grain with others) of every unloading, the last three as it begins; exponent, exponent_error: of the modulus
    over the stress, by a straight line between the logarithms; hertz_exponent, hertz_exponent_error: the same of the modulus over
    (solid share x contacts)^(2/3), which is 1/3 for Hertz's law where every contact bears alike (Walton 1987,
    doi:10.1016/0022-5096(87)90036-6)."""

    def __init__(self, run, lid=None, floor=0.0, area=None, least=None):
        wall = lid_of(run.deck, lid)
        axis, loads = axis_of(wall), run.walls
        if loads is None or not run.snapshot_paths:
            raise ReposeError(f"{run.directory}: has no walls.csv or no snapshot")
        name = wall["name"]
        force = -sum(axis[k] * loads[f"{one}_force_{'xyz'[k]}_N"] for one in body_of(run.deck, [name]) for k in range(3))
        self.area = area or area_of(wall)
        stress = force / self.area
        place = wall["centre"] if wall["type"] == "disc" else wall.get("corner", wall.get("point"))
        height = -float(np.dot(axis, place)) - floor - loads[f"{name}_way_m"]
        if least is None:
            least = 0.02 * stress.max()
        loaded = np.flatnonzero(stress >= least)
        if len(loaded) < 10:
            raise ReposeError(f'{run.directory}: the lid "{name}" carries {least:.3g} Pa in {len(loaded)} rows only')
        rows = slice(loaded[0], loaded[-1] + 1)
        self.stress, self.height, self.time_s = stress[rows], height[rows], loads["time_s"][rows]
        self.strain = -np.log(self.height / self.height[0])
        solid = 4.0 / 3.0 * math.pi * float((run.snapshots[-1].radius ** 3).sum())
        self.porosity = 1.0 - solid / (self.area * self.height)
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
