"""What the ruler does to the figures: the same piles with other rules for the angle, and for the base around which grains are
counted."""

from bench import ROOT, Bench, measured, modulus, names_by_seed, rayleigh_share, save_means, shown, spread_of, values_of, with_seeds

LESS = ["particles.0.mass=7.5 g", "guards.max_overlap=0.5", "output.snapshot_interval=0"]
# Deck and overrides: grains as soft as in the lowest levels of the calibrations, the restitution of the scattering tests; CarboHSP
# with the step of the levels above, since with that of the lowest its bed trembles
CASES = {"CarboHSP": ("scatter_carbohsp.toml", [*LESS, *modulus("1 MPa"), *rayleigh_share(0.3)]),
         "sand": ("scatter_sand.toml", [*LESS, *modulus("2 MPa"), *rayleigh_share(0.4), "particles.0.height=36 mm"])}
ANGLE = "measurement.angle_of_repose."
RULERS = {"as in the decks": [],
          "lines from 10 to 90 % of the height": [ANGLE + "fit_from=0.1", ANGLE + "fit_to=0.9"],
          "lines from 5 to 95 %": [ANGLE + "fit_from=0.05", ANGLE + "fit_to=0.95"],
          "lines from 30 to 70 %": [ANGLE + "fit_from=0.3", ANGLE + "fit_to=0.7"],
          "a camera 30 cm away": [ANGLE + "camera=perspective", ANGLE + "camera_distance=0.3"],
          "a base of 0.3 of the pile's density": ["measurement.scattering.base_share=0.3"],
          "a base of 0.7": ["measurement.scattering.base_share=0.7"]}


def mean_of(found, key, factor=1.0):
    """Mean and standard error of a figure of those that have it, as text."""
    return shown(spread_of(values_of(found, key)), factor)


def study(options):
    """7.5 g of CarboHSP and of sand in their full vessels, with softer grains."""
    runs = {}
    for case, (deck, sets) in CASES.items():
        runs |= with_seeds(f"ruler_{case}", deck, sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for case, (deck, _) in CASES.items():
        for ruler, sets in RULERS.items():
            folders = [options.work / name for name in names_by_seed(f"ruler_{case}", options.seeds).values()]
            found = [measured(options, max(run.glob("run_*.hdf")), ROOT / "input" / deck, run / "measured", sets) for run in folders]
            rows.append({"grains": case, "ruler": ruler, "angle, degrees": mean_of(found, "angle_of_repose_deg"),
                         "base, mm": mean_of(found, "scattering.base_diameter_m", 1e3),
                         "area 1": mean_of(found, "scattering.area_1.count"), "area 3": mean_of(found, "scattering.area_3.count")})
    save_means(options, "ruler", summaries, rows)
