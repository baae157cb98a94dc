"""Runs that end before their time and leave checkpoints, for the tests of what comes then."""

import os

from faulty_runs import Job, command

# 312 grains for 3100 steps: a few seconds alone, long enough to be disturbed.
MEDIUM = ("particles.0.mass=0.05 g", "particles.0.height=20 mm", "phase.settle.max_time=10 ms", "phase.settle.min_time=10 ms",
          "phase.discharge.max_time=10 ms", "phase.discharge.min_time=10 ms", "output.series_interval=0.2 ms",
          "output.snapshot_interval=4 ms", "output.checkpoint_steps=100")
# The same for 310 steps, with checkpoints at 200 and 300 in the end.
BRIEF = (*MEDIUM, "phase.settle.max_time=1 ms", "phase.settle.min_time=1 ms", "phase.discharge.max_time=1 ms",
         "phase.discharge.min_time=1 ms")


def leave_checkpoints(program, library, deck, output, *overrides, options=()):
    """A run whose disk fails when the summary is written: all is there but the end."""
    faults = {"LD_PRELOAD": library, "FAULT_FILE": "summary.json.partial"}
    with Job(command(program, deck, output, *overrides, options=options), env=faults) as job:
        code, _, stderr = job.end()
    assert code == 4 and "summary.json: cannot write" in stderr, f"exit {code}: {stderr}"
    assert not os.path.exists(os.path.join(output, "summary.json"))


def restart(program, deck, output, *overrides, ranks=0, code=0):
    """What a restart says on stdout and stderr; it must end with this exit code."""
    with Job(command(program, deck, output, *overrides, ranks=ranks, options=("--restart",))) as job:
        ended, out, err = job.end(300)
    assert ended == code, f"exit {ended} instead of {code}: {out}\n{err}"
    return out, err
