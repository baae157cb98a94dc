"""Reports: one HTML file of a run, a calibration, a validation or a sensitivity study, which needs nothing else.

    python3 -m repose.report DIR --output FILE.html
"""

import pathlib

from repose.calibration import Calibration
from repose.directory import open_directory
from repose.files import ReposeError
from repose.report import calibration, run, sensitivity, validation
from repose.report.page import page
from repose.run_directory import Run
from repose.sensitivity import Sensitivity
from repose.validation import Validation

KINDS = {Run: run, Calibration: calibration, Sensitivity: sensitivity, Validation: validation}


def html_of(directory):
    """The text of the report of a directory."""
    found = open_directory(directory)
    return page(KINDS[type(found)].report(found))


def refuse_other_file(path):
    """A file that is there and is no HTML is somebody's: it is not replaced."""
    if not path.is_file():
        return
    with path.open("rb") as file:
        begins = file.read(15).lower()
    if begins != b"<!doctype html>":
        raise ReposeError(f"{path}: is there already, and is no report; name another file")


def write(directory, output=None):
    """Writes the report, by default to report.html in the directory, and returns its path. It is whole or not there; an earlier
    one is replaced."""
    path = pathlib.Path(output) if output else pathlib.Path(directory) / "report.html"
    text = html_of(directory)
    try:
        refuse_other_file(path)
        partial = path.with_name(path.name + ".partial")
        partial.write_text(text, encoding="utf-8")
        partial.replace(path)
    except OSError as error:
        raise ReposeError(f"{path}: cannot be written: {error.strerror}") from None
    return path
