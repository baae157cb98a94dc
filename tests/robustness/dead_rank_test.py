"""A rank that dies, or stops and then dies, ends the job soon, with a code other than 0. Without mpirun the ranks end, too: none
goes on writing files that a restart writes as well.

Usage: dead_rank_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import signal
import sys
import tempfile
import time

from faulty_runs import Job, Program, command, wait_until
from results import rows_of

SOON = 60  # wall seconds
ENDLESS = ("phase.settle.max_time=1000", "phase.settle.min_time=1000", "output.series_interval=0.1 ms")


def wait_for_rows(output, job):
    wait_until(lambda: rows_of(output) > 3, job)
    assert job.process.poll() is None, job.end()


def kill_one(program, victim, stop_first):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        with Job(command(program, program.deck("discharge_quick.toml"), output, *ENDLESS, ranks=3)) as job:
            wait_for_rows(output, job)
            pid = job.ranks()[victim]
            if stop_first:
                os.kill(pid, signal.SIGSTOP)
                time.sleep(2)
                assert job.process.poll() is None, "a rank that stands still is not dead"
            os.kill(pid, signal.SIGKILL)
            begin = time.monotonic()
            code, _, stderr = job.end(SOON)
            print(f"rank {victim} {'stopped and ' if stop_first else ''}killed: exit {code} after "
                  f"{time.monotonic() - begin:.1f} s", flush=True)
            assert code not in (0, 75), stderr
            assert "signal 9" in stderr, stderr  # mpirun's own message
            assert not os.path.exists(os.path.join(output, "summary.json"))


def is_alive(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def kill_mpirun(program):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        with Job(command(program, program.deck("discharge_quick.toml"), output, *ENDLESS, ranks=3)) as job:
            wait_for_rows(output, job)
            ranks = job.ranks()
            os.kill(job.process.pid, signal.SIGKILL)
            begin = time.monotonic()
            try:
                while any(is_alive(pid) for pid in ranks):
                    assert time.monotonic() < begin + SOON, "ranks go on without mpirun"
                    time.sleep(0.05)
            finally:
                for pid in filter(is_alive, ranks):
                    os.kill(pid, signal.SIGKILL)
            print(f"mpirun killed: the ranks ended after {time.monotonic() - begin:.1f} s", flush=True)


def main():
    program = Program(*sys.argv[1:4])
    for victim in (0, 2):
        kill_one(program, victim, stop_first=False)
    kill_one(program, 1, stop_first=True)
    kill_mpirun(program)


main()
