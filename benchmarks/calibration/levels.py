#!/usr/bin/python3
"""What a search over levels of a model costs against one on the level that counts alone; see README.md."""

import json
import os
import pathlib
import shutil
import sys
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks"), str(ROOT / "tests" / "regression")]
from laboratories import FRICTION, misfit_at  # noqa: E402
import cheap_levels  # noqa: E402
from report import print_table, save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402

BASE = ROOT / "input" / "discharge_mini.toml"
# Phases end when the grains are at rest, most of them sooner than at the deck's own times.
AT_REST = {'until = "time"\ntime = 0.25': 'until = "kinetic_energy"\nkinetic_energy = 1e-13\nmin_time = 0.1\nmax_time = 0.25',
           'until = "time"\ntime = 1.1': 'until = "kinetic_energy"\nkinetic_energy = 1e-10\nmin_time = 0.25\nmax_time = 1.1',
           "snapshot_times = [0.25]": ""}
STUDY = replace(FRICTION, sets=[], seeds=2)
LEVEL = """
[[level]]
name = "{}"
set = {}
start = {}
[[level]]
name = "mini"
start = 5
"""
# What is searched, over which cheap level, and with how many core-hours of 8e6 particle-steps a second at most: coarse grains go
# on from their first batch, soft ones do not.
SEARCHES = {
    "coarse": (LEVEL.format("coarse", json.dumps(cheap_levels.CANDIDATES["d55"][1]), 18), 1.5),
    "soft": (LEVEL.format("soft", json.dumps(cheap_levels.CANDIDATES["d44"][1]), 14), 0.9),
    "alone": ("", 2.2),
}
CHEAP = [kind for kind, (levels, _) in SEARCHES.items() if levels]
ADAPTIVE = {"start": 9, "batch": 2}
FIRST_BATCH = {"budget_core_hours": 1e-6, "half_width": 0.1}  # a search that ends after its first batch


class Searches:
    def __init__(self, options):
        self.options, self.work = options, options.work
        self.work.mkdir(parents=True, exist_ok=True)
        self.base = self.work / "discharge_mini.toml"
        text = BASE.read_text()
        for ends, rests in AT_REST.items():
            text = text.replace(ends, rests)
        self.base.write_text(text)

    def calibrate(self, name, text):
        """Does what is missing of the runs of a deck and estimates."""
        deck = self.work / f"{name}.toml"
        deck.write_text(text)
        return repose.calibrate(deck, self.work / name, ranks=self.options.ranks, program=self.options.program)

    def search(self, name, laboratory, half_width, budget, levels=""):
        """A search that ends at the half-width or at the budget. Its first batch is the same for every laboratory: it is
        run once and copied, and counts in each."""
        begun = self.first_batch(name.split("_")[0], STUDY, laboratory, levels)
        shutil.copytree(begun.directory / "runs", self.work / name / "runs", dirs_exist_ok=True)
        adaptive = ADAPTIVE | {"budget_core_hours": budget, "half_width": half_width}
        return self.calibrate(name, STUDY.search(self.base, laboratory, adaptive) + levels)

    def first_batch(self, kind, study, laboratory, levels=""):
        """The first batch of the searches of a kind."""
        return self.calibrate(f"start_{kind}", study.search(self.base, laboratory, ADAPTIVE | FIRST_BATCH) + levels)


def row_of(search, hidden):
    """What a search has found, and how its half-width fell with its cost, in core-hours of 8e6 particle-steps a second."""
    found = search.estimate
    particle_steps, cpu_seconds = zip(*cheap_levels.work_of(search))
    return {"particle_steps": sum(particle_steps), "cpu_hours": sum(cpu_seconds) / 3600.0,
            "way": [{"core_hours": hours, "half_width": width if width == width else None}
                    for hours, width in zip(search.search["core_hours"].tolist(), search.search["half_width"].tolist())],
            "half_width": found["half_width"], "values": [p["values"] for p in found["points"]],
            "covered": misfit_at(found["surfaces"], hidden) <= found["limit"],
            "levels": found.get("levels"), "links": [o.get("links") for o in found["observables"]]}


def cost_of(way, half_width):
    """Core-hours after which a search stayed at this half-width or below."""
    stays = [all((later["half_width"] or 1.0) <= half_width for later in way[k:]) for k in range(len(way))]
    return way[stays.index(True)]["core_hours"]


def compare(ways):
    """The costs of a search over levels and of one on the last alone, at the least half-width that both came to."""
    half_width = max(way[-1]["half_width"] or 1.0 for way in ways)
    levels, alone = (cost_of(way, half_width) for way in ways)
    return {"half_width": half_width, "core_hours": levels, "alone_core_hours": alone, "share": levels / alone}


def main():
    parser = usual_options(__doc__, "calibration")
    parser.set_defaults(work=ROOT / "build" / "benchmarks" / "levels")
    parser.add_argument("--ranks", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--half-width", type=float, default=0.08, help="of the widest interval, at which a search over levels ends")
    parser.add_argument("--cheap", action="store_true", help="compare cheap levels at nine points instead")
    parser.add_argument("--anew", action="store_true", help="do not go on from the results of an earlier call")
    options = parser.parse_args()
    searches = Searches(options)
    rows = rows_so_far(options)
    if not rows:
        values = STUDY.laboratory_values(searches.calibrate("hidden", STUDY.laboratories(searches.base)).directory)
        rows = [{"hidden": hidden, "laboratory": laboratory} for hidden, laboratory in zip(STUDY.hidden, values)]
        save(options.results / "levels.json", rows=rows)
    if options.cheap:
        table = cheap_levels.compare(searches, STUDY, rows[0]["laboratory"])
        save(options.results / "cheap_levels.json", rows=table)
        print_table(table)
        return
    for kind, (levels, budget) in SEARCHES.items():
        for number, row in enumerate(rows):
            if kind in row:
                continue
            half_width = options.half_width if levels else min(row[cheap]["half_width"] for cheap in CHEAP)
            row[kind] = row_of(searches.search(f"{kind}_{number}", row["laboratory"], half_width, budget, levels), row["hidden"])
            print(row["hidden"], kind, row[kind], flush=True)
            save(options.results / "levels.json", rows=rows)
    print_table([table_row(row, kind) for kind in CHEAP for row in rows])


def table_row(row, kind):
    """What a search over a cheap level came to, and the costs at the same half-width."""
    same = compare([row[kind]["way"], row["alone"]["way"]])
    return {"cheap level": kind, "hidden": f"{row['hidden'][0]}, {row['hidden'][1]}", "half-width": row[kind]["half_width"],
            "core-hours": row[kind]["way"][-1]["core_hours"], "in the region": "yes" if row[kind]["covered"] else "no",
            "alone: half-width": row["alone"]["half_width"], "alone: core-hours": row["alone"]["way"][-1]["core_hours"],
            "alone: in the region": "yes" if row["alone"]["covered"] else "no",
            "at half-width": same["half_width"], "cost": same["core_hours"], "alone costs": same["alone_core_hours"], "share": same["share"]}


def rows_so_far(options):
    """What an earlier call has found: each search is kept as soon as it ends."""
    path = options.results / "levels.json"
    return [] if options.anew or not path.exists() else json.loads(path.read_text())["rows"]


if __name__ == "__main__":
    main()
