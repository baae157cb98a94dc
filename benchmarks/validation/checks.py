"""Single runs that ask what calibrations at full size only compute: at a crossing, at the thesis's pair, with another seed."""

from bench import ROOT, identities, input_deck, level_of, print_table, repose, save, time_limit

# Calibration, level, values of its parameters, seed
CASES = {"sand_crossing": ("calibrate_sand_levels.toml", "whole", (0.395, 0.414), 1),
         "sand_second_seed": ("calibrate_sand_levels.toml", "whole", (0.3, 0.475), 2),
         "carbohsp_thesis": ("calibrate_carbohsp_levels.toml", "full", (0.827, 0.172), 1)}


def study(options):
    """With all of the mass, one after the other on all ranks."""
    for case in options.cases or CASES:
        file, level, values, seed = CASES[case]
        calibration = input_deck(file)
        parameters = list(zip(calibration["parameter"], values))
        sets = [*calibration["set"], *level_of(file, level), *(f"{one['key']}={value}" for one, value in parameters), f"run.seed={seed}"]
        try:
            run = repose.run(ROOT / "input" / calibration["base"], options.work / f"check_{case}", set=sets, ranks=options.ranks,
                             program=options.program, restart=True, options=time_limit(options))
        except repose.ReposeError as error:
            raise SystemExit(f"{case}: {error}") from None
        summary = run.summary
        rows = [{"level": level, **{one["name"]: value for one, value in parameters}, "seed": seed,
                 "retained, g": 1e3 * summary["retained_mass_kg"],
                 "angle, degrees": summary["angle_of_repose_deg"], "error, degrees": summary["angle_of_repose_stderr_deg"],
                 "bulk density, kg/m3": summary["bulk_density_kg_m3"]}]
        print_table(rows, digits=4)
        save(options.results / f"check_{case}.json", set=sets, runs=identities({case: summary}), rows=rows)
