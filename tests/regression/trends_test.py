"""The trends of the thesis (sections 3.3.3 and 3.6) in small, between far corners: five seeds of input/scatter_mini.toml at
each point. An effect is the difference of two means, its error that of the difference by the scatter of the seeds. What
docs/validation.md says about trends is what this prints. 40 runs of minutes: those in FOLDER that are complete are not run
again.

Usage: trends_test.py EXECUTABLE MPIEXEC SOURCE_DIR [FOLDER]
"""

import math
import os
import statistics
import sys

from repose_runs import Program, folder_of_runs

SEEDS = range(1, 6)
FRICTION = [(sliding, rolling, 0.5, 0.6) for sliding in (0.1, 0.9) for rolling in (0.1, 0.5)]
BETWEEN_GRAINS = [(0.7, 0.3, e, 0.6) for e in (0.1, 0.9)]
WITH_WALL = [(0.7, 0.3, 0.5, e) for e in (0.1, 0.9)]
FIGURES = {"mass, g": lambda s: 1e3 * s["discharged_mass_kg"], "angle, degrees": lambda s: s["angle_of_repose_deg"],
           "area 1": lambda s: s["scattering"]["area_1"]["count"], "area 3": lambda s: s["scattering"]["area_3"]["count"]}


def overrides(point, seed):
    sliding, rolling, between_grains, with_wall = point
    return (f"run.seed={seed}", f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}",
            f"pair.0.restitution={between_grains}", f"pair.1.restitution={with_wall}")


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


def print_table(points, samples):
    print("| sliding | rolling | restitution | with the wall | " + " | ".join(FIGURES) + " |")
    for point in points:
        print("| " + " | ".join(map(str, point)) + " | " + " | ".join(str(samples[point][f]) for f in FIGURES) + " |")


def trends(samples):
    """Name and effect of each, positive when it is that of the thesis."""
    low_low, low_high, high_low, high_high = (samples[point] for point in FRICTION)
    yield "more friction, less mass", effect(high_high["mass, g"], low_low["mass, g"])
    yield "more rolling friction, steeper at sliding 0.9", effect(high_low["angle, degrees"], high_high["angle, degrees"])
    yield "rolling friction holds mass back at sliding 0.9", effect(high_high["mass, g"], high_low["mass, g"])
    yield ("and less at 0.1",
           effect(high_high["mass, g"], high_low["mass, g"]) - effect(low_high["mass, g"], low_low["mass, g"]))
    soft, hard = (samples[point] for point in BETWEEN_GRAINS)
    yield "more restitution between grains, more in area 1", effect(soft["area 1"], hard["area 1"])
    soft, hard = (samples[point] for point in WITH_WALL)
    yield ("restitution with the wall changes area 3 more than area 1, relative",
           relative_effect(soft["area 3"], hard["area 3"]) - relative_effect(soft["area 1"], hard["area 1"]))


def main():
    program = Program(*sys.argv[1:4])
    points = FRICTION + BETWEEN_GRAINS + WITH_WALL
    with folder_of_runs(sys.argv) as folder:
        runs = [(program.deck("scatter_mini.toml"), os.path.join(folder, f"{n}_{seed}"), *overrides(point, seed))
                for n, point in enumerate(points) for seed in SEEDS]
        summaries = iter(program.run_all(runs, ["--restart", "--quiet"]))
    samples = {}
    for point in points:
        of_seeds = [next(summaries) for _ in SEEDS]
        samples[point] = {name: Sample([figure(s) for s in of_seeds]) for name, figure in FIGURES.items()}
    print_table(points, samples)
    for point in points:
        for area in ("area 1", "area 3"):
            assert samples[point][area].mean() >= 200 or point in FRICTION, (point, area, str(samples[point][area]))
    # Sliding friction 0.1 leaves no pile on the plate, so there is no angle to compare: less than any.
    for point in FRICTION[:2]:
        angle = samples[point]["angle, degrees"]
        assert not angle.complete or angle.mean() < samples[FRICTION[2]]["angle, degrees"].mean(), str(angle)
    found = list(trends(samples))
    for name, e in found:
        print(f"{name}: {e}")
    for name, e in found:
        assert e.value > 2.0 * e.error, f"{name}: {e}"


main()
