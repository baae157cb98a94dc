"""Mono-size sand in a flat-floored vessel and in conical ones: what stays, and whether a layer of it stands on the wall."""

import math

import matplotlib
import numpy as np

from bench import Bench, figures, repose, vessel, write

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

RADIUS, ORIFICE, DIAMETER = 11.0, 2.5, 0.765  # mm
HALF_ANGLES = (90, 60, 30)  # degrees from the axis; 90 is a flat floor
FRICTION = ((0.1, 0.1), (0.307, 0.462), (0.5, 0.6))  # between grains: corners of the thesis's range and its calibrated values


def profile(half_angle):
    """Points (r, z) in mm of the vessel from the orifice to the rim."""
    edge = (RADIUS - ORIFICE) / math.tan(math.radians(half_angle)) if half_angle < 90 else 0.0
    return [(ORIFICE, 0.0), (RADIUS, edge), (RADIUS, edge + 60.0)]


def sets(half_angle, sliding, rolling):
    return [*vessel("6 g", [(1e-3 * r, 1e-3 * z) for r, z in profile(half_angle)], 0.07), "particles.0.spacing=1 mm",
            f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}", "phase.discharge.max_time=12 s"]


def retained(folder):
    """Positions and radii in mm of the grains above the orifice in the last snapshot."""
    last = repose.Run(folder).snapshots[-1]
    position, radius = 1e3 * last.position, 1e3 * last.radius
    above = position[:, 2] > 0.0
    return position[above], radius[above]


def rim(position, radius, diameter):
    """By how many mm the grains at the cylinder's wall stand higher than those beside them: means of the tops of 24 sectors, in
    rings one diameter wide; None where either ring is not all around."""
    r, z = np.hypot(position[:, 0], position[:, 1]), position[:, 2]
    sector = np.floor(24 * (np.arctan2(position[:, 1], position[:, 0]) / (2 * math.pi) + 0.5)).astype(int) % 24
    tops = np.full((2, 24), -np.inf)
    ring = np.floor((radius - r) / diameter).astype(int)
    for k in (0, 1):
        np.maximum.at(tops[k], sector[ring == k], z[ring == k])
    return float(np.mean(tops[0] - tops[1])) if np.all(np.isfinite(tops)) else None


def draw(vessels, path):
    """What is left in each vessel, (title, half angle, folder): grains that a plane through the axis cuts, and the profile."""
    figure, axes = pyplot.subplots(1, len(vessels), figsize=(2.9 * len(vessels), 3.6), sharey=True, layout="constrained")
    for axis, (title, half_angle, folder) in zip(axes, vessels):
        for (x, y, z), radius in zip(*retained(folder)):
            if abs(y) < radius:
                cut = math.sqrt(radius**2 - y * y)
                axis.add_patch(pyplot.Circle((x, z), cut, facecolor="#d8c9a8", edgecolor="#6b5b3a", linewidth=0.4))
        for side in (-1, 1):
            axis.plot([side * r for r, _ in profile(half_angle)], [z for _, z in profile(half_angle)], color="#23395d")
        axis.set(title=title, xlabel="mm", aspect="equal", xlim=(-RADIUS - 1, RADIUS + 1), ylim=(-1, 19))
    axes[0].set_ylabel("mm")
    figure.savefig(path, dpi=90)
    print(f"wrote {path}")


def study(options):
    cases = {f"sand_{angle}_{sliding}_{rolling}": (angle, sliding, rolling)
             for angle in HALF_ANGLES for sliding, rolling in FRICTION}
    summaries = Bench(options).run_all({name: ("sand_mono.toml", sets(*case)) for name, case in cases.items()})
    rows = []
    for name, (angle, sliding, rolling) in cases.items():
        position, _ = retained(options.work / name)
        rows.append({"half angle": angle, "sliding": sliding, "rolling": rolling,
                     "discharged, g": figures(summaries[name])["discharged_g"], "plugged": summaries[name]["plugged"],
                     "grains left": len(position), "rim, mm": rim(position, RADIUS, DIAMETER)})
    write(options, "sand_layer", summaries, rows)
    drawn = [(f"flat floor, friction {s}, {r}", 90, options.work / f"sand_90_{s}_{r}") for s, r in FRICTION]
    draw([*drawn, ("cone of 60 degrees, any", 60, options.work / f"sand_60_{FRICTION[0][0]}_{FRICTION[0][1]}")],
         options.work / "sand_layer.png")
