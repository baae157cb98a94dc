"""What a hole that has grown with temperature does to the test: section 4.2 of the thesis."""

from bench import SCATTERING, Bench, flat_floor, row_of, save_means, spreads, vessel_wall, with_seeds

STEEL = 17e-6  # 1/K: linear expansion of an austenitic steel; the thesis names none
DIAMETERS = (5.0, 5.05, 5.2, 5.5)  # mm: cold, at 600 degrees, and larger still so that the trend stands out of the scatter


def study(options):
    """The hole of the reduced scattering test as it grows with temperature, nothing else changed."""
    runs = {}
    for diameter in DIAMETERS:
        radius = round(0.5e-3 * diameter, 9)
        sets = [vessel_wall(flat_floor(0.006, 0.06, radius)), f"wall.lid.radius={radius}", "pair.0.restitution=0.71"]
        runs |= with_seeds(f"orifice_{diameter:g}", "scatter_mini.toml", sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    figures = (*SCATTERING, "discharge_rate_kg_s")
    found = {f"{d:g}": spreads(summaries, f"orifice_{d:g}", options.seeds, figures) for d in DIAMETERS}
    rows = [{"diameter, mm": d, "warmer by, K": (d / DIAMETERS[0] - 1.0) / STEEL, **row_of(found[f"{d:g}"])}
            for d in DIAMETERS]
    save_means(options, "orifice", summaries, rows, expansion_1_K=STEEL, found=found)
