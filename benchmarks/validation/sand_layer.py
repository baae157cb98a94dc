"""Mono-size sand in a flat-floored vessel and in conical ones: what stays, and whether it is one layer on the wall."""

import math

import h5py
import matplotlib
import numpy as np

from bench import Bench, figures, write

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

RADIUS, ORIFICE, DIAMETER = 11.0, 2.5, 0.765  # mm
MASS = "6 g"
HALF_ANGLES = (90, 60, 45, 30)  # degrees from the axis; 90 is a flat floor
FRICTION = ((0.1, 0.1), (0.307, 0.462), (0.5, 0.6))  # between grains: corners of the thesis's range and its calibrated values


def profile(half_angle):
    """Points (r, z) in mm of the vessel from the orifice to the rim."""
    edge = (RADIUS - ORIFICE) / math.tan(math.radians(half_angle)) if half_angle < 90 else 0.0
    return [(ORIFICE, 0.0), (RADIUS, edge), (RADIUS, edge + 60.0)]


def sets(half_angle, sliding, rolling):
    points = profile(half_angle)
    bottom, top = points[1][1], points[2][1]
    return ["particles.0.mass=" + MASS, f"particles.0.radius={RADIUS} mm", f"particles.0.centre=[0.0, 0.0, {1e-3 * bottom}]",
            "particles.0.height=58 mm", "particles.0.spacing=1 mm", f"domain.max=[0.07, 0.07, {1e-3 * top}]",
            f"wall.vessel.points={[[1e-3 * r, 1e-3 * z] for r, z in reversed(points)]}",
            f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}", "phase.discharge.max_time=12 s"]


def retained(folder):
    """Positions in mm of the grains above the orifice in the last snapshot."""
    last = max(folder.glob("run_*.hdf"))
    with h5py.File(last) as file:
        position = 1e3 * file["particles/position"][...]
    return position[position[:, 2] > 0.0]


def gap_to_wall(position, points):
    """Distance in mm of each centre from the vessel, less a radius."""
    r, z = np.hypot(position[:, 0], position[:, 1]), position[:, 2]
    nearest = np.full(len(position), np.inf)
    for (r0, z0), (r1, z1) in zip(points, points[1:]):
        along = np.clip(((r - r0) * (r1 - r0) + (z - z0) * (z1 - z0)) / ((r1 - r0) ** 2 + (z1 - z0) ** 2), 0.0, 1.0)
        nearest = np.minimum(nearest, np.hypot(r - r0 - along * (r1 - r0), z - z0 - along * (z1 - z0)))
    return nearest - 0.5 * DIAMETER


def draw(folders, path):
    """What is left in each vessel, {half angle: folder}: grains that a plane through the axis cuts, and the profile."""
    figure, axes = pyplot.subplots(1, len(folders), figsize=(3.2 * len(folders), 3.8), sharey=True, layout="constrained")
    for axis, (half_angle, folder) in zip(axes, folders.items()):
        for x, y, z in retained(folder):
            if abs(y) < 0.5 * DIAMETER:
                cut = math.sqrt((0.5 * DIAMETER) ** 2 - y * y)
                axis.add_patch(pyplot.Circle((x, z), cut, facecolor="#d8c9a8", edgecolor="#6b5b3a", linewidth=0.4))
        for side in (-1, 1):
            axis.plot([side * r for r, _ in profile(half_angle)], [z for _, z in profile(half_angle)], color="#23395d")
        axis.set(title="flat floor" if half_angle == 90 else f"half angle {half_angle} degrees", xlabel="mm", aspect="equal",
                 xlim=(-RADIUS - 1, RADIUS + 1), ylim=(-1, 22))
    axes[0].set_ylabel("mm")
    figure.savefig(path, dpi=100)
    print(f"wrote {path}")


def study(options):
    cases = {f"sand_{angle}_{sliding}_{rolling}": (angle, sliding, rolling)
             for angle in HALF_ANGLES for sliding, rolling in FRICTION}
    summaries = Bench(options).run_all({name: ("sand_mono.toml", sets(*case)) for name, case in cases.items()})
    rows = []
    for name, (angle, sliding, rolling) in cases.items():
        position = retained(options.work / name)
        in_layer = gap_to_wall(position, profile(angle)) < 0.5 * DIAMETER
        rows.append({"half angle": angle, "sliding": sliding, "rolling": rolling,
                     "discharged, g": figures(summaries[name])["discharged_g"], "plugged": summaries[name]["plugged"],
                     "grains left": len(position), "of them at the wall": int(in_layer.sum())})
    write(options, "sand_layer", summaries, rows)
    sliding, rolling = FRICTION[1]
    draw({angle: options.work / f"sand_{angle}_{sliding}_{rolling}" for angle in HALF_ANGLES}, options.work / "sand_layer.png")
