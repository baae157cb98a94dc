"""The balls of the inclined-plane test on glued grains: section 3.2.1 of the thesis."""

import math
import statistics

from bench import Bench, save_means, with_seeds

BALLS = ((28.0, 80.0), (22.0, 43.5), (18.0, 25.0), (11.0, 6.0), (9.0, 3.0), (8.8, 3.0))  # diameter in mm, mass in g
DECKS = {"CarboHSP 40/70": ("inclined_plane.toml", 0.12757), "sand": ("inclined_plane_sand.toml", 0.15974)}  # rolling friction


def study(options):
    """The tilt at which each ball rolls away, on plates with other grains for every seed, and its tangent, which the thesis takes
    for the rolling friction."""
    runs = {}
    for material, (deck, _) in DECKS.items():
        for diameter, mass in BALLS:
            density = 1e-3 * mass / (math.pi / 6.0 * (1e-3 * diameter) ** 3)
            sets = [f"particles.0.diameter={diameter} mm", f"material.0.density={density:.1f}", f"particles.0.spacing={diameter} mm",
                    f"particles.0.radius={0.5 * diameter + 0.1} mm", f"particles.0.height={diameter + 0.1} mm"]
            runs |= with_seeds(f"plane_{material.split()[0]}_{diameter:g}", deck, sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for material, (_, friction) in DECKS.items():
        for diameter, mass in BALLS:
            own = [summaries[f"plane_{material.split()[0]}_{diameter:g}_{seed}"] for seed in range(1, options.seeds + 1)]
            tilts = [s["tilt_onset_deg"] for s in own if s["tilt_onset_deg"] is not None]
            rows.append({"grains": material, "ball, mm": diameter, "mass, g": mass, "rolled": f"{len(tilts)} of {len(own)}",
                         "tilt, degrees": spread(tilts), "tangent": spread([math.tan(math.radians(t)) for t in tilts]),
                         "rolling friction given": friction})
    save_means(options, "planes", summaries, rows)


def spread(values):
    return f"{statistics.mean(values):.3g} +- {statistics.stdev(values):.2g}" if len(values) > 1 else "none"
