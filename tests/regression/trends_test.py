"""The trends of the thesis (sections 3.3.3 and 3.6) in small, between far corners: five seeds of input/scatter_mini.toml at
each point. An effect is the difference of two means, its error that of the difference by the scatter of the seeds. What
docs/validation.md says about trends is what this prints. 40 runs of minutes: those in FOLDER that are complete are not run
again.

Grains are counted on the same circles in all runs, 10 to 15 mm and beyond 17 mm from the axis, and in a ring of 5 mm beside each
pile's own base, which is how the thesis defines its area 1: small piles grow wider when grains bounce more.

Usage: trends_test.py EXECUTABLE MPIEXEC SOURCE_DIR [FOLDER]
"""

import glob
import json
import math
import os
import statistics
import sys

from repose_runs import Program, folder_of_runs

SEEDS = range(1, 6)
FRICTION = [(sliding, rolling, 0.5, 0.6) for sliding in (0.1, 0.9) for rolling in (0.1, 0.5)]
BETWEEN_GRAINS = [(0.7, 0.3, e, 0.6) for e in (0.1, 0.9)]
WITH_WALL = [(0.7, 0.3, 0.5, e) for e in (0.1, 0.9)]
DECK = "scatter_mini.toml"
AREA_3 = "measurement.scattering.area_3_radius=17 mm"
FEWEST = 200  # grains in a count that is compared


def overrides(point, seed):
    sliding, rolling, between_grains, with_wall = point
    return (f"run.seed={seed}", f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}",
            f"pair.0.restitution={between_grains}", f"pair.1.restitution={with_wall}")


def figures(program, folder, summary):
    """The figures of a run; None for what it has not got."""
    base = summary["scattering"]["base_diameter_m"]
    on_circles = measured(program, folder)
    beside = measured(program, folder, f"measurement.scattering.base_radius={0.5 * base}") if base is not None else None
    return {"mass, g": 1e3 * summary["discharged_mass_kg"], "angle, degrees": summary["angle_of_repose_deg"],
            "area 1": on_circles["area_1"]["count"], "beside the base": beside and beside["area_1"]["count"],
            "area 3": on_circles["area_3"]["count"]}


def measured(program, folder, *overrides):
    """The scattering in a run's last snapshot."""
    arguments = ["measure", max(glob.glob(os.path.join(folder, "run_*.hdf"))), "--deck", program.deck(DECK), "--output", folder]
    for override in (AREA_3, *overrides):
        arguments += ["--set", override]
    done = program.call(*arguments)
    assert done.returncode == 0, done.stderr
    with open(os.path.join(folder, "measurement.json")) as file:
        return json.load(file)["scattering"]


class Sample:
    """The values of the seeds at a point; None where a run has none (no pile, no angle)."""

    def __init__(self, values):
        self.values = values
        self.complete = all(v is not None for v in values)

    def mean(self):
        return statistics.mean(self.values)

    def error(self):
        return statistics.stdev(self.values) / math.sqrt(len(self.values))

    def __str__(self):
        if self.complete:
            return f"{self.mean():.4g} +- {self.error():.2g}"
        return f"none in {sum(v is None for v in self.values)} of {len(self.values)}"


class Effect:
    def __init__(self, value, error):
        self.value, self.error = value, error

    def __sub__(self, other):
        return Effect(self.value - other.value, math.hypot(self.error, other.error))

    def __str__(self):
        return f"{self.value:+.4g} +- {self.error:.2g} ({self.value / self.error:+.1f} errors)"


def effect(lower, upper):
    return Effect(upper.mean() - lower.mean(), math.hypot(upper.error(), lower.error()))


def relative_effect(lower, upper):
    """Of the logarithm of a count."""
    return Effect(math.log(upper.mean() / lower.mean()),
                  math.hypot(upper.error() / upper.mean(), lower.error() / lower.mean()))


def print_table(samples):
    names = list(next(iter(samples.values())))
    print("| sliding | rolling | restitution | with the wall | " + " | ".join(names) + " |")
    print("|" + "---|" * (4 + len(names)))
    for point, sample in samples.items():
        print("| " + " | ".join(map(str, point)) + " | " + " | ".join(map(str, sample.values())) + " |")


def counted(sample, area):
    assert sample[area].mean() >= FEWEST, (area, str(sample[area]))
    return sample[area]


def trends(samples):
    """Name and effect of each, positive when it is that of the thesis."""
    low_low, low_high, high_low, high_high = (samples[point] for point in FRICTION)
    yield "more friction, less mass", effect(high_high["mass, g"], low_low["mass, g"])
    yield "more rolling friction, steeper at sliding 0.9", effect(high_low["angle, degrees"], high_high["angle, degrees"])
    yield "rolling friction holds mass back at sliding 0.9", effect(high_high["mass, g"], high_low["mass, g"])
    yield ("and less at 0.1",
           effect(high_high["mass, g"], high_low["mass, g"]) - effect(low_high["mass, g"], low_low["mass, g"]))
    soft, hard = (samples[point] for point in BETWEEN_GRAINS)
    yield "more restitution between grains, more in area 1", effect(counted(soft, "area 1"), counted(hard, "area 1"))
    yield wall_trend(samples, "beside the base")


def wall_trend(samples, inner):
    soft, hard = (samples[point] for point in WITH_WALL)
    return (f"restitution with the wall changes area 3 more than the grains of \"{inner}\", relative",
            relative_effect(counted(soft, "area 3"), counted(hard, "area 3")) -
            relative_effect(counted(soft, inner), counted(hard, inner)))


def main():
    program = Program(*sys.argv[1:4])
    points = FRICTION + BETWEEN_GRAINS + WITH_WALL
    with folder_of_runs(sys.argv) as folder:
        runs = [(program.deck(DECK), os.path.join(folder, f"{n}_{seed}"), *overrides(point, seed))
                for n, point in enumerate(points) for seed in SEEDS]
        summaries = program.run_all(runs, ["--restart", "--quiet"])
        found = iter([figures(program, run[1], summary) for run, summary in zip(runs, summaries)])
    samples = {}
    for point in points:
        of_seeds = [next(found) for _ in SEEDS]
        samples[point] = {name: Sample([one[name] for one in of_seeds]) for name in of_seeds[0]}
    print_table(samples)
    # Sliding friction 0.1 leaves no pile on the plate, so there is no angle to compare: less than any.
    for point in FRICTION[:2]:
        angle = samples[point]["angle, degrees"]
        assert not angle.complete or angle.mean() < samples[FRICTION[2]]["angle, degrees"].mean(), str(angle)
    effects = list(trends(samples))
    for name, e in [*effects, wall_trend(samples, "area 1")]:
        print(f"{name}: {e}")
    for name, e in effects:
        assert e.value > 2.0 * e.error, f"{name}: {e}"


main()
