#!/usr/bin/python3
"""`repose report` starts this: repose_report.py DIR [--output FILE]. It imports nothing that may be missing before it
can say so."""

import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
DEBIAN = "Debian: python3-numpy, python3-h5py, python3-matplotlib"
FAILED = 4  # exit code: a file


def main():
    arguments = argparse.ArgumentParser(prog="repose report", description="one HTML file of what a directory holds")
    arguments.add_argument("directory", metavar="DIR", help="of a run, calibration, validation or sensitivity study")
    arguments.add_argument("--output", metavar="FILE", help="the report; default: DIR/report.html")
    chosen = arguments.parse_args()
    if sys.version_info < (3, 11):
        print("repose: report needs Python 3.11 or newer; name one in REPOSE_PYTHON", file=sys.stderr)
        return FAILED
    try:
        return write(chosen)
    except ModuleNotFoundError as error:
        print(f"repose: report needs the Python module {error.name}; install it ({DEBIAN}), or name "
              "in REPOSE_PYTHON a Python that has it", file=sys.stderr)
        return FAILED


def write(chosen):
    """The report that was chosen; an exit code."""
    from repose import ReposeError, report
    try:
        print(report.write(chosen.directory, chosen.output))
    except ReposeError as error:
        print(f"repose: {error}", file=sys.stderr)
        return FAILED
    return 0


if __name__ == "__main__":
    sys.exit(main())
