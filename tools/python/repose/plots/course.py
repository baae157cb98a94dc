"""The course of a run, finished or not: discharge, energies, loads on the walls."""

import numpy as np

from repose.plots.style import HEIGHT, WIDTH, new_figure, styled
from repose.units import prefixed

ENERGIES = (("gravitational", "gravitational, above its least"), ("translational", "kinetic, translation"),
            ("rotational", "kinetic, rotation"), ("elastic", "elastic, contacts"))
LETTER = 0.016  # of the width of a picture, that a letter of a phase's name takes
MOST_STEPS = 1000  # of the rate: a picture shows no more


def weight_of_grains(run):
    """N, of the grains in the snapshot that has the most of them; None without one."""
    fullest = max(run.snapshots, key=len, default=None)
    return None if fullest is None else float(fullest.mass.sum() * np.linalg.norm(run.deck["gravity"]))


def first_rows(series):
    """Time of the first row of each phase that has begun; of one too short for a row that of the next phase."""
    phases = np.arange(series["phase"][-1] + 1)
    return series["time_s"][np.searchsorted(series["phase"], phases)]


def phase_begins(run):
    """When each phase has begun, by the steps of those before it; while the run is not complete, by the first rows."""
    if not run.is_complete:
        return first_rows(run.series)
    steps = [phase["steps"] for phase in run.summary["phases"]]
    return run.summary["timestep_s"] * np.cumsum([0, *steps])[:len(steps)]


def is_present(wall, times, begins, deck):
    """At each time: walls come and go as phases begin."""
    present = np.full(len(times), wall.get("present", True))
    for phase, begin in zip(deck["phase"], begins):
        for key, value in (("remove_walls", False), ("add_walls", True)):
            if wall["name"] in phase.get(key, ()):
                present[times > begin] = value
    return present


def rows_of_names(places, lengths):
    """For names that begin at these places, which rise: the lowest row in which each touches none before it."""
    ends, rows = [], []
    for place, length in zip(places, lengths):
        row = next((row for row, end in enumerate(ends) if end <= place), len(ends))
        ends[row:row + 1] = [place + length]
        rows.append(row)
    return rows


def mark_phases(axes, run):
    """A line where a phase begins, with its name behind it; above another name where that would be covered."""
    start, end = (run.series["time_s"][row] for row in (0, -1))
    names = {begin: phase["name"] for phase, begin in zip(run.deck["phase"], phase_begins(run))}
    rows = rows_of_names([begin / max(end - start, 1e-12) for begin in names],
                         [LETTER * (len(name) + 1) for name in names.values()])
    for (begin, name), row in zip(names.items(), rows):
        if begin > start:
            axes.axvline(begin, color="0.55", linewidth=0.8, linestyle=":")
        axes.annotate(name, (begin, 1.0), xycoords=("data", "axes fraction"), xytext=(3, 2 + 9 * row),
                      textcoords="offset points", fontsize=7.5, color="0.35")


def over_time(axes, series):
    axes.set_xlabel("time, s")
    axes.set_xlim(series["time_s"][0], max(series["time_s"][-1], 1e-12))


@styled
def discharge(run):
    """The mass below the orifice, what left through each exit, and the rate between two rows; of long series between
    every few."""
    series = run.series
    if series is None or series.rows < 2:
        return None
    curves = [("discharged_mass_kg", "discharged")]
    curves += [(name, "left by " + name[5:-3]) for name in series if name.startswith("exit_")]
    curves = [(name, label) for name, label in curves if series[name].max() > 0.0]
    if not curves:
        return None
    factor, unit = (1e3, "g") if max(series[name].max() for name, _ in curves) >= 1e-5 else (1e6, "mg")
    figure, (above, below) = new_figure(2, 1, sharex=True, figsize=(WIDTH, 1.35 * HEIGHT), height_ratios=(3, 2))
    step = -(-series.rows // MOST_STEPS)
    for name, label in curves:
        above.plot(series["time_s"], factor * series[name], label=label)
        time, mass = series["time_s"][::step], factor * series[name][::step]
        below.stairs(np.diff(mass) / np.diff(time), time, label=label, linewidth=1.0)
    above.set_ylabel(f"mass, {unit}")
    below.set_ylabel(f"rate, {unit}/s")
    for axes in (above, below):
        axes.set_ylim(bottom=0.0)
    if len(curves) > 1:
        above.legend()
    mark_phases(above, run)
    over_time(below, series)
    return figure


@styled
def energies(run):
    """All parts of the energy that are ever positive, on one logarithmic axis, for they differ by powers of ten."""
    series = run.series
    if series is None:
        return None
    parts = [(series[f"{name}_energy_J"], label) for name, label in ENERGIES]
    parts[0] = (parts[0][0] - parts[0][0].min(), parts[0][1])  # its zero is at z = 0, which means nothing
    parts = [(np.where(energy > 0.0, energy, np.nan), label) for energy, label in parts if energy.max() > 0.0]
    if not parts:
        return None
    figure, axes = new_figure()
    for energy, label in parts:
        axes.semilogy(series["time_s"], energy, label=label)
    lowest, highest = (f([f(energy[np.isfinite(energy)]) for energy, _ in parts]) for f in (np.min, np.max))
    axes.set_ylim(max(0.3 * lowest, 1e-12 * highest), 3.0 * highest)
    axes.set_ylabel("energy, J")
    axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2))
    mark_phases(axes, run)
    over_time(axes, series)
    return figure


def forces_along_gravity(run, loads):
    """Of each wall that is touched, with those that move with it, in N, at the times that it is there."""
    gravity = np.array(run.deck["gravity"])
    down = gravity / np.linalg.norm(gravity) if gravity.any() else np.array((0.0, 0.0, -1.0))
    forces, begins = {}, phase_begins(run)
    walls = run.deck.get("wall", ())
    for wall in walls:
        if wall.get("moves_with"):
            continue
        body = [wall["name"], *(other["name"] for other in walls if other.get("moves_with") == wall["name"])]
        force = sum(down[k] * loads[f"{name}_force_{'xyz'[k]}_N"] for name in body for k in range(3))
        if np.abs(force).max() > 0.0:
            forces[wall["name"]] = np.where(is_present(wall, loads["time_s"], begins, run.deck), force, np.nan)
    return forces


@styled
def walls(run):
    """The force on each wall along gravity."""
    series, loads = run.series, run.walls
    forces = forces_along_gravity(run, loads) if series is not None and loads is not None else None
    if not forces:
        return None
    weight = weight_of_grains(run)
    factor, unit = prefixed(max(*[np.nanmax(np.abs(f)) for f in forces.values()], weight or 0.0), "N")
    figure, axes = new_figure()
    for name, force in forces.items():
        axes.plot(loads["time_s"], factor * force, label=name)
    if weight:
        axes.axhline(factor * weight, color="black", linewidth=0.8, linestyle="--", label="weight of all grains")
    axes.set_ylabel(f"force along gravity, {unit}")
    axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2))
    mark_phases(axes, run)
    over_time(axes, series)
    return figure
