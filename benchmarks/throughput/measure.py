"""Times processes in alternation and compares them pair by pair."""

import os
import pathlib
import shutil
import statistics
import subprocess
import time
from dataclasses import dataclass


@dataclass
class Timing:
    cpu: float  # s, user and system, of the whole process tree
    wall: float  # s


def timed(command, log):
    """Runs a command to its end; what it prints goes to a file, and its error into the message when it fails."""
    with open(log, "w") as file:
        begin = time.perf_counter()
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        lines = pathlib.Path(log).read_text().splitlines() or [""]
        error = next((line for line in lines if "ERROR" in line), lines[-1])
        raise SystemExit(f"{command[0]} ended with {process.returncode}, see {log}: {error}")
    return Timing(usage.ru_utime + usage.ru_stime, wall)


def launcher(ranks):
    return ["mpirun", "-n", str(ranks)] if ranks > 1 else []


def once(code, scene, case, relax, steps, ranks, folder):
    """One run of one code in an empty folder: its time and its own figures."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    timing = timed([*launcher(ranks), *code.command(scene, case, relax, steps, folder)], folder.with_suffix(".out"))
    return timing, code.figures(folder)


def cost(code, scene, case, plan, ranks, folder):
    """What plan.steps steps cost: a long run less one of the same set-up and relaxation and a single step."""
    steps = plan.steps(code.name)
    short = once(code, scene, case, plan.relax, 1, ranks, folder)[0] if not plan.whole else Timing(0.0, 0.0)
    full, figures = once(code, scene, case, plan.relax, steps, ranks, folder)
    counted = steps - 1 if not plan.whole else plan.relax + steps
    cpu, wall = full.cpu - short.cpu, full.wall - short.wall
    return {"steps": counted, "cpu_seconds": cpu, "wall_seconds_difference": wall,
            "particle_steps_per_cpu_second": scene.count * counted / cpu,
            "particle_steps_per_second": scene.count * counted / wall,
            "short": vars(short), "long": vars(full), "figures": figures}


def spread(values):
    return min(values), statistics.median(values), max(values)


def ratios(results, ours, theirs, key="particle_steps_per_cpu_second"):
    """Minimum, median and maximum of the ratio, pair by pair."""
    return spread([a[key] / b[key] for a, b in zip(results[ours], results[theirs])])


class Companion:
    """A second, independent run on one rank that goes on until the block ends."""

    def __init__(self, code, scene, case, plan, folder):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.command = code.command(scene, case, plan.relax, 100 * plan.ours, folder)

    def __enter__(self):
        self.process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)

    def __exit__(self, *_):
        if self.process.poll() is not None:
            raise SystemExit("the run beside the measured one ended before it; take fewer --steps")
        self.process.kill()
        self.process.wait()
