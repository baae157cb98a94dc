"""kill -9 at random moments, of one rank or of the whole job, and a restart on 1 to 4 ranks each time, until the run is
complete: its results are those of a run that nobody disturbed, to the bit.

Usage: kill_test.py EXECUTABLE MPIEXEC SOURCE_DIR KILLS [SEED]
"""

import os
import random
import signal
import sys
import tempfile

from faulty_runs import Job, Program, command, wait_until
from results import check_same_results, checkpoints_of, rows_of

LONG = 600  # wall seconds of an undisturbed run, on a machine under load


def is_writing_checkpoint(output):
    return os.path.isdir(output) and any(n.startswith("checkpoint_") and n.endswith(".partial") for n in os.listdir(output))


class Disturbed:
    """A run that is killed and restarted."""

    def __init__(self, program, deck, output, draw, rows):
        self.program, self.deck, self.output, self.draw, self.rows = program, deck, output, draw, rows

    def start(self, ranks):
        arguments = command(self.program, self.deck, self.output, ranks=ranks, options=("--restart", "--quiet"))
        return Job(arguments, env={"OMPI_MCA_orte_abort_print_stack": "0"})

    def kill_once(self):
        """Whether the run was alive to be killed, and whether it had a checkpoint to go on from; it may be complete instead."""
        ranks = self.draw.randint(1, 4)
        goal = rows_of(self.output) + self.draw.randint(1, self.rows)
        in_checkpoint = self.draw.random() < 0.4
        with self.start(ranks) as job:
            wait_until(lambda: rows_of(self.output) >= goal, job, LONG)
            if in_checkpoint:
                wait_until(lambda: is_writing_checkpoint(self.output), job, LONG)
            saved = bool(checkpoints_of(self.output))
            alive = job.ranks()
            whole = self.draw.random() < 0.5
            if alive and whole:
                job.kill()
            elif alive:
                os.kill(self.draw.choice(alive), signal.SIGKILL)
            code, _, stderr = job.end(LONG)
        if code == 0:
            return False, saved
        assert alive and code == (-signal.SIGKILL if whole else 137), f"exit {code}: {stderr}"
        print(f"killed {'all' if whole else 'one'} of {ranks} ranks at row {rows_of(self.output)}"
              f"{', in a checkpoint' if in_checkpoint else ''}", flush=True)
        return True, saved

    def finish(self):
        with self.start(self.draw.randint(1, 4)) as job:
            code, _, stderr = job.end(LONG)
        assert code == 0, f"exit {code}: {stderr}"


def main():
    program, kills = Program(*sys.argv[1:4]), int(sys.argv[4])
    seed = int(sys.argv[5]) if len(sys.argv) > 5 else random.randrange(10**6)
    print("seed", seed, flush=True)
    draw = random.Random(seed)
    deck = os.path.join(program.source, "tests", "robustness", "eventful.toml")
    with tempfile.TemporaryDirectory() as folder:
        reference = os.path.join(folder, "undisturbed")
        program.run(deck, reference, options=("--quiet",))
        step = max(4, 2 * rows_of(reference) // (min(kills, 20) + 1))
        done = saved = 0
        for attempt in range(kills):  # a run may be complete before all kills are done: then another one
            run = Disturbed(program, deck, os.path.join(folder, f"run{attempt}"), draw, step)
            while done < kills:
                killed, had_checkpoint = run.kill_once()
                if not killed:
                    break
                done, saved = done + 1, saved + had_checkpoint
            run.finish()
            check_same_results(run.output, reference)
            print(f"run {attempt} complete, with the results of the undisturbed one, after {done} kills in all", flush=True)
            if done == kills:
                break
        assert done == kills
        assert 2 * saved > done, f"only {saved} of {done} kills hit a run with a checkpoint"


main()
