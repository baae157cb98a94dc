"""What is measured: settled beds of any number of grains, and the state of a discharge in a snapshot."""

import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "python"))
import repose  # noqa: E402

BED = pathlib.Path(__file__).resolve().parent / "bed.toml"
BED_SIZE, BED_EDGE = 156000, 38.9e-3  # grains, m
LEFT_OUT = ("[[particles]]", "[particles.", "[[particles.", "[[phase]]", "[measurement.", "[output]")
PHASE = """
[[phase]]
name = "measured"
until = "steps"
steps = {steps}
"""
PARTICLES = """
[[particles]]
type = "snapshot"
file = "{file}"
"""
OUTPUT = """
[output]
series_interval = 1e3
checkpoint_minutes = 0
"""


def launcher(ranks):
    return ["mpirun", "-n", str(ranks)] if ranks > 1 else []


def blocks(text):
    """The text of a deck, divided before each header."""
    parts = [[]]
    for line in text.splitlines():
        if line.startswith("["):
            parts.append([])
        parts[-1].append(line)
    return ["\n".join(part) for part in parts]


def without(text, headers):
    return "\n".join(block for block in blocks(text) if not block.startswith(headers)) + "\n"


def settled_bed(program, work, size):
    """The deck of a settled bed, from the program's own snapshot, and the overrides for its size. Made once: settling
    takes 10 000 steps, on as many cores as there are for 20 000 grains each."""
    edge = BED_EDGE * math.sqrt(size / BED_SIZE)
    sets = [f"domain.max=[{edge + 1e-3}, {edge + 1e-3}, 0.03]", f"wall.east.point=[{edge}, 0.0, 0.0]",
            f"wall.north.point=[0.0, {edge}, 0.0]"]
    folder = work / f"bed_{size}"
    state = folder / "state.hdf"
    if not state.exists():
        folder.mkdir(parents=True, exist_ok=True)
        fill = [f"particles.0.count={size}", f"particles.0.max=[{edge}, {edge}, 0.025]"]
        ranks = max(1, min(len(os.sched_getaffinity(0)), size // 20000))
        run = repose.run(BED, folder / "settling", set=[*sets, *fill], ranks=ranks, program=program, restart=True)
        run.snapshot_paths[0].rename(state)
    text = without(BED.read_text(), LEFT_OUT) + PARTICLES.format(file=state) + OUTPUT
    return folder, text, sets


def discharge(work, snapshot):
    """The deck of a snapshot, without what it measures and without the walls that its phases remove."""
    text = repose.Snapshot(snapshot).deck_text
    removed = [block for block in blocks(text) if block.startswith("[[phase]]")]
    names = {name for block in removed for line in block.splitlines() if line.startswith("remove_walls")
             for name in line.split('"')[1::2]}
    folder = work / f"discharge_{snapshot.stem}"
    folder.mkdir(parents=True, exist_ok=True)
    text = without(text, LEFT_OUT) + PARTICLES.format(file=snapshot.resolve()) + OUTPUT
    return folder, text, [f"wall.{name}.present=false" for name in sorted(names)]
