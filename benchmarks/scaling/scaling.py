#!/usr/bin/python3
"""Strong and weak scaling, load balance of a discharge, and what a cluster would make of them; see README.md."""

import argparse
import json
import pathlib
import shutil
import statistics
import subprocess
import sys

import model
import plots
import states
from runs import in_step, run, run_at_once, summary_in

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, print_table, save  # noqa: E402

CASES = ("bed", "weak", "discharge")
BESIDE = ("efficiency", "of ranks in step", "at equal speed", "faster core over slower")  # what `beside` reports
TURN = 25  # steps of ranks in step, then as many of free ones


def numbers(text):
    return [int(word) for word in text.split(",")]


def arguments():
    formatter = argparse.ArgumentDefaultsHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__)
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--work", type=pathlib.Path, default=ROOT / "build/benchmarks/scaling", help="what is made")
    common.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="program and tools")
    common.add_argument("--results", type=pathlib.Path, default=ROOT / "benchmarks/results/scaling", help="JSON files")
    scene = argparse.ArgumentParser(add_help=False)
    scene.add_argument("--case", choices=CASES, default="bed", help="weak: a bed of --size grains for each rank")
    scene.add_argument("--size", type=int, default=156000, help="grains of a bed; usual: 156000, 1000000, weak 50000")
    scene.add_argument("--snapshot", type=pathlib.Path, help="discharge: where it starts")
    scene.add_argument("--steps", type=int, default=500, help="that are measured")
    commands = parser.add_subparsers(dest="command", required=True)
    sub = commands.add_parser("run", parents=[common, scene], formatter_class=formatter, help="a list of rank counts")
    sub.add_argument("--ranks", type=numbers, default="1,2,4,8", help="rank counts")
    sub.add_argument("--rounds", type=int, default=1, help="the median of the times is taken")
    sub = commands.add_parser("beside", parents=[common, scene], formatter_class=formatter,
                              help="two ranks on two cores against two runs of one rank, and against ranks in step")
    sub.add_argument("--rounds", type=int, default=5, help="of both, in alternation")
    sub = commands.add_parser("partition", parents=[common], formatter_class=formatter, help="divide snapshots offline")
    sub.add_argument("snapshots", type=pathlib.Path, nargs="+", help="in the order of time")
    sub.add_argument("--parts", type=numbers, default="8,16,32,64,128,256,512", help="numbers of parts")
    sub.add_argument("--name", default="partition", help="of the results")
    sub = commands.add_parser("balance", parents=[common], formatter_class=formatter, help="a discharge on 8 ranks")
    sub.add_argument("--deck", type=pathlib.Path, default=ROOT / "input/scatter_mini.toml", help="with phases")
    sub.add_argument("--ranks", type=int, default=8, help="of the run")
    sub.add_argument("--set", action="append", default=[], help="override of the deck")
    sub.add_argument("--interval", type=float, default=2e-3, help="s between the snapshots that are divided")
    sub.add_argument("--runs", default="one_rank,balanced,not_balanced", help="those whose snapshots are divided come first")
    sub = commands.add_parser("predict", parents=[common], formatter_class=formatter, help="efficiency on a cluster, a model")
    sub.add_argument("--grain-ns", type=float, help="of a grain and a step on another processor, instead of the measured; printed only")
    sub.add_argument("--pair-ns", type=float, help="of a pair of it, likewise")
    sub = commands.add_parser("plot", parents=[common], formatter_class=formatter, help="pictures of all results")
    return parser.parse_args()


def state_of(args, ranks):
    if args.case == "discharge":
        if args.snapshot is None:
            raise SystemExit("--case discharge needs a --snapshot")
        return states.discharge(args.work, args.snapshot)
    size = args.size * ranks if args.case == "weak" else args.size
    return states.settled_bed(args.program, args.work, size)


def label(args):
    return f"discharge_{args.snapshot.stem}" if args.case == "discharge" else f"{args.case}_{args.size}"


def run_ranks(args):
    """Every rank count in turn, round after round; the same bits on all of them."""
    kept = {ranks: [] for ranks in args.ranks}
    for _ in range(args.rounds):
        for ranks in args.ranks:
            summary = run(args.program, state_of(args, ranks), args.steps, ranks, f"on_{ranks}")
            kept[ranks].append(summary)
            print(f"{ranks} ranks: {summary['timing']['loop_wall_s']:.2f} s", flush=True)
    hashes = {summary["state_hash"] for runs in kept.values() for summary in runs}
    if args.case != "weak" and len(hashes) != 1:
        raise SystemExit(f"the states differ: {sorted(hashes)}")
    table = table_of(kept, args.case)
    print_table(table)
    save(args.results / f"{label(args)}.json", case=args.case, steps=args.steps, table=table,
         runs={str(ranks): runs for ranks, runs in kept.items()})


def middle(runs, of):
    return statistics.median(of(s) for s in runs)


def wall(summary):
    return summary["timing"]["loop_wall_s"]


def table_of(kept, case):
    """One row for each rank count. Efficiencies are those of the smallest one; that of the work leaves out waiting and
    needs no core for each rank."""
    least = min(kept)

    def work(ranks):
        return middle(kept[ranks], lambda s: s["parallel"]["work_cpu_s"]["max"])

    rows = []
    for ranks, runs in kept.items():
        share = ranks / least if case != "weak" else 1.0
        p, grains = runs[0]["parallel"], runs[0]["particles"]["inside"]
        stages = runs[0]["timing"]["stages"]
        rows.append({
            "ranks": ranks,
            "wall s": middle(runs, wall),
            "efficiency": middle(kept[least], wall) / middle(runs, wall) / share,
            "efficiency of the work": work(least) / work(ranks) / share,
            "imbalance of pairs": p["imbalance"],
            "of cpu time": middle(runs, lambda s: s["parallel"]["work_cpu_s"]["max"] / s["parallel"]["work_cpu_s"]["mean"]),
            "ghosts per grain": p["ghosts_per_step"]["mean"] * ranks / grains,
            "communication share": sum(stages[name]["mean_s"] for name in ("ghosts", "agreement")) / wall(runs[0]),
            "messages": p["messages_per_step"]["max"],
            "kB": p["bytes_per_step"]["max"] / 1e3,
            "collectives": p["collectives_per_step"],
        })
    return rows


def spread_of(values):
    return {"min": min(values), "median": statistics.median(values), "max": max(values)}


def at_equal_speed(one, two):
    """Efficiency of two ranks if their cores were equally fast: the loop over the work (contacts and integration, in processor
    time) of the single runs, mean of both, and of that of the two ranks which waits least; less the pairs that both evaluate."""
    busiest = two["parallel"]
    alone = statistics.mean(wall(run) / run["parallel"]["work_cpu_s"]["mean"] for run in one)
    return alone / (wall(two) / busiest["work_cpu_s"]["max"]) * (
        one[0]["parallel"]["pairs_per_step"]["mean"] / (2.0 * busiest["pairs_per_step"]["max"]))


def beside(args):
    """Parallel efficiency of two ranks on two cores: their speed over the sum of the speeds of two independent runs of one
    rank, each of which keeps a core and its share of the memory busy for the other. And what the cores allow: that of
    two ranks which exchange nothing, but wait for one another at every step."""
    state = state_of(args, 1)
    half = state if args.case == "discharge" else states.settled_bed(args.program, args.work, args.size // 2)
    lockstep = args.build.resolve() / "benchmarks/scaling/repose_lockstep"
    kept = []
    for turn in range(args.rounds):
        two = run(args.program, state, args.steps, 2, "two")
        one = run_at_once(args.program, state, args.steps, ["one", "other"])
        if len({summary["state_hash"] for summary in (two, *one)}) != 1:
            raise SystemExit("the states differ")
        kept.append({"efficiency": 1.0 / wall(two) / sum(1.0 / wall(summary) for summary in one),
                     "of ranks in step": in_step(lockstep, half, TURN, max(1, args.steps // TURN), 2),
                     "at equal speed": at_equal_speed(one, two),
                     "faster core over slower": max(map(wall, one)) / min(map(wall, one)), "one": one, "two": two})
        print(f"round {turn + 1}: " + ", ".join(f"{key} {kept[-1][key]:.3f}" for key in BESIDE), flush=True)
    table = [{"": key} | spread_of([turn[key] for turn in kept]) for key in BESIDE]
    print_table(table)
    save(args.results / f"beside_{label(args)}.json", steps=args.steps, table=table, rows=kept)


def divide(args, snapshots, parts):
    program = args.build / "benchmarks/scaling/repose_partition"
    words = [program, ",".join(map(str, parts)), *snapshots]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def partition(args):
    rows = divide(args, args.snapshots, args.parts)
    print_table(means_of(rows, "new"))
    save(args.results / f"{args.name}.json", rows=rows)


def means_of(rows, planes):
    """Over the snapshots, for each number of parts."""
    table = []
    for parts in sorted({row["parts"] for row in rows}):
        of = [row for row in rows if row["parts"] == parts and row["planes"] == planes]

        def mean(pick):
            return statistics.mean(pick(row) for row in of)

        table.append({"parts": parts, "grains per part": mean(lambda r: r["particles"]) / parts,
                      "imbalance of cost": mean(lambda r: r["cost_imbalance"]),
                      "of pairs": mean(lambda r: r["pair_imbalance"]),
                      "pairs evaluated over pairs": mean(lambda r: r["pairs_evaluated_over_pairs"]),
                      "ghosts per grain": mean(lambda r: r["ghosts_per_particle"]),
                      "neighbours, mean": mean(lambda r: r["neighbours"]["mean"]),
                      "most": max(r["neighbours"]["max"] for r in of),
                      "kB per step, mean": mean(lambda r: r["bytes_per_step"]["mean"]) / 1e3,
                      "greatest kB": max(r["bytes_per_step"]["max"] for r in of) / 1e3})
    return table


def balance(args):
    """A whole discharge on some ranks, with and without new decompositions; and its snapshots, divided offline. Runs
    that are complete are not run again; those of another deck are refused."""
    folder = args.work / f"balance_{args.deck.stem}_{args.ranks}_{args.interval}"
    folder.mkdir(parents=True, exist_ok=True)
    ways = {"one_rank": (1, [f"output.snapshot_interval={args.interval}"]), "balanced": (args.ranks, []),
            "not_balanced": (args.ranks, ["neighbours.max_imbalance=1e6"])}
    kept = {}
    for name in args.runs.split(","):
        ranks, sets = ways[name]
        output = folder / name
        if not (output / "summary.json").exists():
            shutil.rmtree(output, ignore_errors=True)  # half of a run has no time of its own
        states.repose.run(args.deck, output, set=[*args.set, *sets], ranks=ranks, program=args.program, restart=True)
        kept[name] = summary_in(output)
    if len({summary["state_hash"] for summary in kept.values()}) != 1:
        raise SystemExit("the states differ")
    rows = divide(args, states.repose.Run(folder / "one_rank").snapshot_paths, [args.ranks])
    table = balance_table(kept, rows)
    print_table(table)
    save(args.results / f"balance_{args.deck.stem}.json", ranks=args.ranks, sets=args.set, table=table, rows=rows, runs=kept)


def balance_table(kept, rows):
    table = []
    for name, planes in (("balanced", "bound"), ("not_balanced", "first")):
        of = [row for row in rows if row["planes"] == planes]
        row = {"planes": "as they are renewed" if planes == "bound" else "those of the start",
               "snapshots: mean of cost": statistics.mean(r["cost_imbalance"] for r in of),
               "of pairs": statistics.mean(r["pair_imbalance"] for r in of),
               "greatest of pairs": max(r["pair_imbalance"] for r in of)}
        if name in kept:
            p = kept[name]["parallel"]
            row |= {"run: mean of pairs": p["imbalance"], "cpu time": p["work_cpu_s"]["max"] / p["work_cpu_s"]["mean"],
                    "decompositions": p["bisections"]}
        table.append(row)
    return table


def predict(args):
    if (args.grain_ns is None) != (args.pair_ns is None):
        raise SystemExit("--grain-ns and --pair-ns go together")
    measured = model.Measured(args.results)
    if args.grain_ns:
        measured.grain_s, measured.pair_s = 1e-9 * args.grain_ns, 1e-9 * args.pair_ns
    table = model.predict(measured)
    print_table(table)
    if args.grain_ns:
        return
    save(args.results / "prediction.json", assumptions=model.ASSUMPTIONS, table=table)


def main():
    args = arguments()
    args.work = args.work.resolve()
    args.program = args.build.resolve() / "src/repose"
    {"run": run_ranks, "beside": beside, "partition": partition, "balance": balance, "predict": predict,
     "plot": plots.draw_all}[args.command](args)


if __name__ == "__main__":
    main()
