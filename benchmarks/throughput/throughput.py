#!/usr/bin/python3
"""Particle-steps per cpu-second of repose, LIGGGHTS and LAMMPS on the same grains; see README.md."""

import argparse
import pathlib
import sys

import beds
import codes
import measure
import peers
from plans import Plan

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, machine, save  # noqa: E402

CODES = ["repose", "liggghts-native", "liggghts-debian", "lammps"]


def names_of_codes(text):
    names = text.split(",")
    unknown = [name for name in names if name not in CODES]
    if unknown:
        raise argparse.ArgumentTypeError(f"unknown code {unknown[0]}; there are {', '.join(CODES)}")
    return names


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    common = argparse.ArgumentParser(add_help=False, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    common.add_argument("--work", type=pathlib.Path, default=ROOT / "build/benchmarks/throughput", help="what is made")
    common.add_argument("--prefix", type=pathlib.Path, help="folder of the built peers; default: WORK/peers")
    common.add_argument("--repose", default=str(ROOT / "build/release/src/repose"), help="executable")
    scene = argparse.ArgumentParser(add_help=False)
    scene.add_argument("--case", choices=("settled", "moving", "discharge_mini"), default="settled", help="what is run")
    scene.add_argument("--segment", action="store_true", help="discharge_mini: only the first steps after the lid")
    scene.add_argument("--size", type=int, default=15600, help="grains: 15600, 156000, 1000000")
    scene.add_argument("--ranks", type=int, default=1, help="also for making the bed, which depends on it in no bit")
    scene.add_argument("--sizes", choices=beds.DIAMETERS, default="mono", help="440 um, or 208 to 724 um")
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("peers", parents=[common], help="get LAMMPS and LIGGGHTS, and build LIGGGHTS")
    commands.add_parser("beds", parents=[common, scene], help="make the starting state of a case, which run also does")
    run = commands.add_parser("run", parents=[common, scene], help="measure")
    run.add_argument("--codes", type=names_of_codes, default=",".join(CODES), help="the first is divided by the others")
    run.add_argument("--pairs", type=int, default=5, help="rounds")
    run.add_argument("--relax", type=int, help="steps before those that count")
    run.add_argument("--steps", type=int, help="steps that count, for every code")
    run.add_argument("--beside", action="store_true", help="repose on two ranks against one beside another, and alone")
    run.add_argument("--json", type=pathlib.Path, help="results; default: WORK/results/<what was run>.json")
    return parser.parse_args()


def scene_of(args):
    program = [*measure.launcher(args.ranks), args.repose]
    if args.case == "discharge_mini":
        return beds.discharge(args.work, program, args.segment)
    make = beds.moving if args.case == "moving" else beds.settled
    return make(args.work, program, args.size, args.sizes)


def label(args):
    scene = ("segment" if args.segment else "whole") if args.case == "discharge_mini" else f"{args.size}_{args.sizes}"
    return f"{args.case}_{scene}_" + ("beside" if args.beside else f"{args.ranks}")


def save_results(args, versions, results, summary):
    path = args.json or args.work / "results" / f"{label(args)}.json"
    settings = {key: str(value) for key, value in vars(args).items()}
    save(path, versions=versions, settings=settings, summary=summary, results=results)


def compare(args):
    """Every code in turn, round after round."""
    scene, plan = scene_of(args), Plan.of(args)
    names = args.codes
    programs = {name: peers.executable(name, args.prefix, args.repose) for name in names}
    versions = {name: peers.version(name, path) for name, path in programs.items()}
    results = {name: [] for name in names}
    for turn in range(args.pairs):
        for name in names:
            code = codes.make(name, programs[name])
            folder = args.work / "runs" / name
            results[name].append(measure.cost(code, scene, args.case, plan, args.ranks, folder))
            print(f"round {turn + 1} {name:16s}", short(results[name][-1]), flush=True)
    save_results(args, versions, results, print_spread(names, results))


def short(result):
    figures = {**result["figures"], "steps": result["steps"], "cpu_seconds": result["cpu_seconds"]}
    own = ", ".join(f"{key} {value:.6g}" for key, value in figures.items() if isinstance(value, (int, float)))
    return f"{1e-6 * result['particle_steps_per_cpu_second']:8.3f} million particle-steps per cpu-second ({own})"


def print_spread(names, results):
    """Prints the processor, the spread of the speeds and of the ratios, and returns the spreads."""
    key = "particle_steps_per_cpu_second"
    levels = {r["figures"]["vector_level"] for r in results.get("repose", [])}
    print(f"\n{machine()['processor']}" + "".join(f"; repose with {level}" for level in sorted(levels)))
    summary = {"speed": {name: measure.spread([r[key] for r in results[name]]) for name in names}, "ratio": {}}
    print(f"\n{'million particle-steps per cpu-second':40s}{'min':>8s}{'median':>8s}{'max':>8s}")
    for name, values in summary["speed"].items():
        print(f"{name:40s}" + "".join(f"{1e-6 * v:8.2f}" for v in values))
    for name in names[1:]:
        summary["ratio"][name] = measure.ratios(results, names[0], name)
        print(f"{names[0] + ' / ' + name:40s}" + "".join(f"{v:8.2f}" for v in summary["ratio"][name]))
    return summary


def beside(args):
    """Two ranks against one rank that shares the machine with another run, and against one rank alone; by wall time."""
    scene, plan = scene_of(args), Plan.of(args)
    code = codes.make("repose", peers.executable("repose", args.prefix, args.repose))
    results = {"two ranks": [], "one rank beside another": [], "one rank alone": []}
    for turn in range(args.pairs):
        folder = args.work / "runs" / "repose"
        results["two ranks"].append(measure.cost(code, scene, args.case, plan, 2, folder))
        with measure.Companion(code, scene, args.case, plan, args.work / "runs" / "companion"):
            results["one rank beside another"].append(measure.cost(code, scene, args.case, plan, 1, folder))
        results["one rank alone"].append(measure.cost(code, scene, args.case, plan, 1, folder))
        for name, values in results.items():
            print(f"round {turn + 1} {name:24s}{1e-6 * values[-1]['particle_steps_per_second']:8.2f}", flush=True)
    summary = {name: measure.ratios(results, "two ranks", name, "particle_steps_per_second") for name in results}
    print(f"\n{'speed of two ranks over':40s}{'min':>8s}{'median':>8s}{'max':>8s}")
    for name, values in list(summary.items())[1:]:
        print(f"{name:40s}" + "".join(f"{v:8.2f}" for v in values))
    save_results(args, {"repose": peers.version("repose", code.executable)}, results, summary)


def main():
    args = arguments()
    args.work = args.work.resolve()
    args.prefix = (args.prefix or args.work / "peers").resolve()
    if args.command == "peers":
        peers.get(args.prefix)
        return
    args.repose = peers.executable("repose", args.prefix, args.repose)
    if args.command == "beds":
        print("the grains are in", scene_of(args).folder)
    elif args.beside:
        beside(args)
    else:
        compare(args)


main()
