"""Heat of a run: temperatures and what walls give over time, and the grains by their temperature."""

import numpy as np
from matplotlib.collections import EllipseCollection

from repose.files import ReposeError
from repose.plots.course import mark_phases, over_time
from repose.plots.style import HEIGHT, WIDTH, new_figure, styled
from repose.units import prefixed

TEMPERATURES = (("highest_temperature_K", "highest"), ("mean_temperature_K", "mean, by mass"), ("lowest_temperature_K", "lowest"))
ACROSS = {"x": (1, 2), "y": (0, 2), "z": (0, 1)}  # what is seen along each axis: right and up


def powers(run):
    """What each wall that gives heat gives between two rows of walls.csv, W."""
    loads = run.walls
    if loads is None or loads.rows < 2:
        return {}
    names = [name[:-7] for name in loads if name.endswith("_heat_J")]
    return {name: np.diff(loads[f"{name}_heat_J"]) / np.diff(loads["time_s"]) for name in names
            if np.ptp(loads[f"{name}_heat_J"]) > 0.0}


@styled
def heat(run):
    """Temperatures of the grains over time, and below them the heat that each wall gives; None of a run without heat."""
    series = run.series
    if series is None or "mean_temperature_K" not in series:
        return None
    given = powers(run)
    figure, all_axes = new_figure(2 if given else 1, 1, sharex=True, squeeze=False,
                                  figsize=(WIDTH, (1.35 if given else 1.0) * HEIGHT))
    axes = all_axes[0, 0]
    inside = series["particles"] > 0
    for (name, label), style in zip(TEMPERATURES, (":", "-", "--")):
        axes.plot(series["time_s"], np.where(inside, series[name], np.nan), style, color="C3", label=label)
    axes.set_ylabel("temperature, K")
    axes.legend()
    mark_phases(axes, series, run.deck)
    if given:
        below = all_axes[1, 0]
        factor, unit = prefixed(max(np.abs(power).max() for power in given.values()), "W")
        for name, power in given.items():
            below.stairs(factor * power, run.walls["time_s"], baseline=None, label=name)
        below.set_ylabel(f"heat from walls, {unit}")
        below.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.3))
    over_time(all_axes[-1, 0], series)
    return figure


@styled
def temperatures(snapshot, axis="y", part=1.0):
    """The grains by their temperature as seen along an axis ("x", "y" or "z"), the nearest in front. `part`: share of the
    bed's depth that is shown, from its back on; 0.5 cuts it open in the middle. None of a snapshot without temperatures
    or grains."""
    if axis not in ACROSS:
        raise ReposeError(f'an axis is x, y or z, not "{axis}"')
    if "temperature" not in snapshot.names or len(snapshot) == 0:
        return None
    right, up = ACROSS[axis]
    depth = snapshot.position[:, 3 - right - up] * (1.0 if axis == "y" else -1.0)  # greater: farther behind
    shown = depth >= depth.max() - part * np.ptp(depth)
    order = np.flatnonzero(shown)[np.argsort(-depth[shown], kind="stable")]
    places = snapshot.position[order][:, (right, up)]
    radii = snapshot.radius[order]
    low, high = (places - radii[:, None]).min(axis=0), (places + radii[:, None]).max(axis=0)
    factor, unit = prefixed((high - low).max(), "m")
    width, height = factor * (high - low)
    scale = min(WIDTH / width, 1.6 * WIDTH / height)
    figure, axes = new_figure(figsize=(max(width * scale, 1.2) + 1.7, height * scale + 0.6))
    grains = EllipseCollection(2.0 * factor * radii, 2.0 * factor * radii, np.zeros(len(radii)), units="xy",
                               offsets=factor * places, offset_transform=axes.transData, array=snapshot["temperature"][order],
                               cmap="inferno", linewidths=0.1, edgecolors="0.3")
    axes.add_collection(grains)
    axes.set_xlim(factor * low[0], factor * high[0])
    axes.set_ylim(factor * low[1], factor * high[1])
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel(f"{'xyz'[right]}, {unit}")
    axes.set_ylabel(f"{'xyz'[up]}, {unit}")
    figure.colorbar(grains, label="temperature, K")
    return figure
