#!/usr/bin/python3
"""Imports the tutorials of LIGGGHTS-PUBLIC, runs each in repose and in LIGGGHTS with several seeds, and prints tables.

Of the state at the end: the grains that are inside and have passed the face they enter through, their kinetic energy,
and the height of their centre of mass (above the lowest grain); of those with heat, the mean and the standard deviation of
the grains' temperatures. They agree when the means differ by less than three
standard deviations of a single run (of both programs together), or by less than a thousandth.

Rows are kept in the work folder, and a tutorial that has one is not run again.

Usage: compare.py TUTORIALS REPOSE [--liggghts EXECUTABLE] [--seeds N] [--work DIR] [--only NAME]
TUTORIALS is the folder examples/LIGGGHTS/Tutorials_public of the sources of LIGGGHTS-PUBLIC.
"""

import argparse
import glob
import json
import os
import re
import shutil
import statistics
import struct
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "python"))
import repose  # noqa: E402

PRIMES = [49979687, 67867967, 86028121, 104395301, 122949823, 141650939]  # none that the scripts have themselves
# Commands without a counterpart whose lack does not change the figures, or that are made up for here.
HARMLESS = ("walls do not wear", "fills the region up again")
FIGURES = ("grains", "kinetic energy (J)", "centre of mass (mm)")
WARM_FIGURES = ("mean temperature (K)", "standard deviation (K)")


def scripts_in(folder):
    found = glob.glob(os.path.join(folder, "**", "in.*"), recursive=True)
    return sorted(os.path.relpath(path, folder) for path in found)


def import_script(arguments, script, output):
    """Exit code and what was said."""
    done = subprocess.run([arguments.repose, "import", os.path.join(arguments.tutorials, script), "--output", output],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def plane_of(deck, folder):
    """A point and the normal, along the velocity, of the face that grains enter through; None without one."""
    for block in deck["particles"]:
        if block.get("region") != "face":
            continue
        wall = next(wall for wall in deck["wall"] if wall["name"] == block["face"])
        assert "rotate_angle" not in wall
        corners = first_triangle(os.path.join(folder, wall["file"]))
        corners = wall.get("scale", 1.0) * corners + np.array(wall.get("translate", [0.0, 0.0, 0.0]))
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal *= np.sign(normal @ np.array(block["velocity"]))
        return corners[0], normal
    return None


def first_triangle(path):
    with open(path, "rb") as file:
        data = file.read()
    if data.lstrip().startswith(b"solid") and b"vertex" in data:
        numbers = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)[:3]
        return np.array([[float(x) for x in corner] for corner in numbers])
    return np.array(struct.unpack("<9f", data[84 + 12:84 + 48])).reshape(3, 3)


def figures(position, velocity, mass, temperature, plane):
    if plane is not None:
        inside = (position - plane[0]) @ plane[1] >= -1e-9
        position, velocity, mass = position[inside], velocity[inside], mass[inside]
        assert temperature is None
    energy = 0.5 * float(np.sum(mass * np.sum(velocity**2, axis=1)))
    height = float(np.sum(mass * position[:, 2]) / np.sum(mass) - np.min(position[:, 2]))
    warmth = () if temperature is None else (float(np.mean(temperature)), float(np.std(temperature)))
    return len(mass), energy, 1e3 * height, *warmth


def run_repose(arguments, deck_path, output, seed, overrides, plane):
    sets = [f"run.seed={seed}", "output.snapshot_interval=0", *overrides]
    try:
        last = repose.run(deck_path, output, set=sets, program=arguments.repose).snapshots[-1]
    except repose.ReposeError as error:
        raise RuntimeError(str(error)) from None
    return figures(last.position, last.velocity, last.mass, last.temperature if "temperature" in last.names else None, plane)


def run_liggghts(arguments, script, folder, seed, plane):
    """In a copy of the tutorial: without dumps, with other seeds, and the last state written at the end."""
    shutil.copytree(os.path.dirname(os.path.join(arguments.tutorials, script)), folder, dirs_exist_ok=True)
    with open(os.path.join(arguments.tutorials, script)) as file:
        text = file.read()
    text = re.sub(r"^(dump|write_restart)\b.*$", "", text, flags=re.M)
    text = re.sub(r"\bseed \d+", f"seed {seed}", text)
    warm = " f_Temp" if re.search(r"^fix\s.*heat/gran", text, flags=re.M) else ""
    text += f"\ndump final all custom 1 final.dump id mass x y z vx vy vz{warm}\nrun 0\n"
    path = os.path.join(folder, "in.compared")
    with open(path, "w") as file:
        file.write(text)
    with open(path) as file, open(os.path.join(folder, "log"), "w") as log:
        done = subprocess.run(["stdbuf", "-o0", arguments.liggghts], stdin=file, stdout=log, stderr=log, cwd=folder, check=False)
    if done.returncode != 0 or not os.path.exists(os.path.join(folder, "final.dump")):
        with open(os.path.join(folder, "log")) as log:
            errors = [line.strip() for line in log if "ERROR" in line]
        raise RuntimeError(errors[0] if errors else f"exit code {done.returncode}")
    table = np.loadtxt(os.path.join(folder, "final.dump"), skiprows=9, ndmin=2)
    return figures(table[:, 2:5], table[:, 5:8], table[:, 1], table[:, 8] if warm else None, plane)


def agree(ours, theirs):
    for a, b in zip(zip(*ours), zip(*theirs)):
        scatter = (statistics.variance(a) + statistics.variance(b)) ** 0.5 if len(a) > 1 else 0.0
        difference = abs(statistics.mean(a) - statistics.mean(b))
        if difference > max(3.0 * scatter, 1e-3 * abs(statistics.mean(b))):
            return False
    return True


def cell(values):
    mean = statistics.mean(values)
    scatter = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{mean:.4g}" if scatter == 0.0 else f"{mean:.4g} ± {scatter:.2g}"


def run_both(arguments, work, deck_path, notes, script):
    """The cells of the table, and whether the programs agree."""
    with open(deck_path, "rb") as file:
        deck = tomllib.load(file)
    plane = plane_of(deck, os.path.dirname(deck_path))
    seeds = PRIMES[: arguments.seeds]
    with ThreadPoolExecutor(arguments.jobs) as pool:
        runs = [pool.submit(run_liggghts, arguments, script, os.path.join(work, f"liggghts_{seed}"), seed, plane)
                for seed in seeds]
        theirs = [run.result() for run in runs]
        overrides = []
        if any("fills the region up again" in note for note in notes):
            overrides = [f"particles.0.count={round(statistics.mean(t[0] for t in theirs))}"]
            notes.append("here as many grains as in LIGGGHTS")
        runs = [pool.submit(run_repose, arguments, deck_path, os.path.join(work, f"repose_{seed}"), seed, overrides, plane)
                for seed in seeds]
        ours = [run.result() for run in runs]
    columns = []
    for a, b in zip(zip(*ours), zip(*theirs)):
        columns += [cell(a), cell(b)]
    return columns + ["agree" if agree(ours, theirs) else "differ"]


def compare(arguments, script):
    """What became of a tutorial: its cells, or why there are none. Kept in the work folder."""
    work = os.path.join(arguments.work, script.replace("/", "_"))
    kept = os.path.join(work, f"row_{arguments.seeds}.json")
    if os.path.exists(kept):
        with open(kept) as file:
            return json.load(file)
    code, said = import_script(arguments, script, os.path.join(work, "deck"))
    if code != 0:
        row = {"refused": said.strip().removeprefix("repose: ")}
    else:
        notes = [line.removeprefix("without a counterpart: ") for line in said.splitlines()[1:]]
        harmful = [note for note in notes if not any(harmless in note for harmless in HARMLESS)]
        try:
            if harmful:
                raise RuntimeError("another simulation without " + "; ".join(harmful))
            row = {"cells": run_both(arguments, work, said.splitlines()[0], notes, script)}
        except RuntimeError as error:
            row = {"stopped": str(error)}
        row["notes"] = "; ".join(notes)
    os.makedirs(work, exist_ok=True)
    with open(kept, "w") as file:
        json.dump(row, file)
    return row


def table(head, rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


def report(rows):
    def head(names):
        return ["tutorial", *[text for name in names for text in (f"{name}: repose", "LIGGGHTS")]]

    cold = 2 * len(FIGURES)
    ran = [[name, *row["cells"][:cold], row["cells"][-1]] for name, row in rows.items() if "cells" in row]
    warm = [[name, *row["cells"][cold:-1]] for name, row in rows.items() if len(row.get("cells", [])) > cold + 1]
    listed = [[name, row["notes"]] for name, row in rows.items() if "cells" in row and row["notes"]]
    stopped = [[name, row["stopped"]] for name, row in rows.items() if "stopped" in row]
    refused = [[name, row["refused"]] for name, row in rows.items() if "refused" in row]
    parts = [table([*head(FIGURES), ""], ran)]
    if warm:
        parts.append(table(head(WARM_FIGURES), warm))
    for title, cells in (("listed as without a counterpart", listed), ("did not run", stopped), ("refused", refused)):
        if cells:
            parts.append(table(["tutorial", title], [[text.replace("|", "/") for text in row] for row in cells]))
    return "\n\n".join(parts)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tutorials")
    parser.add_argument("repose")
    parser.add_argument("--liggghts", default="liggghts")
    parser.add_argument("--seeds", type=int, default=4, choices=range(1, len(PRIMES) + 1))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--work", default=os.path.join(ROOT, "build", "benchmarks", "liggghts_tutorials"))
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    arguments.repose = os.path.abspath(arguments.repose)
    rows = {}
    for script in scripts_in(arguments.tutorials):
        if arguments.only not in script:
            continue
        rows[script] = compare(arguments, script)
        print(script, rows[script], file=sys.stderr, flush=True)
    print(report(rows))
    return 0


sys.exit(main())
