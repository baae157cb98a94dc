"""Runs of the program that keep their summaries."""

import json
import shutil
import subprocess

from states import PHASE, launcher


def command(program, state, steps, ranks, name):
    """The words of a run of so many steps, and the place where it writes, cleared of what an earlier run left."""
    folder, text, sets = state
    deck = folder / f"{name}.toml"
    deck.write_text(text + PHASE.format(steps=steps))
    options = [word for item in sets for word in ("--set", item)]
    output = folder / name
    shutil.rmtree(output, ignore_errors=True)
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
