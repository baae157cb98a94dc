"""python3 -m repose.report DIR [--output FILE.html]"""

import argparse
import sys

from repose.files import ReposeError


def main():
    arguments = argparse.ArgumentParser(prog="repose report", description="one HTML file of what a directory holds")
    arguments.add_argument("directory", metavar="DIR", help="of a run, calibration, validation or sensitivity study")
    arguments.add_argument("--output", metavar="FILE", help="the report; default: DIR/report.html")
    chosen = arguments.parse_args()
    try:
        from repose import report
        print(report.write(chosen.directory, chosen.output))
    except ReposeError as error:
        print(f"repose: {error}", file=sys.stderr)
        return 4
    except ModuleNotFoundError as error:
        print(f"repose: report needs the Python module {error.name}; install it (Debian: python3-numpy, python3-h5py, "
              "python3-matplotlib)", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
