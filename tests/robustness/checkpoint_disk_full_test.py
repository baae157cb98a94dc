"""A disk that is full when a checkpoint is due: exit 4 with its name, the last good ones stay, and with room again the run
goes on to the same results.

Usage: checkpoint_disk_full_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import errno
import os
import sys
import tempfile

from faulty_runs import Job, Program, check_file_error, command, wait_until
from interrupted import MEDIUM, restart
from results import check_same_results, checkpoints_of
from small_disk import SmallDisk, enter_namespace

# Nothing but checkpoints needs room meanwhile.
OVERRIDES = (*MEDIUM, "output.series_interval=1", "output.snapshot_interval=0", "output.checkpoint_steps=50")


def fill(path):
    with open(path, "wb", buffering=0) as file:
        for size in (1 << 16, 1 << 12, 1):
            try:
                while True:
                    file.write(bytes(size))
            except OSError as error:
                assert error.errno == errno.ENOSPC, error


def main():
    enter_namespace()
    program = Program(*sys.argv[1:4])
    deck = program.deck("discharge_quick.toml")
    with tempfile.TemporaryDirectory() as folder, SmallDisk("8m") as disk:
        reference, output = os.path.join(folder, "reference"), os.path.join(disk, "out")
        program.run(deck, reference, *OVERRIDES)
        with Job(command(program, deck, output, *OVERRIDES, ranks=2)) as job:
            wait_until(lambda: len(checkpoints_of(output)) == 2, job)
            fill(os.path.join(disk, "ballast"))
            print(check_file_error(job.end(), output, "checkpoint_"), flush=True)
        good = checkpoints_of(output)
        assert len(good) == 2, good
        os.remove(os.path.join(disk, "ballast"))
        out, err = restart(program, deck, output, *OVERRIDES, ranks=2)
        assert f"goes on from {os.path.join(output, good[0])}" in out and "warning" not in err, f"{out}\n{err}"
        check_same_results(output, reference)


main()
