"""Curves that a calibration compares with those of a laboratory."""

import numpy as np

from repose.plots.plane import LABORATORY, REGION
from repose.plots.style import HEIGHT, WIDTH, new_figure
from repose.units import quantity


def curve(study, name):
    """The laboratory's curve of a `Calibration` with a band of two standard errors, what the components of the runs have
    of it, and the mean of the runs."""
    found = next(c for c in study.estimate["curves"] if c["name"] == name)
    (x_name, x_factor), (y_name, y_factor) = quantity(found["x_column"]), quantity(found["y_column"])
    x = x_factor * np.array(found["x"])
    laboratory, deviation, mean, projected = (
        y_factor * np.array(found[key]) for key in ("laboratory", "deviation", "mean", "projected_laboratory"))
    error = deviation / np.sqrt(found["repeats"])
    figure, axes = new_figure(figsize=(WIDTH, HEIGHT))
    axes.fill_between(x, laboratory - 2 * error, laboratory + 2 * error, color=LABORATORY, alpha=0.2)
    axes.plot(x, laboratory, "o", color=LABORATORY, markersize=3, label="laboratory")
    axes.plot(x, projected, color=REGION, label=f"its {len(found['components'])} components")
    axes.plot(x, mean, ":", color="0.4", label="mean of the runs")
    axes.set(xlabel=x_name, ylabel=y_name)
    axes.legend()
    return figure
