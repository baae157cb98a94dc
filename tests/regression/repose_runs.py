"""Runs the program and reads what it wrote; shared by the regression tests."""

import contextlib
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor


# For runs that are refused: mpirun ends what outlives the first rank that fails at once, not after two seconds.
REFUSED = {"OMPI_MCA_odls_base_sigkill_timeout": "0"}
# By how much longer everything may take, under sanitizers.
PATIENCE = float(os.environ.get("REPOSE_PATIENCE", "1"))


class Program:
    def __init__(self, executable, mpiexec, source):
        self.executable, self.mpiexec, self.source = executable, mpiexec, source

    def deck(self, name):
        return os.path.join(self.source, "input", name)

    def call(self, *arguments, ranks=0, env=None, timeout=5000 * PATIENCE):
        """The finished process; ranks = 0 runs it without mpirun."""
        launcher = [self.mpiexec, "-n", str(ranks)] if ranks else []
        return subprocess.run(
            [*launcher, self.executable, *arguments],
            capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=timeout, env={**os.environ, **(env or {})})

    def run(self, deck, output, *overrides, ranks=0, options=(), env=None):
        """The summary of a run that must succeed."""
        arguments = ["run", deck, "--output", output, *options]
        for override in overrides:
            arguments += ["--set", override]
        done = self.call(*arguments, ranks=ranks, env=env)
        assert done.returncode == 0, f"exit {done.returncode}: {done.stderr}"
        with open(os.path.join(output, "summary.json")) as file:
            return json.load(file)

    def run_all(self, runs, options=()):
        """Several (deck, output, overrides...) at a time, one rank each, as many as there are cores."""
        with ThreadPoolExecutor(cores()) as pool:
            return list(pool.map(lambda r: self.run(*r, options=options), runs))


def cores():
    """Those that this process may use."""
    return len(os.sched_getaffinity(0))


@contextlib.contextmanager
def folder_of_runs(arguments):
    """The folder given after EXECUTABLE MPIEXEC SOURCE_DIR, which stays, so that a stopped test goes on; or one for the test."""
    if len(arguments) > 4:
        os.makedirs(arguments[4], exist_ok=True)
        yield arguments[4]
    else:
        with tempfile.TemporaryDirectory() as folder:
            yield folder


class FolderTest(unittest.TestCase):
    """Tests of a program, each in a folder of its own."""

    program = None  # to be set before they are run

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def fails(self, code, pattern, *arguments, ranks=0):
        """With this exit code, and one line of its own that has the pattern."""
        done = self.program.call(*arguments, ranks=ranks, env=REFUSED)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, pattern)
        spoken = [line for line in done.stderr.splitlines() if line.startswith("repose:")]
        self.assertEqual(len(spoken), 1, done.stderr)


class SharedFolderTest(unittest.TestCase):
    """Tests of a program that share a folder, and find the Python package of the source."""

    program = None  # to be set before they are run

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        sys.path.insert(0, os.path.join(cls.program.source, "tools", "python"))

    @classmethod
    def path(cls, *names):
        return os.path.join(cls.folder, *names)

    def study(self, command, text, ranks=2):
        """The directory of a study that must succeed."""
        path, output = self.path(self.id() + ".toml"), self.path(self.id())
        with open(path, "w") as file:
            file.write(text)
        done = self.program.call(command, path, "--output", output, "--quiet", ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        return output


def read_series(output):
    """The rows that are whole; the last one of a run that goes on may not be."""
    with open(os.path.join(output, "series.csv")) as file:
        whole = (line for line in file if line.endswith("\n"))
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(whole)]
