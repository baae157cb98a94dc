#!/usr/bin/python3
"""Studies behind docs/validation.md; see README.md. What has been run already is not run again."""

import argparse
import json
import math
import pathlib
import subprocess

import sand_layer
from bench import ROOT, Bench, figures, means_of, save, with_seeds, write

MATERIALS = ("material.0", "material.1")
STOPPED = 75  # exit code of a run that was stopped with a checkpoint


def full(options):
    """Cases of input/validation.toml at full size, one after the other on all ranks."""
    output = options.work / "validation"
    for case in options.cases:
        command = ["mpirun", "-n", str(options.ranks), options.program, "validate", str(ROOT / "input" / "validation.toml"),
                   "--case", case, "--output", str(output)]
        if options.time_limit:
            command += ["--time-limit", options.time_limit]
        code = subprocess.run(command, stdin=subprocess.DEVNULL).returncode
        if code != 0:
            raise SystemExit(f"{case} ended with exit code {code}" + (": the same command goes on" if code == STOPPED else ""))
        compared = json.loads((output / "validation.json").read_text())["cases"][0]["comparisons"]
        summary = json.loads((output / case / "summary.json").read_text())
        save(options.results / f"{case}.json", case=case, comparisons=compared, summary=summary)


def stiffness(options):
    """The small scattering test with Young's moduli of 5e6, 5e7 and 5e8 Pa."""
    seeds = {5e6: options.seeds, 5e7: max(2, options.seeds - 2), 5e8: 2}
    runs = {}
    for modulus, count in seeds.items():
        runs |= with_seeds(f"stiffness_{modulus:.0e}", "scatter_mini.toml", [f"{m}.youngs_modulus={modulus}" for m in MATERIALS], count)
    summaries = Bench(options).run_all(runs)
    rows = []
    for modulus, count in seeds.items():
        rows.append({"E, Pa": f"{modulus:.0e}", **means_of(summaries, f"stiffness_{modulus:.0e}", count)})
    write(options, "stiffness", summaries, rows)


def funnel(options):
    """8 g of mono-size CarboHSP, calibrated: what stays in cylinders of several radii; their slope gives the funnel's. The
    domain ends 6 mm below the hole, so that what has left costs nothing."""
    runs = {}
    for radius in options.radii:
        runs[f"funnel_{radius:g}"] = ("scatter_carbohsp.toml", [
            "particles.0.mass=8 g", f"particles.0.radius={radius} mm", "particles.0.height=58 mm", "particles.0.spacing=600 um",
            "domain.min=[-0.05, -0.05, -0.006]", "domain.max=[0.05, 0.05, 0.06]",
            f"wall.vessel.points=[[{1e-3 * radius}, 0.06], [{1e-3 * radius}, 0.0], [0.0025, 0.0]]"])
    summaries = Bench(options).run_all(runs)
    rows = []
    for radius in options.radii:
        summary = summaries[f"funnel_{radius:g}"]
        retained = 8.0 - figures(summary)["discharged_g"]
        # Slope of a surface that rises from the orifice's edge to the wall: volume = 2 pi tan(a) int (r - 2.5) r dr
        ring = 2.0 * math.pi * ((radius**3 - 2.5**3) / 3.0 - 2.5 * (radius**2 - 2.5**2) / 2.0)  # mm3
        rows.append({"radius, mm": float(radius), "retained, g": retained, "rate, g/s": figures(summary)["rate_g_s"],
                     "slope at 2.115 g/cm3, degrees": math.degrees(math.atan(retained / 2.115e-3 / ring))})
    write(options, "funnel", summaries, rows)


def sizes(options):
    """1.5 g of CarboHSP of one size and of its distribution, each with its calibrated friction, from a cylinder of 6 mm."""
    small = ["particles.0.mass=1.5 g", "particles.0.radius=6 mm", "particles.0.height=49 mm", "domain.max=[0.07, 0.07, 0.051]",
             "wall.vessel.points=[[0.006, 0.051], [0.006, 0.0], [0.0025, 0.0]]"]
    decks = {"mono": ("carbohsp_mono.toml", [*small, "particles.0.spacing=770 um"]), "multi": ("carbohsp_multi.toml", small)}
    runs = {}
    for name, (deck, sets) in decks.items():
        runs |= with_seeds(f"sizes_{name}", deck, sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = [{"sizes": name, **means_of(summaries, f"sizes_{name}", options.seeds)} for name in decks]
    write(options, "sizes", summaries, rows)


STUDIES = {"full": full, "stiffness": stiffness, "funnel": funnel, "sizes": sizes, "sand_layer": sand_layer.study}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", choices=STUDIES)
    parser.add_argument("--program", default=str(ROOT / "build" / "ci" / "src" / "repose"))
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "benchmarks" / "validation")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "benchmarks" / "results" / "validation")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, one rank each")
    parser.add_argument("--ranks", type=int, default=2, help="of a case of full size")
    parser.add_argument("--cases", nargs="+", default=["carbohsp_mono", "carbohsp_multi", "sand_multi"], help="of full size")
    parser.add_argument("--time-limit", help="of a case of full size: HH:MM:SS")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--radii", type=float, nargs="+", default=[10.0, 11.0, 12.0], help="of the funnel, mm")
    options = parser.parse_args()
    STUDIES[options.study](options)


if __name__ == "__main__":
    main()
