"""What the ruler does to the figures: the same piles with other rules for the angle, and for the base around which grains are
counted."""

import json
import subprocess

from bench import ROOT, Bench, modulus, names_by_seed, rayleigh_share, save_means, shown, spread_of, with_seeds

LESS = ["particles.0.mass=7.5 g", "guards.max_overlap=0.5", "output.snapshot_interval=0"]
# Deck and overrides: the lowest levels of the calibrations of friction, with the restitution of the scattering tests
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


def measured(options, name, deck, sets, number):
    """The figures of the end of a run by another ruler."""
    run = options.work / name
    output = run / "measured" / str(number)
    if not (output / "measurement.json").exists():
        last = max(run.glob("run_*.hdf"))
        words = [word for override in sets for word in ("--set", override)]
        subprocess.run([options.program, "measure", last, "--deck", ROOT / "input" / deck, "--output", output, *words], check=True,
                       capture_output=True)
    return json.loads((output / "measurement.json").read_text())


def study(options):
    """7.5 g of CarboHSP and of sand in their full vessels, with softer grains."""
    runs = {}
    for case, (deck, sets) in CASES.items():
        runs |= with_seeds(f"ruler_{case}", deck, sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for case, (deck, _) in CASES.items():
        for number, (ruler, sets) in enumerate(RULERS.items()):
            found = [measured(options, name, deck, sets, number) for name in names_by_seed(f"ruler_{case}", options.seeds).values()]
            counts = [figures["scattering"] for figures in found]
            rows.append({"grains": case, "ruler": ruler,
                         "angle, degrees": shown(spread_of([figures["angle_of_repose_deg"] for figures in found]), 1.0),
                         "base, mm": shown(spread_of([c["base_diameter_m"] for c in counts]), 1e3),
                         "area 1": shown(spread_of([c["area_1"]["count"] for c in counts]), 1.0),
                         "area 3": shown(spread_of([c["area_3"]["count"] for c in counts]), 1.0)})
    save_means(options, "ruler", summaries, rows)
