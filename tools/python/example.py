#!/usr/bin/python3
"""An example of the package repose: the figure of a paper from runs with several seeds.

Usage: tools/python/example.py DIR... [--output figure.pdf]

Left the discharged mass over time, mean and standard deviation over the runs; right the shape of the piles, with the
angle of repose. Made for runs of input/discharge_quick.toml, such as

    repose run input/discharge_quick.toml --set run.seed=2 --output results/seed_2
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from repose_needs import need  # noqa: E402

need("numpy", "h5py", "matplotlib")
import numpy as np  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

import repose  # noqa: E402


def discharge(runs):
    """Times in s, mean and standard deviation of the discharged mass in g, at the times that all runs have."""
    times = min((run.series["time_s"] for run in runs), key=lambda time: time[-1])
    masses = np.array([1e3 * np.interp(times, run.series["time_s"], run.series["discharged_mass_kg"]) for run in runs])
    return times, masses.mean(axis=0), masses.std(axis=0, ddof=1) if len(runs) > 1 else 0.0 * times


def pile_height(run, edges):
    """Mean height in mm of the highest grains of 24 sectors in each ring; NaN where there are none."""
    measured = run.deck["measurement"]["angle_of_repose"]
    plate, (x, y, _) = measured["plate_height"], measured["axis"]
    grains = run.snapshots[-1]
    below = grains.position[:, 2] < run.deck["measurement"]["discharge"]["orifice_height"]
    position, radius = grains.position[below] - (x, y, plate), grains.radius[below]
    ring = np.digitize(np.hypot(position[:, 0], position[:, 1]), edges) - 1
    sector = (12 * (np.arctan2(position[:, 1], position[:, 0]) / np.pi + 1.0)).astype(int) % 24
    tops = np.full((len(edges) - 1, 24), np.nan)
    for k, j, top in zip(ring, sector, 1e3 * (position[:, 2] + radius)):
        if 0 <= k < len(tops):
            tops[k, j] = np.fmax(tops[k, j], top)
    covered = np.isfinite(tops).sum(axis=1) >= 12
    return np.where(covered, np.nanmean(np.where(covered[:, None], tops, 0.0), axis=1), np.nan)


def angle_text(runs):
    """Mean of the angle and its standard error; the error within a run when there is one alone."""
    angles = np.array([run.figure("angle_of_repose_deg") for run in runs], dtype=float)
    error = angles.std(ddof=1) / len(runs) ** 0.5 if len(runs) > 1 else runs[0].error("angle_of_repose_deg")
    return f"angle of repose ({angles.mean():.1f} ± {error:.1f})°"


def draw(runs):
    figure = Figure(figsize=(6.9, 2.6), layout="constrained")
    left, right = figure.subplots(1, 2)
    times, mean, deviation = discharge(runs)
    left.fill_between(times, mean - deviation, mean + deviation, alpha=0.3, linewidth=0.0)
    left.plot(times, mean)
    left.set(xlabel="time, s", ylabel="discharged mass, g", ylim=(0.0, None), xlim=(0.0, times[-1]))
    edges = np.linspace(0.8e-3, 8e-3, 19)
    middle = 5e2 * (edges[1:] + edges[:-1])
    for run in runs:
        right.plot(middle, pile_height(run, edges), color="0.6", linewidth=0.8)
    right.plot(middle, np.mean([pile_height(run, edges) for run in runs], axis=0), color="C1")
    right.set(xlabel="distance from the axis, mm", ylabel="height of the pile, mm", ylim=(0.0, None))
    right.set_title(angle_text(runs), fontsize=9)
    return figure


def main():
    arguments = argparse.ArgumentParser(description="a figure of runs with several seeds")
    arguments.add_argument("runs", metavar="DIR", nargs="+")
    arguments.add_argument("--output", default="figure.pdf")
    chosen = arguments.parse_args()
    try:
        draw([repose.Run(folder) for folder in chosen.runs]).savefig(chosen.output, dpi=200)
    except repose.ReposeError as error:
        sys.exit(f"example.py: {error}")
    print(chosen.output)


if __name__ == "__main__":
    main()
