"""The vessel of the discharge test for the peers: triangles of a cylinder and its floor with a hole for LIGGGHTS; for
LAMMPS small grains along the rim of the hole, flush with the floor and the hole."""

import math

import numpy as np

SEGMENTS = 64      # of a turn
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


def triangles():
    turn = [2.0 * math.pi * k / SEGMENTS for k in range(SEGMENTS)] + [0.0]
    polygon = 2.0 / (1.0 + math.cos(math.pi / SEGMENTS))  # as far beyond the circle as within it
    points = [(polygon * r, z) for r, z in profile()]
    for (r1, z1), (r2, z2) in zip(points, points[1:]):
        for a, b in zip(turn, turn[1:]):
            p, q = (r1 * math.cos(a), r1 * math.sin(a), z1), (r1 * math.cos(b), r1 * math.sin(b), z1)
            s, t = (r2 * math.cos(a), r2 * math.sin(a), z2), (r2 * math.cos(b), r2 * math.sin(b), z2)
            yield p, q, s
            yield q, t, s


def write_mesh(path):
    with open(path, "w") as file:
        file.write("solid vessel\n")
        for corners in triangles():
            file.write("facet normal 0 0 0\nouter loop\n")
            for x, y, z in corners:
                file.write(f"vertex {x!r} {y!r} {z!r}\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid vessel\n")


def rim():
    """Centres and radii of the grains along the rim."""
    count = round(2.0 * math.pi * HOLE / RIM_RADIUS)
    turn = 2.0 * math.pi * np.arange(count) / count
    r = HOLE + RIM_RADIUS
    position = np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(count, -RIM_RADIUS)])
    return position, np.full(count, RIM_RADIUS)
