"""Runs the program against faults: every run is bounded in time, and how it ended is looked at in one place."""

import os
import signal
import subprocess
import tempfile
import time

from repose_runs import PATIENCE, Program

SHARED_MEMORY = "/dev/shm" if os.path.isdir("/dev/shm") else None
LONGEST = 120 * PATIENCE  # wall seconds; a run of these tests takes a few, a machine under load ten times as long

# About 310 steps, and the 312 grains of the quick deck: a fraction of a second.
SHORT = ("phase.settle.max_time=1 ms", "phase.settle.min_time=1 ms", "phase.discharge.max_time=1 ms",
         "phase.discharge.min_time=1 ms", "output.series_interval=0.2 ms", "output.snapshot_interval=0.2 ms")
TINY = ("particles.0.mass=0.05 g", "particles.0.height=20 mm", *SHORT)


def command(program, deck, output, *overrides, ranks=0, options=()):
    """The command line of a run; ranks = 0 is without mpirun."""
    launcher = [program.mpiexec, "-n", str(ranks)] if ranks else []
    settings = [part for override in overrides for part in ("--set", override)]
    return [*launcher, program.executable, "run", deck, "--output", output, *options, *settings]


class Job:
    """A started run with all its processes; none of them outlives the block."""

    def __init__(self, arguments, env=None, **popen):
        self.scratch = tempfile.TemporaryDirectory(dir=SHARED_MEMORY)  # what Open MPI leaves behind when it is killed
        places = {"OMPI_MCA_orte_tmpdir_base": self.scratch.name, "OMPI_MCA_btl_vader_backing_directory": self.scratch.name}
        self.process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, start_new_session=True, env={**os.environ, **places, **(env or {})}, **popen)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()
        self.process.stdout.close()
        self.process.stderr.close()
        self.scratch.cleanup()

    def kill(self):
        """kill -9 of all its processes. mpirun stands still first, so that it neither starts a rank meanwhile nor hears of one
        that has died: Open MPI 4.1 hangs or crashes now and then when that happens inside MPI_Init."""
        if self.process.poll() is None:
            os.kill(self.process.pid, signal.SIGSTOP)
            os.waitid(os.P_PID, self.process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
            for pid in [*self.children(), self.process.pid]:
                os.kill(pid, signal.SIGKILL)
        self.process.wait()

    def children(self):
        try:
            with open(f"/proc/{self.process.pid}/task/{self.process.pid}/children") as file:
                return [int(pid) for pid in file.read().split()]
        except (FileNotFoundError, ProcessLookupError):
            return []

    def ranks(self):
        """Process ids of the ranks under mpirun, in their order."""
        return [pid for pid in self.children() if name_of(pid) == "repose"]

    def end(self, seconds=LONGEST):
        """Exit code, what was said on stdout, on stderr."""
        try:
            out, err = self.process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"still running after {seconds} s: {' '.join(self.process.args)}") from None
        return self.process.returncode, out, err


def name_of(pid):
    try:
        with open(f"/proc/{pid}/comm") as file:
            return file.read().strip()
    except (FileNotFoundError, ProcessLookupError):
        return ""


def wait_until(condition, job, seconds=LONGEST):
    """Until a condition holds or the job has ended."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited too long"
        if job.process.poll() is not None:
            return
        time.sleep(0.01)


def messages(stderr):
    return [line for line in stderr.splitlines() if line.startswith("repose:") and "warning" not in line]


def check_file_error(outcome, output, name=""):
    """Exit 4 with one message that names a file in the folder, nothing half-written, no summary. Returns the message."""
    code, _, stderr = outcome
    assert code == 4, f"exit {code}: {stderr}"
    said = messages(stderr)
    assert len(said) == 1, stderr
    assert said[0].startswith(f"repose: {os.path.join(output, name) if name else output}"), f"{name}: {said[0]}"
    assert ": cannot " in said[0], said[0]
    left = os.listdir(output) if os.path.isdir(output) else []
    assert not [file for file in left if file.endswith(".partial")], left
    assert "summary.json" not in left, left
    return said[0]


__all__ = ["Job", "LONGEST", "Program", "SHORT", "TINY", "check_file_error", "command", "messages", "wait_until"]
