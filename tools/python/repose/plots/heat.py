"""Heat of a run: temperatures and what walls give over time, and the grains by their temperature."""

import numpy as np

from repose.plots.course import mark_phases, over_time
from repose.plots.grains import Shade, seen
from repose.plots.style import HEIGHT, WIDTH, new_figure, styled
from repose.units import prefixed

TEMPERATURES = (("highest_temperature_K", "highest"), ("mean_temperature_K", "mean, by mass"), ("lowest_temperature_K", "lowest"))


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
    mark_phases(axes, run)
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
    """The grains by their temperature, as `grains` shows them. None of a snapshot without temperatures or grains."""
    if "temperature" not in snapshot.names:
        return None
    return seen(snapshot, axis, part, Shade(snapshot["temperature"], "temperature, K", "inferno"))
