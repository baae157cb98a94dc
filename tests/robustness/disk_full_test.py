"""A full file system: whatever file finds it full, the run ends with exit code 4 and a message that names this file, and
leaves no half-written file under a final name. Mounts small file systems in a mount namespace of its own.

Usage: disk_full_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import sys
import tempfile

import h5py

from faulty_runs import SHORT, Job, Program, check_file_error, command
from small_disk import SmallDisk, enter_namespace

EDGE = 12  # grains along the lowest layer of the pyramid
GRAINS = sum(n * n for n in range(1, EDGE + 1))


def outcome_on(program, deck, disk, *overrides, ranks=0):
    """The message of the run on this disk, nothing when there was room. Every snapshot left behind must be readable."""
    with disk as folder:
        output = os.path.join(folder, "out")
        with Job(command(program, deck, output, *SHORT, *overrides, ranks=ranks)) as job:
            outcome = job.end()
        message = "" if outcome[0] == 0 else check_file_error(outcome, output)
        for file in os.listdir(output) if os.path.isdir(output) else []:
            if file.endswith(".hdf"):
                with h5py.File(os.path.join(output, file)) as snapshot:
                    assert len(snapshot["particles/id"]) == GRAINS
        return message


def deck_with_picture(program, folder):
    """The quick deck with a pyramid of grains on the plate: it writes every kind of file in no time."""
    with open(program.deck("discharge_quick.toml")) as file:
        text = file.read()
    fill, discharge = text.index("[[particles]]"), text.index("[measurement.discharge]")
    text = (text[:fill] + '[[particles]]\ntype = "csv"\nfile = "grains.csv"\n\n' + text[text.index("[[phase]]"):discharge] +
            text[text.index("[", discharge + 1):])
    d = 440e-6
    lines = [f"{(x - 0.5 * (n - 1)) * d},{(y - 0.5 * (n - 1)) * d},{-0.01 + 0.5 * d + (EDGE - n) * d / 2**0.5},0,0,0,0,0,0,"
             f"{0.5 * d},carbohsp\n" for n in range(1, EDGE + 1) for x in range(n) for y in range(n)]
    with open(os.path.join(folder, "grains.csv"), "w") as file:
        file.write("x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n" + "".join(lines))
    path = os.path.join(folder, "deck.toml")
    with open(path, "w") as file:
        file.write(text)
    return path


def main():
    enter_namespace()
    program = Program(*sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        test(program, deck_with_picture(program, folder))


def test(program, deck):
    # No room for one more file: each file of the run in turn is the one that cannot be created.
    found = []
    for files in range(2, 40):
        found.append(outcome_on(program, deck, SmallDisk("16m", files), "output.snapshot_interval=0"))
        print(files, "files:", found[-1] or "done", flush=True)
        if not found[-1]:
            break
    assert found[-1] == "", "never room enough"
    for name in (".repose-write-test", "series.csv", "walls.csv", "run_", "run.hdf.series", "silhouette.png", "summary.json"):
        assert any(f"/out/{name}" in message for message in found), f"{name} was never the one"
    # No room for bytes: in a series, in the first snapshot, in a later one.
    series_only = ("output.series_interval=0.01 ms", "output.snapshot_interval=0")
    many_snapshots = ("output.snapshot_interval=0.01 ms",)
    for size, overrides, name in (("4k", (), "series.csv"), ("8k", (), "walls.csv"), ("24k", series_only, "csv"),
                                  ("200k", (), "run_0000000031"), ("1500k", many_snapshots, "run_00000000")):
        for ranks in (0, 2):
            message = outcome_on(program, deck, SmallDisk(size), *overrides, ranks=ranks)
            print(f"{size}, {ranks} ranks: {message}", flush=True)
            assert name in message and message.endswith("No space left on device"), f"{size}: {message}"


main()
