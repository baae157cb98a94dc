"""The balls of the inclined-plane test on glued grains: section 3.2.1 of the thesis."""

import math
import statistics

from bench import Bench, of_seeds, save_means, values_of, with_seeds
from contours import coefficient

BALLS = ((28.0, 80.0), (22.0, 43.5), (18.0, 25.0), (11.0, 6.0), (9.0, 3.0), (8.8, 3.0))  # diameter in mm, mass in g
DECKS = {"CarboHSP 40/70": "inclined_plane.toml", "sand": "inclined_plane_sand.toml"}


def name_of(material, diameter):
    return f"plane_{material.split()[0]}_{diameter:g}"


def study(options):
    """The tilt at which each ball rolls away, on plates with other grains for every seed, and its tangent, which the thesis takes
    for the rolling friction."""
    runs = {}
    for material, deck in DECKS.items():
        for diameter, mass in BALLS:
            density = 1e-3 * mass / (math.pi / 6.0 * (1e-3 * diameter) ** 3)
            sets = [f"particles.0.diameter={diameter} mm", f"material.0.density={density:.1f}", f"particles.0.spacing={diameter} mm",
                    f"particles.0.radius={0.5 * diameter + 0.1} mm", f"particles.0.height={diameter + 0.1} mm"]
            runs |= with_seeds(name_of(material, diameter), deck, sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for material, deck in DECKS.items():
        for diameter, mass in BALLS:
            tilts = values_of(of_seeds(summaries, name_of(material, diameter), options.seeds), "tilt_onset_deg")
            rows.append({"grains": material, "ball, mm": diameter, "mass, g": mass, "rolled": f"{len(tilts)} of {options.seeds}",
                         "tilt, degrees": scatter(tilts), "tangent": scatter([math.tan(math.radians(t)) for t in tilts]),
                         "rolling friction given": coefficient(deck, "pair.1.rolling_friction")})
    save_means(options, "planes", summaries, rows)


def scatter(values):
    """Mean and standard deviation as text."""
    return f"{statistics.mean(values):.3g} +- {statistics.stdev(values):.2g}" if len(values) > 1 else "none"
