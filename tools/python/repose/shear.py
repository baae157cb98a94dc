"""A shear box whose moving half is a set of walls on a translation, or that move with one: shear stress over way, yield locus."""

import math

import numpy as np

from repose.compression import area_of, body_of, lid_of
from repose.files import ReposeError

STEADY = 0.5  # the last part of the way that gives the steady stresses


def moving_walls(deck, phase):
    """Names and velocity (m/s) of the walls that are moved in a phase."""
    names, velocity = [], None
    for wall in deck["wall"]:
        for motion in wall.get("motion", []):
            if motion["type"] == "translation" and phase in motion.get("phases", [phase]):
                names.append(wall["name"])
                velocity = np.asarray(motion["velocity"], float)
    if not names or not np.linalg.norm(velocity) > 0.0:
        raise ReposeError(f'no wall is moved in the phase "{phase}"')
    return body_of(deck, names), velocity


class Shear:
    """Stresses in the plane between the halves, at the height `plane` (m), from what the grains do to the moving one below it.

    way (m), shear, normal (Pa): arrays over the rows of the phase; steady_shear, steady_normal: means over the last half of
    the way; peak: greatest ratio of the two, over a tenth of the diameter."""

    def __init__(self, run, phase="shear", plane=0.0):
        names, velocity = moving_walls(run.deck, phase)
        phases = [section["name"] for section in run.deck["phase"]]
        loads, series = run.walls, run.series
        if loads is None or not run.snapshot_paths or phase not in phases:
            raise ReposeError(f'{run.directory}: has no walls.csv, no snapshot or no phase "{phase}"')
        rows = series["phase"] == phases.index(phase)
        snapshot = run.snapshots[-1]
        gravity = float(np.linalg.norm(run.deck["gravity"]))
        weight = gravity * float(snapshot["mass"][snapshot.position[:, 2] < plane].sum())
        along = velocity / np.linalg.norm(velocity)
        total = [sum(loads[f"{name}_force_{axis}_N"] for name in names)[rows] for axis in "xyz"]
        self.area = area_of(lid_of(run.deck))
        self.way = (loads["time_s"][rows] - loads["time_s"][rows][0]) * float(np.linalg.norm(velocity))
        self.shear = -sum(along[k] * total[k] for k in range(3)) / self.area
        self.normal = (-total[2] - weight) / self.area
        last = self.way >= (1.0 - STEADY) * self.way[-1]
        self.steady_shear, self.steady_normal = float(self.shear[last].mean()), float(self.normal[last].mean())
        width = max(1, int(np.searchsorted(self.way, 0.2 * float(snapshot.radius.mean()))))
        ratio = np.convolve(self.shear / self.normal, np.full(width, 1.0 / width), "valid")
        self.peak = float(ratio.max())

    @property
    def friction_deg(self):
        """The angle whose tangent is the steady shear stress over the normal one."""
        return math.degrees(math.atan2(self.steady_shear, self.steady_normal))


def yield_locus(runs):
    """(angle of internal friction in degrees, cohesion in Pa) of the line through the steady stresses of several `Shear`."""
    normal, shear = np.array([[run.steady_normal, run.steady_shear] for run in runs]).T
    slope, offset = np.polyfit(normal, shear, 1)
    return math.degrees(math.atan(slope)), float(offset)
