"""tools/open_in_paraview.py in ParaView itself, in batch: the view is made, and its picture has grains in colours and grey walls.

Debian's python3-paraview cannot be installed beside python3-vtk9, which other tests need: PVPYTHON may name the pvpython of
another place. Without a screen it runs under xvfb-run.

Usage: paraview_test.py EXECUTABLE MPIEXEC SOURCE_DIR; exit code 77 where there is no ParaView for Python
"""

import os
import shutil
import subprocess
import sys
import tempfile

import matplotlib.image
import numpy as np

from repose_runs import Program

SKIPPED = 77
REDUCED = ("particles.0.mass=0.1 g", "phase.settle.max_time=30 ms", "phase.settle.min_time=30 ms",
           "phase.discharge.max_time=60 ms", "phase.discharge.min_time=60 ms", "output.snapshot_interval=30 ms")


def pvpython():
    """The command, or None without one that has its modules."""
    command = [os.environ.get("PVPYTHON", "pvpython")]
    if not shutil.which(command[0]):
        return None
    probe = subprocess.run([*command, "-c", "import paraview.simple"], capture_output=True, timeout=120)
    if probe.returncode != 0:
        return None
    return command if "DISPLAY" in os.environ or not shutil.which("xvfb-run") else ["xvfb-run", "-a", *command]


def main():
    program = Program(*sys.argv[1:4])
    command = pvpython()
    if command is None:
        print("no pvpython with paraview.simple")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        output, picture = os.path.join(folder, "run"), os.path.join(folder, "view.png")
        program.run(program.deck("discharge_quick.toml"), output, *REDUCED)
        tool = os.path.join(program.source, "tools", "open_in_paraview.py")
        done = subprocess.run([*command, tool, output, "--png", picture, "--hide", "lid"], capture_output=True, text=True,
                              timeout=300)
        assert done.returncode == 0 and "rror" not in done.stderr, done.stdout + done.stderr
        assert os.path.getsize(os.path.join(output, "view.pvsm")) > 0
        assert sorted(os.listdir(os.path.join(output, "walls"))) == ["lid.vtp", "plate.vtp", "vessel.vtp"]
        image = matplotlib.image.imread(picture)[..., :3]
        spread = np.ptp(image, axis=2)
        coloured = spread > 0.15
        grey = (spread < 0.12) & (image.max(axis=2) < 0.95) & (image.min(axis=2) > 0.4)
        assert image.shape[:2] == (1000, 1200), image.shape
        assert coloured.mean() > 0.005, f"{coloured.mean()} of the picture has the colours of grains"
        assert grey.mean() > 0.03, f"{grey.mean()} of the picture is wall"
        print(f"{coloured.mean():.3f} grains, {grey.mean():.3f} walls")


main()
