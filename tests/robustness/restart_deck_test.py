"""What a restart accepts: the same deck, other output and later ends; what it refuses: anything else, with the list.

Usage: restart_deck_test.py EXECUTABLE MPIEXEC SOURCE_DIR FAILING_DISK_LIBRARY
"""

import os
import shutil
import sys
import tempfile

from faulty_runs import Job, Program, command, messages
from interrupted import BRIEF, leave_checkpoints, restart
from results import check_same_results, checkpoints_of, summary_of


def main():
    program, library = Program(*sys.argv[1:4]), sys.argv[4]
    deck = program.deck("discharge_quick.toml")
    with tempfile.TemporaryDirectory() as folder:
        reference, output = os.path.join(folder, "reference"), os.path.join(folder, "out")
        program.run(deck, reference, *BRIEF)
        leave_checkpoints(program, library, deck, output, *BRIEF)
        there = checkpoints_of(output)
        shutil.copy(os.path.join(output, there[0]), os.path.join(folder, "kept.hdf"))

        # Another deck: every key that differs is named, and nothing has happened.
        _, err = restart(program, deck, output, *BRIEF, "run.seed=7", "pair.carbohsp-steel.restitution=0.5",
                         "phase.settle.max_time=2 ms", ranks=2, code=2)
        for key in ("run.seed", "restitution", "max_time"):  # the first phase is over: its end is the past
            assert key in messages(err)[0], err
        # Not asked to go on: refused, or checkpoints of days would be lost by a slip.
        with Job(command(program, deck, output, *BRIEF)) as job:
            code, _, err = job.end()
        assert code == 2 and "--restart" in err, f"exit {code}: {err}"
        assert checkpoints_of(output) == there

        # Output and the end of what is not over yet may change; the state does not know of the output.
        later = os.path.join(folder, "later")
        shutil.copytree(output, later)
        restart(program, deck, later, *BRIEF, "output.progress_seconds=1", "phase.discharge.max_time=1.2 ms",
                "phase.discharge.min_time=1 ms", ranks=2)
        assert summary_of(later)["steps"] > summary_of(reference)["steps"]

        restart(program, deck, output, *BRIEF, ranks=3)
        check_same_results(output, reference)
        # Complete already; checkpoints that a sudden end has left behind go.
        shutil.copy(os.path.join(folder, "kept.hdf"), os.path.join(output, there[0]))
        out, _ = restart(program, deck, output, *BRIEF, ranks=2)
        assert "complete" in out, out
        check_same_results(output, reference)
        # Without any checkpoint it begins at the beginning.
        fresh = os.path.join(folder, "fresh")
        restart(program, deck, fresh, *BRIEF, ranks=2)
        check_same_results(fresh, reference)


main()
