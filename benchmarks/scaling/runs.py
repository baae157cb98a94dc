"""Runs of the program that keep their summaries, and files of results."""

import json
import pathlib
import subprocess
import sys
import time

from states import PHASE, launcher

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))
from machine import machine  # noqa: E402


def command(program, state, steps, ranks, name):
    """The words of a run of so many steps, and where it writes."""
    folder, text, sets = state
    deck = folder / f"{name}.toml"
    deck.write_text(text + PHASE.format(steps=steps))
    options = [word for item in sets for word in ("--set", item)]
    output = folder / name
    return [*launcher(ranks), str(program), "run", str(deck), "--output", str(output), "--quiet", *options], output


def run(program, state, steps, ranks, name):
    words, output = command(program, state, steps, ranks, name)
    done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(words)}: {done.stderr.strip()}")
    return summary_in(output)


def summary_in(output):
    """Without the deck, which is in the folder beside it."""
    summary = json.loads((output / "summary.json").read_text())
    return {key: value for key, value in summary.items() if key != "deck"}


def commit():
    done = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


def save(path, **content):
    path.parent.mkdir(parents=True, exist_ok=True)
    head = {"date": time.strftime("%Y-%m-%d"), "machine": machine(), "commit": commit()}
    rows = content.pop("rows", [])
    text = json.dumps({**head, **content}, indent=1)
    if rows:  # one to a line
        text = text[:-2] + ',\n "rows": [\n  ' + ",\n  ".join(json.dumps(row) for row in rows) + "\n ]\n}"
    path.write_text(text + "\n")
    print(f"wrote {path}")


def print_table(rows):
    """A table for a document."""
    columns = list(rows[0])
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(shown(row.get(c)) for c in columns) + " |")


def shown(value):
    if value is None:
        return ""
    return f"{value:.3g}" if isinstance(value, float) and abs(value) < 1000 else f"{value:.0f}" if isinstance(value, float) else str(value)
