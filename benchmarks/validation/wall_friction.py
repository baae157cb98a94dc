"""What friction with the wall does to the discharge and scattering test: Tables 3.2 and 3.3 of the thesis, and one of them changed."""

from bench import SCATTERING, Bench, row_of, save_means, spreads, with_seeds

CASES = {"as measured": [], **{f"{key} {value}": [f"pair.1.{key}={value}"] for key, value in (
    ("rolling_friction", 0.0), ("rolling_friction", 0.01), ("rolling_friction", 0.3), ("sliding_friction", 0.15), ("sliding_friction", 0.8))}}


def study(options):
    """At reduced size."""
    def name_of(case):
        return "wall_friction_" + case.replace(" ", "_")

    runs = {}
    for case, sets in CASES.items():
        runs |= with_seeds(name_of(case), "scatter_mini.toml", sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = [{"friction with the wall": case, **row_of(spreads(summaries, name_of(case), options.seeds, SCATTERING))} for case in CASES]
    save_means(options, "wall_friction", summaries, rows)
