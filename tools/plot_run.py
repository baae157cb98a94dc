#!/usr/bin/python3
"""Draws the course of a run, finished or not, as PNG and PDF: discharge, energies, loads on the walls, heat, grains.

Usage: tools/plot_run.py DIR [--output DIR] [--along AXIS] [--part SHARE]

DIR is the output directory of a run; the pictures discharge, energies, walls, heat, grains, speeds and temperatures (these
three of the last snapshot) are written beside its files, or to the directory of --output. What the run does not have (no discharge
measured, no wall touched, no heat) is not drawn.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
from repose_needs import need  # noqa: E402

need("numpy", "h5py", "matplotlib")
import repose  # noqa: E402
from repose import plots  # noqa: E402

PICTURES = {"discharge": plots.discharge, "energies": plots.energies, "walls": plots.walls, "heat": plots.heat}


def share(text):
    value = float(text)
    if not 0.0 < value <= 1.0:
        raise argparse.ArgumentTypeError(f"{text} is no share above 0 and at most 1")
    return value


def pictures_of(run, chosen):
    """Names and figures of all that the run has."""
    for name, draw in PICTURES.items():
        yield name, draw(run)
    if run.snapshot_paths:
        last = repose.Snapshot(run.snapshot_paths[-1])
        yield "grains", plots.grains(last, chosen.along, chosen.part)
        yield "speeds", plots.speeds(last, chosen.along, chosen.part)
        yield "temperatures", plots.temperatures(last, chosen.along, chosen.part)


def main():
    arguments = argparse.ArgumentParser(description="draw the course of a run: discharge, energies, loads on the walls, heat")
    arguments.add_argument("run", metavar="DIR", help="output directory of a run")
    arguments.add_argument("--output", metavar="DIR", help="where to put the pictures; default: beside the run")
    arguments.add_argument("--along", metavar="AXIS", choices=("x", "y", "z"), default="y",
                           help="x, y or z: how grains are looked at; default: y")
    arguments.add_argument("--part", metavar="SHARE", type=share, default=1.0,
                           help="of the bed's depth that is shown, from its back on; default: 1, all of it")
    chosen = arguments.parse_args()
    output = chosen.output or chosen.run
    try:
        run = repose.Run(chosen.run)
        if run.series is None:
            raise repose.ReposeError(f"{chosen.run}: series.csv has no rows")
        os.makedirs(output, exist_ok=True)
        for name, figure in pictures_of(run, chosen):
            if figure is None:
                continue
            path = os.path.join(output, name)
            for ending in ("png", "pdf"):
                figure.savefig(f"{path}.{ending}", dpi=200)
            print(f"{path}.png")
    except (repose.ReposeError, OSError) as error:
        sys.exit(f"plot_run.py: {error}")


if __name__ == "__main__":
    main()
