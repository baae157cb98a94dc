#!/usr/bin/python3
"""Draws what `repose calibrate` or `repose sensitivity` has found, beside it, as PNG and PDF.

Usage: tools/plot_calibration.py DIR...

DIR holds estimate.json and grid.csv (calibration.png, calibration.pdf) or sensitivity.json (sensitivity.png, .pdf).
"""

import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
from repose_needs import need  # noqa: E402

need("numpy", "matplotlib")
import repose  # noqa: E402
from repose import plots  # noqa: E402


def draw(folder):
    """The picture of a directory, and its name."""
    study = repose.open(folder)
    if isinstance(study, repose.Calibration):
        return plots.calibration(study), "calibration"
    if isinstance(study, repose.Sensitivity):
        return plots.effects(study), "sensitivity"
    raise repose.ReposeError(f"{folder}: has neither estimate.json nor sensitivity.json")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__.strip())
    for folder in sys.argv[1:]:
        try:
            figure, name = draw(folder)
            for ending in ("png", "pdf"):
                path = os.path.join(folder, f"{name}.{ending}")
                figure.savefig(path, dpi=150)
                print(path)
        except (repose.ReposeError, OSError) as error:
            sys.exit(f"plot_calibration.py: {error}")


if __name__ == "__main__":
    main()
