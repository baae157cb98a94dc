"""The job scripts of jobscripts/ under a real SLURM with two virtual nodes: a run that is stopped by the signal of the time limit
is queued again and ends as an undisturbed one, and so does a calibration; what makes no progress is not queued for ever.

Usage: slurm_test.py EXECUTABLE MPIEXEC SOURCE_DIR; exit code 77 where there is no SLURM
"""

import csv
import glob
import json
import os
import re
import stat
import sys
import tempfile

from faulty_runs import Program
from results import check_same_results, rows_of, summary_of
from slurm_cluster import Cluster, is_available

SKIPPED = 77
# The 2497 grains of the quick deck for 2600 steps: seconds, since messages go over TCP; long enough to be disturbed.
LONG = ("phase.settle.max_time=8.4 ms", "phase.settle.min_time=8.4 ms", "phase.discharge.max_time=8.4 ms",
        "phase.discharge.min_time=8.4 ms", "output.series_interval=0.2 ms", "output.snapshot_interval=3 ms")
BRIEF = (*LONG, "particles.0.mass=0.05 g", "phase.settle.max_time=1 ms", "phase.settle.min_time=1 ms",
         "phase.discharge.max_time=1 ms", "phase.discharge.min_time=1 ms")
TWO_NODES = ("--nodes=2", "--ntasks=2", "--ntasks-per-node=1", "--time=10")
CALIBRATION = """
base = "{base}"
seeds = 2
set = ["particles.0.mass=0.1 g", "output.snapshot_interval=0", "phase.settle.max_time=20 ms", "phase.settle.min_time=0",
       "phase.discharge.max_time=80 ms", "phase.discharge.min_time=0", "measurement.discharge.plugged_share=0.02"]
[[parameter]]
name = "sliding_friction"
key = "pair.0.sliding_friction"
values = [0.1, 0.3, 0.5, 0.7]
[[observable]]
figure = "discharged_mass_kg"
laboratory = 30e-6
deviation = 3e-6
"""


def settings(overrides):
    return [part for override in overrides for part in ("--set", override)]


class Scripts:
    """What the tests have in common: the cluster, the program, a folder for each test."""

    def __init__(self, program, cluster):
        self.program, self.cluster = program, cluster
        self.quick = program.deck("discharge_quick.toml")

    def submit(self, folder, script, *arguments, options=TWO_NODES, env=None):
        path = os.path.join(self.program.source, "jobscripts", script)
        return self.cluster.submit(folder, path, *arguments, options=options,
                                   env={"REPOSE": os.path.abspath(self.program.executable), **(env or {})})

    def end(self, number, folder, state="COMPLETED"):
        """The job and its log, once it has ended in this state."""
        job = self.cluster.wait_for_end(number)
        with open(os.path.join(folder, "job.log")) as file:
            log = file.read()
        assert job["JobState"] == state, f"{job['JobState']} {job['ExitCode']}:\n{log}"
        return job, log

    def interrupt(self, number, folder, when):
        """The signal when so much has been done; the job has to come back for a second start."""
        self.cluster.wait(lambda: when() or self.cluster.job(number)["JobState"] not in ("PENDING", "RUNNING"))
        self.cluster.signal_script(number)
        job, log = self.end(number, folder)
        assert job["Restarts"] == "1", f"{job['Restarts']} restarts:\n{log}"
        starts = re.findall(r"start (\d): 2 ranks on n\[1-2\], time limit 00:0(\d):", log)
        assert [int(start) for start, _ in starts] == [1, 2], log
        assert all(6 <= int(minutes) <= 8 for _, minutes in starts), f"not two minutes short of the job's ten: {log}"
        return log


def run_is_queued_again(scripts, folder):
    output, reference = os.path.join(folder, "out"), os.path.join(folder, "undisturbed")
    number = scripts.submit(folder, "run.sbatch", scripts.quick, output, *settings(LONG))
    log = scripts.interrupt(number, folder, lambda: rows_of(output) > 3)
    assert "stopped by SIGUSR1" in log, log
    assert summary_of(output)["restarts"] == 1
    scripts.program.run(scripts.quick, reference, *LONG, ranks=2)
    check_same_results(output, reference)


def calibration_is_queued_again(scripts, folder):
    output, reference = os.path.join(folder, "out"), os.path.join(folder, "undisturbed")
    deck = os.path.join(folder, "calibration.toml")
    with open(deck, "w") as file:
        file.write(CALIBRATION.format(base=scripts.quick))
    number = scripts.submit(folder, "calibrate.sbatch", deck, output)
    scripts.interrupt(number, folder, lambda: glob.glob(os.path.join(output, "runs", "*", "summary.json")))
    done = scripts.program.call("calibrate", deck, "--output", reference, ranks=2)
    assert done.returncode == 0, done.stderr
    tables = [open(os.path.join(path, "grid.csv")).read() for path in (output, reference)]
    assert tables[0] == tables[1], tables[0]
    assert tables[0].count(",done,") == 8, tables[0]


def sweep_makes_a_table(scripts, folder):
    output = os.path.join(folder, "out")
    stopped = os.path.join(output, "ranks_2", "checkpoint_0000000001.hdf")  # left by a job that was too short
    os.makedirs(os.path.dirname(stopped))
    with open(stopped, "w"):
        pass
    number = scripts.submit(folder, "scaling.sbatch", scripts.quick, output, *settings(BRIEF),
                            options=("--nodes=2", "--ntasks=4", "--ntasks-per-node=2", "--time=10"))
    _, log = scripts.end(number, folder)
    with open(os.path.join(output, "scaling.csv")) as file:
        rows = list(csv.DictReader(file))
    assert [row["ranks"] for row in rows] == ["1", "2", "4"], rows
    for row in rows:
        with open(os.path.join(output, f"ranks_{row['ranks']}", "summary.json")) as file:
            assert json.load(file)["ranks"] == int(row["ranks"])
        assert abs(float(row["efficiency"]) * float(row["ranks"]) - float(row["speed_up"])) < 1e-9, row
    assert float(rows[0]["speed_up"]) == 1.0
    assert "efficiency" in log, log


def no_progress_is_no_new_job(scripts, folder):
    """A program that always stops without having done anything."""
    idle = os.path.join(folder, "idle")
    with open(idle, "w") as file:
        file.write("#!/bin/sh\nexit 75\n")
    os.chmod(idle, stat.S_IRWXU)
    for script in ("run.sbatch", "calibrate.sbatch"):
        number = scripts.submit(folder, script, scripts.quick, os.path.join(folder, "out"), env={"REPOSE": idle})
        job, log = scripts.end(number, folder, "FAILED")
        assert job["ExitCode"] == "75:0" and job["Restarts"] == "0", job
        assert "not queued again" in log, log


def failures_end_the_job(scripts, folder):
    """The exit code of the program is that of the job."""
    number = scripts.submit(folder, "run.sbatch", scripts.quick, os.path.join(folder, "out"), "--set", "time.stepp=1")
    job, _ = scripts.end(number, folder, "FAILED")
    assert job["ExitCode"] == "2:0" and job["Restarts"] == "0", job


def main():
    program = Program(*sys.argv[1:4])
    if not is_available():
        print("no SLURM here; Debian has it: slurm_packages in tools/setup.sh")
        sys.exit(SKIPPED)
    with Cluster() as cluster:
        scripts = Scripts(program, cluster)
        for test in (run_is_queued_again, calibration_is_queued_again, sweep_makes_a_table, no_progress_is_no_new_job,
                     failures_end_the_job):
            with tempfile.TemporaryDirectory() as folder:
                test(scripts, folder)
            print(f"{test.__name__}: as it should", flush=True)


main()
