#!/usr/bin/python3
"""Evaluates a uniaxial compression: porosity and modulus of the bed over the stress on its lid.

Usage: tools/compression.py DIR [--output DIR]

DIR is the output directory of a run with [measurement.compression]. Writes compression.json (the unloadings with their moduli, and
the exponent of modulus over stress) and compression.png, .pdf.
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
from repose.compression import Compression  # noqa: E402


def write(output, compression):
    with open(os.path.join(output, "compression.json"), "w") as file:
        json.dump({"unloadings": [{key: float(value) for key, value in compression.unloadings.row(k).items()}
                                  for k in range(compression.unloadings.rows)],
                   "exponent": compression.exponent, "exponent_error": compression.exponent_error,
                   "hertz_exponent": compression.hertz_exponent,
                   "hertz_exponent_error": compression.hertz_exponent_error}, file, indent=2)
        file.write("\n")
    figure = plots.compression(compression)
    for ending in ("png", "pdf"):
        figure.savefig(os.path.join(output, f"compression.{ending}"), dpi=200)


def main():
    arguments = argparse.ArgumentParser(description="porosity and modulus of a bed over the stress on its lid")
    arguments.add_argument("run", metavar="DIR", help="output directory of a run")
    arguments.add_argument("--output", metavar="DIR", help="where to put the files; default: beside the run")
    chosen = arguments.parse_args()
    output = chosen.output or chosen.run
    try:
        compression = Compression(repose.Run(chosen.run))
        os.makedirs(output, exist_ok=True)
        write(output, compression)
    except (repose.ReposeError, OSError) as error:
        sys.exit(f"compression.py: {error}")
    print("stress Pa   modulus Pa   porosity   contacts")
    for k in range(compression.unloadings.rows):
        row = compression.unloadings.row(k)
        print(f"{row['stress_Pa']:9.4g}   {row['modulus_Pa']:10.4g}   {row['porosity']:8.4f}   {row['contacts']:8.3f}")
    if compression.exponent is not None:
        print(f"modulus ~ stress^({compression.exponent:.3f} +- {compression.exponent_error:.3f}), with its contacts taken out "
              f"stress^({compression.hertz_exponent:.3f} +- {compression.hertz_exponent_error:.3f})")


if __name__ == "__main__":
    main()
