"""Whether two runs of one deck have left the same results, to the bit."""

import json
import os

# What may differ between two runs of one deck: time and place.
OF_THE_RUN = ("ranks", "restarts", "wall_seconds", "particle_steps_per_second", "timing", "lists", "parallel", "memory")


def summary_of(output):
    with open(os.path.join(output, "summary.json")) as file:
        return json.load(file)


def bytes_of(output, name):
    with open(os.path.join(output, name), "rb") as file:
        return file.read()


def check_same_results(output, reference):
    """The same files and nothing else, the same bytes in them, but for what a summary tells of the run itself."""
    names, expected = sorted(os.listdir(output)), sorted(os.listdir(reference))
    assert names == expected, f"files {names} instead of {expected}"
    ours, theirs = summary_of(output), summary_of(reference)
    assert ours["state_hash"] == theirs["state_hash"], f"{ours['state_hash']} instead of {theirs['state_hash']}"
    for key in theirs:
        assert key in OF_THE_RUN or ours[key] == theirs[key], f"{key}: {ours[key]} instead of {theirs[key]}"
    for name in names:
        if name != "summary.json":
            assert bytes_of(output, name) == bytes_of(reference, name), f"{name} differs"


def rows_of(output, name="series.csv"):
    """Complete rows of a series so far."""
    try:
        return bytes_of(output, name).count(b"\n")
    except FileNotFoundError:
        return 0


def checkpoints_of(output):
    """Their names, the newest first."""
    names = os.listdir(output) if os.path.isdir(output) else []
    return sorted((n for n in names if n.startswith("checkpoint_") and n.endswith(".hdf")), reverse=True)
