"""What is compared: curves that a run left behind, each a name and its times (s) and values."""

import numpy as np

from inputs import repose

ENERGIES = ("translational_energy_J", "rotational_energy_J")
COLUMNS = {"KinEng": ENERGIES[0], "rotation": ENERGIES[1]}  # of the log of LIGGGHTS; the others keep their names


def snapshots(folder):
    """Time, position and material (by name) of each snapshot of a run, in the order of time."""
    for snapshot in repose.Run(folder).snapshots:
        yield snapshot.time_s, snapshot.position, snapshot.material_names


def repose_curves(case, folder):
    """The energies and what is left of the silo from series.csv, the rest from the snapshots."""
    series = repose.Run(folder).series
    curves = {key: (series["time_s"], series[key]) for key in ENERGIES}
    if case == "silo":
        return {**curves, "left": (series["time_s"], left(folder, series))}
    states = list(snapshots(folder))
    measured = {"height": height} if case == "penetration" else {
        f"{quadrant}_{kind}": count_in(kind, sign)
        for quadrant, sign in (("upper", 1.0), ("lower", -1.0)) for kind in ("M1", "M2")}
    times = np.array([time for time, _, _ in states])
    for name, value in measured.items():
        curves[name] = times, np.array([value(position, names) for _, position, names in states])
    return curves


def left(folder, series):
    """Grains above the lip: all are of one mass."""
    mass = float(repose.Run(folder).snapshots[0].mass[0])
    return np.round(series["particles"][0] - series["discharged_mass_kg"] / mass)


def height(position, names):
    return float(position[names == "steel", 2][0])


def count_in(kind, sign):
    """Grains of a kind in the quadrant x > 0, z > 0 of the drum's cross-section, or in the opposite one."""
    return lambda x, names: int(((names == kind) & (sign * x[:, 0] > 0.0) & (sign * x[:, 2] > 0.0)).sum())


def liggghts_curves(folder, dt):
    """The columns of the log, as far as the run has come."""
    lines = [line.split() for line in (folder / "log").read_text().splitlines()]
    begin = next(i for i, words in enumerate(lines) if words[:2] == ["Step", "Atoms"])
    rows = []
    for words in lines[begin + 1:]:
        if len(words) != len(lines[begin]) or not words[0].isdigit():
            break
        rows.append([float(word) for word in words])
    table = dict(zip(lines[begin], np.array(rows).T))
    return {COLUMNS.get(name, name): (table["Step"] * dt, values) for name, values in table.items()}
