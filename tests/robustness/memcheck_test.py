"""valgrind's memcheck over a small run, on one rank and on two: no access to what is not there, no decision by what nobody
has set, no leak of the program's own.

Usage: memcheck_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import shutil
import sys
import tempfile

from faulty_runs import SHORT, Job, Program, command

FOUND = 99  # the exit code that valgrind is told to use


def main():
    program = Program(*sys.argv[1:4])
    if shutil.which("valgrind") is None:
        print("skipped: no valgrind")
        sys.exit(77)
    suppressions = os.path.join(program.source, "tools", "valgrind.supp")
    valgrind = ["valgrind", "--quiet", f"--error-exitcode={FOUND}", "--num-callers=50", "--leak-check=full", "--show-leak-kinds=definite",
                "--errors-for-leak-kinds=definite", f"--suppressions={suppressions}",
                "--suppressions=/usr/share/openmpi/openmpi-valgrind.supp"]
    reduced = (*SHORT, "particles.0.mass=0.02 g", "particles.0.height=10 mm")
    options = ("--vector-level", "sse2")  # valgrind 3.19 lacks AVX-512 and some instructions of AVX2
    for ranks in (1, 2):
        with tempfile.TemporaryDirectory() as folder:
            arguments = command(program, program.deck("discharge_quick.toml"), os.path.join(folder, "out"), *reduced,
                                ranks=ranks, options=options)
            at = arguments.index(program.executable)
            with Job([*arguments[:at], *valgrind, *arguments[at:]]) as job:
                code, _, stderr = job.end(500)
            assert code == 0, f"exit {code}:\n{stderr}"
            assert not [line for line in stderr.splitlines() if line.startswith("==")], stderr
            print(ranks, "ranks: clean", flush=True)


main()
