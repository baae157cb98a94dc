"""How dense settled beds lie: what filling, friction, stiffness and sizes do to it."""

from bench import BULK_DENSITY, Bench, flat_floor, identities, modulus, print_table, save, vessel

SETTLE = ["phase.discharge.min_time=0.001", "phase.discharge.max_time=0.002", BULK_DENSITY]  # the bed alone
TALL = vessel("8 g", flat_floor(0.011, 0.067), 0.03)
BEDS = {  # deck and overrides
    "CarboHSP, one size": ("carbohsp_mono.toml", []),
    "thrown in with 2 m/s instead of 0.3": ("carbohsp_mono.toml", ["particles.0.velocity=[0.0, 0.0, -2.0]"]),
    "friction 0.1 and 0.1": ("carbohsp_mono.toml", ["pair.0.sliding_friction=0.1", "pair.0.rolling_friction=0.1"]),
    "friction 0.9 and 0.5": ("carbohsp_mono.toml", ["pair.0.sliding_friction=0.9", "pair.0.rolling_friction=0.5"]),
    "ten times as stiff": ("carbohsp_mono.toml", modulus("5e7")),
    "CarboHSP, many sizes": ("carbohsp_multi.toml", []),
    "sand, many sizes": ("sand_multi.toml", []),
}


def study(options):
    """Of a settled bed of 8 g in a cylinder of 11 mm."""
    runs = {f"bed_{k}": (deck, [*TALL, *(["particles.0.spacing=600 um"] if "mono" in deck else []), *SETTLE, *own])
            for k, (deck, own) in enumerate(BEDS.values())}
    summaries = Bench(options).run_all(runs)
    rows = [{"bed": name, "bulk density, kg/m3": summaries[f"bed_{k}"]["bulk_density_kg_m3"],
             "porosity": summaries[f"bed_{k}"]["porosity"]} for k, name in enumerate(BEDS)]
    save(options.results / "bulk_density.json", runs=identities(summaries), rows=rows)
    print_table(rows, digits=4)
