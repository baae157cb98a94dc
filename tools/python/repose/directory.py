"""Which of the four a directory is."""

import pathlib

from repose.calibration import Calibration
from repose.files import ReposeError
from repose.run_directory import Run
from repose.sensitivity import Sensitivity
from repose.validation import Validation


def open_directory(directory):
    """The `Run`, `Calibration`, `Sensitivity` or `Validation` in a directory."""
    directory = pathlib.Path(directory)
    for kind, file in ((Calibration, Calibration.deck_file), (Sensitivity, Sensitivity.deck_file),
                       (Run, "deck.resolved.toml"),
                       (Validation, "validation.json"), (Validation, "*/deck.resolved.toml")):
        if any(directory.glob(file)):
            return kind(directory)
    if not directory.is_dir():
        raise ReposeError(f"{directory}: is no directory")
    raise ReposeError(f"{directory}: holds no run, calibration, validation or sensitivity study")
