"""The scaling benchmark in small: a bed on 1 and 2 ranks gives the same bits, its table and its picture; the divided
snapshots that are stored give the table of docs/performance.md.

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


def check_small_bed(source, env, folder):
    places = ("--build", str(folder / "build"), "--work", str(folder / "work"), "--results", str(folder / "results"))
    benchmark(source, env, "run", *places, "--size", "600", "--ranks", "1,2", "--steps", "64")
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
    benchmark(source, env, "plot", *places)
    assert (folder / "work" / "bed_600.png").stat().st_size > 10000


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
        programs = folder / "build" / "src"
        programs.mkdir(parents=True)
        os.symlink(os.path.abspath(sys.argv[1]), programs / "repose")
        env = {**os.environ, "PATH": f"{os.path.dirname(sys.argv[2])}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1",
               "MPLCONFIGDIR": name}
        check_small_bed(source, env, folder)
        check_document(source, env, folder)


main()
