#!/usr/bin/python3
"""Four parameters from a discharge and a drum together, and from either alone; see README.md."""

import csv
import os
import statistics
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from report import ROOT, print_table, save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402

POINTS, SEEDS = 48, 2
REPEATS, FIRST_SEED = 8, 1001  # of the laboratories
PARAMETERS = {"sliding_friction": ("pair.0.sliding_friction", 0.2, 0.7),
              "rolling_friction": ("pair.0.rolling_friction", 0.05, 0.35),
              "wall_friction": ("pair.1.sliding_friction", 0.15, 0.6),
              "restitution": ("pair.0.restitution", 0.3, 0.7)}
HIDDEN = [(0.3, 0.12, 0.45, 0.5), (0.45, 0.25, 0.25, 0.4), (0.55, 0.1, 0.35, 0.6), (0.6, 0.2, 0.5, 0.45)]
# Of soft grains, whose steps are long.
TESTS = {"discharge": ("discharge_quick.toml", ["material.0.youngs_modulus=0.5 MPa", "material.1.youngs_modulus=0.5 MPa"],
                       ["discharged_mass_kg", "angle_of_repose_deg", "discharge_rate_kg_s"]),
         "drum": ("rotating_drum.toml",
                  ["particles.0.diameter=2 mm", "particles.0.spacing=2.2 mm", "particles.0.count=900",
                   "phase.turn.time=1.2", "measurement.surface_angle.from=0.6"],
                  ["surface_angle_deg"])}


def deck(laboratory, seeds, first_seed, end):
    """laboratory: mean and deviation of each figure."""
    text = f'set = ["output.snapshot_interval=0"]\nfirst_seed = {first_seed}\n'
    for name, (key, low, high) in PARAMETERS.items():
        text += f'[[parameter]]\nname = "{name}"\nkey = "{key}"\nmin = {low}\nmax = {high}\n'
    for test, (base, sets, figures) in TESTS.items():
        text += f'[[experiment]]\nname = "{test}"\nbase = "{ROOT / "input" / base}"\nseeds = {seeds}\nset = {sets}\n'
        for figure in figures:
            value, deviation = laboratory[figure]
            text += (f'[[experiment.observable]]\nfigure = "{figure}"\nlaboratory = {value}\ndeviation = {deviation}\n'
                     f"repeats = {REPEATS}\ndeviation_is_known = false\n")
    return text + end


def laboratories(options):
    """Of each hidden set the mean and deviation of each figure."""
    points = "".join(f"[[point]]\nvalues = {list(hidden)}\n" for hidden in HIDDEN)
    unknown = {figure: (1.0, 1.0) for _, _, figures in TESTS.values() for figure in figures}
    calibrate(options, "laboratories", deck(unknown, REPEATS, FIRST_SEED, points))
    with open(options.work / "laboratories" / "grid.csv") as file:
        rows = list(csv.DictReader(file))
    values = []
    for hidden in HIDDEN:
        own = [row for row in rows if all(abs(float(row[name]) - x) < 1e-9 for name, x in zip(PARAMETERS, hidden))]
        of = {figure: [float(row[f"{test}.{figure}"]) for row in own if row["experiment"] == test]
              for test, (_, _, figures) in TESTS.items() for figure in figures}
        assert all(len(samples) == REPEATS for samples in of.values())
        values.append({figure: (statistics.mean(samples), statistics.stdev(samples)) for figure, samples in of.items()})
    return values


def calibrate(options, name, text):
    path = options.work / f"{name}.toml"
    path.write_text(text)
    return repose.calibrate(path, options.work / name, ranks=options.ranks, program=options.program)


def is_in_region(posterior, names, hidden):
    """Whether the 95 % of the samples that are nearest to their mean, by their covariance, are as far from it."""
    samples = np.column_stack([posterior.samples[name] for name in names])
    mean, inverse = samples.mean(axis=0), np.linalg.inv(np.cov(samples.T))
    distance = lambda x: np.einsum("...i,ij,...j", x - mean, inverse, x - mean)  # noqa: E731
    return bool(distance(np.array(hidden)) <= np.quantile(distance(samples), 0.95))


def deviations(posterior):
    """Of each parameter, and of all: the fourth root of the volume of a region whose shape is that of the covariance."""
    each = [m["deviation"] for m in posterior["marginals"]]
    volume = np.prod(each) * np.sqrt(np.linalg.det(np.array(posterior["correlations"])))
    return {**dict(zip(PARAMETERS, each)), "all": float(volume ** (1 / len(each)))}


def main():
    parser = usual_options(__doc__, "calibration")
    parser.add_argument("--ranks", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    rows = []
    for hidden, laboratory in zip(HIDDEN, laboratories(options)):
        found = calibrate(options, "together",
                          deck(laboratory, SEEDS, 1, f"[adaptive]\nstart = {POINTS}\nbatch = 1\nbudget = {POINTS}\nhalf_width = 0.001\n"))
        alone = found.estimate["experiments_alone"]
        marginals = found.estimate["posterior"]["marginals"]
        rows.append({"hidden": dict(zip(PARAMETERS, hidden)), "laboratory": laboratory,
                     "verdict": found.estimate["verdict"],
                     "in_region": is_in_region(found.posterior, PARAMETERS, hidden),
                     "means": {name: m["mean"] for name, m in zip(PARAMETERS, marginals)},
                     "together": deviations(found.estimate["posterior"]),
                     **{test: deviations(alone[f"{test} alone"]["posterior"]) for test in TESTS}})
    save(options.results / "together.json", points=POINTS, seeds=SEEDS, rows=rows)
    print_table([{"parameter": name, "hidden": row["hidden"].get(name, ""), "found": row["means"].get(name, ""),
                  "± together": row["together"][name], "± discharge alone": row["discharge"][name],
                  "± drum alone": row["drum"][name], "in the region": "yes" if row["in_region"] else "no"}
                 for row in rows for name in [*PARAMETERS, "all"]])


if __name__ == "__main__":
    main()
