"""Laboratories that are runs with hidden parameters: calibrations whose answer is known. For tests and benchmarks."""

import csv
import json
import math
import os
import statistics
from dataclasses import dataclass

REPEATS = 8  # runs of a laboratory
FIRST_SEED = 1001  # of the laboratories: seeds that no calibration uses

HEAD = 'base = "{base}"\nseeds = {seeds}\nfirst_seed = {first_seed}\nset = {sets}\n'
PARAMETER = '[[parameter]]\nname = "{0}"\nkey = "{1}"\nmin = {2}\nmax = {3}\n'
OBSERVABLE = ('[[observable]]\nfigure = "{figure}"\nlaboratory = {value}\ndeviation = {deviation}\nrepeats = {repeats}\n'
              'deviation_is_known = false\nscale = "{scale}"\n')


@dataclass
class Study:
    """The quick discharge test, what is calibrated in it from which figures, and the hidden sets of parameters."""

    sets: list  # overrides
    seeds: int
    parameters: list  # name, key, min, max, points of the grid
    figures: list
    scale: str
    hidden: list

    def points(self):
        return math.prod(points for *_, points in self.parameters)

    def grid(self, base, laboratory):
        """The deck of a calibration over the whole grid; laboratory: mean and deviation of each figure."""
        return self._deck(base, laboratory, self.seeds, 1, grid=True)

    def search(self, base, laboratory, adaptive):
        """The deck of an adaptive calibration in the same ranges; adaptive: its section's keys."""
        section = "[adaptive]\n" + "".join(f"{key} = {value}\n" for key, value in adaptive.items())
        return self._deck(base, laboratory, self.seeds, 1) + section

    def laboratories(self, base):
        """The deck of the runs with hidden parameters."""
        points = "".join(f"[[point]]\nvalues = {list(point)}\n" for point in self.hidden)
        return self._deck(base, [(1e-3, 1e-4)] * len(self.figures), REPEATS, FIRST_SEED) + points

    def laboratory_values(self, output):
        """For each hidden set, mean and deviation of each figure, from the runs of `laboratories` in that folder."""
        with open(os.path.join(output, "grid.csv")) as file:
            rows = list(csv.DictReader(file))
        values = []
        for k in range(len(self.hidden)):
            runs = rows[k * REPEATS:(k + 1) * REPEATS]
            samples = [[float(run[figure]) for run in runs] for figure in self.figures]
            values.append([(statistics.mean(s), statistics.stdev(s)) for s in samples])
        return values

    def _deck(self, base, laboratory, seeds, first_seed, grid=False):
        text = HEAD.format(base=base, seeds=seeds, first_seed=first_seed, sets=json.dumps(self.sets))
        for *parameter, points in self.parameters:
            text += PARAMETER.format(*parameter) + (f"points = {points}\n" if grid else "")
        for figure, (value, deviation) in zip(self.figures, laboratory):
            text += OBSERVABLE.format(figure=figure, value=value, deviation=deviation, repeats=REPEATS, scale=self.scale)
        return text


_QUICK = ["output.snapshot_interval=0"]
_PLATE = 0.04  # m below the orifice, as in the thesis

FRICTION = Study(
    sets=_QUICK, seeds=3, scale="linear",
    parameters=[("sliding_friction", "pair.0.sliding_friction", 0.2, 0.7, 5),
                ("rolling_friction", "pair.0.rolling_friction", 0.05, 0.35, 4)],
    figures=["discharged_mass_kg", "angle_of_repose_deg"],
    hidden=[(0.3, 0.12), (0.45, 0.25), (0.55, 0.1), (0.6, 0.2)])

RESTITUTION = Study(
    sets=_QUICK + [
        f"domain.min=[-0.05, -0.05, {-_PLATE - 1e-3}]", "domain.max=[0.05, 0.05, 0.04]",
        f"wall.plate.corner=[-0.05, -0.05, {-_PLATE}]", "wall.plate.edge_u=[0.1, 0.0, 0.0]",
        "wall.plate.edge_v=[0.0, 0.1, 0.0]", f"measurement.angle_of_repose.plate_height={-_PLATE}",
        f"measurement.scattering.plate_height={-_PLATE}", "measurement.scattering.base_radius=5 mm",
        "measurement.scattering.area_1_width=4 mm", "measurement.scattering.area_3_radius=10 mm",
        "phase.discharge.max_time=1 s", "pair.0.sliding_friction=0.7", "pair.0.rolling_friction=0.1"],
    seeds=8, scale="square_root",
    parameters=[("restitution", "pair.0.restitution", 0.4, 0.85, 4),
                ("wall_restitution", "pair.1.restitution", 0.2, 0.6, 3)],
    figures=["scattering.area_1.count", "scattering.area_3.count"],
    # A wall of 0.7 throws so few grains about the pile (44 in area 1 at 0.75) that they do not tell.
    hidden=[(0.55, 0.45), (0.6, 0.35), (0.7, 0.5), (0.75, 0.4)])


def misfit_at(surfaces, point):
    """The misfit between the nodes of its lattice, bilinear."""
    places = []
    for axis, value in zip((surfaces["x"], surfaces["y"]), point):
        place = (value - axis[0]) / (axis[-1] - axis[0]) * (len(axis) - 1)
        low = min(int(place), len(axis) - 2)
        places.append((low, place - low))
    (i, u), (j, v) = places
    t = surfaces["misfit"]
    return ((1 - u) * (1 - v) * t[j][i] + u * (1 - v) * t[j][i + 1] + (1 - u) * v * t[j + 1][i] + u * v * t[j + 1][i + 1])
