"""What is compared: the columns over time that a run left behind."""

import csv
import re

import h5py
import numpy as np


def snapshots(folder):
    """Time, position and material (by name) of each snapshot of a run, in the order of time."""
    for path in sorted(folder.glob("run_*.hdf")):
        with h5py.File(path) as file:
            names = np.array([str(name) for name in file.attrs["materials"]])
            yield float(file.attrs["time_s"]), file["particles/position"][...], names[file["particles/material"][...]]


def repose_curves(case, folder):
    """Columns over time; of the silo and of energies from series.csv, else from the snapshots."""
    with open(folder / "series.csv") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    series = {key: np.array([row[key] for row in rows]) for key in rows[0]}
    curves = {"series_time_s": series["time_s"], "translational_energy_J": series["translational_energy_J"],
              "rotational_energy_J": series["rotational_energy_J"]}
    if case == "silo":
        with h5py.File(max(folder.glob("run_*.hdf"))) as file:
            mass = float(file["particles/mass"][0])
        return {**curves, "time_s": series["time_s"],
                "left": np.round(series["particles"][0] - series["discharged_mass_kg"] / mass)}
    states = list(snapshots(folder))
    curves["time_s"] = np.array([time for time, _, _ in states])
    if case == "penetration":
        curves["height"] = np.array([float(x[names == "steel", 2][0]) for _, x, names in states])
        return curves
    for kind in ("M1", "M2"):
        for quadrant, sign in (("upper", 1.0), ("lower", -1.0)):
            curves[f"{quadrant}_{kind}"] = np.array(
                [((names == kind) & (sign * x[:, 0] > 0.0) & (sign * x[:, 2] > 0.0)).sum() for _, x, names in states])
    return curves


def liggghts_curves(folder, dt):
    """The columns of the log, as far as the run has come."""
    log = (folder / "log").read_text()
    head, body = re.search(r"^\s*(Step Atoms.*?)\n(.*)", re.sub(r" +", " ", log), re.DOTALL | re.MULTILINE).groups()
    names = head.split()
    rows = [line.split() for line in body.splitlines()]
    stop = next((i for i, row in enumerate(rows) if len(row) != len(names) or not row[0].isdigit()), len(rows))
    table = dict(zip(names, np.array(rows[:stop], dtype=float).T))
    curves = {"time_s": table["Step"] * dt, "series_time_s": table["Step"] * dt, "translational_energy_J": table["KinEng"],
              "rotational_energy_J": table["rotation"], "wall_seconds": table["CPU"]}
    return {**curves, **{name: table[name] for name in names[5:]}}
