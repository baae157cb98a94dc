"""Folders and names that cannot be written to: exit 4, one message that names the path, on one rank and on two.

Usage: bad_paths_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import resource
import sys
import tempfile

from faulty_runs import TINY, Job, Program, check_file_error, command


def main():
    program = Program(*sys.argv[1:4])
    deck = program.deck("discharge_quick.toml")

    def refuse(output, name="", ranks=0, overrides=(), **popen):
        with Job(command(program, deck, output, *TINY, *overrides, ranks=ranks), **popen) as job:
            print(check_file_error(job.end(), output, name), flush=True)

    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "file")
        with open(file, "w"):
            pass
        os.symlink(os.path.join(folder, "nowhere/at/all"), os.path.join(folder, "dangling"))
        for ranks in (0, 2):
            refuse(file, ranks=ranks)
            refuse(os.path.join(file, "below"), ranks=ranks)
            refuse("/proc/repose", ranks=ranks)  # nobody can create anything here, root neither
        refuse("/proc/self", ".repose-write-test")
        refuse(os.path.join(folder, "x" * 300))
        refuse(os.path.join(folder, "dangling"))
        # What the run would write is there already and is no file.
        for name in ("deck.resolved.toml", "series.csv", "walls.csv", "run.hdf.series", "silhouette.png"):
            output = os.path.join(folder, f"taken-{name}")
            os.makedirs(os.path.join(output, name, "not-empty"))
            refuse_taken(refuse, output, name)
        # A limit on the size of files comes as a signal first, which must not kill the run in silence.
        limit = 10 << 20  # what MPI shares between processes is smaller, the trace of all steps larger
        refuse(os.path.join(folder, "limited"), "trace.csv", overrides=("output.trace=true", "output.trace_every=1"),
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))


def refuse_taken(refuse, output, name):
    try:
        refuse(output, name)
    except AssertionError as error:
        raise AssertionError(f"{name} is a folder: {error}") from None


main()
