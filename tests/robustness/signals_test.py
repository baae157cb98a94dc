"""Signals and the time limit: the ranks stop at one step, write a checkpoint and end with 75; a restart comes to the results
of an undisturbed run. A second signal ends at once what cannot agree any more.

Open MPI 4.1 turns SIGTERM and SIGINT to mpirun into SIGCONT, a pause, SIGTERM, a pause and SIGKILL for the ranks, and ends
with 1, whatever they end with. What it forwards as it is, such as SIGUSR1, leaves the 75 of the ranks.

Usage: signals_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import signal
import sys
import tempfile
import time

from faulty_runs import Job, Program, command, wait_until
from interrupted import MEDIUM, restart
from results import check_same_results, checkpoints_of, rows_of

RESUBMIT, MPIRUN_TERMINATED = 75, 1
PAUSE = {"OMPI_MCA_odls_base_sigkill_timeout": "3"}  # s; the default of 1 s is not enough on a machine under load
# No checkpoint but that of the signal, no snapshot that would hold the first deck.
BRIEF_DISCHARGE = [part for part in MEDIUM if "settle" not in part] + [
    "phase.discharge.max_time=1 ms", "phase.discharge.min_time=1 ms", "output.checkpoint_steps=0", "output.snapshot_interval=0"]
TIME_STEP = 6.4547e-6  # s, of this deck


def to_mpirun(which):
    return lambda job: os.kill(job.process.pid, which)


def to_rank(which, rank):
    return lambda job: os.kill(job.ranks()[rank], which)


def endless_deck(program, folder):
    """The quick deck, but the first phase goes on until it is stopped; how long it may last is what a restart may change. A
    threshold of the kinetic energy would not do: on a fast machine the grains come to rest before the signal does."""
    with open(program.deck("discharge_quick.toml")) as file:
        head, settle, rest = file.read().split("[[phase]]\n", 2)
    assert 'name = "settle"' in settle and 'name = "discharge"' in rest, "the quick deck has other phases"
    path = os.path.join(folder, "deck.toml")
    with open(path, "w") as file:
        file.write("[[phase]]\n".join([head, 'name = "settle"\nuntil = "time"\ntime = 1000\nmax_time = 1000\n\n', rest]))
    return path


def start(program, deck, output, *options):
    return Job(command(program, deck, output, *BRIEF_DISCHARGE, ranks=2, options=options), env=PAUSE)


def stop_and_restart(program, what, send, expected, *options):
    with tempfile.TemporaryDirectory() as folder:
        output, reference = os.path.join(folder, "out"), os.path.join(folder, "undisturbed")
        deck = endless_deck(program, folder)
        with start(program, deck, output, *options) as job:
            if send:
                wait_until(lambda: rows_of(output) > 3, job)
                send(job)
            code, out, err = job.end()
        assert code == expected, f"{what}: exit {code}: {out}\n{err}"
        assert err.count("--restart goes on") == 1, f"{what}: {err}"
        checkpoints = checkpoints_of(output)
        assert len(checkpoints) == 1, f"{what}: {os.listdir(output)}"
        steps = int(checkpoints[0].removeprefix("checkpoint_").removesuffix(".hdf"))
        to_the_end = (*BRIEF_DISCHARGE, f"phase.settle.max_time={(steps + 100) * TIME_STEP}")
        restart(program, deck, output, *to_the_end, ranks=3)
        program.run(deck, reference, *to_the_end)
        check_same_results(output, reference)
        print(f"{what}: {[line for line in err.splitlines() if 'goes on' in line][0]}", flush=True)


def end_by_second_signal(program):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        with start(program, endless_deck(program, folder), output) as job:
            wait_until(lambda: rows_of(output) > 3, job)
            first, second = job.ranks()
            os.kill(first, signal.SIGSTOP)  # no agreement with this one
            os.kill(second, signal.SIGTERM)
            time.sleep(2)
            assert job.process.poll() is None, "it ended without agreement"
            os.kill(second, signal.SIGTERM)
            begin = time.monotonic()
            code, _, _ = job.end(60)
            assert code not in (0, RESUBMIT), code
            print(f"second signal: exit {code} after {time.monotonic() - begin:.1f} s", flush=True)


def main():
    program = Program(*sys.argv[1:4])
    stop_and_restart(program, "SIGTERM to mpirun", to_mpirun(signal.SIGTERM), MPIRUN_TERMINATED)
    stop_and_restart(program, "SIGUSR1 to mpirun", to_mpirun(signal.SIGUSR1), RESUBMIT)
    stop_and_restart(program, "SIGTERM to rank 1", to_rank(signal.SIGTERM, 1), RESUBMIT)
    stop_and_restart(program, "SIGINT to rank 0", to_rank(signal.SIGINT, 0), RESUBMIT)
    stop_and_restart(program, "time limit", None, RESUBMIT, "--time-limit", "00:00:03")
    end_by_second_signal(program)


main()
