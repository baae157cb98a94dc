#!/usr/bin/python3
"""Draws the course of a run, finished or not, as PNG and PDF: discharge, energies, loads on the walls.

Usage: tools/plot_run.py DIR [--output DIR]

DIR is the output directory of a run; the pictures discharge, energies and walls are written beside its files, or to the
directory of --output. What the run does not have (no discharge measured, no wall touched) is not drawn.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
import repose  # noqa: E402
from repose import plots  # noqa: E402

PICTURES = {"discharge": plots.discharge, "energies": plots.energies, "walls": plots.walls}


def main():
    arguments = argparse.ArgumentParser(description="draw the course of a run: discharge, energies, loads on the walls")
    arguments.add_argument("run", metavar="DIR", help="output directory of a run")
    arguments.add_argument("--output", metavar="DIR", help="where to put the pictures; default: beside the run")
    chosen = arguments.parse_args()
    output = chosen.output or chosen.run
    try:
        run = repose.Run(chosen.run)
        if run.series is None:
            raise repose.ReposeError(f"{chosen.run}: series.csv has no rows")
        os.makedirs(output, exist_ok=True)
        for name, draw in PICTURES.items():
            figure = draw(run)
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
