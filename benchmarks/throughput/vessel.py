"""The vessel of the discharge test for the peers: triangles of a cylinder and its floor with a hole for LIGGGHTS; for
LAMMPS small grains along the rim of the hole, flush with the floor and the hole."""

import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from liggghts_files import turned, write_stl  # noqa: E402

RADIUS = 6e-3      # m, as in input/discharge_mini.toml
HOLE = 2e-3
HEIGHT = 60e-3
FLOOR_RINGS = 2
SIDE_RINGS = 2
RIM_RADIUS = 50e-6  # of the grains along the rim, one radius apart


def profile():
    """Points (r, z) from the rim of the hole to the top."""
    floor = [(HOLE + (RADIUS - HOLE) * i / FLOOR_RINGS, 0.0) for i in range(FLOOR_RINGS + 1)]
    return floor + [(RADIUS, HEIGHT * i / SIDE_RINGS) for i in range(1, SIDE_RINGS + 1)]


def write_mesh(path):
    write_stl(path, turned(profile()))


def rim():
    """Centres and radii of the grains along the rim."""
    count = round(2.0 * math.pi * HOLE / RIM_RADIUS)
    turn = 2.0 * math.pi * np.arange(count) / count
    r = HOLE + RIM_RADIUS
    position = np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(count, -RIM_RADIUS)])
    return position, np.full(count, RIM_RADIUS)
