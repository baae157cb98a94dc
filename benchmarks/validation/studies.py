#!/usr/bin/python3
"""Studies behind docs/validation.md; see README.md. What has been run already is not run again."""

import math
import subprocess

import numpy as np

import bulk_density
import calibrations
import clogging
import contours
import little_friction
import orifice
import planes
import ruler
import sand_layer
import sensitivity
import settling
import wall_friction
from bench import (BULK_DENSITY, DISCHARGE, ROOT, SCATTERING, STOPPED, Bench, figures, flat_floor, modulus, names_by_seed, places,
                   print_table, rayleigh_share, repose, row_of, save, save_means, shown, spread_of, spreads, time_limit, vessel,
                   usual_options, with_seeds, write)

# Grains and walls a fifth as stiff as the thesis's, with one and a half times its share of the Rayleigh time: nearly three times
# its step
SOFTER = [*modulus("1 MPa"), *rayleigh_share(0.3), "guards.max_overlap=0.5"]  # of a small grain below a large one on the plate
# Cases of `full`: that of input/validation.toml, and overrides. Without overrides they are the thesis's
FULL = {"carbohsp_mono": ("carbohsp_mono", []), "carbohsp_multi": ("carbohsp_multi", []), "sand_multi": ("sand_multi", []),
        "carbohsp_multi_softer": ("carbohsp_multi", SOFTER)}


def full(options):
    """Cases of input/validation.toml at full size, one after the other on all ranks; by default as they are there."""
    for name in options.cases or [name for name, (_, sets) in FULL.items() if not sets]:
        case, sets = FULL[name]
        output = options.work / (name if sets else "validation")
        overrides = [word for override in sets for word in ("--set", override)]
        command = ["mpirun", "-n", str(options.ranks), options.program, "validate", str(ROOT / "input" / "validation.toml"),
                   "--case", case, "--output", str(output), *overrides, *time_limit(options)]
        code = subprocess.run(command, stdin=subprocess.DEVNULL).returncode
        if code != 0:
            raise SystemExit(f"{name} ended with exit code {code}" + (": the same command goes on" if code == STOPPED else ""))
        found = repose.Validation(output)
        run = found.runs[case]
        places = sizes_by_place(run)
        print_table(places, digits=4)
        save(options.results / f"{name}.json", case=case, set=sets, comparisons=found.cases[case], places=places,
             summary=run.summary)


def sizes_by_place(run):
    """How many grains lie where at the end, and their mean diameters: in the vessel, in the pile and its foot (the outer quarter of
    its radius), and in the areas around it."""
    last, scattering = run.snapshots[-1], run.summary.get("scattering")
    from_axis, above = places(last)
    base = 0.5 * scattering["base_diameter_m"] if scattering else run.summary["pile_height_m"] / math.tan(
        math.radians(run.summary["angle_of_repose_deg"]))
    rings = {"pile": (0.0, 0.75 * base), "foot": (0.75 * base, base)}
    for area in ("area_1", "area_2", "area_3") if scattering else ():
        rings[area] = (scattering[area]["from_m"], scattering[area]["to_m"] or math.inf)
    chosen = {"vessel": above, **{name: ~above & (from_axis >= low) & (from_axis < high) for name, (low, high) in rings.items()}}
    return [{"place": name, "grains": int(np.count_nonzero(here)), "mean diameter, um": 2e6 * float(np.mean(last.radius[here]))}
            for name, here in chosen.items()]


# Young's modulus, Pa, and share of the Rayleigh time
STEPS = (("5e6", 0.05), ("5e6", 0.1), ("5e6", 0.2), ("5e6", 0.3), ("5e6", 0.4), ("5e7", 0.2))


def stiffness(options):
    """The quick discharge test, until it rests, with several Young's moduli and time steps: a share of the Rayleigh time and half
    as much of the Hertz time."""
    runs, names = {}, []
    for value, share in STEPS:
        names.append(f"stiffness_{value}_{share:g}")
        sets = [*modulus(value), *rayleigh_share(share), "phase.discharge.max_time=3 s"]
        runs |= with_seeds(names[-1], "discharge_quick.toml", sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = [{"E, Pa": value, "of the Rayleigh time": share, "time step, us": 1e6 * summaries[f"{name}_1"]["timestep_s"],
             **row_of(spreads(summaries, name, options.seeds, DISCHARGE))} for (value, share), name in zip(STEPS, names)]
    save_means(options, "stiffness", summaries, rows)


def time_step(options):
    """The reduced scattering test with time steps of 10 to 40 % of the Rayleigh time and half as much of the Hertz time."""
    shares, figures = (0.1, 0.2, 0.4), (*SCATTERING, "discharge_rate_kg_s")
    runs = {}
    for share in shares:
        runs |= with_seeds(f"time_step_{share:g}", "scatter_mini.toml", rayleigh_share(share), options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = [{"of the Rayleigh time": share, "time step, us": 1e6 * summaries[f"time_step_{share:g}_1"]["timestep_s"],
             **row_of(spreads(summaries, f"time_step_{share:g}", options.seeds, figures))} for share in shares]
    save_means(options, "time_step", summaries, rows)


def funnel(options):
    """8 g, calibrated: what stays in cylinders of several radii, of CarboHSP of one size, by which the radius is chosen, and
    of sand in the radius chosen. The domain ends 6 mm below the hole, so that what has left costs nothing."""
    # Deck, radius in mm, mean diameter in mm, overrides
    cases = {f"funnel_scatter_carbohsp_{radius:g}": ("scatter_carbohsp.toml", radius, 0.44, ["particles.0.spacing=600 um"])
             for radius in options.radii}
    cases["funnel_scatter_sand_11.44"] = ("scatter_sand.toml", 11.44, 0.765, [])
    runs = {name: (deck, [*own, *vessel("8 g", flat_floor(1e-3 * radius, 0.067), 0.05), "domain.min=[-0.05, -0.05, -0.006]",
                          BULK_DENSITY])
            for name, (deck, radius, _, own) in cases.items()}
    summaries = Bench(options).run_all(runs)
    rows = []
    for name, (deck, radius, diameter, _) in cases.items():
        row = figures(summaries[name])
        retained, density = 8.0 - row["discharged_g"], summaries[name]["bulk_density_kg_m3"]
        rim = sand_layer.rim(sand_layer.retained(options.work / name)[0], radius, diameter)
        # Slope of a surface that rises from the orifice's edge to the wall: volume = 2 pi tan(a) int (r - 2.5) r dr
        ring = 2.0 * math.pi * ((radius**3 - 2.5**3) / 3.0 - 2.5 * (radius**2 - 2.5**2) / 2.0)  # mm3
        rows.append({"deck": deck, "radius, mm": radius, "bulk density, kg/m3": density, "retained, g": retained,
                     "rate, g/s": row["rate_g_s"], "slope, degrees": math.degrees(math.atan(1e6 * retained / density / ring)),
                     "rim, mm": rim})
    write(options, "funnel", summaries, rows)


DENSITY = (*DISCHARGE, "bulk_density_kg_m3")
# Cases of `sizes`: name of its results, radius of the vessel in mm, overrides, spacing of one size over its diameter (None: the
# distribution alone), figures
SIZES = {"calibrated": ("sizes", 6.0, contours.SMALL, 1.75, DISCHARGE),
         "little": ("sizes_little_friction", 6.0, [*contours.SMALL, "pair.0.sliding_friction=0.1", "pair.0.rolling_friction=0.1"], 1.75,
                    DISCHARGE),
         "full_vessel": ("sizes_full_vessel", 11.11, ["particles.0.mass=7.5 g", *rayleigh_share(0.3)], 1.25, DENSITY),
         "softer": ("sizes_softer", 11.11, ["particles.0.mass=7.5 g", *SOFTER], None, DENSITY),
         "softer_bouncing": ("sizes_softer_bouncing", 11.11, ["particles.0.mass=7.5 g", *SOFTER, "pair.0.restitution=0.71"], None,
                             DENSITY)}


def rim_of(options, name, radius):
    """Mean and standard error over the seeds of the rim at the wall, in mm, in rings as wide as the mean diameter of what is left
    (sand_layer.rim); radius of the vessel in mm."""
    rims = []
    for run in names_by_seed(name, options.seeds).values():
        position, radii = sand_layer.retained(options.work / run)
        rims.append(sand_layer.rim(position, radius, 2.0 * radii.mean()))
    return shown(spread_of([rim for rim in rims if rim is not None]), 1.0)


def sizes(options):
    """CarboHSP of one size (the thesis's, which stands for what it leaves out, and that of the mean volume of the distribution)
    and of its distribution, each with its calibrated friction: 1.5 g from a cylinder of 6 mm, there with little friction as well,
    and 7.5 g from the vessel of the full test, also with the restitution of the scattering test."""
    for case in options.cases or SIZES:
        study, radius, sets, spacing, chosen = SIZES[case]
        decks = {f"one_{diameter}": ("carbohsp_mono.toml", [*sets, f"particles.0.spacing={spacing * diameter:g} um",
                                                            f"particles.0.diameter={diameter} um"])
                 for diameter in (440, 368) if spacing}
        decks["many"] = ("carbohsp_multi.toml", sets)
        runs = {}
        for name, (deck, own) in decks.items():
            runs |= with_seeds(f"{study}_{name}", deck, own, options.seeds)
        summaries = Bench(options).run_all(dict(reversed(runs.items())))  # the longest first
        rows = [{"sizes": name, "grains": summaries[f"{study}_{name}_1"]["particles"]["inserted"],
                 **row_of(spreads(summaries, f"{study}_{name}", options.seeds, chosen)),
                 "rim, mm": rim_of(options, f"{study}_{name}", radius)} for name in decks]
        save_means(options, study, summaries, rows)


STUDIES = {"full": full, "stiffness": stiffness, "time_step": time_step, "funnel": funnel, "sizes": sizes,
           "sand_layer": sand_layer.study, "contours": contours.study, "calibrations": calibrations.study, "sensitivity": sensitivity.study,
           "orifice": orifice.study, "clogging": clogging.study, "bulk_density": bulk_density.study, "planes": planes.study,
           "wall_friction": wall_friction.study, "ruler": ruler.study, "little_friction": little_friction.study, "settling": settling.study}


def main():
    parser = usual_options(__doc__, "validation")
    parser.add_argument("study", choices=STUDIES)
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, one rank each")
    parser.add_argument("--ranks", type=int, default=2, help="of runs at full size, of contours and of calibrations")
    parser.add_argument("--cases", nargs="+", help="of a study that has some; default: all")
    parser.add_argument("--time-limit", help="of a run at full size, of contours or of a calibration: HH:MM:SS")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--radii", type=float, nargs="+", default=[10.0, 11.11, 12.0], help="of the funnel, mm")
    options = parser.parse_args()
    options.program = options.program or repose.find_program()
    STUDIES[options.study](options)


if __name__ == "__main__":
    main()
