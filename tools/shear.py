#!/usr/bin/python3
"""Evaluates a shear cell: shear stress over way, and internal friction of runs at several normal stresses.

Usage: tools/shear.py DIR [DIR ...] [--yield-locus] [--output DIR]

Each DIR is the output directory of a run with [measurement.shear], as of input/direct_shear.toml or input/ring_shear.toml with
another wall.lid.servo.force. With --yield-locus they are runs of beds that were consolidated alike, as of input/ring_shear.toml with
other wall.lid.servo.factors, the first sheared under the stress of its consolidation; then the flow properties of powder testing
are found. Writes shear.json and shear.png, .pdf to the first of them, or to the directory of --output.
"""
import argparse
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
from repose_needs import need  # noqa: E402

need("numpy", "matplotlib")
import repose  # noqa: E402
from repose import plots  # noqa: E402
from repose.shear import Shear, steady_locus, yield_locus  # noqa: E402


def degrees(angle):
    return "no angle" if angle is None else f"{angle:.2f} degrees"


def main():
    arguments = argparse.ArgumentParser(description="shear stress over way and internal friction of a shear cell")
    arguments.add_argument("runs", metavar="DIR", nargs="+", help="output directories of runs at several normal stresses")
    arguments.add_argument("--yield-locus", action="store_true", help="the runs are of beds that were consolidated alike, the first "
                           "sheared under the stress of its consolidation")
    arguments.add_argument("--output", metavar="DIR", help="where to put the files; default: beside the first run")
    chosen = arguments.parse_args()
    output = chosen.output or chosen.runs[0]
    try:
        if chosen.yield_locus and len(chosen.runs) < 2:
            raise repose.ReposeError("--yield-locus needs the directories of several runs: a line goes through two points or more")
        tests = [Shear(repose.Run(run)) for run in chosen.runs]
        os.makedirs(output, exist_ok=True)
        results = {"runs": [{"normal_Pa": t.steady_normal, "shear_Pa": t.steady_shear, "friction_deg": t.friction_deg,
                             "peak_deg": t.peak_deg} for t in tests]}
        if len(tests) > 1:
            results["internal_friction_deg"], results["cohesion_Pa"] = steady_locus(tests)
        if chosen.yield_locus:
            results["yield_locus"] = yield_locus(tests)
        with open(os.path.join(output, "shear.json"), "w") as file:
            json.dump(results, file, indent=2)
            file.write("\n")
        figure = plots.shear(tests)
        for ending in ("png", "pdf"):
            figure.savefig(os.path.join(output, f"shear.{ending}"), dpi=200)
    except (repose.ReposeError, OSError) as error:
        sys.exit(f"shear.py: {error}")
    for t in tests:
        print(f"normal {t.steady_normal:.4g} Pa, shear {t.steady_shear:.4g} Pa: {degrees(t.friction_deg)}, at the peak "
              f"{degrees(t.peak_deg)}")
    if len(tests) > 1:
        print(f"internal friction {results['internal_friction_deg']:.2f} degrees, cohesion {results['cohesion_Pa']:.3g} Pa")
    for key, value in results.get("yield_locus", {}).items():
        print(f"{key:32} {value:.4g}" if value is not None else f"{key:32} none")


if __name__ == "__main__":
    main()
