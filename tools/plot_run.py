#!/usr/bin/python3
"""Draws the course of a run, finished or not, as PNG and PDF: discharge, energies, loads on the walls.

Usage: tools/plot_run.py DIR [--output DIR]

DIR is the output directory of a run; the pictures discharge, energies and walls are written beside its files, or to the
directory of --output. What the run does not have (no discharge measured, no wall touched) is not drawn.
"""
import argparse
import glob
import os
import sys
import tomllib

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first: there need not be a screen)

STYLE = {"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.frameon": False,
         "legend.fontsize": 8, "lines.linewidth": 1.3, "pdf.fonttype": 42, "figure.constrained_layout.use": True}
WIDTH, HEIGHT = 4.6, 3.0  # inches; a column and a half of a journal
ENERGIES = (("gravitational", "gravitational, above its least"), ("translational", "kinetic, translation"),
            ("rotational", "kinetic, rotation"), ("elastic", "elastic, contacts"))


def read_table(folder, name):
    """Columns of a CSV of the run by name; None when it has no rows yet."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return None
    table = np.atleast_1d(np.genfromtxt(path, delimiter=",", names=True, dtype=float))
    return table if len(table) > 0 else None


def read_deck(folder):
    with open(os.path.join(folder, "deck.resolved.toml"), "rb") as file:
        return tomllib.load(file)


def weight_of_grains(folder, gravity):
    """N, of the grains in the first snapshot; None without one."""
    snapshots = sorted(glob.glob(os.path.join(folder, "run_*.hdf")))
    if not snapshots:
        return None
    with h5py.File(snapshots[0]) as file:
        return float(file["particles/mass"][...].sum() * np.linalg.norm(gravity))


def scaled(values, unit):
    """The values and their unit with the prefix that makes the largest a number from 1 to 1000."""
    largest = float(np.max(np.abs(values)))
    for factor, prefix in ((1.0, ""), (1e3, "m"), (1e6, "µ"), (1e9, "n")):
        if largest * factor >= 1.0 or prefix == "n":
            return factor, prefix + unit


def phase_begins(series):
    """Time of the first row of each phase that has begun."""
    return {int(phase): time for phase, time in zip(series["phase"][::-1], series["time_s"][::-1])}


def is_present(wall, times, series, deck):
    """At each time: walls come and go as phases begin."""
    present = np.full(len(times), wall.get("present", True))
    for phase, begin in sorted(phase_begins(series).items()):
        for key, value in (("remove_walls", False), ("add_walls", True)):
            if wall["name"] in deck["phase"][phase].get(key, ()):
                present[times > begin] = value
    return present


def mark_phases(axes, series, deck):
    """A line where a phase begins, with its name behind it."""
    names = [phase["name"] for phase in deck["phase"]]
    for phase, begin in sorted(phase_begins(series).items()):
        if phase > 0:
            axes.axvline(begin, color="0.55", linewidth=0.8, linestyle=":")
        axes.annotate(names[phase], (begin, 1.0), xycoords=("data", "axes fraction"), xytext=(3, 2),
                      textcoords="offset points", fontsize=7.5, color="0.35")


def finish(figure, axes, series, path):
    axes.set_xlabel("time, s")
    axes.set_xlim(series["time_s"][0], max(series["time_s"][-1], 1e-12))
    for ending in ("png", "pdf"):
        figure.savefig(f"{path}.{ending}", dpi=200)
    plt.close(figure)
    print(f"{path}.png")


def draw_discharge(series, deck, path):
    """The mass below the orifice, what left through each exit, and the rate between two rows."""
    curves = [("discharged_mass_kg", "discharged")]
    curves += [(name, "left by " + name[5:-3]) for name in series.dtype.names if name.startswith("exit_")]
    curves = [(name, label) for name, label in curves if series[name].max() > 0.0]
    if not curves or len(series) < 2:
        return
    factor, unit = (1e3, "g") if max(series[name].max() for name, _ in curves) >= 1e-5 else (1e6, "mg")
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(WIDTH, 1.35 * HEIGHT), height_ratios=(3, 2))
    for name, label in curves:
        above.plot(series["time_s"], factor * series[name], label=label)
        rate = factor * np.diff(series[name]) / np.diff(series["time_s"])
        below.stairs(rate, series["time_s"], label=label, linewidth=1.0)
    above.set_ylabel(f"mass, {unit}")
    below.set_ylabel(f"rate, {unit}/s")
    for axes in (above, below):
        axes.set_ylim(bottom=0.0)
    if len(curves) > 1:
        above.legend()
    mark_phases(above, series, deck)
    finish(figure, below, series, path)


def draw_energies(series, deck, path):
    """All parts of the energy that are ever positive, on one logarithmic axis, for they differ by powers of ten."""
    figure, axes = plt.subplots(figsize=(WIDTH, HEIGHT))
    parts = [(series[f"{name}_energy_J"], label) for name, label in ENERGIES]
    parts[0] = (parts[0][0] - parts[0][0].min(), parts[0][1])  # its zero is at z = 0, which means nothing
    parts = [(np.where(energy > 0.0, energy, np.nan), label) for energy, label in parts if energy.max() > 0.0]
    if not parts:
        plt.close(figure)
        return
    for energy, label in parts:
        axes.semilogy(series["time_s"], energy, label=label)
    lowest, highest = (f([f(energy[np.isfinite(energy)]) for energy, _ in parts]) for f in (np.min, np.max))
    axes.set_ylim(max(0.3 * lowest, 1e-12 * highest), 3.0 * highest)
    axes.set_ylabel("energy, J")
    axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2))
    mark_phases(axes, series, deck)
    finish(figure, axes, series, path)


def draw_walls(loads, series, deck, folder, path):
    """The force on each wall along gravity."""
    gravity = np.array(deck["gravity"])
    down = gravity / np.linalg.norm(gravity) if gravity.any() else np.array((0.0, 0.0, -1.0))
    forces = {}
    for wall in deck["wall"]:
        column = wall["name"].replace("-", "")  # as numpy.genfromtxt names it
        force = sum(down[k] * loads[f"{column}_force_{'xyz'[k]}_N"] for k in range(3))
        if np.abs(force).max() > 0.0:
            forces[wall["name"]] = np.where(is_present(wall, loads["time_s"], series, deck), force, np.nan)
    if not forces:
        return
    weight = weight_of_grains(folder, gravity)
    factor, unit = scaled(np.array([*[np.nanmax(np.abs(f)) for f in forces.values()], weight or 0.0]), "N")
    figure, axes = plt.subplots(figsize=(WIDTH, HEIGHT))
    for name, force in forces.items():
        axes.plot(loads["time_s"], factor * force, label=name)
    if weight:
        axes.axhline(factor * weight, color="black", linewidth=0.8, linestyle="--", label="weight of all grains")
    axes.set_ylabel(f"force along gravity, {unit}")
    axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2))
    mark_phases(axes, series, deck)
    finish(figure, axes, series, path)


def main():
    arguments = argparse.ArgumentParser(description="draw the course of a run: discharge, energies, loads on the walls")
    arguments.add_argument("run", metavar="DIR", help="output directory of a run")
    arguments.add_argument("--output", metavar="DIR", help="where to put the pictures; default: beside the run")
    chosen = arguments.parse_args()
    output = chosen.output or chosen.run
    try:
        series, deck = read_table(chosen.run, "series.csv"), read_deck(chosen.run)
    except (OSError, tomllib.TOMLDecodeError) as error:
        sys.exit(f"plot_run.py: {chosen.run} is no directory of a run: {error}")
    if series is None:
        sys.exit(f"plot_run.py: {chosen.run}: series.csv has no rows")
    os.makedirs(output, exist_ok=True)
    loads = read_table(chosen.run, "walls.csv")
    with plt.rc_context(STYLE):
        draw_discharge(series, deck, os.path.join(output, "discharge"))
        draw_energies(series, deck, os.path.join(output, "energies"))
        if loads is not None:
            draw_walls(loads, series, deck, chosen.run, os.path.join(output, "walls"))


if __name__ == "__main__":
    main()
