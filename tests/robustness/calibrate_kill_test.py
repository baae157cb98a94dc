"""kill -9 of a whole calibration at random moments, and the same command again each time on 1 to 4 ranks: the grid's table
ends as that of a job that nobody disturbed, times and attempts aside, and nothing complete is run again.

With TESTS two tests share the parameters, and one of them is compared by a curve.

Usage: calibrate_kill_test.py EXECUTABLE MPIEXEC SOURCE_DIR KILLS [TESTS] [SEED]
"""

import glob
import os
import random
import signal
import sys
import tempfile
import time

import h5py

from faulty_runs import Job, Program, wait_until

DECK = """
base = "{base}"
seeds = {seeds}
set = ["particles.0.mass=0.1 g", "output.snapshot_interval=10 ms", "phase.settle.max_time=20 ms", "phase.settle.min_time=0",
       "phase.discharge.max_time=80 ms", "phase.discharge.min_time=0", "output.checkpoint_steps=2000",
       "measurement.discharge.plugged_share=0.02"]
[[parameter]]
name = "sliding_friction"
key = "pair.0.sliding_friction"
values = [0.1, 0.5]
[[parameter]]
name = "restitution"
key = "pair.0.restitution"
values = [0.2, 0.5, 0.8]
"""
ONE_TEST = """
[[observable]]
figure = "discharged_mass_kg"
laboratory = 30e-6
deviation = 3e-6
[[observable]]
figure = "retained_mass_kg"
laboratory = 70e-6
deviation = 3e-6
"""
TWO_TESTS = """
[[experiment]]
name = "low"
[[experiment.observable]]
name = "spin"
curve = "spin.csv"
series = "series.csv"
x = "time_s"
y = "rotational_energy_J"
phase = "discharge"
[[experiment]]
name = "high"
set = ["particles.0.mass=0.12 g"]
[[experiment.observable]]
figure = "discharged_mass_kg"
laboratory = 36e-6
deviation = 3e-6
"""
SPIN = "x,y,deviation\n0.01,1e-8,1e-8\n0.03,1e-8,1e-8\n0.06,1e-8,1e-8\n"


def content(output):
    """Everything in grid.h5 but what it has cost."""
    with h5py.File(os.path.join(output, "grid.h5")) as file:
        found = {name: (file["runs"][name][...].tobytes(), dict((k, str(v)) for k, v in file["runs"][name].attrs.items()))
                 for name in file["runs"]}
        return found, {k: str(v) for k, v in file.attrs.items()}


def arguments(program, deck, output, ranks):
    return [program.mpiexec, "-n", str(ranks), program.executable, "calibrate", deck, "--output", output]


def finished(output):
    """Modification times of the summaries."""
    runs = os.path.join(output, "runs")
    return {path: os.stat(path).st_mtime_ns for path in glob.glob(os.path.join(runs, "**", "summary.json"), recursive=True)}


def kill_once(program, deck, output, draw, patience, share):
    """kill -9 at a moment drawn, or sooner when as many further runs as are its share are complete, since how far a job comes
    by then depends on the machine. Whether the job was alive to be killed."""
    ranks = draw.randint(1, 4)
    moment = time.monotonic() + draw.uniform(0.2, patience)
    enough = len(finished(output)) + share
    with Job(arguments(program, deck, output, ranks)) as job:
        wait_until(lambda: time.monotonic() > moment or len(finished(output)) >= enough, job)
        job.kill()
        code, _, err = job.end()
    assert code in (0, -signal.SIGKILL), f"exit {code}: {err}"
    print(f"{'killed' if code else 'ended on'} {ranks} ranks with {len(finished(output))} runs complete", flush=True)
    return code != 0


def main():
    program = Program(*sys.argv[1:4])
    kills = int(sys.argv[4])
    tests = sys.argv[5:6] == ["TESTS"]
    seed = int(sys.argv[-1]) if sys.argv[-1].isdigit() and len(sys.argv) > 5 else random.randrange(10**6)
    print("seed", seed)
    draw = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        deck = os.path.join(folder, "calibration.toml")
        with open(deck, "w") as file:
            file.write(DECK.format(base=program.deck("discharge_quick.toml"), seeds=2 if tests else 3) +
                       (TWO_TESTS if tests else ONE_TEST))
        with open(os.path.join(folder, "spin.csv"), "w") as file:
            file.write(SPIN)
        calm, wild = os.path.join(folder, "calm"), os.path.join(folder, "wild")
        begin = time.monotonic()
        with Job(arguments(program, deck, calm, 2)) as job:
            code, _, err = job.end(1200)
        assert code == 0, err
        patience = 2.0 * (time.monotonic() - begin) / kills
        share = max(1, len(finished(calm)) // kills)
        killed = 0
        complete = {}
        while killed < kills and kill_once(program, deck, wild, draw, patience, share):
            killed += 1
            now = finished(wild)
            assert all(now[path] == when for path, when in complete.items()), "a complete run was run again"
            complete = now
        with Job(arguments(program, deck, wild, draw.randint(1, 4))) as job:
            code, out, err = job.end(1200)
        assert code == 0, err
        assert content(wild) == content(calm)
        for name in ("grid.csv", "estimate.json"):
            with open(os.path.join(wild, name)) as one, open(os.path.join(calm, name)) as other:
                assert one.read() == other.read(), name
        assert all(finished(wild)[path] == when for path, when in complete.items()), "a complete run was run again"
        assert killed >= kills // 2, f"complete after {killed} kills"


main()
