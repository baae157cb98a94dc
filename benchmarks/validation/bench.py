"""What the studies share: runs, figures, tables, results."""

import json
import pathlib
import statistics
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, print_table, save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402

RESULTS = ROOT / "benchmarks" / "results" / "validation"  # what studies wrote, as the repository keeps it


class Bench:
    """Runs of the program, each in a folder of its own, as many at a time as there are cores."""

    def __init__(self, options):
        self.program, self.work = options.program, options.work
        self.cores = options.jobs

    def run(self, name, deck, sets):
        """The summary of one run; one that is complete is not run again, one that was stopped goes on."""
        try:
            run = repose.run(ROOT / "input" / deck, self.work / name, set=sets, program=self.program, restart=True)
        except repose.ReposeError as error:
            raise SystemExit(f"{name}: {error}") from None
        print(f"{name} is complete", flush=True)
        return run.summary

    def run_all(self, runs):
        """{name: summary} of {name: (deck, sets)}."""
        self.work.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(self.cores) as pool:
            return dict(zip(runs, pool.map(lambda name: self.run(name, *runs[name]), runs)))


def input_deck(name):
    """A deck of input/ as a dict."""
    return tomllib.loads((ROOT / "input" / name).read_text())


def measured(options, snapshot, deck, output, sets=()):
    """The figures that `repose measure` finds in a snapshot."""
    words = [word for override in sets for word in ("--set", override)]
    subprocess.run([options.program, "measure", snapshot, "--deck", deck, "--output", output, *words], check=True, capture_output=True)
    return json.loads((output / "measurement.json").read_text())


STOPPED = 75  # exit code of a run that was stopped with a checkpoint


def time_limit(options):
    """Words of the command line that stop a run in time, if that was asked for."""
    return ["--time-limit", options.time_limit] if options.time_limit else []


def places(snapshot):
    """How far each grain is from the axis, in m, and whether it is above the hole, where the vessel is."""
    return np.hypot(snapshot.position[:, 0], snapshot.position[:, 1]), snapshot.position[:, 2] > 0.0


def figures(summary):
    """What the studies compare, in the units of the thesis; None where a run has no such value."""
    def grams(kilograms):
        return None if kilograms is None else 1e3 * kilograms
    return {"discharged_g": grams(summary["discharged_mass_kg"]), "angle_deg": summary["angle_of_repose_deg"],
            "time_s": summary["discharge_time_s"], "rate_g_s": grams(summary["discharge_rate_kg_s"])}


def flat_floor(radius, height, hole=0.0025):
    """Points (r, z) in m of a cylinder from the hole in its floor, by default of 5 mm, to its rim. hole: its radius."""
    return [(hole, 0.0), (radius, 0.0), (radius, height)]


def vessel_wall(points):
    """The override that gives the vessel's wall these points (r, z) in m, hole first."""
    return f"wall.vessel.points={[list(point) for point in reversed(points)]}"


def vessel(mass, points, half_width):
    """The overrides that give a deck a vessel, filled up to 2 mm below its rim. points: (r, z) of its hole, of where its cylinder
    begins and of its rim; half_width: of the domain; all in m."""
    _, (radius, bottom), (_, top) = points
    return [f"particles.0.mass={mass}", f"particles.0.radius={1e3 * radius:g} mm", f"particles.0.centre=[0.0, 0.0, {bottom}]",
            f"particles.0.height={1e3 * (top - bottom) - 2:g} mm", f"domain.max=[{half_width}, {half_width}, {top}]",
            vessel_wall(points)]


# The override that measures the bulk density of the settled bed of 8 g in a cylinder of 10 to 12 mm
BULK_DENSITY = 'measurement.bulk_density={min=["-5 mm", "-5 mm", "1.5 mm"], max=["5 mm", "5 mm", "12 mm"]}'


def rayleigh_share(share):
    """The overrides that make the time step this share of the Rayleigh time, and half as much of the Hertz time."""
    return [f"time.rayleigh_fraction={share}", f"time.hertz_fraction={share / 2}"]


def modulus(value):
    """The overrides that give grains and walls this Young's modulus."""
    return [f"material.{index}.youngs_modulus={value}" for index in (0, 1)]


def names_by_seed(name, count):
    """{seed: name} of the runs that differ in their seed alone."""
    return {seed: f"{name}_{seed}" for seed in range(1, count + 1)}


def with_seeds(name, deck, sets, count):
    """{name: (deck, sets)} of a run with several seeds."""
    return {run: (deck, [*sets, f"run.seed={seed}"]) for seed, run in names_by_seed(name, count).items()}


def of_seeds(summaries, name, count):
    """The summaries of the runs of `with_seeds`."""
    return [summaries[run] for run in names_by_seed(name, count).values()]


def values_of(summaries, figure):
    """A figure of the runs that have it."""
    values = [repose.files.number_in(summary, figure) for summary in summaries]
    return [value for value in values if value is not None]


def spread(summaries, name, count, figure):
    """Mean and standard error of a figure over the runs of `with_seeds` that have it, and how many have."""
    return spread_of(values_of(of_seeds(summaries, name, count), figure))


def spread_of(values):
    """The same of values at hand."""
    error = statistics.stdev(values) / len(values) ** 0.5 if len(values) > 1 else None
    return {"mean": statistics.mean(values) if values else None, "standard_error": error, "runs": len(values)}


def identities(summaries):
    """What tells a run from any other."""
    return {name: {"state_hash": s["state_hash"], "steps": s["steps"], "particles": s["particles"]["inserted"]}
            for name, s in summaries.items()}


def shown(value, factor):
    """A spread as text, times a factor."""
    if value["mean"] is None:
        return "none"
    error = "" if value["standard_error"] is None else f" +- {factor * value['standard_error']:.2g}"
    return f"{factor * value['mean']:.4g}{error}"


# Figures of a summary: what a table calls them, and by what they are multiplied there
UNITS = {"discharged_mass_kg": ("discharged, g", 1e3), "angle_of_repose_deg": ("angle, degrees", 1.0),
         "scattering.area_1.count": ("area 1", 1.0), "scattering.area_3.count": ("area 3", 1.0),
         "discharge_time_s": ("discharge time, s", 1.0), "discharge_rate_kg_s": ("rate, g/s", 1e3),
         "bulk_density_kg_m3": ("bulk density, kg/m3", 1.0)}
SCATTERING = ("discharged_mass_kg", "angle_of_repose_deg", "scattering.area_1.count", "scattering.area_3.count")
DISCHARGE = ("discharged_mass_kg", "angle_of_repose_deg", "discharge_time_s", "discharge_rate_kg_s")


def spreads(summaries, name, count, figures):
    """{figure: its spread}."""
    return {figure: spread(summaries, name, count, figure) for figure in figures}


def row_of(found):
    """{figure: spread} as columns of a table."""
    return {name: shown(found[figure], factor) for figure, (name, factor) in UNITS.items() if figure in found}


def save_means(options, name, summaries, rows, **content):
    """The table of means over seeds, what else belongs to it and, for each run, what identifies it."""
    print_table(rows)
    save(options.results / f"{name}.json", seeds=options.seeds, **content, runs=identities(summaries), rows=rows)


def write(options, name, summaries, table):
    """The table of single runs and, for each, what identifies it and its figures."""
    runs = {key: {**identity, "wall_seconds": round(summaries[key]["wall_seconds"], 1), "ranks": summaries[key]["ranks"],
                  **figures(summaries[key])} for key, identity in identities(summaries).items()}
    print_table(table, digits=4)
    save(options.results / f"{name}.json", build=next(iter(summaries.values()))["build"], table=table, runs=runs)
