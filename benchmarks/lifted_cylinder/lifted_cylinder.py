#!/usr/bin/python3
"""The lifted cylinder of input/lifted_cylinder.toml in repose and in LIGGGHTS, from the same settled beds.

A bed for each seed is settled by repose. From there on both programs lift the cylinder, with the same time step, coefficients and
contact law, without histories of contacts at the start. `repose measure` measures the heaps of both. LIGGGHTS's cylinder has
facets; their inner circle is that of ours.
"""

import csv
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from liggghts_files import write_data, write_stl  # noqa: E402
from report import ROOT, print_table, save, usual_options  # noqa: E402
import repose  # noqa: E402

DECK = ROOT / "input" / "lifted_cylinder.toml"
MODEL = FOLDER.parent / "throughput" / "inputs"
FACETS = 48
REST_MS = 300
FIGURES = ("angle_of_repose_deg", "pile_height_m")


def settled_bed(options, seed, folder):
    """The run whose last snapshot is the bed, before the cylinder moves."""
    at_once = ["phase.lift.time=1e-9", "phase.rest.min_time=0", "phase.rest.max_time=1e-9"]
    sets = [f"run.seed={seed}", *at_once]
    return repose.run(DECK, folder / "bed", set=sets, program=options.program, restart=True)


def lift_deck(folder, bed):
    """The deck from the bed on: its grains are those of the snapshot, and there is nothing to settle."""
    text = DECK.read_text()
    grains = f'[[particles]]\ntype = "snapshot"\nfile = "{os.path.relpath(bed, folder)}"\n\n'
    text = re.sub(r"\[\[particles\]\]\n.*?\n\n(?=\[)", grains, text, count=1, flags=re.S)
    text = re.sub(r'\[\[phase\]\]\nname = "settle"\n.*?\n\n(?=\[)', "", text, count=1, flags=re.S)
    path = folder / "lift.toml"
    path.write_text(text)
    return path


def lift_here(options, seed, folder, bed, step):
    rest = [f"phase.rest.min_time={REST_MS} ms", f"phase.rest.max_time={REST_MS} ms"]
    sets = [f"run.seed={seed}", f"time.step={step!r}", "output.snapshot_interval=0", *rest]
    return repose.run(lift_deck(folder, bed), folder / "repose", set=sets, program=options.program, restart=True)


def cylinder_of(deck, path):
    """The mesh of the cylinder, around it."""
    radius, low, high = deck["wall"]["radius"], *deck["wall"]["heights"]
    corner = radius / math.cos(math.pi / FACETS)
    ring = [(corner * math.cos(2.0 * math.pi * k / FACETS), corner * math.sin(2.0 * math.pi * k / FACETS)) for k in range(FACETS)]
    triangles = []
    for (x, y), (u, v) in zip(ring, [*ring[1:], ring[0]]):
        triangles += [((x, y, low), (x, y, high), (u, v, low)), ((u, v, low), (x, y, high), (u, v, high))]
    write_stl(path, triangles)


def resolved(run):
    """What LIGGGHTS has to know of the deck, in SI."""
    deck = tomllib.loads((run.directory / "deck.resolved.toml").read_text())
    cylinder = next(wall for wall in deck["wall"] if wall["name"] == "cylinder")
    (radius, low), (_, high) = cylinder["points"]
    grains, walls = deck["pair"]
    assert grains["materials"] == ["grains", "grains"] and walls["materials"] == ["grains", "wall"]
    lift = next(phase for phase in deck["phase"] if phase["name"] == "lift")
    return {"domain": deck["domain"], "density": deck["material"][0]["density"], "lift_s": lift["time"],
            "wall": {"radius": radius, "heights": (low, high), "speed": cylinder["motion"][0]["velocity"][2]},
            "variables": {"young": deck["material"][0]["youngs_modulus"], "poisson": deck["material"][0]["poisson_ratio"],
                          "e_grain": grains["restitution"], "e_wall": walls["restitution"],
                          "mu_grain": grains["sliding_friction"], "mu_wall": walls["sliding_friction"],
                          "mu_r_grain": grains["rolling_friction"], "mu_r_wall": walls["rolling_friction"]}}


def write_grains(path, deck, snapshot):
    grains = zip(snapshot.radius.tolist(), snapshot.position.tolist(), snapshot.velocity.tolist(), snapshot.angular_velocity.tolist())
    write_data(path, list(zip(deck["domain"]["min"], deck["domain"]["max"])), 2,
               ((1, r, deck["density"], x, v, w) for r, x, v, w in grains))


def lift_in_liggghts(options, folder, bed, step, deck):
    """The grains at the end as a list (CSV)."""
    work = folder / "liggghts"
    work.mkdir(parents=True, exist_ok=True)
    heap = work / "heap.csv"
    if heap.exists():
        return heap
    snapshot = bed.snapshots[-1]
    write_grains(work / "grains.data", deck, snapshot)
    cylinder_of(deck, work / "cylinder.stl")
    diameter = 2.0 * float(snapshot.radius.max())
    steps = {"lift": round(deck["lift_s"] / step), "rest": round(1e-3 * REST_MS / step)}
    variables = {**deck["variables"], **steps, "inputs": MODEL, "data": "grains.data", "mesh": "cylinder.stl",
                 "final": "final.dump", "dt": step, "speed": deck["wall"]["speed"], "gx": 0, "skin": 0.1 * diameter,
                 "bin": 1.2 * diameter}
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    with open(work / "said", "w") as said:
        subprocess.run([options.liggghts, "-in", FOLDER / "lifted_cylinder.liggghts", "-log", "log", *words], cwd=work,
                       stdin=subprocess.DEVNULL, stdout=said, stderr=said, check=True)
    rows = [line.split() for line in (work / "final.dump").read_text().splitlines()[9:]]
    partial = heap.with_suffix(".part")
    partial.write_text("x,y,z,radius\n" + "".join(",".join(row[1:5]) + "\n" for row in rows))
    partial.rename(heap)
    return heap


def measured(options, heap, output):
    """By the ruler of the deck."""
    program = options.program or repose.find_program()
    subprocess.run([program, "measure", heap, "--deck", DECK, "--output", output], check=True, stdout=subprocess.DEVNULL)
    figures = json.loads((output / "measurement.json").read_text())
    return {name: figures[name] for name in (*FIGURES, "angle_of_repose_stderr_deg", "particles")}


def row_of(options, seed):
    folder = options.work / str(seed)
    folder.mkdir(parents=True, exist_ok=True)
    bed = settled_bed(options, seed, folder)
    step = bed.summary["timestep_s"]
    here = lift_here(options, seed, folder, bed.snapshot_paths[-1], step)
    there = lift_in_liggghts(options, folder, bed, step, resolved(here))
    row = {"seed": seed, "build": here.summary["build"], "bed": bed.summary["state_hash"], "heap": here.summary["state_hash"], "timestep_s": step}
    row["repose"] = measured(options, here.snapshot_paths[-1], folder / "measured_repose")
    row["liggghts"] = measured(options, there, folder / "measured_liggghts")
    print(f"seed {seed} is complete", flush=True)
    return row


def table_of(rows):
    """Means and deviations of a run, and whether the means differ by less than the standard error of their difference."""
    table = []
    for figure in FIGURES:
        ours, theirs = ([row[program][figure] for row in rows] for program in ("repose", "liggghts"))
        error = math.hypot(statistics.stdev(ours), statistics.stdev(theirs)) / math.sqrt(len(rows))
        difference = statistics.mean(ours) - statistics.mean(theirs)
        table.append({"figure": figure, "repose": statistics.mean(ours), "deviation": statistics.stdev(ours),
                      "LIGGGHTS": statistics.mean(theirs), "deviation there": statistics.stdev(theirs),
                      "difference": difference, "standard error": error, "": "agree" if abs(difference) <= error else "differ"})
    return table


def main():
    parser = usual_options(__doc__, "lifted_cylinder")
    parser.add_argument("--liggghts", default="liggghts", help="the program")
    parser.add_argument("--seeds", type=int, default=6)
    parser.add_argument("--jobs", type=int, default=2, help="seeds at a time, one core each")
    options = parser.parse_args()
    if options.seeds < 2:
        parser.error("--seeds: two at least, for their scatter")
    with ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda seed: row_of(options, seed), range(1, options.seeds + 1)))
    build = [row.pop("build") for row in rows][0]
    table = table_of(rows)
    print_table(table, digits=4)
    save(options.results / "lifted_cylinder.json", build=build, table=table, rows=rows)


main()
