"""Runs, calibrations, validations and sensitivity studies of repose, from Python.

    import repose

    run = repose.run("input/discharge_quick.toml", ranks=2, output="quick", set={"run.seed": 7})
    print(run.figure("angle_of_repose_deg"), "+-", run.error("angle_of_repose_deg"), "degrees")
    print(run.series["time_s"][-1], "s,", 1e3 * run.series["discharged_mass_kg"][-1], "g")
    print(run.snapshots[-1].position[:, 2].max(), "m")

Names are those of the decks and of the files, units are SI and stand in the names (`_kg`, `_m`, `_s`; `_deg` is
degrees). What cannot be read or run raises `ReposeError` with one line.

    Run           the directory of `repose run`: summary, series, snapshots
    Calibration   of `repose calibrate`: runs, surfaces, estimate
    Validation    of `repose validate`: cases beside the laboratory's figures
    Sensitivity   of `repose sensitivity`: what each parameter does to the figures
    run           starts the program and returns the Run; calibrate and validate likewise
    open          the one of the four that a directory holds

Needs numpy; h5py for snapshots and contacts, matplotlib for `repose.plots`, pandas for `Table.frame()` alone.
"""

import importlib

from repose.calibration import Calibration, Surfaces
from repose.contact_forces import ContactForces
from repose.contacts import Contacts
from repose.directory import open_directory as open
from repose.files import ReposeError, Table
from repose.program import calibrate, find_program, run, validate
from repose.run_directory import Run
from repose.sensitivity import Sensitivity
from repose.snapshot import Snapshot
from repose.validation import Validation

__all__ = ["Calibration", "ContactForces", "Contacts", "ReposeError", "Run", "Sensitivity", "Snapshot", "Surfaces",
           "Table", "Validation", "calibrate", "find_program", "open", "run", "validate"]


def __getattr__(name):
    """`repose.plots` and `repose.report` are imported when they are asked for: with them comes matplotlib."""
    if name in ("plots", "report"):
        return importlib.import_module(f"repose.{name}")
    raise AttributeError(f"module 'repose' has no attribute '{name}'")
