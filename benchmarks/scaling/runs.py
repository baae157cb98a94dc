"""Runs of the program that keep their summaries."""

import json
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

from states import PHASE, launcher, repose


def deck_for(state, steps, name):
    """Where the deck of a state stands, with so many steps to do."""
    folder, text, _ = state
    deck = folder / f"{name}.toml"
    deck.write_text(text + PHASE.format(steps=steps))
    return deck


def output_of(words):
    """What a command prints; the end of everything, with its words, when it fails."""
    done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(words)}: {done.stderr.strip()}")
    return done.stdout


def run(program, state, steps, ranks, name):
    """The summary of a run of so many steps; what an earlier one left in its place is removed."""
    folder, _, sets = state
    output = folder / name
    shutil.rmtree(output, ignore_errors=True)
    try:
        repose.run(deck_for(state, steps, name), output, set=sets, ranks=ranks, program=str(program))
    except repose.ReposeError as error:
        raise SystemExit(f"{name}: {error}") from None
    return summary_in(output)


def run_at_once(program, state, steps, names):
    """Runs of one rank each, all started at the same time; their summaries."""
    with ThreadPoolExecutor(len(names)) as pool:
        return list(pool.map(lambda name: run(program, state, steps, 1, name), names))


def in_step(program, state, steps, turns, ranks):
    """By lockstep.cpp: how fast ranks are that simulate the same state, each for itself, and wait for one another at every
    step, over what they are without waiting."""
    deck = deck_for(state, 2 * steps * turns, "in_step")
    times = json.loads(output_of([*launcher(ranks), str(program), str(deck), str(steps), str(turns), *state[2]]))
    free = sum(1.0 / seconds for seconds in times["free_s"]) / ranks
    return 1.0 / max(times["in_step_s"]) / free


def summary_in(output):
    """Without the deck, which is in the folder beside it."""
    return {key: value for key, value in repose.Run(output).summary.items() if key != "deck"}
