"""With which friction sand of many sizes plugs the hole of 5 mm: section 3.5 of the thesis."""

import contours
from bench import Bench, of_seeds, row_of, save_means, spreads, with_seeds

CORNERS = ((0.3, 0.4), (0.5, 0.4), (0.3, 0.6), (0.5, 0.6), (0.6, 0.6), (0.5, 0.7), (0.7, 0.7), (0.9, 0.9))  # sliding, rolling friction


def study(options):
    """In a vessel of 8 mm radius with 3 g."""
    runs = {}
    for sliding, rolling in CORNERS:
        runs |= with_seeds(f"clogging_{sliding}_{rolling}", "sand_multi.toml",
                           [*contours.SMALL_SAND, f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}"], options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for sliding, rolling in CORNERS:
        own = of_seeds(summaries, f"clogging_{sliding}_{rolling}", options.seeds)
        rows.append({"sliding": sliding, "rolling": rolling, "plugged": f"{sum(s['plugged'] for s in own)} of {len(own)}",
                     **row_of(spreads(summaries, f"clogging_{sliding}_{rolling}", options.seeds, ("discharged_mass_kg",)))})
    save_means(options, "clogging", summaries, rows)
