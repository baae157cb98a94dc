#!/usr/bin/python3
"""The three bulk processes of Dosta et al. 2024 with repose and LIGGGHTS; see README.md."""

import argparse
import json
import os
import pathlib
import sys
import time

import numpy as np

import codes
import curves
import inputs

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, machine  # noqa: E402


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--work", type=pathlib.Path, default=ROOT / "build/benchmarks/dosta2024", help="what is made")
    common.add_argument("--repose", default=str(ROOT / "build/release/src/repose"), help="executable")
    common.add_argument("--liggghts", default="/usr/bin/liggghts", help="executable")
    case = argparse.ArgumentParser(add_help=False)
    case.add_argument("--case", choices=codes.LENGTH, required=True, help="drum_mesh: of the paper's triangles")
    case.add_argument("--material", choices=codes.STEP, default="M1", help="silo: of the grains")
    case.add_argument("--orifice", type=float, choices=codes.LIP, default=0.03, help="silo: radius in m")
    case.add_argument("--count", type=int, default=100000, help="silo: grains")
    case.add_argument("--name", help="of the folder of the runs below WORK; default: the case")
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("prepare", parents=[common], help="put decks, lists of grains and meshes into WORK")
    run = commands.add_parser("run", parents=[common, case], help="run a case with one of the programs")
    run.add_argument("--code", choices=("repose", "liggghts"), required=True)
    run.add_argument("--time", type=float, required=True, help="s to simulate; of the silo after its lid has gone")
    run.add_argument("--ranks", type=int, default=1)
    run.add_argument("--set", action="append", default=[], help="key=value, overrides a key of repose's deck")
    compare = commands.add_parser("compare", parents=[common, case], help="of both programs' runs: JSON and plot")
    compare.add_argument("--json", type=pathlib.Path, help="default: results/<name>.json beside this script")
    return parser.parse_args()


def run(args):
    folder = args.work / (args.name or args.case)
    folder.mkdir(exist_ok=True)
    output = folder / args.code
    timing = (codes.repose if args.code == "repose" else codes.liggghts)(args, args.work, output)
    facts = {"cpu_seconds": timing.cpu, "wall_seconds": timing.wall, "ranks": args.ranks}
    (output / "timing.json").write_text(json.dumps(facts))
    print(f"{args.case} with {args.code}: {timing.cpu:.0f} cpu-seconds, {timing.wall:.0f} s")


def difference(ours, theirs):
    """Of two curves over the time that both cover, at our times."""
    (time_s, values), (their_time, their_values) = ours, theirs
    shared = time_s <= their_time[-1] * (1.0 + 1e-9)
    mine, other = values[shared], np.interp(time_s[shared], their_time, their_values)
    return {"until_s": float(time_s[shared][-1]), "repose_at_end": float(mine[-1]), "liggghts_at_end": float(other[-1]),
            "greatest_difference": float(np.max(np.abs(mine - other))), "greatest_value": float(np.max(np.abs(other)))}


def cost(folder, steps, particles):
    facts = json.loads((folder / "timing.json").read_text())
    speed = particles * steps / facts["cpu_seconds"]
    return {**facts, "steps": steps, "particle_steps_per_cpu_second": speed}


def compare(args):
    name = args.name or args.case
    folder = args.work / name
    summary = inputs.repose.Run(folder / "repose").summary
    dt, particles = summary["timestep_s"], summary["particles"]["inserted"]
    ours = curves.repose_curves(args.case, folder / "repose")
    theirs = curves.liggghts_curves(folder / "liggghts", dt)
    costs = {"repose": cost(folder / "repose", summary["steps"], particles),
             "liggghts": cost(folder / "liggghts", int(theirs["Step"][1][-1]), particles)}
    shared = [key for key in ours if key in theirs]
    results = {"case": name, "date": time.strftime("%Y-%m-%d"), "machine": machine(),
               "versions": {"repose": summary["build"], "liggghts": codes.version(args)},
               "particles": particles, "time_step_s": dt, "state_hash": summary["state_hash"], "cost": costs,
               "differences": {key: difference(ours[key], theirs[key]) for key in shared},
               "curves": {"repose": {key: thinned(*ours[key]) for key in ours},
                          "liggghts": {key: thinned(*theirs[key]) for key in shared}}}
    path = args.json or inputs.FOLDER / "results" / f"{name}.json"
    lines = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in results.items()]
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    report(results)
    plot(folder / f"{name}.png", ours, theirs, [key for key in shared if key not in curves.ENERGIES])
    print("results in", path, "and a plot in", folder / f"{name}.png")


def thinned(time_s, values, most=201):
    """At most so many points of a curve, in seven digits."""
    step = -(-len(values) // most)
    return {"time_s": [float(f"{t:.7g}") for t in time_s[::step]], "value": [float(f"{v:.7g}") for v in values[::step]]}


def report(results):
    for key, d in results["differences"].items():
        print(f"{key:24s} until {d['until_s']:.4g} s: repose {d['repose_at_end']:.6g}, "
              f"LIGGGHTS {d['liggghts_at_end']:.6g}, "
              f"greatest difference {d['greatest_difference']:.3g} of {d['greatest_value']:.3g}")
    for code, c in results["cost"].items():
        print(f"{code:10s} {c['steps']} steps in {c['cpu_seconds']:.0f} cpu-seconds: "
              f"{1e-6 * c['particle_steps_per_cpu_second']:.2f} million particle-steps per cpu-second")


def plot(path, ours, theirs, keys):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots()
    for key in keys:
        (line,) = axes.plot(*ours[key], label=f"{key}, repose")
        axes.plot(*theirs[key], "--", color=line.get_color(), label=f"{key}, LIGGGHTS")
    axes.set_xlabel("time in s")
    axes.legend()
    figure.savefig(path, dpi=120)


def main():
    args = arguments()
    args.work, args.repose = args.work.resolve(), os.path.abspath(args.repose)
    if os.sep in args.liggghts:  # else it is in PATH
        args.liggghts = os.path.abspath(args.liggghts)
    if args.command == "compare" and args.json:
        args.json = args.json.resolve()
    inputs.prepare(args.work)
    os.chdir(args.work)  # LIGGGHTS leaves a file where it runs
    if args.command != "prepare":
        {"run": run, "compare": compare}[args.command](args)


main()
