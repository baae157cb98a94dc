"""The scaling benchmark in small: a bed on 1 and 2 ranks gives the same bits, its table and its picture; two ranks are
measured against independent ones; a snapshot is divided; the stored results give the table of docs/performance.md.

Usage: scaling_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def benchmark(source, env, *words):
    done = subprocess.run([sys.executable, os.path.join(source, "benchmarks", "scaling", "scaling.py"), *words], env=env,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def places(folder):
    return "--build", str(folder / "build"), "--work", str(folder / "work"), "--results", str(folder / "results")


def check_small_bed(source, env, folder):
    benchmark(source, env, "run", *places(folder), "--size", "600", "--ranks", "1,2", "--steps", "64")
    content = json.loads((folder / "results" / "bed_600.json").read_text())
    one, two = content["table"]
    assert one["efficiency"] == 1.0 and one["ghosts per grain"] == 0.0 and one["messages"] == 0.0, one
    assert two["ranks"] == 2 and two["ghosts per grain"] > 0.05 and 1.0 <= two["imbalance of pairs"] < 1.5, two
    runs = content["runs"]
    assert runs["1"][0]["state_hash"] == runs["2"][0]["state_hash"]
    spread = runs["2"][0]["parallel"]
    # What one rank sends each step the other one has for ghosts, 72 bytes each; rebuilds add to it.
    assert abs(spread["bytes_per_step"]["mean"] / 72.0 - spread["ghosts_per_step"]["mean"]) < 0.5 * spread["ghosts_per_step"]["mean"]
    assert 0.0 < spread["work_cpu_s"]["min"] <= spread["work_cpu_s"]["max"], spread
    benchmark(source, env, "plot", *places(folder))
    assert (folder / "work" / "bed_600.png").stat().st_size > 10000


def check_two_ranks(source, env, folder):
    """The table of `beside` has what it says, from runs that are in the file."""
    benchmark(source, env, "beside", *places(folder), "--size", "600", "--rounds", "2", "--steps", "50")
    content = json.loads((folder / "results" / "beside_bed_600.json").read_text())
    assert [row[""] for row in content["table"]] == ["efficiency", "of ranks in step", "at equal speed", "faster core over slower"]
    for row in content["table"]:
        assert 0.0 < row["min"] <= row["median"] <= row["max"], row
    for turn in content["rows"]:
        speeds = [1.0 / run["timing"]["loop_wall_s"] for run in (turn["two"], *turn["one"])]
        assert abs(turn["efficiency"] - speeds[0] / (speeds[1] + speeds[2])) < 1e-12, turn["efficiency"]
        assert turn["two"]["state_hash"] == turn["one"][0]["state_hash"] == turn["one"][1]["state_hash"]


def check_division(source, env, folder):
    """`partition` divides all grains of a snapshot, and more parts have more ghosts."""
    benchmark(source, env, "partition", *places(folder), "--parts", "2,8", str(folder / "work" / "bed_600" / "state.hdf"))
    rows = [row for row in json.loads((folder / "results" / "partition.json").read_text())["rows"] if row["planes"] == "new"]
    assert [row["parts"] for row in rows] == [2, 8] and {row["particles"] for row in rows} == {600}, rows
    assert 0.05 < rows[0]["ghosts_per_particle"] < rows[1]["ghosts_per_particle"], rows
    assert 1.0 <= rows[1]["cost_imbalance"] < 1.5 and rows[1]["pairs_evaluated_over_pairs"] > 1.1, rows


def check_document(source, env, folder):
    """Every row of the table that `predict` prints stands in the document."""
    results = pathlib.Path(source, "benchmarks", "results", "scaling")
    copies = folder / "stored"
    copies.mkdir()
    for path in results.glob("*.json"):
        (copies / path.name).write_text(path.read_text())
    said = benchmark(source, env, "predict", "--results", str(copies))
    text = pathlib.Path(source, "docs", "performance.md").read_text()
    rows = [line for line in said.splitlines() if line.startswith("|") and not re.fullmatch(r"[|-]+", line)]
    assert len(rows) > 10, said
    for row in rows:
        assert row in text, f"docs/performance.md lacks the row\n{row}"


def main():
    source = os.path.abspath(sys.argv[3])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.symlink(pathlib.Path(sys.argv[1]).resolve().parents[1], folder / "build")
        env = {**os.environ, "PATH": f"{os.path.dirname(sys.argv[2])}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1",
               "MPLCONFIGDIR": name}
        check_small_bed(source, env, folder)
        check_two_ranks(source, env, folder)
        check_division(source, env, folder)
        check_document(source, env, folder)


main()
