"""A rank that dies, or stops and then dies, ends the job soon, with a code other than 0.

Usage: dead_rank_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import signal
import sys
import tempfile
import time

from faulty_runs import Job, Program, command, wait_until

SOON = 60  # wall seconds


def kill_one(program, victim, stop_first):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out")
        endless = ("phase.settle.max_time=1000", "phase.settle.min_time=1000", "output.series_interval=0.1 ms")
        with Job(command(program, program.deck("discharge_quick.toml"), output, *endless, ranks=3)) as job:
            series = os.path.join(output, "series.csv")
            wait_until(lambda: os.path.exists(series) and len(open(series).readlines()) > 3, job)
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


def main():
    program = Program(*sys.argv[1:4])
    for victim in (0, 2):
        kill_one(program, victim, stop_first=False)
    kill_one(program, 1, stop_first=True)


main()
