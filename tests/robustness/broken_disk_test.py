"""A disk that fails in the middle of a file, on one rank alone: an error that names the file, on all ranks, no hang.

Usage: broken_disk_test.py EXECUTABLE MPIEXEC SOURCE_DIR FAILING_DISK_LIBRARY
"""

import os
import sys
import tempfile

from faulty_runs import TINY, Job, Program, check_file_error, command

EIO, ENOSPC = 5, 28
REASON = {EIO: "Input/output error", ENOSPC: "No space left on device"}


def fail_writing(program, library, file, rank, after, error, ranks):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        faults = {"LD_PRELOAD": library, "FAULT_FILE": file, "FAULT_RANK": str(rank), "FAULT_AFTER": str(after),
                  "FAULT_ERRNO": str(error)}
        with Job(command(program, program.deck("discharge_quick.toml"), output, *TINY,
                         "output.checkpoint_steps=100", ranks=ranks), env=faults) as job:
            said = check_file_error(job.end(), output, file.removesuffix(".partial") if file[0] != "." else "run_")
        assert said.endswith(REASON[error]), said
        print(f"rank {rank} of {ranks}, after {after} writes: {said}", flush=True)


def main():
    program, library = Program(*sys.argv[1:4]), sys.argv[4]
    # One process: every write of the first snapshot in turn, its sync too, and some of later ones.
    for after in (*range(19), 25, 40):
        fail_writing(program, library, ".hdf.partial", 0, after, ENOSPC, 0)
    # Of two ranks one has the trouble. The other must hear of it, not wait for it.
    for after in (0, 1, 8, 13, 15):
        fail_writing(program, library, ".hdf.partial", 0, after, EIO, 2)
    fail_writing(program, library, ".hdf.partial", 1, 0, EIO, 2)
    # In a checkpoint each rank writes its rows itself.
    for rank, after in ((0, 3), (1, 0), (1, 5)):
        fail_writing(program, library, "checkpoint_0000000100.hdf.partial", rank, after, EIO, 2)
    for file in ("run.hdf.series.partial", "summary.json.partial", "deck.resolved.toml.partial"):
        fail_writing(program, library, file, 0, 0, EIO, 0)


main()
